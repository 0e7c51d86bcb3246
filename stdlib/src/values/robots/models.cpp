#include "values/robots/models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "values/matrices.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {

Answer<void> read_vector3(Vm& vm, Numbers values, CallPart part, std::string_view what,
                          Eigen::Vector3d& out) {
  if (!values) return {};
  if (values->size() != 3) {
    return failure(vm, "R0613", fmt::format("{} has 3 values, not {}", what, values->size()), part);
  }
  out = Eigen::Map<const Eigen::Vector3d>(values->data());
  return {};
}

Answer<void> read_com(Vm& vm, Numbers values, CallPart part, Link& link) {
  return read_vector3(vm, values, part, "the centre of mass", link.com);
}

Answer<Inertia> inertia_argument(Vm& vm, NumberRows rows, CallPart part) {
  if (!rows) return Inertia{};
  if (rows->size() != 3) {
    return failure(vm, "R0613",
                   fmt::format("an inertia has 3 rows of 3 values, not {}", rows->size()), part);
  }
  Eigen::Matrix3d I;
  for (int i = 0; i < 3; ++i) {
    const auto values = reals_value((*rows)[static_cast<std::size_t>(i)]);
    if (values.size() != 3) {
      return failure(
          vm, "R0613",
          fmt::format("an inertia has 3 rows of 3 values, but row {} has {}", i + 1, values.size()),
          part);
    }
    for (int j = 0; j < 3; ++j) I(i, j) = values[static_cast<std::size_t>(j)];
  }
  return Inertia{I};
}

Answer<Inertia> inertia_argument(Vm& vm, const MatrixObj& matrix, CallPart part) {
  if (matrix.rows != 3 || matrix.cols != 3) {
    return failure(
        vm, "R0613",
        fmt::format("an inertia is a 3 x 3 matrix, not a {} x {} one", matrix.rows, matrix.cols),
        part);
  }
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  return Inertia{Eigen::Matrix3d(Eigen::Map<const Rows>(elements(matrix).data()))};
}

Answer<void> read_friction(Vm& vm, Numbers given, CallPart part, Link& link) {
  if (!given) return {};
  const auto f = *given;
  if (f.size() != 1 && f.size() != 3 && f.size() != 5) {
    return failure(
        vm, "R0613",
        fmt::format("friction is [B], [B, Tc+, Tc-] or [B, Tc+, Tc-, Ts, vs], not {} values",
                    f.size()),
        part);
  }
  link.friction = {.viscous = f[0]};
  if (f.size() >= 3) {
    link.friction.coulomb_plus = f[1];
    link.friction.coulomb_minus = f[2];
  }
  if (f.size() == 5) {
    link.friction.static_torque = f[3];
    link.friction.stribeck_speed = f[4];
  }
  return {};
}

Answer<RobotRef> add_robot(Vm& vm, Robot robot) {
  Result<int> id = Host::of(vm).add_robot(std::make_shared<const Robot>(std::move(robot)));
  if (!id.ok()) return failure_of(vm, row("R0630"), ArgumentError(id.error().message));
  return RobotRef{*id, &Host::of(vm).cell()};
}

// The robot with the settings that every such function accepts: base, tool, name, all optional.
Robot finished(Robot robot, const PosC* base, const ToolValue* tool,
               std::optional<std::string_view> name) {
  if (base != nullptr) robot = robot.with_base(base->T);
  if (tool != nullptr) {
    robot = robot.with_tool(tool->tool);
    if (tool->T_flange_tool) robot = robot.with_tool_point(*tool->T_flange_tool);
  }
  if (name) robot = robot.with_name(std::string(*name));
  return robot;
}

DhConvention convention_of(std::string_view word) {
  const auto* known = std::ranges::find(kConventions, word);
  if (known != kConventions.end()) return static_cast<DhConvention>(known - kConventions.begin());
  throw ArgumentError(
      fmt::format("The convention is \"standard\" or \"modified\", not \"{}\".", word));
}

}  // namespace armlet::bind
