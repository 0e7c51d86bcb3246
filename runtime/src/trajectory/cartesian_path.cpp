#include "armlet/trajectory/cartesian_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/line_samples.hpp"
#include "trajectory/smooth_run.hpp"
#include "trajectory/tool_travel.hpp"

namespace armlet {
namespace {

constexpr int kIntervals = 200;          // of the grid on which the speeds are found
constexpr int kCells = 64;               // the pieces of a speed that is limited in jerk,
constexpr int kCellsPerCorner = 32;      // and what each corner adds
constexpr double kShortestBlend = 1e-6;  // m; the tool stops at sharper corners
constexpr double kNoLength = 1e-9;       // m

void check_move(const Robot& robot, const PathMove& move) {
  check_size("q0", move.q0.size(), robot.n());
  check_finite("q0", move.q0);
  if (move.points.empty()) throw ArgumentError("A path needs at least one place.");
  for (const PathPoint& point : move.points) {
    check_pose("T_world_tool", point.T_world_tool);
    if (point.p_world_via) check_finite("p_world_via", *point.p_world_via);
    if (point.tool_speed) check_positive("tool_speed", *point.tool_speed);
    if (point.tool_accel) check_positive("tool_accel", *point.tool_accel);
    if (!(std::isfinite(point.blend) && point.blend >= 0.0)) {
      throw ArgumentError(fmt::format("A corner cannot be blended within {} m.", point.blend));
    }
  }
  if (move.time && (!std::isfinite(*move.time) || *move.time < 0.0)) {
    throw ArgumentError(
        fmt::format("The time of a path is {} s; expected 0 s or more.", *move.time));
  }
  if (!(move.speed > 0.0 && move.speed <= 1.0) || (move.time && move.speed != 1.0)) {
    throw ArgumentError(
        fmt::format("The speed of a path is {}; expected a fraction of the joint limits, and not "
                    "together with a time.",
                    move.speed));
  }
}

// A piece that leads to a point, with what its corners take away.
struct Leg {
  CurvePiece piece{};
  int point = 0;
  double speed = 0.0;  // of the tool point, m/s
  double accel = 0.0;  // m/s^2
};

// From one stop to the next, as one curve; `zones` are its speeds, `ends` where each leg ends or
// its corner is halfway.
struct Stretch {
  PoseCurve curve{};
  std::vector<SpeedZone> zones{};
  std::vector<Leg> legs{};
  std::vector<double> ends{};
  double travel = 0.0;  // of the tool point, m
};

void add_zone(Stretch& stretch, double from, double speed, double accel) {
  if (std::isfinite(speed) || std::isfinite(accel))
    stretch.zones.push_back({from, stretch.curve.length(), speed, accel});
}

// The corner at the end of `before`; shortens both.
CurveCorner cut_corner(Leg& before, Leg& behind, double blend) {
  const double r = std::min({blend, 0.5 * before.piece.length, 0.5 * behind.piece.length});
  before.piece.to = 1.0 - r / before.piece.length;
  behind.piece.from = r / behind.piece.length;
  return {.T_corner = before.piece.T_end,
          .before = before.piece.state_from_end(before.piece.to),
          .after = behind.piece.state_from_start(behind.piece.from),
          .length = 2.0 * r};
}

double travel_of(const CurveCorner& corner) {
  constexpr int kChords = 64;
  double travel = 0.0;
  Eigen::Vector3d before = corner.at(0.0).translation();
  for (int k = 1; k <= kChords; ++k) {
    const Eigen::Vector3d place = corner.at(static_cast<double>(k) / kChords).translation();
    travel += (place - before).norm();
    before = place;
  }
  return travel;
}

class PathPlanner {
 public:
  PathPlanner(const Robot& robot, const PathMove& move)
      : robot_(robot), move_(move), jerk_(move.jerk) {
    for (int i = 0; i < robot.n(); ++i) {
      limits_.push_back({.speed = move.speed * robot.max_speed()[i],
                         .acceleration = move.speed * move.speed * robot.max_accel()[i],
                         .jerk = move.speed * move.speed * move.speed * robot.max_jerk()[i]});
    }
  }

  PathPlan plan() {
    if (!lay_legs()) return std::move(plan_);
    plan_.missed.assign(move_.points.size(), 0.0);
    plan_.times.assign(move_.points.size(), -1.0);
    std::optional<Trajectory> whole;
    Eigen::VectorXd q = move_.q0;
    for (std::size_t first = 0; first < legs_.size();) {
      Stretch stretch = stretch_from(first);
      first += stretch.legs.size();
      auto motion = run(stretch, q, whole ? whole->duration() : 0.0);
      if (!motion) return std::move(plan_);
      plan_.length += stretch.travel;
      q = motion->end();
      whole = whole ? whole->then(*motion) : std::move(*motion);
    }
    finish(whole ? *std::move(whole) : Trajectory::at_rest(move_.q0, 0.0));
    return std::move(plan_);
  }

 private:
  bool fail(LineFault fault, int point) {
    plan_.fault = std::move(fault);
    plan_.point = point;
    return false;
  }

