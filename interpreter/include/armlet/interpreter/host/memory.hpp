#pragma once
// Memory of the host for the values of a program.

#include <cstddef>
#if __has_include(<memory_resource>)
#include <memory_resource>
#endif

namespace armlet {

// The source of the memory for the values of a Vm: texts, lists, matrices, records and others. The
// Vm takes large blocks, divides them, and returns all of them when it is destroyed. The functions
// are called by the thread that runs the program and must not throw.
struct Memory {
  // Returns `bytes` bytes aligned to 16 bytes; null if there are none, which is a failure of the
  // program (R0628).
  void* (*take)(void* context, std::size_t bytes) = nullptr;  // null: the memory of the C library
  // Returns a block; `bytes` is the size with which it was taken.
  void (*give_back)(void* context, void* block, std::size_t bytes) = nullptr;
  void* context = nullptr;
};

// The memory of a std::pmr::memory_resource, which must outlive the Vms. An exception of the
// resource counts as no memory.
#if __has_include(<memory_resource>)
[[nodiscard]] Memory memory_of(std::pmr::memory_resource& resource);
#endif

}  // namespace armlet
