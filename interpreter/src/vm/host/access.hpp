#pragma once
// What a host asks of a Vm that is not running: the program's functions and variables by name.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vm/state/state.hpp"

namespace armlet::lang {

// The variables of the top level that the host may use, the newest first.
[[nodiscard]] std::vector<const hir::Variable*> open_globals(const VmState& state);

// The variable of the top level with this name, and its number in VmState::globals.
//
// throws  ArgumentError if the program has none, or it has no value yet.
[[nodiscard]] const hir::Variable& require_global(const VmState& state, std::string_view name);
// The same of one that may be changed.
[[nodiscard]] const hir::Variable& require_changeable(const VmState& state, std::string_view name);

// The functions of the main file with this name: one for each combination of types with which the
// program calls it, if its text does not fix them.
//
// throws  ArgumentError if there are none.
[[nodiscard]] std::vector<const hir::Function*> require_functions(const VmState& state,
                                                                  std::string_view name);
// "on_tick(dt: time) -> double"
[[nodiscard]] std::string signature_of(const hir::Function& function);

// throws  ArgumentError unless the run has begun and all variables of the top level have values:
//         functions may use any of them.
void require_values_of_globals(VmState& state);

// The failure under way becomes that of a call by the host, which Vm::error tells.
void keep_failure(VmState& state);

}  // namespace armlet::lang
