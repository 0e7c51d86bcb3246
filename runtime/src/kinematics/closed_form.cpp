#include "armlet/kinematics/closed_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/rotation.hpp"
#include "closed_form_families.hpp"

namespace armlet {
namespace {

constexpr double kVerified = 1e-9;  // m and rad
constexpr double kImproved = 1e-4;  // an error that rounding next to a singularity can make
constexpr double kSameAngle = 1e-6;

// All joints turn, but for joint `except`.
bool all_turn(const CanonicalRows& rows, std::size_t except = kMaxJoints) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.n); ++i) {
    if (!rows.revolute[i] && i != except) return false;
  }
  return true;
}

// Joints 1 to 3 reach a place by formula; the third may slide where axes 1 and 2 meet.
bool has_shoulder(const CanonicalRows& rows) {
  if (rows.parallel(1) || !all_turn(rows, 2)) return false;
  return rows.meet(1) || (rows.parallel(2) && rows.revolute[2]);
}

bool is_scara(const CanonicalRows& rows) {
  int sliding = 0;
  for (std::size_t i = 0; i < 4; ++i) sliding += rows.revolute[i] ? 0 : 1;
  return sliding == 1 && rows.parallel(1) && rows.parallel(2) && rows.parallel(3);
}

ClosedFormKind recognised_six(const CanonicalRows& rows) {
  if (rows.meet(4) && rows.meet(5) && rows.h[4] == 0.0 && has_shoulder(rows))
    return rows.parallel(2) ? ClosedFormKind::kSphericalParallel
                            : ClosedFormKind::kSphericalMeeting;
  const bool three = !rows.parallel(1) && rows.parallel(2) && rows.parallel(3) && !rows.parallel(4);
  return three && rows.meet(5) ? ClosedFormKind::kThreeParallel : ClosedFormKind::kNone;
}

ClosedFormKind recognised(const CanonicalRows& rows) {
  if (rows.n == 4 && is_scara(rows)) return ClosedFormKind::kScara;
  if (rows.n == 6) return recognised_six(rows);
  if (rows.n == 3 && has_shoulder(rows) && !rows.reversed) return ClosedFormKind::kShoulder;
  if (!all_turn(rows)) return ClosedFormKind::kNone;
  switch (rows.n) {
    case 3:
      return rows.parallel(1) && rows.parallel(2) ? ClosedFormKind::kPlane : ClosedFormKind::kNone;
    case 5:
      return !rows.parallel(1) && rows.parallel(2) && rows.parallel(3) && !rows.parallel(4)
                 ? ClosedFormKind::kPlanarArmTwist
                 : ClosedFormKind::kNone;
    case 7: {
      const bool shoulder = rows.meet(1) && rows.meet(2) && rows.h[1] == 0.0;
      const bool wrist = rows.meet(5) && rows.meet(6) && rows.h[5] == 0.0;
      return shoulder && wrist && !rows.parallel(3) ? ClosedFormKind::kShoulderElbowWrist
                                                    : ClosedFormKind::kNone;
    }
    default:
      return ClosedFormKind::kNone;
  }
}

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
  }
  return nullptr;
}

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

std::size_t joint_of(const CanonicalRows& rows, std::size_t i) {
  return rows.reversed ? static_cast<std::size_t>(rows.n) - 1 - i : i;
}

Branch branch_of(const CanonicalRows& rows, JointsIn q) {
  Branch out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.n); ++i) {
    const double value = q[static_cast<Eigen::Index>(joint_of(rows, i))];
    const double x = rows.sign[i] * (value + rows.offset[i]);
    if (rows.revolute[i]) {
      const det::SinCos turn = det::sincos(x);
      out.phi[i] = {turn.cos, turn.sin};
    } else {
      out.phi[i] = rows.phi[i];
      out.height[i] = x;
    }
  }
  return out;
}

// The arm with its first or last joint held still.
Chain held(const Chain& chain, bool first, double q) {
  Chain out = chain;
  const std::size_t n = static_cast<std::size_t>(chain.n);
  const std::size_t i = first ? 0 : n - 1;
  const Eigen::Isometry3d Z = dh_pose(
      DhConvention::kStandard,
      {.theta = chain.theta[i] + q * chain.turns[i], .d = chain.d[i] + q * chain.slides[i]});
  const auto x = [&chain](std::size_t k) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() << 1, 0, 0, 0, chain.cos_alpha[k], -chain.sin_alpha[k], 0, chain.sin_alpha[k],
        chain.cos_alpha[k];
    X.translation().x() = chain.a[k];
    return X;
  };
  out.n = chain.n - 1;
  if (!first) {
    out.T_flange_tool = Z * x(n) * chain.T_flange_tool;
    return out;
  }
  out.T_world_base = chain.T_world_base * x(0) * Z;
  const auto shift = [n](auto& values) {
    std::copy(
        values.begin() + 1,
        values.begin() + static_cast<std::ptrdiff_t>(n + 1 < values.size() ? n + 1 : values.size()),
        values.begin());
  };
  for (auto* values : {&out.theta, &out.d, &out.turns, &out.slides}) shift(*values);
  for (auto* values : {&out.a, &out.sin_alpha, &out.cos_alpha}) shift(*values);
  shift(out.revolute);
  return out;
}

