// Operators: numbers and quantities with the angle rule of section 6, text, truth, and what the
// library adds.

#include <algorithm>
#include <cmath>
#include <limits>

#include "check/checker.hpp"
#include "check/explain/edits.hpp"
#include "check/explain/nothings.hpp"
#include "check/types/matrices.hpp"

namespace armlet::lang {
namespace {

using ast::BinaryOp;
using hir::Op;

struct OpPair {
  Op integer;
  Op real;
};

std::optional<OpPair> arithmetic_op(BinaryOp op) {
  switch (op) {
    case BinaryOp::kAdd:
      return OpPair{Op::kAddI, Op::kAddR};
    case BinaryOp::kSub:
      return OpPair{Op::kSubI, Op::kSubR};
    case BinaryOp::kMul:
      return OpPair{Op::kMulI, Op::kMulR};
    case BinaryOp::kDiv:
      return OpPair{Op::kDivI, Op::kDivR};
    case BinaryOp::kMod:
      return OpPair{Op::kModI, Op::kModR};
    case BinaryOp::kPow:
      return OpPair{Op::kPowI, Op::kPowR};
    default:
      return std::nullopt;
  }
}

struct Comparison {
  Op integer;
  Op real;
  Op text;
};

std::optional<Comparison> comparison_op(BinaryOp op) {
  switch (op) {
    case BinaryOp::kLess:
      return Comparison{Op::kLtI, Op::kLtR, Op::kLtText};
    case BinaryOp::kLessEq:
      return Comparison{Op::kLeI, Op::kLeR, Op::kLeText};
    case BinaryOp::kGreater:
      return Comparison{Op::kGtI, Op::kGtR, Op::kGtText};
    case BinaryOp::kGreaterEq:
      return Comparison{Op::kGeI, Op::kGeR, Op::kGeText};
    case BinaryOp::kEq:
      return Comparison{Op::kEqI, Op::kEqR, Op::kEqText};
    case BinaryOp::kNe:
      return Comparison{Op::kNeI, Op::kNeR, Op::kNeText};
    default:
      return std::nullopt;
  }
}

bool is_sum(BinaryOp op) {
  return op == BinaryOp::kAdd || op == BinaryOp::kSub || op == BinaryOp::kMod;
}
bool is_equality(BinaryOp op) { return op == BinaryOp::kEq || op == BinaryOp::kNe; }
bool is_int_literal(const hir::Expr& expr) { return expr.kind == hir::ExprKind::kInt; }

}  // namespace

bool has_deep_equality(const Type* type) {
  switch (type->kind) {
    case Kind::kList:
    case Kind::kMap:
      return has_deep_equality(type->element);
    case Kind::kHost:
      return type->host->equal != nullptr;
    case Kind::kFunction:
    case Kind::kVoid:
      return false;
    default:
      return true;
  }
}

hir::Expr* Checker::check_unary(const ast::UnaryExpr& unary, const Type* expected) {
  if (unary.op == ast::UnaryOp::kMinus && unary.operand->kind == ast::ExprKind::kInt &&
      unary.operand->as<ast::IntExpr>().too_large &&
      text_of(unary.operand->span) == "9223372036854775808") {
    return make<hir::IntExpr>(hir::ExprKind::kInt, types_.integer(), unary.span,
                              std::numeric_limits<std::int64_t>::min());
  }
  hir::Expr* value = check_value(*unary.operand, expected);
  const Type* type = value->type;
  if (type->is(Kind::kAny)) return failed(unary.span);
  if (unary.op == ast::UnaryOp::kNot && type->is(Kind::kBool)) {
    return make<hir::UnaryExpr>(hir::ExprKind::kUnary, type, unary.span, Op::kNot, value);
  }
  if (unary.op == ast::UnaryOp::kPlus && type->is_number()) return value;
  if (unary.op == ast::UnaryOp::kMinus) {
    if (value->kind == hir::ExprKind::kInt) {
      return make<hir::IntExpr>(hir::ExprKind::kInt, type, unary.span,
                                -value->as<hir::IntExpr>().value);
    }
    if (value->kind == hir::ExprKind::kReal) {
      return make<hir::RealExpr>(hir::ExprKind::kReal, type, unary.span,
                                 -value->as<hir::RealExpr>().value);
    }
    if (type->is_number()) {
      const Op op = type->is(Kind::kInt) ? Op::kNegI : Op::kNegR;
      return make<hir::UnaryExpr>(hir::ExprKind::kUnary, type, unary.span, op, value);
    }
    const Span mark{unary.span.begin, unary.span.begin + 1, unary.span.source};
    if (hir::Expr* result = operator_native("-", mark, unary.span, {value})) return result;
  }
  const std::string_view op = unary.op == ast::UnaryOp::kNot    ? "!"
                              : unary.op == ast::UnaryOp::kPlus ? "+"
                                                                : "-";
  report(make_diagnostic("E0317", unary.span, {std::string(op), type_phrase(type)}));
  return failed(unary.span);
}

// Chains such as a + b + c ... lean to the left and may be thousands long, so they are walked in a
// loop. Texts that are joined become one node.
hir::Expr* Checker::check_binary(const ast::BinaryExpr& binary, const Type* expected) {
  std::vector<const ast::BinaryExpr*> chain = {&binary};
  while (chain.back()->left->kind == ast::ExprKind::kBinary) {
    chain.push_back(&chain.back()->left->as<ast::BinaryExpr>());
  }
  // The sides of a sum are what the sum is; those of a product need not be.
  const bool is_alone = chain.size() == 1 && is_sum(binary.op);
  const ast::Expr* nothing = nothing_in(*this, *chain.back());
  auto node = chain.rbegin();
  hir::Expr* left = nullptr;
  if (nothing != nullptr && nothing == chain.back()->left) {
    left = compared_with_nothing(*this, **node, *nothing, *check_value(*(*node)->right));
    ++node;
  } else {
    left = check_value(*chain.back()->left, is_alone ? expected : nullptr);
  }
  std::vector<hir::Expr*> texts;
  for (; node != chain.rend(); ++node) {
    const ast::BinaryExpr& at = **node;
    nothing = nothing_in(*this, at);
    if (nothing != nullptr && nothing == at.right) {
      left = compared_with_nothing(*this, at, *nothing, *left);
      texts.clear();
      continue;
    }
    hir::Expr* right = check_value(*at.right);
    if (at.op == BinaryOp::kAdd && !left->type->is(Kind::kAny) && !right->type->is(Kind::kAny) &&
        (left->type->is(Kind::kText) || right->type->is(Kind::kText))) {
      if (texts.empty()) texts.push_back(to_text(left));
      texts.push_back(to_text(right));
      const auto next = std::next(node);
      if (next != chain.rend() && (*next)->op == BinaryOp::kAdd) {
        left = texts.back();
        continue;
      }
      left = make<hir::ConcatExpr>(hir::ExprKind::kConcat, types_.text(), at.span, seq(texts));
      texts.clear();
      continue;
    }
    if (!texts.empty()) {
      left =
          make<hir::ConcatExpr>(hir::ExprKind::kConcat, types_.text(), at.left->span, seq(texts));
      texts.clear();
    }
    left = combine(at, left, right);
  }
  return left;
}

hir::Expr* Checker::combine(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right) {
  if (node.op == BinaryOp::kAnd || node.op == BinaryOp::kOr) {
    for (const hir::Expr* side : {left, right}) {
      if (side->type->is(Kind::kBool) || side->type->is(Kind::kAny)) continue;
      report(make_diagnostic("E0309", side->span, {type_phrase(side->type)}));
      return failed(node.span);
    }
    const auto kind = node.op == BinaryOp::kAnd ? hir::ExprKind::kAnd : hir::ExprKind::kOr;
    return make<hir::BinaryExpr>(kind, types_.boolean(), node.span, Op::kEqI, left, right,
                                 node.op_span);
  }
  if (left->type->is(Kind::kAny) || right->type->is(Kind::kAny)) return failed(node.span);
  if (comparison_op(node.op)) return compare(node, left, right);
  if (left->type->is_number() && right->type->is_number()) {
    if (node.op == BinaryOp::kPow) return raise(node, left, right);
    if (arithmetic_op(node.op)) return arithmetic(node, left, right);
  }
  const bool quantities = left->type->is(Kind::kList) && left->type->element->is_quantity();
  if (node.op == BinaryOp::kElemPow && quantities && right->type->is_number())
    return raise_elements(node, left, right);
  hir::Expr* result =
      operator_native(operator_text(node.op), node.op_span, node.span, {left, right});
  return result != nullptr ? result : no_operator(node, *left, *right);
}

// A quotient of whole numbers, where a fraction was perhaps meant.
void Checker::advise_whole_quotient(Span whole, Span left, Span right, const std::string& value) {
  if (!takes_advice()) return;
  Diagnostic advice = make_diagnostic("W0701", whole, {text_of(whole), value});
  const std::string above = text_of(left);
  const bool is_whole = is_decimal_number(above) && above.find_first_of(".eE") == std::string::npos;
  const std::string written =
      (is_whole ? above + ".0" : "double(" + above + ')') + " / " + as_operand(text_of(right));
  advice.fix = Fix{.text = "write " + written, .edits = {{whole, written}}};
  report(std::move(advice));
}

hir::Expr* Checker::arithmetic(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right) {
  const OpPair ops = *arithmetic_op(node.op);
  const auto binary = [&](const Type* type, Op op, hir::Expr* a, hir::Expr* b) {
    return folded(
        make<hir::BinaryExpr>(hir::ExprKind::kBinary, type, node.span, op, a, b, node.op_span));
  };
  if (left->type->is(Kind::kInt) && right->type->is(Kind::kInt)) {
    hir::Expr* result = binary(types_.integer(), ops.integer, left, right);
    if (node.op == BinaryOp::kDiv && is_int_literal(*left) && is_int_literal(*right)) {
      const std::int64_t by = right->as<hir::IntExpr>().value;
      if (by != 0 && by != -1 && left->as<hir::IntExpr>().value % by != 0)
        advise_whole_quotient(node.span, left->span, right->span,
                              std::to_string(left->as<hir::IntExpr>().value / by));
    }
    return result;
  }
  if (is_sum(node.op)) {
    const Type* type = common_type(*left, *right);
    if (type == nullptr) return different_dimensions(node, *left, *right);
    return binary(type, ops.real, convert(left, type), convert(right, type));
  }
  const auto dim = node.op == BinaryOp::kMul ? multiply(left->type->dim, right->type->dim)
                                             : divide(left->type->dim, right->type->dim);
  if (!dim) {
    report(make_diagnostic("E0409", node.span));
    return failed(node.span);
  }
  // A whole number of pitches, (i / columns) * pitch, is meant as it is written.
  const auto as_real = [&](hir::Expr* side, const hir::Expr& other) {
    if (!side->type->is(Kind::kInt)) return side;
    const bool counts = other.type->is_quantity() && side->kind == hir::ExprKind::kBinary;
    return counts ? cast(side, types_.real(), side->span) : convert(side, types_.real());
  };
  hir::Expr* const a = as_real(left, *right);
  return binary(types_.quantity(*dim), ops.real, a, as_real(right, *left));
}

hir::Expr* Checker::raise(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right) {
  const auto binary = [&](const Type* type, Op op, hir::Expr* a, hir::Expr* b) {
    return make<hir::BinaryExpr>(hir::ExprKind::kBinary, type, node.span, op, a, b, node.op_span);
  };
  const bool negative = is_int_literal(*right) && right->as<hir::IntExpr>().value < 0;
  if (left->type->is(Kind::kInt) && right->type->is(Kind::kInt) && !negative) {
    hir::BinaryExpr* result = binary(types_.integer(), Op::kPowI, left, right);
    if (classic_declaration_ && is_int_literal(*left) && is_int_literal(*right)) {
      std::string shown = text_of(node.span);
      if (const auto value = constant_of(*result)) shown += " is " + std::to_string(value->integer);
      Diagnostic advice = make_diagnostic("W0703", node.op_span, {shown});
      advice.why = "in Java `^` mixes bits";
      advice.fix = Fix{.text = "ignore this if a power was meant"};
      report(std::move(advice));
    }
    return result;
  }
  hir::Expr* exponent = convert(right, types_.real());
  if (exponent == nullptr) return mismatch(*right, {.type = types_.real(), .name = "exponent"});
  if (!left->type->is_quantity()) {
    return binary(types_.real(), Op::kPowR, convert(left, types_.real()), exponent);
  }
  const Type* type = power_of(left->type, *exponent, node.span);
  return type == nullptr ? failed(node.span) : binary(type, Op::kPowR, left, exponent);
}

// A quantity to a power that the text tells; null after a message.
const Type* Checker::power_of(const Type* quantity, const hir::Expr& exponent, Span whole) {
  const auto constant = constant_of(exponent);
  const double halves = constant ? constant->real * 2.0 : 0.5;
  if (halves != std::round(halves) || std::abs(halves) > 1000.0) {
    report(make_diagnostic("E0408", exponent.span));
    return nullptr;
  }
  const auto dim = power(quantity->dim, static_cast<int>(halves));
  if (!dim) {
    report(make_diagnostic("E0409", whole));
    return nullptr;
  }
  return types_.quantity(*dim);
}

// lengths .^ 2: computed on plain numbers, because no signature can say what the exponent does.
hir::Expr* Checker::raise_elements(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right) {
  const Type* element = power_of(left->type->element, *right, node.span);
  if (element == nullptr) return failed(node.span);
  const auto as = [&](const Type* type, hir::Expr* value) {
    return make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, value->span,
                                  hir::Conversion::kSame, value);
  };
  hir::Expr* result =
      operator_native(".^", node.op_span, node.span, {as(types_.list(types_.real()), left), right});
  if (result == nullptr) return no_operator(node, *left, *right);
  return as(types_.list(element), result);
}

