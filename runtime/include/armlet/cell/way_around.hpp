// Motions of a robot of a cell around what stands in its way.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/planning/way_search.hpp"
#include "armlet/trajectory/verify.hpp"

namespace armlet {

// goals  n joints each, in the order in which they are preferred; the tool is at the same place in
//        all of them.
// model  with the tool point and the limits of this motion; null: the robot as it is in the cell.
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

// Two bodies that overlap at an end, by so much, m; or that were in the way, of all times that
// something was.
struct BlockingBodies {
  CellBody body{};   // of the robot, or what it carries
  CellBody other{};  // an object, another robot's, or of the same robot
  double depth = 0.0;
  double share = 0.0;
};

// What became of it.
//
// way       its corners, if one was found.
// motion    verified and certified; nothing in it if there is no way, or the time is too short.
// times     when it reaches each corner of the way behind the first, or passes by it, s.
// length    that the tool point travels, m.
// blocking  deepest, or most often, first; the same bodies once.
// met       what the motion meets all the same: robots that are moving now. Then there is none.
struct WayAround {
  Way way{};
  MotionPlan motion{};
  std::vector<double> times{};
  double length = 0.0;
  std::vector<BlockingBodies> blocking{};
  std::vector<CellCollision> met{};

  [[nodiscard]] bool ok() const { return motion.ok(); }
};

// Searches a way for the robot, with all that it carries, from where it stands, and plans a motion
// along it: corners are rounded as far as clearances are kept there, speeds, accelerations and
// jerks keep their limits, and the whole is certified: by check_clearances to keep what the search
// keeps, and by find_collisions to meet nothing. Other robots count as standing where their motions
// end for the clearances, and as they move for what is met.
//
// throws  ArgumentError as search_way and plan_path.
WayAround find_way_around(const Cell& cell, const WayAroundRequest& request);

}  // namespace armlet
