#include "check/blocks/named_rows.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "check/blocks/block_declarations.hpp"
#include "check/calls/calls.hpp"
#include "check/explain/file_names.hpp"
#include "check/library/native_calls.hpp"
#include "check/names/variables.hpp"
#include "check/state/learnt.hpp"

namespace armlet::lang {

bool may_have_named_rows(Checker& checker, const ast::ObjectStmt& stmt) {
  const std::string type = checker.text_of(stmt.type->span);
  if (!checker.scopes.at_top_level()) {
    checker.report(make_diagnostic("E0132", stmt.type->span, {"a `" + type + "` block"}));
    return false;
  }
  if (!is_main_file(checker)) {
    Diagnostic diagnostic = make_diagnostic("E0224", stmt.type->span, {type});
    diagnostic.why = "this file is imported; the block belongs in the file that is run";
    checker.report(std::move(diagnostic));
    return false;
  }
  for (const Local& local : checker.scopes.main().locals) {
    const Type* other = local.variable->type;
    if (local.how != Declared::kBlock || !other->is(Kind::kHost) || other->host->name != type ||
        local.variable->declared.source != stmt.span.source)
      continue;
    Diagnostic diagnostic = make_diagnostic("E0224", stmt.type->span, {type});
    diagnostic.related.push_back({local.variable->declared, "the first one"});
    diagnostic.fix = Fix{.text = "put the rows of both into one block"};
    checker.report(std::move(diagnostic));
    return false;
  }
  return true;
}

namespace {

bool is_lambda(const ast::Arg& arg) { return arg.value->kind == ast::ExprKind::kLambda; }

// The contents of a row: the argument `value` of the function that was called, or a function among
// its arguments; null if there is neither.
hir::Expr** value_of(Checker& checker, hir::CallNativeExpr& call) {
  const int at = checker.shared.signatures.of(*call.function).index_of("value");
  if (at >= 0) {
    hir::Expr*& value = call.arguments[static_cast<std::size_t>(at)];
    return value->kind == hir::ExprKind::kAbsent ? nullptr : &value;
  }
  const auto found = std::ranges::find_if(
      call.arguments, [](const hir::Expr* each) { return each->type->is(Kind::kFunction); });
  return found == call.arguments.end() || (*found)->kind == hir::ExprKind::kAbsent ? nullptr
                                                                                   : &*found;
}

class NamedRows {
 public:
  NamedRows(Checker& checker, const ast::ObjectStmt& stmt, std::vector<hir::Stmt*>& out)
      : checker_(checker), stmt_(stmt), out_(out), rows_(stmt.items.size(), nullptr) {}

  std::vector<Argument> run() {
    // The lambdas of all rows can use the variables of all rows.
    check_all(
        [](const ast::BlockItem& item) { return !std::ranges::any_of(item.args, is_lambda); });
    check_all([](const ast::BlockItem& item) { return std::ranges::any_of(item.args, is_lambda); });
    std::vector<hir::Expr*> given;
    for (hir::Expr* row : rows_)
      if (row != nullptr) given.push_back(row);
    const auto bad =
        std::ranges::find_if(given, [](const hir::Expr* row) { return row->type->is(Kind::kAny); });
    if (given.empty()) return {};
    hir::Expr* list =
        bad != given.end()
            ? *bad
            : checker_.make<hir::ListExpr>(
                  hir::ExprKind::kList, checker_.types.list(given[0]->type),
                  cover(given.front()->span, given.back()->span), checker_.seq(given));
    return {Argument{.name = "rows", .name_span = stmt_.name.span, .value = list}};
  }

 private:
  template <class F>
  void check_all(F is_meant) {
    for (std::size_t i = 0; i < stmt_.items.size(); ++i) {
      const ast::BlockItem& item = stmt_.items[i];
      if (item.is_row && is_meant(item)) rows_[i] = check(item);
    }
  }

  hir::Expr* check(const ast::BlockItem& item) {
    checker_.messages.begin_statement();
    const std::string part = checker_.text_of(stmt_.type->span) + '.' + std::string(item.name.text);
    const auto makers = checker_.registry.functions(part + std::string(kNamedRow));
    if (makers.empty()) return unknown_row(checker_, stmt_, item);
    const std::string_view dotted = checker_.arena.copy(std::string(stmt_.name.text) + '.' +
                                                        std::string(item.constructor.text));
    FunctionContext* where = nullptr;
    if (const Local* other = checker_.scopes.find(dotted, where)) {
      Diagnostic diagnostic =
          make_diagnostic("E0225", item.constructor.span, {std::string(item.constructor.text)});
      diagnostic.related.push_back({other->variable->declared, "first declared here"});
      diagnostic.fix = Fix{.text = "choose another name"};
      checker_.report(std::move(diagnostic));
      return checker_.failed(item.span);
    }
    Use used;
    Use& use_before = checker_.scopes.collect_in(used);
    const bool in_row = checker_.surroundings.set_in_row(true);
    std::vector<Argument> arguments = arguments_of(checker_, item.args, makers[0]->name);
    arguments.push_back({.name = "name",
                         .name_span = item.constructor.span,
                         .value = checker_.make<hir::TextExpr>(
                             hir::ExprKind::kText, checker_.types.text(), item.constructor.span,
                             checker_.arena.copy(item.constructor.text))});
    hir::Expr* row = call_native(checker_, item.name.text, makers, item.name.span, item.span,
                                 std::move(arguments));
    checker_.surroundings.set_in_row(in_row);
    checker_.scopes.collect_in(use_before);
    use_before.add(used);
    declare(item, dotted, row, std::move(used));
    return row;
  }

  // A row without a value is declared too, so that no other row can have its name.
  void declare(const ast::BlockItem& item, std::string_view dotted, hir::Expr* row, Use used) {
    hir::Expr** value =
        row->kind == hir::ExprKind::kCallNative
            ? value_of(checker_, const_cast<hir::CallNativeExpr&>(row->as<hir::CallNativeExpr>()))
            : nullptr;
    const Type* type = value != nullptr ? (*value)->type : checker_.types.any();
    hir::Variable* variable = new_variable(checker_, dotted, type, item.constructor.span);
    checker_.scopes.add(variable, Declared::kBlock, item.name.span)->used = true;
    if (value == nullptr) return;
    variable->storage = hir::Storage::kGlobal;
    variable->is_open = true;
    auto* init = checker_.make<hir::InitStmt>(hir::StmtKind::kInit, item.span, variable, *value);
    checker_.shared.top_level.add(variable, init, std::move(used));
    out_.push_back(init);
    *value =
        checker_.make<hir::VariableExpr>(hir::ExprKind::kVariable, type, (*value)->span, variable);
  }

  Checker& checker_;
  const ast::ObjectStmt& stmt_;
  std::vector<hir::Stmt*>& out_;
  std::vector<hir::Expr*> rows_;  // by item
};

}  // namespace

std::vector<Argument> named_rows(Checker& checker, const ast::ObjectStmt& stmt,
                                 std::vector<hir::Stmt*>& out) {
  return NamedRows(checker, stmt, out).run();
}

}  // namespace armlet::lang
