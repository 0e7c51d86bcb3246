// Compiles assignments to variables, elements and fields.

#include "lower/places.hpp"
#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void add_to(Lowering& in, const AssignStmt& s, const Addend& added, Reg to);
static void assign_whole(Lowering& in, const AssignStmt& s);
static void assign_compound(Lowering& in, const AssignStmt& s);
static void assign_inside(Lowering& in, const AssignStmt& s);
static bool can_write_early(const Lowering& in, const Variable& variable, const Expr& value);
static bool append_text(Lowering& in, const Variable& variable, const Expr& value);
static Addend addend(Lowering& in, const AssignStmt& s);
static void operate(Lowering& in, const AssignStmt& s, Reg left, Reg to);
static bool add_product_inside(Lowering& in, const AssignStmt& s, const Indices& indices);
static bool operate_inside(Lowering& in, const AssignStmt& s, const Indices& indices);
static bool is_chain_of_objects(const Lowering& in, const Place& place);
static Reg owned_inside(Lowering& in, const Place& place, const Indices& indices, Reg object);
static bool can_own(const Lowering& in, const Variable& variable);
static Reg own_register(Lowering& in, const Variable& variable);
static void store_inside(Lowering& in, const Place& place, const Indices& indices, Reg from);
static void load_place(Lowering& in, const Place& place, const Indices& indices, Reg to);

// ---- whole variables

// Using a global variable before its declaration has run is an error at run time.
void check_set(Lowering& in, const Variable& variable) {
  if (variable.storage == Storage::kGlobal && variable.maybe_unset) {
    in.code.push(OpCode::GCHECK, variable.index, 0, 0);
  }
}

void assign(Lowering& in, const AssignStmt& s) {
  if (!s.place.steps.empty()) {
    assign_inside(in, s);
  } else if (s.compound) {
    assign_compound(in, s);
  } else {
    assign_whole(in, s);
  }
}

// The first assignment to a variable declared without a value makes it set.
static void assign_whole(Lowering& in, const AssignStmt& s) {
  const Variable& variable = *s.place.variable;
  in.code.at(s.span);
  if (variable.init != nullptr) check_set(in, variable);
  in.uses.set_whole(s.value);
  store(in, variable, *s.value);
  if (variable.init == nullptr) note_set(in, variable);
}

void store(Lowering& in, const Variable& variable, const Expr& stored) {
  const bool reference = variable.type->is_reference();
  const Emitter::Mark mark = in.code.mark();
  if (variable.storage == Storage::kLocal) {
    if (!reference) {
      value_into(in, stored, {in.homes.of(variable), can_write_early(in, variable, stored)});
    } else if (!append_text(in, variable, stored)) {
      own_into(in, stored, in.homes.of(variable));
    }
  } else {
    const Reg from = reference ? borrow(in, stored, Hold::kNow) : value(in, stored);
    store_register(in, variable, from);
  }
  in.code.release(mark);
}

void store_register(Lowering& in, const Variable& variable, Reg from) {
  const bool reference = variable.type->is_reference();
  switch (variable.storage) {
    case Storage::kLocal:
      in.code.emit(reference ? OpCode::MOVEREF : OpCode::MOVE, in.homes.of(variable), from);
      break;
    case Storage::kBoxed:
      in.code.emit(reference ? OpCode::BSTOREREF : OpCode::BSTORE, in.homes.of(variable), from);
      break;
    case Storage::kGlobal:
      in.code.push(reference ? OpCode::GSTOREREF : OpCode::GSTORE, variable.index, from.bits, 0);
      break;
  }
}

// x = ... may compute in the register of x if x is read first, or not at all, and no part of the
// expression can fail.
static bool can_write_early(const Lowering& in, const Variable& variable, const Expr& value) {
  if (!in.options.optimise || !is_plain(value)) return false;
  const Expr* e = &value;
  for (; e->kind == ExprKind::kBinary; e = e->as<BinaryExpr>().left) {
    if (mentions(*e->as<BinaryExpr>().right, variable)) return false;
  }
  return e->kind == ExprKind::kVariable || !mentions(*e, variable);
}

// s = s + t appends to the text s without a copy.
static bool append_text(Lowering& in, const Variable& variable, const Expr& value) {
  if (!in.options.optimise || value.kind != ExprKind::kConcat || value.constant != nullptr)
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
      hold = stronger(hold, hold_over(in, *parts[later]));
    }
    added.push_back(borrow(in, *parts[i], hold));
  }
  in.code.at(value.span, &value);
  for (const Reg part : added) in.code.emit(OpCode::APPEND, in.homes.of(variable), part);
  return true;
}

