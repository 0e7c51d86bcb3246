// Compiles calls of script functions, of function values and of library functions.

#include <algorithm>
#include <array>

#include "lower/places.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void call_window(Lowering& in, const CallExpr& e, Reg base);
static bool handed_over(Lowering& in, const CallExpr& e, std::size_t argument, Hold hold,
                        Reg& from);
static Reg base_for(Lowering& in, Dest to);
static Reg call(Lowering& in, const Expr& e, Dest to);
static Reg call_value(Lowering& in, const CallValueExpr& e, Dest to);
static Reg call_native(Lowering& in, const CallNativeExpr& e, Reg base);
static Reg call_guarded(Lowering& in, const GuardedExpr& e, Dest to);
static bool call_direct(Lowering& in, const CallNativeExpr& e, Dest to);
static bool code_of_character(Lowering& in, const CallNativeExpr& e, Dest to);

namespace {

// The number of registers that a call reads, plus one, as optimisation passes expect it.
std::uint32_t windowed(Seq<Expr*> arguments) {
  return static_cast<std::uint32_t>(arguments.size()) + 1;
}

}  // namespace

// Evaluates arguments into consecutive registers from `base`, the topmost number. References there
// are borrowed; reference registers own them until the caller frees those.
void window(Lowering& in, Seq<Expr*> arguments, Reg base, Hold hold) {
  std::vector<Hold> holds(arguments.size(), hold);
  for (std::size_t i = arguments.size(); i-- > 1;) {
    holds[i - 1] = stronger(holds[i], hold_over(in, *arguments[i]));
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    argument(in, *arguments[i], i == 0 ? base : in.code.number(), holds[i]);
  }
}

void argument(Lowering& in, const Expr& e, Reg slot, Hold hold) {
  const Emitter::Mark mark = in.code.mark();
  if (e.type->is_reference()) {
    borrow_into(in, e, slot, hold);
  } else {
    value_into(in, e, {slot, true});
  }
  in.code.release_numbers(mark);
}

// The arguments of a call of a script function. Values that the function takes over are moved last,
// because other arguments may still use them.
static void call_window(Lowering& in, const CallExpr& e, Reg base) {
  const Seq<Expr*> arguments = e.arguments;
  std::vector<Hold> holds(arguments.size(), Hold::kCall);
  for (std::size_t i = arguments.size(); i-- > 1;) {
    holds[i - 1] = stronger(holds[i], hold_over(in, *arguments[i]));
  }
  std::vector<std::pair<Reg, Reg>> given;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Reg slot = i == 0 ? base : in.code.number();
    Reg from;
    if (handed_over(in, e, i, holds[i], from)) {
      given.emplace_back(slot, from);
    } else {
      argument(in, *arguments[i], slot, holds[i]);
    }
  }
  for (const auto& [slot, from] : given) in.code.emit(OpCode::GIVE, slot, from);
}

// Evaluates an argument that the function takes over; returns false if the value belongs to another
// object and has to be copied. `from`: the reference register that owns it.
static bool handed_over(Lowering& in, const CallExpr& e, std::size_t argument, Hold hold,
                        Reg& from) {
  const Expr& value = *e.arguments[argument];
  if (!in.options.optimise || !value.type->is_reference() ||
      argument >= e.function->parameters.size() || !e.function->parameters[argument]->adopted) {
    return false;
  }
  if (value.kind == ExprKind::kVariable) {
    const Variable& variable = *value.as<VariableExpr>().variable;
    if (hold == Hold::kOwn || !in.uses.is_whole(e) || !may_be_last_use(in, value, variable))
      return false;
    for (std::size_t i = 0; i < e.arguments.size(); ++i) {
      const bool borrows = i != argument && e.arguments[i]->type->is_reference();
      if (borrows && mentions(*e.arguments[i], variable)) return false;
    }
    from = in.homes.of(variable);
    return true;
  }
  if (!is_one_of(value.kind, {ExprKind::kList, ExprKind::kMap, ExprKind::kNewArray,
                              ExprKind::kRecord, ExprKind::kCall, ExprKind::kCallNative})) {
    return false;
  }
  // f(g(x)): the rule for arguments of the outer call holds for those of the inner one if no other
  // argument can borrow.
  const bool is_only = std::ranges::count_if(
                           e.arguments, [](const Expr* a) { return a->type->is_reference(); }) == 1;
  if (in.uses.is_whole(e) && is_only) in.uses.set_whole(&value);
  from = in.code.reference();
  own_into(in, value, from);
  return true;
}

// Whether no other expression in the statement borrows from the variable whose value may be moved.
bool may_be_last_use(const Lowering& in, const Expr& e, const Variable& variable) {
  if (!in.options.optimise || e.constant != nullptr || variable.storage != Storage::kLocal ||
      !in.homes.of(variable).is_reference()) {
    return false;
  }
  return !in.uses.is_lent(variable);
}

// The window of a call can begin at the destination if that is the topmost number.
static Reg base_for(Lowering& in, Dest to) {
  return to.early && in.code.is_top(to.reg) ? to.reg : in.code.number();
}

