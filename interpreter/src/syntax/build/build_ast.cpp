#include "syntax/build/build_ast.hpp"

#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

Diagnostic out_of_place(Span span, const std::string& word, const std::string& home,
                        const char* task) {
  Diagnostic out = make_diagnostic("E0121", span, {word, home});
  if (task != nullptr)
    out.why = std::string("the block of `") + task + "` runs as a task of its own";
  return out;
}

}  // namespace

ast::Stmt* AstBuilder::statement(RbtParser::StmtContext* ctx) {
  if (ctx->start == ctx->stop && ctx->start->getType() == RbtParser::SEMI) return nullptr;
  in_.sink.begin_statement();
  const Deeper deeper(*this, 1, span_of(ctx));
  // The kind of the statement is read from the number of its rule: asking for every kind in turn
  // would be a search for each.
  auto* rule = static_cast<antlr4::RuleContext*>(ctx->children.front());
  switch (rule->getRuleIndex()) {
    case RbtParser::RuleClosedStmt:
      return closed(static_cast<RbtParser::ClosedStmtContext*>(rule));
    case RbtParser::RuleBlock:
      return plain_block(static_cast<RbtParser::BlockContext*>(rule));
    case RbtParser::RuleIfStmt:
      return if_stmt(static_cast<RbtParser::IfStmtContext*>(rule));
    case RbtParser::RuleWhileStmt:
      return while_stmt(static_cast<RbtParser::WhileStmtContext*>(rule));
    case RbtParser::RuleDoStmt:
      return do_stmt(static_cast<RbtParser::DoStmtContext*>(rule));
    case RbtParser::RuleForStmt:
      return for_stmt(static_cast<RbtParser::ForStmtContext*>(rule));
    case RbtParser::RuleSwitchStmt:
      return switch_stmt(static_cast<RbtParser::SwitchStmtContext*>(rule));
    case RbtParser::RuleTryStmt:
      return try_stmt(static_cast<RbtParser::TryStmtContext*>(rule));
    case RbtParser::RuleRecordStmt:
      return record_stmt(static_cast<RbtParser::RecordStmtContext*>(rule));
    case RbtParser::RuleParallelStmt:
    case RbtParser::RuleWhenStmt:
    case RbtParser::RuleEveryStmt:
      return task_block(ctx);
    case RbtParser::RuleWithStmt:
    case RbtParser::RulePathStmt:
      return setting_block(ctx);
    case RbtParser::RuleLetDecl:
      return let_decl(static_cast<RbtParser::LetDeclContext*>(rule));
    case RbtParser::RuleVarDecl:
      return var_decl(static_cast<RbtParser::VarDeclContext*>(rule));
    case RbtParser::RuleBlockDecl:
      return block_decl(static_cast<RbtParser::BlockDeclContext*>(rule));
  }
  return top_declaration(ctx);
}

ast::Stmt* AstBuilder::plain_block(RbtParser::BlockContext* ctx) {
  Place inside = place_;
  inside.at_top = false;
  return body_block(ctx, inside);
}

ast::Seq<ast::Stmt*> AstBuilder::statements(const std::vector<RbtParser::StmtContext*>& list) {
  std::vector<ast::Stmt*> out;
  out.reserve(list.size());
  for (RbtParser::StmtContext* ctx : list) {
    if (ast::Stmt* made = statement(ctx)) out.push_back(made);
  }
  return in_.arena.copy(out);
}

ast::Block* AstBuilder::block(RbtParser::BlockContext* ctx) {
  auto* out = fresh<ast::Block>(ast::StmtKind::kBlock, span_of(ctx));
  out->body = statements(ctx->stmt());
  return out;
}

ast::Block* AstBuilder::body_block(RbtParser::BlockContext* ctx, const Place& place) {
  const Inside inside(*this, place);
  return block(ctx);
}

ast::Block* AstBuilder::function_block(RbtParser::BlockContext* ctx) {
  return body_block(ctx, {.at_top = false, .in_function = true});
}

// The body of a loop, which may be empty.
ast::Stmt* AstBuilder::body(RbtParser::StmtContext* ctx) {
  Place inside = place_;
  inside.at_top = false;
  inside.in_loop = true;
  const Inside scope(*this, inside);
  if (ast::Stmt* made = statement(ctx)) return made;
  return fresh<ast::EmptyStmt>(ast::StmtKind::kEmpty, span_of(ctx));
}