hir::Expr* Checker::compare(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right) {
  const Comparison ops = *comparison_op(node.op);
  const auto binary = [&](Op op, hir::Expr* a, hir::Expr* b) {
    return make<hir::BinaryExpr>(hir::ExprKind::kBinary, types_.boolean(), node.span, op, a, b,
                                 node.op_span);
  };
  if (left->type->is(Kind::kInt) && right->type->is(Kind::kInt))
    return binary(ops.integer, left, right);
  if (left->type->is_number() && right->type->is_number()) {
    const Type* type = common_type(*left, *right);
    if (type == nullptr) return different_dimensions(node, *left, *right);
    return binary(ops.real, convert(left, type), convert(right, type));
  }
  if (left->type->is(Kind::kText) && right->type->is(Kind::kText))
    return binary(ops.text, left, right);
  if (!is_equality(node.op)) return no_operator(node, *left, *right);
  const bool by_number = left->type->is(Kind::kBool) || left->type->is(Kind::kEnum);
  if (by_number && left->type == right->type) return binary(ops.integer, left, right);
  const Type* type = common_type(*left, *right);
  if (type == nullptr || by_number || !has_deep_equality(type))
    return no_operator(node, *left, *right);
  return binary(node.op == BinaryOp::kEq ? Op::kEqDeep : Op::kNeDeep, convert(left, type),
                convert(right, type));
}

