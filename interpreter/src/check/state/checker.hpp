#pragma once
// The checker of one file: a pass from the syntax tree to the typed tree.
//
// The state is in small classes, each with its own rules. The rules of the language are functions
// in the neighbouring folders that take a Checker. Functions that call each other across these
// folders are declared here.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/host/compile_options.hpp"
#include "check/scopes/names.hpp"
#include "check/scopes/scopes.hpp"
#include "check/state/call.hpp"
#include "check/state/file_tree.hpp"
#include "check/state/messages.hpp"
#include "check/state/postponed.hpp"
#include "check/state/shared.hpp"
#include "check/state/suggest.hpp"
#include "check/state/surroundings.hpp"
#include "hir/checked_program.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

struct Checker {
  Checker(const FileTree& tree, Shared& program, CheckedProgram& result, const Registry& library,
          const CompileOptions& chosen, DiagnosticSink& sink)
      : file(tree),
        shared(program),
        into(result),
        registry(library),
        options(chosen),
        arena(*result.arena),
        types(*result.types),
        messages(sink, scopes, chosen.limits.errors, !tree.ok) {}

  // ---- expressions; what failed has the type `any`
  hir::Expr* check(const ast::Expr& expr, const Type* expected = nullptr);
  hir::Expr* check_value(const ast::Expr& expr, const Type* expected = nullptr);  // not void
  hir::Expr* check_as(const ast::Expr& expr, const Target& target);
  hir::Expr* condition(const ast::Expr& expr);
  // Converts the value to `type`; null if none of the five conversions applies.
  hir::Expr* convert(hir::Expr* value, const Type* type);
  hir::Expr* require(hir::Expr* value, const Target& target);
  const Type* resolve(const ast::TypeExpr& type);
  // What an assignment or a method changes; whole: the variable itself may get a new value. Empty
  // after a message.
  std::optional<hir::Place> check_place(const ast::Expr& expr, Span statement, bool whole);

  // ---- statements; null where nothing is to be done
  hir::Stmt* check_statement(const ast::Stmt& stmt);
  hir::Block* check_block(ast::Seq<ast::Stmt*> body, Span span);
  void check_into(ast::Seq<ast::Stmt*> body, std::vector<hir::Stmt*>& out);

  // Adds the names of an earlier entry: they apply where this file does not declare the same name.
  void follow(const KeptFile& kept) {
    names.follow(kept, shared.earlier);
    scopes.follow(names, shared.earlier);
  }

  // ---- messages
  void report(Diagnostic diagnostic) { messages.report(std::move(diagnostic)); }
  hir::Expr* failed(Span span);
  // A value that failed, with the type that it most likely has, if types are guessed; null: none.
  hir::Expr* guessed(Span span, const Type* type);
  [[nodiscard]] std::string text_of(Span span) const;
  [[nodiscard]] int line_of(Span span) const;

  // ---- nodes
  template <class T, class... Rest>
  T* make(hir::ExprKind kind, const Type* type, Span span, Rest&&... rest) {
    return arena.make<T>(hir::Expr{.kind = kind, .type = type, .span = span},
                         std::forward<Rest>(rest)...);
  }
  template <class T, class... Rest>
  T* make(hir::StmtKind kind, Span span, Rest&&... rest) {
    return arena.make<T>(hir::Stmt{.kind = kind, .span = span}, std::forward<Rest>(rest)...);
  }
  template <class T>
  hir::Seq<T> seq(const std::vector<T>& items) {
    return arena.copy(items);
  }

  const FileTree& file;
  Shared& shared;  // shared with the other files
  CheckedProgram& into;
  const Registry& registry;
  const CompileOptions& options;
  Arena& arena;
  TypePool& types;

  Names names{};
  Scopes scopes{};
  Messages messages;
  Surroundings surroundings{};
  PostponedStatements postponed{};
  const KeptFile* kept_file = nullptr;  // for later entries
};

}  // namespace armlet::lang
