#include "armlet/trajectory/time_optimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/trajectory/spline.hpp"

namespace armlet {
namespace {

constexpr double kNoSlope = 1e-12;  // |q'| below it: the joint does not restrict the acceleration
constexpr double kSamePlace = 1e-12;
constexpr double kSameKnot = 1e-9;  // as in Trajectory::knots

void check_path(const Trajectory& path, std::span<const AxisLimits> limits, int intervals) {
  check_size("limits", static_cast<Eigen::Index>(limits.size()), path.n());
  for (const AxisLimits& l : limits) {
    check_positive("speed limit", l.speed);
    check_positive("acceleration limit", l.acceleration);
  }
  if (intervals < 1) {
    throw ArgumentError(fmt::format("A path of {} intervals; expected at least 1.", intervals));
  }
  if (!(path.duration() > 0.0)) throw ArgumentError("A path without length cannot be run.");
  for (int i = 0; i < path.n(); ++i) {
    for (const Segment& piece : path.joint(i).segments) {
      if (piece.degree <= 3) continue;
      throw ArgumentError(fmt::format("The path of joint {} has degree {}; expected at most 3.",
                                      i + 1, piece.degree));
    }
  }
}

// The piece that begins at a place or goes on behind it; knots of different joints that differ by
// rounding are one place. `piece` is one before.
std::size_t piece_behind(const std::vector<Segment>& pieces, std::size_t piece, double s) {
  while (piece + 1 < pieces.size() && pieces[piece + 1].start <= s + kSameKnot) ++piece;
  return piece;
}

// Places along the path: its knots, and enough in between.
std::vector<double> places(const Trajectory& path, int intervals) {
  const std::vector<double> knots = path.knots();
  const double widest = path.duration() / intervals;
  std::vector<double> s = {0.0};
  s.reserve(static_cast<std::size_t>(intervals) + knots.size() + 1);
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double length = knots[k + 1] - knots[k];
    const int parts = std::max(1, static_cast<int>(std::ceil(length / widest - 1e-9)));
    for (int j = 1; j < parts; ++j) s.push_back(knots[k] + length * j / parts);
    s.push_back(knots[k + 1]);
  }
  return s;
}

// The accelerations u along the path that the joints allow at squared speed x:
// -alpha - beta x <= u <= alpha - beta x for every row.
struct Strips {
  std::vector<double> alpha, beta;
  double x_most = 0.0;  // of the speed limits, and of joints that only curve
};

class Grid {
 public:
  Grid(const Trajectory& path, std::span<const AxisLimits> limits, int intervals,
       std::span<const SpeedZone> zones)
      : s_(places(path, intervals)), limits_(limits), zones_(zones), n_(limits.size()) {
    const std::size_t count = s_.size();
    first_.resize(count * n_);
    second_.resize(count * n_);
    for (std::size_t i = 0; i < n_; ++i) fill_joint(path.joint(static_cast<int>(i)), i);
    strips_.alpha.resize(2 * n_ + zones.size());
    strips_.beta.resize(2 * n_ + zones.size());
    bound_.resize(count);
    for (std::size_t k = 0; k < count; ++k) bound_[k] = speed_bound(k);
  }

  [[nodiscard]] const std::vector<double>& s() const { return s_; }

  // The highest squared speed of the speed limits at a place, where zones meet that of both.
  [[nodiscard]] double speed_bound(std::size_t k) const {
    double least = std::sqrt(kUnbounded);
    for (const SpeedZone& zone : zones_) {
      const bool inside = s_[k] >= zone.from - kSamePlace && s_[k] <= zone.to + kSamePlace;
      if (inside) least = std::min(least, zone.speed);
    }
    for (std::size_t i = 0; i < n_; ++i) {
      const double slope = std::abs(first_[k * n_ + i]);
      if (slope * least > limits_[i].speed) least = limits_[i].speed / slope;
    }
    return least * least;
  }

  // What holds between place k and the next: the limits at k, and those at k + 1 with the speed
  // reached there.
  const Strips& between(std::size_t k) {
    checkpoint(40 * n_);
    const double twice = 2.0 * (s_[k + 1] - s_[k]);
    rows_ = 0;
    strips_.x_most = bound_[k];
    for (std::size_t i = 0; i < n_; ++i) {
      const double A = limits_[i].acceleration;
      add(first_[k * n_ + i], second_[k * n_ + i], A);
      const double curve = second_[(k + 1) * n_ + i];
      add(first_[(k + 1) * n_ + i] + twice * curve, curve, A);
    }
    for (const SpeedZone& zone : zones_) {
      const bool overlaps = s_[k + 1] > zone.from + kSamePlace && s_[k] < zone.to - kSamePlace;
      if (overlaps && std::isfinite(zone.acceleration)) add(1.0, 0.0, zone.acceleration);
    }
    return strips_;
  }

