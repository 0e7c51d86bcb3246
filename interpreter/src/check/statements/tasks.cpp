#include "check/statements/tasks.hpp"

#include <algorithm>

#include "check/explain/edits.hpp"
#include "check/functions/lambdas.hpp"
#include "check/library/native_calls.hpp"
#include "check/names/variables.hpp"
#include "check/statements/statements.hpp"

namespace armlet::lang {

namespace {

// A block as a function that shares the variables around it.
hir::Function* task_function(Checker& checker, const std::string& name, ast::Seq<ast::Stmt*> body,
                             Span span, FunctionContext& context) {
  context.kind = FunctionContext::Kind::kTask;
  context.outer = &checker.scopes.here();
  context.flow = checker.scopes.here().flow;
  context.function = checker.shared.instances.make_function(name, span);
  context.function->is_task = true;
  context.function->result = checker.types.void_type();
  context.result = context.function->result;
  context.result_is_declared = true;
  const Scopes::Position outside =
      checker.scopes.enter(context, checker.shared.uses.of(context.function));
  const bool failed_before = checker.messages.statement_failed();
  checker.scopes.open_block();
  context.function->body = checker.check_block(body, span);
  close_block(checker);
  checker.messages.set_statement_failed(failed_before);
  checker.scopes.come_back(outside);
  return context.function;
}

hir::Expr* task_value(Checker& checker, FunctionContext& context) {
  return closure(checker, context.function, context,
                 checker.types.function({}, checker.types.void_type()), context.function->span);
}

std::string on_line(const Checker& checker, Span span) {
  return " on line " + std::to_string(checker.line_of(span));
}

// The first `length` letters of a statement: its keyword.
Span first_word(Span statement, std::size_t length) {
  return {statement.begin, statement.begin + static_cast<std::uint32_t>(length), statement.source};
}

// The span of `when (c)`, without the block.
Span head_of(Span statement, const ast::Block& body, const Checker& checker) {
  const std::string text = checker.text_of({statement.begin, body.span.begin, statement.source});
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  return first_word(statement, end == std::string::npos ? text.size() : end + 1);
}

bool is_declaration(const ast::Stmt& stmt) {
  using ast::StmtKind;
  return stmt.kind == StmtKind::kVar || stmt.kind == StmtKind::kObject ||
         stmt.kind == StmtKind::kRecord;
}

// The declaration is checked nevertheless, so that later statements know its names.
void refuse_declaration(Checker& checker, const ast::Stmt& stmt, Span parallel) {
  Diagnostic diagnostic = make_diagnostic("E0507", stmt.span);
  diagnostic.why =
      "each statement directly inside `parallel` is a task of its own, and its names end with it";
  diagnostic.fix = Fix{.text = "put it in front of `parallel`, or into one branch in braces",
                       .edits = moved_before(checker, stmt.span, parallel)};
  checker.report(std::move(diagnostic));
  (void)checker.check_statement(stmt);
}

// A `when` or `every` directly inside is active during the whole `parallel`; it is not a branch.
hir::Stmt* check_parallel(Checker& checker, const ast::ParallelStmt& stmt) {
  const Span word = first_word(stmt.span, std::string_view("parallel").size());
  const std::string behind = " of parallel" + on_line(checker, stmt.span);
  std::vector<hir::Expr*> branches;
  std::vector<const hir::Function*> functions;
  std::vector<hir::Stmt*> body;
  Flow after = checker.scopes.here().flow;
  checker.scopes.open_block();
  const ast::Seq<ast::Stmt*> statements = stmt.body->body;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    const ast::Stmt& one = *statements[i];
    checker.messages.begin_statement();
    if (one.kind == ast::StmtKind::kEmpty) continue;
    if (is_declaration(one)) {
      refuse_declaration(checker, one, word);
      continue;
    }
    if (one.kind == ast::StmtKind::kWhen || one.kind == ast::StmtKind::kEvery) {
      if (hir::Stmt* watch = checker.check_statement(one)) body.push_back(watch);
      continue;
    }
    const bool is_block = one.kind == ast::StmtKind::kBlock;
    FunctionContext context;
    functions.push_back(task_function(
        checker, "branch " + std::to_string(functions.size() + 1) + behind,
        is_block ? one.as<ast::Block>().body : statements.subspan(i, 1), one.span, context));
    branches.push_back(task_value(checker, context));
    // After the end of all branches, the assignments of each branch are known.
    after.add_values_of(context.flow);
  }
  close_block(checker);
  checker.scopes.here().flow = std::move(after);
  note_pause(checker, word);
  refuse_busy_resources(checker, word, functions);
  auto* parallel = checker.make<hir::ParallelStmt>(hir::StmtKind::kParallel, stmt.span,
                                                   checker.seq(branches), word);
  if (body.empty()) return parallel;
  body.push_back(parallel);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(body));
}

hir::Stmt* check_when(Checker& checker, const ast::WhenStmt& stmt) {
  hir::Expr* condition = check_guard(checker, *stmt.condition);
  FunctionContext context;
  task_function(checker, "when" + on_line(checker, stmt.span), stmt.body->body, stmt.body->span,
                context);
  note_pause(checker, stmt.span);
  return checker.make<hir::WhenStmt>(hir::StmtKind::kWhen, stmt.span, condition,
                                     task_value(checker, context),
                                     head_of(stmt.span, *stmt.body, checker));
}

hir::Stmt* check_every(Checker& checker, const ast::EveryStmt& stmt) {
  hir::Expr* period = seconds(checker, *stmt.period, "every");
  const auto known = checker.shared.constants.of(*period);
  const bool is_number =
      known && (known->kind == Constant::Kind::kReal || known->kind == Constant::Kind::kInt);
  if (is_number && !(known->real > 0.0)) {
    checker.report(make_diagnostic(
        "E0513", stmt.period->span,
        {"the time between two beats", "more than 0 s", checker.text_of(stmt.period->span)}));
  }
  FunctionContext context;
  task_function(checker, "every" + on_line(checker, stmt.span), stmt.body->body, stmt.body->span,
                context);
  note_pause(checker, stmt.span);
  return checker.make<hir::EveryStmt>(hir::StmtKind::kEvery, stmt.span, period,
                                      task_value(checker, context),
                                      head_of(stmt.span, *stmt.body, checker));
}

}  // namespace

hir::Stmt* check_tasks(Checker& checker, const ast::Stmt& stmt) {
  if (stmt.kind == ast::StmtKind::kParallel)
    return check_parallel(checker, stmt.as<ast::ParallelStmt>());
  if (stmt.kind == ast::StmtKind::kWhen) return check_when(checker, stmt.as<ast::WhenStmt>());
  return check_every(checker, stmt.as<ast::EveryStmt>());
}

}  // namespace armlet::lang
