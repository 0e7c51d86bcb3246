#include "check/statements/asserts.hpp"

#include <algorithm>
#include <array>

#include "check/calls/intrinsics.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

namespace {

void split_condition(Checker& checker, hir::AssertStmt& stmt, hir::Expr* condition);

bool is_literal(const hir::Expr& value) {
  using hir::ExprKind;
  if (value.kind == ExprKind::kConvert) return is_literal(*value.as<hir::ConvertExpr>().operand);
  if (value.kind == ExprKind::kList)
    return std::ranges::all_of(value.as<hir::ListExpr>().items,
                               [](const hir::Expr* item) { return is_literal(*item); });
  constexpr std::array kLiterals = {ExprKind::kBool, ExprKind::kInt,  ExprKind::kReal,
                                    ExprKind::kText, ExprKind::kEnum, ExprKind::kAbsent};
  return std::ranges::find(kLiterals, value.kind) != kLiterals.end();
}

bool can_be_shown(const Type* type) {
  while (type->is(Kind::kList) || type->is(Kind::kMap)) type = type->element;
  if (type->is(Kind::kHost)) return type->host->text != nullptr;
  return !type->is(Kind::kFunction) && !type->is(Kind::kVoid) && !type->is(Kind::kAny);
}

// a && b && c: the conditions that all have to hold, from left to right.
void take_apart(hir::Expr* test, std::vector<hir::Expr*>& out) {
  if (test->kind != hir::ExprKind::kAnd) {
    out.push_back(test);
    return;
  }
  take_apart(test->as<hir::BinaryExpr>().left, out);
  take_apart(test->as<hir::BinaryExpr>().right, out);
}

}  // namespace

// One assertion for each operand of a && b, so that the message marks the one that does not hold.
hir::Stmt* check_assert(Checker& checker, const ast::CallExpr& call) {
  checker.shared.mentions.add("assert");
  if (!takes(checker, call, "assert", 1, 2)) return nullptr;
  const ast::Expr& written = *call.args[0].value;
  std::vector<hir::Expr*> tests;
  take_apart(checker.condition(written), tests);
  std::vector<hir::Stmt*> out;
  for (hir::Expr* test : tests) {
    hir::Expr* note = call.args.size() > 1
                          ? checker.check_as(*call.args[1].value, {.role = Target::Role::kArgument,
                                                                   .type = checker.types.text(),
                                                                   .function = "assert",
                                                                   .position = 2})
                          : nullptr;
    const Span mark = tests.size() == 1 ? written.span : test->span;
    auto* one = checker.make<hir::AssertStmt>(
        hir::StmtKind::kAssert, call.span, hir::Seq<hir::InitStmt*>{}, test, note,
        hir::Seq<hir::AssertPart>{}, nullptr, checker.into.sources->slice(written.span), mark);
    if (!test->type->is(Kind::kAny)) split_condition(checker, *one, test);
    out.push_back(one);
  }
  return out.size() == 1
             ? out[0]
             : checker.make<hir::Block>(hir::StmtKind::kBlock, call.span, checker.seq(out));
}

