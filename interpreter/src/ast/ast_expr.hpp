#pragma once
// The types and expressions of the syntax tree; ast.hpp has the statements and describes the tree.

#include <cstdint>
#include <span>
#include <string_view>

#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/unit.hpp"
#include "base/text_style.hpp"

namespace armlet::lang::ast {

struct Expr;
struct Stmt;
struct Block;
struct TypeExpr;

template <class T>
using Seq = std::span<T>;

// A name with its span.
struct Name {
  std::string_view text;
  Span span;
};

// ---- types as written

enum class TypeForm : std::uint8_t { kNamed, kPrimitive, kArray, kMap, kProduct, kFunction, kVoid };

// One factor of a dimension product: force/length^2 has factors (force, +1), (length, -2).
struct TypeFactor {
  TypeExpr* type;
  int exponent;
};

struct TypeExpr {
  TypeForm form;
  Span span;
  Seq<Name> path;     // kNamed: pal.Pallet; kPrimitive: one name as written (int long double float
                      // bool boolean)
  TypeExpr* element;  // kArray, kMap
  TypeExpr* key;      // kMap
  Seq<TypeFactor> factors;    // kProduct
  Seq<TypeExpr*> parameters;  // kFunction
  TypeExpr* result;           // kFunction
};

// ---- expressions

enum class ExprKind : std::uint8_t {
#define ARMLET_STMT(...)
#define ARMLET_EXPR(kind, ...) kind,
#include "ast/ast_nodes.def"
#undef ARMLET_EXPR
#undef ARMLET_STMT
};

enum class UnaryOp : std::uint8_t { kMinus, kPlus, kNot };

enum class BinaryOp : std::uint8_t {
  kAdd,
  kSub,
  kMul,
  kDiv,
  kMod,
  kLeftDiv,
  kElemMul,
  kElemDiv,
  kPow,
  kElemPow,
  kLess,
  kLessEq,
  kGreater,
  kGreaterEq,
  kEq,
  kNe,
  kAnd,
  kOr
};

// The text of an operator: "+", ".*", "&&" ...
[[nodiscard]] std::string_view operator_text(BinaryOp op);

struct Expr {
  ExprKind kind;
  std::uint8_t parens =
      0;  // pairs of parentheses around it in the text (saturates); span excludes them
  Span span;

  template <class T>
  [[nodiscard]] const T& as() const {
    return static_cast<const T&>(*this);
  }
};

struct IntExpr : Expr {  // 42, 0x1F
  std::int64_t value;
  bool too_large;  // does not fit 64 bits; value is 0
};
struct RealExpr : Expr {
  double value;
};
struct QuantityExpr : Expr {  // 90deg
  double si;
  Dim dim;
  double number;
  std::string_view unit;
};
struct TextExpr : Expr {
  std::string_view value;
};  // escapes already decoded
struct BoolExpr : Expr {
  bool value;
};

// The format of one piece of a formatted text: f"a {x:.1f mm} b" has one more text than pieces.
struct FormatSpec {
  TextStyle style;
  std::string_view unit;  // as written, may be empty
  Span span;              // of the text after the colon; empty if there is none
};
struct FormatPiece {
  Expr* value;
  FormatSpec format;
};
struct FormattedExpr : Expr {
  Seq<std::string_view> texts;
  Seq<FormatPiece> pieces;
};

struct NameExpr : Expr {
  std::string_view name;
};
struct MemberExpr : Expr {
  Expr* object;
  Name member;
};
// One item between [ and ]: an index, or a range first:last whose ends are optional.
struct IndexItem {
  Expr* first;
  Expr* last;
  bool is_range;
  Span span;
};
struct IndexExpr : Expr {
  Expr* object;
  Seq<IndexItem> items;
};
struct Arg {
  Name name;  // text empty: positional
  Expr* value;
  Span span;  // name and value
};
struct CallExpr : Expr {
  Expr* callee;  // a NameExpr for primitive conversions too: int(x), double(x)
  Seq<Arg> args;
  Span args_span;  // the parentheses with what is between them
};
struct UnaryExpr : Expr {
  UnaryOp op;
  Expr* operand;
};
struct BinaryExpr : Expr {
  BinaryOp op;
  Expr* left;
  Expr* right;
  Span op_span;
};
struct CondExpr : Expr {
  Expr* condition;
  Expr* yes;
  Expr* no;
};
struct CastExpr : Expr {  // (int) x
  Name type;
  Expr* operand;
};
struct ListExpr : Expr {
  Seq<Expr*> items;
};                       // [a, b]
struct MapExpr : Expr {  // ["a": 1, "b": 2], and {"a": 1, "b": 2} as an initialiser
  Seq<Expr*> keys;
  Seq<Expr*> values;  // as many
};
struct MatrixExpr : Expr {
  Seq<Seq<Expr*>> rows;
};                             // [a, b; c, d]
struct NewObjectExpr : Expr {  // new point(q)
  TypeExpr* type;
  Seq<Arg> args;
};
struct NewArrayExpr : Expr {  // new double[3][4], new double[3][], new double[] {1, 2}
  TypeExpr* element;          // double
  Seq<Expr*> sizes;
  int open_dimensions;  // number of [] after the sizes, or before the braces
  Expr* init;           // a BraceExpr or null
};
struct BraceExpr : Expr {
  Seq<Expr*> items;
};  // {1, 2}: only as an initialiser
struct Param {
  Name name;
  TypeExpr* type;       // null: generic by use
  Expr* default_value;  // null: required
  Span span;
};
struct LambdaExpr : Expr {
  Seq<Param> params;
  TypeExpr* result;  // null: inferred
  Block* body;       // exactly one of body and value is set
  Expr* value;
};
struct UntilExpr : Expr {  // m.run(p) until c
  Expr* motion;
  Expr* condition;
};

}  // namespace armlet::lang::ast
