#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <span>

#include "armlet/kinematics/closed_form.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/math/twist.hpp"
#include "closed_form_families.hpp"
#include "closed_lanes.hpp"
#include "kinematics/forward/kernels.hpp"
#include "math/det_kernels.hpp"
#include "one_to_four_joints.hpp"

namespace armlet {
namespace {

constexpr double kVerified = 1e-9;  // m and rad
constexpr double kImproved = 1e-2;  // largest error that rounding near a singularity can cause
constexpr int kRounds = 6;          // of the refinement
constexpr double kSameAngle = 1e-6;

FamilySolver solver_of(ClosedFormKind kind) {
  switch (kind) {
    case ClosedFormKind::kNone:
      break;
    case ClosedFormKind::kPlane:
      return solve_plane;
    case ClosedFormKind::kScara:
      return solve_scara;
    case ClosedFormKind::kShoulder:
      return solve_shoulder;
    case ClosedFormKind::kPlanarArmTwist:
      return solve_planar_arm_twist;
    case ClosedFormKind::kSphericalParallel:
    case ClosedFormKind::kSphericalMeeting:
      return solve_spherical_wrist;
    case ClosedFormKind::kThreeParallel:
      return solve_three_parallel;
    case ClosedFormKind::kShoulderElbowWrist:
      return solve_shoulder_elbow_wrist;
    case ClosedFormKind::kFewPosition:
      return solve_few_position;
    case ClosedFormKind::kFewPose:
      return solve_few_pose;
    case ClosedFormKind::kMeetingWrist:
    case ClosedFormKind::kSphericalWrist:
      return solve_any_wrist;
  }
  return nullptr;
}

// An angle within two revolutions of 0, moved into (-pi, pi].
double wrapped(double angle) {
  if (angle > kPi) return angle - 2.0 * kPi;
  return angle <= -kPi ? angle + 2.0 * kPi : angle;
}

std::size_t joint_of(const CanonicalRows& rows, std::size_t i) {
  return rows.reversed ? static_cast<std::size_t>(rows.n) - 1 - i : i;
}

Branch branch_of(const CanonicalRows& rows, const double* q) {
  Branch out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.n); ++i) {
    const double x = rows.sign[i] * (q[joint_of(rows, i)] + rows.offset[i]);
    if (rows.revolute[i]) {
      const det::SinCos angle = det::sincos_inline(x);
      out.phi[i] = {angle.cos, angle.sin};
    } else {
      out.phi[i] = rows.phi[i];
      out.height[i] = x;
    }
  }
  return out;
}

void joints_of(const CanonicalRows& rows, const Branch& branch, double* q) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.n); ++i) {
    const double x =
        rows.revolute[i] ? det::atan2(branch.phi[i].s, branch.phi[i].c) : branch.height[i];
    const double value = rows.sign[i] * x - rows.offset[i];
    q[joint_of(rows, i)] = rows.revolute[i] ? wrap_angle(value) : value;
  }
}

bool is_same(const Chain& chain, const ClosedSolution& a, const ClosedSolution& b) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.n); ++i) {
    const double change = a.q[i] - b.q[i];
    if (std::abs(chain.revolute[i] ? wrapped(change) : change) > kSameAngle) return false;
  }
  return true;
}

// The rotation vector from one orientation to another, for small angles; a long vector for large
// ones.
Eigen::Vector3d small_angle(const Eigen::Matrix3d& R, const Eigen::Matrix3d& R_goal) {
  if (R.cwiseProduct(R_goal).sum() < 1.0) return {kPi, 0.0, 0.0};
  Eigen::Vector3d sum = R.col(0).cross(R_goal.col(0));
  sum += R.col(1).cross(R_goal.col(1));
  sum += R.col(2).cross(R_goal.col(2));
  return 0.5 * sum;
}

}  // namespace

// Whether a solution is correct; one that is nearly so, near a singularity, is refined first as
// long as that helps.
bool ClosedForm::accept(const Eigen::Isometry3d& goal, double tolerance,
                        ClosedSolution& solution) const {
  Eigen::Map<Eigen::VectorXd> q(solution.q.data(), chain_.n);
  std::array<double, kMaxJoints> best = solution.q;
  double least = INFINITY;
  for (int round = 0; round < kRounds && q.allFinite(); ++round) {
    Eigen::Isometry3d T_world_tool;
    kernel_for(kPoseKernels, chain_.n)(plan_, q.data(), T_world_tool.data());
    Vector6d e;
    e << goal.translation() - T_world_tool.translation(),
        small_angle(T_world_tool.linear(), goal.linear());
    if (position_only()) e.tail<3>().setZero();
    const double miss = std::fmax(e.head<3>().norm(), e.tail<3>().norm());
    if (!(miss < least)) break;
    least = miss;
    best = solution.q;
    if (miss <= std::fmin(kVerified, tolerance)) break;
    if (miss > kImproved) return false;
    Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints> J(6, chain_.n);
    kernel_for(kJacobianKernels, chain_.n)(plan_, q.data(), J.data());
    if (position_only()) J.bottomRows<3>().setZero();
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, kMaxJoints>;
    Square H = J.transpose() * J;
    H.diagonal().array() += 1e-3 * miss;
    q += H.ldlt().solve(J.transpose() * e);
  }
  solution.q = best;
  return least <= tolerance;
}

