#include "check/look_ahead.hpp"

#include <algorithm>

#include "check/list_mutations.hpp"

namespace armlet::lang {
namespace {

using namespace ast;

// Walks the tree. Chains of operators lean to the left and may be long, so they are walked in a
// loop.
class Lookout {
 public:
  explicit Lookout(Sights& sights) : sights_(sights) {}

  void body(Seq<ast::Stmt*> statements) {
    for (const ast::Stmt* statement : statements) stmt(statement);
  }

 private:
  void changes(const ast::Expr* place) {
    for (;;) {
      if (place->kind == ExprKind::kMember) {
        place = place->as<MemberExpr>().object;
      } else if (place->kind == ExprKind::kIndex) {
        place = place->as<IndexExpr>().object;
      } else {
        break;
      }
    }
    if (place->kind == ExprKind::kName) sights_.changed.insert(place->as<NameExpr>().name);
  }

  void arguments(Seq<Arg> args) {
    for (const Arg& arg : args) expr(arg.value);
  }

  void call(const CallExpr& node) {
    if (node.callee->kind == ExprKind::kMember) {
      const auto& member = node.callee->as<MemberExpr>();
      const auto changed =
          std::ranges::find(kListMutations, member.member.text, &ListMutation::name);
      if (changed != std::end(kListMutations)) changes(member.object);
    }
    expr(node.callee);
    arguments(node.args);
  }

  void list(Seq<ast::Expr*> items) {
    for (const ast::Expr* item : items) expr(item);
  }

  void lambda(const LambdaExpr& node) {
    for (const Param& param : node.params) expr(param.default_value);
    if (node.body != nullptr) body(node.body->body);
    expr(node.value);
  }

  void expr(const ast::Expr* at) {
    while (at != nullptr && at->kind == ExprKind::kBinary) {
      expr(at->as<BinaryExpr>().right);
      at = at->as<BinaryExpr>().left;
    }
    if (at == nullptr) return;
    switch (at->kind) {
      case ExprKind::kName:
        sights_.mentioned.insert(at->as<NameExpr>().name);
        return;
      case ExprKind::kMember:
        sights_.mentioned.insert(at->as<MemberExpr>().member.text);
        return expr(at->as<MemberExpr>().object);
      case ExprKind::kIndex:
        for (const IndexItem& item : at->as<IndexExpr>().items) {
          expr(item.first);
          expr(item.last);
        }
        return expr(at->as<IndexExpr>().object);
      case ExprKind::kCall:
        return call(at->as<CallExpr>());
      case ExprKind::kUnary:
        return expr(at->as<UnaryExpr>().operand);
      case ExprKind::kCond:
        expr(at->as<CondExpr>().condition);
        expr(at->as<CondExpr>().yes);
        return expr(at->as<CondExpr>().no);
      case ExprKind::kCast:
        return expr(at->as<CastExpr>().operand);
      case ExprKind::kFormatted:
        for (const FormatPiece& piece : at->as<FormattedExpr>().pieces) expr(piece.value);
        return;
      case ExprKind::kList:
        return list(at->as<ListExpr>().items);
      case ExprKind::kBrace:
        return list(at->as<BraceExpr>().items);
      case ExprKind::kMap:
        list(at->as<MapExpr>().keys);
        return list(at->as<MapExpr>().values);
      case ExprKind::kMatrix:
        for (const Seq<ast::Expr*>& row : at->as<MatrixExpr>().rows) list(row);
        return;
      case ExprKind::kNewObject:
        return arguments(at->as<NewObjectExpr>().args);
      case ExprKind::kNewArray:
        list(at->as<NewArrayExpr>().sizes);
        return expr(at->as<NewArrayExpr>().init);
      case ExprKind::kLambda:
        return lambda(at->as<LambdaExpr>());
      case ExprKind::kUntil:
        expr(at->as<UntilExpr>().motion);
        return expr(at->as<UntilExpr>().condition);
      default:
        return;
    }
  }

  void items(Seq<BlockItem> block) {
    for (const BlockItem& item : block) {
      expr(item.value);
      arguments(item.args);
    }
  }