  // The u between all strips at x: the lowest upper and highest lower bound.
  struct Range {
    double lower, upper;
    std::size_t lower_row, upper_row;
  };
  [[nodiscard]] Range range(double x) const {
    Range r{-kUnbounded, kUnbounded, 0, 0};
    for (std::size_t row = 0; row < rows_; ++row) {
      const double middle = -strips_.beta[row] * x;
      const double upper = middle + strips_.alpha[row];
      const double lower = middle - strips_.alpha[row];
      if (upper < r.upper) {
        r.upper = upper;
        r.upper_row = row;
      }
      if (lower > r.lower) {
        r.lower = lower;
        r.lower_row = row;
      }
    }
    return r;
  }

  static constexpr double kUnbounded = 1e100;

 private:
  void fill_joint(const JointPath& path, std::size_t i) {
    std::size_t piece = 0;
    for (std::size_t k = 0; k < s_.size(); ++k) {
      double first = 0.0, second = 0.0;
      if (!path.segments.empty()) {
        piece = piece_behind(path.segments, piece, s_[k]);
        const Segment& p = path.segments[piece];
        const double u = s_[k] - p.start;
        first = p.c[1] + u * (2.0 * p.c[2] + u * 3.0 * p.c[3]);
        second = 2.0 * p.c[2] + 6.0 * u * p.c[3];
      }
      first_[k * n_ + i] = first;
      second_[k * n_ + i] = second;
    }
  }

  // |a u + b x| <= A.
  void add(double a, double b, double A) {
    const double slope = std::abs(a);
    if (slope < kNoSlope) {
      if (std::abs(b) * strips_.x_most > A) strips_.x_most = A / std::abs(b);
      return;
    }
    strips_.alpha[rows_] = A / slope;
    strips_.beta[rows_] = b / a;
    ++rows_;
  }

  std::vector<double> s_;
  std::span<const AxisLimits> limits_;
  std::span<const SpeedZone> zones_;
  std::size_t n_;
  std::vector<double> first_, second_;  // by place, then by joint
  std::vector<double> bound_;           // squared speed
  Strips strips_;
  std::size_t rows_ = 0;
};

// How much room the bounds leave for u at the start of an interval, so that the squared speed at
// its end lies between 0 and `next`: a concave function of x, and how it changes.
struct Room {
  double room, slope, scale;

  [[nodiscard]] bool is_there() const { return room >= -1e-12 * scale; }
};

Room room_at(const Grid& grid, const Strips& strips, double x, double next, double twice) {
  auto r = grid.range(x);
  double upper = r.upper, upper_slope = -strips.beta[r.upper_row];
  double lower = r.lower, lower_slope = -strips.beta[r.lower_row];
  if (r.upper == Grid::kUnbounded) upper_slope = lower_slope = 0.0;
  if (const double most = (next - x) / twice; most < upper) {
    upper = most;
    upper_slope = -1.0 / twice;
  }
  if (const double least = -x / twice; least > lower) {
    lower = least;
    lower_slope = -1.0 / twice;
  }
  return {upper - lower, upper_slope - lower_slope, std::abs(upper) + std::abs(lower)};
}

// The same by halving, for bounds so far apart in size that Newton's method steps past the zero.
double highest_by_halving(const Grid& grid, const Strips& strips, double next, double twice) {
  double low = 0.0, high = std::max(next, 1e-12);
  while (high < strips.x_most && room_at(grid, strips, high, next, twice).is_there()) {
    low = high;
    high *= 4.0;
  }
  high = std::min(high, strips.x_most);
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (room_at(grid, strips, middle, next, twice).is_there() ? low : high) = middle;
  }
  return low;
}

// The highest squared speed at the start of an interval from which a squared speed of at most
// `next` can be reached at its end. The room is not negative at 0, so Newton's method from the
// right meets its zero in a few steps.
double highest_before(const Grid& grid, const Strips& strips, double next, double twice) {
  double x = std::min(strips.x_most, Grid::kUnbounded);
  for (std::size_t step = 0; step <= strips.alpha.size() && x > 0.0; ++step) {
    const Room room = room_at(grid, strips, x, next, twice);
    if (room.is_there() || !(room.slope < 0.0)) return x;
    x -= room.room / room.slope;
  }
  return x > 0.0 ? x : highest_by_halving(grid, strips, next, twice);
}

}  // namespace

double SpeedAlongPath::duration() const {
  double T = 0.0;
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    T += 2.0 * (s[k + 1] - s[k]) / (std::sqrt(squared[k]) + std::sqrt(squared[k + 1]));
  }
  return T;
}

double SpeedAlongPath::time_at(double place) const {
  double T = 0.0;
  for (std::size_t k = 0; k + 1 < s.size() && s[k] < place; ++k) {
    const double v0 = std::sqrt(squared[k]);
    const double step = std::min(place, s[k + 1]) - s[k];
    const double part = step / (s[k + 1] - s[k]);
    const double v1 = std::sqrt(squared[k] + part * (squared[k + 1] - squared[k]));
    T += 2.0 * step / (v0 + v1);
  }
  return T;
}

