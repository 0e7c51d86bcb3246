#include "armlet/cell/motion.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/cell/clock.hpp"
#include "trajectory/planners/ramp.hpp"

namespace armlet {
namespace {

constexpr double kSlack = 1e-9;     // relative, of an acceleration or a jerk
constexpr double kSameTime = 1e-9;  // s, resolution of the clock
// Between the sampled positions of a deceleration the true values may be a little larger.
constexpr double kAllowed = 0.998;  // of a limit
constexpr double kAimedAt = 0.997;

double duration_of(const auto& pieces) { return pieces.back().t + pieces.back().duration; }

}  // namespace

Motion::Motion(Trajectory trajectory, std::int64_t start_ns)
    : trajectory_(std::move(trajectory)),
      start_ns_(start_ns),
      end_ns_(start_ns + to_ns(trajectory_.duration())),
      u_end_(trajectory_.duration()) {}

Motion Motion::stopping(Trajectory trajectory, std::int64_t start_ns) {
  Motion motion(std::move(trajectory), start_ns);
  motion.stop_ns_ = start_ns;
  return motion;
}

bool Motion::stands_at(double u) const {
  for (int i = 0; i < trajectory_.n(); ++i) {
    if (trajectory_.value(i, u, 1) != 0.0) return false;
  }
  return true;
}

Motion::Piece Motion::Piece::next(double next_bend, double next_duration) const {
  return {.t = t + duration,
          .u = u_at(duration),
          .rate = rate_at(duration),
          .slope = slope_at(duration),
          .bend = next_bend,
          .duration = next_duration};
}

// A joint has the acceleration q'' rate^2 + q' slope and the jerk
// q''' rate^3 + 3 q'' rate slope + q' bend.
bool Motion::allows(double u, const Piece& piece, double dt, const Limits& limits) const {
  const double rate = piece.rate_at(dt), slope = piece.slope_at(dt);
  for (int i = 0; i < trajectory_.n(); ++i) {
    const double speed = trajectory_.value(i, u, 1);
    const double own_accel = trajectory_.value(i, u, 2);
    const double own_jerk = trajectory_.value(i, u, 3);
    const double accel = own_accel * rate * rate + speed * slope;
    const double jerk =
        own_jerk * rate * rate * rate + 3.0 * own_accel * rate * slope + speed * piece.bend;
    const double most = std::max(kAllowed * limits.accel[i], std::abs(own_accel));
    const double most_jerk = std::max(kAllowed * limits.jerk[i], std::abs(own_jerk));
    if (!(std::abs(accel) <= most * (1.0 + kSlack))) return false;
    if (!(std::abs(jerk) <= most_jerk * (1.0 + kSlack))) return false;
  }
  return true;
}

// Samples evenly, and on both sides of the knots of the trajectory.
bool Motion::fits(const std::vector<Piece>& pieces, const std::vector<double>& knots,
                  const Limits& limits) const {
  constexpr int kSamples = 32;  // of a piece
  constexpr int kHalvings = 40;
  for (const Piece& piece : pieces) {
    if (piece.rate == 1.0 && piece.slope == 0.0 && piece.bend == 0.0) continue;
    for (int k = 0; k <= kSamples; ++k) {
      const double dt = piece.duration * k / kSamples;
      if (!allows(piece.u_at(dt), piece, dt, limits)) return false;
    }
    const double last = piece.u_at(piece.duration);
    for (auto knot = std::ranges::upper_bound(knots, piece.u); knot != knots.end() && *knot < last;
         ++knot) {
      double before = 0.0, after = piece.duration;
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (before + after);
        (piece.u_at(middle) < *knot ? before : after) = middle;
      }
      for (const double side : {-kSameTime, kSameTime})
        if (!allows(*knot + side, piece, after, limits)) return false;
    }
  }
  return true;
}

