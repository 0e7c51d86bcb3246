#pragma once
// A stack of known size for recursion as deep as a program is nested.

#include <cstddef>
#include <functional>

namespace armlet {

// The stack size that the deepest allowed program needs, with a reserve; a stack of this size is
// made where less is left.
inline constexpr std::size_t kAmpleStack = std::size_t{4} << 20U;
inline constexpr std::size_t kOwnStack = std::size_t{64} << 20U;

// Bytes that are left of the present stack; 0 if its bounds are not known.
[[nodiscard]] std::size_t stack_left();

// Runs `work` in this thread on a new stack, whose pages get memory when they are first used.
// Exceptions of `work` are passed on.
//
// throws  std::bad_alloc if the system has no addresses for another stack.
void on_own_stack(const std::function<void()>& work);

// Runs `work` on the present stack if kAmpleStack bytes of it are left, else like on_own_stack.
template <class Work>
void on_ample_stack(const Work& work) {
  if (stack_left() >= kAmpleStack) {
    work();
  } else {
    on_own_stack([&work] { work(); });
  }
}

}  // namespace armlet