// An operator that the library declares for these types; null if there is none.
hir::Expr* Checker::operator_native(std::string_view op, Span op_span, Span span,
                                    std::vector<hir::Expr*> operands) {
  const std::string name = "operator" + std::string(op);
  std::vector<Argument> arguments;
  for (hir::Expr* operand : operands) arguments.push_back({.value = operand});
  std::vector<const NativeFunction*> fitting;
  for (const NativeFunction* candidate : registry_.functions(name)) {
    if (fit(signature_of(*candidate), arguments, false).problem == Fit::Problem::kNone)
      fitting.push_back(candidate);
  }
  if (fitting.empty()) return nullptr;
  return call_native(name, fitting, op_span, span, std::move(arguments));
}

// Whether the library declares an operator for these types.
static bool has_operator(Checker& checker, std::string_view name, const hir::Expr& left,
                         const hir::Expr& right) {
  return std::ranges::any_of(checker.registry_.functions(name),
                             [&](const NativeFunction* candidate) {
                               const auto& parameters = checker.signature_of(*candidate).parameters;
                               Bindings bindings;
                               return parameters.size() == 2 &&
                                      match(parameters[0].type, left.type, false, bindings) >= 0 &&
                                      match(parameters[1].type, right.type, false, bindings) >= 0;
                             });
}

