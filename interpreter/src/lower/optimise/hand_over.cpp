#include "lower/optimise/hand_over.hpp"

#include <algorithm>
#include <utility>

#include "hir/walk.hpp"
#include "lower/optimise/deaths.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// The parameter that an expression consists of, if its value can be moved; null otherwise.
Variable* passed_parameter(const Expr* e) {
  while (e != nullptr && e->kind == ExprKind::kConvert &&
         e->as<ConvertExpr>().conversion == Conversion::kSame) {
    e = e->as<ConvertExpr>().operand;
  }
  if (e == nullptr || e->kind != ExprKind::kVariable) return nullptr;
  Variable* variable = e->as<VariableExpr>().variable;
  const bool can = variable->is_parameter && variable->storage == Storage::kLocal &&
                   variable->type->is_reference() && !variable->type->is(Kind::kFunction);
  return can ? variable : nullptr;
}

// Collects what the functions of a program do with their parameters.
class Collector {
 public:
  void run(const Module& module) {
    for (const Function* function : module.functions) {
      if (function->body != nullptr) statement(*function->body);
    }
    // A function that passes its parameter on to one that takes it over takes it over too. The loop
    // ends when nothing changes.
    for (bool more = true; more;) {
      more = false;
      for (const Passed& passed : passed_) {
        if (passed.to->adopted && !std::exchange(passed.parameter->adopted, true)) more = true;
      }
    }
  }

 private:
  struct Passed {
    Variable* parameter;
    const Variable* to;
  };

  void statement(const Stmt& s) {
    if (s.kind == StmtKind::kInit) assigned(s.as<InitStmt>().value);
    if (s.kind == StmtKind::kAssign && s.as<AssignStmt>().place.steps.empty()) {
      assigned(s.as<AssignStmt>().value);
    }
    for_each_child(
        s, [this](const Expr& e) { expression(e); },
        [this](const Stmt& child) { statement(child); });
  }

  void assigned(const Expr* value) {
    if (Variable* parameter = passed_parameter(value)) parameter->adopted = true;
  }

  void expression(const Expr& expr) {
    std::vector<const Expr*> open{&expr};
    while (!open.empty()) {
      const Expr& e = *open.back();
      open.pop_back();
      if (e.kind == ExprKind::kCall) call(e.as<CallExpr>());
      for_each_operand(e, [&](const Expr& operand) { open.push_back(&operand); });
    }
  }

  void call(const CallExpr& e) {
    const std::size_t count = std::min(e.arguments.size(), e.function->parameters.size());
    for (std::size_t i = 0; i < count; ++i) {
      Variable* parameter = passed_parameter(e.arguments[i]);
      if (parameter != nullptr) passed_.push_back({parameter, e.function->parameters[i]});
    }
  }

  std::vector<Passed> passed_;
};

}  // namespace

void mark_adopted_parameters(const Module& module) { Collector().run(module); }

Edits hand_over_last_uses(std::vector<WideInstr>& code, const CodeShape& shape) {
  Deaths deaths(code, shape, RegClass::kReference);
  Edits edits;
  edits.removed.assign(code.size(), false);
  for (std::uint32_t at = 0; at < code.size(); ++at) {
    WideInstr& instr = code[at];
    if (instr.op == OpCode::GIVE) {
      if (!deaths.dies(instr.b, at)) instr.op = OpCode::MOVE;
    } else if (instr.op == OpCode::MOVEREF && instr.c == 1) {
      instr.c = 0;
      if (instr.a == instr.b || !deaths.dies(instr.b, at)) continue;
      instr.op = OpCode::TAKE;
      // A parameter that was taken over by the instruction before is moved to the variable
      // directly. No jump leads between the two, because parameters are taken over where the
      // function begins.
      WideInstr* before = at == 0 ? nullptr : &code[at - 1];
      if (before != nullptr && before->op == OpCode::ADOPT && before->a == instr.b) {
        before->a = instr.a;
        edits.removed[at] = true;
      }
    }
  }
  return edits;
}

}  // namespace armlet::lang
