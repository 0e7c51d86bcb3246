#pragma once
// The control loop of visual servoing without a camera and an arm: from the points of a picture to
// joint speeds, and the reason why the loop ends.

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

// Control laws. Image-based, with the present interaction matrix, that of the goal, or the mean of
// both; position-based, by the pose of the points; hybrid (2 1/2 D), by one point of the image, its
// depth and the rotation.
enum class ServoLaw : std::uint8_t { kCurrent, kDesired, kMean, kPosition, kHybrid };

// Why a loop has ended; kNone: it continues. kStopped is set by the caller of the loop.
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

// The goal: pixels of the points, and their depths or positions.
//
// wanted  k x 2, pixels within the picture, 4 to kMostServoPoints points.
// depths  Z of the points, m: one for each, or one for all. Empty: computed from the poses of
//         `points`.
// points  k x 3, m, of a flat object in its own frame. Empty: not known; position-based and hybrid
//         laws need them.
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
// rank   camera_directions at a position of the arm that is not singular.
struct ServoArm {
  Eigen::VectorXd lower, upper, max_speed, max_accel;
  std::vector<bool> turns;
  Eigen::Index rank = 6;
};

// Number of directions in which joints move a camera. Directions whose singular value is below a
// thousandth of the largest, in m and rad, do not count.
//
// J_camera  6 x n (camera_jacobian).
[[nodiscard]] Eigen::Index camera_directions(const Eigen::MatrixXd& J_camera);

// gain      1/s; gain.at(x) with x the largest element of the error of the law: of the image in
//           normalised coordinates; of the pose in m and rad.
// period    s, between pictures; gain * period is below 2.
// within    px: the loop has converged when the norm of all errors in the picture is at most this.
// timeout   s.
// patience  number of consecutive pictures without a point that are bridged by its prediction.
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

// What one picture shows, and the state of the arm when it is taken.
//
// t         s, from the start.
// pixels    k x 2 in the order of the goal; an error with the reason if they were not found.
// missing   rows of `pixels` that were not found, whose values do not count, and why in `lost`.
// J_camera  6 x n, from joint speeds to the twist of the camera in its own axes (camera_jacobian).
// q, qd     n values.
// depths    k values of Z if they are known better than from the goal; else empty.
struct ServoSight {
  double t = 0.0;
  std::optional<PlanePoints> pixels{};
  std::vector<Eigen::Index> missing{};
  std::string lost{};
  Eigen::MatrixXd J_camera{};
  Eigen::VectorXd q{}, qd{};
  Eigen::VectorXd depths{};
};

// One step of the loop.
//
// error     px, norm of the differences of all points from their goals.
// points    k x 2, px; some or all of them predicted if `held`.
// twist     of the camera in its own axes, m/s and rad/s, and qd, of the joints: the command.
// smallest, condition  of the singular values of the law's interaction matrix, or that of the
//                      points if the law has none, in normalised coordinates. Of a picture in
//                      which the loop ends because points are lost or outside: at the predicted
//                      points, or at the border of the picture.
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

// The control loop. Joint speeds are -gain A^+ e for the error e of the law and its derivative A
// with respect to the joints; redundant arms use self-motion to keep away from their limits. All
// speeds are scaled by one factor so that no joint exceeds its speed or its limits, and no point
// leaves the picture within a period.
//
// source  F. Chaumette, S. Hutchinson, Visual servo control, IEEE Robotics and Automation Magazine
//         13(4), 2006 and 14(1), 2007; joint limits as F. Chaumette, E. Marchand, A
//         redundancy-based iterative approach for avoiding joint limits, IEEE Trans. Robotics and
//         Automation 17(5), 2001.
class VisualServo {
 public:
  // throws  ArgumentError that names the impossible number.
  VisualServo(const Pinhole& lens, ServoGoal goal, ServoArm arm, const ServoOptions& options);

  // Processes the next picture. It ends the loop when the points are at their goals; when `timeout`
  // is over; when one was not found for too long; when the speeds no longer change the
  // picture while the error has not decreased for 50 pictures; when the arm, or the picture of the
  // points, has lost a direction of motion; when a joint limit or the edge of the picture has
  // stopped the arm for 10 pictures; or when a point is outside of the picture or of the camera's
  // range of depths.
  //
  // returns  n joint speeds for the period that begins, zero once the loop has ended.
  // throws   ArgumentError for sizes that do not match, numbers that are not finite, and a call
  //          after the end.
  const Eigen::VectorXd& look(const ServoSight& sight);

  // The predicted points a period after the last picture, if the joints have moved with qd; no rows
  // before the points were first found.
  [[nodiscard]] PlanePoints expected(const Eigen::VectorXd& qd) const;

  [[nodiscard]] ServoEnd end() const { return end_; }
  // A clause with the reason of the end, in numbers.
  [[nodiscard]] const std::string& why() const { return why_; }
  // Ends the loop for a reason outside of it; no effect after the end.
  void finish(ServoEnd end, std::string why);
  [[nodiscard]] Eigen::Index wanted_points() const { return goal_.wanted.rows(); }
  // The steps so far, without pictures before the points were first found.
  [[nodiscard]] const std::vector<ServoRow>& rows() const { return rows_; }

  // Directions of the picture, 2k x d, orthonormal, in which a freely moving camera can change it
  // and this arm cannot: in the range of L and not in that of L J, at the last picture.
  [[nodiscard]] Eigen::MatrixXd uncontrollable() const;
  // A few lines: why the loop ended, and the directions in which the picture cannot be controlled.
  [[nodiscard]] std::string explanation() const;

 private:
  // The quantities of a law for one picture.
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
  void end_if_lost(const std::string& lost);
  [[nodiscard]] bool find_pose(const PlanePoints& seen);
  [[nodiscard]] std::optional<Task> task_of(const ServoSight& sight);
  void set_errors(Task& task, const ServoSight& sight) const;
  [[nodiscard]] Eigen::MatrixXd last_interaction(const ServoSight& sight) const;
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
  std::optional<Eigen::Isometry3d> T_goal_obj_{};  // pose of the points in the goal camera
  std::optional<Eigen::Isometry3d> T_camera_obj_{};
  PlanePoints points_ = PlanePoints(0, 2);  // px, of the last picture
  Eigen::MatrixXd pixel_L_{};               // px per second and twist, at the last picture
  Eigen::MatrixXd J_camera_{};
  Eigen::VectorXd speeds_;
  std::optional<Eigen::VectorXd> first_speeds_{};  // for a smooth start
  double t_first_ = 0.0;
  std::deque<double> errors_{};
  std::vector<int> missed_;  // for each point, pictures one after the other without it
  int stopped_by_edge_ = 0;
  int stopped_by_joint_ = 0;
  ServoEnd end_ = ServoEnd::kNone;
  std::string why_{};
  std::vector<ServoRow> rows_{};
};

}  // namespace armlet