namespace {

// The operands of a comparison, or the arguments of a call, are evaluated once into hidden
// variables, so that a failure can show them.
void split_condition(Checker& checker, hir::AssertStmt& stmt, hir::Expr* test) {
  while (test->kind == hir::ExprKind::kUnary) test = static_cast<hir::UnaryExpr*>(test)->operand;
  std::vector<hir::InitStmt*> inits;
  std::vector<hir::AssertPart> shown;
  const auto keep = [&](hir::Expr*& part, Span span) {
    if (is_literal(*part) || !can_be_shown(part->type)) return;
    hir::Variable* variable = hidden(checker, part->type, span);
    variable->init = part;
    inits.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, span, variable, part));
    shown.push_back({checker.into.sources->slice(span), variable});
    part =
        checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, span, variable);
  };
  if (test->kind == hir::ExprKind::kBinary) {
    auto* comparison = static_cast<hir::BinaryExpr*>(test);
    keep(comparison->left, comparison->left->span);
    keep(comparison->right, comparison->right->span);
  } else if (test->kind == hir::ExprKind::kOverList) {
    auto* loop = static_cast<hir::OverListExpr*>(test);
    std::vector<hir::Expr*> operands(loop->operands.begin(), loop->operands.end());
    for (hir::Expr*& operand : operands) keep(operand, operand->span);
    loop->operands = checker.seq(operands);
  } else if (test->kind == hir::ExprKind::kCallNative) {
    auto* call = static_cast<hir::CallNativeExpr*>(test);
    std::vector<hir::Expr*> arguments(call->arguments.begin(), call->arguments.end());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!call->site.arguments[i].empty()) keep(arguments[i], arguments[i]->span);
    }
    call->arguments = checker.seq(arguments);
    if (call->function->explain) {
      NativeFunction why = *call->function;
      why.thunk = why.explain;
      why.real1 = nullptr;
      why.real2 = nullptr;
      why.real3 = nullptr;
      const auto* function = checker.arena.make<NativeFunction>(why);
      stmt.explain =
          checker.make<hir::CallNativeExpr>(hir::ExprKind::kCallNative, checker.types.text(),
                                            call->span, function, call->arguments, call->site);
    }
  }
  stmt.parts_init = checker.seq(inits);
  stmt.shown = checker.seq(shown);
}

}  // namespace

hir::Stmt* check_assert_throws(Checker& checker, const ast::CallExpr& call) {
  checker.shared.mentions.add("assertThrows");
  const ast::Expr* body = nullptr;
  hir::Expr* kind = nullptr;
  for (const ast::Arg& arg : call.args) {
    const bool is_kind = arg.name.text == "kind";
    if (!arg.name.text.empty() && !is_kind) {
      checker.report(
          make_diagnostic("E0207", arg.name.span, {"assertThrows", std::string(arg.name.text)}));
      return nullptr;
    }
    if (is_kind) {
      kind = checker.check_as(*arg.value, {.role = Target::Role::kSetting,
                                           .type = checker.types.text(),
                                           .name = "kind",
                                           .function = "assertThrows"});
    } else if (body == nullptr) {
      body = arg.value;
    }
  }
  const std::size_t values = (body != nullptr ? 1 : 0) + (kind != nullptr ? 1 : 0);
  if (body == nullptr || values != call.args.size()) {
    checker.report(make_diagnostic(
        "E0312", call.callee->span,
        {"assertThrows", "1 function and a kind", std::to_string(call.args.size())}));
    return nullptr;
  }
  auto* out = checker.make<hir::AssertThrowsStmt>(hir::StmtKind::kAssertThrows, call.span, nullptr,
                                                  kind, body->span);
  // The body of fn() => f(x) is checked without a lambda: its names refer to variables of this
  // function.
  if (body->kind == ast::ExprKind::kLambda && body->as<ast::LambdaExpr>().params.empty() &&
      body->as<ast::LambdaExpr>().value != nullptr) {
    out->call = checker.check(*body->as<ast::LambdaExpr>().value);
    return out;
  }
  const Type* wanted = checker.types.function({}, checker.types.void_type());
  hir::Expr* function = checker.check_value(*body, wanted);
  const bool fits = function->type->is(Kind::kFunction) && function->type->parameters.empty();
  if (!fits) {
    if (!function->type->is(Kind::kAny)) {
      checker.report(make_diagnostic(
          "E0313", function->span,
          {"assertThrows", "a function without parameters", type_phrase(function->type)}));
    }
    return nullptr;
  }
  out->call = checker.make<hir::CallValueExpr>(hir::ExprKind::kCallValue, function->type->result,
                                               body->span, function, hir::Seq<hir::Expr*>{},
                                               hir::CallSite{body->span, body->span, {}});
  return out;
}

}  // namespace armlet::lang
