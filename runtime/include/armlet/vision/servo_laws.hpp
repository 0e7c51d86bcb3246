#pragma once
// Visual servoing with a camera on the tool: the twist of the camera that moves points of its image
// to their goals.
//
// Frames: the camera looks along its z axis, x to the right and y down. Twists are [v; w] of the
// camera in its own axes, m/s and rad/s. Points are x = X/Z, y = Y/Z, one in each row.

#include <Eigen/Geometry>
#include <string>

#include "armlet/math/eigen_layout.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// The interaction matrix of points: the twist v of the camera moves them in the image with the
// speeds [x1 y1 x2 y2 ...] = L v.
//
// points  k x 2.
// depths  k values of Z, m; or one for all of them.
// returns L, 2k x 6.
// throws  ArgumentError for a depth that is not above 0, numbers that are not finite, and another
//         number of depths.
// source  F. Chaumette, S. Hutchinson, Visual servo control I, IEEE Robotics and Automation
//         Magazine 13(4), 2006, equation 11.
Eigen::MatrixXd point_interaction(const PlanePoints& points, const Eigen::VectorXd& depths);

// The interaction matrix of an image-based law: the present one, that of the goal, or the mean of
// both, which rotates about the optical axis without translation along it.
//
// source  E. Malis, Improving vision-based control using efficient second-order minimization
//         techniques, ICRA 2004 (the mean).
enum class ImageLaw { kCurrent, kDesired, kMean };

// The inputs of an image-based law.
//
// points, wanted         k x 2, present points and goals in the same order.
// depths, depths_wanted  as in point_interaction.
struct ImageGoal {
  PlanePoints points, wanted;
  Eigen::VectorXd depths, depths_wanted;
};

// The interaction matrix of a law, 2k x 6.
//
// throws  ArgumentError as point_interaction, and for point lists of different length.
Eigen::MatrixXd law_interaction(ImageLaw law, const ImageGoal& goal);

// points - wanted, one after the other, 2k values.
Eigen::VectorXd image_error(const ImageGoal& goal);

// A motion found from a matrix that may not have full rank.
//
// motion        the smallest one with the demanded decrease of the error, where that is possible: a
//               twist, or joint speeds.
// rank          of the matrix; singular values below kSmallSingularValue times the largest count as
//               zero, so that noise does not become speed.
// smallest      the smallest singular value, of as many as the matrix has rows or columns.
// condition     largest to smallest singular value; infinity if the smallest is zero.
// unreachable   share of the error that no motion changes: |e - A A^+ e| / |e|, 0 to 1.
struct ServoStep {
  Eigen::VectorXd motion;
  Eigen::Index rank = 0;
  double smallest = 0.0;
  double condition = 0.0;
  double unreachable = 0.0;
};
inline constexpr double kSmallSingularValue = 1e-9;

// -gain A^+ error, for A = L (a twist of the camera) or A = L camera_jacobian (joint speeds).
//
// A, error  m x n and m values.
// gain      1/s, above 0.
// throws    ArgumentError for sizes that do not match, a gain that is not above 0, and numbers that
//           are not finite.
ServoStep servo_step(const Eigen::MatrixXd& A, const Eigen::VectorXd& error, double gain);

// The directions of the image in which no motion moves its points: an orthonormal basis of the
// complement of the range of A, m x (m - rank).
Eigen::MatrixXd uncontrollable_directions(const Eigen::MatrixXd& A);

// Number of singular values above `share` times the largest one.
//
// throws  ArgumentError for numbers that are not finite.
Eigen::Index rank_above(const Eigen::MatrixXd& A, double share);

// The part of desired joint speeds that does not change the error: (I - A^+ A) wished.
//
// throws  ArgumentError unless A has a column for each of them.
// source  A. Liegeois, Automatic supervisory control of the configuration and behavior of
//         multibody mechanisms, IEEE Trans. SMC 7(12), 1977.
Eigen::VectorXd null_motion(const Eigen::MatrixXd& A, const Eigen::VectorXd& wished);

// Maps joint speeds to the twist of the camera in its own axes.
//
// J_world        6 x n, of the tool point in the axes of the world.
// R_world_tool   orientation of the tool.
// T_tool_camera  pose of the camera on the tool.
// returns        6 x n.
// throws         ArgumentError unless J_world has six rows of finite numbers.
Eigen::MatrixXd camera_jacobian(const Eigen::Ref<const Eigen::MatrixXd>& J_world,
                                const Eigen::Matrix3d& R_world_tool,
                                const Eigen::Isometry3d& T_tool_camera);

// The law of position-based servoing: the camera moves straight to its goal, if the pose is exact.
//
// T_wanted_camera  pose of the camera in the frame of the goal camera.
// returns          v = -gain R^T t, w = -gain theta u.
// throws           ArgumentError as servo_step.
// source           Chaumette, Hutchinson 2006, equation 17.
Vector6d position_twist(const Eigen::Isometry3d& T_wanted_camera, double gain);

// The law of 2 1/2 D servoing. It controls the image of one point and its depth by the translation
// of the camera, and the orientation of the camera by its rotation: the point moves straight to its
// goal in the image.
//
// point, wanted   of the same point, x and y.
// depth, depth_wanted  its present Z and that at the goal, m.
// R_wanted_camera orientation of the camera in the frame of the goal camera.
// throws          ArgumentError as servo_step and for depths that are not above 0.
// source          E. Malis, F. Chaumette, S. Boudet, 2 1/2 D visual servoing, IEEE Trans. Robotics
//                 and Automation 15(2), 1999.
Vector6d hybrid_twist(const Eigen::Vector2d& point, const Eigen::Vector2d& wanted, double depth,
                      double depth_wanted, const Eigen::Matrix3d& R_wanted_camera, double gain);

// A gain that is high near the goal and moderate far from it.
//
// at_zero, at_infinity  1/s, gains for an error of 0 and for large ones.
// slope    decrease of the gain at zero error, 1/s per unit of the error.
// source   O. Kermorgant, F. Chaumette, Dealing with constraints in sensor-based robot control,
//          IEEE Trans. Robotics 30(1), 2014; as in ViSP (E. Marchand and others, 2005).
struct AdaptiveGain {
  double at_zero = 4.0;
  double at_infinity = 0.4;
  double slope = 30.0;

  // throws  ArgumentError for gains or a slope that are not above 0 and finite, a gain at the goal
  //         below the other one, and an error that is negative or not finite.
  [[nodiscard]] double at(double largest_error) const;
};

}  // namespace armlet
