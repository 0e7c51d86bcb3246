#include "check/statements/statements.hpp"

#include <algorithm>

#include "base/cancelled.hpp"
#include "check/blocks/block_declarations.hpp"
#include "check/calls/intrinsics.hpp"
#include "check/declarations/declarations.hpp"
#include "check/explain/catch_types.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/expressions/expressions.hpp"
#include "check/expressions/places.hpp"
#include "check/functions/functions.hpp"
#include "check/functions/lambdas.hpp"
#include "check/library/explained.hpp"
#include "check/library/native_calls.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/names/variables.hpp"
#include "check/state/checker.hpp"
#include "check/state/constants.hpp"
#include "check/statements/asserts.hpp"
#include "check/statements/idle.hpp"
#include "check/statements/loops.hpp"
#include "check/statements/paths.hpp"
#include "check/statements/recordings.hpp"
#include "check/statements/settings.hpp"
#include "check/statements/switches.hpp"
#include "check/statements/tasks.hpp"

namespace armlet::lang {

namespace {

hir::Stmt* check_any_statement(Checker& checker, const ast::Stmt& stmt);
hir::Stmt* check_expression_statement(Checker& checker, const ast::ExprStmt& stmt);
hir::Stmt* check_if(Checker& checker, const ast::IfStmt& stmt);
hir::Stmt* check_return(Checker& checker, const ast::ReturnStmt& stmt);
hir::Stmt* check_jump(Checker& checker, const ast::Stmt& stmt);
hir::Stmt* check_throw(Checker& checker, const ast::ThrowStmt& stmt);
hir::Stmt* check_wait(Checker& checker, const ast::Expr& duration, Span span);
hir::Stmt* check_wait_until(Checker& checker, const ast::WaitUntilStmt& stmt);
hir::Stmt* check_try(Checker& checker, const ast::TryStmt& stmt);

constexpr std::string_view kFn = "fn";

// A finally block runs on every exit, so it must not exit to another target: an error or a
// cancellation would be lost. The motion of a path starts at the end of its block.
Diagnostic cannot_leave(JumpTarget::Kind kind, const std::string& word, Span span) {
  if (kind == JumpTarget::Kind::kPath) return leaves_path(word, span);
  Diagnostic diagnostic = make_diagnostic("E0121", span, {word, "what it leaves"});
  diagnostic.message = '`' + word + "` cannot leave a `finally` block";
  diagnostic.why = "the block runs on the way out, perhaps of an error, which would be lost";
  return diagnostic;
}

}  // namespace

hir::Block* Checker::check_block(ast::Seq<ast::Stmt*> body, Span span) {
  std::vector<hir::Stmt*> out;
  scopes.open_block();
  check_into(body, out);
  close_block(*this);
  return make<hir::Block>(hir::StmtKind::kBlock, span, seq(out));
}

void Checker::check_into(ast::Seq<ast::Stmt*> body, std::vector<hir::Stmt*>& out) {
  bool told = false;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const ast::Stmt& stmt = *body[i];
    const bool is_declaration =
        stmt.kind == ast::StmtKind::kFunction || stmt.kind == ast::StmtKind::kStruct ||
        stmt.kind == ast::StmtKind::kEnum || stmt.kind == ast::StmtKind::kTest;
    if (!scopes.here().flow.reachable && !told && stmt.kind != ast::StmtKind::kEmpty &&
        !is_declaration) {
      told = true;
      const ast::Stmt* before = i > 0 ? body[i - 1] : nullptr;
      const bool lone_return = before != nullptr && before->kind == ast::StmtKind::kReturn &&
                               before->as<ast::ReturnStmt>().value == nullptr &&
                               stmt.kind == ast::StmtKind::kExpr;
      Diagnostic advice =
          lone_return ? make_diagnostic("W0705", stmt.span) : make_diagnostic("W0710", stmt.span);
      if (lone_return) {
        advice.related.push_back({before->span, "ends here"});
        advice.fix = Fix{.text = "write the value behind return, on the same line",
                         .edits = {{{before->span.end, stmt.span.begin, stmt.span.source}, " "}}};
        report(std::move(advice));
        continue;
      }
      report(std::move(advice));
    }
    messages.begin_statement();
    if (is_active_statement(*this, stmt)) {
      check_active_statement(*this, stmt);
    } else if (stmt.kind == ast::StmtKind::kRecord) {
      return check_record(*this, stmt.as<ast::RecordStmt>(), body.subspan(i + 1), out);
    } else if (hir::Stmt* checked = check_statement(stmt)) {
      append(stmt, checked, out);
    }
  }
}

