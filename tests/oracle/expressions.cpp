// Expressions: operands from left to right, then what is done with them.

#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

using namespace lang::hir;

Evaluator::Values Evaluator::evaluate_all(Seq<Expr*> items) {
  Values out;
  for (const Expr* item : items) out.push_back(evaluate(*item));
  return out;
}

Value Evaluator::evaluate(const Expr& e) {
  switch (e.kind) {
    case ExprKind::kBool:
      return {e.as<BoolExpr>().value};
    case ExprKind::kInt:
    case ExprKind::kEnum:
      return {e.as<IntExpr>().value};
    case ExprKind::kReal:
      return {e.as<RealExpr>().value};
    case ExprKind::kText:
      return {std::string(e.as<TextExpr>().value)};
    case ExprKind::kAbsent:
      return {};
    case ExprKind::kVariable:
      return variable(*e.as<VariableExpr>().variable, e.span);
    case ExprKind::kUnary: {
      const auto& unary = e.as<UnaryExpr>();
      const Value operand = evaluate(*unary.operand);
      try {
        return negate(unary.op, operand);
      } catch (const TroubleError& error) {
        fail_calculation(error.trouble, e.span, &operand, nullptr);
      }
    }
    case ExprKind::kBinary:
      return binary(e.as<BinaryExpr>());
    case ExprKind::kAnd:
      return {evaluate(*e.as<BinaryExpr>().left).truth() &&
              evaluate(*e.as<BinaryExpr>().right).truth()};
    case ExprKind::kOr:
      return {evaluate(*e.as<BinaryExpr>().left).truth() ||
              evaluate(*e.as<BinaryExpr>().right).truth()};
    case ExprKind::kCond: {
      const auto& cond = e.as<CondExpr>();
      return evaluate(*cond.condition).truth() ? evaluate(*cond.yes) : evaluate(*cond.no);
    }
    case ExprKind::kConvert:
      return convert(e.as<ConvertExpr>());
    default:
      return evaluate_made(e);
  }
}

// Lists, records, texts and calls.
Value Evaluator::evaluate_made(const Expr& e) {
  switch (e.kind) {
    case ExprKind::kList:
      return {List{evaluate_all(e.as<ListExpr>().items)}};
    case ExprKind::kNewArray:
      return new_array(e.as<NewArrayExpr>());
    case ExprKind::kRecord:
      return {Record{evaluate_all(e.as<RecordExpr>().fields), nullptr}};
    case ExprKind::kField:
      return evaluate(*e.as<FieldExpr>().object).record().fields[e.as<FieldExpr>().field];
    case ExprKind::kElement:
      return element(e.as<ElementExpr>());
    case ExprKind::kSlice:
      return slice(e.as<SliceExpr>());
    case ExprKind::kLength:
      return length(e.as<LengthExpr>());
    case ExprKind::kCharacter:
      return character(e.as<CharacterExpr>());
    case ExprKind::kCall: {
      Values arguments = evaluate_all(e.as<CallExpr>().arguments);
      return call(*e.as<CallExpr>().function, std::move(arguments), {}, e.span);
    }
    case ExprKind::kCallValue: {
      const Value function = evaluate(*e.as<CallValueExpr>().function);
      Values arguments = evaluate_all(e.as<CallValueExpr>().arguments);
      return call(*function.closure().function, std::move(arguments), function.closure().captures,
                  e.span);
    }
    case ExprKind::kCallNative:
      return call_native(e.as<CallNativeExpr>());
    case ExprKind::kOverList:
      return over_list(e.as<OverListExpr>());
    case ExprKind::kMatrix:
      return matrix(e.as<MatrixExpr>());
    case ExprKind::kPart:
      return part(e.as<PartExpr>());
    case ExprKind::kFunctionValue:
      return {Closure{e.as<FunctionValueExpr>().function, {}}};
    case ExprKind::kClosure:
      return closure(e.as<ClosureExpr>());
    case ExprKind::kConcat: {
      std::string all;
      for (const Expr* part : e.as<ConcatExpr>().parts) all += evaluate(*part).text();
      return {all};
    }
    case ExprKind::kToText:
      return to_text(e.as<ToTextExpr>());
    case ExprKind::kError:
      return error(e.as<ErrorExpr>());
    case ExprKind::kMutate:
      return mutate(e.as<MutateExpr>());
    default:
      return of_map(e);
  }
}

