#pragma once
// The settings of the `with` blocks around a call (language reference, section 9): state of a task
// at run time, so that they also apply to functions called inside a block.

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "armlet/control/policies.hpp"
#include "armlet/interpreter/engine.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// The frame of targets: a fixed frame, or that of an object or a frame with a name.
using Frame = std::variant<Eigen::Isometry3d, ObjectRef, FrameRef>;

struct CollectedPath;

// speed, accel   fractions of the joint limits, for moves without a speed of their own.
// T_flange_tool  the tool point, instead of the robot's own.
// avoid          joint moves go around obstacles.
// path           collects moves instead of executing them; null: outside of any path.
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

// The settings of the running task.
[[nodiscard]] BlockSettings settings_of(Vm& vm);
void replace_settings(Vm& vm, BlockSettings settings);
// open_settings stores the present settings at the start of a block; close_settings restores them.
void open_settings(Vm& vm);
void close_settings(Vm& vm);

}  // namespace armlet::bind