// int a = 1, b = 2, or an object with named rows: several statements without a block of their own;
// the variables stay visible.
void append(const ast::Stmt& stmt, hir::Stmt* checked, std::vector<hir::Stmt*>& out) {
  const bool declares = stmt.kind == ast::StmtKind::kVar || stmt.kind == ast::StmtKind::kObject;
  if (!declares || checked->kind != hir::StmtKind::kBlock) {
    out.push_back(checked);
    return;
  }
  std::ranges::copy(checked->as<hir::Block>().body, std::back_inserter(out));
}

hir::Stmt* Checker::check_statement(const ast::Stmt& stmt) {
  stop_if(options.cancelled);
  if (shared.depth.is_full()) {
    report(make_diagnostic("E0125", stmt.span, {std::to_string(Depth::kMost) + " levels"}));
    return nullptr;
  }
  const Depth::Level level(shared.depth);
  hir::Stmt* out = check_any_statement(*this, stmt);
  if (stmt.kind == ast::StmtKind::kAssign || stmt.kind == ast::StmtKind::kStep)
    learn_targets(*this, stmt);
  return out;
}

namespace {

hir::Stmt* check_any_statement(Checker& checker, const ast::Stmt& stmt) {
  using ast::StmtKind;
  switch (stmt.kind) {
    case StmtKind::kBlock:
      return checker.check_block(stmt.as<ast::Block>().body, stmt.span);
    case StmtKind::kEmpty:
      return nullptr;
    case StmtKind::kVar:
      return check_var(checker, stmt.as<ast::VarStmt>());
    case StmtKind::kObject:
      return check_object(checker, stmt.as<ast::ObjectStmt>());
    case StmtKind::kFunction:
    case StmtKind::kStruct:
    case StmtKind::kEnum:
    case StmtKind::kImport:
      return nullptr;  // collected before; in other positions refused while the tree was built
    case StmtKind::kTest:
      return check_test(checker, stmt.as<ast::TestStmt>());
    case StmtKind::kIf:
      return check_if(checker, stmt.as<ast::IfStmt>());
    case StmtKind::kWhile:
    case StmtKind::kDo:
    case StmtKind::kForIn:
    case StmtKind::kFor:
      return check_loop(checker, stmt);
    case StmtKind::kSwitch:
      return check_switch(checker, stmt.as<ast::SwitchStmt>());
    case StmtKind::kTry:
      return check_try(checker, stmt.as<ast::TryStmt>());
    case StmtKind::kParallel:
    case StmtKind::kWhen:
    case StmtKind::kEvery:
      return check_tasks(checker, stmt);
    case StmtKind::kPath:
      return check_path(checker, stmt.as<ast::PathStmt>());
    case StmtKind::kWith:
      return check_with(checker, stmt.as<ast::WithStmt>());
    case StmtKind::kRecord:
      return check_lone_record(checker, stmt.as<ast::RecordStmt>());
    case StmtKind::kExpr:
      return check_expression_statement(checker, stmt.as<ast::ExprStmt>());
    case StmtKind::kAssign:
      return check_assign(checker, stmt.as<ast::AssignStmt>());
    case StmtKind::kStep:
      return check_step(checker, stmt.as<ast::StepStmt>());
    case StmtKind::kWait:
      return check_wait(checker, *stmt.as<ast::WaitStmt>().duration, stmt.span);
    case StmtKind::kWaitUntil:
      return check_wait_until(checker, stmt.as<ast::WaitUntilStmt>());
    case StmtKind::kBreak:
    case StmtKind::kContinue:
    case StmtKind::kRetry:
      return check_jump(checker, stmt);
    case StmtKind::kReturn:
      return check_return(checker, stmt.as<ast::ReturnStmt>());
    case StmtKind::kThrow:
      return check_throw(checker, stmt.as<ast::ThrowStmt>());
  }
  return nullptr;
}

hir::Stmt* check_expression_statement(Checker& checker, const ast::ExprStmt& stmt) {
  if (stmt.value->kind == ast::ExprKind::kCall) {
    const auto& call = stmt.value->as<ast::CallExpr>();
    const std::string name = dotted_name(checker, *call.callee);
    const bool own = checker.names.find_function(name) != nullptr;
    if (name == "assert" && !own) return check_assert(checker, call);
    if (name == "assertThrows" && !own) return check_assert_throws(checker, call);
    if (name == "Thread.sleep") {
      if (!takes(checker, call, name, 1, 1)) return nullptr;
      hir::Expr* milliseconds =
          checker.check_as(*call.args[0].value, {.role = Target::Role::kArgument,
                                                 .type = checker.types.real(),
                                                 .function = "Thread.sleep"});
      hir::Expr* factor = checker.make<hir::RealExpr>(hir::ExprKind::kReal, checker.types.real(),
                                                      stmt.span, 1000.0);
      hir::Expr* seconds = folded(
          checker,
          checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, checker.types.real(), stmt.span,
                                        hir::Op::kDivR, milliseconds, factor, stmt.span));
      note_pause(checker, stmt.span);
      return checker.make<hir::WaitStmt>(hir::StmtKind::kWait, stmt.span, seconds);
    }
  }
  if (stmt.value->kind == ast::ExprKind::kLambda) {
    const std::uint32_t behind = stmt.span.begin + static_cast<std::uint32_t>(kFn.size());
    Diagnostic diagnostic =
        make_diagnostic("E0129", {behind, behind, stmt.span.source}, {"a name"});
    diagnostic.why = "a function without a name is a value, which would be forgotten here";
    checker.report(std::move(diagnostic));
    checker.messages.set_syntax_failed();
    return nullptr;
  }
  hir::Expr* value = checker.check(*stmt.value);
  if (does_nothing(*value)) {
    refuse_idle_statement(checker, stmt, *value);
    return nullptr;
  }
  if (hir::Expr* shown = shown_explanation(checker, stmt, value)) {
    value = shown;
  } else {
    advise_forgotten_value(checker, stmt, *value);
  }
  return checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, stmt.span, value);
}

