#pragma once
// The blocks around the statement that is compiled, and the exits from them: break, continue,
// retry, return, and failures.

#include <vector>

#include "hir/hir.hpp"
#include "lower/context/emitter.hpp"
#include "lower/context/terms.hpp"

namespace armlet::lang {

// The targets of `break`, `continue` and `retry`.
struct JumpTargets {
  const hir::Stmt* target;
  Label leave;           // break
  Label again;           // continue, retry
  std::size_t tries;     // count of tries around it
  Reg retries, instant;  // for RETRY
};

struct TryScope {
  const hir::Block* finally;  // null: none
  Reg watches;          // register of the watches of a block with `when` or `every`; no bits: none
  bool catching;        // failures here go to a handler
  std::uint32_t begin;  // of the range of code that is open
  std::vector<Emitter::Range> caught;
  std::vector<Emitter::Range> finals;
  [[nodiscard]] bool is_watched() const { return watches.bits != 0; }
  [[nodiscard]] bool has_end() const { return finally != nullptr || is_watched(); }
};

// A call that is inlined.
struct Expansion {
  Dest to;    // its result
  Label end;  // the end of the inlined code, where `return` jumps to
};

class WaysOut {
 public:
  // ---- loops, switches, tries with a handler
  void begin(JumpTargets exit) { exits_.push_back(exit); }
  void end() { exits_.pop_back(); }
  [[nodiscard]] const JumpTargets& innermost() const { return exits_.back(); }
  [[nodiscard]] JumpTargets to(const hir::Stmt* target) const;

  // ---- tries and watched blocks
  [[nodiscard]] std::size_t tries() const { return tries_.size(); }
  void open(TryScope scope) { tries_.push_back(std::move(scope)); }
  // Ends the innermost try at this position, at the end of its code or for an exit from it.
  [[nodiscard]] TryScope close(std::uint32_t position);
  // Continues a try behind the code of an exit.
  void reopen(TryScope scope, std::uint32_t position);
  // Begins the handler of the innermost try, in which failures are not caught again. Returns the
  // ranges of code whose failures the handler catches.
  [[nodiscard]] const std::vector<Emitter::Range>& begin_handler(std::uint32_t position);
  [[nodiscard]] bool finally_runs() const;

  // ---- functions in place of their calls
  void begin(Expansion expansion) { expansions_.push_back(expansion); }
  void end_expansion() { expansions_.pop_back(); }
  [[nodiscard]] bool is_expanding() const { return !expansions_.empty(); }
  [[nodiscard]] Expansion expansion() const { return expansions_.back(); }

 private:
  std::vector<JumpTargets> exits_;
  std::vector<TryScope> tries_;
  std::vector<Expansion> expansions_;  // the innermost last
};

}  // namespace armlet::lang
