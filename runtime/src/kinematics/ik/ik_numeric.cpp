#include "ik_numeric.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/rotation.hpp"
#include "chain/lane_pairs.hpp"
#include "kinematics/forward/periodic.hpp"

namespace armlet {
namespace {

constexpr double kDampingRatio = 0.1;   // of the squared error
constexpr double kSmallestStep = 1e-9;  // rad or m; below it the iteration has ended
constexpr double kTinyStep = 1e-8;      // rad or m; the error of the linear model is below 1e-15

constexpr double kSmallRotation =
    2.0 - 1e-8;  // twice the cosine; below 1e-4 rad a sine has two terms

constexpr std::uint64_t kIterationWork = 50;  // operations; few starts need all their iterations

double length_of(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

}  // namespace

IkSolver::IkSolver(const Robot& robot, const IkGoal& goal, const IkPace& pace)
    : plan_(robot.walk_plan()),
      coupling_(robot.coupling()),
      pose_kernel_(kernel_for(kPoseKernels, robot.rows())),
      kernel_(kernel_for(kPoseAndJacobianKernels, robot.rows())),
      iteration_kernel_(kernel_for(kIterationKernels, robot.n())),
      normal_kernel_(kernel_for(kNormalKernels, robot.n())),
      step_kernel_(kernel_for(kStepKernels, robot.n())),
      goal_(goal),
      n_(static_cast<std::size_t>(robot.n())),
      lower_(robot.lower().data()),
      upper_(robot.upper().data()),
      selective_((goal.weights.array() != 1.0).any()),
      plain_(!selective_ && !goal.in_tool_axes && coupling_ == nullptr),
      pace_(pace) {}

// The rotation error, with the approximation of the iteration's kernel or exactly.
Eigen::Vector3d IkSolver::rotation_error(const double* T_world_tool, bool exact) const {
  double twice_cosine = -1.0;
  double w[3] = {};
#pragma GCC unroll 3
  for (std::size_t c = 0; c < 3; ++c) {
    const double* axis = T_world_tool + 4 * c;
    const double* goal = goal_.R.data() + 3 * c;
    twice_cosine += axis[0] * goal[0] + axis[1] * goal[1] + axis[2] * goal[2];
    w[0] += axis[1] * goal[2] - axis[2] * goal[1];
    w[1] += axis[2] * goal[0] - axis[0] * goal[2];
    w[2] += axis[0] * goal[1] - axis[1] * goal[0];
  }
  if (twice_cosine < (exact ? kSmallRotation : 0.0)) {
    far_rotation_error(T_world_tool, goal_.R.data(), w);
    return {w[0], w[1], w[2]};
  }
  const double square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];  // of twice the sine
  const double factor = exact ? 0.5 + square / 48.0 : 1.0 / (1.28 + 0.36 * twice_cosine);
  return {factor * w[0], factor * w[1], factor * w[2]};
}

// Limits the step to the largest one; false if the iteration has ended. Two joints at a time, as
// the kernels load them.
inline bool IkSolver::move(JointArray& q) const {
  const Step& step = at_.step;
  if (!(at_.largest >= kSmallestStep)) return false;
  if (at_.largest > pace_.largest_step) {
    const double scale = pace_.largest_step / at_.largest;
    for (std::size_t i = 0; i < n_; ++i) q[i] += scale * step[i];
    return true;
  }
  for (std::size_t i = 0; i + 1 < n_; i += 2)
    store_pair(q.data() + i, load_pair(q.data() + i) + load_pair(step.data() + i));
  if (n_ % 2 == 1) q[n_ - 1] += step[n_ - 1];
  return true;
}

JointArray IkSolver::rows_at(const JointArray& q) const {
  JointArray rows{};
  const auto m = static_cast<Eigen::Index>(plan_.n);
  Eigen::Map<Eigen::VectorXd>(rows.data(), m) =
      coupling_->values(Eigen::Map<const Eigen::VectorXd>(q.data(), coupling_->E.cols()));
  return rows;
}

// Adds up the columns of rows that the same joint moves.
void IkSolver::pose_and_jacobian(const JointArray& q, double* T_world_tool) {
  if (coupling_ == nullptr) [[likely]]
    return kernel_(plan_, q.data(), at_.J.data()->data(), T_world_tool);
  const JointArray rows = rows_at(q);
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMaxJoints> J(6, plan_.n);
  kernel_(plan_, rows.data(), J.data(), T_world_tool);
  Eigen::Map<Eigen::Matrix<double, 6, Eigen::Dynamic>>(at_.J.data()->data(), 6,
                                                       coupling_->E.cols()) = J * coupling_->E;
}

double IkSolver::evaluate(const JointArray& q) {
  Eigen::Isometry3d T_world_tool;
  pose_and_jacobian(q, T_world_tool.data());
  const double* T = T_world_tool.data();
  const Eigen::Vector3d w = rotation_error(T, exact_angle_);
  // Stored in pairs, because the normal equations load pairs: loading a pair that was stored as
  // single numbers would stall.
  store_pair(at_.error.data(), load_pair(goal_.p.data()) - load_pair(T + 12));
  store_pair(at_.error.data() + 2, Lanes{goal_.p[2] - T[14], w[0]});
  store_pair(at_.error.data() + 4, Lanes{w[1], w[2]});
  if (goal_.in_tool_axes) rotate_rows(T_world_tool.linear().transpose());
  if (selective_)
    select_rows();
  else {
    at_.position = length_of(at_.error.data());
    at_.rotation = length_of(at_.error.data() + 3);
  }
  at_.energy = 0.0;
  for (const double e : at_.error) at_.energy += 0.5 * e * e;
  return at_.energy;
}

double IkSolver::iterate(const JointArray& q, bool in_box) {
  const bool on_bound = in_box && !is_inside(q);
  if (plain_ && !on_bound) {
    iteration_kernel_(plan_, q.data(), goal_.p.data(), goal_.R.data(), kDampingRatio, at_);
    return at_.energy;
  }
  evaluate(q);
  normal_equations();
  const double damping = kDampingRatio * at_.energy;
  at_.step = on_bound ? step_in_box(q, damping) : solve_step(damping);
  at_.largest = 0.0;
  for (std::size_t i = 0; i < n_; ++i) at_.largest = std::max(at_.largest, std::abs(at_.step[i]));
  return at_.energy;
}

// Rotates the rows.
void IkSolver::rotate_rows(const Eigen::Matrix3d& R) {
  const auto rotate = [&R](std::array<double, 6>& rows) {
    Eigen::Map<Vector6d> twist(rows.data());
    twist = rotate_twist(R, twist);
  };
  rotate(at_.error);
  for (std::size_t i = 0; i < n_; ++i) rotate(at_.J[i]);
}

// Removes rows with weight 0 and scales the others by their weights.
void IkSolver::select_rows() {
  double position = 0.0, rotation = 0.0;
  for (std::size_t r = 0; r < 6; ++r) {
    const double weight = goal_.weights[static_cast<Eigen::Index>(r)];
    if (weight != 0.0) (r < 3 ? position : rotation) += at_.error[r] * at_.error[r];
    at_.error[r] *= weight;
    for (std::size_t i = 0; i < n_; ++i) at_.J[i][r] *= weight;
  }
  at_.position = std::sqrt(position);
  at_.rotation = std::sqrt(rotation);
}

bool IkSolver::converged() const { return goal_.is_met({at_.position, at_.rotation}); }

IkError IkSolver::error_of(const JointArray& q) {
  Eigen::Isometry3d T_world_tool;
  const JointArray rows = coupling_ == nullptr ? q : rows_at(q);
  pose_kernel_(plan_, rows.data(), T_world_tool.data());
  Vector6d error;
  error.head<3>() = goal_.p - T_world_tool.translation();
  error.tail<3>() = rotation_error(T_world_tool.data(), true);
  if (goal_.in_tool_axes) error = rotate_twist(T_world_tool.linear().transpose(), error);
  if (selective_) error = (goal_.weights.array() != 0.0).select(error, 0.0);
  return {length_of(error.data()), length_of(error.data() + 3)};
}

IkRows IkSolver::rows_of(const JointArray& q) {
  const bool before = std::exchange(exact_angle_, true);
  evaluate(q);
  exact_angle_ = before;
  IkRows rows{Eigen::Map<const Vector6d>(at_.error.data()), {}};
  rows.J.resize(6, static_cast<Eigen::Index>(n_));
  for (std::size_t i = 0; i < n_; ++i)
    rows.J.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Vector6d>(at_.J[i].data());
  return rows;
}

void IkSolver::normal_equations() {
  normal_kernel_(static_cast<int>(n_), at_.J.data()->data(), at_.error.data(), at_.normal);
}

IkSolver::Step IkSolver::solve_step(double damping) const {
  Step step;
  step_kernel_(static_cast<int>(n_), at_.normal, damping, step.data());
  return step;
}

// Rows and columns of frozen joints become those of the identity.
IkSolver::Step IkSolver::solve_step(double damping, const Frozen& frozen) const {
  NormalEquations free = at_.normal;
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (frozen[i] || frozen[k]) free.A[i][k] = 0.0;
    }
    if (!frozen[i]) continue;
    free.A[i][i] = 1.0;
    free.b[i] = 0.0;
  }
  Step step;
  step_kernel_(static_cast<int>(n_), free, damping, step.data());
  return step;
}

