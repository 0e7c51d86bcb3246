#pragma once
// Terms of the rules: destinations of values, and how long a borrowed reference has to stay valid.

#include <functional>
#include <vector>

#include "hir/hir.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

// The destination of a number.
struct Dest {
  Reg reg;
  bool early;  // may be written before the whole expression has been evaluated
};

// The span and the expression of the text that an instruction belongs to.
struct Site {
  Span span;
  const hir::Expr* expr;
};

// The step of a range.
struct RangeStep {
  std::int64_t by = 1;  // 0: known at run time only, in `reg`
  Reg reg;
};

// What happens if an assignment target ends with a key that the map does not have.
enum class Missing : std::uint8_t { kFails, kIsMade };

// How long a borrowed reference has to stay valid.
enum class Hold : std::uint8_t {
  kNow,   // until the next instruction that uses it; no other code runs before
  kCall,  // other code of the program may run, but this function changes none of its variables
  kOwn,   // this function itself may change the variable: count it
};
[[nodiscard]] Hold stronger(Hold a, Hold b);
// Whether the expression is a product a * b of doubles whose value is not known at compile time.
[[nodiscard]] bool is_product(const hir::Expr& e);

// The registers with the index of each step of an assignment target; unused for fields.
struct StepIndex {
  Reg index;
  Reg column;  // elements of matrices
};
using Indices = std::vector<StepIndex>;

// Emits the code of one iteration of a loop.
using Pass = std::function<void()>;

// The right side of a compound assignment, or the two factors of a product on the right side.
struct Addend {
  bool is_evaluated = false;
  bool is_product = false;
  Reg first;
  Reg second;
};

// The instruction of an operator on numbers. For a > b and a >= b it is that of b < a and b <= a:
// the caller exchanges the operands.
[[nodiscard]] OpCode arithmetic_instruction(hir::Op op);

}  // namespace armlet::lang
