// Ways of an arm around what stands in its way.
#pragma once

#include <cstdint>
#include <vector>

#include "armlet/collision/segment_check.hpp"

namespace armlet {

// Whether ways can be searched here: the library of sampling planners was found. Straight segments
// are found without it.
[[nodiscard]] bool can_search_ways();

// clearance   that is kept from all bodies, m; less from those that are nearer at an end
//             (SegmentCheck).
// iterations  steps of the search, before it gives up.
// shortcuts   tried on the way that was found.
struct WayOptions {
  double clearance = 0.005;
  int iterations = 20'000;
  int shortcuts = 200;
};

// kFound          points are the way.
// kStartCollides  overlaps tell what of, at the start.
// kGoalCollides   every goal does; overlaps are those of the first one.
// kNotFound       within the iterations.
// kCannotSearch   no goal can be reached straight, and can_search_ways() is false.
enum class WayStatus { kFound, kStartCollides, kGoalCollides, kNotFound, kCannotSearch };

// How often a pair of bodies was in the way.
struct InTheWay {
  std::size_t pair = 0;  // of MotionScene::pairs
  std::uint64_t times = 0;
};

// points      joints from the start to one of the goals; straight segments between them are free.
// goal        which of the goals that is.
// iterations  spent.
// in_the_way  most often first.
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

// Searches a way for the first arm of a scene, within the limits of its joints, by RRT-Connect
// where no goal can be reached straight, and makes it shorter by random shortcuts. Every segment is
// certified by SegmentCheck. The same bits on every run: random numbers have a fixed seed, and the
// search is ended by counting. It stops at checkpoints (core/checkpoint.hpp).
//
// start, goals  n joints each, goals in the order in which they are preferred, at least one.
// throws        ArgumentError for sizes, numbers that are not finite, no goal, a clearance or
//               numbers of iterations and shortcuts that are not above zero (shortcuts: below it).
// source        R. Geraerts, M. H. Overmars, Creating high-quality paths for motion planning, Int.
//               J. Robotics Research 26, 2007 (shortcuts); of the search, see its room.
Way search_way(const MotionScene& scene, const Eigen::VectorXd& start,
               const std::vector<Eigen::VectorXd>& goals, const WayOptions& options = {});

}  // namespace armlet
