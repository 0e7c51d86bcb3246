#pragma once
// Visual servoing on the clock of a cell.

#include <cstdint>

#include "armlet/camera/visual_servo.hpp"
#include "moves/moves.hpp"
#include "values/world/cameras.hpp"

namespace armlet::bind {

// The arguments of visualServo that the control loop does not contain.
//
// features   fn(image) -> matrix, or with `expected` fn(image, matrix) -> matrix, whose second
//            argument holds the expected points.
// start      the expected points in the first picture.
// period_ns  time between two pictures.
struct ServoCall {
  int robot = 0;
  CameraRef camera{};
  Obj* features = nullptr;
  bool expected = false;
  PlanePoints start = PlanePoints(0, 2);
  std::int64_t period_ns = 0;
};

// R0690: "this cannot be servoed: ...".
Failed fail_servo(Vm& vm, std::string_view clause, CallPart part = {}, std::string fix = {});

// The joints of an arm in the form of the control loop.
[[nodiscard]] ServoArm servo_arm(const Robot& robot, const Eigen::Isometry3d& T_tool_camera);

// Takes the first picture and moves the arm until the loop ends; returns a ServoRun.
Started start_servo(Vm& vm, const ServoCall& call, VisualServo servo);

}  // namespace armlet::bind
