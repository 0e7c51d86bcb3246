#include "armlet/model/tool.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {
namespace {

void check_not_negative(std::string_view name, double value) {
  check_finite(name, value);
  if (value < 0.0) {
    throw ArgumentError(fmt::format("`{}` is {}; it must be zero or more.", name, value));
  }
}

}  // namespace

Tool parallel_gripper(double stroke, double length, double force) {
  check_positive("stroke", stroke);
  check_not_negative("length", length);
  check_not_negative("force", force);
  return {.kind = ToolKind::kParallelGripper, .stroke = stroke, .length = length, .force = force};
}

Tool suction_cup(double radius, double length) {
  check_positive("radius", radius);
  check_not_negative("length", length);
  return {.kind = ToolKind::kSuctionCup, .length = length, .radius = radius};
}

Tool point_tool(double length) {
  check_not_negative("length", length);
  return {.kind = ToolKind::kPoint, .length = length};
}

}  // namespace armlet
