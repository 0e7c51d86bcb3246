#pragma once
// The checked program: every name resolved, every type known, every conversion written out.
//
// The checker makes this tree from the syntax tree; the compiler makes bytecode of it. Overloads,
// named and default arguments, x.f(a), units, ambient values and block declarations are gone. A
// function without declared parameter types appears here once for each combination of argument
// types. Nodes live in the program's arena and are read-only after checking; they stay alive with
// the program, because messages at run time refer to the text.

#include <cstdint>
#include <string_view>

#include "hir/hir_expr.hpp"
#include "hir/hir_map.hpp"
#include "hir/hir_matrix.hpp"
#include "hir/hir_over_list.hpp"
#include "hir/hir_place.hpp"

namespace armlet::lang::hir {

// ---- statements

enum class StmtKind : std::uint8_t {
#define ARMLET_EXPR(...)
#define ARMLET_STMT(kind, ...) kind,
#include "hir/hir_nodes.def"
#undef ARMLET_STMT
#undef ARMLET_EXPR
};

struct Stmt {
  StmtKind kind;
  Span span;

  template <class T>
  [[nodiscard]] const T& as() const {
    return static_cast<const T&>(*this);
  }
};

struct Block : Stmt {
  Seq<Stmt*> body;
};
struct InitStmt : Stmt {
  Variable* variable;
  Expr* value;  // null: no first value; boxes are made, references stay null
};
struct AssignStmt : Stmt {
  Place place;
  Expr* value;
  bool compound;  // target = target op value, the target evaluated once
  Op op;  // for numbers; the checker writes text and list operations as kConcat or native calls
  Span op_span;
  bool changes_part = false;  // the value is the old one with a changed part: img[x, y] = 3
};
struct StorePartStmt : Stmt {  // xs[a:b] = value, A[a:b, j] = value
  Place place;                 // the list or matrix
  PartEnds rows;
  PartEnds cols;  // unused for lists
  Expr* value;    // a list or matrix of the size of the part
};
struct ExprStmt : Stmt {
  Expr* value;
};  // the value is discarded
struct IfStmt : Stmt {
  Expr* condition;
  Stmt* yes;
  Stmt* no;  // null: none
};
struct LoopStmt : Stmt {  // while, do, for(;;)
  Expr* condition;        // null: for ever
  Stmt* body;
  Stmt* step;  // null: none; `continue` goes here
  bool test_first;
};
// for (i in range(a, b, s)): the bounds are evaluated once. A hidden counter gives messages the
// number of the iteration.
struct RangeStmt : Stmt {
  Variable* variable;
  Expr* first;
  Expr* last;
  Expr* step;  // null: 1
  Stmt* body;
};
struct ForListStmt : Stmt {
  Variable* variable;
  Expr* items;  // a list
  Stmt* body;
};
struct SwitchCase {
  Seq<Expr*> tests;  // bool expressions over `subject`; empty for default
  bool is_default;
  Block* body;
};
struct SwitchStmt : Stmt {
  Variable* subject;  // hidden
  Expr* value;
  Seq<SwitchCase> cases;  // default may be at any position; it is taken last
};
struct TryStmt : Stmt {
  Block* body;
  Variable* error;  // null: catch without a name, or no catch
  Block* handler;   // null: no catch
  Block* finally;   // null: none
};
struct ThrowStmt : Stmt {
  Expr* value;
};  // the library's error record
enum class Jump : std::uint8_t { kBreak, kContinue, kRetry };
struct JumpStmt : Stmt {
  Jump jump;
  const Stmt* target;  // the loop, switch or try
};
struct ReturnStmt : Stmt {
  Expr* value;
};  // null: none
struct WaitStmt : Stmt {
  Expr* duration;
};  // seconds, a double
struct WaitUntilStmt : Stmt {
  Expr* condition;                  // a closure or function without parameters -> bool
  Expr* timeout;                    // seconds; null: none
  std::string_view condition_text;  // as written
  Span condition_span;
};
// parallel { ... }: the blocks run as concurrent tasks. Each is a function without parameters: a
// closure or a function value.
struct ParallelStmt : Stmt {
  Seq<Expr*> branches;
  Span word;  // `parallel`
};
// when (c) { ... }: the body runs as a task each time the condition changes from false to true,
// until the block around the statement ends.
struct WhenStmt : Stmt {
  Expr* condition;  // like that of `wait until`
  Expr* body;
  Span head;  // `when (c)`
};
struct EveryStmt : Stmt {
  Expr* period;  // seconds
  Expr* body;
  Span head;
};
// A part of the condition of assert(c, note). Parts are evaluated once into hidden variables, so
// that a failure can show their values.
struct AssertPart {
  std::string_view text;  // as written
  Variable* variable;
};
struct AssertStmt : Stmt {
  Seq<InitStmt*> parts_init;  // executed in order before the condition
  Expr* condition;
  Expr* note;             // a text or null
  Seq<AssertPart> shown;  // values that a failure shows (not literals)
  Expr* explain;          // text of the reason, evaluated on failure only; null: none
  std::string_view text;  // of the condition, as written
  Span condition_span;
};
// assertThrows(fn() => ..., kind: "..."): runs the call, and fails if nothing was thrown or the
// error has another kind.
struct AssertThrowsStmt : Stmt {
  Expr* call;       // an expression statement to run
  Expr* kind_text;  // null: any
  Span call_span;
};

// ---- the whole

// A test block of a program. Its body begins with the initialisers of the top-level variables that
// the test uses.
struct Test {
  std::string_view name;
  Function* function;
  Span span;
};

struct Module {
  Function* main = nullptr;  // the top level, in order; initialisers of imports first
  Seq<Function*> functions;  // all, main included; in programs in the order of their numbers
  Seq<Test> tests;
  std::uint32_t global_count = 0;
  Seq<Variable*> globals;  // those that the program declares; each has its number
  Seq<const Type*> unset;  // types of elements that `new T[n]` leaves without a value
};

}  // namespace armlet::lang::hir
