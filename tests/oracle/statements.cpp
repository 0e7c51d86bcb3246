// Statements, each executed as the reference (sections 9 and 11) describes it.

#include <algorithm>

#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

using namespace lang::hir;
using How = Completion::How;

Completion Evaluator::execute(const Stmt& s) {
  switch (s.kind) {
    case StmtKind::kBlock:
      return block(s.as<Block>());
    case StmtKind::kInit: {
      const auto& init = s.as<InitStmt>();
      if (init.value != nullptr) {
        declare(*init.variable, evaluate(*init.value));
      } else {
        home(*init.variable).try_emplace(init.variable, std::make_shared<Value>());
      }
      return {};
    }
    case StmtKind::kAssign:
      assign(s.as<AssignStmt>());
      return {};
    case StmtKind::kExpr:
      (void)evaluate(*s.as<ExprStmt>().value);
      return {};
    case StmtKind::kIf: {
      const auto& choice = s.as<IfStmt>();
      if (evaluate(*choice.condition).truth()) return execute(*choice.yes);
      return choice.no == nullptr ? Completion{} : execute(*choice.no);
    }
    case StmtKind::kLoop:
      return loop(s.as<LoopStmt>());
    case StmtKind::kRange:
      return range(s.as<RangeStmt>());
    case StmtKind::kForList:
      return for_list(s.as<ForListStmt>());
    case StmtKind::kSwitch:
      return switch_case(s.as<SwitchStmt>());
    case StmtKind::kTry:
      return try_catch(s.as<TryStmt>());
    case StmtKind::kStorePart:
      store_part(s.as<StorePartStmt>());
      return {};
    case StmtKind::kThrow:
      throw_error(s.as<ThrowStmt>());
      return {};
    case StmtKind::kJump:
      return {How::kJump, s.as<JumpStmt>().jump, s.as<JumpStmt>().target, s.span, {}};
    case StmtKind::kReturn: {
      const Expr* value = s.as<ReturnStmt>().value;
      return {How::kReturn, {}, nullptr, s.span, value == nullptr ? Value{} : evaluate(*value)};
    }
    case StmtKind::kAssert:
      check(s.as<AssertStmt>());
      return {};
    case StmtKind::kAssertThrows:
      check_throws(s.as<AssertThrowsStmt>());
      return {};
    default:
      time_and_tasks(s);
      return {};
  }
}

Completion Evaluator::block(const Block& s) {
  const bool watches = std::ranges::any_of(s.body, [](const Stmt* inner) {
    return inner->kind == StmtKind::kWhen || inner->kind == StmtKind::kEvery;
  });
  return watches ? watched(s) : sequence(s);
}

Completion Evaluator::sequence(const Block& s) {
  for (const Stmt* inner : s.body) {
    Completion completion = execute(*inner);
    if (!completion.is_normal()) return completion;
  }
  return {};
}

// ---- loops

Completion Evaluator::loop(const LoopStmt& s) {
  constexpr int kMostTurns = 100'000;
  int turns = 0;
  const auto goes_on = [&] { return s.condition == nullptr || evaluate(*s.condition).truth(); };
  if (s.test_first && !goes_on()) return {};
  do {
    if (++turns > kMostTurns) throw std::logic_error("a loop without end");
    Completion completion = execute(*s.body);
    if (completion.is(Jump::kBreak, s)) return {};
    if (!completion.is_normal() && !completion.is(Jump::kContinue, s)) return completion;
    if (s.step != nullptr) (void)execute(*s.step);
  } while (goes_on());
  return {};
}

Completion Evaluator::range(const RangeStmt& s) {
  __extension__ using Wide = __int128;
  const std::int64_t first = evaluate(*s.first).integer();
  const std::int64_t last = evaluate(*s.last).integer();
  const std::int64_t step = s.step == nullptr ? 1 : evaluate(*s.step).integer();
  if (step == 0)
    throw Failure{"R0609", "range with a step of 0 never ends", "MathDomain", s.step->span};
  for (Wide i = first; step > 0 ? i < last : i > last; i += step) {
    declare(*s.variable, {static_cast<std::int64_t>(i)});
    Completion completion = execute(*s.body);
    if (completion.is(Jump::kBreak, s)) return {};
    if (!completion.is_normal() && !completion.is(Jump::kContinue, s)) return completion;
  }
  return {};
}

Completion Evaluator::for_list(const ForListStmt& s) {
  const Value items = evaluate(*s.items);
  for (std::size_t i = 0; i < items.list().items.size(); ++i) {
    declare(*s.variable, set_item(items, i, s.items->span));
    Completion completion = execute(*s.body);
    if (completion.is(Jump::kBreak, s)) return {};
    if (!completion.is_normal() && !completion.is(Jump::kContinue, s)) return completion;
  }
  return {};
}