ast::Stmt* AstBuilder::closed(RbtParser::ClosedStmtContext* ctx) {
  switch (ctx->start->getType()) {
    case RbtParser::WAIT:
      return wait(ctx->waitStmt());
    case RbtParser::THROW: {
      auto* out = fresh<ast::ThrowStmt>(ast::StmtKind::kThrow, span_of(ctx));
      out->value = expression(ctx->expression());
      return out;
    }
    case RbtParser::BREAK:
    case RbtParser::CONTINUE:
    case RbtParser::RETRY:
    case RbtParser::RETURN:
      return jump(ctx);
  }
  return expr_stmt(static_cast<RbtParser::ExprStmtContext*>(ctx->children.front()));
}

ast::Stmt* AstBuilder::jump(RbtParser::ClosedStmtContext* ctx) {
  const Span word = token_span(ctx->start);
  const auto refuse_unless = [&](bool fits, const char* home) {
    if (!fits) report(out_of_place(word, std::string(text(word)), home, place_.task));
  };
  switch (ctx->start->getType()) {
    case RbtParser::BREAK:
      refuse_unless(place_.in_loop || place_.in_switch, "a loop or a `switch`");
      return fresh<ast::JumpStmt>(ast::StmtKind::kBreak, word);
    case RbtParser::CONTINUE:
      refuse_unless(place_.in_loop, "a loop");
      return fresh<ast::JumpStmt>(ast::StmtKind::kContinue, word);
    case RbtParser::RETRY:
      refuse_unless(place_.in_catch, "a `catch` block");
      return fresh<ast::JumpStmt>(ast::StmtKind::kRetry, word);
  }
  refuse_unless(place_.in_function, "a function");
  auto* out = fresh<ast::ReturnStmt>(ast::StmtKind::kReturn, span_of(ctx));
  if (ctx->expression() != nullptr) {
    out->value = expression(ctx->expression());
  } else {
    check_lone_return(ctx);
  }
  return out;
}

// Advice W0705: `return` alone on its line, and a value on the next.
void AstBuilder::check_lone_return(const antlr4::ParserRuleContext* ctx) {
  // Only if the next line belongs to the same block: after `if (done) return` the next line is
  // executed.
  const auto* around = static_cast<antlr4::RuleContext*>(ctx->parent->parent);
  const bool in_sequence =
      ctx->parent->parent != nullptr && around->getRuleIndex() == RbtParser::RuleBlock;
  const std::size_t end = ctx->stop->getTokenIndex();
  if (!in_sequence || !in_.tokens[end].inserted || end + 1 >= in_.tokens.size()) return;
  const Token& next = in_.tokens[end + 1];
  const bool is_value = is_literal(next.type) || is_name(next.type) || next.type == RbtParser::NEW;
  if (!next.line_break_before || !is_value) return;
  Diagnostic out = make_diagnostic("W0705", {next.begin, next.end, in_.source.id()});
  out.severity = Severity::kAdvice;
  out.related.push_back({token_span(ctx->start), ""});
  const Span gap{token_span(ctx->start).end, next.begin, in_.source.id()};
  out.fix = Fix{"write the value on the line of `return`", {}, Confidence::kMaybe};
  if (in_.source.slice(gap).find_first_not_of(" \t\r\n") == std::string_view::npos)
    out.fix->edits.push_back({gap, " "});
  report(std::move(out));
}

ast::Stmt* AstBuilder::expr_stmt(RbtParser::ExprStmtContext* ctx) {
  if (ctx->children.size() == 1) {
    auto* out = fresh<ast::ExprStmt>(ast::StmtKind::kExpr, span_of(ctx));
    out->value = expression(static_cast<RbtParser::ExpressionContext*>(ctx->children.front()));
    return out;
  }
  if (ctx->INC() == nullptr && ctx->DEC() == nullptr) return assignment(ctx);
  auto* out = fresh<ast::StepStmt>(ast::StmtKind::kStep, span_of(ctx));
  out->target = ctx->expr() != nullptr ? expr(ctx->expr()) : expression(ctx->expression(0));
  out->up = ctx->INC() != nullptr;
  check_target(out->target);
  return out;
}

ast::Stmt* AstBuilder::assignment(RbtParser::ExprStmtContext* ctx) {
  auto* out = fresh<ast::AssignStmt>(ast::StmtKind::kAssign, span_of(ctx));
  std::vector<ast::Expr*> values = {expression(ctx->expression(0))};
  if (RbtParser::CompoundOpContext* op = ctx->compoundOp()) {
    out->compound = true;
    out->op = *mark_of(op->start->getType()).operation;
    out->op_span = token_span(op->start);
    values.push_back(expression(ctx->expression(1)));
  } else {
    RbtParser::AssignTailContext* tail = ctx->assignTail();
    out->op_span = token_span(tail->start);
    for (RbtParser::ExpressionContext* value : tail->expression())
      values.push_back(expression(value));
    if (tail->braceInit() != nullptr) values.push_back(brace_init(tail->braceInit()));
  }
  out->value = values.back();
  values.pop_back();
  for (const ast::Expr* target : values) check_target(target);
  out->targets = in_.arena.copy(values);
  return out;
}

