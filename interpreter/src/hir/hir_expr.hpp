#pragma once
// The variables and expressions of a checked program; hir.hpp has the statements.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"
#include "base/text_style.hpp"

namespace armlet::lang::hir {

template <class T>
using Seq = std::span<T>;

struct Expr;
struct Stmt;
struct Block;
struct Function;

// ---- variables

// How a variable is stored. Each is kLocal until the checker sees a use in another function.
enum class Storage : std::uint8_t {
  kLocal,   // a register of its function
  kGlobal,  // at the top level, used by a function, test, condition or task: has a number
  kBoxed,   // a local shared by reference with a condition or task inside its function: a register
            // holding a box
};

struct Variable {
  std::string_view name;
  const Type* type = nullptr;
  Span declared;
  Function* owner = nullptr;
  Variable* outer = nullptr;  // of a captured variable: the variable of the enclosing function
  Storage storage = Storage::kLocal;
  bool fixed = false;  // let, final, parameters, loop variables
  bool is_parameter = false;
  // A parameter whose list the function takes over, so that callers need not copy it.
  bool adopted = false;
  // A global that may be read before it has a value: reads are checked (R0623).
  bool maybe_unset = false;
  bool is_open = false;        // the host finds it by name, and may change a `var` between slices
  const Expr* init = nullptr;  // the initialiser, for messages
  std::string_view kind{};     // Fact::kind of its first value
  std::uint32_t index = 0;     // of a global: its number
};

// A variable of an enclosing function that is used inside a lambda (copied) or inside a condition
// or task (shared: both variables are boxed).
struct Capture {
  Variable* outer;
  Variable* inner;
};

struct Function {
  std::string_view name;  // "slot", "lambda on line 3", "" for the program itself
  Span span;
  Seq<Variable*> parameters;
  Seq<Capture> captures;
  const Type* result = nullptr;  // void type if none
  Block* body = nullptr;
  std::uint32_t index = 0;         // in the program's functions
  bool is_condition = false;       // a condition of until, wait until or when: it may not pause
  bool gives_fixed_value = false;  // a default value, the same at every call
  bool is_task = false;  // a block of parallel, when or every: `name` is the name of the task
};

// ---- expressions
enum class ExprKind : std::uint8_t {
#define ARMLET_STMT(...)
#define ARMLET_EXPR(kind, ...) kind,
#include "hir/hir_nodes.def"
#undef ARMLET_EXPR
#undef ARMLET_STMT
};

enum class Op : std::uint8_t {
  kAddI,
  kSubI,
  kMulI,
  kDivI,
  kModI,
  kPowI,
  kNegI,  // overflow and division by zero fail
  kAddR,
  kSubR,
  kMulR,
  kDivR,
  kModR,
  kPowR,
  kNegR,
  kLtI,
  kLeI,
  kGtI,
  kGeI,
  kEqI,
  kNeI,  // kEqI, kNeI also for bool and enum
  kLtR,
  kLeR,
  kGtR,
  kGeR,
  kEqR,
  kNeR,
  kNot,
  kEqText,
  kNeText,
  kLtText,
  kLeText,
  kGtText,
  kGeText,
  kEqDeep,
  kNeDeep,  // lists, records, host values, by Type
};

enum class Conversion : std::uint8_t {
  kSame,  // the bits stay, the type changes (angle to double, 0 to a quantity)
  kIntToReal,
  kRealToInt,  // toward zero; fails when not finite or too large
  kListIntToReal,
  kMatrixToRows,  // the rows as lists
};

struct Expr {
  ExprKind kind;
  const Type* type;
  Span span;
  const Constant* constant = nullptr;  // the value, if the text alone gives it
  const Fact* fact = nullptr;          // owned by the program

  template <class T>
  [[nodiscard]] const T& as() const {
    return static_cast<const T&>(*this);
  }
};

struct BoolExpr : Expr {
  bool value;
};
struct IntExpr : Expr {
  std::int64_t value;
};  // also kEnum: the ordinal
struct RealExpr : Expr {
  double value;
};
struct TextExpr : Expr {
  std::string_view value;
};
struct AbsentExpr : Expr {};  // an optional argument that is absent; `type` decides how
struct VariableExpr : Expr {
  Variable* variable;
};
struct UnaryExpr : Expr {
  Op op;
  Expr* operand;
};
struct BinaryExpr : Expr {  // kBinary, kAnd, kOr
  Op op;                    // unused for kAnd and kOr
  Expr* left;
  Expr* right;
  Span op_span;
};
struct CondExpr : Expr {
  Expr* condition;
  Expr* yes;
  Expr* no;
};
struct ConvertExpr : Expr {
  Conversion conversion;
  Expr* operand;
};
struct ListExpr : Expr {
  Seq<Expr*> items;
};
struct NewArrayExpr : Expr {
  Seq<Expr*> sizes;
};  // elements zero, false, "", empty lists, or not set (has_zero); type: the whole list
struct RecordExpr : Expr {
  Seq<Expr*> fields;
};  // all of them, in order
struct FieldExpr : Expr {
  Expr* object;
  std::uint32_t field;
};
struct ElementExpr : Expr {  // list[i], matrix[i, j]
  Expr* object;
  Expr* index;
  Expr* column;  // null for lists
};
struct SliceExpr : Expr {  // list[a:b]; text[a:b] too
  Expr* object;
  Expr* first;  // null: from the start
  Expr* last;   // null: to the end
};
struct LengthExpr : Expr {
  Expr* object;
};                             // list or text
struct CharacterExpr : Expr {  // text[i]
  Expr* object;
  Expr* index;
};
// The parts of a call that a message marks when the call fails: the whole call, the name, and the
// argument of each parameter (an empty span if it is not in the text).
struct CallSite {
  Span call;
  Span callee;
  Seq<Span> arguments;
};
struct CallExpr : Expr {
  Function* function;
  Seq<Expr*> arguments;
  CallSite site;
};
struct CallValueExpr : Expr {
  Expr* function;
  Seq<Expr*> arguments;
  CallSite site;
};
struct CallNativeExpr : Expr {
  const NativeFunction* function;
  Seq<Expr*> arguments;  // one per parameter
  CallSite site;
};
struct FunctionValueExpr : Expr {
  Function* function;
};
struct ClosureExpr : Expr {
  Function* function;
};  // captures are read here
struct ConcatExpr : Expr {
  Seq<Expr*> parts;
};                          // all of them texts
struct ToTextExpr : Expr {  // any value as print shows it, or in a format
  Expr* value;
  TextStyle style;
  std::string_view unit;  // shown after the number; empty: chosen by size
  double factor;          // SI value of one such unit (when unit is given)
};
struct ErrorExpr : Expr {  // error("text", kind: "word") -> the library's error record
  Expr* message;
  Expr* kind_text;  // null: no kind
};

struct GuardedExpr : Expr {  // motion until condition
  Expr* motion;              // a CallNativeExpr that pauses
  Expr* condition;           // a ClosureExpr or FunctionValueExpr without parameters -> bool
};

}  // namespace armlet::lang::hir
