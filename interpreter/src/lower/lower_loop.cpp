// Compiles loops. The test is at the end of the body, so that each iteration has one jump.

#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void begin_loop(Lowering& in, const Stmt& s);
static void end_loop(Lowering& in, Emitter::Mark mark);
static void pin_globals(Lowering& in, const Summary& summary);
static void plain_loop(Lowering& in, const LoopStmt& s);
static bool counted_loop(Lowering& in, const LoopStmt& s, const Summary& body);
static bool loop_bound(Lowering& in, const Expr& e, const Summary& body, Reg& out);
static void count_up(Lowering& in, Span test, Reg counter, Reg last, const Pass& pass);
static void range_pass(Lowering& in, const RangeStmt& s, Reg counter);
static Reg range_end(Lowering& in, const Expr& e, const Summary& body);
static void count_by(Lowering& in, const RangeStmt& s, Reg counter, Reg last, RangeStep step,
                     const Pass& pass);
static Reg visited_list(Lowering& in, const Expr& items, const Summary& body);
static std::uint32_t line_of(const Lowering& in, Span span);

namespace {

bool is_true(const Expr* condition) {
  Slot slot;
  return condition == nullptr || (constant_slot(*condition, slot) && slot.i != 0);
}

bool is_variable(const Expr& e, const Variable& variable) {
  return e.kind == ExprKind::kVariable && e.as<VariableExpr>().variable == &variable;
}

// The int variable of this function that the step of a loop changes by a constant, as i++ does;
// null for any other step.
const Variable* counted_variable(const Stmt* step, std::int64_t& by) {
  if (step == nullptr) return nullptr;
  if (step->kind == StmtKind::kBlock && step->as<Block>().body.size() == 1) {
    step = step->as<Block>().body[0];
  }
  if (step->kind != StmtKind::kAssign) return nullptr;
  const auto& s = step->as<AssignStmt>();
  const Variable& variable = *s.place.variable;
  if (!s.place.steps.empty() || variable.storage != Storage::kLocal ||
      !variable.type->is(Kind::kInt)) {
    return nullptr;
  }
  const Expr* amount = s.value;
  Op op = s.op;
  if (!s.compound) {
    if (s.value->kind != ExprKind::kBinary) return nullptr;
    const auto& sum = s.value->as<BinaryExpr>();
    if (!is_variable(*sum.left, variable)) return nullptr;
    amount = sum.right;
    op = sum.op;
  }
  if ((op != Op::kAddI && op != Op::kSubI) || !small_int(*amount, by) || by == 0) return nullptr;
  if (op == Op::kSubI) by = -by;
  return &variable;
}

}  // namespace

static std::uint32_t line_of(const Lowering& in, Span span) {
  const auto& sources = in.tables.program().sources;
  return sources == nullptr ? 0 : static_cast<std::uint32_t>(sources->position(span).line);
}

// Keeps global variables in registers while a loop runs that calls no other code of the program.
// Variables that a host may change between two iterations stay in memory.
static void pin_globals(Lowering& in, const Summary& summary) {
  if (!in.options.optimise || !summary.quiet) return;
  for (const VariableUse& use : summary.uses) {
    const Variable& variable = *use.variable;
    Reg reg;
    if (variable.storage != Storage::kGlobal || use.assigned || in.loops.is_pinned(variable, reg))
      continue;
    if (variable.is_open && !variable.fixed) continue;
    if (use.element && use.whole) continue;
    reg = in.code.number();
    in.code.push(use.element ? OpCode::GOWN : OpCode::GLOAD, reg.bits, variable.index, 0);
    in.loops.pin(variable, reg);
  }
}

// ---- while, do, for (;;)

void loop(Lowering& in, const LoopStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  in.loops.begin();
  pin_globals(in, summarise(s, in.tables.inlined()));
  begin_loop(in, s);
  const std::uint32_t begin = in.code.position();
  const Summary body = summarise(*s.body, in.tables.inlined());
  if (!counted_loop(in, s, body)) plain_loop(in, s);
  std::int64_t by = 0;
  const Variable* counter = counted_variable(s.step, by);
  Slot first;
  if (counter != nullptr && !body.assigns(counter) && counter->init != nullptr &&
      constant_slot(*counter->init, first)) {
    in.code.loop({begin, in.code.position()}, in.homes.of(*counter), first.i, by,
                 line_of(in, s.span));
  }
  end_loop(in, mark);
}

