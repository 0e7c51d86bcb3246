#include "armlet/cell/way_around.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/trajectory/cartesian_path.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;

// m, largest distance from a corner at which rounding may begin
constexpr double kWidest = 0.1;
constexpr double kTightest = 0.002;             // m; the motion stops at sharper corners
constexpr std::uint64_t kPlanCost = 5'000'000;  // operations of one planning

// The scene of a motion depends on its ends only.
Trajectory between(const VectorXd& q0, const VectorXd& q1) {
  std::vector<JointPath> joints;
  for (Eigen::Index i = 0; i < q0.size(); ++i) {
    joints.push_back(
        {.segments = {{.start = 0.0, .duration = 1.0, .degree = 1, .c = {q0[i], q1[i] - q0[i]}}},
         .q_end = q1[i]});
  }
  return {std::move(joints), 1.0};
}

bool is_same_body(const CellBody& a, const CellBody& b) {
  return a.robot == b.robot && a.object == b.object && a.frame == b.frame && a.role == b.role;
}

void add(std::vector<BlockingBodies>& all, const std::pair<CellBody, CellBody>& pair, double depth,
         double share) {
  for (BlockingBodies& each : all) {
    if (!is_same_body(each.body, pair.first) || !is_same_body(each.other, pair.second)) continue;
    each.depth = std::max(each.depth, depth);
    each.share += share;
    return;
  }
  all.push_back({.body = pair.first, .other = pair.second, .depth = depth, .share = share});
}

std::vector<BlockingBodies> blocking_of(const Way& way, const ComparedBodies& compared) {
  std::vector<BlockingBodies> all;
  for (const Overlap& each : way.overlaps) add(all, compared.pairs[each.pair], each.depth, 0.0);
  std::uint64_t whole = 0;
  for (const InTheWay& each : way.in_the_way) whole += each.times;
  for (const InTheWay& each : way.in_the_way) {
    add(all, compared.pairs[each.pair], 0.0,
        static_cast<double>(each.times) / static_cast<double>(whole));
  }
  std::ranges::stable_sort(
      all, [](const BlockingBodies& a, const BlockingBodies& b) { return a.share > b.share; });
  return all;
}

// The motion along a path. A corner at which a collision occurs, or a clearance is not kept, is
// rounded less, and finally not at all: the joints then follow the segments that the search has
// certified.
//
// scene  in which the path was searched.
class AlongWay {
 public:
  AlongWay(const Cell& cell, const WayAroundRequest& request, const Robot& model, const Way& way,
           MotionScene scene)
      : cell_(cell), request_(request), model_(model), scene_(std::move(scene)) {
    keep_clearances(way);
    move_.q0 = way.points.front();
    move_.time = request.time;
    move_.speed = request.speed;
    for (std::size_t k = 1; k < way.points.size(); ++k)
      move_.points.push_back({.q = way.points[k], .blend = kWidest});
  }

  void plan(WayAround& out) {
    for (;;) {
      checkpoint(kPlanCost * move_.points.size());
      PathPlan plan = plan_path(model_, move_);
      out.length = plan.length;
      out.times = plan.times;
      out.motion = std::move(plan.motion);
      if (!out.motion.ok()) {
        // A rounded corner may exceed limits that its ends keep.
        if (!out.motion.outside.empty() && tighten_all()) continue;
        return;
      }
      scene_.arms[0].motion = &*out.motion.trajectory;
      scene_.duration = out.motion.trajectory->duration();
      std::vector<double> where;
      for (const Nearing& each : check_clearances(scene_, kept_)) where.push_back(each.t);
      if (where.empty()) {
        out.met = find_collisions(cell_, request_.robot, *out.motion.trajectory);
        if (out.met.empty()) return;
        for (const CellCollision& each : out.met)
          where.insert(where.end(), {each.t, each.t_deepest});
      }
      if (!tighten(out.times, where)) {
        out.motion.trajectory.reset();
        return;
      }
    }
  }

 private:
  // Sets the clearances of the pairs. Moving robots count as at rest at the ends of their motions:
  // while they move, only collisions with them are checked.
  void keep_clearances(const Way& way) {
    std::vector<CheckedPair> pairs;
    for (std::size_t i = 0; i < scene_.pairs.size(); ++i) {
      if (way.kept[i] <= 0.0 || scene_.pairs[i].b.arm > 0) continue;
      pairs.push_back(scene_.pairs[i]);
      pairs.back().leaving = false;
      kept_.push_back(way.kept[i]);
    }
    scene_.pairs = std::move(pairs);
  }

  // Rounds a corner less; false if the motion stops there already.
  bool tighten_at(std::size_t k) {
    double& blend = move_.points[k].blend;
    if (blend == 0.0) return false;
    blend = blend < 2.0 * kTightest ? 0.0 : 0.5 * blend;
    return true;
  }

  bool tighten_all() {
    bool any = false;
    for (std::size_t k = 0; k + 1 < move_.points.size(); ++k) any = tighten_at(k) || any;
    return any;
  }

  // Rounds the corners less that are nearest in time to the given instants, each once; other
  // corners only if the motion stops at these.
  bool tighten(const std::vector<double>& times, const std::vector<double>& where) {
    std::vector<bool> at(times.size(), false);
    for (const double t : where) {
      std::size_t nearest = 0;
      for (std::size_t k = 1; k + 1 < times.size(); ++k) {
        if (std::abs(times[k] - t) < std::abs(times[nearest] - t)) nearest = k;
      }
      if (times.size() > 1) at[nearest] = true;
    }
    bool any = false;
    for (std::size_t k = 0; k < at.size(); ++k) any = (at[k] && tighten_at(k)) || any;
    return any || tighten_all();
  }

  const Cell& cell_;
  const WayAroundRequest& request_;
  const Robot& model_;
  MotionScene scene_;
  std::vector<double> kept_;  // of each pair of scene_
  PathMove move_;
};

}  // namespace

WayAround find_way_around(const Cell& cell, const WayAroundRequest& request) {
  const CellRobot& arm = cell.robot(request.robot);
  WayAround out;
  const Trajectory ends = between(arm.q, request.goals.empty() ? arm.q : request.goals.front());
  ComparedBodies compared = compared_bodies(cell, request.robot, ends);
  out.way = search_way(compared.scene, arm.q, request.goals, request.search);
  out.blocking = blocking_of(out.way, compared);
  if (!out.way.ok()) return out;
  const Robot& model = request.model != nullptr ? *request.model : *arm.model;
  AlongWay(cell, request, model, out.way, std::move(compared.scene)).plan(out);
  return out;
}

}  // namespace armlet
