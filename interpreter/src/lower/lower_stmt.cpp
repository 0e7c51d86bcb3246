// Compiles statements, apart from assignments, loops and try.

#include <algorithm>
#include <map>

#include "base/cancelled.hpp"
#include "lower/places.hpp"
#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void declare(Lowering& in, const Variable& variable);
static void init(Lowering& in, const InitStmt& s);
static void if_else(Lowering& in, const IfStmt& s);
static void switch_case(Lowering& in, const SwitchStmt& s);
static bool switch_by_table(Lowering& in, const SwitchStmt& s, const std::vector<Label>& bodies,
                            Label otherwise);
static void jump(Lowering& in, const JumpStmt& s);
static void give_back(Lowering& in, const ReturnStmt& s);
static void give_back_reference(Lowering& in, const Expr& e);
static void raise(Lowering& in, const ThrowStmt& s);
static void wait(Lowering& in, const WaitStmt& s);
static void wait_until(Lowering& in, const WaitUntilStmt& s);
static void check(Lowering& in, const AssertStmt& s);

static void lower_statement(Lowering& in, const Stmt& s);

// Whether the statement is in the text. The checker adds statements that are not.
static bool is_written(const Stmt& s) {
  if (s.kind == StmtKind::kBlock || s.span.empty()) return false;
  return s.kind != StmtKind::kInit || !s.as<InitStmt>().variable->name.empty();
}

// The byte from which the variables of a statement are visible. Variables of its inner blocks have
// their scope already.
static std::uint32_t scope_begin(const Stmt& s) {
  if (s.kind == StmtKind::kRange) return s.as<RangeStmt>().body->span.begin;
  if (s.kind == StmtKind::kForList) return s.as<ForListStmt>().body->span.begin;
  return s.span.begin;
}

void statement(Lowering& in, const Stmt& s) {
  if (!in.code.reachable()) return;
  stop_if(in.options.cancelled);
  in.code.at(s.span);
  if (!in.options.markers) return lower_statement(in, s);
  const bool repeats =
      !in.marked.empty() && in.marked.begin == s.span.begin && in.marked.source == s.span.source;
  if (is_written(s) && !repeats) {
    in.code.emit(OpCode::MARK);
    in.marked = s.span;
  }
  const Homes::Point point{in.homes.count(), in.code.position()};
  lower_statement(in, s);
  // A declared variable is visible from the end of its declaration to the end of the block around
  // it.
  const Span scope{scope_begin(s), s.span.end, s.span.source};
  if (s.kind == StmtKind::kInit) {
    in.homes.open(point, s.span.end);
  } else {
    in.homes.close(point, scope, in.code.position());
  }
}

static void lower_statement(Lowering& in, const Stmt& s) {
  switch (s.kind) {
    case StmtKind::kBlock:
      return block(in, s.as<Block>());
    case StmtKind::kInit:
      return init(in, s.as<InitStmt>());
    case StmtKind::kAssign:
      return assign(in, s.as<AssignStmt>());
    case StmtKind::kStorePart:
      return store_part(in, s.as<StorePartStmt>());
    case StmtKind::kExpr:
      return effect(in, *s.as<ExprStmt>().value);
    case StmtKind::kIf:
      return if_else(in, s.as<IfStmt>());
    case StmtKind::kLoop:
      return loop(in, s.as<LoopStmt>());
    case StmtKind::kRange:
      return range(in, s.as<RangeStmt>());
    case StmtKind::kForList:
      return for_list(in, s.as<ForListStmt>());
    case StmtKind::kSwitch:
      return switch_case(in, s.as<SwitchStmt>());
    case StmtKind::kTry:
      return try_catch(in, s.as<TryStmt>());
    case StmtKind::kThrow:
      return raise(in, s.as<ThrowStmt>());
    case StmtKind::kJump:
      return jump(in, s.as<JumpStmt>());
    case StmtKind::kReturn:
      return give_back(in, s.as<ReturnStmt>());
    case StmtKind::kAssert:
      return check(in, s.as<AssertStmt>());
    case StmtKind::kAssertThrows:
      return check_throws(in, s.as<AssertThrowsStmt>());
    case StmtKind::kWait:
      return wait(in, s.as<WaitStmt>());
    case StmtKind::kWaitUntil:
      return wait_until(in, s.as<WaitUntilStmt>());
    case StmtKind::kParallel:
      return parallel(in, s.as<ParallelStmt>());
    case StmtKind::kWhen:
      return when(in, s.as<WhenStmt>());
    case StmtKind::kEvery:
      return every(in, s.as<EveryStmt>());
  }
}

