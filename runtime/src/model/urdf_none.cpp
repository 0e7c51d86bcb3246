// Replaces urdf_read.cpp where urdfdom is not available.

#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"

namespace armlet {

Result<Mechanism> read_urdf(std::string_view, const UrdfOptions&) {
  return Error{
      "urdf",
      "robot descriptions are read by the library urdfdom, which this build of Armlet does "
      "not have; the armlet command has it, and rows of Denavit-Hartenberg parameters need "
      "no library"};
}

Result<std::vector<UrdfLink>> read_urdf_scene(std::string_view) { return read_urdf({}).error(); }

Result<RobotSpec> serial_arm_of_urdf(std::string_view, const UrdfOptions&, std::string_view) {
  return read_urdf({}).error();
}

}  // namespace armlet
