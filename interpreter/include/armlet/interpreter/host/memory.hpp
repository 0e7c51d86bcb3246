#pragma once
// Memory of the host for the values of a program.

#include <cstddef>
#if __has_include(<memory_resource>)
#include <memory_resource>
#endif

namespace armlet {

// Where a Vm takes the memory of its values from: texts, lists, matrices, records and so on, in
// large pieces which it divides. Everything is given back when the Vm goes. The functions are
// called by the thread that runs the program and throw nothing.
struct Memory {
  // `bytes` aligned to 16 bytes; null if there is none, which the program hears of (R0628).
  void* (*take)(void* context, std::size_t bytes) = nullptr;  // null: the memory of the C library
  // `bytes` as it was taken.
  void (*give_back)(void* context, void* block, std::size_t bytes) = nullptr;
  void* context = nullptr;
};

// That of a memory resource, which outlives the Vms. One that throws has none.
#if __has_include(<memory_resource>)
[[nodiscard]] Memory memory_of(std::pmr::memory_resource& resource);
#endif

}  // namespace armlet