hir::Stmt* check_if(Checker& checker, const ast::IfStmt& stmt) {
  hir::Expr* test = checker.condition(*stmt.condition);
  const Flow before = checker.scopes.here().flow;
  const auto branch = [&](const ast::Stmt& body) {
    checker.messages.begin_statement();
    checker.scopes.open_block();
    hir::Stmt* out = checker.check_statement(body);
    close_block(checker);
    return out;
  };
  hir::Stmt* yes = branch(*stmt.yes);
  Flow after = std::exchange(checker.scopes.here().flow, before);
  hir::Stmt* no = stmt.no != nullptr ? branch(*stmt.no) : nullptr;
  after.merge(checker.scopes.here().flow);
  checker.scopes.here().flow = std::move(after);
  if (yes == nullptr)
    yes = checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.yes->span, hir::Seq<hir::Stmt*>{});
  return checker.make<hir::IfStmt>(hir::StmtKind::kIf, stmt.span, test, yes, no);
}

}  // namespace

bool is_value_statement(Checker& checker, const ast::ExprStmt& stmt) {
  if (stmt.value->kind == ast::ExprKind::kLambda) return false;
  if (stmt.value->kind != ast::ExprKind::kCall) return true;
  const std::string name = dotted_name(checker, *stmt.value->as<ast::CallExpr>().callee);
  if (name == "Thread.sleep") return false;
  return (name != "assert" && name != "assertThrows") ||
         checker.names.find_function(name) != nullptr;
}

