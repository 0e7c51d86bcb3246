#pragma once
// Finding objects by name while a program runs.

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/world/world.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// The object of that name, also in the default world if nobody gave one; null if there is none.
const Object* find_object(Vm& vm, std::string_view name);
// R0625 with the names there are.
Failed fail_unknown_object(Vm& vm, std::string_view name, int parameter);

// W0723 if the object lies in another one, once for each place of the program.
void report_overlap(Vm& vm, const std::string& name);

// Whether the shape tells how a body is turned: a round one has an axis only (ruling 14).
[[nodiscard]] bool has_orientation(const Object& object);

// W0744: there is no colour of that name, so what has it is gray.
void report_color(Vm& vm, std::string_view color, int parameter);

// What is on an object or a frame; marks argument `parameter` if that is not there.
Answer<Mount> mount_on(Vm& vm, const ObjectRef& on, int parameter);
Answer<Mount> mount_on(Vm& vm, const FrameRef& on, int parameter);
// What is on a robot: a link of it, its flange if none is given. Marks argument `parameter` if
// there is no such link.
Answer<Mount> mount_on_robot(Vm& vm, const RobotRef& on, std::optional<std::int64_t> link,
                             int parameter);

// Where a frame is now; R0645 if there is none of that name, or what it is on was removed.
Answer<PosC> frame_now(Vm& vm, const FrameRef& f, int parameter);
// R0645 with the names there are.
Failed fail_unknown_frame(Vm& vm, std::string_view name, int parameter);

}  // namespace armlet::bind
