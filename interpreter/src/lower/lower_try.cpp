// Compiles try, catch, finally and retry, and the code that runs when a statement leaves them.

#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

static void handle(Lowering& in, const TryStmt& s);

// The code of an exit belongs to none of the tries it leaves: their ranges end before it and begin
// again behind it.
void leave(Lowering& in, std::size_t depth, const std::function<void()>& go) {
  std::vector<TryScope> left;
  while (in.ways.tries() > depth) {
    TryScope scope = in.ways.close(in.code.position());
    if (scope.finally != nullptr) block(in, *scope.finally);
    if (scope.is_watched()) in.code.emit(OpCode::ENDWATCH, scope.watches);
    left.push_back(std::move(scope));
  }
  go();
  for (; !left.empty(); left.pop_back()) {
    in.ways.reopen(std::move(left.back()), in.code.position());
  }
}

void try_catch(Lowering& in, const TryStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Label again = in.code.label();
  const Label end = in.code.label();
  JumpTargets exit{&s, end, again, in.ways.tries() + 1, {}, {}};
  if (s.handler != nullptr) {
    exit.retries = in.code.number();
    exit.instant = in.code.number();
    in.code.constant(exit.retries, slot_of(std::int64_t{0}));
  }
  const bool alive = in.code.reachable();
  in.code.bind_loop(again, alive);
  in.ways.open({s.finally, {}, s.handler != nullptr, in.code.position(), {}, {}});
  block(in, *s.body);
  leave(in, in.ways.tries() - 1, [&] { in.code.jump(end); });
  if (s.handler != nullptr) {
    in.ways.begin(exit);
    handle(in, s);
    in.ways.end();
    leave(in, in.ways.tries() - 1, [&] { in.code.jump(end); });
  }
  const TryScope scope = in.ways.close(in.code.position());
  if (s.finally != nullptr) {
    in.code.begin_handler(scope.finals, true);
    const Reg failure = in.code.reference();
    in.code.at(s.finally->span);
    in.code.emit(OpCode::HOLD, failure);
    const std::uint32_t begin = in.code.position();
    block(in, *s.finally);
    in.code.finally_code(begin, failure);
    in.code.emit(OpCode::RETHROW, failure);
  }
  in.code.bind(end);
  in.code.release(mark);
}

// The catch block: this try does not catch failures in it, but its finally block runs after them.
static void handle(Lowering& in, const TryStmt& s) {
  in.code.begin_handler(in.ways.begin_handler(in.code.position()), false);
  const Emitter::Mark mark = in.code.mark();
  const Reg error = in.code.reference();
  in.code.at(s.handler->span);
  in.code.emit(OpCode::CATCH, error);
  const Homes::Point point{in.homes.count(), in.code.position()};
  if (s.error != nullptr && s.error->storage == Storage::kLocal) {
    in.homes.give(*s.error, error);
  } else if (s.error != nullptr) {
    init_from(in, *s.error, error);
  }
  block(in, *s.handler);
  in.homes.close(point, s.handler->span, in.code.position());
  in.code.release(mark);
}

void check_throws(Lowering& in, const AssertThrowsStmt& s) {
  const Emitter::Mark mark = in.code.mark();
  const Reg kind =
      s.kind_text == nullptr ? null_reference(in) : borrow(in, *s.kind_text, Hold::kOwn);
  const Reg error = in.code.reference();
  const Label end = in.code.label();
  in.code.emit(OpCode::DROP, error);
  in.ways.open({nullptr, {}, true, in.code.position(), {}, {}});
  effect(in, *s.call);
  const TryScope scope = in.ways.close(in.code.position());
  in.code.jump(end);
  in.code.begin_handler(scope.caught, false);
  in.code.emit(OpCode::CATCH, error);
  in.code.bind(end);
  in.code.at(s.call_span, s.call);
  in.code.push(OpCode::EXPECTERR, in.tables.add_expect(s), error.bits, kind.bits);
  in.code.release(mark);
}

}  // namespace armlet::lang