hir::Expr* Checker::no_operator(const ast::BinaryExpr& node, const hir::Expr& left,
                                const hir::Expr& right) {
  const std::string op(operator_text(node.op));
  if (!takes_errors()) {
    report(make_diagnostic("E0316", node.op_span, {"", "", ""}));
    return failed(node.span);
  }
  if (left.type->is(Kind::kList) && right.type->is(Kind::kList) &&
      (node.op == BinaryOp::kMul || node.op == BinaryOp::kDiv)) {
    Diagnostic diagnostic = make_diagnostic("E0304", node.span, {op});
    diagnostic.mark.label = left.type == right.type
                                ? "both are " + type_name(left.type)
                                : type_name(left.type) + " and " + type_name(right.type);
    const std::string a = text_of(left.span);
    const std::string b = text_of(right.span);
    const std::string each = as_operand(a) + " ." + op + ' ' + as_operand(b);
    const std::string element_wise = each + " for element by element";
    diagnostic.fix = node.op == BinaryOp::kMul
                         ? Fix{.text = "write dot(" + a + ", " + b + ") for the inner product or " +
                                       element_wise,
                               .edits = {{node.span, "dot(" + a + ", " + b + ")"}}}
                         : Fix{.text = "write " + element_wise, .edits = {{node.span, each}}};
    report(std::move(diagnostic));
    return failed(node.span);
  }
  const hir::Expr* text = left.type->is(Kind::kText)    ? &left
                          : right.type->is(Kind::kText) ? &right
                                                        : nullptr;
  if (text != nullptr && arithmetic_op(node.op)) {
    report(make_diagnostic("E0314", text->span, {"a text"}));
    return failed(node.span);
  }
  Diagnostic diagnostic =
      make_diagnostic("E0316", node.op_span, {op, type_phrase(left.type), type_phrase(right.type)});
  diagnostic.related.push_back({left.span, type_name(left.type)});
  diagnostic.related.push_back({right.span, type_name(right.type)});
  diagnostic.fix = matrix_operator_fix(*this, node, left, right);
  if (!diagnostic.fix && node.op == BinaryOp::kAdd &&
      has_operator(*this, "operator*", left, right)) {
    const std::string product =
        as_operand(text_of(left.span)) + " * " + as_operand(text_of(right.span));
    diagnostic.fix = Fix{.text = "to put one behind the other, write " + product,
                         .edits = {{node.span, product}}};
  }
  report(std::move(diagnostic));
  return failed(node.span);
}

hir::Expr* Checker::different_dimensions(const ast::BinaryExpr& node, const hir::Expr& left,
                                         const hir::Expr& right) {
  if (!left.type->is_quantity() || !right.type->is_quantity()) {
    const bool left_plain = !left.type->is_quantity();
    plain_number_for_quantity(left_plain ? left : right,
                              {.type = left_plain ? right.type : left.type});
    return failed(node.span);
  }
  const std::string a = dimension_phrase(left.type->dim);
  const std::string b = dimension_phrase(right.type->dim);
  std::vector<std::string> words = {a, "compared with", b};
  if (node.op == BinaryOp::kAdd) words[1] = "added to";
  if (node.op == BinaryOp::kSub) words = {b, "subtracted from", a};
  if (node.op == BinaryOp::kMod) words[1] = "divided with a remainder by";
  Diagnostic diagnostic = make_diagnostic("E0402", right.span, words);
  diagnostic.mark.label = dimension_name(right.type->dim);
  diagnostic.related.push_back({left.span, dimension_name(left.type->dim)});
  diagnostic.fix = Fix{.text = "check which of the two was meant"};
  report(std::move(diagnostic));
  return failed(node.span);
}

}  // namespace armlet::lang
