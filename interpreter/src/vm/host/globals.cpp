// Reading and changing global variables of the program by the host that owns the Vm.

#include "armlet/interpreter/host/globals.hpp"

#include <algorithm>
#include <string>

#include "armlet/interpreter/render.hpp"
#include "vm/host/access.hpp"
#include "vm/host/values.hpp"
#include "vm/state/turn.hpp"
#include "vocabulary/typed_signature.hpp"

namespace armlet {

namespace {

std::string quoted(std::string_view name) { return '`' + std::string(name) + '`'; }

// Replaces the value of a variable, which takes over the count of the new value.
void replace(lang::VmState& state, const lang::hir::Variable& variable, Slot value) {
  state.keep_global(variable.index);
  Slot& place = state.globals.values[variable.index];
  const Slot old = std::exchange(place, value);
  if (variable.type->is_reference()) state.heap.release(old.o);
}

void require_kind(const lang::hir::Variable& variable, const ValueKind& kind) {
  if (lang::stands_for(*variable.type, kind)) return;
  throw ArgumentError(quoted(variable.name) + " is " + type_phrase(variable.type) +
                      " in the program, which is no " + lang::stored_name(kind) + " in C++.");
}

}  // namespace

Value Vm::global(std::string_view name) {
  const lang::Turn turn(*state_);
  const lang::hir::Variable& variable = lang::require_global(*state_, name);
  return lang::value_in(state_->globals.values[variable.index], *variable.type, quoted(name));
}

Result<Value> Vm::try_global(std::string_view name) {
  try {
    return global(name);
  } catch (const ArgumentError& error) {
    return Error{"global", error.what()};
  }
}

void Vm::set(std::string_view name, const Value& value) {
  const lang::Turn turn(*state_);
  const lang::hir::Variable& variable = lang::require_changeable(*state_, name);
  replace(*state_, variable, lang::slot_of_value(*state_, value, *variable.type, quoted(name)));
}

void Vm::set(std::string_view name, double number, std::string_view unit) {
  set(name, Value(number, unit));
}

std::optional<Error> Vm::try_set(std::string_view name, const Value& value) {
  try {
    set(name, value);
    return std::nullopt;
  } catch (const ArgumentError& error) {
    return Error{"set", error.what()};
  }
}

const Diagnostic* Vm::error() const {
  const auto& error = state_->host.error;
  return error ? &*error : nullptr;
}

std::string Vm::error_text() const {
  return error() == nullptr ? std::string() : render_text(*error(), program_->sources());
}

namespace typed {

Slot slot_of_global(Vm& vm, std::string_view name, const ValueKind& kind) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  const lang::hir::Variable& variable = lang::require_global(state, name);
  require_kind(variable, kind);
  return state.globals.values[variable.index];
}

}  // namespace typed

// ---- a new version of the program

namespace {

// Copies a value into a variable of another program. Returns the reason if it cannot be copied,
// otherwise an empty text.
std::string carry(lang::VmState& from, const lang::hir::Variable& old, lang::VmState& to,
                  const lang::hir::Variable& fresh) {
  const std::string was = type_phrase(old.type);
  const std::string is = type_phrase(fresh.type);
  if (!lang::is_same_type(*old.type, *fresh.type))
    return was != is                         ? "it was " + was + ", and is " + is
           : fresh.type->is(Kind::kFunction) ? "it is a function, which belongs to its program"
                                             : was + " is no longer what it was";
  try {
    const Value value = lang::value_in(from.globals.values[old.index], *old.type, "it");
    replace(to, fresh, lang::slot_of_value(to, value, *fresh.type, "it", lang::Undefined::kKept));
    return {};
  } catch (const ArgumentError& error) {
    const std::string why = error.what();
    return why.substr(0, why.size() - 1);  // without the full stop
  }
}

}  // namespace

CarriedGlobals carry_globals(Vm& from, Vm& to) {
  CarriedGlobals out;
  if (&from == &to) throw ArgumentError("A program's values are carried into another Vm.");
  lang::VmState& old_state = from.state();
  lang::VmState& new_state = to.state();
  const lang::Turn old_turn(old_state);
  const lang::Turn new_turn(new_state);
  lang::require_values_of_globals(old_state);
  lang::require_values_of_globals(new_state);
  auto olds = lang::open_globals(old_state);
  auto news = lang::open_globals(new_state);
  std::ranges::reverse(olds);  // in the order of the text
  std::ranges::reverse(news);
  const auto named = [](const auto& among, std::string_view name) {
    const auto found = std::ranges::find(among, name, &lang::hir::Variable::name);
    return found == among.end() ? nullptr : *found;
  };
  for (const lang::hir::Variable* variable : news) {
    const lang::hir::Variable* old = named(olds, variable->name);
    const std::string name(variable->name);
    if (old == nullptr) {
      out.fresh.push_back(name);
    } else if (variable->fixed) {
      if (!old->fixed) out.lost.push_back({name, "it is fixed now"});
    } else if (std::string why = carry(old_state, *old, new_state, *variable); why.empty()) {
      out.kept.push_back(name);
    } else {
      out.lost.push_back({name, std::move(why)});
    }
  }
  for (const lang::hir::Variable* variable : olds) {
    if (named(news, variable->name) == nullptr)
      out.lost.push_back({std::string(variable->name), "it is gone"});
  }
  return out;
}

}  // namespace armlet
