#include "trajectory/tool/line_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "armlet/core/checkpoint.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/spline.hpp"
#include "math/solvers.hpp"
#include "trajectory/tool/least_step.hpp"

namespace armlet {
namespace {

constexpr int kFirstIntervals = 16;
constexpr int kHalvings = 8;      // 16 * 2^8 = 4096 intervals at most
constexpr int kEasyHalvings = 6;  // until joints that have a choice may turn off
constexpr double kBend = 0.5;     // of the change allowed between samples
constexpr double kTurn = 0.2;     // rad, of the curve's direction from one step to the next
constexpr double kRotationPerSample = 2.0 * std::numbers::pi / 180.0;
constexpr double kSlidePerSample = 0.02;  // m
// Between samples, m and rad; looked at halfway, so a little less than what is promised.
constexpr double kPositionDeviation = 8e-7;
constexpr double kAngleDeviation = 8e-6;
constexpr double kGivenDeviates = 10.0;     // factor where the curve need not be followed exactly
constexpr double kSampleTolerance = 1e-10;  // m and rad, at samples
constexpr double kSwing = 5e-10;            // rad or m, beyond a limit between samples
constexpr int kSlideSteps = 8;
constexpr int kSettleSteps = 12;         // where what is left to choose is to settle too,
constexpr double kSettled = 1e-9;        // rad or m
constexpr double kRotationShare = 1e-4;  // of a joint's own motion in what rotates the tool
constexpr double kLargestSlide = 10.0;   // allowed changes between samples; a larger one is a jump

// Joint change between neighbouring samples, as a multiple of the allowed one.
double change(const Robot& robot, const Eigen::VectorXd& q0, const Eigen::VectorXd& q1,
              int* joint = nullptr) {
  double largest = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    const double allowed = robot.is_revolute(i) ? kRotationPerSample : kSlidePerSample;
    const double part = std::abs(q1[i] - q0[i]) / allowed;
    if (part <= largest) continue;
    largest = part;
    if (joint != nullptr) *joint = i;
  }
  return largest;
}

// Radians per metre of the curve, for a joint at its limit; tried one after another.
constexpr std::array<double, LineSamples::kWays> kAway = {12.0, 48.0, 24.0, 6.0};
// Rates, per metre of the curve and relative to the distance to its limit, at which a redundant
// joint may approach the limit; tried one after another.
constexpr std::array<double, 3> kApproach = {50.0, 200.0, 800.0};
constexpr double kRotationLengthOfDamping = 0.2;  // m, what a rotation by one radian counts for

// Preferred direction of the joints of a redundant arm: away from their limits, more strongly the
// closer they are, per metre of the curve.
Eigen::VectorXd away_from_limits(const Robot& robot, const Eigen::VectorXd& q, double most) {
  Eigen::VectorXd away = Eigen::VectorXd::Zero(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const double half = 0.5 * (robot.upper()[i] - robot.lower()[i]);
    if (!std::isfinite(half) || !(half > 0.0)) continue;
    const double part = std::clamp((q[i] - robot.lower()[i]) / half - 1.0, -1.0, 1.0);
    away[i] = -most * part * part * part;
  }
  return away;
}

IkResult found(Eigen::VectorXd q) {
  IkResult result;
  result.status = IkStatus::kOk;
  result.q = std::move(q);
  return result;
}

Eigen::VectorXd joints_of(const Trajectory& motion, double x) {
  Eigen::VectorXd q(motion.n());
  for (int i = 0; i < motion.n(); ++i) q[i] = motion.value(i, x);
  return q;
}

// The slope at the first of four points: that of the cubic through them.
double slope_at_first(const double* x, const double* q) {
  double slope = 0.0;
  for (int k = 1; k < 4; ++k) {
    double weight = 1.0 / (x[k] - x[0]);
    for (int j = 1; j < 4; ++j) {
      if (j != k) weight *= (x[0] - x[j]) / (x[k] - x[j]);
    }
    slope += weight * (q[k] - q[0]);
  }
  return slope;
}

}  // namespace

LineSamples::LineSamples(const Robot& robot, const Eigen::VectorXd& q0, PoseCurve curve,
                         IkTask task, CurveLaw law)
    : robot_(robot), curve_(std::move(curve)), task_(task), law_(law), samples_{{0.0, q0}} {}

double LineSamples::covered(double x) const {
  return law_ != CurveLaw::kQuintic ? x : x * x * x * (10.0 + x * (-15.0 + 6.0 * x));
}

