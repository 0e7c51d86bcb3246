// Inlines small functions. An inlined call still counts a step and a level of nesting, and messages
// still name the function, so programs behave the same.

#include "lower/inlining.hpp"

#include <algorithm>
#include <vector>

#include "hir/analysis.hpp"
#include "hir/walk.hpp"
#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

constexpr int kMostOperations = 12;

// Counts the operations of one function, and finds statements that cannot be inlined.
class Judge {
 public:
  explicit Judge(const Function& function) : function_(function) {}

  bool is_small() {
    const auto in_register = [](const Variable* v) { return v->storage == Storage::kLocal; };
    if (!function_.captures.empty() || function_.is_condition || function_.body == nullptr ||
        function_.result == nullptr || !is_number(*function_.result) ||
        !std::all_of(function_.parameters.begin(), function_.parameters.end(), in_register)) {
      return false;
    }
    statement(*function_.body);
    return fits_ && operations_ <= kMostOperations;
  }

 private:
  static bool is_number(const Type& type) { return !type.is_reference() && !type.is(Kind::kVoid); }
  bool is_own_number(const Variable& v) const {
    return v.owner == &function_ && v.storage == Storage::kLocal && is_number(*v.type);
  }

  void statement(const Stmt& s) {
    switch (s.kind) {
      case StmtKind::kBlock:
      case StmtKind::kReturn:
        break;
      case StmtKind::kIf:
        ++operations_;
        break;
      case StmtKind::kInit:
        if (s.as<InitStmt>().value == nullptr || !is_own_number(*s.as<InitStmt>().variable)) {
          fits_ = false;
        }
        break;
      case StmtKind::kAssign: {
        const auto& assign = s.as<AssignStmt>();
        const Variable& variable = *assign.place.variable;
        // The register of a parameter may be that of the caller's variable, so it must not change.
        if (!assign.place.steps.empty() || !is_own_number(variable) || variable.is_parameter) {
          fits_ = false;
        }
        if (assign.compound) ++operations_;
        break;
      }
      case StmtKind::kExpr:
      case StmtKind::kLoop:
      case StmtKind::kRange:
      case StmtKind::kForList:
      case StmtKind::kSwitch:
      case StmtKind::kTry:
      case StmtKind::kThrow:
      case StmtKind::kJump:
      case StmtKind::kWait:
      case StmtKind::kWaitUntil:
      case StmtKind::kParallel:
      case StmtKind::kWhen:
      case StmtKind::kEvery:
      case StmtKind::kAssert:
      case StmtKind::kAssertThrows:
      case StmtKind::kStorePart:
        fits_ = false;
        break;
    }
    if (!fits_) return;
    for_each_child(
        s, [this](const Expr& e) { expression(e); },
        [this](const Stmt& child) { statement(child); });
  }

  void expression(const Expr& expr) {
    std::vector<const Expr*> open{&expr};
    while (!open.empty() && fits_ && operations_ <= kMostOperations) {
      const Expr& e = *open.back();
      open.pop_back();
      Slot known;
      if (constant_slot(e, known)) continue;
      node(e);
      for_each_operand(e, [&](const Expr& operand) { open.push_back(&operand); });
    }
  }

  // Inlined bodies only read references: they create no object that would have to be released.
  void node(const Expr& e) {
    ++operations_;
    if (e.kind == ExprKind::kVariable) {
      --operations_;
      if (e.as<VariableExpr>().variable->storage == Storage::kBoxed) fits_ = false;
      return;
    }
    if (is_one_of(e.kind, {ExprKind::kField, ExprKind::kElement, ExprKind::kLength})) return;
    const bool computes = is_one_of(e.kind, {ExprKind::kUnary, ExprKind::kBinary, ExprKind::kAnd,
                                             ExprKind::kOr, ExprKind::kCond, ExprKind::kConvert}) ||
                          (e.kind == ExprKind::kCallNative && is_quiet(e));
    if (!computes || e.type->is_reference()) fits_ = false;
  }

  const Function& function_;
  int operations_ = 0;
  bool fits_ = true;
};

}  // namespace

FunctionSet inlined_functions(const Module& module) {
  FunctionSet inlined;
  for (const Function* function : module.functions) {
    if (function != module.main && Judge(*function).is_small()) inlined.insert(function);
  }
  return inlined;
}

// Arguments are evaluated as for any call; the parameters then are other names of their registers.
void expand(Lowering& in, const CallExpr& e, Dest to) {
  Hold hold = Hold::kNow;
  std::vector<Hold> holds(e.arguments.size(), hold);
  for (std::size_t i = e.arguments.size(); i-- > 1;) {
    holds[i - 1] = hold = stronger(hold, hold_over(in, *e.arguments[i]));
  }
  std::vector<Reg> arguments;
  for (std::size_t i = 0; i < e.arguments.size(); ++i) {
    const Expr& argument = *e.arguments[i];
    const bool reference = argument.type->is_reference();
    arguments.push_back(reference ? borrow(in, argument, holds[i]) : value(in, argument));
    if (arguments.back() == to.reg) to.early = false;
  }
  expand_body(in, {e.span, &e}, *e.function, arguments, to);
}

void expand_body(Lowering& in, Site site, const Function& function,
                 const std::vector<Reg>& arguments, Dest to) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    in.homes.give(*function.parameters[i], arguments[i]);
  }
  in.code.at(site.span, site.expr);
  in.code.push(OpCode::EXPANDED, 0, function.index, 0);
  const std::uint32_t begin = in.code.position();
  const Label end = in.code.label();
  in.ways.begin(Expansion{to, end});
  block(in, *function.body);
  in.ways.end_expansion();
  in.code.drop_jump(end);
  in.code.expanded({begin, in.code.position()}, function.index, site.span);
  in.code.bind(end);
}

// `return` in an inlined body.
void give_back_here(Lowering& in, const Expr& e) {
  const Expansion expansion = in.ways.expansion();
  value_into(in, e, expansion.to);
  in.code.jump(expansion.end);
}

}  // namespace armlet::lang