// x += value for numbers.
static void assign_compound(Lowering& in, const AssignStmt& s) {
  const Variable& variable = *s.place.variable;
  const Emitter::Mark mark = in.code.mark();
  in.code.at(s.span);
  if (variable.storage == Storage::kLocal) {
    operate(in, s, in.homes.of(variable), in.homes.of(variable));
  } else {
    check_set(in, variable);
    const Reg old = in.code.number();
    const Addend added = addend(in, s);
    load_variable(in, variable, old);
    add_to(in, s, added, old);
    store_register(in, variable, old);
  }
  in.code.release(mark);
}

// The right side of a compound assignment is evaluated before the target is read, because it may
// change the target. A right side without side effects that cannot fail may be evaluated later.
static Addend addend(Lowering& in, const AssignStmt& s) {
  Addend out;
  if (is_plain(*s.value)) return out;
  out.is_evaluated = true;
  const bool is_sum = s.op == Op::kAddR || s.op == Op::kSubR;
  out.is_product = in.options.optimise && is_sum && is_product(*s.value);
  if (!out.is_product) {
    out.first = value(in, *s.value);
    return out;
  }
  out.first = value(in, *s.value->as<BinaryExpr>().left);
  out.second = value(in, *s.value->as<BinaryExpr>().right);
  return out;
}

// The product is rounded, then the sum: the same bits as with two instructions.
static void add_to(Lowering& in, const AssignStmt& s, const Addend& added, Reg to) {
  if (!added.is_evaluated) return operate(in, s, to, to);
  in.code.at(s.span);
  if (added.is_product) {
    in.code.emit(s.op == Op::kAddR ? OpCode::MADD : OpCode::MSUB, to, added.first, added.second);
  } else {
    in.code.emit(arithmetic_instruction(s.op), to, to, added.first);
  }
}

// to = left op s.value
static void operate(Lowering& in, const AssignStmt& s, Reg left, Reg to) {
  arithmetic(in, {s.span, nullptr}, s.op, left, *s.value, to);
}

// ---- inside lists and records

static bool is_literal_text(const Expr& e) { return e.kind == ExprKind::kText; }

// The indices are evaluated first, then the value. The steps to the assignment target come last,
// without other code between them.
static void assign_inside(Lowering& in, const AssignStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  in.code.at(s.span);
  check_set(in, *s.place.variable);
  const Indices indices = index_values(in, s.place);
  if (s.place.type->is_reference()) {
    // A function may change its argument in place if nothing else holds it. Lists that share their
    // elements are separated first, so that each of them holds the element.
    if (s.changes_part) (void)address(in, s.place, indices);
    const Reg from = borrow(in, *s.value, hold_for(s.place, *s.value));
    const Reg to = address(in, s.place, indices, Missing::kIsMade);
    in.code.emit(OpCode::PUTREF, to, from);
  } else if (!s.compound) {
    store_inside(in, s.place, indices, value(in, *s.value));
  } else if (!add_product_inside(in, s, indices) && !operate_inside(in, s, indices)) {
    const Reg now = in.code.number();
    const Addend added = addend(in, s);
    load_place(in, s.place, indices, now);
    add_to(in, s, added, now);
    store_inside(in, s.place, indices, now);
  }
  in.code.release(mark);
}

// xs[i].field += a * b as one instruction.
static bool add_product_inside(Lowering& in, const AssignStmt& s, const Indices& indices) {
  const auto& steps = s.place.steps;
  if (s.op != Op::kAddR || steps.size() != 2 || steps[0].is_field || !steps[1].is_field ||
      has_key(s.place) || leads_through_unset(in, s.place))
    return false;
  if (!can_own(in, *s.place.variable) || !is_product(*s.value) || !is_plain(*s.value)) return false;
  const auto& product = s.value->as<BinaryExpr>();
  const Reg a = value(in, *product.left);
  const Reg b = value(in, *product.right);
  const Reg list = own_register(in, *s.place.variable);
  in.code.at(steps[0].span);
  in.code.emit(OpCode::MADDLF, list, indices[0].index);
  in.code.push(OpCode::FACTORS, a.bits, b.bits, steps[1].field);
  return true;
}

