#pragma once
// Builds the syntax tree from a complete parse tree: one function per rule of the grammar. Mistakes
// of syntax are reported elsewhere. The builder checks the rules that the grammar leaves open:
// targets of assignments, the order of arguments, and the positions of break, continue, return,
// retry and of declarations.

#include <RbtParser.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "ast/ast.hpp"
#include "base/arena.hpp"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// Thrown if the tree is deeper than the limit, since later stages use recursion.
struct TreeTooDeep {
  Span span;
};

// The input of the builder, and the arena for the tree.
struct BuildInput {
  const Source& source;
  const Tokens& tokens;               // the indices of the parse tree's tokens refer to these
  const std::vector<Span>& comments;  // for the text of /// lines
  Arena& arena;
  DiagnosticSink& sink;
  std::size_t max_depth;
  std::size_t depth;  // the depth of the new tree's root
  // Parses the value in a formatted text; null after a message. The second argument is the depth of
  // the text in the tree.
  std::function<ast::Expr*(Span, std::size_t)> parse_piece;
  const std::atomic<bool>* cancelled;  // see parse.hpp
};

class AstBuilder {
 public:
  explicit AstBuilder(const BuildInput& input) : in_(input), depth_(input.depth) {}

  [[nodiscard]] bool failed() const { return failed_; }
  // Whether a part is missing in the last statement, so that it cannot be checked.
  [[nodiscard]] bool take_incomplete() { return std::exchange(incomplete_, false); }

  // Null for an empty statement.
  ast::Stmt* statement(RbtParser::StmtContext* ctx);
  ast::Expr* expression(RbtParser::ExpressionContext* ctx);

 private:
  // The jumps that are allowed at the position of a statement.
  struct Place {
    bool at_top = true;
    bool in_loop = false;
    bool in_switch = false;
    bool in_function = false;
    bool in_catch = false;
    const char* task = nullptr;  // the kind of block that runs as a task
  };
  // Sets the allowed jumps for a body, and restores the old ones at its end.
  class Inside {
   public:
    Inside(AstBuilder& builder, Place place) : builder_(builder), outer_(builder.place_) {
      builder_.place_ = place;
    }
    ~Inside() { builder_.place_ = outer_; }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;

   private:
    AstBuilder& builder_;
    Place outer_;
  };
  // Increases the depth of the tree during its lifetime.
  class Deeper {
   public:
    Deeper(AstBuilder& builder, std::size_t levels, Span span);
    ~Deeper() { builder_.depth_ -= levels_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;

   private:
    AstBuilder& builder_;
    std::size_t levels_;
  };

  // build_ast.cpp: statements
  ast::Stmt* plain_block(RbtParser::BlockContext* ctx);
  ast::Stmt* closed(RbtParser::ClosedStmtContext* ctx);
  ast::Stmt* jump(RbtParser::ClosedStmtContext* ctx);
  ast::Stmt* expr_stmt(RbtParser::ExprStmtContext* ctx);
  ast::Stmt* assignment(RbtParser::ExprStmtContext* ctx);
  ast::Stmt* wait(RbtParser::WaitStmtContext* ctx);
  ast::Stmt* body(RbtParser::StmtContext* ctx);
  ast::Stmt* if_body(RbtParser::IfBodyContext* ctx);
  ast::Stmt* if_stmt(RbtParser::IfStmtContext* ctx);
  ast::Stmt* while_stmt(RbtParser::WhileStmtContext* ctx);
  ast::Stmt* do_stmt(RbtParser::DoStmtContext* ctx);
  ast::Stmt* for_stmt(RbtParser::ForStmtContext* ctx);
  ast::Stmt* counted_for(RbtParser::ForStmtContext* ctx);
  ast::Stmt* switch_stmt(RbtParser::SwitchStmtContext* ctx);
  ast::Stmt* try_stmt(RbtParser::TryStmtContext* ctx);
  ast::Stmt* task_block(RbtParser::StmtContext* ctx);
  ast::Stmt* setting_block(RbtParser::StmtContext* ctx);
  ast::Stmt* record_stmt(RbtParser::RecordStmtContext* ctx);
  ast::Block* block(RbtParser::BlockContext* ctx);
  ast::Block* function_block(RbtParser::BlockContext* ctx);
  ast::Block* body_block(RbtParser::BlockContext* ctx, const Place& place);
  ast::Seq<ast::Stmt*> statements(const std::vector<RbtParser::StmtContext*>& list);
  void check_target(const ast::Expr* target);
  void check_lone_return(const antlr4::ParserRuleContext* ctx);

