#pragma once
// What the operating system has to provide, besides files (files.hpp) and deep stacks
// (ample_stack.hpp): memory with fixed addresses, elapsed time outside of programs, threads,
// libraries loaded at run time. All other code uses the C++ library alone, so a new platform is a
// folder beside runtime/src/core/posix; the smallest one, bare, is that of WebAssembly.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace armlet {

// Bytes with fixed addresses, meant to be reserved long before they are used: where the system
// supports it, a page gets memory only when it is first used. Bytes that were not written are
// unspecified.
class ReservedMemory {
 public:
  // throws  std::bad_alloc if the system has no addresses left.
  explicit ReservedMemory(std::size_t bytes);
  ~ReservedMemory();
  ReservedMemory(const ReservedMemory&) = delete;
  ReservedMemory& operator=(const ReservedMemory&) = delete;

  [[nodiscard]] void* begin() const { return begin_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  // The bytes after the first `first` are not needed for now: their memory may return to the
  // system.
  void give_back(std::size_t first);

 private:
  void* begin_;
  std::size_t bytes_;
};

// Whether a reservation may be much larger than what is used. If not, a reservation takes its bytes
// from scarce memory.
[[nodiscard]] bool reserves_for_free();

// Time of a monotonic clock, ns since an unspecified moment.
[[nodiscard]] std::int64_t steady_time_ns();

// Lets other threads run; for waiting loops.
void yield_thread();

// Calls a function in a thread of its own after a time, counted from now. If it is destroyed
// earlier, there is no call; if it is destroyed during the call, it waits for its end.
class Alarm {
 public:
  // throws  std::system_error if there are no threads: a host then runs its programs in slices, and
  //         reads the clock between two of them.
  Alarm(std::int64_t after_ns, std::function<void()> call);
  ~Alarm();
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A library that is loaded at run time and stays loaded until the process ends.
class LoadedLibrary {
 public:
  explicit LoadedLibrary(const std::string& name);
  // Null if there is no such library, or no such symbol in it.
  [[nodiscard]] void* find(const char* symbol) const;

 private:
  void* handle_;
};

// The folder of the running executable, without a slash at its end; empty if there is none.
[[nodiscard]] std::string program_folder();

}  // namespace armlet
