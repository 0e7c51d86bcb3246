#pragma once
// Builds checked trees by hand, for tests of what comes after the checker.

#include <memory>
#include <string_view>
#include <vector>

#include "hir/checked_program.hpp"
#include "vm/host/language_functions.hpp"

namespace armlet::lang {

class HirBuilder {
 public:
  HirBuilder() {
    program.sources->add("built.rbt", "by hand");
    program.language = &kLanguageFunctions;
    main = function("", {}, types().void_type());
    owner = main;
  }

  TypePool& types() { return *program.types; }

  hir::Function* function(std::string_view name, std::vector<hir::Variable*> parameters,
                          const Type* result) {
    auto* f = make<hir::Function>();
    f->name = name;
    f->parameters = copy(parameters);
    f->result = result;
    f->index = static_cast<std::uint32_t>(functions.size());
    functions.push_back(f);
    return f;
  }
  hir::Variable* variable(std::string_view name, const Type* type) {
    auto* v = make<hir::Variable>();
    v->name = name;
    v->type = type;
    v->owner = owner;
    return v;
  }
  hir::Variable* global(std::string_view name, const Type* type) {
    hir::Variable* v = variable(name, type);
    v->storage = hir::Storage::kGlobal;
    v->index = static_cast<std::uint32_t>(globals.size());
    globals.push_back(v);
    return v;
  }

  // ---- expressions
  hir::Expr* integer(std::int64_t value) {
    auto* e = expr<hir::IntExpr>(hir::ExprKind::kInt, types().integer());
    e->value = value;
    return e;
  }
  hir::Expr* real(double value) {
    auto* e = expr<hir::RealExpr>(hir::ExprKind::kReal, types().real());
    e->value = value;
    return e;
  }
  hir::Expr* text(std::string_view value) {
    auto* e = expr<hir::TextExpr>(hir::ExprKind::kText, types().text());
    e->value = value;
    return e;
  }
  hir::Expr* read(hir::Variable* variable) {
    auto* e = expr<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type);
    e->variable = variable;
    return e;
  }
  hir::Expr* binary(hir::Op op, hir::Expr* left, hir::Expr* right) {
    const bool truth = op >= hir::Op::kLtI;
    auto* e = expr<hir::BinaryExpr>(hir::ExprKind::kBinary, truth ? types().boolean() : left->type);
    e->op = op;
    e->left = left;
    e->right = right;
    return e;
  }
  hir::Expr* both(hir::Expr* left, hir::Expr* right) {
    auto* e = expr<hir::BinaryExpr>(hir::ExprKind::kAnd, types().boolean());
    e->left = left;
    e->right = right;
    return e;
  }
  hir::Expr* to_real(hir::Expr* operand) {
    auto* e = expr<hir::ConvertExpr>(hir::ExprKind::kConvert, types().real());
    e->conversion = hir::Conversion::kIntToReal;
    e->operand = operand;
    return e;
  }
  hir::Expr* list(const Type* type, const std::vector<hir::Expr*>& items) {
    auto* e = expr<hir::ListExpr>(hir::ExprKind::kList, type);
    e->items = copy(items);
    return e;
  }
  hir::Expr* element(hir::Expr* object, hir::Expr* index) {
    auto* e = expr<hir::ElementExpr>(hir::ExprKind::kElement, object->type->element);
    e->object = object;
    e->index = index;
    return e;
  }
  hir::Expr* length(hir::Expr* object) {
    auto* e = expr<hir::LengthExpr>(hir::ExprKind::kLength, types().integer());
    e->object = object;
    return e;
  }
  hir::Expr* call(hir::Function* function, const std::vector<hir::Expr*>& arguments) {
    auto* e = expr<hir::CallExpr>(hir::ExprKind::kCall, function->result);
    e->function = function;
    e->arguments = copy(arguments);
    return e;
  }
  hir::Expr* call(const NativeFunction& function, const Type* result,
                  const std::vector<hir::Expr*>& arguments) {
    auto* e = expr<hir::CallNativeExpr>(hir::ExprKind::kCallNative, result);
    e->function = &function;
    e->arguments = copy(arguments);
    return e;
  }

  // ---- statements
  hir::Stmt* init(hir::Variable* variable, hir::Expr* value) {
    auto* s = stmt<hir::InitStmt>(hir::StmtKind::kInit);
    s->variable = variable;
    s->value = value;
    variable->init = value;
    return s;
  }
  hir::Stmt* assign(hir::Variable* variable, hir::Expr* value) {
    auto* s = stmt<hir::AssignStmt>(hir::StmtKind::kAssign);
    s->place = {variable, {}, variable->type, {}};
    s->value = value;
    return s;
  }
  hir::Stmt* change(hir::Variable* variable, hir::Op op, hir::Expr* value) {
    auto* s = static_cast<hir::AssignStmt*>(assign(variable, value));
    s->compound = true;
    s->op = op;
    return s;
  }
  hir::Stmt* run(hir::Expr* value) {
    auto* s = stmt<hir::ExprStmt>(hir::StmtKind::kExpr);
    s->value = value;
    return s;
  }
  hir::Stmt* when(hir::Expr* condition, hir::Stmt* yes, hir::Stmt* no = nullptr) {
    auto* s = stmt<hir::IfStmt>(hir::StmtKind::kIf);
    s->condition = condition;
    s->yes = yes;
    s->no = no;
    return s;
  }
  hir::Stmt* loop(hir::Expr* condition, hir::Stmt* body, hir::Stmt* step = nullptr) {
    auto* s = stmt<hir::LoopStmt>(hir::StmtKind::kLoop);
    s->condition = condition;
    s->body = body;
    s->step = step;
    s->test_first = true;
    return s;
  }
  hir::Stmt* give(hir::Expr* value) {
    auto* s = stmt<hir::ReturnStmt>(hir::StmtKind::kReturn);
    s->value = value;
    return s;
  }
  hir::Block* block(const std::vector<hir::Stmt*>& body) {
    auto* s = stmt<hir::Block>(hir::StmtKind::kBlock);
    s->body = copy(body);
    return s;
  }

  // The program, complete: ready for `lower`.
  CheckedProgram finish(const std::vector<hir::Stmt*>& body) {
    main->body = block(body);
    program.module.main = main;
    program.module.functions = copy(functions);
    program.module.globals = copy(globals);
    program.module.global_count = static_cast<std::uint32_t>(globals.size());
    return std::move(program);
  }

  CheckedProgram program;
  hir::Function* main = nullptr;
  hir::Function* owner = nullptr;  // of the variables made from now on

 private:
  template <class T>
  T* make() {
    return program.arena->make<T>();
  }
  template <class T>
  T* expr(hir::ExprKind kind, const Type* type) {
    T* e = make<T>();
    e->kind = kind;
    e->type = type;
    e->span = {0, 2, 0};
    return e;
  }
  template <class T>
  T* stmt(hir::StmtKind kind) {
    T* s = make<T>();
    s->kind = kind;
    s->span = {0, 2, 0};
    return s;
  }
  template <class T>
  hir::Seq<T> copy(const std::vector<T>& items) {
    return program.arena->copy(items);
  }

  std::vector<hir::Function*> functions;
  std::vector<hir::Variable*> globals;
};

}  // namespace armlet::lang
