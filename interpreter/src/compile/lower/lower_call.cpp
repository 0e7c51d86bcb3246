// Calls of functions of the program, of function values and of the library.

#include <algorithm>
#include <array>

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// For passes over the code: one more than the registers that a call reads.
std::uint32_t windowed(Seq<Expr*> arguments) {
  return static_cast<std::uint32_t>(arguments.size()) + 1;
}

}  // namespace

// Arguments in consecutive registers from `base`, which is the topmost number. References there are
// borrowed copies; what owns them stays in reference registers until the caller gives those back.
void Lowering::window(Seq<Expr*> arguments, Reg base, Hold hold) {
  std::vector<Hold> holds(arguments.size(), hold);
  for (std::size_t i = arguments.size(); i-- > 1;) {
    holds[i - 1] = stronger(holds[i], hold_over(*arguments[i]));
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    argument(*arguments[i], i == 0 ? base : code_.number(), holds[i]);
  }
}

void Lowering::argument(const Expr& e, Reg slot, Hold hold) {
  const Emitter::Mark mark = code_.mark();
  if (e.type->is_reference()) {
    borrow_into(e, slot, hold);
  } else {
    value_into(e, {slot, true});
  }
  code_.release_numbers(mark);
}

// Of a function of the program. What it adopts is handed over last of all, so that the other
// arguments can still be made from it.
void Lowering::call_window(const CallExpr& e, Reg base) {
  const Seq<Expr*> arguments = e.arguments;
  std::vector<Hold> holds(arguments.size(), Hold::kCall);
  for (std::size_t i = arguments.size(); i-- > 1;) {
    holds[i - 1] = stronger(holds[i], hold_over(*arguments[i]));
  }
  std::vector<std::pair<Reg, Reg>> given;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Reg slot = i == 0 ? base : code_.number();
    Reg from;
    if (handed_over(e, i, holds[i], from)) {
      given.emplace_back(slot, from);
    } else {
      argument(*arguments[i], slot, holds[i]);
    }
  }
  for (const auto& [slot, from] : given) code_.emit(OpCode::GIVE, slot, from);
}

// Evaluates an argument that the function adopts, unless it is a place of somebody else. `from`:
// the reference register that owns it.
bool Lowering::handed_over(const CallExpr& e, std::size_t argument, Hold hold, Reg& from) {
  const Expr& value = *e.arguments[argument];
  if (!options_.optimise || !value.type->is_reference() ||
      argument >= e.function->parameters.size() ||
      !tables_.adopts(*e.function->parameters[argument])) {
    return false;
  }
  if (value.kind == ExprKind::kVariable) {
    const Variable& variable = *value.as<VariableExpr>().variable;
    if (hold == Hold::kOwn || whole_ != &e || !may_be_last_use(value, variable)) return false;
    for (std::size_t i = 0; i < e.arguments.size(); ++i) {
      const bool borrows = i != argument && e.arguments[i]->type->is_reference();
      if (borrows && mentions(*e.arguments[i], variable)) return false;
    }
    from = reg_of(variable);
    return true;
  }
  if (!is_one_of(value.kind, {ExprKind::kList, ExprKind::kMap, ExprKind::kNewArray,
                              ExprKind::kRecord, ExprKind::kCall, ExprKind::kCallNative})) {
    return false;
  }
  // f(g(x)): what holds for the outer call holds for the inner one if nothing else can borrow.
  const bool is_only = std::ranges::count_if(
                           e.arguments, [](const Expr* a) { return a->type->is_reference(); }) == 1;
  if (whole_ == &e && is_only) whole_ = &value;
  from = code_.reference();
  own_into(value, from);
  return true;
}

// Nothing borrows from the variable here besides the value that is about to change its owner.
bool Lowering::may_be_last_use(const Expr& e, const Variable& variable) const {
  if (!options_.optimise || e.constant != nullptr || variable.storage != Storage::kLocal ||
      !reg_of(variable).is_reference()) {
    return false;
  }
  return std::ranges::find(lent_, &variable) == lent_.end();
}

// The window of a call may begin at the target itself when that is the topmost number.
Reg Lowering::base_for(Dest to) {
  return to.early && code_.is_top(to.reg) ? to.reg : code_.number();
}

void Lowering::call_into(const Expr& e, Dest to) {
  if (options_.optimise && e.kind == ExprKind::kCallNative &&
      (call_direct(e.as<CallNativeExpr>(), to) || code_of_character(e.as<CallNativeExpr>(), to))) {
    return;
  }
  if (e.kind == ExprKind::kCall && e.as<CallExpr>().function->expands) {
    expand(e.as<CallExpr>(), to);
    return;
  }
  const Reg result = call(e, to);
  if (result != to.reg) code_.emit(OpCode::MOVE, to.reg, result);
}

void Lowering::call_own(const Expr& e, Reg to) {
  code_.emit(OpCode::TAKE, to, call(e, {to, false}));
}

