// Statements, apart from assignments, loops and try.

#include <algorithm>
#include <map>

#include "compile/cancelled.hpp"
#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

void Lowering::statement(const Stmt& s) {
  if (!code_.reachable()) return;
  stop_if(options_.cancelled);
  code_.at(s.span);
  switch (s.kind) {
    case StmtKind::kBlock:
      return block(s.as<Block>());
    case StmtKind::kInit:
      return init(s.as<InitStmt>());
    case StmtKind::kAssign:
      return assign(s.as<AssignStmt>());
    case StmtKind::kStorePart:
      return store_part(s.as<StorePartStmt>());
    case StmtKind::kExpr:
      return effect(*s.as<ExprStmt>().value);
    case StmtKind::kIf:
      return if_else(s.as<IfStmt>());
    case StmtKind::kLoop:
      return loop(s.as<LoopStmt>());
    case StmtKind::kRange:
      return range(s.as<RangeStmt>());
    case StmtKind::kForList:
      return for_list(s.as<ForListStmt>());
    case StmtKind::kSwitch:
      return switch_case(s.as<SwitchStmt>());
    case StmtKind::kTry:
      return try_catch(s.as<TryStmt>());
    case StmtKind::kThrow:
      return raise(s.as<ThrowStmt>());
    case StmtKind::kJump:
      return jump(s.as<JumpStmt>());
    case StmtKind::kReturn:
      return give_back(s.as<ReturnStmt>());
    case StmtKind::kAssert:
      return check(s.as<AssertStmt>());
    case StmtKind::kAssertThrows:
      return check_throws(s.as<AssertThrowsStmt>());
    case StmtKind::kWait:
      return wait(s.as<WaitStmt>());
    case StmtKind::kWaitUntil:
      return wait_until(s.as<WaitUntilStmt>());
    case StmtKind::kParallel:
      return parallel(s.as<ParallelStmt>());
    case StmtKind::kWhen:
      return when(s.as<WhenStmt>());
    case StmtKind::kEvery:
      return every(s.as<EveryStmt>());
  }
}

void Lowering::block(const Block& b) {
  const Emitter::Mark mark = code_.mark();
  if (std::ranges::any_of(b.body, starts_watching)) {
    watched_block(b.body);
  } else {
    for (const Stmt* s : b.body) statement(*s);
  }
  code_.at({b.span.end, b.span.end, b.span.source});
  code_.release(mark);
}

// ---- variables
// ----------------------------------------------------------------------------------------------------

// Gives a variable its register or box.
void Lowering::declare(Variable& variable) {
  switch (variable.storage) {
    case Storage::kGlobal:
      break;
    case Storage::kLocal:
      variable.index = (variable.type->is_reference() ? code_.reference() : code_.number()).bits;
      break;
    case Storage::kBoxed:
      variable.index = code_.reference().bits;
      code_.push(OpCode::BOX, variable.index, 0, variable.type->is_reference() ? 1 : 0);
      break;
  }
}

// The register of a new variable holds nothing yet, so it may be written before the value is
// complete.
void Lowering::init(const InitStmt& s) {
  Variable& variable = *s.variable;
  declare(variable);
  if (s.value == nullptr) return;
  const Emitter::Mark mark = code_.mark();
  whole_ = s.value;
  if (variable.storage != Storage::kLocal) {
    store(variable, *s.value);
  } else if (variable.type->is_reference()) {
    own_into(*s.value, reg_of(variable));
  } else {
    value_into(*s.value, {reg_of(variable), true});
  }
  code_.release(mark);
  note_set(variable);
}

// Declares a variable whose first value is in a register.
void Lowering::init_from(Variable& variable, Reg value) {
  declare(variable);
  store_register(variable, value);
  note_set(variable);
}

void Lowering::note_set(const Variable& variable) {
  if (variable.storage == Storage::kGlobal && variable.maybe_unset) {
    code_.push(OpCode::GSET, variable.index, 0, 0);
  }
}

// ---- choices
// ------------------------------------------------------------------------------------------------------

