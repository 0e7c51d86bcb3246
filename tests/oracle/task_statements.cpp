// Statements that take time or start tasks (reference, section 12).

#include <algorithm>
#include <cmath>

#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

using namespace lang::hir;

void Evaluator::time_and_tasks(const Stmt& s) {
  switch (s.kind) {
    case StmtKind::kWait:
      return wait(s.as<WaitStmt>());
    case StmtKind::kWaitUntil:
      return wait_until(s.as<WaitUntilStmt>());
    case StmtKind::kParallel:
      return parallel(s.as<ParallelStmt>());
    case StmtKind::kWhen:
      return when(s.as<WhenStmt>());
    case StmtKind::kEvery:
      return every(s.as<EveryStmt>());
    default:
      throw std::logic_error("the oracle has no such statement: " + text(s.span));
  }
}

// A time that ends before virtual time does, a hundred years after the start.
std::int64_t Evaluator::nanoseconds(double seconds, const Type& type, Span where,
                                    const TimeNames& names) const {
  constexpr std::int64_t kEnd = 100LL * 36525 * 86400 * 10'000'000;
  if (!std::isfinite(seconds)) fail("R0612", where, {names.time, show_number(seconds)});
  const double left = static_cast<double>(kEnd - tasks_.now_ns()) * 1e-9;
  if (seconds > left)
    fail("R0636", where, {names.what + " of " + show({seconds}, type), show({left}, type)});
  if (seconds < 0.0) fail("R0609", where, {names.what, show({seconds}, type), names.too_short});
  return std::llround(seconds * 1e9);
}

// Functions of the library cannot wait for functions of the text.
void Evaluator::refuse_to_pause(Span where) const {
  if (host_calls_ == 0) return;
  const std::string written = text(where);
  fail("R0632", where, {written.size() <= 40 ? "`" + written + "`" : "this", "wait or move"});
}

void Evaluator::wait(const WaitStmt& s) {
  const double seconds = evaluate(*s.duration).real();
  refuse_to_pause(s.duration->span);
  const std::int64_t ns =
      nanoseconds(seconds, *s.duration->type, s.duration->span, {"a wait", "the time to wait"});
  const Aside aside(*this);
  tasks_.sleep(ns);
}

void Evaluator::wait_until(const WaitUntilStmt& s) {
  Tasks::Condition condition = condition_of(*s.condition);
  const std::optional<Value> timeout =
      s.timeout == nullptr ? std::nullopt : std::optional(evaluate(*s.timeout));
  refuse_to_pause(s.condition_span);
  std::optional<std::int64_t> ns;
  if (timeout) {
    ns = nanoseconds(timeout->real(), *s.timeout->type, s.condition_span,
                     {"a timeout", "the time to wait"});
  }
  const Aside aside(*this);
  if (tasks_.wait_until(std::move(condition), ns)) return;
  fail("R0607", s.condition_span,
       {show(*timeout, *s.timeout->type), std::string(s.condition_text)});
}

void Evaluator::parallel(const ParallelStmt& s) {
  std::vector<Tasks::Body> branches;
  for (const Expr* branch : s.branches) {
    branches.push_back(body_of(*branch));
    refuse_to_pause(branch->span);
  }
  if (branches.empty()) return;
  const Aside aside(*this);
  tasks_.parallel(std::move(branches));
}

void Evaluator::when(const WhenStmt& s) {
  Tasks::Condition condition = condition_of(*s.condition);
  tasks_.watch(std::move(condition), body_of(*s.body));
}

void Evaluator::every(const EveryStmt& s) {
  const double seconds = evaluate(*s.period).real();
  Tasks::Body body = body_of(*s.body);
  const std::int64_t ns = nanoseconds(
      seconds, *s.period->type, s.head,
      {"a beat", "the time between two beats", "the time between two beats must be at least 1 ns"});
  if (ns == 0) {
    fail("R0609", s.head,
         {"a beat", show({seconds}, *s.period->type),
          "the time between two beats must be at least 1 ns"});
  }
  tasks_.watch(ns, std::move(body));
}

Completion Evaluator::watched(const Block& s) {
  const auto first = std::ranges::find_if(s.body, [](const Stmt* inner) {
    return inner->kind == StmtKind::kWhen || inner->kind == StmtKind::kEvery;
  });
  const Stmt& head = **first;
  refuse_to_pause(head.kind == StmtKind::kWhen ? head.as<WhenStmt>().head
                                               : head.as<EveryStmt>().head);
  const Aside aside(*this);
  const std::size_t level = tasks_.open_block();
  Completion completion;
  std::optional<Failure> failure;
  std::optional<Raised> raised;
  try {
    completion = sequence(s);
  } catch (const Failure& thrown) {
    failure = seen(thrown);
  } catch (const Raised& thrown) {
    raised = thrown;
    // Of a watch of this block: from here on it is an error like any other.
    if (raised->level == level) failure = std::exchange(raised, {})->failure;
  }
  aside.go_back();
  tasks_.close_block(failure || raised);
  if (failure) throw Failure(*failure);
  if (raised) throw Raised(*raised);
  return completion;
}

// A task begins with nothing but what it shares with the text around it.
Tasks::Body Evaluator::body_of(const Expr& e) {
  return [this, closure = evaluate(e).closure(), where = e.span] {
    calls_ = host_calls_ = 0;
    try {
      (void)call(*closure.function, {}, closure.captures, where, 0);
    } catch (const Failure& failure) {
      throw Failure(seen(failure));
    }
  };
}

// A condition is called from outside of the program.
Tasks::Condition Evaluator::condition_of(const Expr& e) {
  return [this, closure = evaluate(e).closure(), where = e.span] {
    const Aside aside(*this);
    calls_ = 0;
    host_calls_ = 1;
    try {
      return call(*closure.function, {}, closure.captures, where).truth();
    } catch (const Failure& failure) {
      throw Failure(seen(failure));
    }
  };
}

}  // namespace armlet::oracle
