#pragma once
// The syntax tree of a program: plain structs in an arena. Every node has its span in the text.
//
// Nothing here is checked beyond the grammar: names are text, types are type expressions. The
// checker reads this tree and builds the typed one (hir/hir.hpp); it never writes to it, so that
// one function body can be checked several times.

#include <cstdint>
#include <string_view>

#include "ast/ast_expr.hpp"

namespace armlet::lang::ast {

// ---- statements

enum class StmtKind : std::uint8_t {
#define ARMLET_EXPR(...)
#define ARMLET_STMT(kind, ...) kind,
#include "ast/ast_nodes.def"
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
struct EmptyStmt : Stmt {};

// One variable of a declaration: let x = e; var x: T = e; double a = 1, b[] = {..}; final int n =
// 3;
struct Declarator {
  Name name;
  TypeExpr* type;  // with the brackets of `double x[]` already applied; null: inferred
  Expr* init;      // null: none
};
struct VarStmt : Stmt {
  bool fixed;    // let or final
  bool classic;  // Type name = ...
  Span keyword;  // let, var or final; the type in the classic form
  Seq<Declarator> declarators;
  std::string_view doc;  // text of the /// lines above, or empty
};

// One line of a block declaration such as: motor left { phase wound(...); tool: ... }
struct BlockItem {
  bool is_row;
  Name name;         // field name, or the row's first word (phase)
  Name constructor;  // rows: the second word (revolute)
  Expr* value;       // fields
  Seq<Arg> args;     // rows
  Span span;
};
struct ObjectStmt : Stmt {
  TypeExpr* type;
  Name name;
  Seq<BlockItem> items;
  std::string_view doc;
};

struct FunctionStmt : Stmt {
  Name name;
  Seq<Param> params;
  TypeExpr* result;  // null: inferred; form kVoid: returns nothing
  Block* body;       // exactly one of body and value is set
  Expr* value;
  bool classic;
  std::string_view doc;
};
struct StructStmt : Stmt {
  Name name;
  Seq<Param> fields;
  std::string_view doc;
};
struct EnumStmt : Stmt {
  Name name;
  Seq<Name> values;
  std::string_view doc;
};
struct ImportStmt : Stmt {
  std::string_view path;  // text of the string, or the dotted name
  bool is_file;           // a string
  Span path_span;
  Name alias;  // text empty: none
};
struct TestStmt : Stmt {
  std::string_view name;
  Span name_span;
  Block* body;
};

struct IfStmt : Stmt {
  Expr* condition;
  Stmt* yes;
  Stmt* no;  // null: none; an IfStmt for else if
};
struct WhileStmt : Stmt {
  Expr* condition;
  Stmt* body;
};
struct DoStmt : Stmt {
  Block* body;
  Expr* condition;
};
struct ForInStmt : Stmt {  // for (x in xs), for (i, x in xs), for (double x : xs)
  Name index;              // text empty: none
  Name name;
  TypeExpr* type;  // null: inferred
  Expr* items;
  Stmt* body;
};
struct ForStmt : Stmt {
  Seq<Stmt*> init;
  Expr* condition;  // null: for ever
  Seq<Stmt*> step;
  Stmt* body;
};
struct SwitchCase {
  Seq<Expr*> values;  // empty for default
  bool is_default;
  Seq<Stmt*> body;
  Span span;  // `case ... :` without the body
};
struct SwitchStmt : Stmt {
  Expr* value;
  Seq<SwitchCase> cases;
  Span header;  // switch (...) {
};
struct CatchClause {
  Name name;  // text empty: catch without a name
  Name type;  // as it is written; empty: none
  Span head;  // between the parentheses
  Block* body;
};
struct TryStmt : Stmt {
  Block* body;
  Seq<CatchClause> catches;
  Block* finally;  // null: none
};

struct ParallelStmt : Stmt {
  Block* body;
};
struct WhenStmt : Stmt {
  Expr* condition;
  Block* body;
};
struct EveryStmt : Stmt {
  Expr* period;
  Block* body;
};
struct WithStmt : Stmt {
  Seq<Arg> settings;
  Block* body;
};
struct PathStmt : Stmt {
  Seq<Arg> settings;
  Block* body;
};
struct RecordStmt : Stmt {
  Name name;
  Expr* period;
  Seq<BlockItem> items;
};

struct ExprStmt : Stmt {
  Expr* value;
};
// a = b = e; a += e. Targets from left to right; op is kAdd ... only when compound.
struct AssignStmt : Stmt {
  Seq<Expr*> targets;
  Expr* value;
  bool compound;
  BinaryOp op;
  Span op_span;
};
struct StepStmt : Stmt {  // i++, --i
  Expr* target;
  bool up;
};
struct WaitStmt : Stmt {
  Expr* duration;
};  // wait(2s) and wait 2s
struct WaitUntilStmt : Stmt {
  Expr* condition;
  Seq<Arg> args;
};
struct JumpStmt : Stmt {};  // kBreak kContinue kRetry
struct ReturnStmt : Stmt {
  Expr* value;
};  // null: none
struct ThrowStmt : Stmt {
  Expr* value;
};

// The path that an import names: import tools.grip means the file tools/grip.rbt.
[[nodiscard]] std::string path_of(const ImportStmt& stmt);

}  // namespace armlet::lang::ast
