// Loops. The test stands at the bottom, so that a pass costs one jump.

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

bool is_true(const Expr* condition) {
  Slot slot;
  return condition == nullptr || (constant_slot(*condition, slot) && slot.i != 0);
}

bool is_variable(const Expr& e, const Variable& variable) {
  return e.kind == ExprKind::kVariable && e.as<VariableExpr>().variable == &variable;
}

// The int variable of this function that `step` moves by a constant, as in i++; null if it does
// something else.
Variable* counted_variable(const Stmt* step, std::int64_t& by) {
  if (step == nullptr) return nullptr;
  if (step->kind == StmtKind::kBlock && step->as<Block>().body.size() == 1) {
    step = step->as<Block>().body[0];
  }
  if (step->kind != StmtKind::kAssign) return nullptr;
  const auto& s = step->as<AssignStmt>();
  Variable& variable = *s.place.variable;
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

std::uint32_t Lowering::line_of(Span span) const {
  const auto& sources = tables_.program().sources;
  return sources == nullptr ? 0 : static_cast<std::uint32_t>(sources->position(span).line);
}

bool Lowering::pinned_global(const Variable* variable, Reg& out) const {
  const auto known = pinned_registers_.find(variable);
  if (known == pinned_registers_.end()) return false;
  out = known->second;
  return true;
}

// While a quiet loop runs, nobody else changes the program's variables: they stay in registers.
void Lowering::pin_globals(const Summary& summary) {
  if (!options_.optimise || !summary.quiet) return;
  for (const VariableUse& use : summary.uses) {
    const Variable& variable = *use.variable;
    Reg reg;
    if (variable.storage != Storage::kGlobal || use.assigned || pinned_global(&variable, reg))
      continue;
    if (use.element && use.whole) continue;
    reg = code_.number();
    code_.push(use.element ? OpCode::GOWN : OpCode::GLOAD, reg.bits, variable.index, 0);
    pinned_globals_.push_back(&variable);
    pinned_registers_.emplace(&variable, reg);
  }
}

// ---- while, do, for (;;)
// ------------------------------------------------------------------------------------------

void Lowering::loop(const LoopStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const std::size_t pinned = pinned_globals_.size();
  ++loop_depth_;
  pin_globals(summarise(s));
  begin_loop(s);
  const std::uint32_t begin = code_.position();
  const Summary body = summarise(*s.body);
  if (!counted_loop(s, body)) plain_loop(s);
  std::int64_t by = 0;
  const Variable* counter = counted_variable(s.step, by);
  Slot first;
  if (counter != nullptr && !body.assigns(counter) && counter->init != nullptr &&
      constant_slot(*counter->init, first)) {
    code_.loop({begin, code_.position()}, reg_of(*counter), first.i, by, line_of(s.span));
  }
  end_loop(mark, pinned);
}

void Lowering::plain_loop(const LoopStmt& s) {
  const Label body = code_.label();
  const bool endless = is_true(s.condition);
  // The test is made twice: before the first pass, and below with the counting just before it.
  if (s.test_first && !endless) branch(*s.condition, false, exits_.back().leave);
  code_.bind_loop(body, code_.reachable());
  scoped(*s.body);
  code_.bind(exits_.back().again);
  if (s.step != nullptr) scoped(*s.step);
  code_.at(s.span);
  if (endless) {
    code_.jump(body);
  } else {
    branch(*s.condition, true, body);
  }
}

// for (int i = ...; i < n; i++): one instruction counts, tests and jumps.
bool Lowering::counted_loop(const LoopStmt& s, const Summary& body) {
  std::int64_t by = 0;
  const Variable* counter = counted_variable(s.step, by);
  if (!options_.optimise || counter == nullptr || by != 1 || body.assigns(counter)) return false;
  if (!s.test_first || s.condition == nullptr || s.condition->kind != ExprKind::kBinary)
    return false;
  const auto& test = s.condition->as<BinaryExpr>();
  Reg last;
  if (test.op != Op::kLtI || test.constant != nullptr || !is_variable(*test.left, *counter) ||
      !loop_bound(*test.right, body, last)) {
    return false;
  }
  count_up(s.condition->span, reg_of(*counter), last, [&] { scoped(*s.body); });
  return true;
}

// A bound that stays in a register: a number, a variable, or the length of a list or text that
// keeps its length.
bool Lowering::loop_bound(const Expr& e, const Summary& body, Reg& out) {
  if (in_register(e, out)) return true;
  if (e.kind != ExprKind::kLength) return false;
  const Expr& list = *e.as<LengthExpr>().object;
  const bool has_length = list.type->is(Kind::kList) || list.type->is(Kind::kText);
  if (list.kind != ExprKind::kVariable || !has_length) return false;
  const Variable& variable = *list.as<VariableExpr>().variable;
  Reg pinned;
  const bool in_reach = variable.storage == Storage::kLocal || pinned_global(&variable, pinned);
  if (!in_reach || body.assigns(&variable)) return false;
  out = code_.number();
  value_into(e, {out, true});
  return true;
}

// Passes while counter < last, counting by one. The loop's exits are the innermost ones.
void Lowering::count_up(Span test, Reg counter, Reg last, const Pass& pass) {
  const Label body = code_.label();
  const bool alive = code_.reachable();
  code_.at(test);
  code_.emit(OpCode::IFGEI, counter, last);
  code_.jump(exits_.back().leave);
  code_.bind_loop(body, alive);
  pass();
  code_.bind(exits_.back().again);
  code_.at(test);
  code_.emit(OpCode::FORI, counter, last);
  code_.jump(body);
}

// ---- for (x in ...)
// -----------------------------------------------------------------------------------------------

void Lowering::range(const RangeStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const std::size_t pinned = pinned_globals_.size();
  ++loop_depth_;
  const Summary body = summarise(*s.body);
  const Reg counter = code_.number();
  value_into(*s.first, {counter, true});
  const Reg last = range_end(*s.last, body);
  RangeStep step;
  if (s.step != nullptr && (!small_int(*s.step, step.by) || step.by == 0)) {
    step.reg = code_.number();
    value_into(*s.step, {step.reg, true});
    step.by = 0;
  }
  pin_globals(body);
  begin_loop(s);
  const std::uint32_t begin = code_.position();
  const auto pass = [&] { range_pass(s, counter); };
  if (options_.optimise && step.by == 1) {
    count_up(s.span, counter, last, pass);
  } else {
    count_by(s, counter, last, step, pass);
  }
  Slot first;
  const bool told = constant_slot(*s.first, first);
  code_.loop({begin, code_.position()}, counter, told ? first.i : 0, told ? step.by : 0,
             line_of(s.span));
  end_loop(mark, pinned);
}

void Lowering::range_pass(const RangeStmt& s, Reg counter) {
  const Emitter::Mark mark = code_.mark();
  if (s.variable->storage == Storage::kLocal) {
    s.variable->index = counter.bits;
  } else {
    init_from(*s.variable, counter);
  }
  statement(*s.body);
  code_.release(mark);
}

// The end of a range is evaluated once: a variable that the body changes is copied.
Reg Lowering::range_end(const Expr& e, const Summary& body) {
  Reg reg;
  const Variable* variable = root_variable(e);
  if ((variable == nullptr || !body.assigns(variable)) && in_register(e, reg)) return reg;
  reg = code_.number();
  value_into(e, {reg, true});
  return reg;
}

// A range by any step: up while below the end, down while above it. A step of zero is refused.
void Lowering::count_by(const RangeStmt& s, Reg counter, Reg last, RangeStep step,
                        const Pass& pass) {
  const Label body = code_.label();
  const Label test = code_.label();
  const Exit exit = exits_.back();
  const bool alive = code_.reachable();
  if (step.by != 0) {
    step.reg = code_.number();
    code_.constant(step.reg, slot_of(step.by));
    code_.at(s.span);
    code_.emit(step.by > 0 ? OpCode::IFGEI : OpCode::IFLEI, counter, last);
    code_.jump(exit.leave);
  } else {
    code_.jump(test);
  }
  code_.bind_loop(body, alive);
  pass();
  code_.bind(exit.again);
  code_.at(s.span);
  code_.emit(OpCode::STRIDE, counter, counter, step.reg);
  if (step.by != 0) {
    code_.emit(step.by > 0 ? OpCode::IFLTI : OpCode::IFGTI, counter, last);
    code_.jump(body);
    return;
  }
  code_.bind(test);
  const Label down = code_.label();
  code_.push(OpCode::IFLEIK, step.reg.bits, 0, 0);
  code_.jump(down);
  code_.emit(OpCode::IFLTI, counter, last);
  code_.jump(body);
  code_.jump(exit.leave);
  code_.bind(down);
  code_.at(s.step->span, s.step);
  code_.emit(OpCode::CHECKSTEP, step.reg);
  code_.at(s.span);
  code_.emit(OpCode::IFGTI, counter, last);
  code_.jump(body);
}

void Lowering::for_list(const ForListStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const std::size_t pinned = pinned_globals_.size();
  ++loop_depth_;
  const Summary body = summarise(*s.body);
  const Reg list = visited_list(*s.items, body);
  const Variable* lender = root_variable(*s.items);
  if (lender != nullptr) lent_.push_back(lender);
  const Reg counter = code_.number();
  const Reg last = code_.number();
  const Reg item = code_.number();
  code_.at(s.span);
  code_.emit(OpCode::LEN, last, list);
  code_.constant(counter, slot_of(std::int64_t{0}));
  pin_globals(body);
  begin_loop(s);
  const std::uint32_t begin = code_.position();
  count_up(s.span, counter, last, [&] {
    const Emitter::Mark pass = code_.mark();
    load_item(item, list, counter, *s.variable->type, *s.items);
    // The list owns the item, so the variable only borrows it.
    if (s.variable->storage == Storage::kLocal) {
      s.variable->index = item.bits;
    } else {
      init_from(*s.variable, item);
    }
    statement(*s.body);
    code_.release(pass);
  });
  if (lender != nullptr) lent_.pop_back();
  code_.loop({begin, code_.position()}, counter, 0, 1, line_of(s.span));
  end_loop(mark, pinned);
}

// The list as it is when the loop begins: counted if the body could change it.
Reg Lowering::visited_list(const Expr& items, const Summary& body) {
  if (items.kind == ExprKind::kVariable) {
    const Variable& variable = *items.as<VariableExpr>().variable;
    const VariableUse* use = body.find(&variable);
    const bool changes = use != nullptr && (use->assigned || use->element);
    if (variable.storage == Storage::kLocal && !changes) return reg_of(variable);
  }
  return borrow(items, Hold::kOwn);
}

void Lowering::begin_loop(const Stmt& s) {
  exits_.push_back({&s, code_.label(), code_.label(), tries_.size(), {}, {}});
}

void Lowering::end_loop(Emitter::Mark mark, std::size_t pinned) {
  const Label leave = exits_.back().leave;
  exits_.pop_back();
  --loop_depth_;
  while (pinned_globals_.size() > pinned) {
    pinned_registers_.erase(pinned_globals_.back());
    pinned_globals_.pop_back();
  }
  code_.bind(leave);
  code_.release(mark);
}

}  // namespace armlet::lang
