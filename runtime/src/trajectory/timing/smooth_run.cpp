#include "trajectory/timing/smooth_run.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "armlet/core/error.hpp"
#include "trajectory/cube_root.hpp"
#include "trajectory/timing/run_forces.hpp"
#include "trajectory/timing/speed_changes.hpp"
#include "trajectory/timing/speed_spline.hpp"

namespace armlet {
namespace {

// Weights in the distribution of the pieces: evenly in u, evenly in time, and where the speed
// changes.
constexpr double kShareOfPosition = 0.2;
constexpr double kShareOfTime = 0.2;
constexpr double kShareOfChange = 0.6;
constexpr int kPiecesOfEnd = 4;          // least number of pieces of the ramp at each end
constexpr double kNearBorder = 0.3;      // of the distance between knots: nearer ones are dropped
constexpr double kSameBorder = 1e-6;     // of the whole path
constexpr double kShortestPiece = 0.05;  // of the motion, as a fraction of a piece of the speed
constexpr int kRounds = 4;  // how often limits that are exceeded between points are reduced
// Largest duration of a motion, as a multiple of the one without jerk limits, and of the time in
// which a joint reaches its highest acceleration under the jerk limit.
constexpr double kLongest = 5.0;
constexpr double kLongestRamps = 20.0;
// Allowed relative distance of the duration from the least one, at first and at the end.
constexpr double kRoughly = 0.03;
constexpr double kNearly = 2e-3;
constexpr double kRests = 1e-9;     // derivatives of a path that is at rest at its ends: rounding
constexpr double kWellKept = 2e-3;  // excess for which the whole motion is not slowed down

// Derivatives of a cubic piece at s, one after another.
struct Rates {
  double value, first, second, third;
};
Rates rates_of(const Segment& piece, double s) {
  const double u = s - piece.start;
  const auto& c = piece.c;
  return {c[0] + u * (c[1] + u * (c[2] + u * c[3])), c[1] + u * (2.0 * c[2] + u * 3.0 * c[3]),
          2.0 * c[2] + 6.0 * u * c[3], 6.0 * c[3]};
}

// Derivatives by u of a cubic piece in s, if s is a function of u.
Rates by_u(const Rates& r, const PathWarp::Along& p) {
  return {r.value, r.first * p.first, r.second * p.first * p.first + r.first * p.second,
          r.third * p.first * p.first * p.first + 3.0 * r.second * p.first * p.second +
              r.first * p.third};
}

// The piece that contains s, searched from an earlier one.
std::size_t piece_at(std::span<const Segment> pieces, std::size_t piece, double s) {
  while (piece + 1 < pieces.size() && pieces[piece + 1].start <= s) ++piece;
  return piece;
}

// Whether a path begins and ends at rest already.
bool rests_at_ends(const Trajectory& path) {
  double most = 0.0;
  for (int i = 0; i < path.n(); ++i) {
    for (const double s : {0.0, path.duration()})
      most = std::max({most, std::abs(path.value(i, s, 1)), std::abs(path.value(i, s, 2))});
  }
  return most <= kRests;
}

class Run {
 public:
  Run(const Course& course, const SpeedAlongPath& fastest, int cells)
      : path_(course.path),
        limits_(course.limits),
        zones_(course.zones),
        travel_(course.travel),
        warp_(course.arm != nullptr && rests_at_ends(course.path)
                  ? PathWarp(course.path.duration(), 0.0, 0.0)
                  : warp_of(fastest, time_of_jerk(limits_))),
        longest_(kLongest * fastest.duration() + kLongestRamps * time_of_jerk(limits_)) {
    const std::vector<double> knots = place_knots(fastest, cells);
    tight_.assign(knots.size() - 1, Tight{});
    spline_ = SpeedSpline(knots);
    if (course.arm != nullptr) forces_.emplace(*course.arm, path_, course.share, spline_.cells());
    lay_pieces(knots);
    take_thirds();
  }

  TimedRun find() {
    TimedRun run;
    for (int round = 0; round < kRounds; ++round) {
      add_points();
      if (forces_ && !forces_->hold()) return {};
      const bool is_fastest = spline_.find_fastest(round == 0 ? kRoughly : kNearly);
      if (!(spline_.duration() <= longest_)) return {};
      run = make();
      run.is_fastest = is_fastest;
      if (tighten(run) <= 1.0 + kWellKept && round > 0) break;
    }
    const double factor = std::max(slower(run), 1.0);
    if (!(factor * run.motion.duration() <= longest_)) return {};
    return run.stretched(factor);
  }