static void plain_loop(Lowering& in, const LoopStmt& s) {
  const Label body = in.code.label();
  const bool endless = is_true(s.condition);
  // The test is compiled twice: before the first iteration, and at the end of the body, where it
  // can be joined with the increment.
  if (s.test_first && !endless) branch(in, *s.condition, false, in.ways.innermost().leave);
  in.code.bind_loop(body, in.code.reachable());
  scoped(in, *s.body);
  in.code.bind(in.ways.innermost().again);
  if (s.step != nullptr) scoped(in, *s.step);
  in.code.at(s.span);
  if (endless) {
    in.code.jump(body);
  } else {
    branch(in, *s.condition, true, body);
  }
}

// for (int i = ...; i < n; i++): one instruction increments, tests and jumps.
static bool counted_loop(Lowering& in, const LoopStmt& s, const Summary& body) {
  std::int64_t by = 0;
  const Variable* counter = counted_variable(s.step, by);
  if (!in.options.optimise || counter == nullptr || by != 1 || body.assigns(counter)) return false;
  if (!s.test_first || s.condition == nullptr || s.condition->kind != ExprKind::kBinary)
    return false;
  const auto& test = s.condition->as<BinaryExpr>();
  Reg last;
  if (test.op != Op::kLtI || test.constant != nullptr || !is_variable(*test.left, *counter) ||
      !loop_bound(in, *test.right, body, last)) {
    return false;
  }
  count_up(in, s.condition->span, in.homes.of(*counter), last, [&] { scoped(in, *s.body); });
  return true;
}

// The register of a bound that does not change during the loop: a constant, a variable, or the
// length of a list or text that keeps its length.
static bool loop_bound(Lowering& in, const Expr& e, const Summary& body, Reg& out) {
  if (in_register(in, e, out)) return true;
  if (e.kind != ExprKind::kLength) return false;
  const Expr& list = *e.as<LengthExpr>().object;
  const bool has_length = list.type->is(Kind::kList) || list.type->is(Kind::kText);
  if (list.kind != ExprKind::kVariable || !has_length) return false;
  const Variable& variable = *list.as<VariableExpr>().variable;
  Reg pinned;
  const bool in_reach = variable.storage == Storage::kLocal || in.loops.is_pinned(variable, pinned);
  if (!in_reach || body.assigns(&variable)) return false;
  out = in.code.number();
  value_into(in, e, {out, true});
  return true;
}

// Iterates while counter < last, with steps of one. Exits are those of the innermost loop.
static void count_up(Lowering& in, Span test, Reg counter, Reg last, const Pass& pass) {
  const Label body = in.code.label();
  const bool alive = in.code.reachable();
  in.code.at(test);
  in.code.emit(OpCode::IFGEI, counter, last);
  in.code.jump(in.ways.innermost().leave);
  in.code.bind_loop(body, alive);
  pass();
  in.code.bind(in.ways.innermost().again);
  in.code.at(test);
  in.code.emit(OpCode::FORI, counter, last);
  in.code.jump(body);
}

// ---- for (x in ...)

void range(Lowering& in, const RangeStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  in.loops.begin();
  const Summary body = summarise(*s.body, in.tables.inlined());
  const Reg counter = in.code.number();
  value_into(in, *s.first, {counter, true});
  const Reg last = range_end(in, *s.last, body);
  RangeStep step;
  if (s.step != nullptr && (!small_int(*s.step, step.by) || step.by == 0)) {
    step.reg = in.code.number();
    value_into(in, *s.step, {step.reg, true});
    step.by = 0;
  }
  pin_globals(in, body);
  begin_loop(in, s);
  const std::uint32_t begin = in.code.position();
  const auto pass = [&] { range_pass(in, s, counter); };
  if (in.options.optimise && step.by == 1) {
    count_up(in, s.span, counter, last, pass);
  } else {
    count_by(in, s, counter, last, step, pass);
  }
  Slot first;
  const bool told = constant_slot(*s.first, first);
  in.code.loop({begin, in.code.position()}, counter, told ? first.i : 0, told ? step.by : 0,
               line_of(in, s.span));
  end_loop(in, mark);
}

static void range_pass(Lowering& in, const RangeStmt& s, Reg counter) {
  const Emitter::Mark mark = in.code.mark();
  if (s.variable->storage == Storage::kLocal) {
    in.homes.give(*s.variable, counter);
  } else {
    init_from(in, *s.variable, counter);
  }
  statement(in, *s.body);
  in.code.release(mark);
}

