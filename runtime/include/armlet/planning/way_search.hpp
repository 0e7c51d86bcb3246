// Path search: paths of an arm around obstacles.
#pragma once

#include <cstdint>
#include <vector>

#include "armlet/collision/segment_check.hpp"

namespace armlet {

// Whether path search is available: the library of sampling planners was found. Straight segments
// are checked without it.
[[nodiscard]] bool can_search_ways();

// clearance   from all bodies, m; less from bodies that are nearer at an end (SegmentCheck).
// iterations  largest number of search steps.
// shortcuts   number of shortcuts that are tried on the path.
struct WayOptions {
  double clearance = 0.005;
  int iterations = 20'000;
  int shortcuts = 200;
};

// kFound          `points` is the path.
// kStartCollides  `overlaps` are those at the start.
// kGoalCollides   every goal collides; `overlaps` are those of the first one.
// kNotFound       no path was found within the iterations.
// kCannotSearch   no goal can be reached straight, and can_search_ways() is false.
enum class WayStatus { kFound, kStartCollides, kGoalCollides, kNotFound, kCannotSearch };

// How often a pair of bodies blocked the search.
struct InTheWay {
  std::size_t pair = 0;  // of MotionScene::pairs
  std::uint64_t times = 0;
};

// points      joint values from the start to one of the goals; straight segments between them are
//             free.
// goal        index of that goal.
// iterations  that were used.
// in_the_way  most frequent first.
// kept        of each pair of the scene, as SegmentCheck::kept.
struct Way {
  WayStatus status = WayStatus::kNotFound;
  std::vector<Eigen::VectorXd> points{};
  int goal = -1;
  int iterations = 0;
  std::vector<Overlap> overlaps{};
  std::vector<InTheWay> in_the_way{};
  std::vector<double> kept{};

  [[nodiscard]] bool ok() const { return status == WayStatus::kFound; }
};

// Searches a path for the first arm of a scene, within its joint limits: straight if a goal can be
// reached so, otherwise by RRT-Connect, shortened by random shortcuts. Every segment is certified
// by SegmentCheck. The same bits on every run: the random generator has a fixed seed, and the
// search ends after a number of steps. It stops at checkpoints (core/checkpoint.hpp).
//
// start, goals  n joint values each, goals in order of preference, at least one.
// throws        ArgumentError for sizes, numbers that are not finite, no goal, a clearance or
//               numbers of iterations and shortcuts that are not above zero (shortcuts: below it).
// source        R. Geraerts, M. H. Overmars, Creating high-quality paths for motion planning, Int.
//               J. Robotics Research 26, 2007 (shortcuts); of the search, see runtime/src/planning.
Way search_way(const MotionScene& scene, const Eigen::VectorXd& start,
               const std::vector<Eigen::VectorXd>& goals, const WayOptions& options = {});

}  // namespace armlet