Value Evaluator::to_text(const ToTextExpr& e) {
  const Value value = evaluate(*e.value);
  check_whole(value, *e.value->type, e.value->span);
  return {show(value, *e.value->type,
               {e.style.digits, e.style.notation, std::string(e.unit), e.factor, e.style.align,
                e.style.sign, e.style.zeros, e.style.width})};
}

Value Evaluator::length(const LengthExpr& e) {
  const Value object = evaluate(*e.object);
  if (std::holds_alternative<Map>(object.is))
    return {static_cast<std::int64_t>(object.map().keys.size())};
  const bool is_text = std::holds_alternative<std::string>(object.is);
  return {static_cast<std::int64_t>(is_text ? characters(object.text()).size()
                                            : object.list().items.size())};
}

Value Evaluator::character(const CharacterExpr& e) {
  const std::vector<std::string> all = characters(evaluate(*e.object).text());
  const std::int64_t index = evaluate(*e.index).integer();
  if (index < 0 || static_cast<std::size_t>(index) >= all.size())
    fail_index(index, all.size(), e.span, "text");
  return {all[index]};
}

Value Evaluator::variable(const Variable& v, Span where) {
  check_set(v, where);
  const auto found = home(v).find(&v);
  if (found == home(v).end() || found->second->absent())
    throw std::logic_error("read before it has a value: " + std::string(v.name));
  return *found->second;
}

Value Evaluator::binary(const BinaryExpr& e) {
  const Value left = evaluate(*e.left);
  const Value right = evaluate(*e.right);
  if (e.op == Op::kEqDeep || e.op == Op::kNeDeep) {
    check_whole(left, *e.left->type, e.left->span);
    check_whole(right, *e.right->type, e.right->span);
  }
  return calculate_at(e.op, left, right, e.span);
}

Value Evaluator::convert(const ConvertExpr& e) {
  const Value value = evaluate(*e.operand);
  switch (e.conversion) {
    case Conversion::kSame:
      return value;
    case Conversion::kIntToReal:
      return {static_cast<double>(value.integer())};
    case Conversion::kRealToInt:
      try {
        return {to_integer(value.real())};
      } catch (const TroubleError& error) {
        fail_calculation(error.trouble, e.span, &value, nullptr);
      }
    case Conversion::kListIntToReal:
      break;
    case Conversion::kMatrixToRows: {
      List rows;
      const Matrix& matrix = value.matrix();
      for (std::size_t i = 0; i < matrix.rows; ++i) {
        const auto begin = matrix.numbers.begin() + static_cast<std::ptrdiff_t>(i * matrix.cols);
        rows.items.push_back({List{{begin, begin + static_cast<std::ptrdiff_t>(matrix.cols)}}});
      }
      return {std::move(rows)};
    }
  }
  List out;
  for (const Value& item : value.list().items)
    out.items.push_back({static_cast<double>(item.integer())});
  return {std::move(out)};
}

Value Evaluator::element(const ElementExpr& e) {
  Value object = evaluate(*e.object);
  const std::int64_t index = evaluate(*e.index).integer();
  if (e.column != nullptr) return cell(object, {index, evaluate(*e.column).integer()}, e.span);
  const Values& items = object.list().items;
  if (index < 0 || static_cast<std::size_t>(index) >= items.size())
    fail_index(index, items.size(), e.span);
  if (items[index].absent()) {
    Span list = e.object->span;
    // A target of an assignment: its variable has the span of all of it.
    const bool is_variable = e.object->kind == ExprKind::kVariable;
    const std::string_view name =
        is_variable ? e.object->as<VariableExpr>().variable->name : std::string_view();
    if (!name.empty() && text(list).size() > name.size() && text(list).starts_with(name))
      list.end = list.begin + static_cast<std::uint32_t>(last_bracket(text(e.span)));
    fail_unset(index, list, e.span);
  }
  return items[index];
}

