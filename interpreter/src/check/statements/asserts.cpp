// assert and assertThrows: statements that show what they looked at.

#include <algorithm>

#include "check/checker.hpp"

namespace armlet::lang {
namespace {

bool is_literal(const hir::Expr& value) {
  switch (value.kind) {
    case hir::ExprKind::kBool:
    case hir::ExprKind::kInt:
    case hir::ExprKind::kReal:
    case hir::ExprKind::kText:
    case hir::ExprKind::kEnum:
    case hir::ExprKind::kAbsent:
      return true;
    case hir::ExprKind::kConvert:
      return is_literal(*value.as<hir::ConvertExpr>().operand);
    case hir::ExprKind::kList:
      return std::ranges::all_of(value.as<hir::ListExpr>().items,
                                 [](const hir::Expr* item) { return is_literal(*item); });
    default:
      return false;
  }
}

bool can_be_shown(const Type* type) {
  while (type->is(Kind::kList) || type->is(Kind::kMap)) type = type->element;
  if (type->is(Kind::kHost)) return type->host->text != nullptr;
  return !type->is(Kind::kFunction) && !type->is(Kind::kVoid) && !type->is(Kind::kAny);
}

// a && b && c: the conditions that have to hold, from left to right.
void take_apart(hir::Expr* test, std::vector<hir::Expr*>& out) {
  if (test->kind != hir::ExprKind::kAnd) {
    out.push_back(test);
    return;
  }
  take_apart(test->as<hir::BinaryExpr>().left, out);
  take_apart(test->as<hir::BinaryExpr>().right, out);
}

}  // namespace

// One assertion for each part of a && b, so that the message marks the part that does not hold.
hir::Stmt* Checker::check_assert(const ast::CallExpr& call) {
  mentioned_.insert("assert");
  if (!takes(call, "assert", 1, 2)) return nullptr;
  const ast::Expr& written = *call.args[0].value;
  std::vector<hir::Expr*> tests;
  take_apart(condition(written), tests);
  std::vector<hir::Stmt*> out;
  for (hir::Expr* test : tests) {
    hir::Expr* note = call.args.size() > 1
                          ? check_as(*call.args[1].value, {.role = Target::Role::kArgument,
                                                           .type = types_.text(),
                                                           .function = "assert",
                                                           .position = 2})
                          : nullptr;
    const Span mark = tests.size() == 1 ? written.span : test->span;
    auto* one = make<hir::AssertStmt>(hir::StmtKind::kAssert, call.span, hir::Seq<hir::InitStmt*>{},
                                      test, note, hir::Seq<hir::AssertPart>{}, nullptr,
                                      into_.sources->slice(written.span), mark);
    if (!test->type->is(Kind::kAny)) split_condition(*one, test);
    out.push_back(one);
  }
  return out.size() == 1 ? out[0] : make<hir::Block>(hir::StmtKind::kBlock, call.span, seq(out));
}

// The sides of a comparison, or the values of a call, are computed once into hidden variables, so
// that a failure can show them.
void Checker::split_condition(hir::AssertStmt& stmt, hir::Expr* test) {
  while (test->kind == hir::ExprKind::kUnary) test = static_cast<hir::UnaryExpr*>(test)->operand;
  std::vector<hir::InitStmt*> inits;
  std::vector<hir::AssertPart> shown;
  const auto keep = [&](hir::Expr*& part, Span span) {
    if (is_literal(*part) || !can_be_shown(part->type)) return;
    hir::Variable* variable = hidden(part->type, span);
    variable->init = part;
    inits.push_back(make<hir::InitStmt>(hir::StmtKind::kInit, span, variable, part));
    shown.push_back({into_.sources->slice(span), variable});
    part = make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, span, variable);
  };
  if (test->kind == hir::ExprKind::kBinary) {
    auto* comparison = static_cast<hir::BinaryExpr*>(test);
    keep(comparison->left, comparison->left->span);
    keep(comparison->right, comparison->right->span);
  } else if (test->kind == hir::ExprKind::kOverList) {
    auto* loop = static_cast<hir::OverListExpr*>(test);
    std::vector<hir::Expr*> operands(loop->operands.begin(), loop->operands.end());
    for (hir::Expr*& operand : operands) keep(operand, operand->span);
    loop->operands = seq(operands);
  } else if (test->kind == hir::ExprKind::kCallNative) {
    auto* call = static_cast<hir::CallNativeExpr*>(test);
    std::vector<hir::Expr*> arguments(call->arguments.begin(), call->arguments.end());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (!call->site.arguments[i].empty()) keep(arguments[i], arguments[i]->span);
    }
    call->arguments = seq(arguments);
    if (call->function->explain) {
      NativeFunction why = *call->function;
      why.thunk = why.explain;
      why.real1 = nullptr;
      why.real2 = nullptr;
      why.real3 = nullptr;
      const auto* function = arena_.make<NativeFunction>(why);
      stmt.explain = make<hir::CallNativeExpr>(hir::ExprKind::kCallNative, types_.text(),
                                               call->span, function, call->arguments, call->site);
    }
  }
  stmt.parts_init = seq(inits);
  stmt.shown = seq(shown);
}

hir::Stmt* Checker::check_assert_throws(const ast::CallExpr& call) {
  mentioned_.insert("assertThrows");
  const ast::Expr* body = nullptr;
  hir::Expr* kind = nullptr;
  for (const ast::Arg& arg : call.args) {
    const bool is_kind = arg.name.text == "kind";
    if (!arg.name.text.empty() && !is_kind) {
      report(make_diagnostic("E0207", arg.name.span, {"assertThrows", std::string(arg.name.text)}));
      return nullptr;
    }
    if (is_kind) {
      kind = check_as(*arg.value, {.role = Target::Role::kSetting,
                                   .type = types_.text(),
                                   .name = "kind",
                                   .function = "assertThrows"});
    } else if (body == nullptr) {
      body = arg.value;
    }
  }
  const std::size_t values = (body != nullptr ? 1 : 0) + (kind != nullptr ? 1 : 0);
  if (body == nullptr || values != call.args.size()) {
    report(make_diagnostic(
        "E0312", call.callee->span,
        {"assertThrows", "1 function and a kind", std::to_string(call.args.size())}));
    return nullptr;
  }
  auto* out = make<hir::AssertThrowsStmt>(hir::StmtKind::kAssertThrows, call.span, nullptr, kind,
                                          body->span);
  // fn() => f(x) is run in place: what it names are the variables here.
  if (body->kind == ast::ExprKind::kLambda && body->as<ast::LambdaExpr>().params.empty() &&
      body->as<ast::LambdaExpr>().value != nullptr) {
    out->call = check(*body->as<ast::LambdaExpr>().value);
    return out;
  }
  const Type* wanted = types_.function({}, types_.void_type());
  hir::Expr* function = check_value(*body, wanted);
  const bool fits = function->type->is(Kind::kFunction) && function->type->parameters.empty();
  if (!fits) {
    if (!function->type->is(Kind::kAny)) {
      report(make_diagnostic(
          "E0313", function->span,
          {"assertThrows", "a function without parameters", type_phrase(function->type)}));
    }
    return nullptr;
  }
  out->call = make<hir::CallValueExpr>(hir::ExprKind::kCallValue, function->type->result,
                                       body->span, function, hir::Seq<hir::Expr*>{},
                                       hir::CallSite{body->span, body->span, {}});
  return out;
}

}  // namespace armlet::lang
