#pragma once
// Properties of function values of the program, for native functions.

#include <cstddef>

#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// The type of a parameter, counted from 0; null if the function has fewer. `function` is a function
// value of the running program.
//
// throws  ArgumentError if it is not a function value.
const Type* parameter_type(Vm& vm, const Obj* function, std::size_t index);

}  // namespace armlet
