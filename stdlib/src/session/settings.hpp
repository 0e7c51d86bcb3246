#pragma once
// The settings of the `with` blocks around a call (language reference, section 9): run-time state
// of a task, so functions called inside a block obey it too.

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "armlet/interpreter/engine.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Where targets are read: a fixed frame, or that of an object or a frame with a name.
using Frame = std::variant<Eigen::Isometry3d, ObjectRef, FrameRef>;

struct CollectedPath;

// What a line does where it comes close to a singularity: goes as slowly all along as the joints
// need it there, slows down only there, or leaves the line a little.
enum class Track { kExact, kSlow, kDamped };

// What becomes of a move that asks motors for more than they give; kLimit: it is made so that it
// does not.
enum class TorqueCheck { kReport, kError, kIgnore, kLimit };

// What becomes of a move that runs into something.
enum class CollisionCheck { kReport, kError, kIgnore };

// What becomes of a move that would take joints beyond their limits: it is refused; it goes as far
// and as fast as they allow; it is made, with advice.
enum class LimitCheck { kError, kClamp, kWarn };

// speed, accel   fractions of the joint limits, for moves that do not say how fast.
// T_flange_tool  the point that moves, instead of the robot's own.
// avoid          moves of the joints go around what is in their way.
// path           where moves are collected instead of made; null: outside of any path.
struct BlockSettings {
  std::shared_ptr<const BlockSettings> outer{};  // never changes; shared by tasks started inside
  double speed = 1.0;
  double accel = 1.0;
  std::optional<Eigen::Isometry3d> T_flange_tool{};
  std::optional<Frame> frame{};
  std::shared_ptr<CollectedPath> path{};
  Track track = Track::kExact;
  TorqueCheck torques = TorqueCheck::kReport;
  CollisionCheck collisions = CollisionCheck::kReport;
  LimitCheck limits = LimitCheck::kError;
  bool avoid = false;
};

// Those of the running task.
[[nodiscard]] BlockSettings settings_of(Vm& vm);
void replace_settings(Vm& vm, BlockSettings settings);
// A block that begins keeps those around it, and gives them back when it ends.
void open_settings(Vm& vm);
void close_settings(Vm& vm);

}  // namespace armlet::bind