IkSolver::Step IkSolver::step_in_box(const JointArray& q, double damping) const {
  Frozen frozen{};
  bool any = false;
  // Freezes joints on a bound that they would cross.
  const auto freeze = [&](const double* direction) {
    bool more = false;
    for (std::size_t i = 0; i < n_; ++i) {
      const bool leaves =
          (q[i] <= lower_[i] && direction[i] < 0.0) || (q[i] >= upper_[i] && direction[i] > 0.0);
      if (!frozen[i] && leaves) more = any = frozen[i] = true;
    }
    return more;
  };
  freeze(at_.normal.b);
  Step step = any ? solve_step(damping, frozen) : solve_step(damping);
  for (int pass = 0; pass < 3 && freeze(step.data()); ++pass) step = solve_step(damping, frozen);
  return step;
}

void IkSolver::clamp(JointArray& q) const {
  for (std::size_t i = 0; i < n_; ++i) q[i] = std::clamp(q[i], lower_[i], upper_[i]);
}

bool IkSolver::is_within_limits(const JointArray& q) const {
  for (std::size_t i = 0; i < n_; ++i) {
    if (!(q[i] >= lower_[i] && q[i] <= upper_[i])) return false;
  }
  return true;
}

bool IkSolver::is_inside(const JointArray& q) const {
  for (std::size_t i = 0; i < n_; ++i) {
    if (q[i] <= lower_[i] || q[i] >= upper_[i]) return false;
  }
  return true;
}

