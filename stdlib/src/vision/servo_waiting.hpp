#pragma once
// Visual servoing on the clock of a cell.

#include <cstdint>

#include "armlet/camera/visual_servo.hpp"
#include "motion/moves.hpp"
#include "vision/cameras.hpp"

namespace armlet::bind {

// What a call of visualServo says beside what the loop itself takes.
//
// features   fn(image) -> matrix, or with `expected` fn(image, matrix) -> matrix, whose second
//            argument is where the points are expected.
// start      where they are expected in the first picture.
// period_ns  from picture to picture.
struct ServoCall {
  int robot = 0;
  CameraRef camera{};
  Obj* features = nullptr;
  bool expected = false;
  PlanePoints start = PlanePoints(0, 2);
  std::int64_t period_ns = 0;
};

// R0690: "this cannot be servoed: ...".
Failed fail_servo(Vm& vm, std::string_view clause, int parameter = -1, std::string fix = {});

// The joints of an arm as the loop takes them.
[[nodiscard]] ServoArm servo_arm(const Robot& robot, const Eigen::Isometry3d& T_tool_camera);

// Takes the first picture and moves the arm until the loop ends; gives a ServoRun.
Started start_servo(Vm& vm, const ServoCall& call, VisualServo servo);

}  // namespace armlet::bind
