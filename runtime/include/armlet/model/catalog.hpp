#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "armlet/model/robot.hpp"

namespace armlet {

// Ready-made arms. Each carries its source, limits, speeds, a home configuration and, where the
// source gives them, masses and motors. Arms of four and more joints carry a parallel gripper whose
// tool point is the end of the last link.
Robot make_planar2();   // two links of 1 m in the vertical x-z plane
Robot make_planar3();   // three links in the horizontal plane
Robot make_rrr3();      // anthropomorphic arm without a wrist
Robot make_scara();     // RRPR, tool pointing down, 400 + 300 mm
Robot make_scorbot();   // Scorbot-ER 4U, five joints
Robot make_puma560();   // with its 0.67183 m pedestal
Robot make_stanford();  // RRPRRR
Robot make_pa10_6();    // Mitsubishi PA-10, six joints
Robot make_pa10();      // Mitsubishi PA-10, seven joints
Robot make_irb120();    // ABB IRB 120-3/0.6
Robot make_ur3();       // Universal Robots
Robot make_ur5();
Robot make_ur10();
Robot make_panda();   // Franka Emika
Robot make_iiwa14();  // KUKA LBR iiwa 14 R820
Robot make_arm7();    // a generic arm of seven joints

// Names that make_robot knows, in the order above.
const std::vector<std::string_view>& catalog_names();

// The arm of that name, or null if there is none. Some have a second name: "rrr3" is
// anthropomorphic, "iiwa" is iiwa14.
// Shared, because cells, planners and recorders may hold the same immutable arm.
std::shared_ptr<const Robot> make_robot(std::string_view name);

}  // namespace armlet
