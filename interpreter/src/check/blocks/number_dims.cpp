#include "check/blocks/number_dims.hpp"

#include <algorithm>
#include <functional>

#include "armlet/interpreter/binding/dims_fact.hpp"
#include "check/checker.hpp"
#include "check/types/constants.hpp"

namespace armlet::lang {
namespace {

using hir::ExprKind;
using Dims = std::optional<std::vector<Dim>>;

constexpr int kDeepestPart = 24;
constexpr int kMostLooks = 5000;
constexpr std::size_t kMostParts = 200;  // things of a value

bool is_number_list(const TypePattern& pattern, int d) {
  return pattern.form == TypePattern::Form::kList &&
         pattern.parts[0].form == TypePattern::Form::kDimension && pattern.parts[0].d == d &&
         pattern.parts[0].e == 0;
}
// D, with nothing else in it.
bool is_plain_d(const TypePattern& pattern) {
  return pattern.form == TypePattern::Form::kDimension && pattern.d == 1 && pattern.e == 0 &&
         pattern.dim.is_none();
}

class DimsOfParts {
 public:
  explicit DimsOfParts(Checker& checker) : checker_(checker) {}

  Dims of(const hir::Expr& expr, int depth) const {
    if (depth > kDeepestPart || --left_ < 0) return std::nullopt;
    const hir::Expr& at = origin_of(expr);
    if (const auto* fact = dynamic_cast<const DimsFact*>(fact_of(at))) return fact->dims;
    const bool is_negative =
        at.kind == ExprKind::kUnary && at.as<hir::UnaryExpr>().op == hir::Op::kNegR;
    Dims found;
    if (at.kind == ExprKind::kElement) found = element(at.as<hir::ElementExpr>(), depth);
    if (at.kind == ExprKind::kSlice) return slice(at.as<hir::SliceExpr>(), depth);
    if (is_negative) found = of(*at.as<hir::UnaryExpr>().operand, depth + 1);
    if (at.kind == ExprKind::kBinary) found = sum(at.as<hir::BinaryExpr>(), depth);
    if (at.kind == ExprKind::kCond) found = either(at.as<hir::CondExpr>(), depth);
    if (at.kind == ExprKind::kList) return all_of(at.as<hir::ListExpr>().items, depth);
    if (at.kind == ExprKind::kRecord) return all_of(at.as<hir::RecordExpr>().fields, depth);
    if (at.kind == ExprKind::kCall) found = result_of(*at.as<hir::CallExpr>().function, depth);
    if (at.kind == ExprKind::kCallNative) found = native(at.as<hir::CallNativeExpr>(), depth);
    return found ? found : by_type(*at.type);
  }

  // What a function gives whose body names some values and ends with one.
  Dims result_of(const hir::Function& function, int depth) const {
    if (function.body == nullptr || function.body->body.empty()) return std::nullopt;
    const hir::Stmt* last = function.body->body.back();
    for (const hir::Stmt* each : function.body->body)
      if (each != last && each->kind != hir::StmtKind::kInit) return std::nullopt;
    if (last->kind != hir::StmtKind::kReturn) return std::nullopt;
    const hir::Expr* value = static_cast<const hir::ReturnStmt*>(last)->value;
    return value == nullptr ? std::nullopt : of(*value, depth + 1);
  }

 private:
  // One thing; how many there are in a list, a matrix or a value of the host, a type does not tell.
  static Dims by_type(const Type& type) {
    if (type.is_quantity()) return std::vector{type.dim};
    const bool is_one =
        type.is_number() || type.is(Kind::kBool) || type.is(Kind::kText) || type.is(Kind::kEnum);
    return is_one ? Dims(std::vector{Dim{}}) : std::nullopt;
  }

  [[nodiscard]] std::optional<std::int64_t> whole(const hir::Expr* expr,
                                                  std::int64_t otherwise) const {
    if (expr == nullptr) return otherwise;
    const auto known = checker_.shared.constants.of(*expr);
    if (!known || known->kind != Constant::Kind::kInt) return std::nullopt;
    return known->integer;
  }

