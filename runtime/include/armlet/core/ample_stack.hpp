#pragma once
// A stack of known size for work that calls itself as deep as a program is nested.

#include <cstddef>
#include <functional>

namespace armlet {

// What the deepest program that the limits allow needs, with reserve, and the size of the stack
// that it gets where less is left.
inline constexpr std::size_t kAmpleStack = std::size_t{4} << 20U;
inline constexpr std::size_t kOwnStack = std::size_t{64} << 20U;

// Runs `work` in this thread: on the present stack if kAmpleStack bytes of it are left, otherwise
// on one of its own, whose pages get memory when they are first touched. What `work` throws is
// thrown here.
//
// throws  std::bad_alloc if the system has no addresses for another stack.
void on_ample_stack(const std::function<void()>& work);

// Bytes that are left of the present stack; 0 if its bounds are not known.
[[nodiscard]] std::size_t stack_left();

}  // namespace armlet
