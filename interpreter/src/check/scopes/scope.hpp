#pragma once
// One function while its body is checked: the variables that can be seen, which of them have a
// value, and what can be left from here.

#include <string_view>
#include <unordered_map>
#include <vector>

#include "check/scopes/declared.hpp"
#include "check/scopes/variable_set.hpp"
#include "hir/hir.hpp"
#include "hir/kept.hpp"

namespace armlet::lang {

// A variable that can be seen from here.
struct Local {
  hir::Variable* variable = nullptr;
  Declared how = Declared::kVar;
  Span keyword{};  // let, var, final, or the type of a classic declaration
  bool used = false;
};

// Whether the end of the text so far can be reached, and which variables have no value there on
// some way.
struct Flow {
  bool reachable = true;
  VariableSet unset{};

  // Where two ways meet.
  void merge(const Flow& other);
  // After what has run besides: what has a value there has one here too.
  void add_values_of(const Flow& other);
  void assign(const hir::Variable* variable) { unset.erase(variable); }
  [[nodiscard]] bool is_unset(const hir::Variable* variable) const;
};

// Where many ways meet. In pairs, then pairs of pairs, so that sets that are much alike meet first.
[[nodiscard]] Flow merged(std::vector<Flow> ways);

// A statement that break, continue or retry can leave; kFinally and kPath: one that nothing can
// leave.
struct JumpTarget {
  enum class Kind : std::uint8_t { kLoop, kSwitch, kCatch, kFinally, kPath } kind;
  const hir::Stmt* statement;
  std::vector<Flow> exits{};    // the states at each break
  std::vector<Flow> repeats{};  // the states at each continue
};

// A value that calls inside a `with` block mean when they leave it out: its resource.
struct WithAmbient {
  const HostType* type = nullptr;
  Local local;
};

// One function, lambda, condition or test while its body is being checked.
struct FunctionContext {
  enum class Kind : std::uint8_t {
    kProgram,
    kNamed,
    kTest,
    kLambda,
    kCondition,
    kTask
  } kind = Kind::kProgram;
  bool in_row = false;  // kLambda: of a row that is asked again and again
  hir::Function* function = nullptr;
  FunctionContext* outer = nullptr;     // lambdas and conditions: where they are written
  FunctionDecl* declaration = nullptr;  // kNamed
  Instance* instance = nullptr;         // kNamed
  std::vector<Local> locals{};          // all that can be seen, innermost last
  std::unordered_map<std::string_view, std::size_t> places{};  // of names in locals
  std::vector<std::size_t> ambient_places{};  // of the locals that calls can leave out
  std::vector<std::size_t> blocks{};          // where each open block begins in locals
  std::vector<WithAmbient> ambients{};        // innermost last
  std::vector<hir::Capture> captures{};
  std::unordered_map<const hir::Variable*, hir::Variable*>
      inner_of{};  // what captures has, by outer
  std::vector<JumpTarget> targets{};
  Flow flow{};
  int tries = 0;                 // bodies of `try` that are open
  const Type* result = nullptr;  // declared, or of the first return; null: none so far
  bool result_is_declared = false;
  std::vector<hir::ReturnStmt*> returns{};  // of an inferred result

  // The variable of that name; null if none can be seen here.
  [[nodiscard]] Local* find(std::string_view name);
  void add(Local local);
  // Forgets the locals from `first` on.
  void drop(std::size_t first);
  [[nodiscard]] const FunctionContext& root() const;
};

}  // namespace armlet::lang
