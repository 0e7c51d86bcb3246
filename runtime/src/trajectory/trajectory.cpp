#include "armlet/trajectory/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/profile.hpp"
#include "trajectory/roots.hpp"

namespace armlet {
namespace {

constexpr double kTimeTolerance = 1e-9;  // s, one tick of the clock

void check_path(const JointPath& path, int joint, double duration) {
  double t = 0.0;
  for (const Segment& piece : path.segments) {
    const bool finite = std::ranges::all_of(piece.c, [](double c) { return std::isfinite(c); }) &&
                        piece.degree >= 0 && piece.degree <= Segment::kMaxDegree;
    if (!finite) {
      throw ArgumentError(
          fmt::format("The polynomial of joint {} at t = {} s is not finite.", joint + 1, t));
    }
    if (!(piece.duration > 0.0) || !(std::abs(piece.start - t) <= kTimeTolerance)) {
      throw ArgumentError(
          fmt::format("A piece of joint {} starts at {} s and lasts {} s; expected a start at {} s "
                      "and a positive duration.",
                      joint + 1, piece.start, piece.duration, t));
    }
    t = piece.end();
  }
  if (!(t <= duration + kTimeTolerance)) {
    throw ArgumentError(fmt::format(
        "Joint {} moves until {} s, longer than the whole motion ({} s).", joint + 1, t, duration));
  }
  if (!std::isfinite(path.q_end)) {
    throw ArgumentError(fmt::format("The last position of joint {} is not finite.", joint + 1));
  }
}

// The piece that holds at time t, 0 <= t <= end of the path.
const Segment& piece_at(const JointPath& path, double t) {
  const auto after = std::ranges::upper_bound(path.segments, t, {}, &Segment::start);
  return after == path.segments.begin() ? *after : *(after - 1);
}

double value_of(const JointPath& path, double t, int order) {
  if (path.segments.empty()) return order == 0 ? path.q_end : 0.0;
  const double end = path.segments.back().end();
  if (t >= end && order == 0) return path.q_end;
  if (t < 0.0 || t > end) return order == 0 ? path.segments.front().c[0] : 0.0;
  const Segment& piece = piece_at(path, t);
  return piece.value(std::min(t - piece.start, piece.duration), order);
}

}  // namespace

double Segment::value(double u, int order) const {
  double sum = 0.0;
  for (int k = degree; k >= order; --k) {
    double factor = 1.0;
    for (int j = 0; j < order; ++j) factor *= k - j;
    sum = sum * u + factor * c[static_cast<size_t>(k)];
  }
  return sum;
}

Trajectory::Trajectory(std::vector<JointPath> joints, double duration)
    : joints_(std::move(joints)), duration_(duration) {
  if (!std::isfinite(duration) || duration < 0.0) {
    throw ArgumentError(
        fmt::format("A motion of {} s cannot be made; expected 0 s or more.", duration));
  }
  for (int i = 0; i < n(); ++i) check_path(joint(i), i, duration);
}

Trajectory Trajectory::at_rest(const Eigen::VectorXd& q, double duration) {
  std::vector<JointPath> joints;
  for (const double q_i : q) joints.push_back({.q_end = q_i});
  return {std::move(joints), duration};
}

Eigen::VectorXd Trajectory::start() const {
  Eigen::VectorXd q(n());
  for (int i = 0; i < n(); ++i) q[i] = value(i, 0.0);
  return q;
}

Eigen::VectorXd Trajectory::end() const {
  Eigen::VectorXd q(n());
  for (int i = 0; i < n(); ++i) q[i] = joint(i).q_end;
  return q;
}

void Trajectory::sample(double t, Eigen::Ref<Eigen::VectorXd> q, Eigen::Ref<Eigen::VectorXd> qd,
                        Eigen::Ref<Eigen::VectorXd> qdd) const {
  for (int i = 0; i < n(); ++i) {
    const JointPath& path = joint(i);
    const bool moving = !path.segments.empty() && t >= 0.0 && t <= path.segments.back().end();
    if (!moving) {
      q[i] = value_of(path, t, 0);
      qd[i] = qdd[i] = 0.0;
      continue;
    }
    // One pass gives the value and, from its partial sums, both derivatives.
    const Segment& piece = piece_at(path, t);
    const double u = std::min(t - piece.start, piece.duration);
    double p = 0.0, v = 0.0, half_a = 0.0;
    for (int k = piece.degree; k >= 0; --k) {
      half_a = half_a * u + v;
      v = v * u + p;
      p = p * u + piece.c[static_cast<size_t>(k)];
    }
    q[i] = t >= path.segments.back().end() ? path.q_end : p;
    qd[i] = v;
    qdd[i] = 2.0 * half_a;
  }
}

double Trajectory::value(int i, double t, int order) const { return value_of(joint(i), t, order); }

std::vector<double> Trajectory::knots() const {
  std::vector<double> t = {0.0, duration_};
  for (const JointPath& path : joints_) {
    for (const Segment& piece : path.segments) t.push_back(piece.end());
  }
  std::ranges::sort(t);
  // Knots of different joints that differ by rounding are one knot; the exact last one is kept.
  std::vector<double> distinct;
  for (const double knot : t) {
    if (distinct.empty() || knot - distinct.back() > kTimeTolerance) distinct.push_back(knot);
  }
  if (duration_ > 0.0) distinct.back() = duration_;
  return distinct;
}

double Trajectory::peak(int i, int order) const {
  double largest = 0.0;
  for (const Segment& piece : joint(i).segments) {
    std::vector<double> candidates = sign_changes(piece, order + 1);
    candidates.push_back(0.0);
    candidates.push_back(piece.duration);
    for (const double u : candidates) largest = std::max(largest, std::abs(piece.value(u, order)));
  }
  return largest;
}

Trajectory::Range Trajectory::range(int i) const {
  Range range{joint(i).q_end, joint(i).q_end};
  for (const Segment& piece : joint(i).segments) {
    std::vector<double> candidates = sign_changes(piece, 1);
    candidates.push_back(0.0);
    for (const double u : candidates) {
      range.lower = std::min(range.lower, piece.value(u));
      range.upper = std::max(range.upper, piece.value(u));
    }
  }
  return range;
}

Trajectory Trajectory::stretched(double factor) const {
  if (!std::isfinite(factor) || !(factor > 0.0)) {
    throw ArgumentError(
        fmt::format("A motion cannot be stretched by {}; expected more than 0.", factor));
  }
  std::vector<JointPath> joints = joints_;
  for (JointPath& path : joints) {
    for (Segment& piece : path.segments) {
      piece.start *= factor;
      piece.duration *= factor;
      double scale = 1.0;
      for (double& c : piece.c) {
        c *= scale;
        scale /= factor;
      }
    }
  }
  return {std::move(joints), duration_ * factor};
}

namespace {

// A joint that arrives early waits in a piece of its own.
void wait_until(JointPath& path, double T) {
  const double end = path.segments.empty() ? 0.0 : path.segments.back().end();
  if (T - end <= kTimeTolerance) return;
  path.segments.push_back({.start = end, .duration = T - end, .degree = 0, .c = {path.q_end}});
}

}  // namespace

Trajectory Trajectory::then(const Trajectory& next) const {
  check_size("next", next.n(), n());
  std::vector<JointPath> joints = joints_;
  for (int i = 0; i < n(); ++i) {
    JointPath& path = joints[static_cast<size_t>(i)];
    const double there = next.value(i, 0.0);
    if (!(std::abs(there - path.q_end) <= 1e-9)) {
      throw ArgumentError(fmt::format(
          "Joint {} ends at {} and would go on from {}; a motion continues where the one before "
          "it ended.",
          i + 1, path.q_end, there));
    }
    if (!next.joint(i).segments.empty()) wait_until(path, duration_);
    for (Segment piece : next.joint(i).segments) {
      piece.start += duration_;
      path.segments.push_back(piece);
    }
    path.q_end = next.joint(i).q_end;
  }
  return {std::move(joints), duration_ + next.duration_};
}

Trajectory Trajectory::reversed() const {
  std::vector<JointPath> joints;
  for (const JointPath& path : joints_) {
    JointPath forth = path;
    if (!forth.segments.empty()) wait_until(forth, duration_);
    JointPath back{.q_end = forth.segments.empty() ? forth.q_end : forth.segments.front().c[0]};
    double start = 0.0;
    for (auto piece = forth.segments.rbegin(); piece != forth.segments.rend(); ++piece) {
      back.segments.push_back(armlet::reversed(*piece, start));
      start += piece->duration;
    }
    joints.push_back(std::move(back));
  }
  return {std::move(joints), duration_};
}

int Trajectory::continuity(int i, double tolerance) const {
  const JointPath& path = joint(i);
  for (int order = 0; order <= Segment::kMaxDegree; ++order) {
    const double allowed = tolerance * std::max(peak(i, order), order == 0 ? 1.0 : 0.0);
    // Standing still before and after.
    double before = order == 0 ? value(i, 0.0) : 0.0;
    for (const Segment& piece : path.segments) {
      if (std::abs(piece.value(0.0, order) - before) > allowed) return order - 1;
      before = piece.value(piece.duration, order);
    }
    const double last = order == 0 ? path.q_end : 0.0;
    if (std::abs(last - before) > allowed) return order - 1;
  }
  return Segment::kMaxDegree;
}

}  // namespace armlet
