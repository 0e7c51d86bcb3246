#pragma once
// What native functions ask of a function value of the program besides calling it.

#include <cstddef>

#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// The type of a parameter, counted from 0; null if it has not so many. `function` is a function
// value of the program that runs.
//
// throws  ArgumentError if it is none.
const Type* parameter_type(Vm& vm, const Obj* function, std::size_t index);

}  // namespace armlet
