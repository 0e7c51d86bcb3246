#pragma once
// The checked program: every name resolved, every type known, every conversion written out.
//
// The checker makes this tree from the syntax tree; the compiler turns it into bytecode. Overloads, named and default
// arguments, x.f(a), units, ambient robots and block declarations are gone. One function of the text that is generic
// by use appears here once for each combination of argument types. Nodes live in the program's arena and are read-only
// after checking; they stay alive with the program, because messages at run time point back to what was written.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet::lang::hir {

template <class T>
using Seq = std::span<T>;

struct Expr;
struct Stmt;
struct Block;
struct Function;

// ---- variables ------------------------------------------------------------------------------------------------

// Where a variable lives. The checker starts with kLocal and raises it when it sees a use from elsewhere.
enum class Storage : std::uint8_t {
  kLocal,    // a register of its function
  kGlobal,   // a top-level variable that a function, test or condition uses: numbered in the program's globals
  kBoxed,    // a local shared by reference with a condition or task inside its function: a register holding a box
};

struct Variable {
  std::string_view name;
  const Type* type = nullptr;
  Span declared;
  Function* owner = nullptr;
  Storage storage = Storage::kLocal;
  bool fixed = false;              // let, final, parameters, loop variables
  bool is_parameter = false;
  bool maybe_unset = false;        // a global that may be read before its initialiser ran: reads are checked (R0623)
  const Expr* init = nullptr;      // the initialiser, for messages
  std::uint32_t index = 0;         // the compiler's: register or global number
};

// A variable of an enclosing function used inside a lambda (by copy) or a condition (by reference: both boxed).
struct Capture {
  Variable* outer;
  Variable* inner;
};

struct Function {
  std::string_view name;           // "slot", "lambda on line 3", "" for the program itself
  Span span;
  Seq<Variable*> parameters;
  Seq<Capture> captures;
  const Type* result = nullptr;    // void type if none
  Block* body = nullptr;
  std::uint32_t index = 0;         // in the program's functions
  bool is_condition = false;       // the condition of until, wait until, when: may not pause
};

// ---- expressions ----------------------------------------------------------------------------------------------

enum class ExprKind : std::uint8_t {
  kBool, kInt, kReal, kText, kEnum, kAbsent,
  kVariable, kUnary, kBinary, kAnd, kOr, kCond, kConvert,
  kList, kNewArray, kRecord, kField, kElement, kSlice, kLength, kCharacter,
  kCall, kCallValue, kCallNative, kFunctionValue, kClosure,
  kConcat, kToText, kError, kMutate, kGuarded
};

enum class Op : std::uint8_t {
  kAddI, kSubI, kMulI, kDivI, kModI, kPowI, kNegI,      // overflow and division by zero fail
  kAddR, kSubR, kMulR, kDivR, kModR, kPowR, kNegR,
  kLtI, kLeI, kGtI, kGeI, kEqI, kNeI,                   // kEqI, kNeI also for bool and enum
  kLtR, kLeR, kGtR, kGeR, kEqR, kNeR,
  kNot,
  kEqText, kNeText, kLtText, kLeText, kGtText, kGeText,
  kEqDeep, kNeDeep,                                     // lists, records, host values, by Type
};

enum class Conversion : std::uint8_t {
  kSame,          // the bits stay, the type changes (angle to double, 0 to a quantity)
  kIntToReal,
  kRealToInt,     // toward zero; fails when not finite or too large
  kListIntToReal,
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

struct BoolExpr : Expr { bool value; };
struct IntExpr : Expr { std::int64_t value; };        // also kEnum: the ordinal
struct RealExpr : Expr { double value; };
struct TextExpr : Expr { std::string_view value; };
struct AbsentExpr : Expr {};                          // an optional argument not given; type tells how it is passed
struct VariableExpr : Expr { Variable* variable; };
struct UnaryExpr : Expr {
  Op op;
  Expr* operand;
};
struct BinaryExpr : Expr {                            // kBinary, kAnd, kOr
  Op op;                                              // unused for kAnd and kOr
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
struct ListExpr : Expr { Seq<Expr*> items; };
struct NewArrayExpr : Expr { Seq<Expr*> sizes; };     // elements zero, false, "" or empty lists; type: the whole list
struct RecordExpr : Expr { Seq<Expr*> fields; };      // all of them, in order
struct FieldExpr : Expr {
  Expr* object;
  std::uint32_t field;
};
struct ElementExpr : Expr {                           // list[i]
  Expr* object;
  Expr* index;
};
struct SliceExpr : Expr {                             // list[a:b]; text[a:b] too
  Expr* object;
  Expr* first;                                        // null: from the start
  Expr* last;                                         // null: to the end
};
struct LengthExpr : Expr { Expr* object; };           // list or text
struct CharacterExpr : Expr {                         // text[i]
  Expr* object;
  Expr* index;
};
// What is marked when a call fails: the whole, the name, and each argument by parameter (empty if not written).
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
  Seq<Expr*> arguments;                               // one per parameter
  CallSite site;
};
struct FunctionValueExpr : Expr { Function* function; };
struct ClosureExpr : Expr { Function* function; };    // captures are read here
struct ConcatExpr : Expr { Seq<Expr*> parts; };       // all of them texts
struct ToTextExpr : Expr {                            // any value as print shows it, or in a format
  Expr* value;
  std::int8_t digits;                                 // -1: not given
  char style;                                         // 'f' 'e' 'g' or 0
  std::string_view unit;                              // shown after the number; empty: chosen by size
  double factor;                                      // SI value of one such unit (when unit is given)
};
struct ErrorExpr : Expr {                             // error("text", kind: "word") -> the library's error record
  Expr* message;
  Expr* kind_text;                                    // null: no kind
};

// A place that can be assigned: a variable, then fields and elements of it.
struct Step {
  bool is_field;
  std::uint32_t field;
  Expr* index;                                        // elements
  const Type* type;                                   // of the place after this step
  Span span;                                          // from the start of the place to the end of this step
};
struct Place {
  Variable* variable;
  Seq<Step> steps;
  const Type* type;
  Span span;
};
enum class Mutation : std::uint8_t { kPush, kPop, kInsert, kRemoveAt };
struct MutateExpr : Expr {                            // xs.push(x): void; xs.pop(), xs.removeAt(i): the element
  Mutation mutation;
  Place place;
  Expr* index;                                        // insert, removeAt
  Expr* value;                                        // push, insert
};
struct GuardedExpr : Expr {                           // motion until condition
  Expr* motion;                                       // a CallNativeExpr that pauses
  Expr* condition;                                    // a ClosureExpr or FunctionValueExpr without parameters -> bool
};

// ---- statements -----------------------------------------------------------------------------------------------

enum class StmtKind : std::uint8_t {
  kBlock, kInit, kAssign, kExpr, kIf, kLoop, kRange, kForList, kSwitch, kTry, kThrow, kJump, kReturn, kWait,
  kWaitUntil, kAssert, kAssertThrows
};

struct Stmt {
  StmtKind kind;
  Span span;

