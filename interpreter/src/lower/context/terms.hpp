#pragma once
// How the rules say where a value goes and how long a borrowed one stays good.

#include <functional>
#include <vector>

#include "hir/hir.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

// Where a number shall go.
struct Dest {
  Reg reg;
  bool early;  // may be written before the whole expression has been evaluated
};

// What an instruction belongs to in the text.
struct Site {
  Span span;
  const hir::Expr* expr;
};

// The step of a range.
struct RangeStep {
  std::int64_t by = 1;  // 0: known only while running, in `reg`
  Reg reg;
};

// The entry of a map that a place ends with.
enum class Missing : std::uint8_t { kFails, kIsMade };

// How long a borrowed reference must stay good.
enum class Hold : std::uint8_t {
  kNow,   // nothing else runs until it is used
  kCall,  // other code of the program may run, but this function changes none of its variables
  kOwn,   // this function itself may change the variable: count it
};
[[nodiscard]] Hold stronger(Hold a, Hold b);
// a * b of doubles, not known before running.
[[nodiscard]] bool is_product(const hir::Expr& e);

// By step of a place; unused for fields.
struct StepIndex {
  Reg index;
  Reg column;  // elements of matrices
};
using Indices = std::vector<StepIndex>;

// What a loop does in each pass.
using Pass = std::function<void()>;

// The right side of a compound assignment, or the two factors of it.
struct Addend {
  bool is_evaluated = false;
  bool is_product = false;
  Reg first;
  Reg second;
};

// The instruction of an operator on numbers; comparisons the wrong way round are turned by the
// caller.
[[nodiscard]] OpCode arithmetic_instruction(hir::Op op);

}  // namespace armlet::lang
