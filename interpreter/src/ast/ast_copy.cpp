#include "ast/ast_copy.hpp"

namespace armlet::lang {
namespace ast {
namespace {

class Copier {
 public:
  Copier(Arena& arena, const Source& text, std::int64_t shift)
      : arena_(arena), text_(text), shift_(shift) {}

  Expr* copy(const Expr& expr) {
    switch (expr.kind) {
#define ARMLET_STMT(...)
#define ARMLET_EXPR(kind, Node, ...) \
  case ExprKind::kind:               \
    return node<Node>(expr __VA_OPT__(, ) __VA_ARGS__);
#include "ast/ast_nodes.def"
#undef ARMLET_EXPR
#undef ARMLET_STMT
    }
    return nullptr;
  }

  Stmt* copy(const Stmt& stmt) {
    switch (stmt.kind) {
#define ARMLET_EXPR(...)
#define ARMLET_STMT(kind, Node, ...) \
  case StmtKind::kind:               \
    return node<Node>(stmt __VA_OPT__(, ) __VA_ARGS__);
#include "ast/ast_nodes.def"
#undef ARMLET_STMT
#undef ARMLET_EXPR
    }
    return nullptr;
  }

 private:
  template <class Node, class Base, class... Members>
  Node* node(const Base& from, Members... members) {
    Node* out = arena_.make<Node>(from.template as<Node>());
    fix(out->span);
    (fix(out->*members), ...);
    return out;
  }

  void fix(Span& span) {
    span.begin = static_cast<std::uint32_t>(span.begin + shift_);
    span.end = static_cast<std::uint32_t>(span.end + shift_);
    span.source = text_.id();
  }
  void fix(std::string_view& text) { text = arena_.copy(text); }
  void fix(Name& name) {
    fix(name.span);
    const std::string_view there = text_.slice(name.span);
    if (there == name.text) {
      name.text = there;
    } else {
      fix(name.text);
    }
  }
  void fix(Expr*& expr) {
    if (expr != nullptr) expr = copy(*expr);
  }
  void fix(Stmt*& stmt) {
    if (stmt != nullptr) stmt = copy(*stmt);
  }
  void fix(Block*& block) {
    if (block != nullptr) block = static_cast<Block*>(copy(static_cast<const Stmt&>(*block)));
  }
  void fix(TypeExpr*& type) {
    if (type == nullptr) return;
    type = arena_.make<TypeExpr>(*type);
    of(*type, &TypeExpr::span, &TypeExpr::path, &TypeExpr::element, &TypeExpr::key,
       &TypeExpr::factors, &TypeExpr::parameters, &TypeExpr::result);
  }
  void fix(TypeFactor& factor) { fix(factor.type); }
  void fix(Arg& arg) { of(arg, &Arg::name, &Arg::value, &Arg::span); }
  void fix(Param& param) {
    of(param, &Param::name, &Param::type, &Param::default_value, &Param::span);
  }
  void fix(Declarator& at) { of(at, &Declarator::name, &Declarator::type, &Declarator::init); }
  void fix(BlockItem& item) {
    of(item, &BlockItem::name, &BlockItem::constructor, &BlockItem::value, &BlockItem::args,
       &BlockItem::span);
  }
  void fix(SwitchCase& one) { of(one, &SwitchCase::values, &SwitchCase::body, &SwitchCase::span); }
  void fix(CatchClause& clause) {
    of(clause, &CatchClause::name, &CatchClause::type, &CatchClause::head, &CatchClause::body);
  }
  void fix(FormatPiece& piece) {
    fix(piece.value);
    of(piece.format, &FormatSpec::unit, &FormatSpec::span);
  }
  void fix(IndexItem& item) { of(item, &IndexItem::first, &IndexItem::last, &IndexItem::span); }
  template <class T>
  void fix(Seq<T>& items) {
    items = arena_.copy(std::vector<T>(items.begin(), items.end()));
    for (T& item : items) fix(item);
  }
  template <class Part, class... Members>
  void of(Part& part, Members... members) {
    (fix(part.*members), ...);
  }

  Arena& arena_;
  const Source& text_;
  std::int64_t shift_;
};

}  // namespace
}  // namespace ast

ast::Stmt* copied(const ast::Stmt& stmt, Arena& arena, const Source& text, std::int64_t shift) {
  return ast::Copier(arena, text, shift).copy(stmt);
}

}  // namespace armlet::lang