  template <class T>
  [[nodiscard]] const T& as() const {
    return static_cast<const T&>(*this);
  }
};

struct Block : Stmt { Seq<Stmt*> body; };
struct InitStmt : Stmt {
  Variable* variable;
  Expr* value;                     // null: no first value; boxes are made, references stay null
};
struct AssignStmt : Stmt {
  Place place;
  Expr* value;
  bool compound;                   // place = place op value, the place evaluated once
  Op op;                           // for numbers; text and lists are written out by the checker as kConcat or natives
  Span op_span;
};
struct ExprStmt : Stmt { Expr* value; };   // the value is dropped
struct IfStmt : Stmt {
  Expr* condition;
  Stmt* yes;
  Stmt* no;                        // null: none
};
struct LoopStmt : Stmt {           // while, do, for(;;)
  Expr* condition;                 // null: for ever
  Stmt* body;
  Stmt* step;                      // null: none; `continue` goes here
  bool test_first;
};
// for (i in range(a, b, s)): the bounds are evaluated once. The hidden counter tells messages the pass.
struct RangeStmt : Stmt {
  Variable* variable;
  Expr* first;
  Expr* last;
  Expr* step;                      // null: 1
  Stmt* body;
};
struct ForListStmt : Stmt {
  Variable* variable;
  Expr* items;                     // a list
  Stmt* body;
};
struct SwitchCase {
  Seq<Expr*> tests;                // bool expressions over `subject`; empty for default
  bool is_default;
  Block* body;
};
struct SwitchStmt : Stmt {
  Variable* subject;               // hidden
  Expr* value;
  Seq<SwitchCase> cases;           // default may stand anywhere; it is taken last
};
struct TryStmt : Stmt {
  Block* body;
  Variable* error;                 // null: catch without a name, or no catch
  Block* handler;                  // null: no catch
  Block* finally;                  // null: none
};
struct ThrowStmt : Stmt { Expr* value; };   // the library's error record
enum class Jump : std::uint8_t { kBreak, kContinue, kRetry };
struct JumpStmt : Stmt {
  Jump jump;
  const Stmt* target;              // the loop, switch or try
};
struct ReturnStmt : Stmt { Expr* value; };  // null: none
struct WaitStmt : Stmt { Expr* duration; };             // seconds, a double
struct WaitUntilStmt : Stmt {
  Expr* condition;                 // a closure or function without parameters -> bool
  Expr* timeout;                   // seconds; null: none
  std::string_view condition_text; // as written
  Span condition_span;
};
// assert(c, note): the parts of c are evaluated once into hidden variables, so that they can be shown.
struct AssertPart {
  std::string_view text;           // as written
  Variable* variable;
};
struct AssertStmt : Stmt {
  Seq<InitStmt*> parts_init;       // executed in order before the condition
  Expr* condition;
  Expr* note;                      // a text or null
  Seq<AssertPart> shown;           // values worth showing (not literals)
  Expr* explain;                   // text expression saying why, evaluated on failure only; null: none
  std::string_view text;           // of the condition, as written
  Span condition_span;
};
// assertThrows(fn() => ..., kind: "..."): runs the call; fails if nothing was thrown, or another kind.
struct AssertThrowsStmt : Stmt {
  Expr* call;                      // an expression statement to run
  Expr* kind_text;                 // null: any
  Span call_span;
};

// ---- the whole ------------------------------------------------------------------------------------------------

// The body begins with the initialisers of the top-level variables that the test needs.
struct Test {
  std::string_view name;
  Function* function;
  Span span;
};

struct Module {
  Function* main = nullptr;              // the top level, in order; imports' initialisers first
  Seq<Function*> functions;              // all, main included, numbered by index
  Seq<Test> tests;
  std::uint32_t global_count = 0;
  Seq<Variable*> globals;                // numbered by index
};

}  // namespace armlet::lang::hir
