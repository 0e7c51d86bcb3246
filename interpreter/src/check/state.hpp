#pragma once
// What is known while a program is checked: its names, its functions, and what was left for later.

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "check/calls/call.hpp"
#include "check/check.hpp"
#include "check/names/scope.hpp"
#include "types/signature.hpp"

namespace armlet::lang {

struct Checker;

// A function of the program handed to one of the library, which calls it.
struct Callback {
  std::string_view called_by;
  const hir::Function* function;
  Span span;
};

// A `path`, to be looked at when all functions are known.
struct PathBlock {
  const hir::Block* body;
  Span head;  // where it begins
};

// A default value that was needed once.
struct Default {
  hir::Expr* value = nullptr;
  hir::Function* function = nullptr;  // gives the value; null: it is so small that it is repeated
  Use use{};                          // what the value mentions
  bool is_open = false;               // being checked
};

// Names of block declarations of one type.
struct DeclaredNames {
  std::vector<std::string> in_order;
  std::unordered_set<std::string> all;
};

// What the files of one program have in common.
struct SharedState {
  std::vector<Checker*> files{};  // imported ones before those that import them
  int depth = 0;                  // of nested checks, bodies of called functions included
  std::deque<Instance> instances{};
  std::vector<Instance*> queue{};  // bodies that can wait
  std::map<const RecordInfo*, StructDecl> structs{};
  std::map<const Type*, Checker*> homes{};  // of struct and enum types: the file that declares them
  std::map<std::string, DeclaredNames> declared_names{};  // block declarations by type
  std::unordered_map<const NativeFunction*, std::unique_ptr<Signature>> signatures{};
  std::unordered_map<const hir::Function*, Use> uses{};
  std::vector<hir::Function*> all_functions{};
  std::vector<hir::Test> tests{};
  std::vector<hir::Variable*> inner_globals{};  // of blocks of the top level, used by conditions
  std::vector<std::pair<const hir::Function*, std::size_t>>
      main_calls{};  // with the top-level variables declared then
  std::vector<std::pair<const hir::Function*, Span>> conditions{};
  std::vector<Callback> callbacks{};
  std::vector<PathBlock> paths{};
  std::vector<std::pair<hir::Variable*, hir::InitStmt*>> top_level{};  // in their order
  std::unordered_map<const hir::Variable*, Use> init_uses{};
  std::set<std::string> mentioned{};
  std::map<std::string, Span> later{};  // what the program uses and nothing stands behind yet
  std::set<const Type*> unset{};        // of elements that begin without a value
  const Type* error_type = nullptr;
  // By record or enum with many names: where each stands.
  std::unordered_map<const void*, std::unordered_map<std::string_view, int>> places{};
  // By enum with many values: the functions that give the names of values, and all values.
  std::unordered_map<const EnumInfo*, hir::Function*> enum_names{};
  std::unordered_map<const EnumInfo*, hir::Function*> enum_values{};
  std::unordered_map<const ast::Expr*, Default> defaults{};
  // Functions that may wait or move, through others too; known when all have been checked.
  std::optional<std::unordered_set<const hir::Function*>> pausing{};
  std::size_t defaults_taken = 0;                                                 // by all calls
  std::unordered_map<const hir::Variable*, std::optional<Constant>> constants{};  // of variables
};

// What is known of one file.
struct CheckerState {
  CheckerState(const FileTree& file, SharedState& shared, CompiledProgram& into,
               const Registry& registry, const CompileOptions& options, DiagnosticSink& sink)
      : file_(file),
        program_(file.program),
        shared_(shared),
        into_(into),
        registry_(registry),
        options_(options),
        sink_(sink),
        arena_(*into.arena),
        types_(*into.types),
        syntax_failed_(!file.ok) {}

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

  // Whether an error, or advice, would be kept now: what is dear to say need not be made otherwise.
  [[nodiscard]] bool takes_errors() const { return !sink_.statement_failed() && !sink_.full(); }
  [[nodiscard]] bool takes_advice() const {
    return static_cast<int>(sink_.all().size()) < options_.limits.errors;
  }

  const FileTree& file_;
  const ast::Block& program_;
  SharedState& shared_;
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
  std::string likely_type_ = "double";  // of a lambda's parameter without a type
  std::vector<Joined> joined_;          // around the expression that is checked
  bool syntax_failed_ = false;          // statements are missing, so unknown names prove nothing
  std::set<std::string, std::less<>> told_;  // unknown names; each is told of once
  std::map<std::string_view, Import> imports_;
  std::map<std::string_view, FunctionDecl> functions_;
  std::map<std::string_view, const Type*> named_types_;
  std::map<std::string_view, Span> type_names_;  // where they are declared
  std::map<std::string_view, Span> top_level_names_;
  std::set<std::string_view> changed_names_;  // that some statement of the text changes
  std::map<std::string_view, std::vector<std::string_view>>
      ambient_names_;   // top-level ambient values by type
  Use* use_ = nullptr;  // what is being collected now
  std::vector<const ast::TestStmt*> waiting_tests_;
  std::vector<std::pair<Span, Use>> active_statements_;  // of an imported file's top level

  int& depth_ = shared_.depth;
  std::deque<Instance>& instances_ = shared_.instances;
  std::vector<Instance*>& queue_ = shared_.queue;
  std::map<const RecordInfo*, StructDecl>& structs_ = shared_.structs;
  std::map<std::string, DeclaredNames>& declared_names_ = shared_.declared_names;
  std::unordered_map<const NativeFunction*, std::unique_ptr<Signature>>& signatures_ =
      shared_.signatures;
  std::unordered_map<const hir::Function*, Use>& uses_ = shared_.uses;
  std::vector<hir::Function*>& all_functions_ = shared_.all_functions;
  std::vector<hir::Test>& tests_ = shared_.tests;
  std::vector<hir::Variable*>& inner_globals_ = shared_.inner_globals;
  std::vector<std::pair<const hir::Function*, std::size_t>>& main_calls_ = shared_.main_calls;
  std::vector<std::pair<const hir::Function*, Span>>& conditions_ = shared_.conditions;
  std::vector<Callback>& callbacks_ = shared_.callbacks;
  std::vector<std::pair<hir::Variable*, hir::InitStmt*>>& top_level_ = shared_.top_level;
  std::unordered_map<const hir::Variable*, Use>& init_uses_ = shared_.init_uses;
  std::set<std::string>& mentioned_ = shared_.mentioned;
  std::map<std::string, Span>& later_ = shared_.later;
  const Type*& error_type_ = shared_.error_type;
};

}  // namespace armlet::lang
