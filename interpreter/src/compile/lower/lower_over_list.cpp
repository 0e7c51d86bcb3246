// map, filter, fold and their relatives: loops that no statement of the text stands for. Each pass
// is one step, and the call in it another, as in a loop that is written out.

#include "compile/code/list_natives.hpp"
#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

const Type* element_of(const OverListExpr& e) { return e.operands[0]->type->element; }

const NativeFunction& sorter(const Type* key) {
  if (key->is(Kind::kText)) return kSortByText;
  return key->is(Kind::kInt) ? kSortByInt : kSortByReal;
}

}  // namespace

// The result is built beside `to`, which may be a variable that the operands use.
void Lowering::over_list(const OverListExpr& e, Reg to) {
  Reg result;
  switch (e.verb) {
    case ListVerb::kMap:
      result = map_list(e, held(e, 0), e.type->element);
      break;
    case ListVerb::kFilter:
      result = filter_list(e);
      break;
    case ListVerb::kFold:
      result = fold_list(e);
      break;
    case ListVerb::kAny:
    case ListVerb::kAll:
      result = test_list(e);
      break;
    case ListVerb::kSort:
      result = sort_list(e);
      break;
    case ListVerb::kZip:
      result = zip_lists(e);
      break;
    case ListVerb::kContains:
    case ListVerb::kIndexOf:
      result = find_in_list(e);
      break;
  }
  code_.emit(e.type->is_reference() ? OpCode::TAKE : OpCode::MOVE, to, result);
  if (result.is_reference()) code_.set_owned(result, false);
}

// An operand that stays as it is while the loop runs. A function that is known needs no register.
Reg Lowering::held(const OverListExpr& e, std::size_t operand) {
  const Expr& value_of = *e.operands[operand];
  if (value_of.kind == ExprKind::kFunctionValue) return {};
  if (!value_of.type->is_reference()) {
    const Reg number = code_.number();
    value_into(value_of, {number, true});
    return number;
  }
  Hold hold = Hold::kCall;
  for (std::size_t i = operand + 1; i < e.operands.size(); ++i)
    hold = stronger(hold, hold_over(*e.operands[i]));
  return borrow(value_of, hold);
}

Reg Lowering::length_of(const OverListExpr& e, Reg list) {
  const Reg length = code_.number();
  code_.at(e.span, &e);
  code_.emit(OpCode::LEN, length, list);
  return length;
}

// Passes with the counter from 0 up to but excluding `last`.
void Lowering::each(const OverListExpr& e, Reg last, const Element& pass) {
  const Reg counter = code_.number();
  const Label body = code_.label();
  const Label leave = code_.label();
  code_.at(e.span, &e);
  code_.constant(counter, slot_of(std::int64_t{0}));
  const bool alive = code_.reachable();
  code_.emit(OpCode::IFGEI, counter, last);
  code_.jump(leave);
  code_.bind_loop(body, alive);
  ++loop_depth_;
  const Emitter::Mark mark = code_.mark();
  pass(counter);
  code_.release(mark);
  --loop_depth_;
  code_.at(e.span, &e);
  code_.emit(OpCode::FORI, counter, last);
  code_.jump(body);
  code_.bind(leave);
}

// The arguments are in the window at `base`, where the result comes.
void Lowering::call_each(const OverListExpr& e, Reg function, Reg base) {
  const bool folds = e.verb == ListVerb::kFold;
  const Expr& called = *e.operands[folds ? 2 : 1];
  code_.at(e.span, &e);
  if (called.kind != ExprKind::kFunctionValue) {
    code_.emit(OpCode::CALLV, base, function);
    return;
  }
  const Function& known = *called.as<FunctionValueExpr>().function;
  if (known.expands) {
    std::vector<Reg> arguments = {base};
    if (folds) arguments.push_back(base.plus(1));
    expand_body({e.span, &e}, known, arguments, {base, false});
  } else {
    code_.push(OpCode::CALL, base.bits, known.index, 0);
  }
}

// An empty list.
Reg Lowering::new_list(const OverListExpr& e, const Type* element) {
  const Reg list = code_.reference();
  const Reg size = code_.number();
  code_.at(e.span, &e);
  code_.constant(size, slot_of(std::int64_t{0}));
  code_.push(OpCode::NEWLIST, list.bits, size.bits, element->is_reference() ? 1 : 0);
  return list;
}

void Lowering::add_to(const OverListExpr& e, Reg list, Reg item, const Type* element) {
  const Reg place = code_.number();
  code_.at(e.span, &e);
  code_.emit(OpCode::ADDRL, place, list);
  code_.emit(element->is_reference() ? OpCode::PUSHREF : OpCode::PUSH, place, item);
}

// What the function gives for every element; also the keys of sort.
Reg Lowering::map_list(const OverListExpr& e, Reg list, const Type* element) {
  const Reg function = held(e, 1);
  const Reg last = length_of(e, list);
  const bool references = element->is_reference();
  Reg out;
  Reg item;
  if (references) {
    out = new_list(e, element);
    item = code_.reference();
  } else {
    out = code_.reference();
    code_.push(OpCode::NEWLIST, out.bits, last.bits, 0);
  }
  each(e, last, [&](Reg counter) {
    const Reg base = code_.number();
    load_item(base, list, counter, *element_of(e), *e.operands[0]);
    call_each(e, function, base);
    if (references) {
      code_.emit(OpCode::TAKE, item, base);
      add_to(e, out, item, element);
    } else {
      code_.emit(OpCode::ST, out, counter, base);
    }
  });
  return out;
}

