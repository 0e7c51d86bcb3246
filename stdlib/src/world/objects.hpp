#pragma once
// Finding objects by name while a program runs.

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/world/object.hpp"

namespace armlet::bind {

// The object of that name, also in the default world if nobody gave one; null if there is none.
const Object* find_object(Vm& vm, std::string_view name);
// R0625 with the names there are.
Failed fail_unknown_object(Vm& vm, std::string_view name, int parameter);

}  // namespace armlet::bind