 private:
  // Factors by which limits are divided in a cell, since they are exceeded between the points.
  struct Tight {
    double speed = 1.0, acceleration = 1.0, jerk = 1.0;
  };

  // Knots: the borders of zones; the others are where speeds change, and evenly spaced in time and
  // u.
  std::vector<double> place_knots(const SpeedAlongPath& fastest, int cells) const {
    const SpeedChanges changes = changes_of(fastest, time_of_jerk(limits_));
    double busy = 0.0;
    for (std::size_t k = 0; k < changes.busy.size(); ++k)
      busy += changes.busy[k] ? changes.t[k + 1] - changes.t[k] : 0.0;
    std::vector<double> u = {0.0}, share = {0.0};
    for (std::size_t k = 1; k < fastest.s.size(); ++k) {
      const double dt = changes.t[k] - changes.t[k - 1];
      u.push_back(warp_.inverse(fastest.s[k]));
      share.push_back(share.back() + kShareOfPosition * (u[k] - u[k - 1]) / warp_.whole() +
                      kShareOfTime * dt / changes.t.back() +
                      (changes.busy[k - 1] ? kShareOfChange * dt / busy : 0.0));
    }
    std::vector<double> knots;
    std::size_t k = 0;
    for (int j = 0; j <= cells; ++j) {
      const double wanted = share.back() * j / cells;
      while (k + 2 < share.size() && share[k + 1] < wanted) ++k;
      const double part = (wanted - share[k]) / (share[k + 1] - share[k]);
      knots.push_back(u[k] + std::clamp(part, 0.0, 1.0) * (u[k + 1] - u[k]));
    }
    knots.front() = 0.0;
    knots.back() = warp_.whole();
    return with_borders(std::move(knots));
  }

  // Adds the borders of zones and the pieces of both ends to knots, and drops knots near them.
  std::vector<double> with_borders(const std::vector<double>& knots) const {
    std::vector<double> borders = {0.0, warp_.whole()};
    for (const SpeedZone& zone : zones_) {
      add_border(borders, warp_.inverse(zone.from), kSameBorder * warp_.whole());
      add_border(borders, warp_.inverse(zone.to), kSameBorder * warp_.whole());
    }
    // Each end has pieces of its own, however short it is: one piece over a whole ramp to a low
    // speed would overshoot that speed.
    for (int k = 1; k <= kPiecesOfEnd; ++k) {
      const double part = static_cast<double>(k) / kPiecesOfEnd;
      const double start = warp_.start(), end = warp_.end();
      if (start > 0.0) add_border(borders, part * start, kNearBorder * start / kPiecesOfEnd);
      if (end > 0.0)
        add_border(borders, warp_.whole() - part * end, kNearBorder * end / kPiecesOfEnd);
    }
    std::vector<double> all = borders;
    for (std::size_t k = 1; k + 1 < knots.size(); ++k) {
      const double space = std::min(knots[k] - knots[k - 1], knots[k + 1] - knots[k]);
      if (space > 0.0 && is_apart(borders, knots[k], kNearBorder * space)) all.push_back(knots[k]);
    }
    std::ranges::sort(all);
    return all;
  }

  static bool is_apart(const std::vector<double>& borders, double u, double near) {
    return std::ranges::none_of(borders, [&](double each) { return std::abs(each - u) <= near; });
  }

  static void add_border(std::vector<double>& borders, double u, double near) {
    if (is_apart(borders, u, near)) borders.push_back(u);
  }

  // Sets the pieces of the motion: at the knots of the speeds and of the path, unless a piece would
  // be so short that rounding determines its jerk.
  void lay_pieces(const std::vector<double>& knots) {
    std::vector<double> of_path;
    for (const double s : path_.knots()) of_path.push_back(warp_.inverse(s));
    u_ = {0.0};
    std::size_t next = 0;
    for (std::size_t k = 1; k < knots.size(); ++k) {
      const double least = kShortestPiece * (knots[k] - knots[k - 1]);
      for (; next < of_path.size() && of_path[next] < knots[k]; ++next) {
        const double u = of_path[next];
        if (u > u_.back() + least && u < knots[k] - least) u_.push_back(u);
      }
      u_.push_back(knots[k]);
    }
  }

