#include "armlet/interpreter/host/memory.hpp"

#include <new>

#if __has_include(<memory_resource>)
namespace armlet {

namespace {

constexpr std::size_t kAlignment = 16;

void* take_from(void* resource, std::size_t bytes) {
  try {
    return static_cast<std::pmr::memory_resource*>(resource)->allocate(bytes, kAlignment);
  } catch (...) {
    return nullptr;
  }
}

void give_back_to(void* resource, void* block, std::size_t bytes) {
  static_cast<std::pmr::memory_resource*>(resource)->deallocate(block, bytes, kAlignment);
}

}  // namespace

Memory memory_of(std::pmr::memory_resource& resource) {
  return {&take_from, &give_back_to, &resource};
}

}  // namespace armlet
#endif