Eigen::Isometry3d LineSamples::pose_at(double x) const { return curve_.at(covered(x)); }

// How far the joints of a step may move on from q if the whole step begins at the seed: a fraction
// of the distance to their limits.
struct StepRoom {
  Eigen::VectorXd lower, upper;

  StepRoom(const Robot& robot, const Eigen::VectorXd& seed, const Eigen::VectorXd& q, double share)
      : lower(share * (robot.lower() - seed) + seed - q),
        upper(share * (robot.upper() - seed) + seed - q) {}
};

// The difference of two poses as a distance.
double distance_of(const Vector6d& error) {
  return error.head<3>().norm() + kRotationLengthOfDamping * error.tail<3>().norm();
}

// Newton's method from the solution before: the solution that the arm reaches continuously. Nothing
// if it does not converge at once, or only outside the limits.
std::optional<Eigen::VectorXd> LineSamples::slide(const Eigen::Isometry3d& T_world_tool,
                                                  const Eigen::VectorXd& seed, Slide how) const {
  Eigen::VectorXd q = seed;
  Jacobian J;
  double share = 1.0;
  for (int k = 0; k < kSlideSteps; ++k) {
    const Vector6d error = pose_error(forward_and_jacobian(robot_, q, J), T_world_tool);
    if (error.head<3>().norm() <= kSampleTolerance && error.tail<3>().norm() <= kSampleTolerance) {
      if (limit_violations(robot_, q).empty()) return q;
      return std::nullopt;
    }
    // The shortest step; for arms with fewer joints the one with the smallest error.
    if (robot_.n() > 6) {
      if (k == 0) share = how.share_of(distance_of(error));
      Eigen::VectorXd wished = Eigen::VectorXd::Zero(robot_.n());
      if (k == 0 && how.away) wished = distance_of(error) * away_from_limits(robot_, seed, away_);
      const StepRoom room(robot_, seed, q, share);
      const auto step = least_step({.W = Eigen::MatrixXd::Identity(robot_.n(), robot_.n()),
                                    .g = std::move(wished),
                                    .A = J,
                                    .b = error},
                                   room.lower, room.upper);
      if (!step) return std::nullopt;
      q += *step;
    } else if (robot_.n() == 6) {
      const Eigen::Matrix<double, 6, 6> square = J * J.transpose();
      q += J.transpose() * SymmetricFactors<6>(square).solve(error);
    } else {
      const Eigen::MatrixXd square = J.transpose() * J;
      q += SymmetricFactors<Eigen::Dynamic>(square).solve(J.transpose() * error);
    }
    if (!q.allFinite() || change(robot_, seed, q) > kLargestSlide) return std::nullopt;
  }
  return std::nullopt;
}

// Solves for a position only: of the joint values with the tool there, those with the smallest
// rotation of the tool from the solution before. Each step removes the position error to first
// order, with the smallest rotation.
std::optional<Eigen::VectorXd> LineSamples::slide_to_position(const Eigen::Vector3d& position,
                                                              const Eigen::VectorXd& seed,
                                                              Slide how) const {
  Eigen::Isometry3d T_world_wished = forward(robot_, seed);
  const double share = how.share_of((position - T_world_wished.translation()).norm());
  T_world_wished.translation() = position;
  Eigen::VectorXd q = seed;
  Jacobian J;
  bool settled = false;
  for (int k = 0; k < kSettleSteps; ++k) {
    const Vector6d error = pose_error(forward_and_jacobian(robot_, q, J), T_world_wished);
    if (settled && error.head<3>().norm() <= kSampleTolerance) {
      if (limit_violations(robot_, q).empty()) return q;
      return std::nullopt;
    }
    StepTask task{.W = J.bottomRows<3>().transpose() * J.bottomRows<3>(),
                  .g = J.bottomRows<3>().transpose() * error.tail<3>(),
                  .A = J.topRows<3>(),
                  .b = error.head<3>()};
    task.W.diagonal().array() += kRotationShare;
    const StepRoom room(robot_, seed, q, share);
    const auto step = least_step(task, room.lower, room.upper);
    if (!step) return std::nullopt;
    q += *step;
    if (!q.allFinite() || change(robot_, seed, q) > kLargestSlide) return std::nullopt;
    settled = step->cwiseAbs().maxCoeff() <= kSettled;
  }
  return std::nullopt;
}

