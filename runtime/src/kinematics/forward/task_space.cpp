#include "armlet/kinematics/task_space.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "armlet/kinematics/fixed_tilt.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSamples = 8;
constexpr double kSame = 1e-8;  // m and rad: difference by rounding
constexpr double kRank = 1e-6;  // of the largest pivot

struct Sample {
  VectorXd q;
  Isometry3d T;
  Jacobian J;
};

// Joint values without a pattern that a mechanism could have: multiples of roots of primes.
std::vector<Sample> samples_of(const Robot& robot) {
  constexpr std::array<double, kMaxJoints> kSteps = {1.4142135, 1.7320508, 2.2360680, 2.6457513,
                                                     3.3166248, 3.6055513, 4.1231056, 4.3588989,
                                                     4.7958315, 5.3851648, 5.5677644, 6.0827625};
  std::vector<Sample> samples;
  for (int k = 1; k <= kSamples; ++k) {
    VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) {
      const double step = kSteps[static_cast<std::size_t>(i)] * k;
      const double share = step - std::floor(step);
      const bool endless = robot.joint(i).is_continuous();
      const double low = endless ? -kPi : robot.lower()[i];
      const double high = endless ? kPi : robot.upper()[i];
      q[i] = low + share * (high - low);
    }
    Jacobian J;
    const Isometry3d T = forward_and_jacobian(robot, q, J);
    samples.push_back({std::move(q), T, J});
  }
  return samples;
}

// The largest rank of some rows over all samples.
int rank_of(const std::vector<Sample>& samples, std::initializer_list<int> rows) {
  Eigen::Index most = 0;
  for (const Sample& sample : samples) {
    MatrixXd part(static_cast<Eigen::Index>(rows.size()), sample.J.cols());
    Eigen::Index at = 0;
    for (const int row : rows) part.row(at++) = sample.J.row(row);
    Eigen::ColPivHouseholderQR<MatrixXd> qr(part);
    qr.setThreshold(kRank);
    most = std::max(most, qr.rank());
  }
  return static_cast<int>(most);
}

// An arm that rotates about a vertical axis and keeps the tool's axis in a vertical plane, which
// rotates with it.
//
// p_axis  a point on the axis; only x and y are used.
// offset  of the tool point from the axis, along `side`, m.
// side    horizontal, at right angles to the plane, for the first joint at zero.
struct TurningPlane {
  Vector3d p_axis = Vector3d::Zero();
  Vector3d side = Vector3d::UnitY();
  double offset = 0.0;
  double roll = 0.0;  // of the tool at the first sample
  bool keeps_roll = true;
};

double heading(const Vector3d& direction) { return det::atan2(direction.y(), direction.x()); }

// The tool points along Rz(heading) Ry(90 deg - pitch) z.
Matrix3d pointing(double heading, double pitch) {
  return rot_z(heading) * rot_y(0.5 * kPi - pitch);
}

double roll_of(const Matrix3d& R, const Vector3d& side) {
  const Vector3d out = side.cross(Vector3d::UnitZ());
  const double pitch = det::atan2(R(2, 2), R.col(2).dot(out));
  const Matrix3d about = pointing(heading(out), pitch).transpose() * R;
  return det::atan2(about(1, 0), about(0, 0));
}

// Horizontal axis of the first of the other joints that has one; nothing if there is none.
std::optional<Vector3d> horizontal_axis(const Jacobian& J) {
  for (Eigen::Index i = 1; i < J.cols(); ++i) {
    const Vector3d w = J.col(i).tail<3>();
    if (w.norm() > 0.5 && std::abs(w.z()) < kSame) return w;
  }
  return std::nullopt;
}

std::optional<TurningPlane> turning_plane(const Robot& robot, const std::vector<Sample>& samples) {
  if (!robot.is_revolute(0)) return std::nullopt;
  TurningPlane plane;
  bool is_first = true;
  for (const Sample& sample : samples) {
    const Vector3d w = sample.J.col(0).tail<3>();
    if (w.head<2>().norm() > kSame) return std::nullopt;
    const Vector3d p = sample.T.translation();
    const Vector3d p_axis = p + w.cross(Vector3d(sample.J.col(0).head<3>()));
    const auto side = horizontal_axis(sample.J);
    if (!side || std::abs(side->dot(sample.T.linear().col(2))) > kSame) return std::nullopt;
    const Vector3d at_zero = rot_z(-w.z() * sample.q[0]) * *side;
    const double offset = side->dot(p - p_axis);
    const double roll = roll_of(sample.T.linear(), *side);
    if (is_first) plane = {p_axis, at_zero, offset, roll, true};
    is_first = false;
    if ((at_zero - plane.side).norm() > kSame || std::abs(offset - plane.offset) > kSame)
      return std::nullopt;
    // Half a revolution of difference, where the tool points backwards over its axis, is the same
    // roll.
    const double change = wrap_angle(roll - plane.roll);
    plane.keeps_roll = plane.keeps_roll && std::abs(change) < kSame;
  }
  return plane;
}

// The direction of the arm at home is forwards.
void turn_forwards(const Robot& robot, TurningPlane& plane) {
  Jacobian J;
  const Isometry3d T = forward_and_jacobian(robot, robot.home(), J);
  const Vector3d side = rot_z(J(5, 0) * robot.home()[0]) * plane.side;
  const Vector3d out = side.cross(Vector3d::UnitZ());
  if (out.dot(T.translation() - plane.p_axis) >= 0.0) return;
  plane.side = -plane.side;
  plane.offset = -plane.offset;
  plane.roll = roll_of(T.linear(), -side);
}

