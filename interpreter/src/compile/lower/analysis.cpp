#include "compile/lower/analysis.hpp"

#include <algorithm>
#include <map>

#include "check/tree/walk.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

bool calls_quietly(const CallNativeExpr& call) {
  if (call.function->pauses) return false;
  return std::none_of(call.arguments.begin(), call.arguments.end(),
                      [](const Expr* a) { return a->type->is(Kind::kFunction); });
}

bool is_loud(const Expr& e) {
  switch (e.kind) {
    case ExprKind::kCall:
      return !e.as<CallExpr>().function->expands;
    case ExprKind::kCallValue:
    case ExprKind::kMutate:
    case ExprKind::kGuarded:
    case ExprKind::kOverList:
      return true;
    case ExprKind::kCallNative:
      return !calls_quietly(e.as<CallNativeExpr>());
    default:
      return false;
  }
}

bool is_plain_op(Op op) {
  switch (op) {
    case Op::kAddR:
    case Op::kSubR:
    case Op::kMulR:
    case Op::kDivR:
    case Op::kNegR:
    case Op::kLtI:
    case Op::kLeI:
    case Op::kGtI:
    case Op::kGeI:
    case Op::kEqI:
    case Op::kNeI:
    case Op::kLtR:
    case Op::kLeR:
    case Op::kGtR:
    case Op::kGeR:
    case Op::kEqR:
    case Op::kNeR:
    case Op::kNot:
      return true;
    default:
      return false;
  }
}

bool is_plain_node(const Expr& e) {
  switch (e.kind) {
    case ExprKind::kBool:
    case ExprKind::kInt:
    case ExprKind::kReal:
    case ExprKind::kEnum:
      return true;
    case ExprKind::kVariable:
      return e.as<VariableExpr>().variable->storage == Storage::kLocal && !e.type->is_reference();
    case ExprKind::kAnd:
    case ExprKind::kOr:
      return true;
    case ExprKind::kUnary:
      return is_plain_op(e.as<UnaryExpr>().op);
    case ExprKind::kBinary:
      return is_plain_op(e.as<BinaryExpr>().op);
    case ExprKind::kConvert:
      return e.as<ConvertExpr>().conversion == Conversion::kSame ||
             e.as<ConvertExpr>().conversion == Conversion::kIntToReal;
    default:
      return false;
  }
}

// The expression that gives a variable its only value; null if there is none, or if it is another
// variable.
const Expr* only_value(const Variable& variable) {
  const Variable* v = &variable;
  while (v->outer != nullptr) v = v->outer;
  if (!v->fixed || v->is_parameter || v->maybe_unset || v->init == nullptr) return nullptr;
  return v->init->kind == ExprKind::kVariable ? nullptr : v->init;
}

// Walks one statement and everything in it.
class Summariser {
 public:
  explicit Summariser(Summary& out) : out_(out) {}

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
      default:
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
      if (is_loud(e)) out_.quiet = false;
      if (e.kind == ExprKind::kCall && e.as<CallExpr>().function->expands) {
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

  // A variable that is only looked into is not used as a whole.
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
  std::map<const Variable*, std::size_t> index_;
};

}  // namespace

bool constant_slot(const Expr& e, Slot& out) {
  switch (e.kind) {
    case ExprKind::kVariable: {
      const Expr* init = only_value(*e.as<VariableExpr>().variable);
      if (init != nullptr && init->type == e.type && constant_slot(*init, out)) return true;
      break;
    }
    case ExprKind::kConvert:
      if (e.as<ConvertExpr>().conversion == Conversion::kIntToReal &&
          constant_slot(*e.as<ConvertExpr>().operand, out)) {
        out = slot_of(static_cast<double>(out.i));
        return true;
      }
      break;
    case ExprKind::kBool:
      out = slot_of(e.as<BoolExpr>().value);
      return true;
    case ExprKind::kInt:
    case ExprKind::kEnum:
      out = slot_of(e.as<IntExpr>().value);
      return true;
    case ExprKind::kReal:
      out = slot_of(e.as<RealExpr>().value);
      return true;
    default:
      break;
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

bool is_quiet(const Expr& expr) { return !any_part(expr, is_loud); }

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
  for (;;) {
    switch (e->kind) {
      case ExprKind::kVariable:
        return e->as<VariableExpr>().variable;
      case ExprKind::kField:
        e = e->as<FieldExpr>().object;
        break;
      case ExprKind::kElement:
        e = e->as<ElementExpr>().object;
        break;
      case ExprKind::kEntry:
        e = e->as<EntryExpr>().object;
        break;
      case ExprKind::kConvert:
        e = e->as<ConvertExpr>().operand;
        break;
      default:
        return nullptr;
    }
  }
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

Summary summarise(const Stmt& loop) {
  Summary summary;
  Summariser(summary).statement(loop);
  return summary;
}

}  // namespace armlet::lang