void Lowering::if_else(const IfStmt& s) {
  const Label end = code_.label();
  const IfStmt* link = &s;
  for (;;) {
    const Label no = code_.label();
    branch(*link->condition, false, no);
    scoped(*link->yes);
    if (link->no == nullptr) {
      code_.bind(no);
      break;
    }
    code_.jump(end);
    code_.bind(no);
    if (link->no->kind != StmtKind::kIf) {
      scoped(*link->no);
      break;
    }
    link = &link->no->as<IfStmt>();
  }
  code_.bind(end);
}

// A statement whose declarations, if it is one, end with it.
void Lowering::scoped(const Stmt& s) {
  const Emitter::Mark mark = code_.mark();
  Stmt* only = const_cast<Stmt*>(&s);
  if (starts_watching(only)) {
    watched_block({&only, 1});
  } else {
    statement(s);
  }
  code_.release(mark);
}

void Lowering::switch_case(const SwitchStmt& s) {
  const Emitter::Mark mark = code_.mark();
  declare(*s.subject);
  store(*s.subject, *s.value);
  const Label end = code_.label();
  std::vector<Label> bodies;
  // Every value of an enum has its case, so without a default the last case needs no test.
  const SwitchCase* fallback = nullptr;
  if (s.value->type->is(Kind::kEnum) && !s.cases.empty()) fallback = &s.cases.back();
  for (const SwitchCase& c : s.cases) {
    bodies.push_back(code_.label());
    if (c.is_default) fallback = &c;
  }
  const Label otherwise =
      fallback == nullptr ? end : bodies[static_cast<std::size_t>(fallback - s.cases.data())];
  if (!switch_by_table(s, bodies, otherwise)) {
    for (std::size_t i = 0; i < s.cases.size(); ++i) {
      for (const Expr* test : s.cases[i].tests) branch(*test, true, bodies[i]);
    }
    code_.jump(otherwise);
  }
  exits_.push_back({&s, end, end, tries_.size(), {}, {}});
  for (std::size_t i = 0; i < s.cases.size(); ++i) {
    code_.bind(bodies[i]);
    if (s.cases[i].body != nullptr) block(*s.cases[i].body);
    code_.jump(end);
  }
  exits_.pop_back();
  code_.bind(end);
  code_.release(mark);
}

// The number that a case `subject == number` asks for.
static bool number_of_case(const Expr& test, const Variable& subject, std::int64_t& out) {
  if (test.kind != ExprKind::kBinary || test.as<BinaryExpr>().op != Op::kEqI) return false;
  const auto& equal = test.as<BinaryExpr>();
  const bool asks = equal.left->kind == ExprKind::kVariable &&
                    equal.left->as<VariableExpr>().variable == &subject;
  return asks && small_int(*equal.right, out);
}

// Numbers that lie close together are looked up, the first case of each.
bool Lowering::switch_by_table(const SwitchStmt& s, const std::vector<Label>& bodies,
                               Label otherwise) {
  constexpr std::size_t kFewest = 4;
  if (!options_.optimise || s.subject->storage != Storage::kLocal) return false;
  std::map<std::int64_t, Label> targets;
  for (std::size_t i = 0; i < s.cases.size(); ++i) {
    for (const Expr* test : s.cases[i].tests) {
      std::int64_t number = 0;
      if (!number_of_case(*test, *s.subject, number)) return false;
      targets.emplace(number, bodies[i]);
    }
  }
  if (targets.size() < kFewest) return false;
  const std::int64_t lowest = targets.begin()->first;
  const auto span = static_cast<std::size_t>(targets.rbegin()->first - lowest + 1);
  if (span > 4 * targets.size()) return false;
  std::vector<Label> table(span, otherwise);
  for (const auto& [number, label] : targets) {
    table[static_cast<std::size_t>(number - lowest)] = label;
  }
  code_.at(s.value->span, s.value);
  code_.switch_on(reg_of(*s.subject), lowest, table, otherwise);
  return true;
}

// ---- going elsewhere
// ----------------------------------------------------------------------------------------------

