// try, catch, finally, retry; and what has to be done on the way out of them.

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

void Lowering::close(TryScope& scope) {
  const Emitter::Range range{scope.begin, code_.position()};
  if (scope.catching) scope.caught.push_back(range);
  if (scope.has_end()) scope.finals.push_back(range);
}

Lowering::TryScope Lowering::pop_try() {
  TryScope scope = std::move(tries_.back());
  tries_.pop_back();
  close(scope);
  return scope;
}

bool Lowering::finally_runs() const {
  for (const TryScope& scope : tries_) {
    if (scope.has_end()) return true;
  }
  return false;
}

// Code on the way out belongs to none of the tries it leaves: their ranges stop here and go on
// behind it.
void Lowering::leave(std::size_t depth, const std::function<void()>& go) {
  std::vector<TryScope> left;
  while (tries_.size() > depth) {
    TryScope scope = pop_try();
    if (scope.finally != nullptr) block(*scope.finally);
    if (scope.is_watched()) code_.emit(OpCode::ENDWATCH, scope.watches);
    left.push_back(std::move(scope));
  }
  go();
  for (; !left.empty(); left.pop_back()) {
    left.back().begin = code_.position();
    tries_.push_back(std::move(left.back()));
  }
}

void Lowering::try_catch(const TryStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Label again = code_.label();
  const Label end = code_.label();
  Exit exit{&s, end, again, tries_.size() + 1, {}, {}};
  if (s.handler != nullptr) {
    exit.retries = code_.number();
    exit.instant = code_.number();
    code_.constant(exit.retries, slot_of(std::int64_t{0}));
  }
  const bool alive = code_.reachable();
  code_.bind_loop(again, alive);
  tries_.push_back({s.finally, {}, s.handler != nullptr, code_.position(), {}, {}});
  block(*s.body);
  leave(tries_.size() - 1, [&] { code_.jump(end); });
  if (s.handler != nullptr) {
    exits_.push_back(exit);
    handle(s);
    exits_.pop_back();
    leave(tries_.size() - 1, [&] { code_.jump(end); });
  }
  const TryScope scope = pop_try();
  if (s.finally != nullptr) {
    code_.begin_handler(scope.finals, true);
    const Reg failure = code_.reference();
    code_.at(s.finally->span);
    code_.emit(OpCode::HOLD, failure);
    const std::uint32_t begin = code_.position();
    block(*s.finally);
    code_.finally_code(begin, failure);
    code_.emit(OpCode::RETHROW, failure);
  }
  code_.bind(end);
  code_.release(mark);
}

// The catch block: failures in it are no longer caught here, but what is done finally still is.
void Lowering::handle(const TryStmt& s) {
  TryScope& scope = tries_.back();
  scope.catching = false;
  scope.begin = code_.position();
  code_.begin_handler(scope.caught, false);
  const Emitter::Mark mark = code_.mark();
  const Reg error = code_.reference();
  code_.at(s.handler->span);
  code_.emit(OpCode::CATCH, error);
  if (s.error != nullptr && s.error->storage == Storage::kLocal) {
    s.error->index = error.bits;
  } else if (s.error != nullptr) {
    init_from(*s.error, error);
  }
  block(*s.handler);
  code_.release(mark);
}

void Lowering::check_throws(const AssertThrowsStmt& s) {
  const Emitter::Mark mark = code_.mark();
  const Reg kind = s.kind_text == nullptr ? null_reference() : borrow(*s.kind_text, Hold::kOwn);
  const Reg error = code_.reference();
  const Label end = code_.label();
  code_.emit(OpCode::DROP, error);
  tries_.push_back({nullptr, {}, true, code_.position(), {}, {}});
  effect(*s.call);
  const TryScope scope = pop_try();
  code_.jump(end);
  code_.begin_handler(scope.caught, false);
  code_.emit(OpCode::CATCH, error);
  code_.bind(end);
  code_.at(s.call_span, s.call);
  code_.push(OpCode::EXPECTERR, tables_.add_expect(s), error.bits, kind.bits);
  code_.release(mark);
}

}  // namespace armlet::lang
