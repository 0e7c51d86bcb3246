// Assignments: variables, and places inside lists and records.

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

// ---- whole variables
// ----------------------------------------------------------------------------------------------

// Reading or changing a variable of the program before its declaration has run is an error.
void Lowering::check_set(const Variable& variable) {
  if (variable.storage == Storage::kGlobal && variable.maybe_unset) {
    code_.push(OpCode::GCHECK, variable.index, 0, 0);
  }
}

void Lowering::assign(const AssignStmt& s) {
  if (!s.place.steps.empty()) {
    assign_inside(s);
  } else if (s.compound) {
    assign_compound(s);
  } else {
    assign_whole(s);
  }
}

// A variable declared without a value is set by its first assignment.
void Lowering::assign_whole(const AssignStmt& s) {
  const Variable& variable = *s.place.variable;
  code_.at(s.span);
  if (variable.init != nullptr) check_set(variable);
  whole_ = s.value;
  store(variable, *s.value);
  if (variable.init == nullptr) note_set(variable);
}

void Lowering::store(const Variable& variable, const Expr& value) {
  const bool reference = variable.type->is_reference();
  const Emitter::Mark mark = code_.mark();
  if (variable.storage == Storage::kLocal) {
    if (!reference) {
      value_into(value, {reg_of(variable), can_write_early(variable, value)});
    } else if (!append_text(variable, value)) {
      own_into(value, reg_of(variable));
    }
  } else {
    const Reg from = reference ? borrow(value, Hold::kNow) : this->value(value);
    store_register(variable, from);
  }
  code_.release(mark);
}

void Lowering::store_register(const Variable& variable, Reg from) {
  const bool reference = variable.type->is_reference();
  switch (variable.storage) {
    case Storage::kLocal:
      code_.emit(reference ? OpCode::MOVEREF : OpCode::MOVE, reg_of(variable), from);
      break;
    case Storage::kBoxed:
      code_.emit(reference ? OpCode::BSTOREREF : OpCode::BSTORE, reg_of(variable), from);
      break;
    case Storage::kGlobal:
      code_.push(reference ? OpCode::GSTOREREF : OpCode::GSTORE, variable.index, from.bits, 0);
      break;
  }
}

// x = ... may use x as its work register if x is read first, or not at all, and nothing can fail
// half-way.
bool Lowering::can_write_early(const Variable& variable, const Expr& value) const {
  if (!options_.optimise || !is_plain(value)) return false;
  const Expr* e = &value;
  for (; e->kind == ExprKind::kBinary; e = e->as<BinaryExpr>().left) {
    if (mentions(*e->as<BinaryExpr>().right, variable)) return false;
  }
  return e->kind == ExprKind::kVariable || !mentions(*e, variable);
}

// s = s + t grows s in place.
bool Lowering::append_text(const Variable& variable, const Expr& value) {
  if (!options_.optimise || value.kind != ExprKind::kConcat || value.constant != nullptr)
    return false;
  const std::vector<Expr*> parts = joined_parts(value.as<ConcatExpr>());
  if (parts.size() < 2 || parts.size() > 8) return false;
  const auto is_variable = [&](const Expr& e) {
    return e.kind == ExprKind::kVariable && e.as<VariableExpr>().variable == &variable;
  };
  if (!is_variable(*parts[0])) return false;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (mentions(*parts[i], variable)) return false;
  }
  std::vector<Reg> added;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    Hold hold = Hold::kNow;
    for (std::size_t later = i + 1; later < parts.size(); ++later) {
      hold = stronger(hold, hold_over(*parts[later]));
    }
    added.push_back(borrow(*parts[i], hold));
  }
  code_.at(value.span, &value);
  for (const Reg part : added) code_.emit(OpCode::APPEND, reg_of(variable), part);
  return true;
}

// x += value for numbers.
void Lowering::assign_compound(const AssignStmt& s) {
  const Variable& variable = *s.place.variable;
  const Emitter::Mark mark = code_.mark();
  code_.at(s.span);
  if (variable.storage == Storage::kLocal) {
    operate(s, reg_of(variable), reg_of(variable));
  } else {
    check_set(variable);
    const Reg old = code_.number();
    const Addend added = addend(s);
    load_variable(variable, old);
    add_to(s, added, old);
    store_register(variable, old);
  }
  code_.release(mark);
}

