// A platform with only a C++ library: one thread, no libraries to load, and memory that is
// allocated when it is reserved.
#include "armlet/core/platform.hpp"

#include <chrono>
#include <new>
#include <system_error>

#include "armlet/core/ample_stack.hpp"

namespace armlet {

ReservedMemory::ReservedMemory(std::size_t bytes) : begin_(::operator new(bytes)), bytes_(bytes) {}
ReservedMemory::~ReservedMemory() { ::operator delete(begin_); }
void ReservedMemory::give_back(std::size_t) {}

bool reserves_for_free() { return false; }

std::int64_t steady_time_ns() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

void yield_thread() {}

struct Alarm::State {};

Alarm::Alarm(std::int64_t, std::function<void()>) {
  throw std::system_error(std::make_error_code(std::errc::function_not_supported),
                          "There is one thread here; run the program in slices and look at the "
                          "clock between two of them");
}
Alarm::~Alarm() = default;

LoadedLibrary::LoadedLibrary(const std::string&) : handle_(nullptr) {}
void* LoadedLibrary::find(const char*) const { return nullptr; }

std::string program_folder() { return {}; }

// There is only one stack, and its free size cannot be determined, so a host limits the nesting.
std::size_t stack_left() { return 0; }
void on_own_stack(const std::function<void()>& work) { work(); }

}  // namespace armlet
