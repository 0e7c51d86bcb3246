#pragma once
// A stack of known size for work that calls itself as deep as a program is nested.

#include <cstddef>
#include <functional>

namespace armlet {

// What the deepest program that the limits allow needs, with reserve, and the size of the stack
// that it gets where less is left.
inline constexpr std::size_t kAmpleStack = std::size_t{4} << 20U;
inline constexpr std::size_t kOwnStack = std::size_t{64} << 20U;

// Bytes that are left of the present stack; 0 if its bounds are not known.
[[nodiscard]] std::size_t stack_left();

// Runs `work` in this thread on a stack of its own, whose pages get memory when they are first
// touched. What `work` throws is thrown here.
//
// throws  std::bad_alloc if the system has no addresses for another stack.
void on_own_stack(const std::function<void()>& work);

// The same on the present stack if kAmpleStack bytes of it are left.
template <class Work>
void on_ample_stack(const Work& work) {
  if (stack_left() >= kAmpleStack) {
    work();
  } else {
    on_own_stack([&work] { work(); });
  }
}

}  // namespace armlet
