#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "armlet/model/robot.hpp"

namespace armlet {

// Ready-made arms. Each has its source, limits, speeds, a home configuration and, where the source
// gives them, masses and motors. Arms of four and more joints have a parallel gripper whose tool
// point is the end of the last link.
//
// This struct has what is known without constructing the arm. An arm is one row of
// runtime/src/model/catalog_*.cpp; everything that lists the arms (the library's robots.NAME,
// `armlet robot`, the reference, the tests) reads these entries.
struct CatalogArm {
  std::string_view name;
  std::string_view second_name;  // empty: none
  std::string_view source;       // of its numbers
  std::string_view help;         // a sentence
};

std::span<const CatalogArm> catalog_arms();

// The names of the entries, in the same order.
const std::vector<std::string_view>& catalog_names();

// The arm of that name or second name, or null if there is none. Shared, because cells, planners
// and recorders may hold the same immutable arm.
std::shared_ptr<const Robot> make_robot(std::string_view name);

}  // namespace armlet
