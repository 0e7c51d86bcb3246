#pragma once
// The moves of a `path`: collected where they are called, made as one motion at its end (language
// reference, 13.3).

#include <optional>
#include <vector>

#include "moves.hpp"

namespace armlet::bind {

// A move as it was called; its target and the place on the way are in the world.
struct CollectedMove {
  MoveCall call;
  PosC target;
  std::optional<Eigen::Vector3d> p_world_via{};
  std::optional<double> blend{};
  std::optional<double> speed{};  // m/s
  std::optional<double> accel{};  // m/s^2
};

// blend, speed  of moves that have none of their own.
// time          of the whole path, and the call that said so.
struct CollectedPath {
  double blend = 0.0;
  std::optional<double> speed{};
  std::optional<double> time{};
  CallPlace time_place{};
  std::vector<CollectedMove> moves{};
};

// Adds a move to the path around it; its result is a move that was not made.
Signal collect(Vm& vm, Slot* args, MoveCall call, const PosC& target, const MoveSettings& settings,
               std::optional<Eigen::Vector3d> p_world_via = {});

// Checks how far from their places corners may begin, m. False: the failure is set.
[[nodiscard]] bool check_blend_length(Vm& vm, double blend, int parameter);

// Plans and starts the whole path; kPause when the robot is on its way.
Signal make_path(Vm& vm, Slot* args, const CollectedPath& path);

}  // namespace armlet::bind