namespace {

hir::Stmt* check_return(Checker& checker, const ast::ReturnStmt& stmt) {
  FunctionContext& context = checker.scopes.here();
  const bool in_function = context.kind == FunctionContext::Kind::kNamed ||
                           context.kind == FunctionContext::Kind::kLambda;
  if (!in_function) return nullptr;  // refused while the tree was built
  const auto keeps = [](const JumpTarget& at) {
    return at.kind == JumpTarget::Kind::kFinally || at.kind == JumpTarget::Kind::kPath;
  };
  const auto kept = std::ranges::find_if(context.targets, keeps);
  if (kept != context.targets.end()) {
    checker.report(cannot_leave(kept->kind, "return", stmt.span));
    return nullptr;
  }
  const bool is_void = context.result_is_declared && context.result->is(Kind::kVoid);
  const std::string name(context.function->name);
  if (stmt.value != nullptr && is_void) {
    checker.check(*stmt.value);
    checker.report(make_diagnostic("E0321", stmt.value->span, {name}));
    return nullptr;
  }
  if (stmt.value != nullptr) {
    const Type* wanted = context.result_is_declared ? context.result : nullptr;
    hir::Expr* value = checker.check(*stmt.value, wanted);
    advise_on_divided_remark(checker, *stmt.value, *value, wanted);
    return return_value(checker, value, stmt.span);
  }
  if (context.result_is_declared && !is_void && !context.result->is(Kind::kAny)) {
    checker.report(make_diagnostic("E0322", stmt.span, {type_phrase(context.result)}));
  }
  if (!context.result_is_declared && context.result == nullptr)
    context.result = checker.types.void_type();
  context.flow.reachable = false;
  return checker.make<hir::ReturnStmt>(hir::StmtKind::kReturn, stmt.span, nullptr);
}

hir::Stmt* check_jump(Checker& checker, const ast::Stmt& stmt) {
  using To = JumpTarget::Kind;
  const bool is_break = stmt.kind == ast::StmtKind::kBreak;
  const bool is_retry = stmt.kind == ast::StmtKind::kRetry;
  const auto leaves = [&](const JumpTarget& target) {
    if (target.kind == To::kFinally || target.kind == To::kPath) return true;
    if (is_retry) return target.kind == To::kCatch;
    return target.kind == To::kLoop || (is_break && target.kind == To::kSwitch);
  };
  auto& targets = checker.scopes.here().targets;
  const auto found = std::find_if(targets.rbegin(), targets.rend(), leaves);
  if (found == targets.rend()) {
    const std::string word = is_break ? "break" : is_retry ? "retry" : "continue";
    checker.report(make_diagnostic("E0121", stmt.span,
                                   {word, is_retry   ? "`catch`"
                                          : is_break ? "a loop or a `switch`"
                                                     : "a loop"}));
    return nullptr;
  }
  if (found->kind == To::kFinally || found->kind == To::kPath) {
    const std::string word = is_break ? "break" : is_retry ? "retry" : "continue";
    checker.report(cannot_leave(found->kind, word, stmt.span));
    return nullptr;
  }
  if (is_break) found->exits.push_back(checker.scopes.here().flow);
  if (!is_break && !is_retry) found->repeats.push_back(checker.scopes.here().flow);
  checker.scopes.here().flow.reachable = false;
  const hir::Jump jump = is_break   ? hir::Jump::kBreak
                         : is_retry ? hir::Jump::kRetry
                                    : hir::Jump::kContinue;
  return checker.make<hir::JumpStmt>(hir::StmtKind::kJump, stmt.span, jump, found->statement);
}

hir::Stmt* check_throw(Checker& checker, const ast::ThrowStmt& stmt) {
  hir::Expr* value = checker.check_value(*stmt.value);
  checker.scopes.here().flow.reachable = false;
  if (value->type->is(Kind::kText)) {
    Diagnostic diagnostic = make_diagnostic("E0315", value->span, {"an error", "a string"});
    const std::string written = "error(" + checker.text_of(value->span) + ")";
    diagnostic.fix = Fix{.text = "write throw " + written,
                         .edits = {{value->span, written}},
                         .confidence = Confidence::kSure};
    checker.report(std::move(diagnostic));
    return nullptr;
  }
  value = checker.require(value, {.type = checker.shared.error_type, .name = "throw"});
  return checker.make<hir::ThrowStmt>(hir::StmtKind::kThrow, stmt.span, value);
}

}  // namespace

hir::Expr* seconds(Checker& checker, const ast::Expr& written, std::string_view what) {
  hir::Expr* value = checker.check_value(written);
  // Programs with classic declarations give times as plain numbers of seconds.
  if (hir::Expr* plain = checker.convert(value, checker.types.real())) return plain;
  const bool setting = what == "timeout";
  return checker.require(value, {.role = setting ? Target::Role::kSetting : Target::Role::kVariable,
                                 .type = checker.types.quantity(dims::kTime),
                                 .name = setting ? what : std::string_view()});
}