Completion Evaluator::switch_case(const SwitchStmt& s) {
  declare(*s.subject, evaluate(*s.value));
  const SwitchCase* taken = nullptr;
  const SwitchCase* otherwise = nullptr;
  for (const SwitchCase& c : s.cases) {
    if (c.is_default) otherwise = &c;
    for (const Expr* test : c.tests) {
      if (taken == nullptr && evaluate(*test).truth()) taken = &c;
    }
  }
  if (taken == nullptr) taken = otherwise;
  if (taken == nullptr || taken->body == nullptr) return {};
  Completion completion = block(*taken->body);
  return completion.is(Jump::kBreak, s) ? Completion{} : completion;
}

// ---- failures and their handling

// An error that `finally` raises replaces the one being handled, but does not end a
// cancellation.
Completion Evaluator::try_catch(const TryStmt& s) {
  if (s.finally == nullptr) return attempt(s);
  const Aside aside(*this);
  Completion completion;
  std::optional<Failure> failure;
  std::optional<Raised> raised;
  try {
    completion = attempt(s);
  } catch (const Failure& thrown) {
    failure = seen(thrown);
  } catch (const Raised& thrown) {
    raised = thrown;
  }
  aside.go_back();
  Completion last;
  try {
    last = block(*s.finally);
  } catch (const Failure&) {
    if (!raised) throw;
  }
  if (!last.is_normal()) return last;
  if (failure) throw Failure(*failure);
  if (raised) throw Raised(*raised);
  return completion;
}

Completion Evaluator::attempt(const TryStmt& s) {
  const Aside aside(*this);
  int retries = 0;
  std::int64_t instant = tasks_.now_ns();
  for (;;) {
    std::optional<Failure> failure;
    try {
      return block(*s.body);
    } catch (const Failure& thrown) {
      if (s.handler == nullptr) throw;
      failure = seen(thrown);
    }
    aside.go_back();
    if (s.error != nullptr) declare(*s.error, caught(*failure));
    Completion completion = block(*s.handler);
    if (!completion.is(Jump::kRetry, s)) return completion;
    if (tasks_.now_ns() != instant) retries = 0;
    instant = tasks_.now_ns();
    if (++retries > 1000) fail("R0615", completion.where, {"1000"});
  }
}

// ---- targets of assignments

Evaluator::Variables& Evaluator::home(const Variable& v) {
  return v.storage == Storage::kGlobal ? globals_ : *locals_;
}

void Evaluator::declare(const Variable& v, Value value) {
  home(v)[&v] = std::make_shared<Value>(std::move(value));
}

// A function may run before the variable of the program that it uses has its first value.
void Evaluator::check_set(const Variable& v, Span where) {
  const bool may_be_unset = v.storage == Storage::kGlobal && v.maybe_unset;
  if (!may_be_unset) return;
  const auto found = globals_.find(&v);
  if (found == globals_.end() || found->second->absent())
    fail("R0623", where, {std::string(v.name)});
}

Evaluator::Indices Evaluator::indices(const Place& place) {
  Indices out;
  for (const Step& step : place.steps) {
    Index index;
    if (step.map != nullptr) {
      index.key = evaluate(*step.index);
    } else if (step.index != nullptr) {
      index.row = evaluate(*step.index).integer();
    }
    if (step.column != nullptr) index.column = evaluate(*step.column).integer();
    out.push_back(index);
  }
  return out;
}

Value& Evaluator::walk(const Place& place, const Indices& indices, bool makes) {
  Value* at = home(*place.variable).at(place.variable).get();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const Step& step = place.steps[i];
    if (step.is_field) {
      at = &at->record().fields[step.field];
      continue;
    }
    if (step.map != nullptr) {
      at = &step_to_entry(*at, step, indices[i].key, makes && i + 1 == indices.size());
      continue;
    }
    if (step.column != nullptr) {
      at = &cell(*at, indices[i], step.span);
      continue;
    }
    std::vector<Value>& items = at->list().items;
    const std::int64_t index = indices[i].row;
    const bool inside = index >= 0 && static_cast<std::size_t>(index) < items.size();
    if (!inside) fail_index(index, items.size(), step.span);
    at = &items[index];
    if (at->absent() && i + 1 < indices.size()) {
      const std::string name = short_text(step.span);
      const std::string list = name.substr(0, last_bracket(name));
      fail("R0623", step.span, {list + '[' + std::to_string(index) + ']'});
    }
  }
  return *at;
}

// Indexes first, then the right side, then the old value if it is needed: the right side may have
// changed the target.
void Evaluator::assign(const AssignStmt& s) {
  const Variable& variable = *s.place.variable;
  const bool is_first = s.place.steps.empty() && !s.compound && variable.init == nullptr;
  if (!is_first) check_set(variable, s.span);
  const Indices where = indices(s.place);
  Value value;
  if (s.compound) {
    value = evaluate(*s.value);
    value = calculate_at(s.op, walk(s.place, where), value, s.span);
  } else {
    value = evaluate(*s.value);
  }
  if (s.place.steps.empty()) {
    std::shared_ptr<Value>& at = home(variable)[&variable];
    if (at == nullptr) at = std::make_shared<Value>();
    *at = std::move(value);
  } else {
    walk(s.place, where, !s.compound) = std::move(value);
  }
}

}  // namespace armlet::oracle
