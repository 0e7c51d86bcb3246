#include "armlet/trajectory/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

// Index of the last start that is not after t, 0 if all are.
std::size_t last_not_after(const double* starts, std::size_t count, double t) {
  constexpr std::size_t kFew = 16;
  if (count > kFew) {
    return static_cast<std::size_t>(std::upper_bound(starts + 1, starts + count, t) - starts) - 1;
  }
  std::size_t behind = 0;  // counting all needs no branch that could be guessed wrong
  for (std::size_t k = 1; k < count; ++k) behind += starts[k] <= t ? 1 : 0;
  return behind;
}

// The piece that holds at time t, 0 <= t <= end of the path.
const Segment& piece_at(const JointPath& path, double t) {
  const auto after = std::ranges::upper_bound(path.segments, t, {}, &Segment::start);
  return after == path.segments.begin() ? *after : *(after - 1);
}

struct Sample {
  double p, v, half_a;
};

// One pass gives the value and, from its partial sums, both derivatives. The first two steps leave
// out what would be added to zero.
template <int kDegree>
Sample horner(const Segment& piece, double u) {
  static_assert(kDegree >= 2);
  const auto& c = piece.c;
  Sample s{c[kDegree] * u + c[kDegree - 1], c[kDegree], c[kDegree]};
  s.v = s.v * u + s.p;
  s.p = s.p * u + c[kDegree - 2];
  for (int k = kDegree - 3; k >= 0; --k) {
    s.half_a = s.half_a * u + s.v;
    s.v = s.v * u + s.p;
    s.p = s.p * u + c[static_cast<size_t>(k)];
  }
  return s;
}

Sample sample_piece(const Segment& piece, double u) {
  switch (piece.degree) {
    case 3:
      return horner<3>(piece, u);
    case 4:
      return horner<4>(piece, u);
    case 5:
      return horner<5>(piece, u);
    case 6:
      return horner<6>(piece, u);
    case 7:
      return horner<7>(piece, u);
    default:
      return horner<2>(piece, u);
  }
}

// Bounds of the derivative of this order over the whole piece: the smallest and the largest of its
// Bernstein coefficients. Exact where it is of degree 1 at most.
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
  // Sums of neighbours, m times, turn them into the Bernstein coefficients.
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
  std::size_t pieces = 0;
  for (int i = 0; i < n(); ++i) {
    check_path(joint(i), i, duration);
    pieces += joint(i).segments.size();
  }
  index_pieces(pieces);
}

// Starts of all pieces, joint by joint, and whether they are the same for all joints.
void Trajectory::index_pieces(std::size_t pieces) {
  starts_.reserve(pieces);
  first_.reserve(joints_.size());
  ends_.reserve(joints_.size());
  shared_ = true;
  for (JointPath& path : joints_) {
    first_.push_back(starts_.size());
    for (const Segment& piece : path.segments) starts_.push_back(piece.start);
    double end = -1.0;
    if (!path.segments.empty()) {
      Segment& last = path.segments.back();
      // A rounding error must not keep the joint from its last position at the end.
      if (last.end() > duration_) last.duration = std::max(duration_ - last.start, 1e-300);
      end = std::min(last.end(), duration_);
    }
    ends_.push_back(end);
    first_end_ = ends_.size() == 1 ? end : std::min(first_end_, end);
    const std::size_t count = path.segments.size();
    shared_ = shared_ && count == joints_.front().segments.size() &&
              std::equal(starts_.begin(), starts_.begin() + static_cast<std::ptrdiff_t>(count),
                         starts_.end() - static_cast<std::ptrdiff_t>(count));
  }
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
  std::size_t k = 0;
  if (shared_ && !joints_.empty()) {
    k = last_not_after(starts_.data(), starts_.size() / joints_.size(), t);
    if (t >= 0.0 && t < first_end_) {
      // All joints move, each in its piece k.
      const double u = t - starts_[k];
      for (std::size_t i = 0; i < joints_.size(); ++i) {
        const Sample sample = sample_piece(joints_[i].segments[k], u);
        const auto at = static_cast<Eigen::Index>(i);
        q[at] = sample.p;
        qd[at] = sample.v;
        qdd[at] = 2.0 * sample.half_a;
      }
      return;
    }
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointPath& path = joints_[i];
    const auto at = static_cast<Eigen::Index>(i);
    // Where there are no pieces the end lies before 0.
    if (!(t >= 0.0 && t <= ends_[i])) {
      q[at] = value_of(path, t, 0);
      qd[at] = qdd[at] = 0.0;
      continue;
    }
    if (!shared_) k = last_not_after(starts_.data() + first_[i], path.segments.size(), t);
    const Segment& piece = path.segments[k];
    const Sample sample = sample_piece(piece, std::min(t - piece.start, piece.duration));
    q[at] = t >= ends_[i] ? path.q_end : sample.p;
    qd[at] = sample.v;
    qdd[at] = 2.0 * sample.half_a;
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
