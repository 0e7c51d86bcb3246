// Statements that are no loops, no switches and no declarations.

#include <algorithm>

#include "check/checker.hpp"
#include "check/explain/divided_remarks.hpp"
#include "check/explain/explained.hpp"
#include "check/names/imports.hpp"
#include "check/statements/paths.hpp"
#include "check/statements/recordings.hpp"
#include "check/statements/settings.hpp"
#include "check/statements/tasks.hpp"
#include "compile/cancelled.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kFn = "fn";

// Computing it changes nothing, so a statement made of it does nothing.
bool does_nothing(const hir::Expr& value) {
  switch (value.kind) {
    case hir::ExprKind::kCall:
    case hir::ExprKind::kCallValue:
    case hir::ExprKind::kCallNative:
    case hir::ExprKind::kMutate:
    case hir::ExprKind::kGuarded:
      return false;
    case hir::ExprKind::kCond:
      return does_nothing(*value.as<hir::CondExpr>().yes) &&
             does_nothing(*value.as<hir::CondExpr>().no);
    case hir::ExprKind::kConvert:
      return does_nothing(*value.as<hir::ConvertExpr>().operand);
    default:
      return !value.type->is(Kind::kAny);
  }
}

// What is done finally is done on every way out, so it cannot choose another one: an error or a
// cancellation would be lost. A path is made when its end is reached.
Diagnostic cannot_leave(JumpTarget::Kind kind, const std::string& word, Span span) {
  if (kind == JumpTarget::Kind::kPath) return leaves_path(word, span);
  Diagnostic diagnostic = make_diagnostic("E0121", span, {word, "what it leaves"});
  diagnostic.message = '`' + word + "` cannot leave a `finally` block";
  diagnostic.why = "the block runs on the way out, perhaps of an error, which would be lost";
  return diagnostic;
}

// A value alone on its line: a call without its parentheses, or the result of a function that other
// languages return by itself.
void refuse_idle_statement(Checker& checker, const ast::ExprStmt& stmt, const hir::Expr& value) {
  Diagnostic diagnostic = make_diagnostic("E0332", stmt.value->span);
  const FunctionContext& here = *checker.here_;
  const std::string text = checker.text_of(stmt.value->span);
  const Span begin{stmt.span.begin, stmt.span.begin, stmt.span.source};
  const Span end{stmt.value->span.end, stmt.value->span.end, stmt.value->span.source};
  if (value.kind == hir::ExprKind::kFunctionValue) {
    diagnostic.fix = Fix{.text = "write " + text + "()", .edits = {{end, "()"}}};
  } else if (here.result_is_declared && here.result == value.type) {
    diagnostic.why = "a value is given back by `return`";
    diagnostic.fix = Fix{.text = "write return " + text, .edits = {{begin, "return "}}};
    checker.here_->flow.reachable = false;  // no second message about the missing return
  }
  checker.report(std::move(diagnostic));
}

}  // namespace

hir::Block* Checker::check_block(ast::Seq<ast::Stmt*> body, Span span) {
  std::vector<hir::Stmt*> out;
  open_block();
  check_into(body, out);
  close_block();
  return make<hir::Block>(hir::StmtKind::kBlock, span, seq(out));
}

