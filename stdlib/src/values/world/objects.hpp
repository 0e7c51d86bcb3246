#pragma once
// Objects and frames by name during a run.

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/world/world.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// The object with that name, also in the default world if no world was given; null: none.
const Object* find_object(Vm& vm, std::string_view name);
// R0625 with the names of the existing objects.
Failed fail_unknown_object(Vm& vm, std::string_view name, CallPart part);

// W0723 if the object intersects another one, once for each statement of the program.
void report_overlap(Vm& vm, const std::string& name);

// Whether the shape shows the rotation of a body: a round one shows only its axis
// (language reference, section 8.6).
[[nodiscard]] bool has_orientation(const Object& object);

// W0744: there is no colour with that name; gray is used.
void report_color(Vm& vm, std::string_view color, CallPart part);

// A mount on an object or a frame; if it does not exist, the failure marks `part`.
Answer<Mount> mount_on(Vm& vm, const ObjectRef& on, CallPart part);
Answer<Mount> mount_on(Vm& vm, const FrameRef& on, CallPart part);
// A mount on a link of a robot; on its flange if none is given. If there is no such link, the
// failure marks `part`.
Answer<Mount> mount_on_robot(Vm& vm, const RobotRef& on, std::optional<std::int64_t> link,
                             CallPart part);

// The present pose of a frame; R0645 if no frame has that name, or if its mount was removed.
Answer<PosC> frame_now(Vm& vm, const FrameRef& f, CallPart part);
// R0645 with the names of the existing frames.
Failed fail_unknown_frame(Vm& vm, std::string_view name, CallPart part);

}  // namespace armlet::bind
