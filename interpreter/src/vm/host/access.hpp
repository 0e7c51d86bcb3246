#pragma once
// Access of a host to a Vm that is not running: the program's functions and variables by name.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vm/state/state.hpp"

namespace armlet::lang {

// The global variables that the host may use, the newest first.
[[nodiscard]] std::vector<const hir::Variable*> open_globals(const VmState& state);

// The global variable with this name, and its number in VmState::globals.
//
// throws  ArgumentError if the program has none, or it has no value yet.
[[nodiscard]] const hir::Variable& require_global(const VmState& state, std::string_view name);
// The global variable with this name, which must not be constant.
[[nodiscard]] const hir::Variable& require_changeable(const VmState& state, std::string_view name);

// The functions of the main file with this name: one for each combination of types with which the
// program calls it, if its parameters have no declared types.
//
// throws  ArgumentError if there are none.
[[nodiscard]] std::vector<const hir::Function*> require_functions(const VmState& state,
                                                                  std::string_view name);
// "on_tick(dt: time) -> double"
[[nodiscard]] std::string signature_of(const hir::Function& function);

// throws  ArgumentError unless the run has begun and all global variables have values, since a
//         function may use any of them.
void require_values_of_globals(VmState& state);

// Stores the current failure as that of a call by the host, for Vm::error.
void keep_failure(VmState& state);

}  // namespace armlet::lang