// rows[i][j] += value looks the row up once. Likewise xs[i] += value with a global variable xs.
static bool operate_inside(Lowering& in, const AssignStmt& s, const Indices& indices) {
  const Step& last = s.place.steps.back();
  if (last.is_field || last.column != nullptr) return false;
  if (!can_own(in, *s.place.variable) || !is_chain_of_objects(in, s.place)) return false;
  const Addend added = addend(in, s);
  const Reg object = own_register(in, *s.place.variable);
  const Reg inner = s.place.steps.size() < 2 ? object : owned_inside(in, s.place, indices, object);
  const Reg now = in.code.number();
  in.code.at(last.span);
  in.code.emit(OpCode::LD, now, inner, indices.back().index);
  add_to(in, s, added, now);
  in.code.at(last.span);
  in.code.emit(OpCode::ST, inner, indices.back().index, now);
  return true;
}

// Whether all steps but the last lead to lists or records, and the last one is an element or field
// of one.
static bool is_chain_of_objects(const Lowering& in, const Place& place) {
  if (has_key(place) || leads_through_unset(in, place)) return false;
  for (std::size_t i = 0; i + 1 < place.steps.size(); ++i) {
    if (place.steps[i].column != nullptr) return false;
  }
  return true;
}

// The list or record that the last step is an element or field of. It is copied first if it is
// shared.
static Reg owned_inside(Lowering& in, const Place& place, const Indices& indices, Reg object) {
  const Reg inner = in.code.number();
  for (std::size_t i = 0; i + 1 < place.steps.size(); ++i) {
    const Step& step = place.steps[i];
    in.code.at(step.span);
    if (step.is_field) {
      in.code.push(OpCode::OWNEDF, inner.bits, object.bits, step.field);
    } else {
      in.code.emit(OpCode::OWNED, inner, object, indices[i].index);
    }
    object = inner;
  }
  return inner;
}

Indices index_values(Lowering& in, const Place& place) {
  Indices indices;
  for (const Step& step : place.steps) {
    StepIndex at;
    if (step.map != nullptr) {
      at.index = key(in, *step.index, is_literal_text(*step.index) ? Hold::kNow : Hold::kOwn);
    } else if (!step.is_field) {
      at.index = value(in, *step.index);
    }
    if (step.column != nullptr) at.column = value(in, *step.column);
    indices.push_back(at);
  }
  return indices;
}

// A value that is part of the variable it is stored into is counted first, so that no object can
// contain itself.
Hold hold_for(const Place& place, const Expr& value) {
  return root_variable(value) == place.variable ? Hold::kOwn : Hold::kNow;
}

// Whether stores may change the list or record of the variable through a register.
static bool can_own(const Lowering& in, const Variable& variable) {
  if (!in.options.optimise) return false;
  return variable.storage == Storage::kGlobal ||
         (variable.storage == Storage::kLocal && in.homes.of(variable).is_reference());
}

// The register of that list or record. That of a global variable is valid until other code runs.
static Reg own_register(Lowering& in, const Variable& variable) {
  Reg reg;
  if (variable.storage == Storage::kLocal) return in.homes.of(variable);
  if (in.loops.is_pinned(variable, reg)) return reg;
  reg = in.code.number();
  in.code.push(OpCode::GOWN, reg.bits, variable.index, 0);
  return reg;
}

static void store_inside(Lowering& in, const Place& place, const Indices& indices, Reg from) {
  if (!can_own(in, *place.variable) || !is_chain_of_objects(in, place)) {
    const Reg to = address(in, place, indices, Missing::kIsMade);
    in.code.emit(OpCode::PUT, to, from);
    return;
  }
  Reg object = own_register(in, *place.variable);
  const std::size_t steps = place.steps.size();
  const Step& first = place.steps[0];
  const Step& last = place.steps.back();
  if (steps == 2 && !first.is_field && last.column == nullptr) {
    in.code.at(first.span);
    in.code.emit(last.is_field ? OpCode::STLF : OpCode::STLD, object, indices[0].index, from);
    in.code.at(last.span);
    if (last.is_field) {
      in.code.word(last.field);
    } else {
      in.code.emit(OpCode::WITH, indices[1].index);
    }
    return;
  }
  if (steps > 1) object = owned_inside(in, place, indices, object);
  in.code.at(last.span);
  if (last.is_field) {
    in.code.push(OpCode::STF, object.bits, last.field, from.bits);
  } else if (last.column != nullptr) {
    in.code.emit(OpCode::STM, object, indices.back().index, from);
    in.code.emit(OpCode::WITH, indices.back().column);
  } else {
    in.code.emit(OpCode::ST, object, indices.back().index, from);
  }
}

