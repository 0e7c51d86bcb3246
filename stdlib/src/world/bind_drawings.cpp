// Shapes that are displayed but have no effect (language reference, section 14).

#include <fmt/format.h>

#include "armlet/core/similar.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/world/looks.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {
namespace {

// The mount of a shape.
Answer<Mount> shown_on(Vm&) { return Mount{}; }
template <class On>
Answer<Mount> shown_on(Vm& vm, const On& on) {
  return mount_on(vm, on, at("on"));
}
// Without a link the shape is mounted on the tool point.
Answer<Mount> shown_on(Vm& vm, const RobotRef& on, std::optional<std::int64_t> link) {
  if (link) return mount_on_robot(vm, on, link, at("link"));
  return Mount{.base = FrameBase::kCarrier,
               .on = Host::of(vm).cell().robot(on.id).name,
               .carrier = on.id,
               .frame = kTipFrame};
}

Answer<void> show(Vm& vm, Drawing drawing, const Answer<Mount>& on, std::string_view color) try {
  if (!on) return Failed{};
  drawing.on = *on;
  drawing.color = color;
  if (!is_color(color)) report_color(vm, color, at("color"));
  Host::of(vm).cell().draw(std::move(drawing));
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0672"), error);
}

Drawing between(DrawingKind kind, std::string_view name, const PosC& from, const PosC& to,
                double width) {
  const Eigen::Vector3d begin = from.T.translation();
  const Eigen::Vector3d end = to.T.translation();
  return {.name = std::string(name),
          .kind = kind,
          .size = {(end - begin).norm(), width, 0.0},
          .T_on_drawing = frame_between(begin, end)};
}

// The functions for each kind of mount, whose parameters precede the colour.
template <class... On>
struct Shows {
  template <DrawingKind kKind>
  static Answer<void> stroke(Vm& vm, std::string_view name, const PosC& from, const PosC& to,
                             On... on, std::string_view color, double width) {
    return show(vm, between(kKind, name, from, to, width), shown_on(vm, on...), color);
  }
  static Answer<void> capsule(Vm& vm, std::string_view name, const PosC& from, const PosC& to,
                              double radius, On... on, std::string_view color) {
    Drawing drawing = between(DrawingKind::kCapsule, name, from, to, 0.0);
    // A capsule of length zero is a sphere.
    drawing.size = {radius, std::max(drawing.size[0], kSmallest), 0.0};
    return show(vm, std::move(drawing), shown_on(vm, on...), color);
  }
  static Answer<void> text(Vm& vm, std::string_view name, std::string_view said, const PosC& pose,
                           On... on, std::string_view color, double height) {
    return show(vm,
                {.name = std::string(name),
                 .kind = DrawingKind::kText,
                 .size = {height, 0.0, 0.0},
                 .text = std::string(said),
                 .T_on_drawing = pose.T},
                shown_on(vm, on...), color);
  }
  static Answer<void> disk(Vm& vm, std::string_view name, const PosC& pose, double radius, On... on,
                           std::string_view color) {
    return show(vm,
                {.name = std::string(name),
                 .kind = DrawingKind::kDisk,
                 .size = {radius, 0.0, 0.0},
                 .T_on_drawing = pose.T},
                shown_on(vm, on...), color);
  }
  static Answer<void> ellipsoid(Vm& vm, std::string_view name, const PosC& pose,
                                std::span<const double> radii, On... on, std::string_view color) {
    if (radii.size() != 3) {
      return failure(vm, "R0613", fmt::format("an ellipsoid has 3 radii, not {}", radii.size()),
                     at("radii"));
    }
    return show(vm,
                {.name = std::string(name),
                 .kind = DrawingKind::kEllipsoid,
                 .size = {radii[0], radii[1], radii[2]},
                 .T_on_drawing = pose.T},
                shown_on(vm, on...), color);
  }
};

using InWorld = Shows<>;
using OnObject = Shows<const ObjectRef&>;
using OnFrame = Shows<const FrameRef&>;
using OnRobot = Shows<const RobotRef&, std::optional<std::int64_t>>;

Answer<void> remove_drawing(Vm& vm, std::string_view name) {
  Cell& cell = Host::of(vm).cell();
  if (cell.undraw(name)) return {};
  const std::vector<std::string> names = cell.drawings().names();
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = most_similar(name, known);
  return failure(vm, row("R0672"), fmt::format("there is no shape \"{}\"", name), at("name"),
                 known.empty() ? "no shapes are drawn" : std::string(),
                 meant ? fmt::format("did you mean \"{}\"?", *meant) : std::string());
}

Answer<void> trail(Vm& vm, const RobotRef& r, std::string_view color, double width) try {
  if (!is_color(color)) report_color(vm, color, at("color"));
  Cell& cell = Host::of(vm).cell();
  cell.trails().begin(cell, r.id, std::string(color), width);
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0672"), error, at("width"));
}

Answer<void> clear_drawings(Vm& vm) {
  Cell& cell = Host::of(vm).cell();
  for (const std::string& name : cell.drawings().names()) cell.undraw(name);
  return {};
}

constexpr std::string_view kArrowHelp =
    "Shows an arrow from one place to another, or changes the shape of that name. Shapes are only "
    "shown: nothing collides with them. On a robot it goes with its tool point, or with a link; on "
    "an object or a frame with that, and the places are seen from there.";
constexpr std::string_view kLineHelp =
    "Shows a straight line, or changes the shape of that name; otherwise as draw.arrow.";
constexpr std::string_view kCapsuleHelp =
    "Shows a cylinder that is round behind both ends, or changes the shape of that name; otherwise "
    "as draw.arrow.";
constexpr std::string_view kTextHelp =
    "Shows a text that faces the viewer, or changes the shape of that name; otherwise as "
    "draw.arrow.";
constexpr std::string_view kDiskHelp =
    "Shows a flat disk that faces along z of its pose, or changes the shape of that name; "
    "otherwise "
    "as draw.arrow.";
constexpr std::string_view kEllipsoidHelp =
    "Shows an ellipsoid with half its widths along x, y and z of its pose, or changes the shape of "
    "that name; otherwise as draw.arrow.";

#define ARMLET_STYLE(more) "color: string = \"orange\"" more ")"
#define ARMLET_SHOWN(function, parameters, style, help, example)                                \
  def<&InWorld::function>(parameters style, help, example, {.acts = true}),                     \
      def<&OnRobot::function>(parameters "on: robot, link: int?, " style, help, example,        \
                              {.acts = true}),                                                  \
      def<&OnObject::function>(parameters "on: object, " style, help, example, {.acts = true}), \
      def<&OnFrame::function>(parameters "on: frame, " style, help, example, {.acts = true})

constexpr NativeFunction kDrawingFunctions[] = {
    ARMLET_SHOWN(stroke<DrawingKind::kArrow>, "draw.arrow(name: string, from: posC, to: posC, ",
                 ARMLET_STYLE(", width: length = 6mm"), kArrowHelp,
                 "draw.arrow(\"up\", xyz(), xyz(z: 300mm), color: \"red\")"),
    ARMLET_SHOWN(stroke<DrawingKind::kLine>, "draw.line(name: string, from: posC, to: posC, ",
                 ARMLET_STYLE(", width: length = 3mm"), kLineHelp,
                 "draw.line(\"edge\", xyz(), xyz(x: 300mm))"),
    ARMLET_SHOWN(text, "draw.text(name: string, text: string, at: posC, ",
                 ARMLET_STYLE(", height: length = 25mm"), kTextHelp,
                 "draw.text(\"note\", f\"t = {now():.1f s}\", xyz(z: 500mm))"),
    ARMLET_SHOWN(disk, "draw.disk(name: string, at: posC, radius: length, ", ARMLET_STYLE(""),
                 kDiskHelp, "draw.disk(\"goal\", xyz(x: 300mm, z: 1mm), 40mm)"),
    ARMLET_SHOWN(ellipsoid, "draw.ellipsoid(name: string, at: posC, radii: length[], ",
                 ARMLET_STYLE(""), kEllipsoidHelp,
                 "draw.ellipsoid(\"reach\", xyz(z: 300mm), [100mm, 60mm, 30mm])"),
    ARMLET_SHOWN(capsule, "draw.capsule(name: string, from: posC, to: posC, radius: length, ",
                 ARMLET_STYLE(""), kCapsuleHelp,
                 "draw.capsule(\"zone\", xyz(), xyz(z: 400mm), 50mm)"),
    def<trail>("trail(r: robot, color: string = \"orange\", width: length = 3mm)",
               "Draws the path of the hand from now on, as lines that are only shown: on the page "
               "of a laboratory and in the pictures of cameras. draw.clear() takes away what was "
               "drawn.",
               "robot arm = robots.scara(); arm.trail(); arm.moveJ(posJ(20deg, 30deg, 10mm, 0deg))",
               {.acts = true}),
    def<remove_drawing>("draw.remove(name: string)", "Takes a shape away that was drawn.",
                        "draw.line(\"edge\", xyz(), xyz(x: 300mm)); draw.remove(\"edge\")",
                        {.acts = true}),
    def<clear_drawings>("draw.clear()", "Takes all shapes away that were drawn.", "draw.clear()",
                        {.acts = true}),
};

}  // namespace

std::span<const NativeFunction> drawing_functions() { return kDrawingFunctions; }

}  // namespace armlet::bind
