#pragma once
// The loop of visual servoing without a camera and an arm: from the points of a picture to joint
// speeds, and why the loop ends.

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/camera/pinhole.hpp"
#include "armlet/math/eigen_layout.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/vision/plane_points.hpp"
#include "armlet/vision/servo_laws.hpp"

namespace armlet {

// Image-based with the interaction matrix of now, of the goal or the mean of both; by the pose of
// the points; by one point of the image, its depth and the rotation (2 1/2 D).
enum class ServoLaw : std::uint8_t { kCurrent, kDesired, kMean, kPosition, kHybrid };

// Why a loop has ended; kNone: it goes on. kStopped is for whoever runs it.
enum class ServoEnd : std::uint8_t {
  kNone,
  kConverged,
  kTimeout,
  kFeatureLost,
  kLocalMinimum,
  kSingular,
  kJointLimit,
  kOutOfImage,
  kStopped
};
[[nodiscard]] std::string_view name_of(ServoEnd end);  // "Converged"; "" of kNone

using ObjectPoints = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// Where points are wanted in the picture, and what is known of them.
//
// wanted  k x 2, pixels within the picture, 4 to kMostServoPoints points.
// depths  Z of the points, m: one for each, or one for all. Empty: of the poses of `points`.
// points  k x 3, m, of a flat object in its own frame. Empty: not known, which position-based and
//         hybrid laws need.
struct ServoGoal {
  PlanePoints wanted;
  Eigen::VectorXd depths{};
  ObjectPoints points = ObjectPoints(0, 3);
};
inline constexpr Eigen::Index kMostServoPoints = 200;

// The joints that move the camera.
//
// lower, upper, max_speed, max_accel  n values, rad or m, per s and s^2; may be infinite.
// turns  whether the joint is revolute, for messages.
// rank   camera_directions where the arm is not singular.
struct ServoArm {
  Eigen::VectorXd lower, upper, max_speed, max_accel;
  std::vector<bool> turns;
  Eigen::Index rank = 6;
};

// In how many directions joints move a camera. Directions whose singular value is below a
// thousandth of the largest, in m and rad, do not count.
//
// J_camera  6 x n (camera_jacobian).
[[nodiscard]] Eigen::Index camera_directions(const Eigen::MatrixXd& J_camera);

// gain      1/s; gain.at(x) with x the largest element of the error of the law: of the image in
//           normalised coordinates; of the pose in m and rad.
// period    s, from picture to picture; gain * period is below 2.
// within    px: the loop has converged when the norm of all errors in the picture is at most this.
// timeout   s.
// patience  so many pictures without the points, one after the other, are bridged by prediction.
// smooth    1/s: the speeds begin at 0 and reach those of the law like 1 - e^(-smooth t). 0: at
//           once.
struct ServoOptions {
  ServoLaw law = ServoLaw::kMean;
  AdaptiveGain gain{0.5, 0.5, 1.0};
  double period = 0.04;
  double within = 0.5;
  double timeout = 20.0;
  int patience = 5;
  double smooth = 0.0;
};

// What one picture shows, and how the arm stands when it is taken.
//
// t         s, from the start.
// pixels    k x 2 in the order of the goal; nothing: they were not found, and why.
// J_camera  6 x n, from joint speeds to the twist of the camera in its own axes (camera_jacobian).
// q, qd     n values.
// depths    k values of Z if they are known better than the goal knows them; else empty.
struct ServoSight {
  double t = 0.0;
  std::optional<PlanePoints> pixels{};
  std::string lost{};
  Eigen::MatrixXd J_camera{};
  Eigen::VectorXd q{}, qd{};
  Eigen::VectorXd depths{};
};

// One step of the loop.
//
// error     px, norm of all differences of points from where they are wanted.
// points    k x 2, px; predicted ones if `held`.
// twist     of the camera in its own axes, m/s and rad/s, and qd, of the joints: what is commanded.
// smallest, condition  singular values of the interaction matrix of the law, or of the points if it
//           takes none, in normalised coordinates.
struct ServoRow {
  double t = 0.0;
  double error = 0.0;
  PlanePoints points{};
  bool held = false;
  Vector6d twist = Vector6d::Zero();
  Eigen::VectorXd qd{};
  double smallest = 0.0;
  double condition = 0.0;
};

// The loop. Joint speeds are -gain A^+ e for the error e of the law and its derivative A with
// respect to the joints; arms with more joints than the task needs keep away from their limits.
// All speeds are scaled alike so that no joint is faster than it may be or leaves its limits, and
// so that no point leaves the picture within a period.
//
// source  F. Chaumette, S. Hutchinson, Visual servo control, IEEE Robotics and Automation Magazine
//         13(4), 2006 and 14(1), 2007; joint limits as F. Chaumette, E. Marchand, A
//         redundancy-based iterative approach for avoiding joint limits, IEEE Trans. Robotics and
//         Automation 17(5), 2001.
class VisualServo {
 public:
  // throws  ArgumentError that names the number that cannot be.
  VisualServo(const Pinhole& lens, ServoGoal goal, ServoArm arm, const ServoOptions& options);