  // The mean third derivatives of the pieces of the motion: those of the path itself vary strongly
  // where its knots are closer.
  void take_thirds() {
    third_.assign((u_.size() - 1) * limits_.size(), 0.0);
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const std::span<const Segment> pieces = path_.joint(static_cast<int>(i)).segments;
      if (pieces.empty()) continue;
      std::size_t piece = 0;
      double from = 0.0, second = rates_of(pieces[0], 0.0).second;
      for (std::size_t k = 0; k + 1 < u_.size(); ++k) {
        const double to = warp_.at(u_[k + 1]).s;
        piece = piece_at(pieces, piece, to);
        const double next = rates_of(pieces[piece], to).second;
        third_[k * limits_.size() + i] = (next - second) / (to - from);
        from = to;
        second = next;
      }
    }
  }

  // Indices of the pieces of the path, of `travel` and of the motion that contain a position.
  struct Cursor {
    std::vector<std::size_t> path;
    std::size_t travel = 0;
    std::size_t motion = 0;
  };

  // Adds the conditions at three points of each cell, those of Simpson's rule, and in the middle of
  // every piece of the motion in it.
  void add_points() {
    Cursor cursor{.path = std::vector<std::size_t>(limits_.size(), 0)};
    spline_.clear_points();
    std::size_t next = 0;  // of the pieces
    for (std::size_t cell = 0; cell < spline_.cells(); ++cell) {
      std::vector<std::pair<double, double>> parts = {{0.0, 1.0}, {0.5, 4.0}, {1.0, 1.0}};
      const double from = spline_.at(cell, 0.0), to = spline_.at(cell, 1.0);
      for (; next + 1 < u_.size() && u_[next + 1] <= to; ++next) {
        const double part = (0.5 * (u_[next] + u_[next + 1]) - from) / (to - from);
        if (part != 0.5) parts.emplace_back(part, 0.0);
      }
      std::ranges::sort(parts);
      for (const auto& [part, weight] : parts) add_point(cell, part, weight / 6.0, cursor);
    }
  }

  void add_point(std::size_t cell, double part, double weight, Cursor& cursor) {
    // Slightly inside of the cell, since the path has a knot at its border.
    const double inside = spline_.at(cell, std::clamp(part, 1e-6, 1.0 - 1e-6));
    const PathWarp::Along along = warp_.at(spline_.at(cell, part));
    const double s = warp_.at(inside).s;
    while (cursor.motion + 2 < u_.size() && warp_.at(u_[cursor.motion + 1]).s <= s) ++cursor.motion;
    SpeedSpline::Point& point = spline_.add_point(cell, part, weight);
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const std::span<const Segment> pieces = path_.joint(static_cast<int>(i)).segments;
      if (pieces.empty()) continue;
      cursor.path[i] = piece_at(pieces, cursor.path[i], s);
      Rates rates = rates_of(pieces[cursor.path[i]], along.s);
      rates.third = third_[cursor.motion * limits_.size() + i];
      add_joint(cell, point, by_u(rates, along), limits_[i]);
    }
    if (!travel_.empty()) cursor.travel = piece_at(travel_, cursor.travel, s);
    const Rates rates =
        travel_.empty() ? Rates{along.s, 1.0, 0.0, 0.0} : rates_of(travel_[cursor.travel], along.s);
    add_zones(cell, point, by_u(rates, along));
    if (forces_) {
      const double from = warp_.at(u_[cursor.motion]).s, to = warp_.at(u_[cursor.motion + 1]).s;
      forces_->add_to(spline_, cell, along, s, from, to);
    }
  }

  void add_joint(std::size_t cell, SpeedSpline::Point& point, const Rates& r, const AxisLimits& l) {
    const Tight& tight = tight_[cell];
    limit_speed(point, r.first * tight.speed, l.speed);
    const double A = l.acceleration / tight.acceleration, J = l.jerk / tight.jerk;
    spline_.add_row({.ya = 0.5 * r.first / A,
                     .yb = r.second / A,
                     .za = 0.5 * r.first / J,
                     .zb = 1.5 * r.second / J,
                     .zc = r.third / J});
  }

