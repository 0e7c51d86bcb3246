// Collision-free motions of a robot of a cell, found by path search.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/planning/way_search.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

// goals  n joint values each, in order of preference; the tool has the same pose in all of them.
// model  with the tool point and the limits of this motion; null: the model of the robot in the
//        cell.
// time   whole duration, s; nothing: as fast as the joints allow.
// speed  fraction of the joint limits, above 0 and at most 1; not together with time.
struct WayAroundRequest {
  int robot = 0;
  std::vector<Eigen::VectorXd> goals{};
  std::shared_ptr<const Robot> model{};
  std::optional<double> time{};
  double speed = 1.0;
  WayOptions search{};
};

// Two bodies that overlap at the start or the goal, and the depth, m; or that blocked the search,
// and their share of all blocked checks.
struct BlockingBodies {
  CellBody body{};   // of the robot, or what it carries
  CellBody other{};  // an object, or a part of another or the same robot
  double depth = 0.0;
  double share = 0.0;
};

// The result of the search.
//
// way       corners of the path, if one was found.
// motion    verified and certified; empty if there is no path, or the time is too short.
// times     at which the motion reaches or passes each corner after the first, s.
// length    of the path of the tool point, m.
// blocking  deepest or most frequent first; each pair of bodies once.
// met       collisions with robots that are moving now, which the search cannot avoid; then there
//           is no motion.
struct WayAround {
  Way way{};
  MotionPlan motion{};
  std::vector<double> times{};
  double length = 0.0;
  std::vector<BlockingBodies> blocking{};
  std::vector<CellCollision> met{};

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Searches a path for the robot, with all that it carries, from its present joint values, and plans
// a motion along it. Corners are rounded as far as clearances are kept, speeds, accelerations and
// jerks stay within their limits, and the whole motion is certified: check_clearances shows that it
// keeps the clearances of the search, find_collisions that it collides with nothing. Clearances are
// kept from other robots where their motions end; collisions are checked with their motions.
//
// throws  ArgumentError as search_way and plan_path.
WayAround find_way_around(const Cell& cell, const WayAroundRequest& request);

}  // namespace armlet