std::optional<Eigen::VectorXd> LineSamples::slide_into(const Eigen::Isometry3d& T_world_tool,
                                                       const Eigen::VectorXd& seed,
                                                       Slide how) const {
  if (task_ == IkTask::kPose) return slide(T_world_tool, seed, how);
  if (task_ == IkTask::kPositionFirst)
    return slide_to_position(T_world_tool.translation(), seed, how);
  return std::nullopt;
}

bool LineSamples::has_choice() const { return robot_.n() > 6 || task_ == IkTask::kPositionFirst; }

std::optional<Eigen::VectorXd> LineSamples::slide_easily(const Eigen::Isometry3d& T_world_tool,
                                                         const Eigen::VectorXd& seed) const {
  for (const double approach : kApproach) {
    auto q = slide_into(T_world_tool, seed, {.approach = approach, .away = true});
    if (q || !has_choice()) return q;
  }
  return std::nullopt;
}

IkResult LineSamples::solve(double x, const Eigen::VectorXd& seed, bool respect_limits) const {
  checkpoint(1000);
  const Eigen::Isometry3d T_world_tool = pose_at(x);
  if (respect_limits) {
    auto q = slide_easily(T_world_tool, seed);
    if (!q && has_choice()) q = slide_into(T_world_tool, seed, {.away = true});
    if (q) return found(*std::move(q));
  }
  // Only the solution that the arm reaches continuously counts, so there is one start.
  return solve_ik(robot_, T_world_tool,
                  {.seed = seed,
                   .task = task_,
                   .choice = IkChoice::kFirst,
                   .position_tolerance = kSampleTolerance,
                   .rotation_tolerance = kSampleTolerance,
                   .starts = 1,
                   .respect_limits = respect_limits,
                   .diagnose = false});
}

// Stores why the line ends after the last sample; `ik` is the solver's answer for x.
bool LineSamples::fail(const Sample& last, double x, IkResult ik) {
  fault_ = {.kind = LineFaultKind::kJump,
            .fraction = covered(last.x),
            .T_world_tool = pose_at(x),
            .ik = std::move(ik)};
  if (fault_.ik.ok()) {
    change(robot_, last.q, fault_.ik.q, &fault_.joint);
    return false;
  }
  fault_.kind = LineFaultKind::kPath;
  fault_.ik = solve_ik(robot_, pose_at(x), {.seed = last.q, .task = task_});
  const IkResult further = solve(x, last.q, false);
  const auto outside = limit_violations(robot_, further.q);
  if (further.ok() && !outside.empty()) fault_.limit = outside.front();
  return false;
}

// Whether the joint direction up to x is about the same as before the last sample.
bool LineSamples::goes_on(double x, const Eigen::VectorXd& q) const {
  if (samples_.size() < 2) return true;
  const Sample &last = samples_.back(), &before = samples_[samples_.size() - 2];
  const double share = (x - last.x) / (last.x - before.x);
  return change(robot_, last.q + share * (last.q - before.q), q) <= kBend;
}

// Whether the direction of the curve after x is about the same as from the last sample to x.
bool LineSamples::is_straight(double x) const {
  const double h = x - samples_.back().x;
  if (x + h > 1.0) return true;
  const Eigen::Isometry3d T = pose_at(x);
  Vector6d in = pose_error(pose_at(x - h), T), out = pose_error(T, pose_at(x + h));
  in.tail<3>() *= kRotationLengthOfDamping;
  out.tail<3>() *= kRotationLengthOfDamping;
  return (out.normalized() - in.normalized()).norm() <= kTurn;
}

// Takes a step of a redundant arm only if neither the joints nor the curve change direction and no
// joint reaches its limit at once; shorter steps avoid these.
bool LineSamples::extend_easily(double x) {
  const Sample& last = samples_.back();
  if (!is_straight(x)) return false;
  auto q = slide_easily(pose_at(x), last.q);
  if (!q || change(robot_, last.q, *q) > 1.0 || !goes_on(x, *q)) return false;
  samples_.push_back({x, *std::move(q)});
  return true;
}

bool LineSamples::extend(double x, int halvings) {
  if (has_choice() && halvings > kHalvings - kEasyHalvings) {
    if (extend_easily(x)) return true;
    const double middle = 0.5 * (samples_.back().x + x);
    return extend(middle, halvings - 1) && extend(x, halvings - 1);
  }
  const Sample last = samples_.back();
  IkResult ik = solve(x, last.q);
  if (ik.ok() && change(robot_, last.q, ik.q) <= 1.0) {
    samples_.push_back({x, std::move(ik.q)});
    return true;
  }
  if (halvings == 0) return fail(last, x, std::move(ik));
  return extend(0.5 * (last.x + x), halvings - 1) && extend(x, halvings - 1);
}