void block(Lowering& in, const Block& b) {
  const Emitter::Mark mark = in.code.mark();
  const Homes::Point point{in.homes.count(), in.code.position()};
  // A `when` or `every` at the top level of an entry stays active while later entries run.
  const bool lives_on =
      in.tables.program().entry.is_one && in.is_program() && &b == in.function.body;
  if (!lives_on && std::ranges::any_of(b.body, starts_watching)) {
    watched_block(in, b.body);
  } else {
    for (const Stmt* s : b.body) statement(in, *s);
  }
  in.homes.close(point, b.span, in.code.position());
  in.code.at({b.span.end, b.span.end, b.span.source});
  in.code.release(mark);
}

// ---- variables

// Gives a variable its register or its box.
static void declare(Lowering& in, const Variable& variable) {
  switch (variable.storage) {
    case Storage::kGlobal:
      break;
    case Storage::kLocal:
      in.homes.give(variable,
                    variable.type->is_reference() ? in.code.reference() : in.code.number());
      break;
    case Storage::kBoxed:
      in.homes.give(variable, in.code.reference());
      in.code.push(OpCode::BOX, in.homes.of(variable).bits, 0,
                   variable.type->is_reference() ? 1 : 0);
      break;
  }
}

// The register of a new variable has no value yet, so the expression may compute in it.
static void init(Lowering& in, const InitStmt& s) {
  const Variable& variable = *s.variable;
  declare(in, variable);
  if (s.value == nullptr) {
    // A debugger must not show the old contents of the register as the value of the variable.
    if (in.options.markers && variable.storage == Storage::kLocal)
      in.code.emit(variable.type->is_reference() ? OpCode::DROP : OpCode::ZERO,
                   in.homes.of(variable));
    return;
  }
  const Emitter::Mark mark = in.code.mark();
  in.uses.set_whole(s.value);
  if (variable.storage != Storage::kLocal) {
    store(in, variable, *s.value);
  } else if (variable.type->is_reference()) {
    own_into(in, *s.value, in.homes.of(variable));
  } else {
    value_into(in, *s.value, {in.homes.of(variable), true});
  }
  in.code.release(mark);
  note_set(in, variable);
}

// Declares a variable whose first value is in a register.
void init_from(Lowering& in, const Variable& variable, Reg value) {
  declare(in, variable);
  store_register(in, variable, value);
  note_set(in, variable);
}

void note_set(Lowering& in, const Variable& variable) {
  if (variable.storage == Storage::kGlobal && (variable.maybe_unset || variable.is_open)) {
    in.code.push(OpCode::GSET, variable.index, 0, 0);
  }
}

// ---- choices

static void if_else(Lowering& in, const IfStmt& s) {
  const Label end = in.code.label();
  const IfStmt* link = &s;
  for (;;) {
    const Label no = in.code.label();
    branch(in, *link->condition, false, no);
    scoped(in, *link->yes);
    if (link->no == nullptr) {
      in.code.bind(no);
      break;
    }
    in.code.jump(end);
    in.code.bind(no);
    if (link->no->kind != StmtKind::kIf) {
      scoped(in, *link->no);
      break;
    }
    link = &link->no->as<IfStmt>();
  }
  in.code.bind(end);
}

// Compiles a statement whose declarations, if it is one, are visible only inside of it.
void scoped(Lowering& in, const Stmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Stmt* only = &s;
  if (starts_watching(only)) {
    watched_block(in, {&only, 1});
  } else {
    statement(in, s);
  }
  in.code.release(mark);
}

static void switch_case(Lowering& in, const SwitchStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  declare(in, *s.subject);
  store(in, *s.subject, *s.value);
  const Label end = in.code.label();
  std::vector<Label> bodies;
  // If every value of an enum has its case and there is no default, the last case needs no test.
  const SwitchCase* fallback = nullptr;
  if (s.value->type->is(Kind::kEnum) && !s.cases.empty()) fallback = &s.cases.back();
  for (const SwitchCase& c : s.cases) {
    bodies.push_back(in.code.label());
    if (c.is_default) fallback = &c;
  }
  const Label otherwise =
      fallback == nullptr ? end : bodies[static_cast<std::size_t>(fallback - s.cases.data())];
  if (!switch_by_table(in, s, bodies, otherwise)) {
    for (std::size_t i = 0; i < s.cases.size(); ++i) {
      for (const Expr* test : s.cases[i].tests) branch(in, *test, true, bodies[i]);
    }
    in.code.jump(otherwise);
  }
  in.ways.begin(JumpTargets{&s, end, end, in.ways.tries(), {}, {}});
  for (std::size_t i = 0; i < s.cases.size(); ++i) {
    in.code.bind(bodies[i]);
    if (s.cases[i].body != nullptr) block(in, *s.cases[i].body);
    in.code.jump(end);
  }
  in.ways.end();
  in.code.bind(end);
  in.code.release(mark);
}

