#pragma once
// The moves of a `path`: collected where they are called, made as one motion at its end (language
// reference, 13.3).

#include <optional>
#include <vector>

#include "motion/moves.hpp"

namespace armlet::bind {

// The planner whose way is a straight line of the joints.
inline constexpr std::string_view kPathPlanner = "Syn";

// What a move of the joints in a path leads to: joint values, or a position to be solved near some.
struct JointGoal {
  std::optional<Eigen::VectorXd> q{};
  Eigen::VectorXd near{};  // empty: where the move before ends
  std::string planner{};
};

// A move as it was called; its target and the position on the way are in the world.
struct CollectedMove {
  MoveCall call;
  PosC target;                        // of joint values, where they have the hand
  std::optional<JointGoal> joints{};  // of a move of the joints
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
Started collect(Vm& vm, MoveCall call, const PosC& target, const MoveSettings& settings,
                std::optional<Eigen::Vector3d> p_world_via = {});

// The same for a move of the joints; of the target only a position counts.
Started collect_joints(Vm& vm, MoveCall call, const PosC& target, JointGoal goal,
                       const MoveSettings& settings);

// Checks how far from their places corners may begin, m.
Answer<void> check_blend_length(Vm& vm, double blend, int parameter);

// Plans and starts the whole path.
Started make_path(Vm& vm, const CollectedPath& path);

}  // namespace armlet::bind
