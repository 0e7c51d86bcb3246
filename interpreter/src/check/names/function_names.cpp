#include "check/names/function_names.hpp"

#include "check/names/imports.hpp"

namespace armlet::lang {

const FunctionDecl* written_function(Checker& checker, const ast::Expr& expr) {
  if (expr.kind != ast::ExprKind::kName) return imported_function(checker, expr);
  FunctionContext* where = nullptr;
  const std::string_view name = expr.as<ast::NameExpr>().name;
  return checker.find_local(name, where) == nullptr ? checker.find_function(name) : nullptr;
}

std::string library_function(Checker& checker, const ast::Expr& expr) {
  constexpr std::string_view kMath = "Math.";
  std::string name = checker.dotted_name(expr);
  if (name == kToText) return name;
  if (name.starts_with(kMath)) {
    name.erase(0, kMath.size());
  } else if (name.find('.') != std::string::npos || checker.find_function(name) != nullptr ||
             checker.type_called(name) != nullptr) {
    return {};
  }
  const bool is_one =
      checker.registry_.constant(name) == nullptr && !checker.registry_.functions(name).empty();
  return is_one ? name : std::string();
}

hir::Expr* library_function_value(Checker& checker, const ast::Expr& written, std::string_view name,
                                  const Type* expected) {
  if (expected == nullptr || !expected->is(Kind::kFunction) ||
      (checker.registry_.functions(name).empty() && name != kToText))
    return nullptr;
  const std::size_t count = expected->parameters.size();
  std::vector<ast::Param> params(count);
  std::vector<ast::Arg> args(count);
  const Span behind{written.span.end, written.span.end, written.span.source};
  for (std::size_t i = 0; i < count; ++i) {
    // No program can write this name, so that it hides nothing.
    const ast::Name parameter{checker.arena_.copy("value " + std::to_string(i + 1)), written.span};
    params[i] = {
        .name = parameter, .type = nullptr, .default_value = nullptr, .span = written.span};
    args[i].value = checker.arena_.make<ast::NameExpr>(
        ast::Expr{.kind = ast::ExprKind::kName, .span = written.span}, parameter.text);
  }
  auto* call = checker.arena_.make<ast::CallExpr>(
      ast::Expr{.kind = ast::ExprKind::kCall, .span = written.span},
      const_cast<ast::Expr*>(&written), checker.arena_.copy(args), behind);
  const ast::LambdaExpr lambda{{.kind = ast::ExprKind::kLambda, .span = written.span},
                               checker.arena_.copy(params),
                               nullptr,
                               nullptr,
                               call};
  return checker.check_lambda(lambda, expected);
}

std::string lambda_around(Checker& checker, std::string_view function) {
  const auto known = checker.registry_.functions(function);
  if (known.empty()) return "";
  std::size_t left = checker.signature_of(*known[0]).parameters.size();
  for (const NativeFunction* other : known) {
    if (checker.signature_of(*other).parameters.size() != left) return "";
  }
  std::string names;
  for (char letter = 'a'; left > 0 && letter <= 'z'; ++letter) {
    const std::string name(1, letter == 'a' ? 'x' : letter == 'x' ? 'a' : letter);
    FunctionContext* where = nullptr;
    if (checker.find_local(name, where) != nullptr) continue;
    names += (names.empty() ? "" : ", ") + name;
    --left;
  }
  return "fn(" + names + ") => " + std::string(function) + '(' + names + ')';
}

}  // namespace armlet::lang