// The right side, evaluated before the place is read: what it changes counts. What cannot fail may
// wait.
Lowering::Addend Lowering::addend(const AssignStmt& s) {
  Addend out;
  if (is_plain(*s.value)) return out;
  out.is_evaluated = true;
  const bool is_sum = s.op == Op::kAddR || s.op == Op::kSubR;
  out.is_product = options_.optimise && is_sum && is_product(*s.value);
  if (!out.is_product) {
    out.first = value(*s.value);
    return out;
  }
  out.first = value(*s.value->as<BinaryExpr>().left);
  out.second = value(*s.value->as<BinaryExpr>().right);
  return out;
}

// The product is rounded, then the sum: the same bits as two instructions.
void Lowering::add_to(const AssignStmt& s, const Addend& added, Reg to) {
  if (!added.is_evaluated) return operate(s, to, to);
  code_.at(s.span);
  if (added.is_product) {
    code_.emit(s.op == Op::kAddR ? OpCode::MADD : OpCode::MSUB, to, added.first, added.second);
  } else {
    code_.emit(arithmetic_instruction(s.op), to, to, added.first);
  }
}

// to = left op s.value
void Lowering::operate(const AssignStmt& s, Reg left, Reg to) {
  arithmetic({s.span, nullptr}, s.op, left, *s.value, to);
}

// ---- inside lists and records
// -------------------------------------------------------------------------------------

static bool is_literal_text(const Expr& e) { return e.kind == ExprKind::kText; }

// What stands in the brackets is evaluated first, then the value; then the way to the place is
// walked at once.
void Lowering::assign_inside(const AssignStmt& s) {
  const Emitter::Mark mark = code_.mark();
  code_.at(s.span);
  check_set(*s.place.variable);
  const Indices indices = index_values(s.place);
  if (s.place.type->is_reference()) {
    const Reg from = borrow(*s.value, hold_for(s.place, *s.value));
    const Reg to = address(s.place, indices, Missing::kIsMade);
    code_.emit(OpCode::PUTREF, to, from);
  } else if (!s.compound) {
    store_inside(s.place, indices, value(*s.value));
  } else if (!add_product_inside(s, indices) && !operate_inside(s, indices)) {
    const Reg now = code_.number();
    const Addend added = addend(s);
    load_place(s.place, indices, now);
    add_to(s, added, now);
    store_inside(s.place, indices, now);
  }
  code_.release(mark);
}

// xs[i].field += a * b in one instruction.
bool Lowering::add_product_inside(const AssignStmt& s, const Indices& indices) {
  const auto& steps = s.place.steps;
  if (s.op != Op::kAddR || steps.size() != 2 || steps[0].is_field || !steps[1].is_field ||
      has_key(s.place) || leads_through_unset(s.place))
    return false;
  if (!can_own(*s.place.variable) || !is_product(*s.value) || !is_plain(*s.value)) return false;
  const auto& product = s.value->as<BinaryExpr>();
  const Reg a = value(*product.left);
  const Reg b = value(*product.right);
  const Reg list = own_register(*s.place.variable);
  code_.at(steps[0].span);
  code_.emit(OpCode::MADDLF, list, indices[0].index);
  code_.push(OpCode::FACTORS, a.bits, b.bits, steps[1].field);
  return true;
}

// rows[i][j] += value: the row is looked up once. Likewise xs[i] += value where xs is a variable of
// the program.
bool Lowering::operate_inside(const AssignStmt& s, const Indices& indices) {
  const Step& last = s.place.steps.back();
  if (last.is_field || last.column != nullptr) return false;
  if (!can_own(*s.place.variable) || !is_chain_of_objects(s.place)) return false;
  const Addend added = addend(s);
  const Reg object = own_register(*s.place.variable);
  const Reg inner = s.place.steps.size() < 2 ? object : owned_inside(s.place, indices, object);
  const Reg now = code_.number();
  code_.at(last.span);
  code_.emit(OpCode::LD, now, inner, indices.back().index);
  add_to(s, added, now);
  code_.at(last.span);
  code_.emit(OpCode::ST, inner, indices.back().index, now);
  return true;
}

