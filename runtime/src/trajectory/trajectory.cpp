#include "armlet/trajectory/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/profile.hpp"
#include "trajectory/roots.hpp"
#include "trajectory/sample_table.hpp"

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

// Leaves nothing behind the degree of a piece and nothing after the end of the motion.
void settle_path(JointPath& path, double duration) {
  for (Segment& piece : path.segments) {
    std::fill(piece.c.begin() + piece.degree + 1, piece.c.end(), 0.0);
  }
  if (path.segments.empty()) return;
  Segment& last = path.segments.back();
  // A rounding error must not keep the joint from its last position at the end.
  if (last.end() > duration) last.duration = std::max(duration - last.start, 1e-300);
}

// The piece that holds at time t, 0 <= t <= end of the path.
const Segment& piece_at(const JointPath& path, double t) {
  const auto after = std::ranges::upper_bound(path.segments, t, {}, &Segment::start);
  return after == path.segments.begin() ? *after : *(after - 1);
}

// Bounds of the derivative of this order over the whole piece: the smallest and the largest of its
// Bernstein coefficients. Exact where it is of degree 1 at most.
//
// source  G. Farin, Curves and Surfaces for CAGD, 2002, chapter 5 (the convex hull, and other
//         bases).
struct Bounds {
  double lower, upper;
};
Bounds bounds(const Segment& piece, int order) {
  const int m = piece.degree - order;
  if (m < 0) return {0.0, 0.0};
  std::array<double, Segment::kMaxDegree + 1> b{};
  double power = 1.0;
  for (int k = 0; k <= m; ++k) {
    double factor = power;
    for (int j = 0; j < order; ++j) factor *= k + order - j;
    // Divided by the binomial coefficient (m over k): a scaled Bernstein polynomial.
    double binomial = 1.0;
    for (int j = 0; j < k; ++j) binomial = binomial * (m - j) / (j + 1);
    b[static_cast<size_t>(k)] = factor * piece.c[static_cast<size_t>(k + order)] / binomial;
    power *= piece.duration;
  }
  // m rounds of sums of neighbours convert them into the Bernstein coefficients.
  for (int round = 1; round <= m; ++round) {
    for (int k = m; k >= round; --k) b[static_cast<size_t>(k)] += b[static_cast<size_t>(k - 1)];
  }
  const auto [lower, upper] = std::minmax_element(b.begin(), b.begin() + m + 1);
  return {*lower, *upper};
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
  for (int i = 0; i < n(); ++i) {
    JointPath& path = joints_[static_cast<std::size_t>(i)];
    check_path(path, i, duration);
    settle_path(path, duration);
  }
  table_ = std::make_shared<const SampleTable>(joints_, duration);
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
  for (const auto& [name, size] :
       {std::pair("q", q.size()), std::pair("qd", qd.size()), std::pair("qdd", qdd.size())}) {
    if (size != n()) check_size(name, size, n());
  }
  if (table_) table_->sample(joints_, t, {q.data(), qd.data(), qdd.data()});
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
    const Bounds bound = bounds(piece, order);
    if (std::max(-bound.lower, bound.upper) <= largest) continue;
    largest = std::max(
        {largest, std::abs(piece.value(0.0, order)), std::abs(piece.value(piece.duration, order))});
    if (piece.degree - order <= 1) continue;
    for (const double u : sign_changes(piece, order + 1)) {
      largest = std::max(largest, std::abs(piece.value(u, order)));
    }
  }
  return largest;
}

Trajectory::Range Trajectory::range(int i) const {
  Range range{joint(i).q_end, joint(i).q_end};
  const auto include = [&](double q) {
    range.lower = std::min(range.lower, q);
    range.upper = std::max(range.upper, q);
  };
  for (const Segment& piece : joint(i).segments) {
    include(piece.c[0]);
    const Bounds bound = bounds(piece, 0);
    if (bound.lower >= range.lower && bound.upper <= range.upper) continue;
    for (const double u : sign_changes(piece, 1)) include(piece.value(u));
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
      throw ArgumentError(
          fmt::format("Joint {} ends at {:.6g} and would go on from {:.6g}, {:.2g} away (SI); a "
                      "motion continues where the one "
                      "before it ended.",
                      i + 1, path.q_end, there, std::abs(there - path.q_end)));
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

int Trajectory::continuity(int i, double tolerance, Start start) const {
  const JointPath& path = joint(i);
  for (int order = 0; order <= Segment::kMaxDegree; ++order) {
    const double allowed = tolerance * std::max(peak(i, order), order == 0 ? 1.0 : 0.0);
    const bool at_rest = order > 0 && start == Start::kAtRest;
    double before = at_rest ? 0.0 : value(i, 0.0, order);
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