void call_into(Lowering& in, const Expr& e, Dest to) {
  if (in.options.optimise && e.kind == ExprKind::kCallNative &&
      (call_direct(in, e.as<CallNativeExpr>(), to) ||
       code_of_character(in, e.as<CallNativeExpr>(), to))) {
    return;
  }
  if (e.kind == ExprKind::kCall && in.tables.inlines(*e.as<CallExpr>().function)) {
    expand(in, e.as<CallExpr>(), to);
    return;
  }
  const Reg result = call(in, e, to);
  if (result != to.reg) in.code.emit(OpCode::MOVE, to.reg, result);
}

void call_own(Lowering& in, const Expr& e, Reg to) {
  in.code.emit(OpCode::TAKE, to, call(in, e, {to, false}));
}

void effect(Lowering& in, const Expr& e) {
  const Emitter::Mark mark = in.code.mark();
  in.uses.set_whole(&e);
  const bool expands = e.kind == ExprKind::kCall && in.tables.inlines(*e.as<CallExpr>().function);
  const bool is_mutation = e.kind == ExprKind::kMutate;
  const bool calls = is_one_of(
      e.kind, {ExprKind::kCall, ExprKind::kCallValue, ExprKind::kCallNative, ExprKind::kGuarded});
  if (is_mutation || (calls && !expands)) {
    const Reg result = is_mutation ? mutate(in, e.as<MutateExpr>()) : call(in, e, {Reg{}, false});
    if (e.type->is_reference()) in.code.emit(OpCode::DROP, result);
  } else if (e.type->is_reference()) {
    (void)borrow(in, e, Hold::kNow);
  } else if (!e.type->is(Kind::kVoid)) {
    (void)value(in, e);
  }
  in.code.release(mark);
}

// Returns the register of the result. A reference there is owned and has to be moved to its
// destination before the next call.
static Reg call(Lowering& in, const Expr& e, Dest to) {
  if (e.kind == ExprKind::kGuarded) return call_guarded(in, e.as<GuardedExpr>(), to);
  if (e.kind == ExprKind::kCallNative)
    return call_native(in, e.as<CallNativeExpr>(), base_for(in, to));
  if (e.kind == ExprKind::kCallValue) return call_value(in, e.as<CallValueExpr>(), to);
  const auto& c = e.as<CallExpr>();
  const Reg base = base_for(in, to);
  call_window(in, c, base);
  in.code.at(e.span, &e);
  in.code.push(OpCode::CALL, base.bits, c.function->index, windowed(c.arguments));
  return base;
}

static Reg call_value(Lowering& in, const CallValueExpr& e, Dest to) {
  Hold hold = Hold::kCall;
  for (const Expr* argument : e.arguments) hold = stronger(hold, hold_over(in, *argument));
  const Reg function = borrow(in, *e.function, hold);
  const Reg base = base_for(in, to);
  window(in, e.arguments, base, Hold::kCall);
  in.code.at(e.span, &e);
  in.code.push(OpCode::CALLV, base.bits, function.bits, windowed(e.arguments));
  return base;
}

static Reg call_native(Lowering& in, const CallNativeExpr& e, Reg base) {
  window(in, e.arguments, base, is_quiet(e, in.tables.inlined()) ? Hold::kNow : Hold::kCall);
  check_arguments(in, e, base);
  in.code.at(e.span, &e);
  in.code.push(OpCode::CALLN, base.bits, in.tables.native(e.function), windowed(e.arguments));
  return base;
}

static Reg call_guarded(Lowering& in, const GuardedExpr& e, Dest to) {
  const auto& motion = e.motion->as<CallNativeExpr>();
  const Reg condition = borrow(in, *e.condition, Hold::kOwn);
  const Reg base = base_for(in, to);
  window(in, motion.arguments, base, Hold::kCall);
  check_arguments(in, motion, base);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::GUARD, condition);
  in.code.at(motion.span, &motion);
  in.code.push(OpCode::CALLN, base.bits, in.tables.native(motion.function), 0);
  return base;
}

// codeOf(text[i]) reads the character code without making a text of one character.
static bool code_of_character(Lowering& in, const CallNativeExpr& e, Dest to) {
  if (e.function->name != "codeOf" || e.arguments.size() != 1 ||
      e.arguments[0]->kind != ExprKind::kCharacter || e.arguments[0]->constant != nullptr) {
    return false;
  }
  character_code(in, e.arguments[0]->as<CharacterExpr>(), to.reg);
  return true;
}

void character_code(Lowering& in, const CharacterExpr& e, Reg to) {
  const Reg text = borrow(in, *e.object, hold_over(in, *e.index));
  const Reg index = value(in, *e.index);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::CODEAT, to, text, index);
}

// Library functions of one to three doubles take their arguments from any registers, without a
// window.
static bool call_direct(Lowering& in, const CallNativeExpr& e, Dest to) {
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
  operands[0] = value_near(in, *e.arguments[0], to);
  for (std::size_t i = 1; i < count; ++i) operands[i] = value(in, *e.arguments[i]);
  in.code.at(e.span, &e);
  constexpr std::array kCalls = {OpCode::CALLD1, OpCode::CALLD2, OpCode::CALLD3};
  in.code.push(is_root ? OpCode::SQRT : kCalls[count - 1], to.reg.bits, operands[0].bits,
               in.tables.native(&f));
  if (count == 2) in.code.emit(OpCode::WITH, operands[1]);
  if (count == 3) in.code.emit(OpCode::PAIR, operands[1], operands[2]);
  return true;
}

}  // namespace armlet::lang