bool IkSolver::solve_free(JointArray& q, int iterations) { return solve(q, iterations, false); }

bool IkSolver::solve_in_box(JointArray& q, int iterations) { return solve(q, iterations, true); }

bool IkSolver::solve(JointArray& q, int iterations, bool in_box) {
  checkpoint(kIterationWork * static_cast<std::uint64_t>(iterations));
  double best = INFINITY;
  int stalled = 0;
  if (in_box) clamp(q);
  for (int it = 0; it < iterations; ++it) {
    ++iterations_used_;
    const double energy = iterate(q, in_box);
    if (converged()) {
      polish(q, in_box);
      return true;
    }
    stalled = energy < pace_.progress * best ? 0 : stalled + 1;
    best = std::min(best, energy);
    if (stalled >= pace_.stall) return false;
    if (!move(q)) return false;
    if (in_box) clamp(q);
  }
  return false;
}

bool IkSolver::correct(JointArray& q, double error) {
  iterations_used_ += 2;
  iterate(q, false);
  move(q);
  const bool close = iterate(q, false) < 0.5 * error * error;
  move(q);
  return close;
}

// A few more steps while each at least halves the error; for a regular goal one is enough.
void IkSolver::polish(JointArray& q, bool in_box) {
  double energy = at_.energy;
  for (int it = 0; it < 6 && energy > 1e-26; ++it) {
    if (!(at_.largest < pace_.largest_step)) return;
    JointArray next = q;
    for (std::size_t i = 0; i < n_; ++i) next[i] += at_.step[i];
    if (in_box) clamp(next);
    const bool tiny = at_.largest < kTinyStep;
    const double next_energy = tiny ? promised_energy(q, next) : iterate(next, in_box);
    if (!(next_energy < 0.25 * energy)) return;
    q = next;
    if (tiny) return;
    energy = next_energy;
  }
}

