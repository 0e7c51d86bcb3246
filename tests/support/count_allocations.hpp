#pragma once
// Counts what the whole program allocates, because operators cannot be replaced for a part of it:
// for one source of a test program.

#include <cstdlib>
#include <new>

namespace {

long allocations = 0;

}  // namespace

// Inlined, g++ 12 takes new and free for a pair that does not match.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
// Sorting asks for its buffer in this form; all forms must fit to the same free.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
