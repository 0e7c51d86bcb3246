#include "armlet/stdlib/install.hpp"

#include <numbers>

#include "bind.hpp"
#include "values.hpp"

namespace armlet {
namespace {

constexpr NativeConstant kConstants[] = {
    {"PI", std::numbers::pi, dims::kNone, "The circumference of a circle over its diameter."},
    {"E", std::numbers::e, dims::kNone, "The base of natural logarithms."},
};

}  // namespace

void install(Engine& engine) {
  for (const HostType* type : {&bind::kPosJ, &bind::kPosC, &bind::kRobot, &bind::kObject,
                               &bind::kShape, &bind::kTool, &bind::kJointRow}) {
    engine.add_type(*type);
  }
  engine.add_record("Move", "reached: bool, stopped: bool, time: time, length: length");
  engine.add_record("Wrench", "x: force, y: force, z: force, mx: torque, my: torque, mz: torque");
  engine.add_constants(kConstants);
  for (const auto functions :
       {bind::math_functions(), bind::list_functions(), bind::text_functions(),
        bind::pose_functions(), bind::model_functions(), bind::robot_functions(),
        bind::motion_functions(), bind::hand_functions(), bind::world_functions(),
        bind::classic_functions(), bind::time_functions()}) {
    engine.add_functions(functions);
  }
}

}  // namespace armlet
