#include "armlet/kinematics/fixed_tilt.hpp"

#include <cmath>

#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// An axis whose tilt is smaller, rad, changes the tilt of the tool by less than the tolerance of
// orientations, however many such axes there are.
constexpr double kVertical = 1e-8;
constexpr double kSameTilt = 1e-6;  // rad, as exact as every other orientation

Matrix3d about_x(double c, double s) {
  Matrix3d R;
  R << 1, 0, 0, 0, c, -s, 0, s, c;
  return R;
}

double lean(const Vector3d& axis) { return axis.head<2>().norm(); }

// The angle between directions, exact also where the cosine is not.
double angle_of(const Vector3d& a, const Vector3d& b) {
  return det::atan2(a.cross(b).norm(), a.dot(b));
}

// Heading of the x axis seen from above, or of the y axis less a right angle if x is vertical.
double rotation_about_z(const Matrix3d& R) {
  if (det::hypot(R(0, 0), R(1, 0)) > 1e-9) return det::atan2(R(1, 0), R(0, 0));
  return det::atan2(-R(0, 1), R(1, 1));
}

// Mimic joints may keep the tool upright on horizontal axes, as in a parallel linkage. Tested at
// joint values without symmetry.
std::optional<Vector3d> fixed_tilt_seen(const Robot& robot) {
  constexpr int kPositions = 8;
  constexpr double kGolden = 0.6180339887498949;
  const Vector3d up = forward(robot, robot.home()).linear().row(2);
  for (int k = 1; k <= kPositions; ++k) {
    Eigen::VectorXd q = robot.home();
    for (int i = 0; i < robot.n(); ++i) {
      const double share = kGolden * k * (i + 1);
      const double turn = (share - std::floor(share) - 0.5) * 2.0;
      q[i] += robot.is_revolute(i) ? 3.0 * turn : robot.length() * turn;
    }
    if ((forward(robot, q).linear().row(2).transpose() - up).norm() > kVertical)
      return std::nullopt;
  }
  return up.normalized();
}

std::optional<Vector3d> find_fixed_tilt(const Robot& robot) {
  if (robot.coupling() != nullptr) return fixed_tilt_seen(robot);
  const Chain& chain = robot.chain();
  Matrix3d R = chain.T_world_base.linear();
  const std::size_t n = static_cast<std::size_t>(chain.n);
  for (std::size_t i = 0; i < n; ++i) {
    R = R * about_x(chain.cos_alpha[i], chain.sin_alpha[i]);
    if (chain.revolute[i] && lean(R.col(2)) > kVertical) return std::nullopt;
    R = R * rot_z(chain.theta[i]);
  }
  R = R * about_x(chain.cos_alpha[n], chain.sin_alpha[n]) * chain.T_flange_tool.linear();
  return R.row(2).transpose().normalized();
}

// Every goal needs the tilt of its arm; it is computed once.
struct FixedTilt {
  using FromShape = void;
  explicit FixedTilt(const Robot& robot) : up(find_fixed_tilt(robot)) {}
  std::optional<Vector3d> up;
};

}  // namespace

std::optional<Vector3d> fixed_tilt(const Robot& robot) { return robot.derived<FixedTilt>().up; }

double tilt_error(const Robot& robot, const Eigen::Isometry3d& T_world_frame) {
  const auto up = fixed_tilt(robot);
  return up ? angle_of(*up, T_world_frame.linear().row(2).transpose()) : 0.0;
}

std::optional<IkTask> frame_task(const Robot& robot, const Eigen::Isometry3d& T_world_frame) {
  const auto up = fixed_tilt(robot);
  if (!up) return IkTask::kPose;
  const Vector3d frame_up = T_world_frame.linear().row(2).transpose();
  if (lean(*up) <= kSameTilt && lean(frame_up) <= kSameTilt) return IkTask::kHeading;
  if (angle_of(*up, frame_up) <= kSameTilt) return IkTask::kPose;
  return std::nullopt;
}

Eigen::Isometry3d with_heading_of(const Robot& robot, const Eigen::Isometry3d& T_world_frame,
                                  JointsIn q) {
  const Matrix3d R_seed = forward(robot, q).linear();
  const Matrix3d& R = T_world_frame.linear();
  return make_pose(rot_z(rotation_about_z(R) - rotation_about_z(R_seed)) * R_seed,
                   T_world_frame.translation());
}

}  // namespace armlet