  void stmt(const ast::Stmt* at) {
    if (at == nullptr) return;
    switch (at->kind) {
      case StmtKind::kVar:
        for (const Declarator& declarator : at->as<VarStmt>().declarators) {
          expr(declarator.init);
          // Without a first value the first assignment is a change.
          if (declarator.init == nullptr) sights_.changed.insert(declarator.name.text);
        }
        return;
      case StmtKind::kAssign:
        for (const ast::Expr* target : at->as<AssignStmt>().targets) {
          changes(target);
          expr(target);
        }
        return expr(at->as<AssignStmt>().value);
      case StmtKind::kStep:
        changes(at->as<StepStmt>().target);
        return expr(at->as<StepStmt>().target);
      case StmtKind::kExpr:
        return expr(at->as<ExprStmt>().value);
      case StmtKind::kObject:
        return items(at->as<ObjectStmt>().items);
      case StmtKind::kFunction:
        for (const Param& param : at->as<FunctionStmt>().params) expr(param.default_value);
        stmt(at->as<FunctionStmt>().body);
        return expr(at->as<FunctionStmt>().value);
      case StmtKind::kReturn:
        return expr(at->as<ReturnStmt>().value);
      case StmtKind::kThrow:
        return expr(at->as<ThrowStmt>().value);
      case StmtKind::kWait:
        return expr(at->as<WaitStmt>().duration);
      case StmtKind::kWaitUntil:
        arguments(at->as<WaitUntilStmt>().args);
        return expr(at->as<WaitUntilStmt>().condition);
      default:
        return compound(at);
    }
  }

  // Statements that hold statements.
  void compound(const ast::Stmt* at) {
    switch (at->kind) {
      case StmtKind::kBlock:
        return body(at->as<Block>().body);
      case StmtKind::kTest:
        return stmt(at->as<TestStmt>().body);
      case StmtKind::kParallel:
        return stmt(at->as<ParallelStmt>().body);
      case StmtKind::kWhen:
        expr(at->as<WhenStmt>().condition);
        return stmt(at->as<WhenStmt>().body);
      case StmtKind::kEvery:
        expr(at->as<EveryStmt>().period);
        return stmt(at->as<EveryStmt>().body);
      case StmtKind::kIf:
        expr(at->as<IfStmt>().condition);
        stmt(at->as<IfStmt>().yes);
        return stmt(at->as<IfStmt>().no);
      case StmtKind::kWhile:
        expr(at->as<WhileStmt>().condition);
        return stmt(at->as<WhileStmt>().body);
      case StmtKind::kDo:
        expr(at->as<DoStmt>().condition);
        return stmt(at->as<DoStmt>().body);
      case StmtKind::kForIn:
        expr(at->as<ForInStmt>().items);
        return stmt(at->as<ForInStmt>().body);
      case StmtKind::kFor:
        body(at->as<ForStmt>().init);
        expr(at->as<ForStmt>().condition);
        body(at->as<ForStmt>().step);
        return stmt(at->as<ForStmt>().body);
      case StmtKind::kSwitch:
        expr(at->as<SwitchStmt>().value);
        for (const SwitchCase& one : at->as<SwitchStmt>().cases) {
          list(one.values);
          body(one.body);
        }
        return;
      case StmtKind::kTry:
        stmt(at->as<TryStmt>().body);
        for (const CatchClause& clause : at->as<TryStmt>().catches) stmt(clause.body);
        return stmt(at->as<TryStmt>().finally);
      default:
        return;  // refused by the checker
    }
  }

  Sights& sights_;
};

}  // namespace

namespace {

bool returns(const ast::Stmt* at);

bool any_returns(Seq<ast::Stmt*> statements) { return std::ranges::any_of(statements, returns); }

bool returns(const ast::Stmt* at) {
  if (at == nullptr) return false;
  switch (at->kind) {
    case StmtKind::kReturn:
      return at->as<ReturnStmt>().value != nullptr;
    case StmtKind::kBlock:
      return any_returns(at->as<Block>().body);
    case StmtKind::kIf:
      return returns(at->as<IfStmt>().yes) || returns(at->as<IfStmt>().no);
    case StmtKind::kWhile:
      return returns(at->as<WhileStmt>().body);
    case StmtKind::kDo:
      return returns(at->as<DoStmt>().body);
    case StmtKind::kForIn:
      return returns(at->as<ForInStmt>().body);
    case StmtKind::kFor:
      return returns(at->as<ForStmt>().body);
    case StmtKind::kSwitch:
      return std::ranges::any_of(at->as<SwitchStmt>().cases,
                                 [](const SwitchCase& one) { return any_returns(one.body); });
    case StmtKind::kTry:
      return returns(at->as<TryStmt>().body) || returns(at->as<TryStmt>().finally) ||
             std::ranges::any_of(at->as<TryStmt>().catches,
                                 [](const CatchClause& clause) { return returns(clause.body); });
    default:
      return false;
  }
}

}  // namespace

bool returns_a_value(const ast::Block& body) { return any_returns(body.body); }

Sights look_over(const ast::Block& program) {
  Sights out;
  Lookout(out).body(program.body);
  return out;
}

}  // namespace armlet::lang