void Lowering::effect(const Expr& e) {
  const Emitter::Mark mark = code_.mark();
  whole_ = &e;
  const bool expands = e.kind == ExprKind::kCall && e.as<CallExpr>().function->expands;
  const bool is_mutation = e.kind == ExprKind::kMutate;
  const bool calls = is_one_of(
      e.kind, {ExprKind::kCall, ExprKind::kCallValue, ExprKind::kCallNative, ExprKind::kGuarded});
  if (is_mutation || (calls && !expands)) {
    const Reg result = is_mutation ? mutate(e.as<MutateExpr>()) : call(e, {Reg{}, false});
    if (e.type->is_reference()) code_.emit(OpCode::DROP, result);
  } else if (e.type->is_reference()) {
    (void)borrow(e, Hold::kNow);
  } else if (!e.type->is(Kind::kVoid)) {
    (void)value(e);
  }
  code_.release(mark);
}

// Returns the register of the result; a reference there is owned and has to be taken at once.
Reg Lowering::call(const Expr& e, Dest to) {
  if (e.kind == ExprKind::kGuarded) return call_guarded(e.as<GuardedExpr>(), to);
  if (e.kind == ExprKind::kCallNative) return call_native(e.as<CallNativeExpr>(), base_for(to));
  if (e.kind == ExprKind::kCallValue) return call_value(e.as<CallValueExpr>(), to);
  const auto& c = e.as<CallExpr>();
  const Reg base = base_for(to);
  call_window(c, base);
  code_.at(e.span, &e);
  code_.push(OpCode::CALL, base.bits, c.function->index, windowed(c.arguments));
  return base;
}

Reg Lowering::call_value(const CallValueExpr& e, Dest to) {
  Hold hold = Hold::kCall;
  for (const Expr* argument : e.arguments) hold = stronger(hold, hold_over(*argument));
  const Reg function = borrow(*e.function, hold);
  const Reg base = base_for(to);
  window(e.arguments, base, Hold::kCall);
  code_.at(e.span, &e);
  code_.push(OpCode::CALLV, base.bits, function.bits, windowed(e.arguments));
  return base;
}

Reg Lowering::call_native(const CallNativeExpr& e, Reg base) {
  window(e.arguments, base, is_quiet(e) ? Hold::kNow : Hold::kCall);
  check_arguments(e, base);
  code_.at(e.span, &e);
  code_.push(OpCode::CALLN, base.bits, tables_.native(e.function), windowed(e.arguments));
  return base;
}

Reg Lowering::call_guarded(const GuardedExpr& e, Dest to) {
  const auto& motion = e.motion->as<CallNativeExpr>();
  const Reg condition = borrow(*e.condition, Hold::kOwn);
  const Reg base = base_for(to);
  window(motion.arguments, base, Hold::kCall);
  check_arguments(motion, base);
  code_.at(e.span, &e);
  code_.emit(OpCode::GUARD, condition);
  code_.at(motion.span, &motion);
  code_.push(OpCode::CALLN, base.bits, tables_.native(motion.function), 0);
  return base;
}

// codeOf(text[i]) needs no text of one character.
bool Lowering::code_of_character(const CallNativeExpr& e, Dest to) {
  if (e.function->name != "codeOf" || e.arguments.size() != 1 ||
      e.arguments[0]->kind != ExprKind::kCharacter || e.arguments[0]->constant != nullptr) {
    return false;
  }
  character_code(e.arguments[0]->as<CharacterExpr>(), to.reg);
  return true;
}

void Lowering::character_code(const CharacterExpr& e, Reg to) {
  const Reg text = borrow(*e.object, hold_over(*e.index));
  const Reg index = value(*e.index);
  code_.at(e.span, &e);
  code_.emit(OpCode::CODEAT, to, text, index);
}

// Functions of one to three doubles need no window.
bool Lowering::call_direct(const CallNativeExpr& e, Dest to) {
  const NativeFunction& f = *e.function;
  const std::size_t count = e.arguments.size();
  const bool is_root = count == 1 && f.name == "sqrt";
  const bool is_direct = is_root || (count == 1 && f.real1 != nullptr) ||
                         (count == 2 && f.real2 != nullptr) || (count == 3 && f.real3 != nullptr);
  if (!is_direct || !e.type->is(Kind::kReal)) return false;
  for (const Expr* argument : e.arguments) {
    if (!argument->type->is(Kind::kReal) || argument->kind == ExprKind::kAbsent) return false;
  }
  std::array<Reg, 3> operands;
  operands[0] = value_near(*e.arguments[0], to);
  for (std::size_t i = 1; i < count; ++i) operands[i] = value(*e.arguments[i]);
  code_.at(e.span, &e);
  constexpr std::array kCalls = {OpCode::CALLD1, OpCode::CALLD2, OpCode::CALLD3};
  code_.push(is_root ? OpCode::SQRT : kCalls[count - 1], to.reg.bits, operands[0].bits,
             tables_.native(&f));
  if (count == 2) code_.emit(OpCode::WITH, operands[1]);
  if (count == 3) code_.emit(OpCode::PAIR, operands[1], operands[2]);
  return true;
}

}  // namespace armlet::lang