void Checker::check_into(ast::Seq<ast::Stmt*> body, std::vector<hir::Stmt*>& out) {
  bool told = false;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const ast::Stmt& stmt = *body[i];
    const bool is_declaration =
        stmt.kind == ast::StmtKind::kFunction || stmt.kind == ast::StmtKind::kStruct ||
        stmt.kind == ast::StmtKind::kEnum || stmt.kind == ast::StmtKind::kTest;
    if (!here_->flow.reachable && !told && stmt.kind != ast::StmtKind::kEmpty && !is_declaration) {
      told = true;
      const ast::Stmt* before = i > 0 ? body[i - 1] : nullptr;
      const bool lone_return = before != nullptr && before->kind == ast::StmtKind::kReturn &&
                               before->as<ast::ReturnStmt>().value == nullptr &&
                               stmt.kind == ast::StmtKind::kExpr;
      Diagnostic advice = make_diagnostic(lone_return ? "W0705" : "W0710", stmt.span);
      if (lone_return) {
        advice.related.push_back({before->span, "ends here"});
        advice.fix = Fix{.text = "write the value behind return, on the same line",
                         .edits = {{{before->span.end, stmt.span.begin, stmt.span.source}, " "}}};
        report(std::move(advice));
        continue;
      }
      report(std::move(advice));
    }
    sink_.begin_statement();
    if (is_active_statement(*this, stmt)) {
      check_active_statement(*this, stmt);
    } else if (stmt.kind == ast::StmtKind::kRecord) {
      return check_record(*this, stmt.as<ast::RecordStmt>(), body.subspan(i + 1), out);
    } else if (hir::Stmt* checked = check_statement(stmt)) {
      append(stmt, checked, out);
    }
  }
}

// int a = 1, b = 2: several statements, but no block of their own; the variables live on.
void Checker::append(const ast::Stmt& stmt, hir::Stmt* checked, std::vector<hir::Stmt*>& out) {
  if (stmt.kind != ast::StmtKind::kVar || checked->kind != hir::StmtKind::kBlock) {
    out.push_back(checked);
    return;
  }
  std::ranges::copy(checked->as<hir::Block>().body, std::back_inserter(out));
}

hir::Stmt* Checker::check_statement(const ast::Stmt& stmt) {
  stop_if(options_.cancelled);
  if (++depth_ > 600) {
    report(make_diagnostic("E0125", stmt.span, {"600 levels"}));
    --depth_;
    return nullptr;
  }
  hir::Stmt* out = check_any_statement(stmt);
  --depth_;
  return out;
}

hir::Stmt* Checker::check_any_statement(const ast::Stmt& stmt) {
  using ast::StmtKind;
  switch (stmt.kind) {
    case StmtKind::kBlock:
      return check_block(stmt.as<ast::Block>().body, stmt.span);
    case StmtKind::kEmpty:
      return nullptr;
    case StmtKind::kVar:
      return check_var(stmt.as<ast::VarStmt>());
    case StmtKind::kObject:
      return check_object(stmt.as<ast::ObjectStmt>());
    case StmtKind::kFunction:
    case StmtKind::kStruct:
    case StmtKind::kEnum:
    case StmtKind::kImport:
      return nullptr;  // collected before; refused elsewhere while the tree was built
    case StmtKind::kTest:
      return check_test(stmt.as<ast::TestStmt>());
    case StmtKind::kIf:
      return check_if(stmt.as<ast::IfStmt>());
    case StmtKind::kWhile:
    case StmtKind::kDo:
    case StmtKind::kForIn:
    case StmtKind::kFor:
      return check_loop(stmt);
    case StmtKind::kSwitch:
      return check_switch(stmt.as<ast::SwitchStmt>());
    case StmtKind::kTry:
      return check_try(stmt.as<ast::TryStmt>());
    case StmtKind::kParallel:
    case StmtKind::kWhen:
    case StmtKind::kEvery:
      return check_tasks(*this, stmt);
    case StmtKind::kPath:
      return check_path(*this, stmt.as<ast::PathStmt>());
    case StmtKind::kWith:
      return check_with(*this, stmt.as<ast::WithStmt>());
    case StmtKind::kRecord:
      return check_lone_record(*this, stmt.as<ast::RecordStmt>());
    case StmtKind::kExpr:
      return check_expression_statement(stmt.as<ast::ExprStmt>());
    case StmtKind::kAssign:
      return check_assign(stmt.as<ast::AssignStmt>());
    case StmtKind::kStep:
      return check_step(stmt.as<ast::StepStmt>());
    case StmtKind::kWait:
      return check_wait(*stmt.as<ast::WaitStmt>().duration, stmt.span);
    case StmtKind::kWaitUntil:
      return check_wait_until(stmt.as<ast::WaitUntilStmt>());
    case StmtKind::kBreak:
    case StmtKind::kContinue:
    case StmtKind::kRetry:
      return check_jump(stmt);
    case StmtKind::kReturn:
      return check_return(stmt.as<ast::ReturnStmt>());
    case StmtKind::kThrow:
      return check_throw(stmt.as<ast::ThrowStmt>());
  }
  return nullptr;
}