// All steps but the last lead to lists or records, and the last one is inside one.
bool Lowering::is_chain_of_objects(const Place& place) const {
  if (has_key(place) || leads_through_unset(place)) return false;
  for (std::size_t i = 0; i + 1 < place.steps.size(); ++i) {
    if (place.steps[i].column != nullptr) return false;
  }
  return true;
}

// What the last step leads into, which nobody else sees from here on.
Reg Lowering::owned_inside(const Place& place, const Indices& indices, Reg object) {
  const Reg inner = code_.number();
  for (std::size_t i = 0; i + 1 < place.steps.size(); ++i) {
    const Step& step = place.steps[i];
    code_.at(step.span);
    if (step.is_field) {
      code_.push(OpCode::OWNEDF, inner.bits, object.bits, step.field);
    } else {
      code_.emit(OpCode::OWNED, inner, object, indices[i].index);
    }
    object = inner;
  }
  return inner;
}

Lowering::Indices Lowering::index_values(const Place& place) {
  Indices indices;
  for (const Step& step : place.steps) {
    StepIndex at;
    if (step.map != nullptr) {
      at.index = key(*step.index, is_literal_text(*step.index) ? Hold::kNow : Hold::kOwn);
    } else if (!step.is_field) {
      at.index = value(*step.index);
    }
    if (step.column != nullptr) at.column = value(*step.column);
    indices.push_back(at);
  }
  return indices;
}

// A value that is part of the variable it is stored into is counted first, so that no object can
// come to hold itself.
Hold Lowering::hold_for(const Place& place, const Expr& value) {
  return root_variable(value) == place.variable ? Hold::kOwn : Hold::kNow;
}

// Stores may change the list or record of the variable in a register.
bool Lowering::can_own(const Variable& variable) const {
  if (!options_.optimise) return false;
  return variable.storage == Storage::kGlobal ||
         (variable.storage == Storage::kLocal && reg_of(variable).is_reference());
}

// That register; of a variable of the program good until anything else runs.
Reg Lowering::own_register(const Variable& variable) {
  Reg reg;
  if (variable.storage == Storage::kLocal) return reg_of(variable);
  if (pinned_global(&variable, reg)) return reg;
  reg = code_.number();
  code_.push(OpCode::GOWN, reg.bits, variable.index, 0);
  return reg;
}

void Lowering::store_inside(const Place& place, const Indices& indices, Reg from) {
  if (!can_own(*place.variable) || !is_chain_of_objects(place)) {
    const Reg to = address(place, indices, Missing::kIsMade);
    code_.emit(OpCode::PUT, to, from);
    return;
  }
  Reg object = own_register(*place.variable);
  const std::size_t steps = place.steps.size();
  const Step& first = place.steps[0];
  const Step& last = place.steps.back();
  if (steps == 2 && !first.is_field && last.column == nullptr) {
    code_.at(first.span);
    code_.emit(last.is_field ? OpCode::STLF : OpCode::STLD, object, indices[0].index, from);
    code_.at(last.span);
    if (last.is_field) {
      code_.word(last.field);
    } else {
      code_.emit(OpCode::WITH, indices[1].index);
    }
    return;
  }
  if (steps > 1) object = owned_inside(place, indices, object);
  code_.at(last.span);
  if (last.is_field) {
    code_.push(OpCode::STF, object.bits, last.field, from.bits);
  } else if (last.column != nullptr) {
    code_.emit(OpCode::STM, object, indices.back().index, from);
    code_.emit(OpCode::WITH, indices.back().column);
  } else {
    code_.emit(OpCode::ST, object, indices.back().index, from);
  }
}

