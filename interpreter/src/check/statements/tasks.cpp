#include "check/statements/tasks.hpp"

#include <algorithm>

#include "check/explain/edits.hpp"

namespace armlet::lang {

namespace {

// One block as a function of its own that shares the variables around it.
hir::Function* task_function(Checker& checker, const std::string& name, ast::Seq<ast::Stmt*> body,
                             Span span, FunctionContext& context) {
  context.kind = FunctionContext::Kind::kTask;
  context.outer = checker.here_;
  context.flow = checker.here_->flow;
  context.function = checker.new_function(name, span);
  context.function->is_task = true;
  context.function->result = checker.types_.void_type();
  context.result = context.function->result;
  context.result_is_declared = true;
  FunctionContext* const before = std::exchange(checker.here_, &context);
  Use* const use_before = std::exchange(checker.use_, &checker.use_of(context.function));
  const bool failed_before = checker.sink_.statement_failed();
  checker.open_block();
  context.function->body = checker.check_block(body, span);
  checker.close_block();
  checker.sink_.set_statement_failed(failed_before);
  checker.here_ = before;
  checker.use_ = use_before;
  return context.function;
}

hir::Expr* task_value(Checker& checker, FunctionContext& context) {
  return checker.closure(context.function, context,
                         checker.types_.function({}, checker.types_.void_type()),
                         context.function->span);
}

std::string on_line(const Checker& checker, Span span) {
  return " on line " + std::to_string(checker.line_of(span));
}

// The first letters of a statement: the word that names it.
Span first_word(Span statement, std::size_t length) {
  return {statement.begin, statement.begin + static_cast<std::uint32_t>(length), statement.source};
}

// `when (c)`, without the block.
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

// The declaration is checked all the same, so that its names are known further down.
void refuse_declaration(Checker& checker, const ast::Stmt& stmt, Span parallel) {
  Diagnostic diagnostic = make_diagnostic("E0507", stmt.span);
  diagnostic.why =
      "each statement directly inside `parallel` is a task of its own, and its names end with it";
  diagnostic.fix = Fix{.text = "put it in front of `parallel`, or into one branch in braces",
                       .edits = moved_before(checker, stmt.span, parallel)};
  checker.report(std::move(diagnostic));
  (void)checker.check_statement(stmt);
}

// A `when` or `every` directly inside watches the whole `parallel`: it begins no branch.
hir::Stmt* check_parallel(Checker& checker, const ast::ParallelStmt& stmt) {
  const Span word = first_word(stmt.span, std::string_view("parallel").size());
  const std::string behind = " of parallel" + on_line(checker, stmt.span);
  std::vector<hir::Expr*> branches;
  std::vector<const hir::Function*> functions;
  std::vector<hir::Stmt*> body;
  Flow after = checker.here_->flow;
  checker.open_block();
  const ast::Seq<ast::Stmt*> statements = stmt.body->body;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    const ast::Stmt& one = *statements[i];
    checker.sink_.begin_statement();
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
    // What one branch has given a value has one when all have ended.
    after.add_values_of(context.flow);
  }
  checker.close_block();
  checker.here_->flow = std::move(after);
  checker.note_pause(word);
  refuse_busy_resources(checker, word, functions);
  auto* parallel = checker.make<hir::ParallelStmt>(hir::StmtKind::kParallel, stmt.span,
                                                   checker.seq(branches), word);
  if (body.empty()) return parallel;
  body.push_back(parallel);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(body));
}

hir::Stmt* check_when(Checker& checker, const ast::WhenStmt& stmt) {
  hir::Expr* condition = checker.check_guard(*stmt.condition);
  FunctionContext context;
  task_function(checker, "when" + on_line(checker, stmt.span), stmt.body->body, stmt.body->span,
                context);
  checker.note_pause(stmt.span);
  return checker.make<hir::WhenStmt>(hir::StmtKind::kWhen, stmt.span, condition,
                                     task_value(checker, context),
                                     head_of(stmt.span, *stmt.body, checker));
}

hir::Stmt* check_every(Checker& checker, const ast::EveryStmt& stmt) {
  hir::Expr* period = checker.seconds(*stmt.period, "every");
  const auto known = checker.constant_of(*period);
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
  checker.note_pause(stmt.span);
  return checker.make<hir::EveryStmt>(hir::StmtKind::kEvery, stmt.span, period,
                                      task_value(checker, context),
                                      head_of(stmt.span, *stmt.body, checker));
}

}  // namespace

const Flow& flow_for(const Checker& checker, const FunctionContext& where) {
  const FunctionContext* context = checker.here_;
  while (context != &where && context->kind != FunctionContext::Kind::kTask &&
         context->outer != nullptr) {
    context = context->outer;
  }
  return context->kind == FunctionContext::Kind::kTask ? context->flow : where.flow;
}

void note_assigned(FunctionContext& here, const hir::Variable* variable) {
  here.flow.assign(variable);
  const FunctionContext* context = &here;
  while (context->kind == FunctionContext::Kind::kTask) {
    if (variable->owner != context->function || variable->outer == nullptr) return;
    variable = variable->outer;
    here.flow.assign(variable);
    context = context->outer;
  }
}

hir::Stmt* check_tasks(Checker& checker, const ast::Stmt& stmt) {
  switch (stmt.kind) {
    case ast::StmtKind::kParallel:
      return check_parallel(checker, stmt.as<ast::ParallelStmt>());
    case ast::StmtKind::kWhen:
      return check_when(checker, stmt.as<ast::WhenStmt>());
    default:
      return check_every(checker, stmt.as<ast::EveryStmt>());
  }
}

}  // namespace armlet::lang