// The end of a range, evaluated once. A variable that the body changes is copied.
static Reg range_end(Lowering& in, const Expr& e, const Summary& body) {
  Reg reg;
  const Variable* variable = root_variable(e);
  if ((variable == nullptr || !body.assigns(variable)) && in_register(in, e, reg)) return reg;
  reg = in.code.number();
  value_into(in, e, {reg, true});
  return reg;
}

// A range with any step: it counts up while below the end, or down while above it. A step of zero
// fails.
static void count_by(Lowering& in, const RangeStmt& s, Reg counter, Reg last, RangeStep step,
                     const Pass& pass) {
  const Label body = in.code.label();
  const Label test = in.code.label();
  const JumpTargets exit = in.ways.innermost();
  const bool alive = in.code.reachable();
  if (step.by != 0) {
    step.reg = in.code.number();
    in.code.constant(step.reg, slot_of(step.by));
    in.code.at(s.span);
    in.code.emit(step.by > 0 ? OpCode::IFGEI : OpCode::IFLEI, counter, last);
    in.code.jump(exit.leave);
  } else {
    in.code.jump(test);
  }
  in.code.bind_loop(body, alive);
  pass();
  in.code.bind(exit.again);
  in.code.at(s.span);
  in.code.emit(OpCode::STRIDE, counter, counter, step.reg);
  if (step.by != 0) {
    in.code.emit(step.by > 0 ? OpCode::IFLTI : OpCode::IFGTI, counter, last);
    in.code.jump(body);
    return;
  }
  in.code.bind(test);
  const Label down = in.code.label();
  in.code.push(OpCode::IFLEIK, step.reg.bits, 0, 0);
  in.code.jump(down);
  in.code.emit(OpCode::IFLTI, counter, last);
  in.code.jump(body);
  in.code.jump(exit.leave);
  in.code.bind(down);
  in.code.at(s.step->span, s.step);
  in.code.emit(OpCode::CHECKSTEP, step.reg);
  in.code.at(s.span);
  in.code.emit(OpCode::IFGTI, counter, last);
  in.code.jump(body);
}

void for_list(Lowering& in, const ForListStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  in.loops.begin();
  const Summary body = summarise(*s.body, in.tables.inlined());
  const Reg list = visited_list(in, *s.items, body);
  const Variable* lender = root_variable(*s.items);
  if (lender != nullptr) in.uses.lend(*lender);
  const Reg counter = in.code.number();
  const Reg last = in.code.number();
  const Reg item = in.code.number();
  in.code.at(s.span);
  in.code.emit(OpCode::LEN, last, list);
  in.code.constant(counter, slot_of(std::int64_t{0}));
  pin_globals(in, body);
  begin_loop(in, s);
  const std::uint32_t begin = in.code.position();
  count_up(in, s.span, counter, last, [&] {
    const Emitter::Mark pass = in.code.mark();
    load_item(in, item, list, counter, *s.variable->type, *s.items);
    // The list owns the element, so the loop variable borrows it.
    if (s.variable->storage == Storage::kLocal) {
      in.homes.give(*s.variable, item);
    } else {
      init_from(in, *s.variable, item);
    }
    statement(in, *s.body);
    in.code.release(pass);
  });
  if (lender != nullptr) in.uses.take_back();
  in.code.loop({begin, in.code.position()}, counter, 0, 1, line_of(in, s.span));
  end_loop(in, mark);
}

// The list at the beginning of the loop. Its count is increased if the body could change the
// variable.
static Reg visited_list(Lowering& in, const Expr& items, const Summary& body) {
  if (items.kind == ExprKind::kVariable) {
    const Variable& variable = *items.as<VariableExpr>().variable;
    const VariableUse* use = body.find(&variable);
    const bool changes = use != nullptr && (use->assigned || use->element);
    if (variable.storage == Storage::kLocal && !changes) return in.homes.of(variable);
  }
  return borrow(in, items, Hold::kOwn);
}

static void begin_loop(Lowering& in, const Stmt& s) {
  in.ways.begin(JumpTargets{&s, in.code.label(), in.code.label(), in.ways.tries(), {}, {}});
}

static void end_loop(Lowering& in, Emitter::Mark mark) {
  const Label leave = in.ways.innermost().leave;
  in.ways.end();
  in.loops.end();
  in.code.bind(leave);
  in.code.release(mark);
}

}  // namespace armlet::lang