  Dims element(const hir::ElementExpr& node, int depth) const {
    const auto index = whole(node.index, 0);
    const Dims all = of(*node.object, depth + 1);
    if (!all || !index || node.column != nullptr || !node.type->is_number()) return std::nullopt;
    if (*index < 0 || *index >= static_cast<std::int64_t>(all->size())) return std::nullopt;
    return std::vector{(*all)[static_cast<std::size_t>(*index)]};
  }

  Dims slice(const hir::SliceExpr& node, int depth) const {
    const Dims all = of(*node.object, depth + 1);
    if (!all || !node.type->is(Kind::kList) || !node.type->element->is_number())
      return std::nullopt;
    const auto size = static_cast<std::int64_t>(all->size());
    const auto first = whole(node.first, 0);
    const auto last = whole(node.last, size);
    if (!first || !last || *first < 0 || *last > size || *first > *last) return std::nullopt;
    return std::vector(all->begin() + *first, all->begin() + *last);
  }

  // Of two that have the same.
  Dims sum(const hir::BinaryExpr& node, int depth) const {
    if (node.op != hir::Op::kAddR && node.op != hir::Op::kSubR) return std::nullopt;
    const Dims left = of(*node.left, depth + 1);
    return left == of(*node.right, depth + 1) ? left : std::nullopt;
  }
  Dims either(const hir::CondExpr& node, int depth) const {
    const Dims yes = of(*node.yes, depth + 1);
    return yes == of(*node.no, depth + 1) ? yes : std::nullopt;
  }

  Dims all_of(std::span<hir::Expr* const> parts, int depth) const {
    std::vector<Dim> all;
    for (const hir::Expr* part : parts) {
      const Dims some = of(*part, depth + 1);
      if (!some || all.size() + some->size() > kMostParts) return std::nullopt;
      all.insert(all.end(), some->begin(), some->end());
    }
    return all;
  }

  // norm(v: D[]) -> D gives what all of v are; a + b, element by element, what both are.
  Dims native(const hir::CallNativeExpr& call, int depth) const {
    const Signature& signature = checker_.shared.signatures.of(*call.function);
    const std::string_view name = call.function->name;
    const bool is_by_element = name == "operator+" || name == "operator-" || name == "abs";
    const bool gives_list = is_by_element && is_number_list(signature.result, 1);
    if (!gives_list && !is_plain_d(signature.result)) return std::nullopt;
    Dims given;
    for (std::size_t p = 0; p < signature.parameters.size(); ++p) {
      const TypePattern& pattern = signature.parameters[p].type;
      const bool is_list = is_number_list(pattern, 1);
      if (!is_list && !is_plain_d(pattern)) continue;
      Dims own = of(*call.arguments[p], depth + 1);
      if (!own || own->empty()) return std::nullopt;
      if (!gives_list &&
          std::adjacent_find(own->begin(), own->end(), std::not_equal_to()) != own->end())
        return std::nullopt;
      if (!gives_list) own->resize(1);
      if (given && given != own) return std::nullopt;
      given = std::move(own);
    }
    return given;
  }

  Checker& checker_;
  mutable int left_ = kMostLooks;  // `let b = a + a; let c = b + b` doubles them
};

}  // namespace

Dims dims_of_numbers(Checker& checker, const hir::Expr& expr) {
  const DimsOfParts reader(checker);
  const hir::Expr& at = origin_of(expr);
  Dims found;
  if (at.kind == ExprKind::kFunctionValue)
    found = reader.result_of(*at.as<hir::FunctionValueExpr>().function, 0);
  else if (at.kind == ExprKind::kClosure)
    found = reader.result_of(*at.as<hir::ClosureExpr>().function, 0);
  else
    found = reader.of(expr, 0);
  if (!found || std::ranges::all_of(*found, &Dim::is_none)) return std::nullopt;
  return found;
}

}  // namespace armlet::lang