Reg Lowering::filter_list(const OverListExpr& e) {
  const Type* element = element_of(e);
  const Reg list = held(e, 0);
  const Reg function = held(e, 1);
  const Reg last = length_of(e, list);
  const Reg out = new_list(e, element);
  each(e, last, [&](Reg counter) {
    const Reg item = code_.number();
    const Reg base = code_.number();
    const Label skip = code_.label();
    load_item(item, list, counter, *element_of(e), *e.operands[0]);
    code_.emit(OpCode::MOVE, base, item);
    call_each(e, function, base);
    code_.jump_if(OpCode::JF, base, skip);
    add_to(e, out, item, element);
    code_.bind(skip);
  });
  return out;
}

Reg Lowering::fold_list(const OverListExpr& e) {
  const bool reference = e.type->is_reference();
  const Reg list = held(e, 0);
  const Reg so_far = reference ? code_.reference() : code_.number();
  if (reference) {
    own_into(*e.operands[1], so_far);
  } else {
    value_into(*e.operands[1], {so_far, true});
  }
  const Reg function = held(e, 2);
  each(e, length_of(e, list), [&](Reg counter) {
    const Reg base = code_.number();
    const Reg item = code_.number();
    code_.emit(OpCode::MOVE, base, so_far);
    load_item(item, list, counter, *element_of(e), *e.operands[0]);
    call_each(e, function, base);
    code_.emit(reference ? OpCode::TAKE : OpCode::MOVE, so_far, base);
  });
  return so_far;
}

// any and all: the first element that decides ends the loop.
Reg Lowering::test_list(const OverListExpr& e) {
  const bool any = e.verb == ListVerb::kAny;
  const Reg list = held(e, 0);
  const Reg function = held(e, 1);
  const Reg result = code_.number();
  const Label decided = code_.label();
  const Label end = code_.label();
  each(e, length_of(e, list), [&](Reg counter) {
    const Reg base = code_.number();
    load_item(base, list, counter, *element_of(e), *e.operands[0]);
    call_each(e, function, base);
    code_.jump_if(any ? OpCode::JT : OpCode::JF, base, decided);
  });
  code_.constant(result, slot_of(!any));
  code_.jump(end);
  code_.bind(decided);
  code_.constant(result, slot_of(any));
  code_.bind(end);
  return result;
}

// The keys of all elements first, then the sorting, which calls nothing.
Reg Lowering::sort_list(const OverListExpr& e) {
  const Type* key = e.operands[1]->type->result;
  const Reg list = held(e, 0);
  const Reg keys = map_list(e, list, key);
  const Reg base = code_.number();
  const Reg second = code_.number();
  code_.emit(OpCode::MOVE, base, list);
  code_.emit(OpCode::MOVE, second, keys);
  code_.at(e.span, &e);
  code_.push(OpCode::CALLN, base.bits, tables_.native(&sorter(key)), 0);
  return base;
}

Reg Lowering::zip_lists(const OverListExpr& e) {
  const Type* pair = e.type->element;
  const Reg left = held(e, 0);
  const Reg right = held(e, 1);
  const Reg last = code_.number();
  const Reg second = code_.number();
  code_.emit(OpCode::MOVE, last, left);
  code_.emit(OpCode::MOVE, second, right);
  code_.at(e.span, &e);
  code_.push(OpCode::CALLN, last.bits, tables_.native(&kCommonLength), 0);
  const Reg out = new_list(e, pair);
  const Reg item = code_.reference();
  each(e, last, [&](Reg counter) {
    const Reg first = code_.number();
    load_item(first, left, counter, *element_of(e), *e.operands[0]);
    const Expr& others = *e.operands[1];
    load_item(code_.number(), right, counter, *others.type->element, others);
    code_.at(e.span, &e);
    code_.push(OpCode::MAKEREC, item.bits, first.bits, tables_.layout(pair));
    add_to(e, out, item, pair);
  });
  return out;
}

Reg Lowering::find_in_list(const OverListExpr& e) {
  const bool tells_where = e.verb == ListVerb::kIndexOf;
  const Reg list = held(e, 0);
  const Reg wanted = held(e, 1);
  check_whole(*e.operands[0], list);
  check_whole(*e.operands[1], wanted);
  const Reg result = code_.number();
  const Label found = code_.label();
  const Label end = code_.label();
  each(e, length_of(e, list), [&](Reg counter) {
    const Reg item = code_.number();
    code_.emit(OpCode::LD, item, list, counter);
    if (tells_where) code_.emit(OpCode::MOVE, result, counter);
    branch_equal(e, item, wanted, found);
  });
  code_.constant(result, slot_of(std::int64_t{tells_where ? -1 : 0}));
  code_.jump(end);
  code_.bind(found);
  if (!tells_where) code_.constant(result, slot_of(true));
  code_.bind(end);
  return result;
}

void Lowering::branch_equal(const OverListExpr& e, Reg a, Reg b, Label to) {
  const Type* type = element_of(e);
  code_.at(e.span, &e);
  if (type->is(Kind::kReal)) {
    code_.emit(OpCode::IFEQR, a, b);
    code_.jump(to);
  } else if (!type->is_reference()) {
    code_.emit(OpCode::IFEQI, a, b);
    code_.jump(to);
  } else {
    const Reg same = code_.number();
    code_.emit(OpCode::EQDEEP, same, a, b);
    code_.word(code_.type(type));
    code_.jump_if(OpCode::JT, same, to);
  }
}

}  // namespace armlet::lang
