#include "armlet/trajectory/cartesian_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/trajectory/motion_forces.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/timing/smooth_run.hpp"
#include "trajectory/tool/joined_path.hpp"
#include "trajectory/tool/line_samples.hpp"
#include "trajectory/tool/tool_travel.hpp"

namespace armlet {
namespace {

constexpr int kIntervals = 200;      // of the grid for the speeds
constexpr int kCells = 64;           // number of pieces of a jerk-limited speed,
constexpr int kCellsPerCorner = 32;  // and additional ones for each corner
constexpr int kCornerChords = 64;    // for the length of a corner
// factor for the number of samples where joint directions change sharply
constexpr int kFiner = 4;
constexpr double kShortestBlend = 1e-6;  // m; the tool stops at sharper corners
constexpr double kNoLength = 1e-9;       // m

void check_move(const Robot& robot, const PathMove& move) {
  check_size("q0", move.q0.size(), robot.n());
  check_finite("q0", move.q0);
  if (move.points.empty()) throw ArgumentError("A path needs at least one place.");
  for (const PathPoint& point : move.points) {
    check_pose("T_world_tool", point.T_world_tool);
    if (point.q) {
      check_size("q", point.q->size(), robot.n());
      check_finite("q", *point.q);
    }
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

// The segment that leads to a point, shortened by its corners: a piece of a tool curve, or a
// straight line in joint space to q_goal.
struct Leg {
  CurvePiece piece{};
  const Eigen::VectorXd* q_goal = nullptr;
  int point = 0;
  double speed = INFINITY;  // of the tool point, m/s
  double accel = INFINITY;  // m/s^2
};

// Consecutive segments of one kind: pieces of one tool curve, or one line in joint space. `zones`
// are their speeds, `ends` the positions where each segment ends or its corner has its middle.
struct Part {
  PoseCurve curve{};
  std::vector<SpeedZone> zones{};
  std::vector<Leg> legs{};
  std::vector<double> ends{};
  double travel = 0.0;  // of the tool point, m; of a curve

  [[nodiscard]] bool is_joint_line() const { return legs.back().q_goal != nullptr; }
};

// The path from one stop to the next, as one joint path with the speeds and ends of its parts.
struct Stretch {
  Trajectory path{};
  std::vector<SpeedZone> zones{};
  std::vector<double> ends{};  // of each leg
  int corners = 0;
  double travel = 0.0;
  TimedRun smooth{};  // within all limits; empty where joints nearly jump
};

void add_zone(std::vector<SpeedZone>& zones, double from, double to, double speed, double accel) {
  if (std::isfinite(speed) || std::isfinite(accel)) zones.push_back({from, to, speed, accel});
}

// The speed limit of each half of a corner is that of its own segment. With the lower limit on the
// whole corner, a wider corner would take longer although its path is shorter.
void add_corner_zones(std::vector<SpeedZone>& zones, double from, double to, const Leg& before,
                      const Leg& behind) {
  const double middle = 0.5 * (from + to);
  add_zone(zones, from, middle, before.speed, before.accel);
  add_zone(zones, middle, to, behind.speed, behind.accel);
}

class PathPlanner {
 public:
  PathPlanner(const Robot& robot, const PathMove& move)
      : robot_(robot), move_(move), jerk_(move.jerk) {
    for (int i = 0; i < robot.n(); ++i) {
      limits_.push_back({.speed = move.speed * robot.max_speed()[i],
                         .acceleration = move.speed * move.speed * robot.max_accel()[i],
                         .jerk = move.speed * move.speed * move.speed * robot.max_jerk()[i]});
      driven_.push_back(limits_.back());
      if (move.motors != nullptr && std::isfinite(move.motors->joint(i).max_effort))
        driven_.back().acceleration = INFINITY;
    }
  }

  PathPlan plan() {
    if (!lay_legs()) return std::move(plan_);
    plan_.missed.assign(move_.points.size(), 0.0);
    plan_.times.assign(move_.points.size(), -1.0);
    std::optional<Trajectory> whole;
    Eigen::VectorXd q = move_.q0;
    for (std::size_t first = 0; first < legs_.size();) {
      const std::vector<Part> parts = parts_from(first);
      const auto stretch = lay_smooth(parts, q);
      if (!stretch) return std::move(plan_);
      const Trajectory motion = run(*stretch, first, whole ? whole->duration() : 0.0);
      first += stretch->ends.size();
      plan_.length += stretch->travel;
      q = motion.end();
      whole = whole ? whole->then(motion) : motion;
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

  // Makes full segments from pose to pose; a pose equal to the one before is left out.
  bool lay_legs() {
    Eigen::Isometry3d T = forward(robot_, move_.q0);
    for (std::size_t k = 0; k < move_.points.size(); ++k) {
      const PathPoint& point = move_.points[k];
      Leg leg{.point = static_cast<int>(k),
              .speed = point.tool_speed.value_or(INFINITY),
              .accel = point.tool_accel.value_or(INFINITY)};
      if (point.q) {
        leg.q_goal = &*point.q;
        legs_.push_back(leg);
        T = forward(robot_, *point.q);
        continue;
      }
      std::optional<CurvePiece> piece = straight_piece(T, point.T_world_tool);
      if (point.p_world_via) piece = piece_over(T, *point.p_world_via, point.T_world_tool);
      if (!piece) {
        const auto why =
            no_circle_over(T.translation(), *point.p_world_via, point.T_world_tool.translation());
        return fail({.kind = LineFaultKind::kNoArc,
                     .T_world_tool = point.T_world_tool,
                     .no_circle = why.value_or(NoCircle::kOnOneLine)},
                    leg.point);
      }
      leg.piece = *piece;
      if (piece->length > kNoLength) legs_.push_back(leg);
      T = point.T_world_tool;
    }
    return true;
  }

  [[nodiscard]] double blend_behind(const Leg& leg) const {
    return move_.points[static_cast<std::size_t>(leg.point)].blend;
  }

  // The parts from this segment on up to the next pose at which the tool stops.
  std::vector<Part> parts_from(std::size_t first) {
    std::vector<Part> parts;
    for (std::size_t k = first;; ++k) {
      Leg& leg = legs_[k];
      const bool stops = k + 1 == legs_.size() || blend_behind(leg) < kShortestBlend;
      const bool curve_goes_on = !stops && !leg.q_goal && !legs_[k + 1].q_goal;
      std::optional<CurveCorner> corner;
      if (curve_goes_on) corner = cut_corner(leg.piece, legs_[k + 1].piece, blend_behind(leg));
      if (k == first || leg.q_goal || legs_[k - 1].q_goal) parts.emplace_back();
      add_leg(parts.back(), leg);
      if (corner) add_corner(parts.back(), *corner, legs_[k + 1]);
      if (stops) return parts;
    }
  }

  static void add_leg(Part& part, const Leg& leg) {
    part.legs.push_back(leg);
    if (leg.q_goal) return;
    const double from = part.curve.length();
    part.curve.add(leg.piece);
    part.travel += (leg.piece.to - leg.piece.from) * leg.piece.travel();
    add_zone(part.zones, from, part.curve.length(), leg.speed, leg.accel);
    part.ends.push_back(part.curve.length());
  }

  void add_corner(Part& part, const CurveCorner& corner, const Leg& next) {
    const Leg& leg = part.legs.back();
    const double from = part.curve.length();
    part.curve.add(corner);
    part.travel += chord_length(corner, kCornerChords);
    part.ends.back() = 0.5 * (from + part.curve.length());
    add_corner_zones(part.zones, from, part.curve.length(), leg, next);
    plan_.missed[static_cast<std::size_t>(leg.point)] =
        (corner.middle().translation() - corner.T_corner.translation()).norm();
  }

  // The joint path of a part, as a function of its length, m.
  std::optional<Trajectory> follow(const Part& part, const Eigen::VectorXd& q0) {
    if (part.is_joint_line()) return joint_line(robot_, q0, *part.legs.back().q_goal);
    LineSamples samples(robot_, q0, part.curve, move_.task, CurveLaw::kEven);
    ways_ = std::max(ways_, samples.ways());
    if (!samples.follow(way_)) {
      fail_on(part, samples.fault());
      return std::nullopt;
    }
    return samples.motion().stretched(part.curve.length());
  }

  // The length by which a corner in joint space may shorten one side of it.
  double joint_blend(const Part& part, const Trajectory& path, double blend, bool at_end) const {
    const Leg& leg = at_end ? part.legs.back() : part.legs.front();
    if (!leg.q_goal) {
      const double measure = leg.piece.measure();
      return std::min(blend, 0.5 * measure) * (leg.piece.length / measure);
    }
    const double r =
        at_end ? blend_at_end(robot_, path, blend) : blend_at_start(robot_, path, blend);
    return std::min(r, 0.5 * path.duration());
  }

  // Samples it so that the joint path is smooth, if possible; empty if the curve cannot be
  // followed.
  std::optional<Stretch> lay_smooth(const std::vector<Part>& parts, const Eigen::VectorXd& q0) {
    std::optional<Stretch> first;
    PathPlan plan_of_first;
    for (way_ = 0, ways_ = 1; way_ < ways_; ++way_) {
      auto stretch = lay(parts, q0);
      if (!stretch) break;
      if (jerk_ == Jerk::kFree || !(stretch->path.duration() > 0.0)) return stretch;
      stretch->smooth = smooth_run_on(*stretch);
      if (!stretch->smooth.s.empty()) return stretch;
      if (first) continue;
      first = std::move(stretch);
      plan_of_first = plan_;
    }
    if (first) plan_ = std::move(plan_of_first);
    return first;
  }

  // The joint path of the parts; empty if the curve cannot be followed, and the fault is set.
  std::optional<Stretch> lay(const std::vector<Part>& parts, const Eigen::VectorXd& q0) {
    std::vector<Trajectory> paths;
    std::vector<const Part*> moving;  // parts along which joints move
    for (const Part& part : parts) {
      auto path = follow(part, paths.empty() ? q0 : paths.back().end());
      if (!path) return std::nullopt;
      if (path->duration() <= kNoLength) continue;
      paths.push_back(*std::move(path));
      moving.push_back(&part);
    }
    if (paths.size() == 1 && !moving.front()->is_joint_line()) {
      const Part& part = *moving.front();
      return Stretch{std::move(paths.front()), part.zones, part.ends,
                     static_cast<int>(part.legs.size()) - 1, part.travel};
    }
    return joined(parts, moving, paths, q0);
  }

  Stretch joined(const std::vector<Part>& parts, const std::vector<const Part*>& moving,
                 const std::vector<Trajectory>& paths, const Eigen::VectorXd& q0) {
    Stretch stretch;
    std::vector<double> blends;
    for (std::size_t k = 0; k + 1 < paths.size(); ++k) {
      const double blend = blend_behind(moving[k]->legs.back());
      blends.push_back(std::min(joint_blend(*moving[k], paths[k], blend, true),
                                joint_blend(*moving[k + 1], paths[k + 1], blend, false)));
    }
    const JoinedPath whole = join_rounded(paths, blends);
    std::size_t k = 0;
    for (const Part& part : parts) {
      const bool moves = k < moving.size() && moving[k] == &part;
      if (!moves) {
        stretch.ends.push_back(stretch.ends.empty() ? 0.0 : stretch.ends.back());
        continue;
      }
      place_part(stretch, part, whole, k);
      if (++k < moving.size()) place_corner(stretch, part, *moving[k], whole, k - 1);
    }
    stretch.path = paths.empty() ? Trajectory::at_rest(q0, 0.0) : whole.q;
    if (!paths.empty()) {
      const Segment last = tool_travel(robot_, stretch.path).back();
      stretch.travel = last.value(last.duration);
    }
    return stretch;
  }

  static void place_part(Stretch& stretch, const Part& part, const JoinedPath& whole,
                         std::size_t k) {
    for (const SpeedZone& zone : part.zones) {
      const double from = whole.position(k, zone.from), to = whole.position(k, zone.to);
      if (to > from) add_zone(stretch.zones, from, to, zone.speed, zone.acceleration);
    }
    stretch.corners += static_cast<int>(part.legs.size());
    if (!part.is_joint_line()) {
      for (const double end : part.ends) stretch.ends.push_back(whole.position(k, end));
      return;
    }
    const Leg& leg = part.legs.back();
    add_zone(stretch.zones, whole.from[k], whole.to[k], leg.speed, leg.accel);
    stretch.ends.push_back(whole.to[k]);
  }

  // Sets the position of the corner after a part that is rounded in joint space.
  void place_corner(Stretch& stretch, const Part& part, const Part& next, const JoinedPath& whole,
                    std::size_t k) {
    const Leg &before = part.legs.back(), &behind = next.legs.front();
    const double from = whole.to[k], to = whole.from[k + 1];
    add_corner_zones(stretch.zones, from, to, before, behind);
    stretch.ends.back() = 0.5 * (from + to);
    Eigen::VectorXd q(robot_.n()), qd(robot_.n()), qdd(robot_.n());
    whole.q.sample(stretch.ends.back(), q, qd, qdd);
    const PathPoint& point = move_.points[static_cast<std::size_t>(before.point)];
    const Eigen::Isometry3d T = point.q ? forward(robot_, *point.q) : point.T_world_tool;
    plan_.missed[static_cast<std::size_t>(before.point)] =
        (forward(robot_, q).translation() - T.translation()).norm();
  }

  // Executes the stretch, which begins with segment `first`, from the time `start`.
  Trajectory run(const Stretch& stretch, std::size_t first, double start) {
    TimedRun run{.motion = stretch.path, .s = {0.0}, .t = {0.0}};
    if (stretch.path.duration() > 0.0) {
      run = run_on(stretch);
      run = run.stretched(std::max(1.0, tool_excess(robot_, run, stretch.zones)));
    }
    for (std::size_t k = 0; k < stretch.ends.size(); ++k) {
      plan_.times[static_cast<std::size_t>(legs_[first + k].point)] =
          start + run.time_at(stretch.ends[k]);
    }
    return std::move(run.motion);
  }

  // The shorter of the motions with acceleration limits and with force limits, if the latter apply.
  TimedRun smooth_run_on(const Stretch& stretch) const {
    const std::vector<Segment> travel = travel_of(stretch);
    const Course course{stretch.path, limits_, stretch.zones, travel};
    TimedRun run = smooth_on(course, stretch.corners);
    if (move_.motors == nullptr) return run;
    run = slowed(std::move(run));
    const Course by_motors{stretch.path, driven_,      stretch.zones,
                           travel,       move_.motors, move_.speed * move_.speed};
    TimedRun strong = slowed(smooth_on(by_motors, stretch.corners));
    const bool shorter =
        !strong.s.empty() && (run.s.empty() || strong.motion.duration() < run.motion.duration());
    return shorter ? strong : run;
  }

  static TimedRun smooth_on(const Course& course, int corners) {
    const auto speed = fastest_along(course, kIntervals);
    if (!speed) return {};
    const int cells = kCells + kCellsPerCorner * corners;
    TimedRun run = smooth_run(course, *speed, cells);
    if (!run.s.empty() && run.is_fastest) return run;
    TimedRun finer = smooth_run(course, *speed, kFiner * cells);
    const bool shorter =
        !finer.s.empty() && (run.s.empty() || finer.motion.duration() < run.motion.duration());
    return shorter ? finer : run;
  }

  // Slows the motion down until the motors suffice, if they can.
  [[nodiscard]] TimedRun slowed(TimedRun run) const {
    if (run.s.empty()) return run;
    const double slower = motion_forces(*move_.motors, run.motion).slower;
    return std::isfinite(slower) ? run.stretched(std::max(slower, 1.0)) : run;
  }

  TimedRun run_on(const Stretch& stretch) {
    if (!stretch.smooth.s.empty()) return stretch.smooth;
    jerk_ = Jerk::kFree;
    FastestRun fastest =
        fastest_run(stretch.path, limits_, kIntervals, stretch.zones, travel_of(stretch));
    return {.motion = std::move(fastest.motion), .s = fastest.speed.s, .t = fastest.speed.times()};
  }

  [[nodiscard]] std::vector<Segment> travel_of(const Stretch& stretch) const {
    return stretch.zones.empty() ? std::vector<Segment>() : tool_travel(robot_, stretch.path);
  }

  // A corner shortens both segments by its length.
  void fail_on(const Part& part, LineFault fault) {
    double s = fault.fraction * part.curve.length();
    std::size_t k = 0;
    for (; k + 1 < part.legs.size() && s >= part.legs[k].piece.length; ++k)
      s -= part.legs[k].piece.length;
    fault.fraction = std::min(s / part.legs[k].piece.length, 1.0);
    fail(std::move(fault), part.legs[k].point);
  }

  void finish(Trajectory fastest) {
    fill_times();
    const double least = fastest.duration();
    if (!move_.time || least == 0.0) {
      plan_.motion = verify(robot_, std::move(fastest), true, jerk_, move_.motors);
      return;
    }
    if (*move_.time < least * (1.0 - 1e-9)) {
      plan_.motion.too_fast = least_time(robot_, fastest, jerk_, move_.motors);
      plan_.motion.too_fast->given = *move_.time;
      plan_.motion.too_fast->least_time = least;
      return;
    }
    for (double& t : plan_.times) t *= *move_.time / least;
    plan_.motion =
        verify(robot_, fastest.stretched(*move_.time / least), true, jerk_, move_.motors);
  }

  // Positions equal to the one before have its time.
  void fill_times() {
    double before = 0.0;
    for (double& t : plan_.times) before = t = std::max(t, before);
  }

  const Robot& robot_;
  const PathMove& move_;
  std::vector<AxisLimits> limits_;
  std::vector<AxisLimits> driven_;  // acceleration limits only of joints without a known motor
  int way_ = 0, ways_ = 1;          // of redundant arms, see LineSamples
  Jerk jerk_;  // of the present motion: where limited jerk would take very long, it is not limited
  std::vector<Leg> legs_;
  PathPlan plan_;
};

}  // namespace

PathPlan plan_path(const Robot& robot, const PathMove& move) {
  check_move(robot, move);
  return PathPlanner(robot, move).plan();
}

}  // namespace armlet
