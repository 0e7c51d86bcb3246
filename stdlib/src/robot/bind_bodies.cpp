// Rows of robot blocks that define the shapes of links (language reference, section 13.1).

#include <fmt/format.h>

#include <cmath>

#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "robot/bodies.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/robots/models.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"
#include "values/world/meshes.hpp"

namespace armlet::bind {
namespace {

Answer<LinkSolidUse> use_of(Vm& vm, std::string_view word, int parameter) {
  for (std::size_t i = 0; i < std::size(kShapeUses); ++i) {
    if (word == kShapeUses[i]) return static_cast<LinkSolidUse>(i);
  }
  return failure(
      vm, row("R0630"),
      fmt::format("a shape is used for \"both\", a \"picture\" or a \"collision\", not \"{}\"",
                  word),
      parameter);
}

Answer<BodyRow> body_row(Vm& vm, LinkSolidKind kind, const Eigen::Vector3d& size, std::int64_t link,
                         const PosC* at, std::string_view use, int use_at) {
  for (int i = 0; i < 3; ++i) {
    const bool is_size =
        i == 0 || kind == LinkSolidKind::kBox || (i == 1 && kind == LinkSolidKind::kCylinder);
    if (is_size && !(std::isfinite(size[i]) && size[i] > 0.0))
      return domain_failure(vm, "the size of a shape", size[i], "be above 0 m", {}, i);
  }
  const auto used = use_of(vm, use, use_at);
  if (!used) return Failed{};
  BodyRow row{.link = link};
  row.solid = {.kind = kind, .size = size, .use = *used};
  if (at != nullptr) row.solid.T_link_solid = at->T;
  return row;
}

Answer<BodyRow> box_row(Vm& vm, double x, double y, double z, std::int64_t link, const PosC* at,
                        std::string_view use) {
  return body_row(vm, LinkSolidKind::kBox, {x, y, z}, link, at, use, 5);
}
Answer<BodyRow> cylinder_row(Vm& vm, double radius, double height, std::int64_t link,
                             const PosC* at, std::string_view use) {
  return body_row(vm, LinkSolidKind::kCylinder, {radius, height, 0.0}, link, at, use, 4);
}
Answer<BodyRow> sphere_row(Vm& vm, double radius, std::int64_t link, const PosC* at,
                           std::string_view use) {
  return body_row(vm, LinkSolidKind::kSphere, {radius, 0.0, 0.0}, link, at, use, 3);
}
Answer<BodyRow> mesh_row(Vm& vm, std::string_view file, std::int64_t link, const PosC* at,
                         std::optional<double> unit, double scale, std::string_view use) {
  const auto used = use_of(vm, use, 5);
  if (!used) return Failed{};
  for (const double factor : {unit.value_or(1.0), scale}) {
    if (!(std::isfinite(factor) && factor > 0.0))
      return fail_mesh(vm, file,
                       fmt::format("its unit or scale is {}; expected more than 0", factor), {},
                       factor == scale ? 4 : 3);
  }
  BodyRow row{.link = link, .mesh = std::string(file), .unit = unit.value_or(0.0), .scale = scale};
  row.solid.use = *used;
  if (at != nullptr) row.solid.T_link_solid = at->T;
  return row;
}

#define ARMLET_BODY "link: int = 0, at: posC?, "
#define ARMLET_USE "use: string = \"both\") -> bodyRow"
constexpr std::string_view kShapeHelp =
    "A shape of a link of the robot, 0: its base. at is its middle, in the frame of the link; use: "
    "\"both\", or only for the \"picture\" or for \"collision\".";

constexpr NativeFunction kBodyFunctions[] = {
    def<box_row>("robot.body.box(x: length, y: length, z: length, " ARMLET_BODY ARMLET_USE,
                 kShapeHelp,
                 "joint revolute(a: 300mm); body box(400mm, 400mm, 20mm, at: xyz(z: -10mm))",
                 {.check = check_word<5, kShapeUses>}),
    def<cylinder_row>("robot.body.cylinder(radius: length, height: length, " ARMLET_BODY ARMLET_USE,
                      kShapeHelp, "joint revolute(a: 300mm); body cylinder(60mm, 120mm)",
                      {.check = check_word<4, kShapeUses>}),
    def<sphere_row>("robot.body.sphere(radius: length, " ARMLET_BODY ARMLET_USE, kShapeHelp,
                    "joint revolute(a: 300mm); body sphere(40mm, link: 1)",
                    {.check = check_word<3, kShapeUses>}),
    def<mesh_row>("robot.body.mesh(file: string, " ARMLET_BODY
                  "unit: length?, scale: double = 1.0, " ARMLET_USE,
                  "A mesh as a shape of a link of the robot, 0: its base; the rest as for boxes.",
                  "joint revolute(a: 300mm); body mesh(\"base.glb\")",
                  {.check = check_word<5, kShapeUses>}),
};

}  // namespace

Answer<bool> add_bodies(Vm& vm, HostList<BodyRow> rows, RobotSpec& spec) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BodyRow& body = rows[i];
    const auto n = static_cast<std::int64_t>(spec.joints.size());
    if (body.link < 0 || body.link > n) {
      throw ArgumentError(fmt::format(
          "Robot `{}` has the links 0, its base, to {}, but no link {}.", spec.name, n, body.link));
    }
    Link& link = body.link == 0 ? spec.base : spec.links[static_cast<std::size_t>(body.link - 1)];
    if (body.mesh.empty()) {
      link.solids.push_back(body.solid);
      continue;
    }
    if (!Host::of(vm).has_mesh({}, body.mesh)) {
      throw ArgumentError(fmt::format("The mesh \"{}\" of link {} of robot `{}` is not there.",
                                      body.mesh, body.link, spec.name));
    }
    const auto mesh = load_link_mesh(vm, {}, body.mesh, {.unit = body.unit, .scale = body.scale});
    if (!mesh.ok()) return fail_mesh(vm, body.mesh, mesh.error().message, {}, -1);
    if (*mesh != nullptr) link.bodies.push_back({*mesh, body.solid.T_link_solid, body.solid.use});
  }
  for (const Link& link : spec.links) {
    if (!link.solids.empty() || !link.bodies.empty()) return true;
  }
  return false;
}

std::span<const NativeFunction> body_functions() { return kBodyFunctions; }

}  // namespace armlet::bind
