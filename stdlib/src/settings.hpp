#pragma once
// The settings of the `with` blocks around a call (language reference, section 9): run-time state
// of a task, so functions called inside a block obey it too.

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "armlet/interpreter/engine.hpp"

namespace armlet::bind {

// Where targets are read: a fixed frame, or the frame of the object of that name.
using Frame = std::variant<Eigen::Isometry3d, std::string>;

// speed, accel   fractions of the joint limits, for moves that do not say how fast.
// T_flange_tool  the point that moves, instead of the robot's own.
struct BlockSettings {
  std::shared_ptr<const BlockSettings> outer{};  // never changes; shared by tasks started inside
  double speed = 1.0;
  double accel = 1.0;
  std::optional<Eigen::Isometry3d> T_flange_tool{};
  std::optional<Frame> frame{};
};

// Those of the running task.
[[nodiscard]] BlockSettings settings_of(Vm& vm);

}  // namespace armlet::bind