// The number in a case `subject == number`.
static bool number_of_case(const Expr& test, const Variable& subject, std::int64_t& out) {
  if (test.kind != ExprKind::kBinary || test.as<BinaryExpr>().op != Op::kEqI) return false;
  const auto& equal = test.as<BinaryExpr>();
  const bool asks = equal.left->kind == ExprKind::kVariable &&
                    equal.left->as<VariableExpr>().variable == &subject;
  return asks && small_int(*equal.right, out);
}

// Cases with numbers close together use a table of jumps, with the first case of each number.
static bool switch_by_table(Lowering& in, const SwitchStmt& s, const std::vector<Label>& bodies,
                            Label otherwise) {
  constexpr std::size_t kFewest = 4;
  if (!in.options.optimise || s.subject->storage != Storage::kLocal) return false;
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
  in.code.at(s.value->span, s.value);
  in.code.switch_on(in.homes.of(*s.subject), lowest, table, otherwise);
  return true;
}

// ---- going elsewhere

static void jump(Lowering& in, const JumpStmt& s) {
  const JumpTargets exit = in.ways.to(s.target);
  leave(in, exit.tries, [&] {
    if (s.jump == Jump::kRetry) in.code.emit(OpCode::RETRY, exit.retries, exit.instant);
    in.code.jump(s.jump == Jump::kBreak ? exit.leave : exit.again);
  });
}

static void give_back(Lowering& in, const ReturnStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  in.uses.set_whole(s.value);
  if (in.ways.is_expanding()) {
    give_back_here(in, *s.value);
  } else if (s.value == nullptr || s.value->type->is(Kind::kVoid)) {
    if (s.value != nullptr) effect(in, *s.value);
    leave(in, 0, [&] { in.code.emit(in.is_program() ? OpCode::HALT : OpCode::RETVOID); });
  } else if (s.value->type->is_reference()) {
    give_back_reference(in, *s.value);
  } else {
    Reg result;
    if (in.ways.finally_runs() || !in_register(in, *s.value, result)) {
      result = in.code.number();
      value_into(in, *s.value, {result, true});
    }
    leave(in, 0, [&] {
      in.code.emit(OpCode::RET, in.options.optimise ? in.code.moved_to_first(result) : result);
    });
  }
  in.code.release(mark);
}

// Returns a reference: local variables and new values are moved, values with other owners are
// counted.
static void give_back_reference(Lowering& in, const Expr& e) {
  if (!in.ways.finally_runs()) {
    const bool variable =
        e.kind == ExprKind::kVariable && e.as<VariableExpr>().variable->storage == Storage::kLocal;
    if (variable || e.kind == ExprKind::kField || e.kind == ExprKind::kElement) {
      const Reg result = borrow(in, e, Hold::kNow);
      in.code.emit(variable && result.is_reference() ? OpCode::RETTAKE : OpCode::RETREF, result);
      return;
    }
  }
  const Reg result = in.code.reference();
  own_into(in, e, result);
  leave(in, 0, [&] { in.code.emit(OpCode::RETTAKE, result); });
}

static void raise(Lowering& in, const ThrowStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Reg error = borrow(in, *s.value, Hold::kNow);
  in.code.at(s.span);
  in.code.emit(OpCode::THROW, error);
  in.code.release(mark);
}

// ---- waiting and checking

static void wait(Lowering& in, const WaitStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Reg seconds = value(in, *s.duration);
  in.code.at(s.duration->span, s.duration);
  in.code.emit(OpCode::WAIT, seconds);
  in.code.release(mark);
}

static void wait_until(Lowering& in, const WaitUntilStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Reg condition = borrow(in, *s.condition, Hold::kOwn);
  const Reg timeout = in.code.number();
  if (s.timeout != nullptr) {
    value_into(in, *s.timeout, {timeout, true});
  } else {
    in.code.constant(timeout, Slot{.i = kAbsentBits});
  }
  in.code.at(s.condition_span, s.condition);
  in.code.push(OpCode::WAITUNTIL, condition.bits, timeout.bits, in.tables.add_wait(s));
  in.code.release(mark);
}

static void check(Lowering& in, const AssertStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  for (const InitStmt* part : s.parts_init) init(in, *part);
  const Label holds = in.code.label();
  branch(in, *s.condition, true, holds);
  const Emitter::Mark inner = in.code.mark();
  const Reg note = s.note != nullptr ? borrow(in, *s.note, Hold::kOwn) : null_reference(in);
  const Reg why = s.explain != nullptr ? borrow(in, *s.explain, Hold::kOwn) : null_reference(in);
  const std::uint32_t index = in.tables.add_assert(s);
  std::vector<Reg> registers;
  for (const AssertPart& part : s.shown) registers.push_back(in.homes.of(*part.variable));
  in.code.shown(index, std::move(registers));
  in.code.at(s.condition_span, s.condition);
  in.code.push(OpCode::ASSERTFAIL, index, note.bits, why.bits);
  in.code.release(inner);
  in.code.bind(holds);
  in.code.release(mark);
}

}  // namespace armlet::lang