// The address of the place, good until anything else runs.
Reg Lowering::address(const Place& place, const Indices& indices, Missing missing) {
  const Variable& variable = *place.variable;
  const Reg to = code_.number();
  switch (variable.storage) {
    case Storage::kLocal:
      code_.emit(OpCode::ADDRL, to, reg_of(variable));
      break;
    case Storage::kBoxed:
      code_.emit(OpCode::ADDRB, to, reg_of(variable));
      break;
    case Storage::kGlobal:
      code_.push(OpCode::ADDRG, to.bits, variable.index, 0);
      break;
  }
  for (std::size_t i = 0; i < place.steps.size(); ++i) {
    const Step& step = place.steps[i];
    code_.at(step.span);
    if (step.is_field) {
      code_.push(OpCode::ADDRF, to.bits, to.bits, step.field);
    } else if (step.map != nullptr) {
      const bool is_last = i + 1 == place.steps.size();
      step_to_entry(step, to, indices[i].index, is_last && missing == Missing::kIsMade);
    } else if (step.column != nullptr) {
      code_.emit(OpCode::ADDRM, to, to, indices[i].index);
      code_.emit(OpCode::WITH, indices[i].column);
    } else {
      code_.emit(OpCode::ADDRE, to, to, indices[i].index);
      const bool goes_on = i + 1 < place.steps.size();
      if (goes_on && may_be_unset(*step.type)) code_.emit(OpCode::PLACESET, to, indices[i].index);
    }
  }
  return to;
}

// The number at the place as it is now.
void Lowering::load_place(const Place& place, const Indices& indices, Reg to) {
  if (leads_through_unset(place)) (void)address(place, indices);  // fails if an element is not set
  Reg object = borrow_variable(*place.variable, Hold::kNow);
  const std::size_t steps = place.steps.size();
  for (std::size_t i = 0; i < steps; ++i) {
    const Step& step = place.steps[i];
    code_.at(step.span);
    if (step.is_field) {
      code_.push(OpCode::FLD, to.bits, object.bits, step.field);
    } else if (step.map != nullptr) {
      code_.emit(OpCode::MAPLD, to, object, indices[i].index);
      code_.word(code_.type(step.map));
    } else if (step.column != nullptr) {
      code_.emit(OpCode::LDM, to, object, indices[i].index);
      code_.emit(OpCode::WITH, indices[i].column);
    } else if (options_.optimise && i + 2 == steps && place.steps[i + 1].is_field) {
      code_.emit(OpCode::LDF, to, object, indices[i].index);
      code_.word(place.steps[i + 1].field);
      return;
    } else {
      code_.emit(OpCode::LD, to, object, indices[i].index);
    }
    object = to;
  }
}

// ---- lists that grow and shrink
// -----------------------------------------------------------------------------------

// Returns the register of the removed element; a reference there is owned and has to be taken at
// once.
Reg Lowering::mutate(const MutateExpr& e) {
  if (e.mutation == Mutation::kRemoveKey) return remove_key(e);
  const bool reference = e.value != nullptr && e.value->type->is_reference();
  const Reg result = code_.number();
  code_.at(e.span, &e);
  check_set(*e.place.variable);
  const Indices indices = index_values(e.place);
  const Reg index = e.index == nullptr ? code_.number() : value(*e.index);
  Reg added;
  if (e.value != nullptr) {
    added = reference ? borrow(*e.value, hold_for(e.place, *e.value)) : value(*e.value);
  }
  if (e.mutation == Mutation::kPop) code_.constant(index, Slot{.i = kAbsentBits});
  const Reg list = address(e.place, indices);
  code_.at(e.span, &e);
  switch (e.mutation) {
    case Mutation::kPush:
      code_.emit(reference ? OpCode::PUSHREF : OpCode::PUSH, list, added);
      break;
    case Mutation::kInsert:
      code_.emit(reference ? OpCode::INSERTREF : OpCode::INSERT, list, index, added);
      break;
    case Mutation::kPop:
    case Mutation::kRemoveAt:
    case Mutation::kRemoveKey:
      code_.emit(OpCode::POP, result, list, index);
      break;
  }
  return result;
}

}  // namespace armlet::lang
