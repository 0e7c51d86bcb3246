#pragma once
// What stands around the statement that is being lowered, and where its ways out lead: break,
// continue, retry, return, and failures.

#include <vector>

#include "hir/hir.hpp"
#include "lower/context/emitter.hpp"
#include "lower/context/terms.hpp"

namespace armlet::lang {

// What `break`, `continue` and `retry` go to.
struct JumpTargets {
  const hir::Stmt* target;
  Label leave;           // break
  Label again;           // continue, retry
  std::size_t tries;     // how many tries are around it
  Reg retries, instant;  // for RETRY
};

struct TryScope {
  const hir::Block* finally;  // null: none
  Reg watches;                // of a watched block; no bits: there are none
  bool catching;              // failures here go to a handler
  std::uint32_t begin;        // of the range that is open
  std::vector<Emitter::Range> caught;
  std::vector<Emitter::Range> finals;
  [[nodiscard]] bool is_watched() const { return watches.bits != 0; }
  [[nodiscard]] bool has_end() const { return finally != nullptr || is_watched(); }
};

// A function that stands in place of its call.
struct Expansion {
  Dest to;    // its result
  Label end;  // where it returns to
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
  // The innermost one ends here, or is left on a way out.
  [[nodiscard]] TryScope close(std::uint32_t position);
  // It goes on here.
  void reopen(TryScope scope, std::uint32_t position);
  // Its handler begins here: failures are no longer caught. The ranges where they were.
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