hir::Stmt* Checker::check_expression_statement(const ast::ExprStmt& stmt) {
  if (stmt.value->kind == ast::ExprKind::kCall) {
    const auto& call = stmt.value->as<ast::CallExpr>();
    const std::string name = dotted_name(*call.callee);
    const bool own = find_function(name) != nullptr;
    if (name == "assert" && !own) return check_assert(call);
    if (name == "assertThrows" && !own) return check_assert_throws(call);
    if (name == "Thread.sleep") {
      if (!takes(call, name, 1, 1)) return nullptr;
      hir::Expr* milliseconds = check_as(
          *call.args[0].value,
          {.role = Target::Role::kArgument, .type = types_.real(), .function = "Thread.sleep"});
      hir::Expr* factor =
          make<hir::RealExpr>(hir::ExprKind::kReal, types_.real(), stmt.span, 1000.0);
      hir::Expr* seconds =
          folded(make<hir::BinaryExpr>(hir::ExprKind::kBinary, types_.real(), stmt.span,
                                       hir::Op::kDivR, milliseconds, factor, stmt.span));
      note_pause(stmt.span);
      return make<hir::WaitStmt>(hir::StmtKind::kWait, stmt.span, seconds);
    }
  }
  if (stmt.value->kind == ast::ExprKind::kLambda) {
    const std::uint32_t behind = stmt.span.begin + static_cast<std::uint32_t>(kFn.size());
    Diagnostic diagnostic =
        make_diagnostic("E0129", {behind, behind, stmt.span.source}, {"a name"});
    diagnostic.why = "a function without a name is a value, which would be forgotten here";
    report(std::move(diagnostic));
    syntax_failed_ = true;
    return nullptr;
  }
  hir::Expr* value = check(*stmt.value);
  if (does_nothing(*value)) {
    refuse_idle_statement(*this, stmt, *value);
    return nullptr;
  }
  if (hir::Expr* shown = shown_explanation(*this, stmt, value)) value = shown;
  return make<hir::ExprStmt>(hir::StmtKind::kExpr, stmt.span, value);
}

hir::Stmt* Checker::check_if(const ast::IfStmt& stmt) {
  hir::Expr* test = condition(*stmt.condition);
  const Flow before = here_->flow;
  const auto branch = [&](const ast::Stmt& body) {
    sink_.begin_statement();
    open_block();
    hir::Stmt* out = check_statement(body);
    close_block();
    return out;
  };
  hir::Stmt* yes = branch(*stmt.yes);
  Flow after = std::exchange(here_->flow, before);
  hir::Stmt* no = stmt.no != nullptr ? branch(*stmt.no) : nullptr;
  after.merge(here_->flow);
  here_->flow = std::move(after);
  if (yes == nullptr)
    yes = make<hir::Block>(hir::StmtKind::kBlock, stmt.yes->span, hir::Seq<hir::Stmt*>{});
  return make<hir::IfStmt>(hir::StmtKind::kIf, stmt.span, test, yes, no);
}

hir::Stmt* Checker::return_value(hir::Expr* value, Span span) {
  FunctionContext& context = *here_;
  if (context.result_is_declared) {
    value = require(value, {.role = Target::Role::kResult, .type = context.result});
  } else if (value->type->is(Kind::kVoid)) {
    value = mismatch(*value, {.type = types_.any()});
  }
  if (!context.result_is_declared) {
    hir::Expr seen{.kind = hir::ExprKind::kVariable, .type = context.result, .span = span};
    const Type* common = context.result == nullptr ? value->type : common_type(seen, *value);
    if (common == nullptr) {
      mismatch(*value, {.role = Target::Role::kResult, .type = context.result});
      common = types_.any();
    }
    context.result = common;
  }
  auto* stmt = make<hir::ReturnStmt>(hir::StmtKind::kReturn, span, value);
  context.returns.push_back(stmt);
  context.flow.reachable = false;
  return stmt;
}