Eigen::VectorXd joints_of(const CanonicalRows& rows, const Branch& branch) {
  Eigen::VectorXd q(rows.n);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.n); ++i) {
    const double x =
        rows.revolute[i] ? det::atan2(branch.phi[i].s, branch.phi[i].c) : branch.height[i];
    const double value = rows.sign[i] * x - rows.offset[i];
    q[static_cast<Eigen::Index>(joint_of(rows, i))] = rows.revolute[i] ? wrapped(value) : value;
  }
  return q;
}

bool is_new(const Robot& robot, const Eigen::VectorXd& q,
            const std::vector<Eigen::VectorXd>& known) {
  for (const Eigen::VectorXd& other : known) {
    double largest = 0.0;
    for (int i = 0; i < robot.n(); ++i) {
      const double change = q[i] - other[i];
      largest = std::fmax(largest, std::abs(robot.is_revolute(i) ? wrapped(change) : change));
    }
    if (largest <= kSameAngle) return false;
  }
  return true;
}

// Whether q is right; an answer that is nearly right, next to a singularity, is improved first.
bool reaches(const Robot& robot, Eigen::VectorXd& q, const Eigen::Isometry3d& goal,
             bool place_only) {
  Jacobian J;
  for (int round = 0; round < 4; ++round) {
    const Eigen::Isometry3d T = forward_and_jacobian(robot, q, J);
    Vector6d e;
    e << goal.translation() - T.translation(), rotation_log(goal.linear() * T.linear().transpose());
    if (place_only) e.tail<3>().setZero();
    const double miss = std::fmax(e.head<3>().norm(), e.tail<3>().norm());
    if (miss <= kVerified) return true;
    if (miss > kImproved) return false;
    const int rows = place_only ? 3 : 6;
    const Eigen::MatrixXd A = J.topRows(rows);
    const Eigen::MatrixXd H =
        A.transpose() * A + 1e-3 * miss * Eigen::MatrixXd::Identity(q.size(), q.size());
    q += H.ldlt().solve(A.transpose() * e.head(rows));
  }
  return false;
}

}  // namespace

std::string_view to_text(ClosedFormKind kind) {
  switch (kind) {
    case ClosedFormKind::kNone:
      return "none";
    case ClosedFormKind::kPlane:
      return "three parallel axes";
    case ClosedFormKind::kScara:
      return "SCARA: three parallel axes and a slide along them";
    case ClosedFormKind::kShoulder:
      return "three joints that reach a place";
    case ClosedFormKind::kPlanarArmTwist:
      return "five joints, axes 2, 3 and 4 parallel";
    case ClosedFormKind::kSphericalParallel:
      return "six joints, spherical wrist, axes 2 and 3 parallel";
    case ClosedFormKind::kSphericalMeeting:
      return "six joints, spherical wrist, axes 1 and 2 meet";
    case ClosedFormKind::kThreeParallel:
      return "six joints, axes 2, 3 and 4 parallel, 5 and 6 meet";
    case ClosedFormKind::kShoulderElbowWrist:
      return "seven joints, spherical shoulder and wrist";
  }
  return "none";
}

ClosedForm::ClosedForm(const Robot& robot) : robot_(&robot) {
  recognise(robot.chain());
  if (exists() || robot.n() != 7) return;
  for (const Hold hold : {Hold::kLast, Hold::kFirst}) {
    hold_ = hold;
    recognise(held(robot.chain(), hold == Hold::kFirst, 0.0));
    if (exists()) return;
  }
  hold_ = Hold::kNone;
}

void ClosedForm::recognise(const Chain& chain) {
  for (const bool reversed : {false, true}) {
    auto rows = std::make_unique<CanonicalRows>(canonical_rows(chain, reversed));
    kind_ = recognised(*rows);
    reversed_ = reversed;
    rows_ = std::move(rows);
    if (exists()) return;
  }
}

ClosedForm::~ClosedForm() = default;
ClosedForm::ClosedForm(ClosedForm&&) noexcept = default;
ClosedForm& ClosedForm::operator=(ClosedForm&&) noexcept = default;

int ClosedForm::solve(const Eigen::Isometry3d& T_world_tool, JointsIn q_near,
                      std::vector<Eigen::VectorXd>& solutions) const {
  solutions.clear();
  if (!exists()) return 0;
  const int n = robot_->n();
  const int first = hold_ == Hold::kFirst ? 1 : 0;
  const int moving = hold_ == Hold::kNone ? n : n - 1;
  const CanonicalRows* rows = rows_.get();
  CanonicalRows of_held;
  if (hold_ != Hold::kNone) {
    of_held = canonical_rows(held(robot_->chain(), first == 1, q_near[first == 1 ? 0 : n - 1]),
                             reversed_);
    rows = &of_held;
  }
  Branches branches;
  solver_of(kind_)(*rows, rows->goal(T_world_tool), branch_of(*rows, q_near.segment(first, moving)),
                   branches);
  const bool place_only = kind_ == ClosedFormKind::kShoulder;
  for (int i = 0; i < branches.count; ++i) {
    Eigen::VectorXd q = q_near;
    q.segment(first, moving) = joints_of(*rows, branches.at[static_cast<std::size_t>(i)]);
    if (q.allFinite() && reaches(*robot_, q, T_world_tool, place_only) &&
        is_new(*robot_, q, solutions))
      solutions.push_back(std::move(q));
  }
  return static_cast<int>(solutions.size());
}

}  // namespace armlet
