#pragma once
// What a program in a folder needs before it runs: the files that it imports, its robot, its world.

#include <memory>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/stdlib/mesh_converter.hpp"
#include "armlet/stdlib/session_options.hpp"

namespace armlet {

// Reads imported files, and tables whose columns the checker needs, relative to the file that
// imports them. A program can read files of its own folder and the folders below it, whatever the
// path says; links there are not followed.
[[nodiscard]] ModuleLoader imports_of(const std::string& program);

// The arm or hand with that name in the catalogue.
//
// returns  an error "robot" that lists the known names, with a similar one on a second line.
[[nodiscard]] Result<std::shared_ptr<const Robot>> robot_from_catalog(const std::string& name);

// program  the file of the program.
// robot    of programs that declare none, by its name in the catalogue.
// world    a file for load_world; empty: programs that name an object get the table.
// convert  makes GLB of meshes in other formats; null: only GLB can be read.
struct Workspace {
  std::string program;
  std::string robot;
  std::string world{};
  MeshConverter convert{};
};

// The options of a session for this program, which may write files below its own folder only. The
// caller adds limits, outputs and listeners.
//
// returns  the error of robot_from_catalog, or that of load_world.
[[nodiscard]] Result<SessionOptions> session_options(const Workspace& workspace);

}  // namespace armlet