// Adds the solutions of the lanes; each was checked by forward kinematics.
int ClosedForm::take_lanes(const Eigen::Isometry3d& goal, double tolerance,
                           const ClosedSolution& start, const ClosedLanes& lanes, unsigned wanted,
                           ClosedSolutions& solutions) const {
  const double verified = std::fmin(kVerified, tolerance);
  const std::size_t first = hold_ == Hold::kFirst ? 1 : 0;
  for (std::size_t k = 0; k < kSolutions; ++k) {
    if (!(lanes.miss2[k] <= kImproved * kImproved) || (wanted >> k & 1U) == 0) continue;
    ClosedSolution& solution = solutions.at[static_cast<std::size_t>(solutions.count)];
    if (hold_ != Hold::kNone) solution = start;
    for (std::size_t i = 0; i < kSixJoints; ++i) solution.q[first + i] = lanes.q[i][k];
    solution.n = chain_.n;
    solution.branch = static_cast<int>(k);
    if (lanes.miss2[k] <= verified * verified || accept(goal, tolerance, solution))
      ++solutions.count;
  }
  return solutions.count;
}

Eigen::Isometry3d ClosedForm::without_held(const Eigen::Isometry3d& T_world_tool,
                                           double held) const {
  const std::size_t i = static_cast<std::size_t>(held_joint());
  const det::SinCos angle = det::sincos(held * chain_.q_to_theta[i]);
  Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
  back.linear() << angle.cos, angle.sin, 0, -angle.sin, angle.cos, 0, 0, 0, 1;
  back.translation().z() = -held * chain_.q_to_d[i];
  const Eigen::Isometry3d inverse = T_beside_held_.inverse(Eigen::Isometry);
  if (hold_ == Hold::kFirst) return T_beside_held_ * back * inverse * T_world_tool;
  return T_world_tool * inverse * back * T_beside_held_;
}

int ClosedForm::solve(const Eigen::Isometry3d& T_world_tool, JointsIn q_near,
                      ClosedSolutions& solutions, double tolerance, double arm_angle_change,
                      unsigned wanted) const {
  solutions.count = 0;
  solutions.free = false;
  solutions.open = 0;
  if (!exists()) return 0;
  ClosedSolution start;
  start.n = chain_.n;
  std::copy(q_near.data(), q_near.data() + chain_.n, start.q.begin());
  Eigen::Isometry3d goal = T_world_tool;
  if (hold_ != Hold::kNone) {
    double& held = start.q[static_cast<std::size_t>(held_joint())];
    held += arm_angle_change;
    goal = without_held(T_world_tool, held);
  }
  if (ClosedLanes lanes; lanes_ && lanes_->solve(goal, lanes))
    return take_lanes(T_world_tool, tolerance, start, lanes, wanted, solutions);
  const std::size_t first = hold_ == Hold::kFirst ? 1 : 0;
  Branches branches;
  branches.arm_angle_change = arm_angle_change;
  solver_of(kind_)(*rows_, rows_->goal(goal), branch_of(*rows_, start.q.data() + first), branches);
  solutions.free = branches.free;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows_->n); ++i) {
    if ((branches.open >> i & 1U) != 0) solutions.open |= 1U << (joint_of(*rows_, i) + first);
  }
  for (int i = 0; i < branches.count; ++i) {
    const Branch& branch = branches.at[static_cast<std::size_t>(i)];
    if ((wanted >> branch.bits & 1U) == 0) continue;
    ClosedSolution& solution = solutions.at[static_cast<std::size_t>(solutions.count)];
    solution = start;
    solution.branch = branch.bits;
    joints_of(*rows_, branch, solution.q.data() + first);
    if (!accept(T_world_tool, tolerance, solution)) continue;
    const auto same = [&](const ClosedSolution& other) { return is_same(chain_, solution, other); };
    if (std::none_of(solutions.begin(), solutions.end(), same)) ++solutions.count;
  }
  std::ranges::sort(std::span(solutions.at).first(solutions.count), {}, &ClosedSolution::branch);
  return solutions.count;
}

}  // namespace armlet