void AstBuilder::check_target(const ast::Expr* target) {
  const bool is_place = target->kind == ast::ExprKind::kName ||
                        target->kind == ast::ExprKind::kIndex ||
                        target->kind == ast::ExprKind::kMember;
  if (is_place && target->parens == 0) return;
  Span span = target->span;
  if (is_place) {  // the span with its parentheses
    span.begin -= text({span.begin - 1, span.begin, span.source}) == "(" ? 1 : 0;
  }
  report(make_diagnostic("E0328", span));
}

ast::Stmt* AstBuilder::wait(RbtParser::WaitStmtContext* ctx) {
  if (ctx->UNTIL() == nullptr) {
    auto* out = fresh<ast::WaitStmt>(ast::StmtKind::kWait, span_of(ctx));
    out->duration = expression(ctx->expression());
    return out;
  }
  auto* out = fresh<ast::WaitUntilStmt>(ast::StmtKind::kWaitUntil, span_of(ctx));
  out->condition = expr(ctx->expr());
  out->args = args(ctx->arg());
  return out;
}

ast::Stmt* AstBuilder::if_body(RbtParser::IfBodyContext* ctx) {
  Place inside = place_;
  inside.at_top = false;
  if (ctx->block() != nullptr) return body_block(ctx->block(), inside);
  const Inside scope(*this, inside);
  return closed(ctx->closedStmt());
}

ast::Stmt* AstBuilder::if_stmt(RbtParser::IfStmtContext* ctx) {
  const Deeper deeper(*this, 1, span_of(ctx));
  auto* out = fresh<ast::IfStmt>(ast::StmtKind::kIf, span_of(ctx));
  out->condition = expression(ctx->expression());
  out->yes = if_body(ctx->ifBody(0));
  if (ctx->ifStmt() != nullptr) {
    out->no = if_stmt(ctx->ifStmt());
  } else if (ctx->ELSE() != nullptr) {
    out->no = if_body(ctx->ifBody(1));
  }
  return out;
}

ast::Stmt* AstBuilder::while_stmt(RbtParser::WhileStmtContext* ctx) {
  auto* out = fresh<ast::WhileStmt>(ast::StmtKind::kWhile, span_of(ctx));
  out->condition = expression(ctx->expression());
  out->body = body(ctx->stmt());
  return out;
}

ast::Stmt* AstBuilder::do_stmt(RbtParser::DoStmtContext* ctx) {
  auto* out = fresh<ast::DoStmt>(ast::StmtKind::kDo, span_of(ctx));
  Place inside = place_;
  inside.at_top = false;
  inside.in_loop = true;
  out->body = body_block(ctx->block(), inside);
  out->condition = expression(ctx->expression());
  return out;
}

ast::Stmt* AstBuilder::for_stmt(RbtParser::ForStmtContext* ctx) {
  RbtParser::ForHeaderContext* header = ctx->forHeader();
  const std::vector<RbtParser::NameContext*> names = header->name();
  if (names.empty()) return counted_for(ctx);
  auto* out = fresh<ast::ForInStmt>(ast::StmtKind::kForIn, span_of(ctx));
  out->name = name(names.back());
  if (names.size() == 2) out->index = name(names.front());
  if (header->type() != nullptr) out->type = type(header->type());
  out->items = expression(header->expression());
  out->body = body(ctx->stmt());
  return out;
}

ast::Stmt* AstBuilder::counted_for(RbtParser::ForStmtContext* ctx) {
  RbtParser::ForHeaderContext* header = ctx->forHeader();
  auto* out = fresh<ast::ForStmt>(ast::StmtKind::kFor, span_of(ctx));
  std::vector<ast::Stmt*> first;
  if (RbtParser::ForInitContext* init = header->forInit()) {
    if (init->varDecl() != nullptr) first.push_back(var_decl(init->varDecl()));
    if (init->letDecl() != nullptr) first.push_back(let_decl(init->letDecl()));
    for (RbtParser::ExprStmtContext* one : init->exprStmt()) first.push_back(expr_stmt(one));
  }
  std::vector<ast::Stmt*> step;
  if (RbtParser::ForUpdateContext* update = header->forUpdate()) {
    for (RbtParser::ExprStmtContext* one : update->exprStmt()) step.push_back(expr_stmt(one));
  }
  out->init = in_.arena.copy(first);
  out->step = in_.arena.copy(step);
  if (header->expression() != nullptr) out->condition = expression(header->expression());
  out->body = body(ctx->stmt());
  return out;
}

