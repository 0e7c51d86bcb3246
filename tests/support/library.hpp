// The engine with the whole library, and a session at the arm and the table of the command.
#pragma once

#include "armlet/interpreter/engine.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"

namespace armlet {

inline SessionOptions at_the_table() {
  SessionOptions options;
  options.robot = make_robot("scara");
  options.default_world = table_world();
  return options;
}

}  // namespace armlet
