#include "armlet/trajectory/time_optimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "trajectory/timing/speed_grid.hpp"

namespace armlet {
namespace {

// distance from all limits below which an interval is not divided,
constexpr double kIdle = 0.02;
constexpr double kMostParts = 6.0;  // and the largest number of parts of one
constexpr int kDivisions = 6;       // largest number of divisions of the grid,
constexpr double kGain = 1e-3;      // which end when the time decreases by less than this fraction
constexpr std::size_t kManyPositions = 20'000;  // a grid with more positions is not divided again
constexpr int kRounds = 8;          // how often the motion is slowed down between positions
constexpr double kWellKept = 1e-3;  // excess for which the whole motion is not slowed down

void check_limits(const Course& course) {
  check_size("limits", static_cast<Eigen::Index>(course.limits.size()), course.path.n());
  for (int i = 0; i < course.path.n(); ++i) {
    const AxisLimits& l = course.limits[static_cast<std::size_t>(i)];
    check_positive("speed limit", l.speed);
    const bool by_motor = course.arm != nullptr && std::isfinite(course.arm->joint(i).max_effort);
    if (by_motor && l.acceleration == std::numeric_limits<double>::infinity()) continue;
    check_positive("acceleration limit", l.acceleration);
  }
}

void check_path(const Trajectory& path, int intervals) {
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

// The room that the bounds leave for u at the start of an interval, so that the squared speed at
// its end is between 0 and `next`: a concave function of x, and its derivative.
struct Room {
  double room, slope, scale;

  [[nodiscard]] bool is_there() const { return room >= -1e-12 * scale; }
};

Room room_at(const SpeedGrid& grid, double x, double next, double twice) {
  const SpeedGrid::Range r = grid.range(x);
  double upper = r.most, upper_slope = r.upper.slope;
  double lower = r.least, lower_slope = r.lower.slope;
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

// The highest squared speed by bisection, for bounds of very different size, for which Newton's
// method steps past the zero.
double highest_by_halving(const SpeedGrid& grid, const SpeedStrips& strips, double next,
                          double twice) {
  double low = 0.0, high = std::max(next, 1e-12);
  while (high < strips.x_most && room_at(grid, high, next, twice).is_there()) {
    low = high;
    high *= 4.0;
  }
  high = std::min(high, strips.x_most);
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (room_at(grid, middle, next, twice).is_there() ? low : high) = middle;
  }
  return low;
}

// The highest squared speed at the start of an interval from which a squared speed of at most
// `next` can be reached at its end. The room is not negative at 0, so Newton's method from the
// right converges to its zero in a few steps.
double highest_before(const SpeedGrid& grid, const SpeedStrips& strips, double next, double twice) {
  double x = std::min(strips.x_most, SpeedGrid::kUnbounded);
  for (std::size_t step = 0; step <= strips.upper.size() + strips.lower.size() && x > 0.0; ++step) {
    const Room room = room_at(grid, x, next, twice);
    if (room.is_there() || !(room.slope < 0.0)) return x;
    x -= room.room / room.slope;
  }
  return x > 0.0 ? x : highest_by_halving(grid, strips, next, twice);
}

void check_course(const Course& course, int intervals) {
  check_limits(course);
  check_path(course.path, intervals);
  for (const SpeedZone& zone : course.zones) {
    if (zone.speed > 0.0 && zone.acceleration > 0.0) continue;
    throw ArgumentError(fmt::format(
        "A stretch of the path is limited to a speed of {} and an acceleration of {}; expected "
        "both above zero.",
        zone.speed, zone.acceleration));
  }
}

SpeedAlongPath fastest_on(SpeedGrid& grid) {
  const std::vector<double>& s = grid.s();
  const std::size_t last = s.size() - 1;
  // Backward pass: the highest speeds from which the arm can still stop at the end.
  std::vector<double> most(s.size(), 0.0);
  for (std::size_t k = last; k-- > 0;) {
    const SpeedStrips& strips = grid.between(k);
    most[k] = highest_before(grid, strips, most[k + 1], 2.0 * (s[k + 1] - s[k]));
  }
  // Forward pass: as fast as possible below those.
  std::vector<double> x(s.size(), 0.0);
  for (std::size_t k = 0; k < last; ++k) {
    grid.between(k);
    const double twice = 2.0 * (s[k + 1] - s[k]);
    x[k + 1] = std::clamp(x[k] + twice * grid.range(x[k]).most, 0.0, most[k + 1]);
    // The motion may stop at a position where the path has a sharp bend, but has to leave it again.
    const bool may_stop = x[k] > 0.0 && k + 2 < last;
    if (k + 1 < last && !(x[k + 1] > 0.0) && !may_stop) {
      throw ArgumentError(fmt::format(
          "The path cannot be left at s = {}: the limits allow no acceleration there.", s[k]));
    }
  }
  return {.s = s, .squared = std::move(x)};
}

// Adds positions where the grid is too coarse for limits to be reached, as the fastest motion does
// everywhere.
std::vector<double> finer(const SpeedGrid& grid, const SpeedAlongPath& run) {
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

// Viscous friction is linearised at the speeds of the motion before, which stays allowed: no motion
// is slower than the one before it.
SpeedAlongPath fastest_with_friction(SpeedGrid& grid) {
  SpeedAlongPath run = fastest_on(grid);
  if (grid.motors() == nullptr || !grid.motors()->have_viscous_friction()) return run;
  for (const double reach : {4.0, 2.0, 1.5, 1.2, 1.1, 1.05}) {
    grid.motors()->linearise_at(run.squared, reach);
    run = fastest_on(grid);
  }
  return run;
}

bool motors_hold(SpeedGrid& grid) { return grid.motors() == nullptr || grid.motors()->hold(); }

// The fastest motion on a grid, and that grid.
struct GridRun {
  std::unique_ptr<SpeedGrid> grid{};
  SpeedAlongPath speed{};
};

// The fastest motion on a grid so fine that more positions hardly reduce the time. Doubling the
// positions halves the loss of time, but only to nine tenths where all joints nearly reverse at
// once. There the squared speed along the path has a narrow peak, and a speed that is too low next
// to it reduces the speed far before and after it. Nothing if motors cannot hold the arm somewhere.
std::optional<GridRun> run_on_fine_grid(const Course& course, int intervals) {
  GridRun run{std::make_unique<SpeedGrid>(course, positions_along(course, intervals))};
  if (!motors_hold(*run.grid)) return {};
  run.speed = fastest_with_friction(*run.grid);
  for (int k = 0; k < kDivisions; ++k) {
    GridRun next{std::make_unique<SpeedGrid>(course, finer(*run.grid, run.speed))};
    if (!motors_hold(*next.grid)) return {};
    next.speed = fastest_with_friction(*next.grid);
    const bool gains = next.speed.duration() < run.speed.duration() * (1.0 - kGain);
    run = std::move(next);
    if (!gains || run.speed.s.size() > kManyPositions) break;
  }
  return run;
}

// Factor by which a motion has to be slower for the limits on speeds and accelerations.
double slower_for_rates(const Trajectory& motion, std::span<const AxisLimits> limits) {
  double slower = 1.0;
  for (int i = 0; i < motion.n(); ++i) {
    const AxisLimits& l = limits[static_cast<std::size_t>(i)];
    slower = std::max(
        {slower, motion.peak(i, 1) / l.speed, std::sqrt(motion.peak(i, 2) / l.acceleration)});
  }
  return slower;
}

// Nothing if motors cannot hold the arm somewhere.
std::optional<FastestRun> run_on(const Course& course, int intervals) {
  std::optional<GridRun> run = run_on_fine_grid(course, intervals);
  if (!run) return {};
  SpeedAlongPath& speed = run->speed;
  for (int k = 0; k < kRounds && run->grid->tighten(speed.squared) > 1.0 + kWellKept; ++k)
    speed = fastest_on(*run->grid);
  Trajectory motion = run_along(course.path, speed);
  const double slower = slower_for_rates(motion, course.limits);
  if (slower == 1.0) return FastestRun{std::move(speed), std::move(motion)};
  for (double& x : speed.squared) x /= slower * slower;
  return FastestRun{std::move(speed), motion.stretched(slower)};
}

}  // namespace

SpeedAlongPath fastest_along(const Trajectory& path, std::span<const AxisLimits> limits,
                             int intervals, std::span<const SpeedZone> zones,
                             std::span<const Segment> travel) {
  const Course course{path, limits, zones, travel};
  check_course(course, intervals);
  SpeedGrid grid(course, positions_along(course, intervals));
  return fastest_on(grid);
}

std::optional<SpeedAlongPath> fastest_along(const Course& course, int intervals) {
  check_course(course, intervals);
  SpeedGrid grid(course, positions_along(course, intervals));
  if (!motors_hold(grid)) return {};
  return fastest_with_friction(grid);
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
      // s - s_k = v t + w t^2, inserted into the cubic.
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
  return *run_on(course, intervals);
}

Trajectory time_optimal(const Trajectory& path, std::span<const AxisLimits> limits, int intervals,
                        std::span<const SpeedZone> zones) {
  return fastest_run(path, limits, intervals, zones).motion;
}

std::optional<Trajectory> time_optimal_with_motors(const Robot& robot, const Trajectory& path,
                                                   std::span<const AxisLimits> limits,
                                                   int intervals) {
  check_size("the path", path.n(), robot.n());
  const Course course{path, limits, {}, {}, &robot};
  check_course(course, intervals);
  std::optional<FastestRun> run = run_on(course, intervals);
  if (!run) return {};
  const MotionForces forces = motion_forces(robot, run->motion);
  if (!std::isfinite(forces.slower)) return {};
  if (forces.slower <= 1.0) return std::move(run->motion);
  return run->motion.stretched(forces.slower);
}

}  // namespace armlet