  // Takes the next picture. It ends the loop if the points are where they are wanted; if `timeout`
  // is over; if they were not found for too long; if the speeds no longer change the picture while
  // the error has not fallen for 50 pictures; if the arm, or the picture of the points, has lost a
  // direction of motion; if a joint limit or the edge of the picture has stopped the arm for 10
  // pictures; if a point lies outside of the picture or of the depths that the camera sees.
  //
  // returns  n joint speeds for the period that begins, zero once the loop has ended.
  // throws   ArgumentError for sizes that do not fit, numbers that are not finite, and after the
  //          end.
  const Eigen::VectorXd& look(const ServoSight& sight);

  // Where the points are expected a period after the last picture, if the joints have moved with
  // qd; no rows before the points were first found.
  [[nodiscard]] PlanePoints expected(const Eigen::VectorXd& qd) const;

  [[nodiscard]] ServoEnd end() const { return end_; }
  // A clause with the numbers behind the end.
  [[nodiscard]] const std::string& why() const { return why_; }
  // Ends the loop for a reason outside of it; one that has ended stays as it is.
  void finish(ServoEnd end, std::string why);
  [[nodiscard]] Eigen::Index wanted_points() const { return goal_.wanted.rows(); }
  // The steps so far. Pictures before the points were first found have none.
  [[nodiscard]] const std::vector<ServoRow>& rows() const { return rows_; }

  // Directions of the picture, 2k x d, orthonormal, in which a camera that moves freely can change
  // it and this arm cannot: what L reaches and L J does not, at the last picture.
  [[nodiscard]] Eigen::MatrixXd uncontrollable() const;
  // Why the loop ended, and in which directions the picture cannot be controlled, in a few lines.
  [[nodiscard]] std::string explanation() const;

 private:
  // A picture as the law takes it.
  struct Task {
    PlanePoints seen;        // normalised
    Eigen::VectorXd depths;  // of the points now
    Eigen::MatrixXd L;       // of the law, or of the points
    Eigen::MatrixXd A;       // d error / d joints
    Eigen::VectorXd error;
    double gain = 0.0;
  };

  [[nodiscard]] bool is_image_law() const { return options_.law <= ServoLaw::kMean; }
  [[nodiscard]] bool needs_pose() const { return !is_image_law() || goal_.depths.size() == 0; }
  void check_goal();
  void check_options() const;
  void check_sight(const ServoSight& sight) const;
  [[nodiscard]] PlanePoints normalised(const PlanePoints& pixels) const;
  void take_points(const ServoSight& sight);
  [[nodiscard]] bool find_pose(const PlanePoints& seen);
  [[nodiscard]] std::optional<Task> task_of(const ServoSight& sight);
  void set_errors(Task& task, const ServoSight& sight) const;
  void end_if_outside(const Eigen::VectorXd& depths, bool depths_are_known);
  void end_if_singular(const Task& task, const ServoSight& sight);
  void end_if_stuck(const Task& task, const ServoSight& sight, const Eigen::VectorXd& speeds);
  [[nodiscard]] double keep_in_picture(const Eigen::VectorXd& speeds);
  [[nodiscard]] Eigen::VectorXd command(const Task& task, const ServoSight& sight);

  Pinhole lens_;
  ServoGoal goal_;
  ServoArm arm_;
  ServoOptions options_;
  PlanePoints wanted_;  // normalised
  Eigen::VectorXd depths_wanted_;
  std::optional<Eigen::Isometry3d> T_goal_obj_{};  // pose of the points in the wanted camera
  std::optional<Eigen::Isometry3d> T_camera_obj_{};
  PlanePoints points_ = PlanePoints(0, 2);  // px, of the last picture
  Eigen::MatrixXd pixel_L_{};               // px per second and twist, at the last picture
  Eigen::MatrixXd J_camera_{};
  Eigen::VectorXd speeds_;
  std::optional<Eigen::VectorXd> first_speeds_{};  // for a smooth start
  double t_first_ = 0.0;
  std::deque<double> errors_{};
  int missed_ = 0;
  int stopped_by_edge_ = 0;
  int stopped_by_joint_ = 0;
  ServoEnd end_ = ServoEnd::kNone;
  std::string why_{};
  std::vector<ServoRow> rows_{};
};

}  // namespace armlet
