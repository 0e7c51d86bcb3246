#include "vm/host/access.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/core/similar.hpp"
#include "hir/kept.hpp"
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

bool is_of_main_file(const CompiledProgram& program, const hir::Function& function) {
  return function.span.source == program.sources->first() && !function.name.empty() &&
         !function.is_condition && !function.is_task && function.captures.empty();
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
  if (state.globals.is_set[variable.index] != 0) return;
  throw ArgumentError('`' + std::string(variable.name) +
                      "` has no value yet: the program has not come to " +
                      line_of(state, variable) + ", where it is declared.");
}

template <class Things>
std::vector<std::string_view> names_of(const Things& things) {
  std::vector<std::string_view> names;
  for (const auto* thing : things) names.push_back(thing->name);
  return names;
}

// The functions of the main file; in a session the newest declaration of each name, from any entry.
std::vector<const hir::Function*> open_functions(const CompiledProgram& program) {
  std::vector<const hir::Function*> out;
  if (program.entry.kept == nullptr) {
    for (const hir::Function* function : program.module.functions)
      if (is_of_main_file(program, *function)) out.push_back(function);
    return out;
  }
  program.entry.kept->main().names.for_each([&](const KeptFile::Bucket& bucket) {
    for (const KeptName& kept : bucket) {
      if (kept.function == nullptr) continue;
      for (const KeptInstance& form : kept.function->instances) out.push_back(form.function);
    }
  });
  return out;
}

}  // namespace

std::vector<const hir::Variable*> open_globals(const VmState& state) {
  std::vector<const hir::Variable*> out;
  const CompiledProgram& program = *state.programs.newest;
  if (program.entry.kept == nullptr) {
    for (const hir::Variable* variable : program.module.globals)
      if (variable->is_open) out.push_back(variable);
    std::ranges::reverse(out);
    return out;
  }
  program.entry.kept->main().names.for_each([&](const KeptFile::Bucket& bucket) {
    for (const KeptName& kept : bucket)
      if (kept.variable != nullptr) out.push_back(kept.variable);
  });
  std::ranges::sort(out, std::greater{}, [](const hir::Variable* variable) {
    return std::pair(variable->declared.source, variable->declared.begin);
  });
  return out;
}

const hir::Variable& require_global(const VmState& state, std::string_view name) {
  if (const KeptNames* kept = state.programs.newest->entry.kept.get()) {
    const KeptName* known = kept->main().find(name);
    if (known != nullptr && known->variable != nullptr) {
      require_set(state, *known->variable);
      return *known->variable;
    }
  }
  const std::vector<const hir::Variable*> globals = open_globals(state);
  const auto found = std::ranges::find(globals, name, &hir::Variable::name);
  if (found == globals.end()) refuse_name("variable", name, names_of(globals));
  require_set(state, **found);
  return **found;
}

const hir::Variable& require_changeable(const VmState& state, std::string_view name) {
  const hir::Variable& variable = require_global(state, name);
  if (!variable.fixed) return variable;
  throw ArgumentError('`' + std::string(name) + "` is fixed: " + line_of(state, variable) +
                      " says `let` or `final`; `var` can be set.");
}

std::vector<const hir::Function*> require_functions(const VmState& state, std::string_view name) {
  std::vector<const hir::Function*> functions = open_functions(*state.programs.newest);
  const std::vector<std::string_view> names = names_of(functions);
  std::erase_if(functions, [&](const hir::Function* function) { return function->name != name; });
  if (functions.empty()) refuse_name("function", name, names);
  return functions;
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
  if (state.host.all_are_set) return;
  require_begun(state);
  for (const hir::Variable* variable : open_globals(state)) require_set(state, *variable);
  const LoadedCode* newest =
      state.programs.units.empty() ? nullptr : state.programs.units.back().get();
  state.host.all_are_set =
      newest == nullptr || newest->texts.size() == newest->program->texts.size();
  if (!state.host.all_are_set)
    throw ArgumentError("The program could not begin, so its functions cannot be called.");
}

void keep_failure(VmState& state) {
  state.host.error = std::move(state.fault->diagnostic);
  state.fault.reset();
  state.reopen();
}

}  // namespace armlet::lang