// The second end must lie in 0 to the size, the first in 0 to the second.
Value Evaluator::slice(const SliceExpr& e) {
  const Value object = evaluate(*e.object);
  const bool is_text = std::holds_alternative<std::string>(object.is);
  const std::vector<std::string> letters =
      is_text ? characters(object.text()) : std::vector<std::string>();
  const std::size_t size = is_text ? letters.size() : object.list().items.size();
  const std::string what = is_text ? "text" : "list";
  const std::int64_t first = e.first == nullptr ? 0 : evaluate(*e.first).integer();
  const std::int64_t last =
      e.last == nullptr ? static_cast<std::int64_t>(size) : evaluate(*e.last).integer();
  if (last < 0 || static_cast<std::size_t>(last) > size) fail_index(last, size + 1, e.span, what);
  if (first > last) fail_backwards(first, last, e.span);
  if (first < 0) fail_index(first, static_cast<std::size_t>(last) + 1, e.span, what);
  if (is_text) {
    std::string part;
    for (std::int64_t i = first; i < last; ++i) part += letters[i];
    return {part};
  }
  const auto begin = object.list().items.begin();
  for (std::int64_t i = first; i < last; ++i) {
    if (begin[i].absent()) fail_unset(i, e.object->span, e.span);
  }
  return {List{{begin + first, begin + last}}};
}

namespace {

Value zero_of(const Type& type) {
  if (!lang::has_zero(type)) return {};
  switch (type.kind) {
    case Kind::kBool:
      return {false};
    case Kind::kReal:
      return {0.0};
    case Kind::kText:
      return {std::string()};
    case Kind::kList:
      return {List{}};
    default:
      return {std::int64_t{0}};
  }
}

}  // namespace

Value Evaluator::new_array(const NewArrayExpr& e) {
  const Values sizes = evaluate_all(e.sizes);
  const Type* type = e.type;
  for (std::size_t i = 0; i < sizes.size(); ++i) type = type->element;
  Value out = zero_of(*type);
  for (std::size_t i = sizes.size(); i-- > 0;) {
    const std::int64_t size = sizes[i].integer();
    if (size < 0) fail("R0613", e.span, {"a list cannot have " + std::to_string(size) + " values"});
    out = {List{Values(size, out)}};
  }
  return out;
}

// Lambdas keep copies of what they use; conditions and tasks share what can change.
Value Evaluator::closure(const ClosureExpr& e) {
  Closure out{e.function, {}};
  for (const Capture& capture : e.function->captures) {
    const bool shares = capture.inner->storage == Storage::kBoxed;
    out.captures.push_back(shares ? home(*capture.outer).at(capture.outer)
                                  : std::make_shared<Value>(variable(*capture.outer, e.span)));
  }
  return {std::move(out)};
}

Value Evaluator::mutate(const MutateExpr& e) {
  if (e.mutation == Mutation::kRemoveKey) return remove_key(e);
  check_set(*e.place.variable, e.span);
  const Indices where = indices(e.place);
  const Value index = e.index == nullptr ? Value{} : evaluate(*e.index);
  const Value added = e.value == nullptr ? Value{} : evaluate(*e.value);
  Values& items = walk(e.place, where).list().items;
  const auto size = static_cast<std::int64_t>(items.size());
  std::int64_t at = index.absent() ? size : index.integer();
  if (e.mutation == Mutation::kPop) {
    if (size == 0) throw Failure{"R0606", "an empty list has no last value", "IndexError", e.span};
    at = size - 1;
  }
  if (e.mutation == Mutation::kPush || e.mutation == Mutation::kInsert) {
    if (at < 0 || at > size) fail_index(at, items.size() + 1, e.span);
    items.insert(items.begin() + at, added);
    return {};
  }
  if (at < 0 || at >= size) fail_index(at, items.size(), e.span);
  const Value removed = items[at];
  if (removed.absent()) fail_unset(at, e.place.span, e.span);
  items.erase(items.begin() + at);
  return removed;
}

}  // namespace armlet::oracle
