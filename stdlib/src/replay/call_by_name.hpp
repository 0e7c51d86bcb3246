#pragma once
// Functions of a program that a host calls by name, with values.

#include <functional>
#include <string_view>
#include <vector>

#include "armlet/interpreter/host/program_function.hpp"

namespace armlet {

// throws  ArgumentError if there is none with so many parameters.
[[nodiscard]] ReadyFunction find_function(Vm& vm, std::string_view name, std::size_t parameters);

// A part of the run. `on_call` comes when it is known that the values fit.
//
// throws  ArgumentError as find_function, and if one of them has another type.
[[nodiscard]] Result<Value> call_function(Vm& vm, std::string_view name,
                                          const std::vector<Value>& arguments,
                                          const std::function<void()>& on_call);

}  // namespace armlet
