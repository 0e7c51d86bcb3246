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

Answer<LinkSolidUse> use_of(Vm& vm, std::string_view word, CallPart part) {
  for (std::size_t i = 0; i < std::size(kShapeUses); ++i) {
    if (word == kShapeUses[i]) return static_cast<LinkSolidUse>(i);
  }
  return failure(
      vm, row("R0630"),
      fmt::format("a shape is used for \"both\", a \"picture\" or a \"collision\", not \"{}\"",
                  word),
      part);
}

// names  of the sizes that the shape has.
Answer<BodyRow> body_row(Vm& vm, LinkSolidKind kind, const Eigen::Vector3d& size,
                         std::span<const CallPart> names, std::int64_t link, const PosC* pose,
                         std::string_view use) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double length = size[static_cast<Eigen::Index>(i)];
    if (!(std::isfinite(length) && length > 0.0))
      return domain_failure(vm, "the size of a shape", length, "be above 0 m", {}, names[i]);
  }
  const auto used = use_of(vm, use, at("use"));
  if (!used) return Failed{};
  BodyRow row{.link = link};
  row.solid = {.kind = kind, .size = size, .use = *used};
  if (pose != nullptr) row.solid.T_link_solid = pose->T;
  return row;
}

Answer<BodyRow> box_row(Vm& vm, double x, double y, double z, std::int64_t link, const PosC* pose,
                        std::string_view use) {
  static constexpr CallPart kSides[] = {at("x"), at("y"), at("z")};
  return body_row(vm, LinkSolidKind::kBox, {x, y, z}, kSides, link, pose, use);
}
Answer<BodyRow> cylinder_row(Vm& vm, double radius, double height, std::int64_t link,
                             const PosC* pose, std::string_view use) {
  static constexpr CallPart kSizes[] = {at("radius"), at("height")};
  return body_row(vm, LinkSolidKind::kCylinder, {radius, height, 0.0}, kSizes, link, pose, use);
}
Answer<BodyRow> sphere_row(Vm& vm, double radius, std::int64_t link, const PosC* pose,
                           std::string_view use) {
  static constexpr CallPart kSizes[] = {at("radius")};
  return body_row(vm, LinkSolidKind::kSphere, {radius, 0.0, 0.0}, kSizes, link, pose, use);
}
Answer<BodyRow> mesh_row(Vm& vm, std::string_view file, std::int64_t link, const PosC* pose,
                         std::optional<double> unit, double scale, std::string_view use) {
  const auto used = use_of(vm, use, at("use"));
  if (!used) return Failed{};
  for (const double factor : {unit.value_or(1.0), scale}) {
    if (!(std::isfinite(factor) && factor > 0.0))
      return fail_mesh(vm, file,
                       fmt::format("its unit or scale is {}; expected more than 0", factor), {},
                       factor == scale ? at("scale") : at("unit"));
  }
  BodyRow row{.link = link, .mesh = std::string(file), .unit = unit.value_or(0.0), .scale = scale};
  row.solid.use = *used;
  if (pose != nullptr) row.solid.T_link_solid = pose->T;
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
                 {.check = check_word<"use", kShapeUses>}),
    def<cylinder_row>("robot.body.cylinder(radius: length, height: length, " ARMLET_BODY ARMLET_USE,
                      kShapeHelp, "joint revolute(a: 300mm); body cylinder(60mm, 120mm)",
                      {.check = check_word<"use", kShapeUses>}),
    def<sphere_row>("robot.body.sphere(radius: length, " ARMLET_BODY ARMLET_USE, kShapeHelp,
                    "joint revolute(a: 300mm); body sphere(40mm, link: 1)",
                    {.check = check_word<"use", kShapeUses>}),
    def<mesh_row>("robot.body.mesh(file: string, " ARMLET_BODY
                  "unit: length?, scale: double = 1.0, " ARMLET_USE,
                  "A mesh as a shape of a link of the robot, 0: its base; the rest as for boxes.",
                  "joint revolute(a: 300mm); body mesh(\"base.glb\")",
                  {.check = check_word<"use", kShapeUses>}),
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
    if (!mesh.ok()) return fail_mesh(vm, body.mesh, mesh.error().message, {}, {});
    if (*mesh != nullptr) link.bodies.push_back({*mesh, body.solid.T_link_solid, body.solid.use});
  }
  for (const Link& link : spec.links) {
    if (!link.solids.empty() || !link.bodies.empty()) return true;
  }
  return false;
}

std::span<const NativeFunction> body_functions() { return kBodyFunctions; }

}  // namespace armlet::bind
