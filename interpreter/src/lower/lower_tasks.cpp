// Compiles `parallel`, and blocks that contain `when` or `every`, whose watches end with the block.

#include <algorithm>

#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

Span head_of(const Stmt& s) {
  return s.kind == StmtKind::kWhen ? s.as<WhenStmt>().head : s.as<EveryStmt>().head;
}

}  // namespace

void parallel(Lowering& in, const ParallelStmt& s) {
  std::uint32_t index = 0;
  for (const Expr* branch : s.branches) {
    const Emitter::Mark mark = in.code.mark();
    const Reg task = borrow(in, *branch, Hold::kNow);
    in.code.at(branch->span, branch);
    in.code.push(OpCode::SPAWN, task.bits, 0, index++);
    in.code.release(mark);
  }
  in.code.at(s.word);
  if (!s.branches.empty()) in.code.emit(OpCode::PARALLEL);
}

bool starts_watching(const Stmt* s) {
  return s->kind == StmtKind::kWhen || s->kind == StmtKind::kEvery;
}

// Every exit from the block ends its watches, as a finally block would.
void watched_block(Lowering& in, Seq<const Stmt* const> body) {
  const auto first = std::ranges::find_if(body, starts_watching);
  const Span head = head_of(**first);
  const Label end = in.code.label();
  const Reg watches = in.code.pinned();
  in.code.at(head);
  in.code.emit(OpCode::OPENWATCH, watches);
  in.ways.open({nullptr, watches, false, in.code.position(), {}, {}});
  for (const Stmt* s : body) statement(in, *s);
  in.code.at(head);
  leave(in, in.ways.tries() - 1, [&] { in.code.jump(end); });
  const TryScope scope = in.ways.close(in.code.position());
  in.code.begin_handler(scope.finals, true);
  const Reg failure = in.code.reference();
  in.code.at(head);
  in.code.emit(OpCode::HOLD, failure);
  const std::uint32_t begin = in.code.position();
  in.code.emit(OpCode::STOPWATCH, watches, failure);
  in.code.finally_code(begin, failure);
  in.code.emit(OpCode::RETHROW, failure);
  in.code.bind(end);
}

void when(Lowering& in, const WhenStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Reg condition = borrow(in, *s.condition, Hold::kOwn);
  const Reg body = borrow(in, *s.body, Hold::kNow);
  in.code.at(s.head, s.condition);
  in.code.emit(OpCode::WATCHWHEN, condition, body);
  in.code.release(mark);
}

void every(Lowering& in, const EveryStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Reg period = value(in, *s.period);
  const Reg body = borrow(in, *s.body, Hold::kNow);
  in.code.at(s.head, s.period);
  in.code.emit(OpCode::WATCHEVERY, period, body);
  in.code.release(mark);
}

}  // namespace armlet::lang