  static void limit_speed(SpeedSpline::Point& point, double slope, double speed) {
    slope = std::abs(slope);
    if (slope * std::sqrt(point.most) > speed) point.most = (speed / slope) * (speed / slope);
  }

  [[nodiscard]] bool is_in(std::size_t cell, const SpeedZone& zone) const {
    const double middle = warp_.at(spline_.at(cell, 0.5)).s;
    return middle > zone.from && middle < zone.to;
  }

  void add_zones(std::size_t cell, SpeedSpline::Point& point, const Rates& rates) {
    for (const SpeedZone& zone : zones_) {
      if (!is_in(cell, zone)) continue;
      if (std::isfinite(zone.speed))
        limit_speed(point, rates.first * tight_[cell].speed, zone.speed);
      if (!std::isfinite(zone.acceleration)) continue;
      const double A = zone.acceleration / tight_[cell].acceleration;
      spline_.add_row({.ya = 0.5 * rates.first / A, .yb = rates.second / A});
    }
  }

  // The motion: quintics with the positions, speeds and accelerations at the points.
  TimedRun make() {
    TimedRun run;
    std::vector<double> t = {0.0};
    std::vector<SpeedSpline::Rate> rate;
    cell_of_.clear();
    std::size_t cell = 0;
    for (std::size_t k = 0; k < u_.size(); ++k) {
      rate.push_back(spline_.rate_at(u_[k], cell));
      run.s.push_back(warp_.at(u_[k]).s);
      if (k + 1 == u_.size()) break;
      cell = spline_.cell_at(0.5 * (u_[k] + u_[k + 1]), cell);
      cell_of_.push_back(cell);
      t.push_back(t.back() + spline_.time_between(u_[k], u_[k + 1], cell));
    }
    std::vector<JointPath> joints;
    for (int i = 0; i < path_.n(); ++i) joints.push_back(run_joint(path_.joint(i), t, rate));
    const double length = path_.duration();
    along_ = run_joint(
        {.segments = {{.duration = length, .degree = 1, .c = {0.0, 1.0}}}, .q_end = length}, t,
        rate);
    run.motion = Trajectory(std::move(joints), t.back());
    run.t = std::move(t);
    return run;
  }

  [[nodiscard]] JointPath run_joint(const JointPath& path, const std::vector<double>& t,
                                    const std::vector<SpeedSpline::Rate>& rate) const {
    JointPath run{.q_end = path.q_end};
    if (path.segments.empty()) return run;
    std::size_t piece = 0;
    AxisState before;
    for (std::size_t k = 0; k < u_.size(); ++k) {
      const PathWarp::Along along = warp_.at(u_[k]);
      piece = piece_at(path.segments, piece, along.s);
      const Rates r = by_u(rates_of(path.segments[piece], along.s), along);
      const bool ends = k == 0 || k + 1 == u_.size();
      const AxisState now{
          .q = k + 1 == u_.size() ? path.q_end : r.value,
          .v = ends ? 0.0 : r.first * rate[k].speed,
          .a = ends ? 0.0
                    : r.first * rate[k].acceleration + r.second * rate[k].speed * rate[k].speed};
      if (k > 0) {
        run.segments.push_back(quintic_segment(before, now, t[k] - t[k - 1]));
        run.segments.back().start = t[k - 1];
      }
      before = now;
    }
    return run;
  }

