#include "armlet/trajectory/time_optimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"

namespace armlet {
namespace {

constexpr double kNoSlope = 1e-12;  // |q'| below it: the joint does not restrict the acceleration
constexpr double kSameKnot = 1e-9;  // as in Trajectory::knots
constexpr double kIdle = 0.02;      // of all limits, that an interval may leave without parts,
constexpr double kMostParts = 6.0;  // of which it gets so many at most
constexpr int kRounds = 8;          // how often what is exceeded between positions is made slower
constexpr double kWellKept = 1e-3;  // what may be exceeded before the whole is made slower

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

// The piece that begins at a position or goes on behind it; knots of different joints that differ
// by rounding are one position. `piece` is one before.
std::size_t piece_behind(std::span<const Segment> pieces, std::size_t piece, double s) {
  while (piece + 1 < pieces.size() && pieces[piece + 1].start <= s + kSameKnot) ++piece;
  return piece;
}

// Positions along the path: its knots, where zones begin and end, and enough in between.
std::vector<double> positions(const Trajectory& path, std::span<const SpeedZone> zones,
                              int intervals) {
  std::vector<double> knots = path.knots();
  for (const SpeedZone& zone : zones) {
    for (const double border : {zone.from, zone.to}) {
      const auto behind = std::ranges::lower_bound(knots, border - kSameKnot);
      if (behind == knots.end() || *behind <= border + kSameKnot) continue;
      if (behind != knots.begin()) knots.insert(behind, border);
    }
  }
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

// What is run along: the path, its limits and those of its zones.
struct Course {
  const Trajectory& path;
  std::span<const AxisLimits> limits;
  std::span<const SpeedZone> zones;
  std::span<const Segment> travel;
};

// First and second derivative.
struct Slopes {
  double first = 0.0, second = 0.0;
};
Slopes slopes_at(const Segment& p, double s) {
  const double u = s - p.start;
  return {p.c[1] + u * (2.0 * p.c[2] + u * 3.0 * p.c[3]), 2.0 * p.c[2] + 6.0 * u * p.c[3]};
}

class Grid {
 public:
  Grid(const Course& course, std::vector<double> positions)
      : course_(course),
        s_(std::move(positions)),
        limits_(course.limits),
        zones_(course.zones),
        n_(course.limits.size()) {
    const std::size_t count = s_.size();
    first_.resize(count * n_);
    second_.resize(count * n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const std::vector<Segment>& pieces = course.path.joint(static_cast<int>(i)).segments;
      fill(pieces, n_, &first_[i], &second_[i]);
    }
    travel_first_.assign(count, 1.0);
    travel_second_.assign(count, 0.0);
    if (!course.travel.empty()) fill(course.travel, 1, travel_first_.data(), travel_second_.data());
    strips_.alpha.resize(2 * (n_ + zones_.size()));
    strips_.beta.resize(2 * (n_ + zones_.size()));
    over_.assign(count, {});
    bound_.resize(count);
    for (std::size_t k = 0; k < count; ++k) bound_[k] = speed_bound(k);
  }

  // By how much limits are exceeded in an interval, so that they are divided by it.
  struct Over {
    double speed = 1.0, acceleration = 1.0;
  };

  // Makes limits stricter where a run exceeds them between the positions; by how much the worst is
  // exceeded, as a factor of time.
  double tighten(const std::vector<double>& x) {
    double worst = 1.0;
    std::vector<std::size_t> piece(n_ + 1, 0);
    for (std::size_t k = 0; k + 1 < s_.size(); ++k) {
      Over over;
      for (const double part : {0.2, 0.5, 0.8}) look(k, part, x, piece, over);
      over_[k].speed *= over.speed;
      over_[k].acceleration *= over.acceleration;
      worst = std::max({worst, over.speed, std::sqrt(over.acceleration)});
    }
    for (std::size_t k = 0; k < s_.size(); ++k) bound_[k] = speed_bound(k);
    return worst;
  }

  // How far a run stays below all limits in each interval, as a part of them.
  [[nodiscard]] std::vector<double> idle(const std::vector<double>& x) const {
    std::vector<double> out;
    std::vector<std::size_t> piece(n_ + 1, 0);
    for (std::size_t k = 0; k + 1 < s_.size(); ++k) {
      double least = 1.0;
      for (const double part : {0.01, 0.5, 0.99}) {
        Over load{0.0, 0.0};
        look(k, part, x, piece, load);
        least = std::min(least, std::max(load.speed, load.acceleration));
      }
      out.push_back(1.0 - least);
    }
    return out;
  }

  [[nodiscard]] const std::vector<double>& s() const { return s_; }

  // The highest squared speed of the speed limits at a position, where zones meet that of both.
  [[nodiscard]] double speed_bound(std::size_t k) const {
    double least = std::sqrt(kUnbounded);
    for (const SpeedZone& zone : zones_) {
      const bool inside = s_[k] >= zone.from - kSameKnot && s_[k] <= zone.to + kSameKnot;
      const double slope = std::abs(travel_first_[k]);
      if (inside && slope * least > zone.speed) least = zone.speed / slope;
    }
    for (std::size_t i = 0; i < n_; ++i) {
      const double slope = std::abs(first_[k * n_ + i]);
      if (slope * least > limits_[i].speed) least = limits_[i].speed / slope;
    }
    least /= std::max(over_[k].speed, k > 0 ? over_[k - 1].speed : 1.0);
    return least * least;
  }

  // What holds between position k and the next: the limits at k, and those at k + 1 with the speed
  // reached there.
  const Strips& between(std::size_t k) {
    checkpoint(40 * n_);
    const double twice = 2.0 * (s_[k + 1] - s_[k]);
    rows_ = 0;
    strips_.x_most = bound_[k];
    for (std::size_t i = 0; i < n_; ++i) {
      const double A = limits_[i].acceleration / over_[k].acceleration;
      add(first_[k * n_ + i], second_[k * n_ + i], A);
      const double curve = second_[(k + 1) * n_ + i];
      add(first_[(k + 1) * n_ + i] + twice * curve, curve, A);
    }
    for (const SpeedZone& zone : zones_) {
      const bool overlaps = s_[k + 1] > zone.from + kSameKnot && s_[k] < zone.to - kSameKnot;
      if (!overlaps || !std::isfinite(zone.acceleration)) continue;
      const double A = zone.acceleration / over_[k].acceleration;
      add(travel_first_[k], travel_second_[k], A);
      add(travel_first_[k + 1] + twice * travel_second_[k + 1], travel_second_[k + 1], A);
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
  // Derivatives at all positions; of a curve without pieces they are zero.
  void fill(std::span<const Segment> pieces, std::size_t stride, double* first,
            double* second) const {
    std::size_t piece = 0;
    for (std::size_t k = 0; k < s_.size(); ++k) {
      Slopes slopes;
      if (!pieces.empty()) {
        piece = piece_behind(pieces, piece, s_[k]);
        slopes = slopes_at(pieces[piece], s_[k]);
      }
      first[k * stride] = slopes.first;
      second[k * stride] = slopes.second;
    }
  }

  // What is exceeded at a part of interval k.
  void look(std::size_t k, double part, const std::vector<double>& x,
            std::vector<std::size_t>& piece, Over& over) const {
    const double length = s_[k + 1] - s_[k];
    const double s = s_[k] + part * length;
    const double u = (x[k + 1] - x[k]) / (2.0 * length);
    const double squared = x[k] + part * (x[k + 1] - x[k]);
    const double speed = std::sqrt(squared);
    const auto compare = [&](const Slopes& slopes, double V, double A) {
      over.speed = std::max(over.speed, std::abs(slopes.first) * speed / V);
      const double a = std::abs(slopes.first * u + slopes.second * squared);
      over.acceleration = std::max(over.acceleration, a / A);
    };
    for (std::size_t i = 0; i < n_; ++i) {
      const std::vector<Segment>& pieces = course_.path.joint(static_cast<int>(i)).segments;
      if (pieces.empty()) continue;
      piece[i] = piece_behind(pieces, piece[i], s);
      compare(slopes_at(pieces[piece[i]], s), limits_[i].speed, limits_[i].acceleration);
    }
    Slopes travel{1.0, 0.0};
    if (!course_.travel.empty()) {
      piece[n_] = piece_behind(course_.travel, piece[n_], s);
      travel = slopes_at(course_.travel[piece[n_]], s);
    }
    for (const SpeedZone& zone : zones_) {
      if (s > zone.from && s < zone.to) compare(travel, zone.speed, zone.acceleration);
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

  Course course_;
  std::vector<double> s_;
  std::span<const AxisLimits> limits_;
  std::span<const SpeedZone> zones_;
  std::size_t n_;
  std::vector<double> first_, second_;  // by position, then by joint
  std::vector<double> travel_first_, travel_second_;
  std::vector<Over> over_;     // by interval
  std::vector<double> bound_;  // squared speed
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

void check_course(const Course& course, int intervals) {
  check_path(course.path, course.limits, intervals);
  for (const SpeedZone& zone : course.zones) {
    if (zone.speed > 0.0 && zone.acceleration > 0.0) continue;
    throw ArgumentError(fmt::format(
        "A stretch of the path is limited to a speed of {} and an acceleration of {}; expected "
        "both above zero.",
        zone.speed, zone.acceleration));
  }
}

SpeedAlongPath fastest_on(Grid& grid) {
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
    // It may stop at a position where the path turns sharply, but has to leave it again.
    const bool may_stop = x[k] > 0.0 && k + 2 < last;
    if (k + 1 < last && !(x[k + 1] > 0.0) && !may_stop) {
      throw ArgumentError(fmt::format(
          "The path cannot be left at s = {}: the limits allow no acceleration there.", s[k]));
    }
  }
  return {.s = s, .squared = std::move(x)};
}

// Where the grid is too coarse for limits to be reached everywhere, as the fastest run does, it
// gets more positions.
std::vector<double> finer(const Grid& grid, const SpeedAlongPath& run) {
  const std::vector<double> idle = grid.idle(run.squared);
  std::vector<double> s = {0.0};
  for (std::size_t k = 0; k + 1 < run.s.size(); ++k) {
    const double parts = std::clamp(std::ceil(idle[k] / kIdle), 1.0, kMostParts);
    const double length = run.s[k + 1] - run.s[k];
    for (double j = 1.0; j < parts; ++j) s.push_back(run.s[k] + length * j / parts);
    s.push_back(run.s[k + 1]);
  }
  return s;
}

}  // namespace

SpeedAlongPath fastest_along(const Trajectory& path, std::span<const AxisLimits> limits,
                             int intervals, std::span<const SpeedZone> zones,
                             std::span<const Segment> travel) {
  const Course course{path, limits, zones, travel};
  check_course(course, intervals);
  Grid grid(course, positions(path, zones, intervals));
  return fastest_on(grid);
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

FastestRun fastest_run(const Trajectory& path, std::span<const AxisLimits> limits, int intervals,
                       std::span<const SpeedZone> zones, std::span<const Segment> travel) {
  const Course course{path, limits, zones, travel};
  check_course(course, intervals);
  Grid coarse(course, positions(path, zones, intervals));
  Grid grid(course, finer(coarse, fastest_on(coarse)));
  SpeedAlongPath speed = fastest_on(grid);
  for (int k = 0; k < kRounds && grid.tighten(speed.squared) > 1.0 + kWellKept; ++k)
    speed = fastest_on(grid);
  Trajectory motion = run_along(path, speed);
  double slower = 1.0;
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    slower = std::max(
        {slower, motion.peak(i, 1) / l.speed, std::sqrt(motion.peak(i, 2) / l.acceleration)});
  }
  if (slower == 1.0) return {std::move(speed), std::move(motion)};
  for (double& x : speed.squared) x /= slower * slower;
  return {std::move(speed), motion.stretched(slower)};
}

Trajectory time_optimal(const Trajectory& path, std::span<const AxisLimits> limits, int intervals,
                        std::span<const SpeedZone> zones) {
  return fastest_run(path, limits, intervals, zones).motion;
}

}  // namespace armlet