  // build_declaration.cpp
  ast::Stmt* top_declaration(RbtParser::StmtContext* ctx);
  ast::Stmt* let_decl(RbtParser::LetDeclContext* ctx);
  ast::Stmt* var_decl(RbtParser::VarDeclContext* ctx);
  ast::Stmt* block_decl(RbtParser::BlockDeclContext* ctx);
  ast::Stmt* fn_decl(RbtParser::FnDeclContext* ctx);
  ast::Stmt* struct_decl(RbtParser::StructDeclContext* ctx);
  ast::Stmt* enum_decl(RbtParser::EnumDeclContext* ctx);
  ast::Stmt* import_decl(RbtParser::ImportDeclContext* ctx);
  ast::Stmt* test_decl(RbtParser::TestDeclContext* ctx);
  ast::Seq<ast::BlockItem> block_items(const std::vector<RbtParser::BlockItemContext*>& list);
  std::string_view doc(const antlr4::ParserRuleContext* ctx);

  // build_types.cpp: types, parameters
  ast::TypeExpr* any_type(RbtParser::AnyTypeContext* ctx);
  ast::TypeExpr* dim_type(RbtParser::DimTypeContext* ctx);
  ast::TypeExpr* type_in_parens(RbtParser::DimFactorContext* ctx);
  ast::TypeExpr* function_type(RbtParser::FnTypeContext* ctx);
  ast::TypeExpr* result_type(RbtParser::ResultTypeContext* ctx);
  ast::TypeExpr* type(RbtParser::TypeContext* ctx);
  ast::TypeExpr* base_type(RbtParser::PrimTypeContext* primitive,
                           RbtParser::TypeNameContext* named);
  ast::TypeExpr* named_type(RbtParser::TypeNameContext* ctx);
  ast::TypeExpr* type_expr(ast::TypeForm form, Span span);
  ast::TypeExpr* array_of(ast::TypeExpr* element, std::size_t dimensions, Span span);
  ast::TypeExpr* in_brackets(ast::TypeExpr* element,
                             const std::vector<RbtParser::BracketPairContext*>& pairs, Span span);
  ast::Seq<ast::Param> params(RbtParser::ParamsContext* ctx);
  ast::Param param(RbtParser::ParamContext* ctx);

  // build_expr.cpp: expressions
  ast::Expr* expr(RbtParser::ExprContext* ctx);
  ast::Expr* leaf(RbtParser::ExprContext* ctx);
  ast::Expr* extend(ast::Expr* left, RbtParser::ExprContext* ctx);
  ast::Expr* unary(RbtParser::UnaryEContext* ctx);
  ast::Expr* index(ast::Expr* object, RbtParser::ExprContext* ctx);
  ast::IndexItem index_item(RbtParser::IndexItemContext* ctx);
  ast::Expr* primary(RbtParser::PrimaryContext* ctx);
  ast::Expr* lambda(RbtParser::LambdaContext* ctx);
  ast::Expr* new_array(RbtParser::NewArrayContext* ctx);
  ast::Expr* initializer(RbtParser::InitializerContext* ctx);
  ast::Seq<ast::Expr*> expressions(const antlr4::ParserRuleContext* ctx);
  ast::Seq<ast::Arg> args(RbtParser::ArgsContext* ctx);
  ast::Seq<ast::Arg> args(const std::vector<RbtParser::ArgContext*>& list);

  // build_list.cpp: lists, matrices, maps
  // A value, or a key with its value.
  struct Item {
    ast::Expr* first;
    ast::Expr* second;  // null: the item has no colon
  };
  ast::Expr* list_or_matrix(RbtParser::PrimaryContext* ctx);
  ast::Expr* brace_init(RbtParser::BraceInitContext* ctx);
  ast::Seq<ast::Expr*> firsts_of(const std::vector<Item>& items);
  ast::Expr* map_of(Span span, const std::vector<Item>& items);

  // build_literal.cpp: numbers and texts
  ast::Expr* literal(RbtParser::LiteralContext* ctx);
  ast::Expr* whole_number(Span span);
  ast::Expr* real_number(Span span);
  ast::Expr* quantity(Span span);
  ast::Expr* formatted(Span span);
  ast::FormatPiece format_piece(Span piece);
  ast::FormatSpec format_spec(Span span);
  std::string_view decoded(Span literal);
  std::size_t decode_escape(Span span, std::size_t at, std::string& out);

  // A new node without its parts.
  template <class T, class Kind>
  T* fresh(Kind kind, Span span) {
    T* out = in_.arena.make<T>();
    out->kind = kind;
    out->span = span;
    return out;
  }

  // build_types.cpp: spans and messages
  [[nodiscard]] Span token_span(const antlr4::Token* token) const;
  // The span without the `;` at the end.
  [[nodiscard]] Span span_of(const antlr4::ParserRuleContext* ctx) const;
  [[nodiscard]] ast::Name name(RbtParser::NameContext* ctx) const;
  [[nodiscard]] std::string_view text(Span span) const { return in_.source.slice(span); }
  void report(Diagnostic diagnostic);

  const BuildInput& in_;
  std::size_t depth_;
  Place place_;
  bool failed_ = false;
  bool incomplete_ = false;
};

}  // namespace armlet::lang