TaskSpace space_of(const Robot& robot, const std::vector<Sample>& samples) {
  const int n = robot.n();
  const int place = rank_of(samples, {0, 1, 2});
  if (fixed_tilt(robot)) {
    const bool level = std::ranges::all_of(
        samples, [](const Sample& s) { return s.J.row(2).cwiseAbs().maxCoeff() < kSame; });
    const int plane = rank_of(samples, {0, 1, 5});
    if (level && plane == 3) return TaskSpace::kPlane;
    if (level) return n == 2 && plane == 2 ? TaskSpace::kPlanePosition : TaskSpace::kOther;
    if (rank_of(samples, {0, 1, 2, 5}) == 4) return TaskSpace::kHeading;
    return place == 3 ? TaskSpace::kPosition : TaskSpace::kOther;
  }
  const int rank = rank_of(samples, {0, 1, 2, 3, 4, 5});
  if (rank == 6) return TaskSpace::kPose;
  if (n == 3 && place == 3) return TaskSpace::kPosition;
  if (place < 3 || rank != n || (n != 4 && n != 5)) return TaskSpace::kOther;
  const auto plane = turning_plane(robot, samples);
  if (!plane) return TaskSpace::kOther;
  if (n == 5) return TaskSpace::kPitchRoll;
  return plane->keeps_roll ? TaskSpace::kPitch : TaskSpace::kOther;
}

// The task space of an arm, computed once for each.
class ArmTask {
 public:
  struct FromShape {};
  explicit ArmTask(const Robot& robot) {
    const std::vector<Sample> samples = samples_of(robot);
    space_ = space_of(robot, samples);
    if (space_ != TaskSpace::kPitchRoll && space_ != TaskSpace::kPitch) return;
    plane_ = *turning_plane(robot, samples);
    turn_forwards(robot, plane_);
  }
  [[nodiscard]] TaskSpace space() const { return space_; }
  // For an arm with a pitch.
  [[nodiscard]] const TurningPlane& plane() const { return plane_; }

 private:
  TaskSpace space_ = TaskSpace::kOther;
  TurningPlane plane_;
};

// An arm with a tilted tool rotates about z with the tilt that it has.
Isometry3d upright(const Robot& robot, const Vector3d& p, double angle) {
  const Isometry3d T = make_pose(rot_z(angle), p);
  return frame_task(robot, T) ? T : with_heading_of(robot, T, robot.home());
}

std::optional<Isometry3d> in_plane(const Robot& robot, const Vector3d& p, double pitch,
                                   std::optional<double> roll) {
  const TurningPlane& plane = robot.derived<ArmTask>().plane();
  const double x = p.x() - plane.p_axis.x(), y = p.y() - plane.p_axis.y();
  const double out2 = x * x + y * y - plane.offset * plane.offset;
  if (out2 < -kSame) return std::nullopt;
  const double out = std::sqrt(std::max(out2, 0.0));
  const double along = det::atan2(y, x) - det::atan2(plane.offset, out);
  return make_pose(pointing(along, pitch) * rot_z(roll.value_or(plane.roll)), p);
}

}  // namespace

int coordinate_count(TaskSpace space) {
  switch (space) {
    case TaskSpace::kPose:
      return 6;
    case TaskSpace::kPitchRoll:
      return 5;
    case TaskSpace::kPitch:
    case TaskSpace::kHeading:
      return 4;
    case TaskSpace::kPosition:
    case TaskSpace::kPlane:
      return 3;
    case TaskSpace::kPlanePosition:
      return 2;
    case TaskSpace::kOther:
      break;
  }
  return 0;
}

std::string_view coordinate_names(TaskSpace space) {
  switch (space) {
    case TaskSpace::kPose:
      return "x, y, z, roll, pitch and yaw";
    case TaskSpace::kPitchRoll:
      return "x, y, z, pitch and roll";
    case TaskSpace::kPitch:
      return "x, y, z and pitch";
    case TaskSpace::kHeading:
      return "x, y, z and the rotation about z";
    case TaskSpace::kPosition:
      return "x, y and z";
    case TaskSpace::kPlane:
      return "x, y and the rotation about z";
    case TaskSpace::kPlanePosition:
      return "x and y";
    case TaskSpace::kOther:
      break;
  }
  return {};
}

TaskSpace task_space(const Robot& robot) { return robot.derived<ArmTask>().space(); }

std::optional<Isometry3d> pose_of_coordinates(const Robot& robot, std::span<const double> v) {
  const TaskSpace space = task_space(robot);
  if (static_cast<int>(v.size()) != coordinate_count(space) || v.empty()) return std::nullopt;
  const auto height = [&] { return forward(robot, robot.home()).translation().z(); };
  switch (space) {
    case TaskSpace::kPose:
      return pose_from_rpy({v[0], v[1], v[2]}, {v[3], v[4], v[5]});
    case TaskSpace::kPitchRoll:
      return in_plane(robot, {v[0], v[1], v[2]}, v[3], v[4]);
    case TaskSpace::kPitch:
      return in_plane(robot, {v[0], v[1], v[2]}, v[3], std::nullopt);
    case TaskSpace::kHeading:
      return upright(robot, {v[0], v[1], v[2]}, v[3]);
    case TaskSpace::kPlane:
      return upright(robot, {v[0], v[1], height()}, v[2]);
    case TaskSpace::kPosition:
      return make_translation({v[0], v[1], v[2]});
    case TaskSpace::kPlanePosition:
      return make_translation({v[0], v[1], height()});
    case TaskSpace::kOther:
      break;
  }
  return std::nullopt;
}

}  // namespace armlet