hir::Stmt* Checker::check_return(const ast::ReturnStmt& stmt) {
  FunctionContext& context = *here_;
  const bool in_function = context.kind == FunctionContext::Kind::kNamed ||
                           context.kind == FunctionContext::Kind::kLambda;
  if (!in_function) return nullptr;  // refused while the tree was built
  const auto keeps = [](const JumpTarget& at) {
    return at.kind == JumpTarget::Kind::kFinally || at.kind == JumpTarget::Kind::kPath;
  };
  const auto kept = std::ranges::find_if(context.targets, keeps);
  if (kept != context.targets.end()) {
    report(cannot_leave(kept->kind, "return", stmt.span));
    return nullptr;
  }
  const bool is_void = context.result_is_declared && context.result->is(Kind::kVoid);
  const std::string name(context.function->name);
  if (stmt.value != nullptr && is_void) {
    check(*stmt.value);
    report(make_diagnostic("E0321", stmt.value->span, {name}));
    return nullptr;
  }
  if (stmt.value != nullptr) {
    const Type* wanted = context.result_is_declared ? context.result : nullptr;
    hir::Expr* value = check(*stmt.value, wanted);
    advise_on_divided_remark(*this, *stmt.value, *value, wanted);
    return return_value(value, stmt.span);
  }
  if (context.result_is_declared && !is_void && !context.result->is(Kind::kAny)) {
    report(make_diagnostic("E0322", stmt.span, {type_phrase(context.result)}));
  }
  if (!context.result_is_declared && context.result == nullptr) context.result = types_.void_type();
  context.flow.reachable = false;
  return make<hir::ReturnStmt>(hir::StmtKind::kReturn, stmt.span, nullptr);
}

hir::Stmt* Checker::check_jump(const ast::Stmt& stmt) {
  using To = JumpTarget::Kind;
  const bool is_break = stmt.kind == ast::StmtKind::kBreak;
  const bool is_retry = stmt.kind == ast::StmtKind::kRetry;
  const auto leaves = [&](const JumpTarget& target) {
    if (target.kind == To::kFinally || target.kind == To::kPath) return true;
    if (is_retry) return target.kind == To::kCatch;
    return target.kind == To::kLoop || (is_break && target.kind == To::kSwitch);
  };
  auto& targets = here_->targets;
  const auto found = std::find_if(targets.rbegin(), targets.rend(), leaves);
  if (found == targets.rend()) {
    const std::string word = is_break ? "break" : is_retry ? "retry" : "continue";
    report(make_diagnostic("E0121", stmt.span,
                           {word, is_retry   ? "`catch`"
                                  : is_break ? "a loop or a `switch`"
                                             : "a loop"}));
    return nullptr;
  }
  if (found->kind == To::kFinally || found->kind == To::kPath) {
    const std::string word = is_break ? "break" : is_retry ? "retry" : "continue";
    report(cannot_leave(found->kind, word, stmt.span));
    return nullptr;
  }
  if (is_break) found->exits.push_back(here_->flow);
  if (!is_break && !is_retry) found->repeats.push_back(here_->flow);
  here_->flow.reachable = false;
  const hir::Jump jump = is_break   ? hir::Jump::kBreak
                         : is_retry ? hir::Jump::kRetry
                                    : hir::Jump::kContinue;
  return make<hir::JumpStmt>(hir::StmtKind::kJump, stmt.span, jump, found->statement);
}

hir::Stmt* Checker::check_throw(const ast::ThrowStmt& stmt) {
  hir::Expr* value = check_value(*stmt.value);
  here_->flow.reachable = false;
  if (value->type->is(Kind::kText)) {
    Diagnostic diagnostic = make_diagnostic("E0315", value->span, {"an error", "a string"});
    const std::string written = "error(" + text_of(value->span) + ")";
    diagnostic.fix = Fix{.text = "write throw " + written,
                         .edits = {{value->span, written}},
                         .confidence = Confidence::kSure};
    report(std::move(diagnostic));
    return nullptr;
  }
  value = require(value, {.type = error_type_, .name = "throw"});
  return make<hir::ThrowStmt>(hir::StmtKind::kThrow, stmt.span, value);
}