  // Divides limits by their excess; returns the factor by which the motion would have to be slower.
  double tighten(const TimedRun& run) {
    std::vector<Tight> worst(tight_.size());
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const std::vector<Segment>& pieces = run.motion.joint(static_cast<int>(i)).segments;
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        Tight& w = worst[cell_of_[k]];
        for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const double u = part * pieces[k].duration;
          w.speed = std::max(w.speed, std::abs(pieces[k].value(u, 1)) / limits_[i].speed);
          w.acceleration =
              std::max(w.acceleration, std::abs(pieces[k].value(u, 2)) / limits_[i].acceleration);
          w.jerk = std::max(w.jerk, std::abs(pieces[k].value(u, 3)) / limits_[i].jerk);
        }
      }
    }
    look_at_zones(worst);
    double most = 1.0;
    for (std::size_t cell = 0; cell < worst.size(); ++cell) {
      tight_[cell].speed *= worst[cell].speed;
      tight_[cell].acceleration *= worst[cell].acceleration;
      tight_[cell].jerk *= worst[cell].jerk;
      most = std::max({most, worst[cell].speed, std::sqrt(worst[cell].acceleration),
                       cube_root(worst[cell].jerk)});
    }
    return std::max(most, tighten_forces(run));
  }

  // Speeds exceed the limits of zones mostly near the borders of zones. Only those cells are
  // reduced; slowing the whole motion down for them would take longer.
  void look_at_zones(std::vector<Tight>& worst) const {
    if (zones_.empty()) return;
    std::size_t travels = 0;
    for (std::size_t k = 0; k < along_.segments.size(); ++k) {
      const Segment& piece = along_.segments[k];
      const double limit = speed_of_zones(piece.value(0.5 * piece.duration));
      if (!std::isfinite(limit)) continue;
      for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double s = piece.value(part * piece.duration);
        if (!travel_.empty()) travels = piece_at(travel_, travels, s);
        const double slope = travel_.empty() ? 1.0 : rates_of(travel_[travels], s).first;
        double& most = worst[cell_of_[k]].speed;
        most = std::max(most, std::abs(slope * piece.value(part * piece.duration, 1)) / limit);
      }
    }
  }

  [[nodiscard]] double speed_of_zones(double s) const {
    double least = INFINITY;
    for (const SpeedZone& zone : zones_) {
      if (s > zone.from && s < zone.to) least = std::min(least, zone.speed);
    }
    return least;
  }

  double tighten_forces(const TimedRun& run) {
    if (!forces_) return 1.0;
    double most = 1.0;
    for (std::size_t k = 0; k < cell_of_.size(); ++k) {
      for (const double part : {0.1, 0.35, 0.65, 0.9}) {
        const double t = run.t[k] + part * (run.t[k + 1] - run.t[k]);
        most = std::max(most, forces_->tighten(cell_of_[k], run.motion, t));
      }
    }
    return most;
  }

  [[nodiscard]] double slower(const TimedRun& run) const {
    double factor = 0.0;
    for (int i = 0; i < run.motion.n(); ++i) {
      const AxisLimits& l = limits_[static_cast<std::size_t>(i)];
      factor = std::max({factor, run.motion.peak(i, 1) / l.speed,
                         std::sqrt(run.motion.peak(i, 2) / l.acceleration),
                         cube_root(run.motion.peak(i, 3) / l.jerk)});
    }
    return factor;
  }

  const Trajectory& path_;
  std::span<const AxisLimits> limits_;
  std::span<const SpeedZone> zones_;
  std::span<const Segment> travel_;
  PathWarp warp_;
  SpeedSpline spline_;
  std::optional<RunForces> forces_;
  std::vector<Tight> tight_;          // by cell
  double longest_;                    // largest duration of the motion
  JointPath along_{};                 // s over the time of the motion
  std::vector<double> u_;             // borders of the pieces of the motion
  std::vector<double> third_;         // by piece of the motion, then by joint
  std::vector<std::size_t> cell_of_;  // of the pieces
};

}  // namespace

double TimedRun::time_at(double position) const {
  const auto after = std::ranges::upper_bound(s, position);
  if (after == s.begin()) return 0.0;
  if (after == s.end()) return t.back();
  const auto k = static_cast<std::size_t>(after - s.begin());
  return t[k - 1] + (t[k] - t[k - 1]) * (position - s[k - 1]) / (s[k] - s[k - 1]);
}

TimedRun TimedRun::stretched(double factor) const {
  if (factor == 1.0) return *this;
  TimedRun slow{.motion = motion.stretched(factor), .s = s, .t = t, .is_fastest = is_fastest};
  for (double& time : slow.t) time *= factor;
  return slow;
}

TimedRun smooth_run(const Trajectory& path, std::span<const AxisLimits> limits,
                    const SpeedAlongPath& fastest, int cells, std::span<const SpeedZone> zones,
                    std::span<const Segment> travel) {
  return smooth_run(Course{path, limits, zones, travel}, fastest, cells);
}

TimedRun smooth_run(const Course& course, const SpeedAlongPath& fastest, int cells) {
  for (const AxisLimits& l : course.limits) check_positive("jerk limit", l.jerk);
  return Run(course, fastest, cells).find();
}

}  // namespace armlet
