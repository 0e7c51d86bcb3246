#pragma once
// What is known while a program is checked: its names, its functions, and what was left for later.

#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "check/check.hpp"
#include "check/scope.hpp"
#include "types/signature.hpp"

namespace armlet::lang {

struct CheckerState {
  CheckerState(const ast::Block& program, CompiledProgram& into, const Registry& registry,
               const CompileOptions& options, DiagnosticSink& sink)
      : program_(program),
        into_(into),
        registry_(registry),
        options_(options),
        sink_(sink),
        arena_(*into.arena),
        types_(*into.types),
        syntax_failed_(sink.has_errors()) {}

  template <class T, class... Rest>
  T* make(hir::ExprKind kind, const Type* type, Span span, Rest&&... rest) {
    return arena_.make<T>(hir::Expr{.kind = kind, .type = type, .span = span},
                          std::forward<Rest>(rest)...);
  }
  template <class T, class... Rest>
  T* make(hir::StmtKind kind, Span span, Rest&&... rest) {
    return arena_.make<T>(hir::Stmt{.kind = kind, .span = span}, std::forward<Rest>(rest)...);
  }
  template <class T>
  hir::Seq<T> seq(const std::vector<T>& items) {
    return arena_.copy(items);
  }

  const ast::Block& program_;
  CompiledProgram& into_;
  const Registry& registry_;
  const CompileOptions& options_;
  DiagnosticSink& sink_;
  Arena& arena_;
  TypePool& types_;

  FunctionContext main_;
  FunctionContext* here_ = &main_;
  bool only_top_level_ = false;  // while a default value is checked
  bool classic_declaration_ = false;
  struct {
    std::string_view name;
    Span value;
  } naming_;  // the declaration whose first value is being checked
  int errors_ = 0;
  bool syntax_failed_ = false;  // statements are missing, so unknown names prove nothing
  std::set<std::string, std::less<>> told_;  // unknown names; each is told of once
  int depth_ = 0;  // of nested checks, bodies of called functions included
  std::deque<Instance> instances_;
  std::vector<Instance*> queue_;  // bodies that can wait
  std::map<std::string_view, FunctionDecl> functions_;
  std::map<std::string_view, const Type*> named_types_;
  std::map<const RecordInfo*, StructDecl> structs_;
  std::map<std::string_view, Span> top_level_names_;
  std::set<std::string_view> changed_names_;  // that some statement of the text changes
  std::map<std::string, std::vector<std::string>> declared_names_;  // block declarations by type
  std::map<std::string_view, std::vector<std::string_view>>
      ambient_names_;  // top-level robots by type
  std::unordered_map<const NativeFunction*, std::unique_ptr<Signature>> signatures_;
  std::unordered_map<const hir::Function*, Use> uses_;
  Use* use_ = nullptr;  // what is being collected now
  std::vector<hir::Function*> all_functions_;
  std::vector<hir::Test> tests_;
  std::vector<const ast::TestStmt*> waiting_tests_;
  std::vector<hir::Variable*> inner_globals_;  // of blocks of the top level, used by conditions
  std::vector<std::pair<const hir::Function*, std::size_t>>
      main_calls_;  // with the top-level variables declared then
  std::vector<std::pair<const hir::Function*, Span>> conditions_;
  std::vector<std::pair<hir::Variable*, hir::InitStmt*>> top_level_;  // in their order
  std::unordered_map<const hir::Variable*, Use> init_uses_;
  std::set<std::string> mentioned_;
  std::map<std::string, Span> later_;  // what the program uses and nothing stands behind yet
  const Type* error_type_ = nullptr;
};

}  // namespace armlet::lang