hir::Expr* Checker::seconds(const ast::Expr& written, std::string_view what) {
  hir::Expr* value = check_value(written);
  // Classic programs count seconds in plain numbers.
  if (hir::Expr* plain = convert(value, types_.real())) return plain;
  const bool setting = what == "timeout";
  return require(value, {.role = setting ? Target::Role::kSetting : Target::Role::kVariable,
                         .type = types_.quantity(dims::kTime),
                         .name = setting ? what : std::string_view()});
}

hir::Stmt* Checker::check_wait(const ast::Expr& duration, Span span) {
  note_pause(span);
  return make<hir::WaitStmt>(hir::StmtKind::kWait, span, seconds(duration, "wait"));
}

hir::Stmt* Checker::check_wait_until(const ast::WaitUntilStmt& stmt) {
  hir::Expr* timeout = nullptr;
  for (const ast::Arg& arg : stmt.args) {
    if (arg.name.text != "timeout") {
      const Span mark = arg.name.text.empty() ? arg.span : arg.name.span;
      Diagnostic diagnostic = make_diagnostic("E0207", mark, {"wait until", text_of(mark)});
      diagnostic.why = "wait until accepts timeout";
      if (!arg.name.text.empty()) diagnostic.fix = did_you_mean(arg.name.text, mark, {"timeout"});
      report(std::move(diagnostic));
      return nullptr;
    }
    if (timeout != nullptr) report(make_diagnostic("E0212", arg.name.span, {"timeout"}));
    timeout = seconds(*arg.value, "timeout");
  }
  hir::Expr* guard = check_guard(*stmt.condition);
  note_pause(stmt.span);
  const Span span = stmt.condition->span;
  return make<hir::WaitUntilStmt>(hir::StmtKind::kWaitUntil, stmt.span, guard, timeout,
                                  into_.sources->slice(span), span);
}

hir::Stmt* Checker::check_try(const ast::TryStmt& stmt) {
  auto* out =
      make<hir::TryStmt>(hir::StmtKind::kTry, stmt.span, nullptr, nullptr, nullptr, nullptr);
  const Flow before = here_->flow;
  out->body = check_block(stmt.body->body, stmt.body->span);
  Flow after = here_->flow;
  for (std::size_t i = 0; i < stmt.catches.size(); ++i) {
    const ast::CatchClause& clause = stmt.catches[i];
    if (i > 0) {
      Diagnostic diagnostic = make_diagnostic("E0337", clause.body->span);
      diagnostic.related.push_back({stmt.catches[0].body->span, "this one takes every error"});
      diagnostic.fix = Fix{.text = "use one catch with switch (e.kind) { ... } inside it"};
      report(std::move(diagnostic));
      break;
    }
    // The body may have stopped anywhere, so nothing it stored is certain.
    here_->flow = before;
    open_block();
    if (!clause.name.text.empty() && is_free(clause.name)) {
      out->error = new_variable(clause.name.text, error_type_, clause.name.span);
      out->error->fixed = true;
      add_local(out->error, Declared::kCatch, clause.name.span);
    }
    here_->targets.push_back({JumpTarget::Kind::kCatch, out});
    out->handler = check_block(clause.body->body, clause.body->span);
    here_->targets.pop_back();
    close_block();
    after.merge(here_->flow);
  }
  here_->flow = after;
  if (stmt.finally != nullptr) {
    here_->flow = before;
    here_->targets.push_back({JumpTarget::Kind::kFinally, out});
    out->finally = check_block(stmt.finally->body, stmt.finally->span);
    here_->targets.pop_back();
    // What finally stores is stored on every way on.
    after.add_values_of(here_->flow);
    after.reachable = after.reachable && here_->flow.reachable;
    here_->flow = std::move(after);
  }
  return out;
}

}  // namespace armlet::lang
