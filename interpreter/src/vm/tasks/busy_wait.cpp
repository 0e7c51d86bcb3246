#include "vm/tasks/busy_wait.hpp"

#include <string>

#include "hir/walk.hpp"
#include "vm/failures/failures.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kLongText = 60;

bool contains(Span outer, Span inner) {
  return outer.source == inner.source && outer.begin <= inner.begin && inner.end <= outer.end;
}

// The innermost loop with a condition around a span. Bodies of nested functions are not searched.
const hir::LoopStmt* loop_around(const hir::Stmt& stmt, Span span) {
  const hir::LoopStmt* found = nullptr;
  const auto look_inside = [&](const hir::Stmt& inner) {
    if (!contains(inner.span, span)) return;
    if (const hir::LoopStmt* deeper = loop_around(inner, span)) found = deeper;
  };
  for_each_child(
      stmt, [](const hir::Expr&) {}, look_inside);
  if (found != nullptr || stmt.kind != hir::StmtKind::kLoop) return found;
  const auto& loop = stmt.as<hir::LoopStmt>();
  const bool waits_for_something = loop.condition != nullptr &&
                                   loop.condition->constant == nullptr &&
                                   loop.condition->kind != hir::ExprKind::kBool;
  return waits_for_something ? &loop : nullptr;
}

// The text of the condition that ends a loop with the given condition.
std::string negated(const VmState& state, const hir::Expr& condition) {
  if (condition.kind == hir::ExprKind::kUnary) {
    const auto& unary = condition.as<hir::UnaryExpr>();
    if (unary.op == hir::Op::kNot) return source_text(state, unary.operand->span);
  }
  return "!(" + source_text(state, condition.span) + ")";
}

std::string fix_of(const VmState& state, const CodeSpan* at) {
  const Frame& frame = *state.running->stack.top;
  const hir::Function* function = frame.is_host() ? nullptr : frame.callee->function->function;
  if (at != nullptr && function != nullptr && function->body != nullptr) {
    if (const hir::LoopStmt* loop = loop_around(*function->body, at->span)) {
      const std::string until = negated(state, *loop->condition);
      if (until.size() <= kLongText && until.find('\n') == std::string::npos)
        return "write `wait until " + until + "`, or wait for some time in each pass";
    }
  }
  return "write `wait until` with what the loop waits for, or wait for some time in each pass";
}

}  // namespace

void count_wait(Task& task, std::int64_t now_ns) {
  if (task.waits.at_ns != now_ns) task.waits = {.at_ns = now_ns};
  ++task.waits.count;
}

Task* find_busy_task(VmState& state, int waits) {
  const std::int64_t now = state.vm.timeline().now_ns();
  const auto is_busy = [&](const Task& task) {
    return !task.has_ended && task.waiting != nullptr && task.interrupted == nullptr &&
           task.waits.at_ns == now && task.waits.count >= waits;
  };
  if (is_busy(state.main)) return &state.main;
  for (const auto& task : state.tree.all()) {
    if (is_busy(*task)) return task.get();
  }
  return nullptr;
}

void raise_busy_wait(VmState& state, Task& task, int rounds) {
  state.running = &task;
  const CodeSpan* at = code_span(state);
  std::string text = at == nullptr ? "" : source_text(state, at->span);
  const bool is_short = !text.empty() && text.size() <= kLongText && text.find('\n') == text.npos;
  Diagnostic failure = start_failure(
      state,
      {"R0647", {is_short ? "`" + text + "`" : "what it waits for", std::to_string(rounds)}});
  failure.why =
      "what takes no time lets other tasks have their turn, but the clock goes on only when all of "
      "them wait for something later";
  failure.fix = Fix{fix_of(state, at), {}, Confidence::kMaybe};
  task.waits = {};
  raise(state, std::move(failure));
}

}  // namespace armlet::lang