ast::Stmt* AstBuilder::switch_stmt(RbtParser::SwitchStmtContext* ctx) {
  auto* out = fresh<ast::SwitchStmt>(ast::StmtKind::kSwitch, span_of(ctx));
  out->header = cover(token_span(ctx->start), token_span(ctx->LBRACE()->getSymbol()));
  out->value = expression(ctx->expression());
  Place inside = place_;
  inside.at_top = false;
  inside.in_switch = true;
  const Inside scope(*this, inside);
  std::vector<ast::SwitchCase> cases;
  for (RbtParser::SwitchCaseContext* one : ctx->switchCase()) {
    ast::SwitchCase made{};
    made.is_default = one->DEFAULT() != nullptr;
    made.span = cover(token_span(one->start), token_span(one->COLON()->getSymbol()));
    made.values = expressions(one);
    made.body = statements(one->stmt());
    cases.push_back(made);
  }
  out->cases = in_.arena.copy(cases);
  return out;
}

ast::Stmt* AstBuilder::try_stmt(RbtParser::TryStmtContext* ctx) {
  auto* out = fresh<ast::TryStmt>(ast::StmtKind::kTry, span_of(ctx));
  Place inside = place_;
  inside.at_top = false;
  out->body = body_block(ctx->block(0), inside);
  if (ctx->FINALLY() != nullptr) out->finally = body_block(ctx->block(1), inside);
  inside.in_catch = true;
  std::vector<ast::CatchClause> catches;
  for (RbtParser::CatchClauseContext* one : ctx->catchClause()) {
    ast::CatchClause made{};
    if (RbtParser::ParamContext* error = one->param()) {
      made.name = name(error->name());
      made.head = span_of(error);
      const antlr4::ParserRuleContext* type = error->type();
      if (error->anyType() != nullptr) type = error->anyType();
      if (type != nullptr) made.type = {text(span_of(type)), span_of(type)};
    }
    made.body = body_block(one->block(), inside);
    catches.push_back(made);
  }
  out->catches = in_.arena.copy(catches);
  return out;
}

// parallel, when and every: their blocks run as tasks, which no jump may leave.
ast::Stmt* AstBuilder::task_block(RbtParser::StmtContext* ctx) {
  const Span span = span_of(ctx);
  if (RbtParser::ParallelStmtContext* parallel = ctx->parallelStmt()) {
    auto* out = fresh<ast::ParallelStmt>(ast::StmtKind::kParallel, span);
    out->body = body_block(parallel->block(), {.at_top = false, .task = "parallel"});
    return out;
  }
  if (RbtParser::WhenStmtContext* when = ctx->whenStmt()) {
    auto* out = fresh<ast::WhenStmt>(ast::StmtKind::kWhen, span);
    out->condition = expression(when->expression());
    out->body = body_block(when->block(), {.at_top = false, .task = "when"});
    return out;
  }
  auto* out = fresh<ast::EveryStmt>(ast::StmtKind::kEvery, span);
  out->period = expression(ctx->everyStmt()->expression());
  out->body = body_block(ctx->everyStmt()->block(), {.at_top = false, .task = "every"});
  return out;
}

ast::Stmt* AstBuilder::setting_block(RbtParser::StmtContext* ctx) {
  Place inside = place_;
  inside.at_top = false;
  if (RbtParser::WithStmtContext* with = ctx->withStmt()) {
    auto* out = fresh<ast::WithStmt>(ast::StmtKind::kWith, span_of(ctx));
    out->settings = args(with->args());
    out->body = body_block(with->block(), inside);
    return out;
  }
  auto* out = fresh<ast::PathStmt>(ast::StmtKind::kPath, span_of(ctx));
  out->settings = args(ctx->pathStmt()->args());
  out->body = body_block(ctx->pathStmt()->block(), inside);
  return out;
}

ast::Stmt* AstBuilder::record_stmt(RbtParser::RecordStmtContext* ctx) {
  auto* out = fresh<ast::RecordStmt>(ast::StmtKind::kRecord, span_of(ctx));
  out->name = name(ctx->name());
  out->period = expression(ctx->expression());
  out->items = block_items(ctx->blockItem());
  return out;
}

}  // namespace armlet::lang