int LineSamples::ways() const { return robot_.n() > 6 && task_ == IkTask::kPose ? kWays : 1; }

bool LineSamples::follow(int way) {
  for (; way < ways(); ++way) {
    away_ = kAway[static_cast<std::size_t>(way)];
    samples_.resize(1);
    if (follow_once()) return true;
  }
  return false;
}

bool LineSamples::follow_once() {
  for (int k = 1; k <= kFirstIntervals; ++k) {
    if (!extend(static_cast<double>(k) / kFirstIntervals, kHalvings)) return false;
  }
  return refine();
}

// Whether a joint curve exceeds a limit between two samples that keep it.
bool LineSamples::swings_out(const Trajectory& motion, const Sample& before,
                             const Sample& behind) const {
  for (const double part : {0.25, 0.5, 0.75}) {
    const double x = before.x + part * (behind.x - before.x);
    for (int i = 0; i < robot_.n(); ++i) {
      const double q = motion.value(i, x);
      const double upper = std::max({robot_.upper()[i], before.q[i], behind.q[i]});
      const double lower = std::min({robot_.lower()[i], before.q[i], behind.q[i]});
      if (q > upper + kSwing || q < lower - kSwing) return true;
    }
  }
  return false;
}

bool LineSamples::strays(const Trajectory& motion, double x) const {
  const Eigen::Isometry3d T_world_tool = forward(robot_, joints_of(motion, x));
  const Eigen::Isometry3d T_world_line = pose_at(x);
  const double aside = (T_world_tool.translation() - T_world_line.translation()).norm();
  const double share = law_ == CurveLaw::kGiven ? kGivenDeviates : 1.0;
  if (aside > share * kPositionDeviation) return true;
  const bool oriented = task_ == IkTask::kPose;
  return oriented && angle_between(T_world_tool, T_world_line) > share * kAngleDeviation;
}

// Adds samples in the middle of intervals where the joint curves leave the line.
bool LineSamples::refine() {
  constexpr std::size_t kMostSamples = kFirstIntervals * (std::size_t{1} << kHalvings) + 1;
  for (bool straying = true; straying;) {
    straying = false;
    const Trajectory curve = motion();
    std::vector<Sample> finer = {samples_.front()};
    for (std::size_t k = 1; k < samples_.size(); ++k) {
      const Sample& before = samples_[k - 1];
      const double x = 0.5 * (before.x + samples_[k].x);
      if (strays(curve, x) || swings_out(curve, before, samples_[k])) {
        // Solved near the joint curve, so that redundant joints continue in their direction: solved
        // from the sample before, they would deviate between two fixed samples.
        auto q = slide_into(pose_at(x), joints_of(curve, x), {});
        if (!q) {
          IkResult ik = solve(x, before.q);
          if (!ik.ok()) return fail(before, x, std::move(ik));
          q = std::move(ik.q);
        }
        if (finer.size() >= kMostSamples) return fail(before, x, found(*std::move(q)));
        finer.push_back({x, *std::move(q)});
        straying = true;
      }
      finer.push_back(samples_[k]);
    }
    samples_ = std::move(finer);
  }
  return true;
}

Trajectory LineSamples::motion() const {
  std::vector<double> x;
  for (const Sample& sample : samples_) x.push_back(sample.x);
  const std::size_t last = samples_.size() - 1;  // there are more than kFirstIntervals
  std::vector<JointPath> joints;
  for (int i = 0; i < robot_.n(); ++i) {
    std::vector<double> q;
    for (const Sample& sample : samples_) q.push_back(sample.q[i]);
    if (law_ == CurveLaw::kQuintic) {
      // Zero acceleration at both ends, and continuous jerk.
      joints.push_back({.segments = quintic_spline(x, q), .q_end = q.back()});
      continue;
    }
    double v_start = 0.0, v_end = 0.0;
    if (law_ == CurveLaw::kEven) {
      v_start = slope_at_first(x.data(), q.data());
      const std::array<double, 4> x_end = {x[last], x[last - 1], x[last - 2], x[last - 3]};
      const std::array<double, 4> q_end = {q[last], q[last - 1], q[last - 2], q[last - 3]};
      v_end = slope_at_first(x_end.data(), q_end.data());
    }
    joints.push_back({.segments = cubic_spline(x, q, v_start, v_end), .q_end = q.back()});
  }
  return {std::move(joints), 1.0};
}

}  // namespace armlet