// Half the squared error at `next` by the linear model at q.
double IkSolver::promised_energy(const JointArray& q, const JointArray& next) const {
  double energy = 0.0;
  for (std::size_t r = 0; r < 6; ++r) {
    double e = at_.error[r];
    for (std::size_t i = 0; i < n_; ++i) e -= at_.J[i][r] * (next[i] - q[i]);
    energy += 0.5 * e * e;
  }
  return energy;
}

void IkSolver::minimise_in_box(JointArray& q, int iterations) {
  exact_angle_ = true;  // the gradient J^T e is that of the true angle only
  clamp(q);
  double energy = evaluate(q);
  normal_equations();
  double mu = 1e-3;
  double nu = 2.0;
  for (int it = 0; it < iterations; ++it) {
    ++iterations_used_;
    const Step step = step_in_box(q, mu);
    JointArray next = q;
    for (std::size_t i = 0; i < n_; ++i) next[i] += step[i];
    clamp(next);
    // The decrease that the linear model predicts for the step after clamping.
    double promised = 0.0, largest = 0.0;
    std::array<double, 6> change{};
    for (std::size_t i = 0; i < n_; ++i) {
      const double s = next[i] - q[i];
      largest = std::max(largest, std::abs(s));
      promised += at_.normal.b[i] * s;
      for (std::size_t r = 0; r < 6; ++r) change[r] += at_.J[i][r] * s;
    }
    for (const double c : change) promised -= 0.5 * c * c;
    if (largest < 1e-12) return;
    const double next_energy = evaluate(next);
    const double ratio = promised > 0.0 ? (energy - next_energy) / promised : -1.0;
    if (ratio > 0.0) {
      q = next;
      energy = next_energy;
      normal_equations();
      const double t = 2.0 * ratio - 1.0;
      mu = std::max(mu * std::max(1.0 / 3.0, 1.0 - t * t * t), 1e-15);
      nu = 2.0;
    } else {
      evaluate(q);
      mu *= nu;
      nu *= 2.0;
      if (mu > 1e12) return;
    }
  }
}

double halton_share(int joint, int index) {
  constexpr std::array<int, kMaxJoints> kPrimes = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  const int base = kPrimes[static_cast<std::size_t>(joint)];
  double share = index == 0 ? 0.5 : 0.0;
  double digit = 1.0 / base;
  for (int rest = index; rest > 0; rest /= base) {
    share += digit * (rest % base);
    digit /= base;
  }
  return share;
}

JointArray halton_start(const Robot& robot, int index, bool inside_limits) {
  JointArray q{};
  for (int i = 0; i < robot.n(); ++i) {
    const double middle = 0.5 * (robot.lower()[i] + robot.upper()[i]);
    double range = robot.upper()[i] - robot.lower()[i];
    if (is_periodic(robot, i))
      range = inside_limits ? std::min(range, 2.0 * kPi) : 2.0 * kPi;
    else if (robot.is_revolute(i))  // its mimic joints need more than one revolution to return
      range = std::min(range, 4.0 * kPi);
    else if (!inside_limits)
      range += 2.0 * robot.length();
    q[static_cast<std::size_t>(i)] = middle + (halton_share(i, index) - 0.5) * range;
  }
  return q;
}

JointArray to_array(const Eigen::VectorXd& q) {
  JointArray array{};
  for (Eigen::Index i = 0; i < q.size(); ++i) array[static_cast<std::size_t>(i)] = q[i];
  return array;
}

Eigen::VectorXd to_vector(const JointArray& q, int n) {
  return Eigen::Map<const Eigen::VectorXd>(q.data(), n);
}

}  // namespace armlet
