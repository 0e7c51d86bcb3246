#pragma once
// The state of one function while its body is checked: the visible variables, those that have a
// value, and the statements that can be left.

#include <string_view>
#include <unordered_map>
#include <vector>

#include "check/scopes/declared.hpp"
#include "check/scopes/variable_set.hpp"
#include "hir/hir.hpp"
#include "hir/kept.hpp"

namespace armlet::lang {

// A visible variable.
struct Local {
  hir::Variable* variable = nullptr;
  Declared how = Declared::kVar;
  Span keyword{};  // let, var, final, or the type of a classic declaration
  bool used = false;
};

// The state of the control flow at a point of the text: whether the point can be reached, and the
// variables that have no value there on at least one path.
struct Flow {
  bool reachable = true;
  VariableSet unset{};

  // The state where two paths meet.
  void merge(const Flow& other);
  // Adds the values that were assigned by code which has run as well.
  void add_values_of(const Flow& other);
  void assign(const hir::Variable* variable) { unset.erase(variable); }
  [[nodiscard]] bool is_unset(const hir::Variable* variable) const;
};

// The state where many paths meet. Merges pairs, then pairs of pairs, so that similar sets are
// merged first.
[[nodiscard]] Flow merged(std::vector<Flow> ways);

// A statement that break, continue or retry can leave; kFinally and kPath mark statements that no
// jump may leave.
struct JumpTarget {
  enum class Kind : std::uint8_t { kLoop, kSwitch, kCatch, kFinally, kPath } kind;
  const hir::Stmt* statement;
  std::vector<Flow> exits{};    // the states at each break
  std::vector<Flow> repeats{};  // the states at each continue
};

// The ambient value of a `with` block: the resource of calls inside that omit it.
struct WithAmbient {
  const HostType* type = nullptr;
  Local local;
};

// One function, lambda, condition or test while its body is checked.
struct FunctionContext {
  enum class Kind : std::uint8_t {
    kProgram,
    kNamed,
    kTest,
    kLambda,
    kCondition,
    kTask
  } kind = Kind::kProgram;
  bool in_row = false;  // kLambda: of a row, which is evaluated repeatedly
  hir::Function* function = nullptr;
  FunctionContext* outer = nullptr;     // lambdas and conditions: the function around
  FunctionDecl* declaration = nullptr;  // kNamed
  Instance* instance = nullptr;         // kNamed
  std::vector<Local> locals{};          // all visible ones, the innermost last
  std::unordered_map<std::string_view, std::size_t> places{};  // indices in locals, by name
  std::vector<std::size_t> ambient_places{};  // indices of the locals with ambient values
  std::vector<std::size_t> blocks{};    // indices in locals of the first one of each open block
  std::vector<WithAmbient> ambients{};  // the innermost last
  std::vector<hir::Capture> captures{};
  std::unordered_map<const hir::Variable*, hir::Variable*>
      inner_of{};  // of captures: the inner variable, by outer one
  std::vector<JumpTarget> targets{};
  Flow flow{};
  int tries = 0;                 // count of open `try` bodies
  const Type* result = nullptr;  // declared, or of the first return; null: none so far
  bool result_is_declared = false;
  std::vector<hir::ReturnStmt*> returns{};  // whose result is inferred

  // The visible variable with that name; null if there is none.
  [[nodiscard]] Local* find(std::string_view name);
  void add(Local local);
  // Removes the locals from `first` on.
  void drop(std::size_t first);
  [[nodiscard]] const FunctionContext& root() const;
};

}  // namespace armlet::lang
