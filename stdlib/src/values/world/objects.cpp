#include "values/world/objects.hpp"

#include <fmt/format.h>

#include <string>
#include <variant>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/core/format.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/world/looks.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

Failed fail_unknown_object(Vm& vm, std::string_view name, CallPart part) {
  Host& host = Host::of(vm);
  const World& world = host.cell().world();
  Failure f;
  f.headline = {row("R0625"), {std::string(name)}};
  f.mark = part;
  std::string list;
  for (const std::string& known : world.names())
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", known);
  f.why = list.empty() ? "this world is empty" : fmt::format("there are {}", list);
  if (const auto meant = world.similar_name(name))
    f.fix = fmt::format("did you mean \"{}\"?", *meant);
  return fail(vm, std::move(f));
}

const Object* find_object(Vm& vm, std::string_view name) {
  Host& host = Host::of(vm);
  if (const Object* object = host.cell().world().find(name)) return object;
  host.want_world({});
  return host.cell().world().find(name);
}

bool has_orientation(const Object& object) {
  return std::holds_alternative<Box>(object.shape) || std::holds_alternative<Plane>(object.shape) ||
         std::holds_alternative<Mesh>(object.shape);
}

// W0723, once for each statement of the program.
void report_overlap(Vm& vm, const std::string& name) {
  Host& host = Host::of(vm);
  const World& world = host.cell().world();
  const Object* placed = world.find(name);
  if (placed == nullptr || world.attachment(name)) return;
  if (host.knows_collision(place_of_call(vm).code(), "placed")) return;
  const auto inside = deepest_overlap(world, *placed);
  if (!inside || !host.first_collision(place_of_call(vm).code(), "placed")) return;
  Failure advice;
  const std::string depth = (inside->at_least ? "at least " : "") + format_mm(inside->depth);
  advice.headline = {row("W0723"), {name, depth, inside->other}};
  advice.why = "two bodies cannot be in one place; a hand that takes one of them would collide";
  advice.fix = fmt::format("move it by {} at least", format_mm(inside->depth));
  if (placed->fixed != world.at(inside->other).fixed) {
    advice.fix += ", or make both `fixed: true` if they are parts of one thing";
  }
  vm.advise(advice);
}

Answer<PosC> frame_now(Vm& vm, const FrameRef& f, CallPart part) {
  const World& world = Host::of(vm).cell().world();
  const NamedFrame* frame = world.find_frame(f.name);
  if (frame == nullptr) return fail_unknown_frame(vm, f.name, part);
  if (const auto T = world.T_world_frame(f.name)) return PosC{*T, frame->turned};
  return failure(vm, row("R0645"),
                 fmt::format("what the frame `{}` is on was removed from the world", f.name), part);
}

Failed fail_unknown_frame(Vm& vm, std::string_view name, CallPart part) {
  const World& world = Host::of(vm).cell().world();
  const std::vector<std::string> known = world.frame_names();
  std::string list;
  for (const std::string& each : known)
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", each);
  const std::vector<std::string_view> candidates(known.begin(), known.end());
  const auto meant = most_similar(name, candidates);
  return failure(vm, row("R0645"), fmt::format("there is no frame called \"{}\"", name), part,
                 list.empty() ? "this world has no frames" : fmt::format("there are {}", list),
                 meant ? fmt::format("did you mean \"{}\"?", *meant) : std::string());
}

Answer<Mount> mount_on(Vm& vm, const ObjectRef& on, CallPart part) {
  if (find_object(vm, on.name) == nullptr) return fail_unknown_object(vm, on.name, part);
  return Mount{.base = FrameBase::kObject, .on = on.name};
}
Answer<Mount> mount_on(Vm& vm, const FrameRef& on, CallPart part) {
  if (!frame_now(vm, on, part)) return Failed{};
  return Mount{.base = FrameBase::kFrame, .on = on.name};
}
Answer<Mount> mount_on_robot(Vm& vm, const RobotRef& on, std::optional<std::int64_t> link,
                             CallPart part) {
  const Cell& cell = Host::of(vm).cell();
  const CellRobot& arm = cell.robot(on.id);
  if (arm.on >= 0) {
    // The joints of a hand move its fingers; its palm moves with the flange of the arm.
    if (link && *link != 0) {
      return failure(
          vm, row("R0631"),
          fmt::format("things are mounted on the palm of `{}`, which is its link 0", arm.name),
          part);
    }
    return Mount{.base = FrameBase::kCarrier, .on = cell.robot(arm.on).name, .carrier = arm.on};
  }
  const int n = arm.model->rows();
  if (link && (*link < 0 || *link > n)) {
    return failure(
        vm, row("R0631"),
        fmt::format("`{}` has the links 0, its base, to {}, but no link {}", arm.name, n, *link),
        part);
  }
  return Mount{.base = FrameBase::kCarrier,
               .on = arm.name,
               .carrier = on.id,
               .frame = link ? static_cast<int>(*link) : kFlange};
}

void report_color(Vm& vm, std::string_view color, CallPart part) {
  Failure advice;
  advice.headline = {row("W0744"), {std::string(color)}};
  advice.mark = part;
  if (const auto meant = similar_color(color))
    advice.fix = fmt::format("did you mean \"{}\"?", *meant);
  vm.advise(advice);
}

}  // namespace armlet::bind