  // Full pieces from place to place; places where nothing moves are left out.
  bool lay_legs() {
    Eigen::Isometry3d T = forward(robot_, move_.q0);
    for (std::size_t k = 0; k < move_.points.size(); ++k) {
      const PathPoint& point = move_.points[k];
      const int index = static_cast<int>(k);
      std::optional<CurvePiece> piece = straight_piece(T, point.T_world_tool);
      if (point.p_world_via) piece = piece_over(T, *point.p_world_via, point.T_world_tool);
      if (!piece) {
        return fail({.kind = LineFaultKind::kNoArc, .T_world_tool = point.T_world_tool}, index);
      }
      if (piece->length > kNoLength) {
        legs_.push_back({.piece = *piece,
                         .point = index,
                         .speed = point.tool_speed.value_or(INFINITY),
                         .accel = point.tool_accel.value_or(INFINITY)});
      }
      T = point.T_world_tool;
    }
    return true;
  }

  // From the leg on up to the next place where the tool stops.
  Stretch stretch_from(std::size_t first) {
    Stretch stretch;
    for (std::size_t k = first;; ++k) {
      Leg& leg = legs_[k];
      const double blend = move_.points[static_cast<std::size_t>(leg.point)].blend;
      const bool stops = k + 1 == legs_.size() || blend < kShortestBlend;
      std::optional<CurveCorner> corner;
      if (!stops) corner = cut_corner(leg, legs_[k + 1], blend);
      double from = stretch.curve.length();
      stretch.curve.add(leg.piece);
      stretch.travel += (leg.piece.to - leg.piece.from) * leg.piece.travel();
      add_zone(stretch, from, leg.speed, leg.accel);
      stretch.legs.push_back(leg);
      stretch.ends.push_back(stretch.curve.length());
      if (stops) return stretch;
      from = stretch.curve.length();
      stretch.curve.add(*corner);
      stretch.travel += travel_of(*corner);
      stretch.ends.back() = 0.5 * (from + stretch.curve.length());
      add_zone(stretch, from, std::min(leg.speed, legs_[k + 1].speed),
               std::min(leg.accel, legs_[k + 1].accel));
      plan_.missed[static_cast<std::size_t>(leg.point)] =
          (corner->at(0.5).translation() - corner->T_corner.translation()).norm();
    }
  }

  // `start` is when the stretch begins.
  std::optional<Trajectory> run(const Stretch& stretch, const Eigen::VectorXd& q0, double start) {
    LineSamples samples(robot_, q0, stretch.curve, move_.task, CurveLaw::kEven);
    if (!samples.follow()) {
      fail_on(stretch, samples.fault());
      return std::nullopt;
    }
    // Samples run from 0 to 1, speeds in metres.
    const Trajectory path = samples.motion().stretched(stretch.curve.length());
    TimedRun run = run_on(path, stretch);
    run = run.stretched(std::max(1.0, tool_excess(robot_, run, stretch.zones)));
    for (std::size_t k = 0; k < stretch.legs.size(); ++k) {
      plan_.times[static_cast<std::size_t>(stretch.legs[k].point)] =
          start + run.time_at(stretch.ends[k]);
    }
    return std::move(run.motion);
  }

  TimedRun run_on(const Trajectory& path, const Stretch& stretch) {
    std::vector<Segment> travel;
    if (!stretch.zones.empty()) travel = tool_travel(robot_, path);
    if (jerk_ == Jerk::kLimited) {
      const SpeedAlongPath speed = fastest_along(path, limits_, kIntervals, stretch.zones, travel);
      const int corners = static_cast<int>(stretch.legs.size()) - 1;
      TimedRun run = smooth_run(path, limits_, speed, kCells + kCellsPerCorner * corners,
                                stretch.zones, travel);
      if (!run.s.empty()) return run;
      jerk_ = Jerk::kFree;
    }
    FastestRun fastest = fastest_run(path, limits_, kIntervals, stretch.zones, travel);
    return {.motion = std::move(fastest.motion), .s = fastest.speed.s, .t = fastest.speed.times()};
  }

  // A corner takes from both legs as much as it is long.
  void fail_on(const Stretch& stretch, LineFault fault) {
    double s = fault.fraction * stretch.curve.length();
    std::size_t k = 0;
    for (; k + 1 < stretch.legs.size() && s >= stretch.legs[k].piece.length; ++k)
      s -= stretch.legs[k].piece.length;
    fault.fraction = std::min(s / stretch.legs[k].piece.length, 1.0);
    fail(std::move(fault), stretch.legs[k].point);
  }

  void finish(Trajectory fastest) {
    fill_times();
    const double least = fastest.duration();
    if (!move_.time || least == 0.0) {
      plan_.motion = verify(robot_, std::move(fastest), true, jerk_);
      return;
    }
    if (*move_.time < least * (1.0 - 1e-9)) {
      plan_.motion.too_fast = least_time(robot_, fastest, jerk_);
      plan_.motion.too_fast->given = *move_.time;
      plan_.motion.too_fast->least_time = least;
      return;
    }
    for (double& t : plan_.times) t *= *move_.time / least;
    plan_.motion = verify(robot_, fastest.stretched(*move_.time / least), true, jerk_);
  }

  // Places at which nothing moves are reached with those before them.
  void fill_times() {
    double before = 0.0;
    for (double& t : plan_.times) before = t = std::max(t, before);
  }

  const Robot& robot_;
  const PathMove& move_;
  std::vector<AxisLimits> limits_;
  Jerk jerk_;  // of what is done: where limiting it would take very long, it is not
  std::vector<Leg> legs_;
  PathPlan plan_;
};

}  // namespace

PathPlan plan_path(const Robot& robot, const PathMove& move) {
  check_move(robot, move);
  return PathPlanner(robot, move).plan();
}

}  // namespace armlet
