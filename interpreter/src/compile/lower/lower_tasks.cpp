// parallel; and blocks that hold a `when` or `every`, which watch until the block is left.

#include <algorithm>

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

Span head_of(const Stmt& s) {
  return s.kind == StmtKind::kWhen ? s.as<WhenStmt>().head : s.as<EveryStmt>().head;
}

}  // namespace

void Lowering::parallel(const ParallelStmt& s) {
  std::uint32_t index = 0;
  for (const Expr* branch : s.branches) {
    const Emitter::Mark mark = code_.mark();
    const Reg task = borrow(*branch, Hold::kNow);
    code_.at(branch->span, branch);
    code_.push(OpCode::SPAWN, task.bits, 0, index++);
    code_.release(mark);
  }
  code_.at(s.word);
  if (!s.branches.empty()) code_.emit(OpCode::PARALLEL);
}

bool Lowering::starts_watching(const Stmt* s) {
  return s->kind == StmtKind::kWhen || s->kind == StmtKind::kEvery;
}

// Every way out of the block ends its watches: like a finally block, written by nobody.
void Lowering::watched_block(Seq<Stmt*> body) {
  const auto first = std::ranges::find_if(body, starts_watching);
  const Span head = head_of(**first);
  const Label end = code_.label();
  const Reg watches = code_.pinned();
  code_.at(head);
  code_.emit(OpCode::OPENWATCH, watches);
  tries_.push_back({nullptr, watches, false, code_.position(), {}, {}});
  for (const Stmt* s : body) statement(*s);
  code_.at(head);
  leave(tries_.size() - 1, [&] { code_.jump(end); });
  const TryScope scope = pop_try();
  code_.begin_handler(scope.finals, true);
  const Reg failure = code_.reference();
  code_.at(head);
  code_.emit(OpCode::HOLD, failure);
  const std::uint32_t begin = code_.position();
  code_.emit(OpCode::STOPWATCH, watches, failure);
  code_.finally_code(begin, failure);
  code_.emit(OpCode::RETHROW, failure);
  code_.bind(end);
}

void Lowering::when(const WhenStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Reg condition = borrow(*s.condition, Hold::kOwn);
  const Reg body = borrow(*s.body, Hold::kNow);
  code_.at(s.head, s.condition);
  code_.emit(OpCode::WATCHWHEN, condition, body);
  code_.release(mark);
}

void Lowering::every(const EveryStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Reg period = value(*s.period);
  const Reg body = borrow(*s.body, Hold::kNow);
  code_.at(s.head, s.period);
  code_.emit(OpCode::WATCHEVERY, period, body);
  code_.release(mark);
}

}  // namespace armlet::lang
