#pragma once
// Prepares the run of a program from the command line: robot, world, packages and meshes.

#include <memory>
#include <string>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/stdlib/session.hpp"
#include "commands.hpp"

namespace armlet::cli {

// The packages of --package NAME=DIR and the folders of ROS_PACKAGE_PATH.
PackageFolders package_folders(const std::vector<std::string>& named);

// The session options for a program, with the robot and world of the command line, or the exit
// status after a message.
struct Setup {
  SessionOptions session;
  int exit = kDone;
};
// Converts meshes of programs, with a cache; shows progress if it takes long.
MeshConverter mesh_converter();
Setup make_setup(const ProgramOptions& options, const std::string& file);

// The robot with that name in the catalogue, or null after a message.
std::shared_ptr<const Robot> find_robot(const std::string& name);

}  // namespace armlet::cli
