// Frames with names (language reference, section 13.4).

#include <fmt/format.h>

#include "armlet/core/similar.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {

namespace {

Answer<FrameRef> insert(Vm& vm, NamedFrame frame) try {
  FrameRef made{frame.name};
  Host::of(vm).cell().insert_frame(std::move(frame));
  return made;
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}

Answer<FrameRef> frame_block(Vm& vm, std::string_view name, const PosC& pose) {
  return insert(vm,
                {.name = std::string(name), .T_on_frame = pose.T, .turned = pose.has_orientation});
}
Answer<FrameRef> frame_on_object(Vm& vm, std::string_view name, const PosC& pose,
                                 const ObjectRef& on) {
  const Object* object = find_object(vm, on.name);
  if (object == nullptr) return fail_unknown_object(vm, on.name, at("on"));
  return insert(vm, {.name = std::string(name),
                     .base = FrameBase::kObject,
                     .on = on.name,
                     .T_on_frame = pose.T,
                     .turned = pose.has_orientation || has_orientation(*object)});
}
Answer<FrameRef> frame_on_frame(Vm& vm, std::string_view name, const PosC& pose,
                                const FrameRef& on) {
  const NamedFrame* lower = Host::of(vm).cell().world().find_frame(on.name);
  if (lower == nullptr) return fail_unknown_frame(vm, on.name, at("on"));
  return insert(vm, {.name = std::string(name),
                     .base = FrameBase::kFrame,
                     .on = on.name,
                     .T_on_frame = pose.T,
                     .turned = pose.has_orientation || lower->turned});
}

Answer<FrameRef> frame_on_robot(Vm& vm, std::string_view name, const PosC& pose, const RobotRef& on,
                                std::optional<std::int64_t> link) {
  const auto mount = mount_on_robot(vm, on, link, at("link"));
  if (!mount) return Failed{};
  return insert(vm, {.name = std::string(name),
                     .base = FrameBase::kCarrier,
                     .on = mount->on,
                     .T_on_frame = pose.T,
                     .turned = true,
                     .carrier = mount->carrier,
                     .frame = mount->frame});
}

Answer<FrameRef> frame_named(Vm& vm, std::string_view name) {
  if (Host::of(vm).cell().world().find_frame(name) == nullptr)
    return fail_unknown_frame(vm, name, at("name"));
  return FrameRef{std::string(name)};
}
std::string frame_name(const FrameRef& f) { return f.name; }
Answer<PosC> pose_of_frame(Vm& vm, const FrameRef& f) { return frame_now(vm, f, at("f")); }

Answer<void> set_frame_pose(Vm& vm, const FrameRef& f, const PosC& p) try {
  const auto before = frame_now(vm, f, at("f"));
  if (!before) return Failed{};
  Eigen::Isometry3d T = p.T;
  if (!p.has_orientation) T.linear() = before->T.linear();
  Host::of(vm).cell().set_frame(f.name, T);
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}

Answer<PosC> seen_from(Vm& vm, const FrameRef& f, const PosC& p) {
  const auto frame = frame_now(vm, f, at("f"));
  if (!frame) return Failed{};
  return PosC{frame->T * p.T, frame->has_orientation || p.has_orientation};
}

constexpr std::string_view kFrameHelp =
    "A frame with a name; at is seen from what it is on, with which it moves: an object, another "
    "frame or a link of a robot, its flange unless told otherwise; or from the world.";

constexpr NativeFunction kFrameFunctions[] = {
    def<frame_block>("frame{}(name: string, at: posC) -> frame", kFrameHelp,
                     "frame bench { at: xyz(300mm, 200mm, 100mm) }", {.acts = true}),
    def<frame_on_object, frame_on_frame>(
        "frame{}(name: string, at: posC, on: object | frame) -> frame", kFrameHelp,
        "frame lid { at: xyz(z: 20mm); on: object(\"cube\") }; frame bench { at: xyz(x: 300mm) } "
        "frame corner { at: xyz(y: 50mm); on: bench }",
        {.acts = true}),
    def<frame_on_robot>(
        "frame{}(name: string, at: posC, on: robot, link: int?) -> frame", kFrameHelp,
        "robot arm = robots.ur5(); frame probe { at: xyz(z: 80mm); on: arm }", {.acts = true}),
    def<frame_named>("frame(name: string) -> frame", "The frame of that name.",
                     "frame bench { at: xyz(x: 300mm) } print(frame(\"bench\"))"),
    def<frame_name>("frame.name(f: frame) -> string", "The name.",
                    "frame bench { at: xyz(x: 300mm) } print(bench.name)"),
    def<pose_of_frame>("poseOf(f: frame) -> posC", "Where a frame is in the world now.",
                       "frame bench { at: xyz(x: 300mm) } print(poseOf(bench))"),
    def<set_frame_pose>("setPose(f: frame, p: posC)",
                        "Puts a frame somewhere else in the world; it stays on what it is on.",
                        "frame bench { at: xyz(x: 300mm) } setPose(bench, xyz(x: 310mm))"),
    def<seen_from>("operator*(f: frame, p: posC) -> posC", "p as seen from a frame, in the world.",
                   "frame bench { at: xyz(x: 300mm) } print(bench * xyz(z: 20mm))"),
};

}  // namespace

std::span<const NativeFunction> frame_functions() { return kFrameFunctions; }

}  // namespace armlet::bind
