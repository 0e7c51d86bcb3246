// Compiles map, filter, fold and similar functions to loops. Each iteration counts one step and its
// call another, as in a loop of the text.

#include "lower/places.hpp"
#include "lower/values.hpp"
#include "vocabulary/language_functions.hpp"

namespace armlet::lang {

using namespace hir;

// Emits the code for one element.
using Element = std::function<void(Reg counter)>;

static void add_item(Lowering& in, const OverListExpr& e, Reg list, Reg item, const Type* element);
static Reg held(Lowering& in, const OverListExpr& e, std::size_t operand);
static void each(Lowering& in, const OverListExpr& e, Reg last, const Element& pass);
static void call_each(Lowering& in, const OverListExpr& e, Reg function, Reg base);
static Reg length_of(Lowering& in, const OverListExpr& e, Reg list);
static Reg new_list(Lowering& in, const OverListExpr& e, const Type* element);
static Reg map_list(Lowering& in, const OverListExpr& e, Reg list, const Type* element);
static Reg filter_list(Lowering& in, const OverListExpr& e);
static Reg fold_list(Lowering& in, const OverListExpr& e);
static Reg test_list(Lowering& in, const OverListExpr& e);
static Reg sort_list(Lowering& in, const OverListExpr& e);
static Reg zip_lists(Lowering& in, const OverListExpr& e);
static Reg find_in_list(Lowering& in, const OverListExpr& e);
static void branch_equal(Lowering& in, const OverListExpr& e, Reg a, Reg b, Label to);

namespace {

const Type* element_of(const OverListExpr& e) { return e.operands[0]->type->element; }

const LanguageFunctions& language_of(Lowering& in) { return *in.tables.program().language; }

const NativeFunction& sorter(const LanguageFunctions& language, const Type* key) {
  if (key->is(Kind::kText)) return *language.sort_by_text;
  return key->is(Kind::kInt) ? *language.sort_by_int : *language.sort_by_real;
}

}  // namespace

// The result is built in another register than `to`, because the operands may use the variable of
// `to`.
void over_list(Lowering& in, const OverListExpr& e, Reg to) {
  Reg result;
  switch (e.verb) {
    case ListVerb::kMap:
      result = map_list(in, e, held(in, e, 0), e.type->element);
      break;
    case ListVerb::kFilter:
      result = filter_list(in, e);
      break;
    case ListVerb::kFold:
      result = fold_list(in, e);
      break;
    case ListVerb::kAny:
    case ListVerb::kAll:
      result = test_list(in, e);
      break;
    case ListVerb::kSort:
      result = sort_list(in, e);
      break;
    case ListVerb::kZip:
      result = zip_lists(in, e);
      break;
    case ListVerb::kContains:
    case ListVerb::kIndexOf:
      result = find_in_list(in, e);
      break;
  }
  in.code.emit(e.type->is_reference() ? OpCode::TAKE : OpCode::MOVE, to, result);
  if (result.is_reference()) in.code.set_owned(result, false);
}

// An operand that does not change while the loop runs. A function that is known at compile time
// needs no register.
static Reg held(Lowering& in, const OverListExpr& e, std::size_t operand) {
  const Expr& value_of = *e.operands[operand];
  if (value_of.kind == ExprKind::kFunctionValue) return {};
  if (!value_of.type->is_reference()) {
    const Reg number = in.code.number();
    value_into(in, value_of, {number, true});
    return number;
  }
  Hold hold = Hold::kCall;
  for (std::size_t i = operand + 1; i < e.operands.size(); ++i)
    hold = stronger(hold, hold_over(in, *e.operands[i]));
  return borrow(in, value_of, hold);
}

static Reg length_of(Lowering& in, const OverListExpr& e, Reg list) {
  const Reg length = in.code.number();
  in.code.at(e.span, &e);
  in.code.emit(OpCode::LEN, length, list);
  return length;
}

// Iterates with the counter from 0 to `last` - 1.
static void each(Lowering& in, const OverListExpr& e, Reg last, const Element& pass) {
  const Reg counter = in.code.number();
  const Label body = in.code.label();
  const Label leave = in.code.label();
  in.code.at(e.span, &e);
  in.code.constant(counter, slot_of(std::int64_t{0}));
  const bool alive = in.code.reachable();
  in.code.emit(OpCode::IFGEI, counter, last);
  in.code.jump(leave);
  in.code.bind_loop(body, alive);
  in.loops.begin();
  const Emitter::Mark mark = in.code.mark();
  pass(counter);
  in.code.release(mark);
  in.loops.end();
  in.code.at(e.span, &e);
  in.code.emit(OpCode::FORI, counter, last);
  in.code.jump(body);
  in.code.bind(leave);
}

// Calls the function with the arguments in the window at `base`, which then has the result.
static void call_each(Lowering& in, const OverListExpr& e, Reg function, Reg base) {
  const bool folds = e.verb == ListVerb::kFold;
  const Expr& called = *e.operands[folds ? 2 : 1];
  in.code.at(e.span, &e);
  if (called.kind != ExprKind::kFunctionValue) {
    in.code.emit(OpCode::CALLV, base, function);
    return;
  }
  const Function& known = *called.as<FunctionValueExpr>().function;
  if (in.tables.inlines(known)) {
    std::vector<Reg> arguments = {base};
    if (folds) arguments.push_back(base.plus(1));
    expand_body(in, {e.span, &e}, known, arguments, {base, false});
  } else {
    in.code.push(OpCode::CALL, base.bits, known.index, 0);
  }
}

// Makes an empty list.
static Reg new_list(Lowering& in, const OverListExpr& e, const Type* element) {
  const Reg list = in.code.reference();
  const Reg size = in.code.number();
  in.code.at(e.span, &e);
  in.code.constant(size, slot_of(std::int64_t{0}));
  in.code.push(OpCode::NEWLIST, list.bits, size.bits, element->is_reference() ? 1 : 0);
  return list;
}

static void add_item(Lowering& in, const OverListExpr& e, Reg list, Reg item, const Type* element) {
  const Reg place = in.code.number();
  in.code.at(e.span, &e);
  in.code.emit(OpCode::ADDRL, place, list);
  in.code.emit(element->is_reference() ? OpCode::PUSHREF : OpCode::PUSH, place, item);
}

// The list of the function's results for all elements; sort uses it for its keys.
static Reg map_list(Lowering& in, const OverListExpr& e, Reg list, const Type* element) {
  const Reg function = held(in, e, 1);
  const Reg last = length_of(in, e, list);
  const bool references = element->is_reference();
  Reg out;
  Reg item;
  if (references) {
    out = new_list(in, e, element);
    item = in.code.reference();
  } else {
    out = in.code.reference();
    in.code.push(OpCode::NEWLIST, out.bits, last.bits, 0);
  }
  each(in, e, last, [&](Reg counter) {
    const Reg base = in.code.number();
    load_item(in, base, list, counter, *element_of(e), *e.operands[0]);
    call_each(in, e, function, base);
    if (references) {
      in.code.emit(OpCode::TAKE, item, base);
      add_item(in, e, out, item, element);
    } else {
      in.code.emit(OpCode::ST, out, counter, base);
    }
  });
  return out;
}

static Reg filter_list(Lowering& in, const OverListExpr& e) {
  const Type* element = element_of(e);
  const Reg list = held(in, e, 0);
  const Reg function = held(in, e, 1);
  const Reg last = length_of(in, e, list);
  const Reg out = new_list(in, e, element);
  each(in, e, last, [&](Reg counter) {
    const Reg item = in.code.number();
    const Reg base = in.code.number();
    const Label skip = in.code.label();
    load_item(in, item, list, counter, *element_of(e), *e.operands[0]);
    in.code.emit(OpCode::MOVE, base, item);
    call_each(in, e, function, base);
    in.code.jump_if(OpCode::JF, base, skip);
    add_item(in, e, out, item, element);
    in.code.bind(skip);
  });
  return out;
}

static Reg fold_list(Lowering& in, const OverListExpr& e) {
  const bool reference = e.type->is_reference();
  const Reg list = held(in, e, 0);
  const Reg so_far = reference ? in.code.reference() : in.code.number();
  if (reference) {
    own_into(in, *e.operands[1], so_far);
  } else {
    value_into(in, *e.operands[1], {so_far, true});
  }
  const Reg function = held(in, e, 2);
  each(in, e, length_of(in, e, list), [&](Reg counter) {
    const Reg base = in.code.number();
    const Reg item = in.code.number();
    in.code.emit(OpCode::MOVE, base, so_far);
    load_item(in, item, list, counter, *element_of(e), *e.operands[0]);
    call_each(in, e, function, base);
    in.code.emit(reference ? OpCode::TAKE : OpCode::MOVE, so_far, base);
  });
  return so_far;
}

// any and all: the first element that decides ends the loop.
static Reg test_list(Lowering& in, const OverListExpr& e) {
  const bool any = e.verb == ListVerb::kAny;
  const Reg list = held(in, e, 0);
  const Reg function = held(in, e, 1);
  const Reg result = in.code.number();
  const Label decided = in.code.label();
  const Label end = in.code.label();
  each(in, e, length_of(in, e, list), [&](Reg counter) {
    const Reg base = in.code.number();
    load_item(in, base, list, counter, *element_of(e), *e.operands[0]);
    call_each(in, e, function, base);
    in.code.jump_if(any ? OpCode::JT : OpCode::JF, base, decided);
  });
  in.code.constant(result, slot_of(!any));
  in.code.jump(end);
  in.code.bind(decided);
  in.code.constant(result, slot_of(any));
  in.code.bind(end);
  return result;
}

// Computes the keys of all elements first, then sorts by them without any call.
static Reg sort_list(Lowering& in, const OverListExpr& e) {
  const Type* key = e.operands[1]->type->result;
  const Reg list = held(in, e, 0);
  const Reg descending = held(in, e, 2);
  const Reg keys = map_list(in, e, list, key);
  const Reg base = in.code.number();
  const Reg second = in.code.number();
  const Reg third = in.code.number();
  in.code.emit(OpCode::MOVE, base, list);
  in.code.emit(OpCode::MOVE, second, keys);
  in.code.emit(OpCode::MOVE, third, descending);
  in.code.at(e.span, &e);
  in.code.push(OpCode::CALLN, base.bits, in.tables.native(&sorter(language_of(in), key)), 0);
  return base;
}

static Reg zip_lists(Lowering& in, const OverListExpr& e) {
  const Type* pair = e.type->element;
  const Reg left = held(in, e, 0);
  const Reg right = held(in, e, 1);
  const Reg last = in.code.number();
  const Reg second = in.code.number();
  in.code.emit(OpCode::MOVE, last, left);
  in.code.emit(OpCode::MOVE, second, right);
  in.code.at(e.span, &e);
  in.code.push(OpCode::CALLN, last.bits, in.tables.native(language_of(in).common_length), 0);
  const Reg out = new_list(in, e, pair);
  const Reg item = in.code.reference();
  each(in, e, last, [&](Reg counter) {
    const Reg first = in.code.number();
    load_item(in, first, left, counter, *element_of(e), *e.operands[0]);
    const Expr& others = *e.operands[1];
    load_item(in, in.code.number(), right, counter, *others.type->element, others);
    in.code.at(e.span, &e);
    in.code.push(OpCode::MAKEREC, item.bits, first.bits, in.tables.layout(pair));
    add_item(in, e, out, item, pair);
  });
  return out;
}

static Reg find_in_list(Lowering& in, const OverListExpr& e) {
  const bool tells_where = e.verb == ListVerb::kIndexOf;
  const Reg list = held(in, e, 0);
  const Reg wanted = held(in, e, 1);
  check_whole(in, *e.operands[0], list);
  check_whole(in, *e.operands[1], wanted);
  const Reg result = in.code.number();
  const Label found = in.code.label();
  const Label end = in.code.label();
  each(in, e, length_of(in, e, list), [&](Reg counter) {
    const Reg item = in.code.number();
    in.code.emit(OpCode::LD, item, list, counter);
    if (tells_where) in.code.emit(OpCode::MOVE, result, counter);
    branch_equal(in, e, item, wanted, found);
  });
  in.code.constant(result, slot_of(std::int64_t{tells_where ? -1 : 0}));
  in.code.jump(end);
  in.code.bind(found);
  if (!tells_where) in.code.constant(result, slot_of(true));
  in.code.bind(end);
  return result;
}

static void branch_equal(Lowering& in, const OverListExpr& e, Reg a, Reg b, Label to) {
  const Type* type = element_of(e);
  in.code.at(e.span, &e);
  if (type->is(Kind::kReal)) {
    in.code.emit(OpCode::IFEQR, a, b);
    in.code.jump(to);
  } else if (!type->is_reference()) {
    in.code.emit(OpCode::IFEQI, a, b);
    in.code.jump(to);
  } else {
    const Reg same = in.code.number();
    in.code.emit(OpCode::EQDEEP, same, a, b);
    in.code.word(in.code.type(type));
    in.code.jump_if(OpCode::JT, same, to);
  }
}

}  // namespace armlet::lang