// The shortest deceleration found that begins `delay` seconds after path time u and lasts less than
// `longest` in all; empty if there is none.
std::vector<Motion::Piece> Motion::brake(double u, double delay, double longest,
                                         const std::vector<double>& knots,
                                         const Limits& limits) const {
  constexpr double kSlower = 1.15;
  constexpr int kHalvings = 5;
  constexpr double kMostBend = 1e4;  // times the slope, 1/s
  const Piece free{.t = 0.0, .u = u, .rate = 1.0, .slope = 0.0, .bend = 0.0, .duration = delay};
  if (stands_at(u + delay)) return {free};
  double flattest = 0.0, straightest = 0.0;  // inverses of the largest that the joints allow
  for (int i = 0; i < trajectory_.n(); ++i) {
    const double speed = std::abs(trajectory_.value(i, u + delay, 1)) / kAimedAt;
    flattest = std::max(flattest, speed / limits.accel[i]);
    straightest = std::max(straightest, speed / limits.jerk[i]);
  }
  const double slope = 1.0 / flattest;
  const double bend = std::min(1.0 / straightest, kMostBend * slope);
  const Ramp quickest = make_ramp(1.0, 0.0, 0.0, slope, bend);
  const auto slower = [&](double factor) {
    const double most = quickest.jerk / (factor * factor);
    std::vector<Piece> pieces = {free};
    pieces.push_back(pieces.back().next(most, quickest.rise * factor));
    pieces.push_back(pieces.back().next(0.0, quickest.hold * factor));
    pieces.push_back(pieces.back().next(-most, quickest.fall * factor));
    return pieces;
  };
  double too_quick = 0.0, factor = 1.0;
  for (;; too_quick = factor, factor *= kSlower) {
    const std::vector<Piece> pieces = slower(factor);
    if (duration_of(pieces) >= longest) return {};
    const double end = pieces.back().u_at(pieces.back().duration);
    if (end < trajectory_.duration() - kSameTime && fits(pieces, knots, limits)) break;
  }
  for (int k = 0; k < kHalvings && too_quick > 0.0; ++k) {
    const double middle = 0.5 * (too_quick + factor);
    (fits(slower(middle), knots, limits) ? factor : too_quick) = middle;
  }
  return slower(factor);
}

void Motion::stop(std::int64_t t_ns, const Eigen::VectorXd& max_accel,
                  const Eigen::VectorXd& max_jerk) {
  if (stop_ns_ != kNever || t_ns >= end_ns_) return;
  stop_ns_ = t_ns;
  const double u = to_seconds(t_ns - start_ns_);
  if (stands_at(u)) {
    end_ns_ = t_ns;
    u_end_ = u;
    return;
  }
  Limits limits{.accel = max_accel, .jerk = max_jerk};
  for (int i = 0; i < trajectory_.n(); ++i) {
    limits.accel[i] = std::max(limits.accel[i], trajectory_.peak(i, 2));
    limits.jerk[i] = std::max(limits.jerk[i], trajectory_.peak(i, 3));
  }
  // A deceleration may begin at the knots of the trajectory, and evenly spaced in between.
  constexpr int kDelays = 16;
  const std::vector<double> knots = trajectory_.knots();
  double longest = trajectory_.duration() - u;
  std::vector<double> delays;
  for (int k = 0; k < kDelays; ++k) delays.push_back(longest * k / kDelays);
  for (const double knot : knots) {
    if (knot > u + kSameTime) delays.push_back(knot - u);
  }
  std::ranges::sort(delays);
  for (const double delay : delays) {
    if (delay >= longest - kSameTime) break;
    auto pieces = brake(u, delay, longest, knots, limits);
    if (pieces.empty()) continue;
    slowing_ = std::move(pieces);
    longest = duration_of(slowing_);
  }
  if (slowing_.empty()) return;  // reaching the end is as fast as stopping
  end_ns_ = t_ns + to_ns(longest);
  u_end_ = slowing_.back().u_at(slowing_.back().duration);
}

void Motion::sample(std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd,
                    Eigen::VectorXd& qdd) const {
  if (t_ns >= end_ns_) {
    trajectory_.sample(u_end_, q, qd, qdd);
    qd.setZero();
    qdd.setZero();
  } else if (slowing_.empty() || t_ns <= stop_ns_) {
    trajectory_.sample(to_seconds(t_ns - start_ns_), q, qd, qdd);
  } else {
    const double t = to_seconds(t_ns - stop_ns_);
    const auto behind = std::ranges::upper_bound(slowing_, t, {}, &Piece::t);
    const Piece& piece = *(behind - 1);
    const double dt = std::min(t - piece.t, piece.duration);
    const double rate = piece.rate_at(dt);
    trajectory_.sample(piece.u_at(dt), q, qd, qdd);
    qdd = qdd * (rate * rate) + qd * piece.slope_at(dt);
    qd *= rate;
  }
}

}  // namespace armlet