SpeedAlongPath fastest_along(const Trajectory& path, std::span<const AxisLimits> limits,
                             int intervals, std::span<const SpeedZone> zones) {
  check_path(path, limits, intervals);
  for (const SpeedZone& zone : zones) {
    if (zone.speed > 0.0 && zone.acceleration > 0.0) continue;
    throw ArgumentError(fmt::format(
        "A stretch of the path is limited to a speed of {} and an acceleration of {}; expected "
        "both above zero.",
        zone.speed, zone.acceleration));
  }
  Grid grid(path, limits, intervals, zones);
  const std::vector<double>& s = grid.s();
  const std::size_t last = s.size() - 1;
  // Backwards: from which speeds can the arm still stop at the end?
  std::vector<double> most(s.size(), 0.0);
  for (std::size_t k = last; k-- > 0;) {
    const Strips& strips = grid.between(k);
    most[k] = highest_before(grid, strips, most[k + 1], 2.0 * (s[k + 1] - s[k]));
  }
  // Forwards: as fast as possible within those.
  std::vector<double> x(s.size(), 0.0);
  for (std::size_t k = 0; k < last; ++k) {
    grid.between(k);
    const double twice = 2.0 * (s[k + 1] - s[k]);
    x[k + 1] = std::clamp(x[k] + twice * grid.range(x[k]).upper, 0.0, most[k + 1]);
    // It may stop at a place where the path turns sharply, but has to leave it again.
    const bool may_stop = x[k] > 0.0 && k + 2 < last;
    if (k + 1 < last && !(x[k + 1] > 0.0) && !may_stop) {
      throw ArgumentError(fmt::format(
          "The path cannot be left at s = {}: the limits allow no acceleration there.", s[k]));
    }
  }
  return {.s = s, .squared = std::move(x)};
}

Trajectory run_along(const Trajectory& path, const SpeedAlongPath& speed) {
  const std::size_t count = speed.s.size() - 1;
  std::vector<double> start(count + 1, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const double v = std::sqrt(speed.squared[k]) + std::sqrt(speed.squared[k + 1]);
    start[k + 1] = start[k] + 2.0 * (speed.s[k + 1] - speed.s[k]) / v;
  }
  std::vector<JointPath> joints;
  for (int i = 0; i < path.n(); ++i) {
    JointPath run{.q_end = path.joint(i).q_end};
    const std::vector<Segment>& pieces = path.joint(i).segments;
    std::size_t piece = 0;
    for (std::size_t k = 0; k < count && !pieces.empty(); ++k) {
      piece = piece_behind(pieces, piece, speed.s[k]);
      const Segment& p = pieces[piece];
      const double at = speed.s[k] - p.start;
      const double p0 = p.value(at), p1 = p.value(at, 1), p2 = 0.5 * p.value(at, 2), p3 = p.c[3];
      // s - s_k = v t + w t^2, put into the cubic.
      const double v = std::sqrt(speed.squared[k]);
      const double w =
          (speed.squared[k + 1] - speed.squared[k]) / (4.0 * (speed.s[k + 1] - speed.s[k]));
      run.segments.push_back(
          {.start = start[k],
           .duration = start[k + 1] - start[k],
           .degree = 6,
           .c = {p0, p1 * v, p1 * w + p2 * v * v, 2.0 * p2 * v * w + p3 * v * v * v,
                 p2 * w * w + 3.0 * p3 * v * v * w, 3.0 * p3 * v * w * w, p3 * w * w * w}});
    }
    joints.push_back(std::move(run));
  }
  return {std::move(joints), start.back()};
}

Trajectory time_optimal(const Trajectory& path, std::span<const AxisLimits> limits, int intervals,
                        std::span<const SpeedZone> zones) {
  return run_within(path, fastest_along(path, limits, intervals, zones), limits);
}

Trajectory run_within(const Trajectory& path, const SpeedAlongPath& speed,
                      std::span<const AxisLimits> limits) {
  const Trajectory fastest = run_along(path, speed);
  double slower = 1.0;
  for (int i = 0; i < fastest.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    slower = std::max(
        {slower, fastest.peak(i, 1) / l.speed, std::sqrt(fastest.peak(i, 2) / l.acceleration)});
  }
  return slower > 1.0 ? fastest.stretched(slower) : fastest;
}

Trajectory path_through(std::span<const Eigen::VectorXd> points) {
  if (points.size() < 2) throw ArgumentError("A path needs at least two points.");
  std::vector<double> s = {0.0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    check_size("points", points[k].size(), points[0].size());
    check_finite("points", points[k]);
    const double distance = (points[k] - points[k - 1]).norm();
    if (!(distance > 0.0)) {
      throw ArgumentError(
          fmt::format("Points {} and {} of the path are the same; leave one out.", k, k + 1));
    }
    s.push_back(s.back() + std::sqrt(distance));
  }
  std::vector<JointPath> joints;
  std::vector<double> q(points.size());
  for (Eigen::Index i = 0; i < points[0].size(); ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) q[k] = points[k][i];
    joints.push_back({.segments = natural_spline(s, q), .q_end = q.back()});
  }
  return {std::move(joints), s.back()};
}

}  // namespace armlet
