#pragma once
// The moves of a `path`: collected when they are called, planned as one motion at its end (language
// reference, 13.3).

#include <optional>
#include <vector>

#include "moves/moves.hpp"

namespace armlet::bind {

// The target of a joint move in a path: joint values, or a position with a seed for its solution.
struct JointGoal {
  std::optional<Eigen::VectorXd> q{};
  Eigen::VectorXd near{};  // empty: the end of the move before
  std::string planner{};
};

// A move as it was called; its target and the position `via` are in the world.
struct CollectedMove {
  MoveCall call;
  PosC target;                        // of joint values: the pose of the tool there
  std::optional<JointGoal> joints{};  // of a joint move
  std::optional<Eigen::Vector3d> p_world_via{};
  std::optional<double> blend{};
  std::optional<double> speed{};  // m/s
  std::optional<double> accel{};  // m/s^2
};

// blend, speed  for moves without values of their own.
// time          of the whole path, and the call that gave it.
struct CollectedPath {
  double blend = 0.0;
  std::optional<double> speed{};
  std::optional<double> time{};
  CallPlace time_place{};
  std::vector<CollectedMove> moves{};
};

// Adds a move to the path around it; the result is a move that was not executed.
Started collect(Vm& vm, MoveCall call, const PosC& target, const MoveSettings& settings,
                std::optional<Eigen::Vector3d> p_world_via = {});

// Adds a joint move to the path around it; the target is used only for a position.
Started collect_joints(Vm& vm, MoveCall call, const PosC& target, JointGoal goal,
                       const MoveSettings& settings);

// Checks a blend length: the largest distance from its target at which a corner begins, m.
Answer<void> check_blend_length(Vm& vm, double blend, CallPart part);

// Plans and starts the whole path.
Started make_path(Vm& vm, const CollectedPath& path);

}  // namespace armlet::bind
