#include "check/functions/function_names.hpp"

#include "check/functions/lambdas.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {

const FunctionDecl* written_function(Checker& checker, const ast::Expr& expr) {
  if (expr.kind != ast::ExprKind::kName) return imported_function(checker, expr);
  FunctionContext* where = nullptr;
  const std::string_view name = expr.as<ast::NameExpr>().name;
  return checker.scopes.find(name, where) == nullptr ? checker.names.find_function(name) : nullptr;
}

std::string library_function(Checker& checker, const ast::Expr& expr) {
  constexpr std::string_view kMath = "Math.";
  std::string name = dotted_name(checker, expr);
  if (name == kToText) return name;
  if (name.starts_with(kMath)) {
    name.erase(0, kMath.size());
  } else if (name.find('.') != std::string::npos || checker.names.find_function(name) != nullptr ||
             type_called(checker, name) != nullptr) {
    return {};
  }
  const bool is_one =
      checker.registry.constant(name) == nullptr && !checker.registry.functions(name).empty();
  return is_one ? name : std::string();
}

hir::Expr* library_function_value(Checker& checker, const ast::Expr& written, std::string_view name,
                                  const Type* expected) {
  if (expected == nullptr || !expected->is(Kind::kFunction) ||
      (checker.registry.functions(name).empty() && name != kToText))
    return nullptr;
  const std::size_t count = expected->parameters.size();
  std::vector<ast::Param> params(count);
  std::vector<ast::Arg> args(count);
  const Span behind{written.span.end, written.span.end, written.span.source};
  for (std::size_t i = 0; i < count; ++i) {
    // The name contains a blank, so no name of a program can be the same.
    const ast::Name parameter{checker.arena.copy("value " + std::to_string(i + 1)), written.span};
    params[i] = {
        .name = parameter, .type = nullptr, .default_value = nullptr, .span = written.span};
    args[i].value = checker.arena.make<ast::NameExpr>(
        ast::Expr{.kind = ast::ExprKind::kName, .span = written.span}, parameter.text);
  }
  auto* call = checker.arena.make<ast::CallExpr>(
      ast::Expr{.kind = ast::ExprKind::kCall, .span = written.span},
      const_cast<ast::Expr*>(&written), checker.arena.copy(args), behind);
  const ast::LambdaExpr lambda{{.kind = ast::ExprKind::kLambda, .span = written.span},
                               checker.arena.copy(params),
                               nullptr,
                               nullptr,
                               call};
  return check_lambda(checker, lambda, expected);
}

std::string lambda_around(Checker& checker, std::string_view function) {
  const auto known = checker.registry.functions(function);
  if (known.empty()) return "";
  std::size_t left = checker.shared.signatures.of(*known[0]).parameters.size();
  for (const NativeFunction* other : known) {
    if (checker.shared.signatures.of(*other).parameters.size() != left) return "";
  }
  std::string names;
  for (char letter = 'a'; left > 0 && letter <= 'z'; ++letter) {
    const std::string name(1, letter == 'a' ? 'x' : letter == 'x' ? 'a' : letter);
    FunctionContext* where = nullptr;
    if (checker.scopes.find(name, where) != nullptr) continue;
    names += (names.empty() ? "" : ", ") + name;
    --left;
  }
  return "fn(" + names + ") => " + std::string(function) + '(' + names + ')';
}

}  // namespace armlet::lang
