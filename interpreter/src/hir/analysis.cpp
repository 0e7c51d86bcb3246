#include "hir/analysis.hpp"

#include <algorithm>
#include <map>

#include "hir/walk.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

bool calls_quietly(const CallNativeExpr& call) {
  if (call.function->pauses) return false;
  return std::none_of(call.arguments.begin(), call.arguments.end(),
                      [](const Expr* a) { return a->type->is(Kind::kFunction); });
}

bool is_loud(const Expr& e, const FunctionSet& inlined) {
  if (e.kind == ExprKind::kCall) return !inlined.contains(e.as<CallExpr>().function);
  if (e.kind == ExprKind::kCallNative) return !calls_quietly(e.as<CallNativeExpr>());
  return is_one_of(
      e.kind, {ExprKind::kCallValue, ExprKind::kMutate, ExprKind::kGuarded, ExprKind::kOverList});
}

bool is_plain_op(Op op) {
  return (op >= Op::kAddR && op <= Op::kDivR) || op == Op::kNegR ||
         (op >= Op::kLtI && op <= Op::kNot);
}

bool is_plain_node(const Expr& e) {
  if (e.kind == ExprKind::kVariable) {
    return e.as<VariableExpr>().variable->storage == Storage::kLocal && !e.type->is_reference();
  }
  if (e.kind == ExprKind::kUnary) return is_plain_op(e.as<UnaryExpr>().op);
  if (e.kind == ExprKind::kBinary) return is_plain_op(e.as<BinaryExpr>().op);
  if (e.kind == ExprKind::kConvert) {
    return is_one_of(e.as<ConvertExpr>().conversion, {Conversion::kSame, Conversion::kIntToReal});
  }
  return is_one_of(e.kind, {ExprKind::kBool, ExprKind::kInt, ExprKind::kReal, ExprKind::kEnum,
                            ExprKind::kAnd, ExprKind::kOr});
}

// The initialiser of a variable that is never assigned again; null if the variable is assigned
// elsewhere or its initialiser is another variable.
const Expr* only_value(const Variable& variable) {
  const Variable* v = &variable;
  while (v->outer != nullptr) v = v->outer;
  if (!v->fixed || v->is_parameter || v->maybe_unset || v->init == nullptr) return nullptr;
  return v->init->kind == ExprKind::kVariable ? nullptr : v->init;
}

// Adds what a statement, with all statements and expressions inside it, does to variables to a
// Summary.
class Summariser {
 public:
  Summariser(Summary& out, const FunctionSet& inlined) : out_(out), inlined_(inlined) {}

  void statement(const Stmt& s) {
    switch (s.kind) {
      case StmtKind::kAssign:
        place(s.as<AssignStmt>().place, false);
        break;
      case StmtKind::kStorePart:
        use(s.as<StorePartStmt>().place.variable).element = true;
        break;
      case StmtKind::kInit:
        use(s.as<InitStmt>().variable).assigned = true;
        break;
      case StmtKind::kRange:
        use(s.as<RangeStmt>().variable).assigned = true;
        break;
      case StmtKind::kForList:
        use(s.as<ForListStmt>().variable).assigned = true;
        break;
      case StmtKind::kWait:
      case StmtKind::kWaitUntil:
      case StmtKind::kParallel:
      case StmtKind::kWhen:
      case StmtKind::kEvery:
        out_.quiet = false;
        break;
      case StmtKind::kBlock:
      case StmtKind::kExpr:
      case StmtKind::kIf:
      case StmtKind::kLoop:
      case StmtKind::kSwitch:
      case StmtKind::kTry:
      case StmtKind::kThrow:
      case StmtKind::kJump:
      case StmtKind::kReturn:
      case StmtKind::kAssert:
      case StmtKind::kAssertThrows:
        break;
    }
    for_each_child(
        s, [this](const Expr& e) { expression(e); },
        [this](const Stmt& child) { statement(child); });
  }

 private:
  void expression(const Expr& expr) {
    std::vector<const Expr*> open{&expr};
    while (!open.empty()) {
      const Expr& e = *open.back();
      open.pop_back();
      if (is_loud(e, inlined_)) out_.quiet = false;
      if (e.kind == ExprKind::kCall && inlined_.contains(e.as<CallExpr>().function)) {
        statement(*e.as<CallExpr>().function->body);
      }
      if (e.kind == ExprKind::kMutate) place(e.as<MutateExpr>().place, true);
      if (e.kind == ExprKind::kVariable) use(e.as<VariableExpr>().variable).whole = true;
      if (e.kind == ExprKind::kClosure) {
        for (const Capture& capture : e.as<ClosureExpr>().function->captures)
          use(capture.outer).whole = true;
      }
      const Expr* inner = container(e);
      for_each_operand(e, [&](const Expr& operand) {
        if (&operand != inner) open.push_back(&operand);
      });
    }
  }