// The address of the assignment target, valid until other code runs.
Reg address(Lowering& in, const Place& place, const Indices& indices, Missing missing) {
  const Variable& variable = *place.variable;
  const Reg to = in.code.number();
  switch (variable.storage) {
    case Storage::kLocal:
      in.code.emit(OpCode::ADDRL, to, in.homes.of(variable));
      break;
    case Storage::kBoxed:
      in.code.emit(OpCode::ADDRB, to, in.homes.of(variable));
      break;
    case Storage::kGlobal:
      in.code.push(OpCode::ADDRG, to.bits, variable.index, 0);
      break;
  }
  for (std::size_t i = 0; i < place.steps.size(); ++i) {
    const Step& step = place.steps[i];
    in.code.at(step.span);
    if (step.is_field) {
      in.code.push(OpCode::ADDRF, to.bits, to.bits, step.field);
    } else if (step.map != nullptr) {
      const bool is_last = i + 1 == place.steps.size();
      step_to_entry(in, step, to, indices[i].index, is_last && missing == Missing::kIsMade);
    } else if (step.column != nullptr) {
      in.code.emit(OpCode::ADDRM, to, to, indices[i].index);
      in.code.emit(OpCode::WITH, indices[i].column);
    } else {
      in.code.emit(OpCode::ADDRE, to, to, indices[i].index);
      const bool goes_on = i + 1 < place.steps.size();
      if (goes_on && may_be_unset(in, *step.type))
        in.code.emit(OpCode::PLACESET, to, indices[i].index);
    }
  }
  return to;
}

// Loads the current number at the assignment target.
static void load_place(Lowering& in, const Place& place, const Indices& indices, Reg to) {
  if (leads_through_unset(in, place))
    (void)address(in, place, indices);  // fails if an element has no value
  Reg object = borrow_variable(in, *place.variable, Hold::kNow);
  const std::size_t steps = place.steps.size();
  for (std::size_t i = 0; i < steps; ++i) {
    const Step& step = place.steps[i];
    in.code.at(step.span);
    if (step.is_field) {
      in.code.push(OpCode::FLD, to.bits, object.bits, step.field);
    } else if (step.map != nullptr) {
      in.code.emit(OpCode::MAPLD, to, object, indices[i].index);
      in.code.word(in.code.type(step.map));
    } else if (step.column != nullptr) {
      in.code.emit(OpCode::LDM, to, object, indices[i].index);
      in.code.emit(OpCode::WITH, indices[i].column);
    } else if (in.options.optimise && i + 2 == steps && place.steps[i + 1].is_field) {
      in.code.emit(OpCode::LDF, to, object, indices[i].index);
      in.code.word(place.steps[i + 1].field);
      return;
    } else {
      in.code.emit(OpCode::LD, to, object, indices[i].index);
    }
    object = to;
  }
}

// ---- lists that grow and shrink

// Returns the register of the removed element. A reference there is owned and has to be moved to
// its destination before the next call.
Reg mutate(Lowering& in, const MutateExpr& e) {
  if (e.mutation == Mutation::kRemoveKey) return remove_key(in, e);
  const bool reference = e.value != nullptr && e.value->type->is_reference();
  const Reg result = in.code.number();
  in.code.at(e.span, &e);
  check_set(in, *e.place.variable);
  const Indices indices = index_values(in, e.place);
  const Reg index = e.index == nullptr ? in.code.number() : value(in, *e.index);
  Reg added;
  if (e.value != nullptr) {
    added = reference ? borrow(in, *e.value, hold_for(e.place, *e.value)) : value(in, *e.value);
  }
  if (e.mutation == Mutation::kPop) in.code.constant(index, Slot{.i = kAbsentBits});
  const Reg list = address(in, e.place, indices);
  in.code.at(e.span, &e);
  switch (e.mutation) {
    case Mutation::kPush:
      in.code.emit(reference ? OpCode::PUSHREF : OpCode::PUSH, list, added);
      break;
    case Mutation::kInsert:
      in.code.emit(reference ? OpCode::INSERTREF : OpCode::INSERT, list, index, added);
      break;
    case Mutation::kPop:
    case Mutation::kRemoveAt:
    case Mutation::kRemoveKey:
      in.code.emit(OpCode::POP, result, list, index);
      break;
  }
  return result;
}

}  // namespace armlet::lang
