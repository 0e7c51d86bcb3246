// record run every (10ms) { q: ... }: a table whose columns are sampled until the enclosing block
// ends.
//
// The sampled values become a function that returns one row. The rest of the block becomes a try
// whose finally block takes the last sample.

#include "check/statements/recordings.hpp"

#include <algorithm>
#include <string>
#include <unordered_set>

#include "check/calls/tables.hpp"
#include "check/explain/pauses.hpp"
#include "check/functions/lambdas.hpp"
#include "check/names/reading.hpp"
#include "check/names/variables.hpp"

namespace armlet::lang {
namespace {

// The function that returns one row; null after a message.
hir::Expr* check_sample(Checker& checker, const ast::RecordStmt& stmt) {
  FunctionContext context;
  context.kind = FunctionContext::Kind::kCondition;
  context.outer = &checker.scopes.here();
  context.function = checker.shared.instances.make_function(
      std::string(kSampleName) + std::to_string(checker.line_of(stmt.span)), stmt.span);
  context.function->is_condition = true;
  const Scopes::Position outside =
      checker.scopes.enter(context, checker.shared.uses.of(context.function));
  checker.scopes.open_block();
  const Type* time = checker.types.quantity(dims::kTime);
  std::vector<RecordField> columns{{.name = "t", .type = time}};
  std::vector<hir::Expr*> values{
      checker.make<hir::RealExpr>(hir::ExprKind::kReal, time, stmt.name.span, 0.0)};
  bool well = true;
  std::unordered_set<std::string> names = {"t", "length"};
  for (const ast::BlockItem& item : stmt.items) {
    checker.messages.begin_statement();
    const std::string name(item.name.text);
    const bool taken = !item.is_row && !names.insert(name).second;
    if (item.is_row || taken) {
      Diagnostic diagnostic = item.is_row ? make_diagnostic("E0516", item.span, {name})
                                          : make_diagnostic("E0212", item.name.span, {name});
      if (name == "t") diagnostic.why = "every table has a column t, the time of its samples";
      if (name == "length") diagnostic.why = "the length of a table is the number of its rows";
      checker.report(std::move(diagnostic));
      well = false;
      continue;
    }
    hir::Expr* value = checker.check_value(*item.value);
    if (value->type->is(Kind::kAny)) well = false;
    columns.push_back({.name = name, .type = value->type});
    values.push_back(value);
  }
  if (well) {
    const Type* row = checker.types.table(columns)->record->row;
    hir::Expr* record =
        checker.make<hir::RecordExpr>(hir::ExprKind::kRecord, row, stmt.span, checker.seq(values));
    hir::Stmt* result = checker.make<hir::ReturnStmt>(hir::StmtKind::kReturn, stmt.span, record);
    context.function->result = row;
    context.function->body = checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span,
                                                      checker.seq(std::vector<hir::Stmt*>{result}));
  }
  close_block(checker);
  checker.scopes.come_back(outside);
  if (!well) return nullptr;
  checker.shared.postponed.add(Postponed::Condition{context.function, stmt.span});
  return closure(checker, context.function, context,
                 checker.types.function({}, context.function->result), stmt.name.span);
}

}  // namespace

void check_record(Checker& checker, const ast::RecordStmt& stmt, ast::Seq<ast::Stmt*> rest,
                  std::vector<hir::Stmt*>& out) {
  const bool top_level = checker.scopes.at_top_level();
  Use used;
  Use& use_before = checker.scopes.use();
  if (top_level) checker.scopes.collect_in(used);
  hir::Expr* period = checker.check_as(*stmt.period, {.role = Target::Role::kSetting,
                                                      .type = checker.types.quantity(dims::kTime),
                                                      .name = "every",
                                                      .function = "record",
                                                      .call = stmt.name.span});
  hir::Expr* sample = check_sample(checker, stmt);
  checker.scopes.collect_in(use_before);
  const bool well = sample != nullptr && !period->type->is(Kind::kAny);
  const Type* type = well ? sample->type->result->record->table : checker.types.any();
  hir::Variable* run = new_variable(checker, stmt.name.text, type, stmt.name.span);
  run->fixed = true;
  if (is_free(checker, stmt.name)) checker.scopes.add(run, Declared::kBlock, stmt.name.span);
  if (!well) return checker.check_into(rest, out);
  hir::Expr* table = builtin(checker, *checker.registry.language().start_recording, type,
                             stmt.name.span, {sample, period});
  run->init = table;
  auto* init = checker.make<hir::InitStmt>(hir::StmtKind::kInit, stmt.name.span, run, table);
  if (top_level) {
    checker.shared.top_level.add(run, init, std::move(used));
  }
  out.push_back(init);
  std::vector<hir::Stmt*> body;
  checker.check_into(rest, body);
  hir::Expr* read =
      checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, type, stmt.name.span, run);
  hir::Expr* end = builtin(checker, *checker.registry.language().end_recording,
                           checker.types.void_type(), stmt.name.span, {read});
  const auto block = [&](const std::vector<hir::Stmt*>& statements) {
    return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(statements));
  };
  out.push_back(checker.make<hir::TryStmt>(
      hir::StmtKind::kTry, stmt.span, block(body), nullptr, nullptr,
      block({checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, stmt.name.span, end)})));
}

hir::Stmt* check_lone_record(Checker& checker, const ast::RecordStmt& stmt) {
  std::vector<hir::Stmt*> out;
  checker.scopes.open_block();
  check_record(checker, stmt, {}, out);
  close_block(checker);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(out));
}

}  // namespace armlet::lang
