// The five implicit conversions (language reference, section 5), and casts.

#include "check/explain/mismatch_units.hpp"
#include "check/explain/quotients.hpp"
#include "check/state/checker.hpp"
#include "check/types/maps.hpp"
#include "check/types/mismatch.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {

bool is_zero(const hir::Expr& value) {
  if (value.kind == hir::ExprKind::kInt) return value.as<hir::IntExpr>().value == 0;
  return value.kind == hir::ExprKind::kReal && value.type->is_double() &&
         value.as<hir::RealExpr>().value == 0.0;
}

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
    case Kind::kAny:
    case Kind::kBool:
    case Kind::kInt:
    case Kind::kReal:
    case Kind::kText:
    case Kind::kMatrix:
    case Kind::kRecord:
    case Kind::kEnum:
      break;
  }
  return true;
}

namespace {

hir::Expr* number_as(Checker& checker, hir::Expr* value, const Type* type) {
  if (conversion_cost(value->type, type, is_zero(*value)) < 0) return nullptr;
  if (value->kind == hir::ExprKind::kInt) {
    const auto number = static_cast<double>(value->as<hir::IntExpr>().value);
    return checker.make<hir::RealExpr>(hir::ExprKind::kReal, type, value->span, number);
  }
  if (value->kind == hir::ExprKind::kBinary && value->as<hir::BinaryExpr>().op == hir::Op::kDivI) {
    const auto& quotient = value->as<hir::BinaryExpr>();
    advise_whole_quotient(checker, value->span, quotient.left->span, quotient.right->span,
                          "a whole number");
  }
  const auto how =
      value->type->is(Kind::kInt) ? hir::Conversion::kIntToReal : hir::Conversion::kSame;
  return checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, value->span, how, value);
}

}  // namespace

hir::Expr* Checker::convert(hir::Expr* value, const Type* type) {
  const Type* from = value->type;
  if (from == type || from->is(Kind::kAny) || type->is(Kind::kAny)) return value;
  if (from->is_number() && type->is(Kind::kReal)) return number_as(*this, value, type);
  types.join_tables(from, type);
  if (from->is_table() && type->is_table() && from->record == type->record)
    return make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, value->span,
                                  hir::Conversion::kSame, value);
  if (value->kind == hir::ExprKind::kMap && type->is(Kind::kMap))
    return convert_map(*this, value->as<hir::MapExpr>(), type);
  if (from->is(Kind::kMap) && type->is(Kind::kMap) && conversion_cost(from, type) == 0)
    return make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, value->span,
                                  hir::Conversion::kSame, value);
  if (!from->is(Kind::kList) || !type->is(Kind::kList)) return nullptr;
  if (value->kind == hir::ExprKind::kList) {
    // A list literal takes the expected element type.
    std::vector<hir::Expr*> items;
    for (hir::Expr* item : value->as<hir::ListExpr>().items) {
      items.push_back(convert(item, type->element));
      if (items.back() == nullptr) return nullptr;
    }
    return make<hir::ListExpr>(hir::ExprKind::kList, type, value->span, seq(items));
  }
  if (conversion_cost(from, type) < 0) return nullptr;
  const Type* inner_from = from;
  while (inner_from->is(Kind::kList)) inner_from = inner_from->element;
  if (inner_from->is(Kind::kInt) && !from->element->is(Kind::kInt)) return nullptr;
  const auto how =
      inner_from->is(Kind::kInt) ? hir::Conversion::kListIntToReal : hir::Conversion::kSame;
  return make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, value->span, how, value);
}

hir::Expr* Checker::require(hir::Expr* value, const Target& target) {
  if (hir::Expr* converted = convert(value, target.type)) return converted;
  if (value->kind == hir::ExprKind::kList && target.type->is(Kind::kList)) {
    // The message marks the element that does not fit.
    for (hir::Expr* item : value->as<hir::ListExpr>().items) {
      if (convert(item, target.type->element) != nullptr) continue;
      Target element{.role = Target::Role::kElement, .type = target.type->element};
      require(item, element);
      return failed(value->span);
    }
  }
  if (value->kind == hir::ExprKind::kMap && target.type->is(Kind::kMap)) {
    for (hir::Expr* item : value->as<hir::MapExpr>().values) {
      if (convert(item, target.type->element) != nullptr) continue;
      require(item, {.role = Target::Role::kElement, .type = target.type->element});
      return failed(value->span);
    }
  }
  return mismatch(*this, *value, target);
}

hir::Expr* Checker::check_as(const ast::Expr& expr, const Target& target) {
  return require(check(expr, target.type), target);
}

hir::Expr* Checker::condition(const ast::Expr& expr) {
  hir::Expr* value = check_value(expr, types.boolean());
  if (value->type->is(Kind::kBool) || value->type->is(Kind::kAny)) return value;
  Diagnostic diagnostic = make_diagnostic("E0309", value->span, {type_phrase(value->type)});
  if (value->type->is(Kind::kInt)) {
    const std::string text = text_of(value->span) + " != 0";
    diagnostic.fix = Fix{.text = "write " + text, .edits = {{value->span, text}}};
  }
  report(std::move(diagnostic));
  return failed(value->span);
}

hir::Expr* cast(Checker& checker, hir::Expr* value, const Type* type, Span span) {
  if (value->type->is(Kind::kAny)) return checker.failed(span);
  if (type->is(Kind::kInt) && value->type->is_double()) {
    return checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, span,
                                          hir::Conversion::kRealToInt, value);
  }
  if (type->is_double() && value->type->is(Kind::kInt)) {
    return checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, type, span,
                                          hir::Conversion::kIntToReal, value);
  }
  if (value->type->is(Kind::kReal) && (type->is_double() || type->is(Kind::kInt))) {
    hir::Expr* number = checker.convert(value, checker.types.real());
    if (number == nullptr) {
      quantity_for_number(checker, *value);
      return checker.failed(span);
    }
    return type->is(Kind::kInt) ? cast(checker, number, type, span) : number;
  }
  if (value->type == type) return value;
  checker.report(make_diagnostic("E0325", span, {type_phrase(value->type), type_phrase(type)}));
  return checker.failed(span);
}

const Type* common_type(Checker& checker, const hir::Expr& a, const hir::Expr& b) {
  if (a.type->is(Kind::kAny) || b.type->is(Kind::kAny)) return checker.types.any();
  const bool maps = a.type->is(Kind::kMap) && b.type->is(Kind::kMap);
  const bool lists = a.type->is(Kind::kList) && b.type->is(Kind::kList);
  if ((maps || lists) && a.type->element->is(Kind::kAny)) return b.type;
  if ((maps || lists) && b.type->element->is(Kind::kAny)) return a.type;
  if (conversion_cost(b.type, a.type, is_zero(b)) == 0) return a.type;
  if (a.type->is_number() && b.type->is_number()) {
    if (is_zero(a) && b.type->is(Kind::kReal)) return b.type;
    if (is_zero(b) && a.type->is(Kind::kReal)) return a.type;
    const auto dim = common_dimension(a.type->dim, b.type->dim);
    return dim ? checker.types.quantity(*dim) : nullptr;
  }
  if (!maps && !lists) return nullptr;
  if (conversion_cost(b.type, a.type) >= 0) return a.type;
  return conversion_cost(a.type, b.type) >= 0 ? b.type : nullptr;
}

}  // namespace armlet::lang
