#pragma once
// Which instructions the machine has executed, when it is the one of counting_interpret.cpp.

#include <set>

#include "program/program.hpp"

namespace armlet::lang {

[[nodiscard]] inline std::set<OpCode>& executed_opcodes() {
  static std::set<OpCode> executed;
  return executed;
}

}  // namespace armlet::lang