  // The variable or expression below a chain of fields and elements. Reading one element of a list
  // does not count as a use of the whole list.
  const Expr* container(const Expr& e) {
    const Expr* object = nullptr;
    if (e.kind == ExprKind::kElement) object = e.as<ElementExpr>().object;
    if (e.kind == ExprKind::kField) object = e.as<FieldExpr>().object;
    if (e.kind == ExprKind::kLength) object = e.as<LengthExpr>().object;
    if (e.kind == ExprKind::kPart) object = e.as<PartExpr>().object;
    if (object == nullptr || object->kind != ExprKind::kVariable) return nullptr;
    (void)use(object->as<VariableExpr>().variable);
    return object;
  }

  void place(const Place& place, bool changes_length) {
    VariableUse& u = use(place.variable);
    if (place.steps.empty()) {
      u.assigned = true;
    } else {
      u.element = true;
      if (changes_length) u.assigned = true;
    }
  }

  VariableUse& use(const Variable* variable) {
    const auto [known, is_new] = index_.try_emplace(variable, out_.uses.size());
    if (is_new) out_.uses.push_back({.variable = variable});
    return out_.uses[known->second];
  }

  Summary& out_;
  const FunctionSet& inlined_;
  std::map<const Variable*, std::size_t> index_;
};

}  // namespace

namespace {

bool literal_slot(const Expr& e, Slot& out) {
  if (e.kind == ExprKind::kBool) {
    out = slot_of(e.as<BoolExpr>().value);
  } else if (e.kind == ExprKind::kInt || e.kind == ExprKind::kEnum) {
    out = slot_of(e.as<IntExpr>().value);
  } else if (e.kind == ExprKind::kReal) {
    out = slot_of(e.as<RealExpr>().value);
  } else {
    return false;
  }
  return true;
}

}  // namespace

bool constant_slot(const Expr& e, Slot& out) {
  if (literal_slot(e, out)) return true;
  if (e.kind == ExprKind::kVariable) {
    const Expr* init = only_value(*e.as<VariableExpr>().variable);
    if (init != nullptr && init->type == e.type && constant_slot(*init, out)) return true;
  } else if (e.kind == ExprKind::kConvert) {
    if (e.as<ConvertExpr>().conversion == Conversion::kIntToReal &&
        constant_slot(*e.as<ConvertExpr>().operand, out)) {
      out = slot_of(static_cast<double>(out.i));
      return true;
    }
  }
  if (e.constant == nullptr) return false;
  const Constant& c = *e.constant;
  if (e.type->is(Kind::kBool) && c.kind == Constant::Kind::kBool) {
    out = slot_of(c.truth);
    return true;
  }
  const bool number = c.kind == Constant::Kind::kInt || c.kind == Constant::Kind::kReal;
  if (e.type->is(Kind::kReal) && number) {
    out = slot_of(c.real);
    return true;
  }
  if (e.type->is(Kind::kInt) && c.kind == Constant::Kind::kInt) {
    out = slot_of(c.integer);
    return true;
  }
  return false;
}

bool small_int(const Expr& e, std::int64_t& out) {
  Slot slot;
  if (e.type->is(Kind::kReal) || !constant_slot(e, slot)) return false;
  out = slot.i;
  return out >= INT16_MIN && out <= INT16_MAX;
}

bool is_quiet(const Expr& expr, const FunctionSet& inlined) {
  return !any_part(expr, [&](const Expr& e) { return is_loud(e, inlined); });
}

bool is_plain(const Expr& expr) {
  return !any_part(expr, [](const Expr& e) { return !is_plain_node(e); });
}

bool mutates(const Expr& expr) {
  return any_part(expr, [](const Expr& e) { return e.kind == ExprKind::kMutate; });
}

bool mentions(const Expr& expr, const Variable& variable) {
  return any_part(expr, [&](const Expr& e) {
    return e.kind == ExprKind::kVariable && e.as<VariableExpr>().variable == &variable;
  });
}

const Variable* root_variable(const Expr& expr) {
  const Expr* e = &expr;
  while (e->kind != ExprKind::kVariable) {
    if (e->kind == ExprKind::kField) {
      e = e->as<FieldExpr>().object;
    } else if (e->kind == ExprKind::kElement) {
      e = e->as<ElementExpr>().object;
    } else if (e->kind == ExprKind::kEntry) {
      e = e->as<EntryExpr>().object;
    } else if (e->kind == ExprKind::kConvert) {
      e = e->as<ConvertExpr>().operand;
    } else {
      return nullptr;
    }
  }
  return e->as<VariableExpr>().variable;
}

const VariableUse* Summary::find(const Variable* variable) const {
  const auto found = std::find_if(uses.begin(), uses.end(),
                                  [&](const VariableUse& u) { return u.variable == variable; });
  return found == uses.end() ? nullptr : &*found;
}

bool Summary::assigns(const Variable* variable) const {
  const VariableUse* use = find(variable);
  return use != nullptr && use->assigned;
}

Summary summarise(const Stmt& loop, const FunctionSet& inlined) {
  Summary summary;
  Summariser(summary, inlined).statement(loop);
  return summary;
}

}  // namespace armlet::lang
