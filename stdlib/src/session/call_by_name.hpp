#pragma once
// Functions of a program that a host calls by name, with values.

#include <functional>
#include <string_view>
#include <vector>

#include "armlet/interpreter/host/program_function.hpp"

namespace armlet {

// throws  ArgumentError if no function has this name and number of parameters.
[[nodiscard]] ReadyFunction find_function(Vm& vm, std::string_view name, std::size_t parameters);

// Calls the function as a part of the run. `on_call` is called when the types have been checked.
//
// throws  ArgumentError as find_function, and if an argument has another type.
[[nodiscard]] Result<Value> call_function(Vm& vm, std::string_view name,
                                          const std::vector<Value>& arguments,
                                          const std::function<void()>& on_call);

}  // namespace armlet
