#include "vm/host/access.hpp"

#include <algorithm>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/similar.hpp"
#include "vm/failures/failures.hpp"

namespace armlet::lang {

namespace {

[[noreturn]] void refuse_name(const char* what, std::string_view name,
                              const std::vector<std::string_view>& others) {
  std::string message = "The program has no " + std::string(what) + " `" + std::string(name) + '`';
  if (const auto near = most_similar(name, others))
    message += "; did you mean `" + std::string(*near) + "`?";
  throw ArgumentError(message.ends_with('?') ? message : message + '.');
}

bool is_of_main_file(const hir::Function& function) {
  return function.span.source == 0 && !function.name.empty() && !function.is_condition &&
         !function.is_task && function.captures.empty();
}

std::string line_of(const VmState& state, const hir::Variable& variable) {
  return "line " + std::to_string(lang::line_of(state, variable.declared));
}

void require_begun(const VmState& state) {
  if (state.scheduler == nullptr)
    throw ArgumentError("The program has not run yet, so nothing in it has a value; run it first.");
}

void require_set(const VmState& state, const hir::Variable& variable) {
  require_begun(state);
  if (state.global_is_set[variable.index] != 0) return;
  throw ArgumentError('`' + std::string(variable.name) +
                      "` has no value yet: the program has not come to " +
                      line_of(state, variable) + ", where it is declared.");
}

}  // namespace

const hir::Variable& require_global(const VmState& state, std::string_view name) {
  const auto& globals = state.program.module.globals;
  std::vector<std::string_view> names;
  for (std::size_t i = globals.size(); i > 0; --i) {  // the newest first
    const hir::Variable& variable = *globals[i - 1];
    if (!variable.is_open) continue;
    if (variable.name == name) {
      require_set(state, variable);
      return variable;
    }
    names.push_back(variable.name);
  }
  refuse_name("variable", name, names);
}

const hir::Variable& require_changeable(const VmState& state, std::string_view name) {
  const hir::Variable& variable = require_global(state, name);
  if (!variable.fixed) return variable;
  throw ArgumentError('`' + std::string(name) + "` is fixed: " + line_of(state, variable) +
                      " says `let` or `final`; `var` can be set.");
}

std::vector<const hir::Function*> require_functions(const VmState& state, std::string_view name) {
  std::vector<const hir::Function*> found;
  std::vector<std::string_view> names;
  for (const hir::Function* function : state.program.module.functions) {
    if (!is_of_main_file(*function)) continue;
    if (function->name == name) found.push_back(function);
    names.push_back(function->name);
  }
  if (found.empty()) refuse_name("function", name, names);
  return found;
}

std::string signature_of(const hir::Function& function) {
  std::string text(function.name);
  text += '(';
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const hir::Variable& parameter = *function.parameters[i];
    text += (i == 0 ? "" : ", ") + std::string(parameter.name) + ": " + type_name(parameter.type);
  }
  text += ')';
  const bool has_result = function.result != nullptr && !function.result->is(Kind::kVoid);
  return has_result ? text + " -> " + type_name(function.result) : text;
}

void require_values_of_globals(VmState& state) {
  if (state.host_access.all_are_set) return;
  require_begun(state);
  for (const hir::Variable* variable : state.program.module.globals) {
    if (variable->is_open) require_set(state, *variable);
  }
  state.host_access.all_are_set = state.texts.size() == state.program.texts.size();
  if (!state.host_access.all_are_set)
    throw ArgumentError("The program could not begin, so its functions cannot be called.");
}

void keep_failure(VmState& state) {
  state.host_access.error = std::move(state.fault->diagnostic);
  state.fault.reset();
  state.reopen();
}

}  // namespace armlet::lang
