#pragma once
// What a machine and its system have to provide, besides files (files.hpp) and deep stacks
// (ample_stack.hpp): memory that keeps its addresses, time that passes outside of programs, other
// threads, libraries loaded while running. Whatever else is in the libraries asks the C++ library
// alone, so that a new platform is a folder beside runtime/src/core/posix; the smallest one, bare,
// is that of WebAssembly.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace armlet {

// Bytes whose addresses do not change, meant to be reserved long before they are used: where the
// system can do so, a page gets memory only when it is first touched. What is read before it is
// written is not specified.
class ReservedMemory {
 public:
  // throws  std::bad_alloc if the system has no addresses left.
  explicit ReservedMemory(std::size_t bytes);
  ~ReservedMemory();
  ReservedMemory(const ReservedMemory&) = delete;
  ReservedMemory& operator=(const ReservedMemory&) = delete;

  [[nodiscard]] void* begin() const { return begin_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  // What lies behind the first bytes is not needed for now: its memory may go back to the system.
  void give_back(std::size_t first);

 private:
  void* begin_;
  std::size_t bytes_;
};

// Whether much more may be reserved than is ever used. Without it, a reservation takes its bytes
// from the little that there is.
[[nodiscard]] bool reserves_for_free();

// Time on a clock that only goes on, ns since some moment.
[[nodiscard]] std::int64_t steady_time_ns();

// Lets other threads go on, for those who wait for a moment.
void yield_thread();

// Calls a function in a thread of its own when the time has passed, counted from now. Destroyed
// earlier, it does nothing; destroyed while the function runs, it waits for its end.
class Alarm {
 public:
  // throws  std::system_error where there are no other threads: a host then runs its programs in
  //         slices, and looks at the clock between two of them.
  Alarm(std::int64_t after_ns, std::function<void()> call);
  ~Alarm();
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// A library that is loaded while the program runs, and stays until it ends.
class LoadedLibrary {
 public:
  explicit LoadedLibrary(const std::string& name);
  // Null if there is no such library, or no such symbol in it.
  [[nodiscard]] void* find(const char* symbol) const;

 private:
  void* handle_;
};

// The folder of the program that runs, without a slash at its end; empty where there is none.
[[nodiscard]] std::string program_folder();

}  // namespace armlet