namespace {

hir::Stmt* check_wait(Checker& checker, const ast::Expr& duration, Span span) {
  note_pause(checker, span);
  hir::Expr* value = seconds(checker, duration, "wait");
  const auto known = checker.shared.constants.of(*value);
  const bool is_number =
      known && (known->kind == Constant::Kind::kReal || known->kind == Constant::Kind::kInt);
  if (is_number && known->real < 0.0) {
    checker.report(make_diagnostic("E0534", duration.span,
                                   {"wait", "0 s or more", checker.text_of(duration.span)}));
  }
  return checker.make<hir::WaitStmt>(hir::StmtKind::kWait, span, value);
}

hir::Stmt* check_wait_until(Checker& checker, const ast::WaitUntilStmt& stmt) {
  hir::Expr* timeout = nullptr;
  for (const ast::Arg& arg : stmt.args) {
    if (arg.name.text != "timeout") {
      const Span mark = arg.name.text.empty() ? arg.span : arg.name.span;
      Diagnostic diagnostic = make_diagnostic("E0207", mark, {"wait until", checker.text_of(mark)});
      diagnostic.why = "wait until accepts timeout";
      if (!arg.name.text.empty())
        diagnostic.fix = did_you_mean(checker, arg.name.text, mark, {"timeout"});
      checker.report(std::move(diagnostic));
      return nullptr;
    }
    if (timeout != nullptr) checker.report(make_diagnostic("E0212", arg.name.span, {"timeout"}));
    timeout = seconds(checker, *arg.value, "timeout");
  }
  hir::Expr* guard = check_guard(checker, *stmt.condition);
  note_pause(checker, stmt.span);
  const Span span = stmt.condition->span;
  return checker.make<hir::WaitUntilStmt>(hir::StmtKind::kWaitUntil, stmt.span, guard, timeout,
                                          checker.into.sources->slice(span), span);
}

hir::Stmt* check_try(Checker& checker, const ast::TryStmt& stmt) {
  auto* out = checker.make<hir::TryStmt>(hir::StmtKind::kTry, stmt.span, nullptr, nullptr, nullptr,
                                         nullptr);
  const Flow before = checker.scopes.here().flow;
  ++checker.scopes.here().tries;
  out->body = checker.check_block(stmt.body->body, stmt.body->span);
  --checker.scopes.here().tries;
  Flow after = checker.scopes.here().flow;
  for (std::size_t i = 0; i < stmt.catches.size(); ++i) {
    const ast::CatchClause& clause = stmt.catches[i];
    if (i > 0) {
      Diagnostic diagnostic = make_diagnostic("E0337", clause.body->span);
      diagnostic.related.push_back({stmt.catches[0].body->span, "this one takes every error"});
      diagnostic.fix = Fix{.text = "use one catch with switch (e.kind) { ... } inside it"};
      checker.report(std::move(diagnostic));
      break;
    }
    advise_catch_of_a_type(checker, clause);
    // The body may have stopped at any point, so none of its assignments is certain.
    checker.scopes.here().flow = before;
    checker.scopes.open_block();
    if (!clause.name.text.empty() && is_free(checker, clause.name)) {
      out->error =
          new_variable(checker, clause.name.text, checker.shared.error_type, clause.name.span);
      out->error->fixed = true;
      checker.scopes.add(out->error, Declared::kCatch, clause.name.span);
    }
    checker.scopes.here().targets.push_back({JumpTarget::Kind::kCatch, out});
    out->handler = checker.check_block(clause.body->body, clause.body->span);
    checker.scopes.here().targets.pop_back();
    close_block(checker);
    after.merge(checker.scopes.here().flow);
  }
  checker.scopes.here().flow = after;
  if (stmt.finally != nullptr) {
    checker.scopes.here().flow = before;
    checker.scopes.here().targets.push_back({JumpTarget::Kind::kFinally, out});
    out->finally = checker.check_block(stmt.finally->body, stmt.finally->span);
    checker.scopes.here().targets.pop_back();
    // The finally block has run on every path after it.
    after.add_values_of(checker.scopes.here().flow);
    after.reachable = after.reachable && checker.scopes.here().flow.reachable;
    checker.scopes.here().flow = std::move(after);
  }
  return out;
}

}  // namespace

}  // namespace armlet::lang