void Lowering::jump(const JumpStmt& s) {
  for (std::size_t i = exits_.size(); i-- > 0;) {
    const Exit exit = exits_[i];
    if (exit.target != s.target) continue;
    leave(exit.tries, [&] {
      if (s.jump == Jump::kRetry) code_.emit(OpCode::RETRY, exit.retries, exit.instant);
      code_.jump(s.jump == Jump::kBreak ? exit.leave : exit.again);
    });
    return;
  }
}

void Lowering::give_back(const ReturnStmt& s) {
  const Emitter::Mark mark = code_.mark();
  whole_ = s.value;
  if (!expansions_.empty()) {
    give_back_here(*s.value);
  } else if (s.value == nullptr || s.value->type->is(Kind::kVoid)) {
    if (s.value != nullptr) effect(*s.value);
    leave(0, [&] { code_.emit(is_program_ ? OpCode::HALT : OpCode::RETVOID); });
  } else if (s.value->type->is_reference()) {
    give_back_reference(*s.value);
  } else {
    Reg result;
    if (finally_runs() || !in_register(*s.value, result)) {
      result = code_.number();
      value_into(*s.value, {result, true});
    }
    leave(0, [&] {
      code_.emit(OpCode::RET, options_.optimise ? code_.moved_to_first(result) : result);
    });
  }
  code_.release(mark);
}

// A local variable is handed over; what belongs to someone else is counted; new values are handed
// over.
void Lowering::give_back_reference(const Expr& e) {
  if (!finally_runs()) {
    const bool variable =
        e.kind == ExprKind::kVariable && e.as<VariableExpr>().variable->storage == Storage::kLocal;
    if (variable || e.kind == ExprKind::kField || e.kind == ExprKind::kElement) {
      const Reg result = borrow(e, Hold::kNow);
      code_.emit(variable && result.is_reference() ? OpCode::RETTAKE : OpCode::RETREF, result);
      return;
    }
  }
  const Reg result = code_.reference();
  own_into(e, result);
  leave(0, [&] { code_.emit(OpCode::RETTAKE, result); });
}

void Lowering::raise(const ThrowStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Reg error = borrow(*s.value, Hold::kNow);
  code_.at(s.span);
  code_.emit(OpCode::THROW, error);
  code_.release(mark);
}

// ---- waiting and checking
// -----------------------------------------------------------------------------------------

void Lowering::wait(const WaitStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Reg seconds = value(*s.duration);
  code_.at(s.duration->span, s.duration);
  code_.emit(OpCode::WAIT, seconds);
  code_.release(mark);
}

void Lowering::wait_until(const WaitUntilStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Reg condition = borrow(*s.condition, Hold::kOwn);
  const Reg timeout = code_.number();
  if (s.timeout != nullptr) {
    value_into(*s.timeout, {timeout, true});
  } else {
    code_.constant(timeout, Slot{.i = kAbsentBits});
  }
  code_.at(s.condition_span, s.condition);
  code_.push(OpCode::WAITUNTIL, condition.bits, timeout.bits, tables_.add_wait(s));
  code_.release(mark);
}

void Lowering::check(const AssertStmt& s) {
  const Emitter::Mark mark = code_.mark();
  for (const InitStmt* part : s.parts_init) init(*part);
  const Label holds = code_.label();
  branch(*s.condition, true, holds);
  const Emitter::Mark inner = code_.mark();
  const Reg note = s.note != nullptr ? borrow(*s.note, Hold::kOwn) : null_reference();
  const Reg why = s.explain != nullptr ? borrow(*s.explain, Hold::kOwn) : null_reference();
  const std::uint32_t index = tables_.add_assert(s);
  std::vector<Reg> registers;
  for (const AssertPart& part : s.shown) registers.push_back(reg_of(*part.variable));
  code_.shown(index, std::move(registers));
  code_.at(s.condition_span, s.condition);
  code_.push(OpCode::ASSERTFAIL, index, note.bits, why.bits);
  code_.release(inner);
  code_.bind(holds);
  code_.release(mark);
}

}  // namespace armlet::lang
