#pragma once
// What a run counts, apart from what calls by its host count: whatever the host looks at between
// two slices, steps, statements and limits of the run are the same.

#include <cstdint>

namespace armlet::lang {

struct VmState;

struct RunCounts {
  std::uint64_t steps = 0;
  std::uint64_t since_pause = 0;  // steps
  std::uint64_t limit = 0;        // of these; a lower one while the program is being stopped
  std::uint64_t work = 0;         // of kernels, that has not made a whole step
  std::uint64_t statements = 0;   // that have begun
  bool is_leaving = false;        // the program is being stopped
  bool is_stopped = false;        // by a stop request
};

// While it lives, the run counts on; before and after it the counts are kept aside.
class CountOfRun {
 public:
  explicit CountOfRun(VmState& state);
  ~CountOfRun();
  CountOfRun(const CountOfRun&) = delete;
  CountOfRun& operator=(const CountOfRun&) = delete;

 private:
  VmState& state_;
};

// While it lives, a call by the host counts with the run, which cannot be taken again without it.
// What limits the run between two pauses is none of its business.
class CallOfRun {
 public:
  explicit CallOfRun(VmState& state);
  ~CallOfRun();
  CallOfRun(const CallOfRun&) = delete;
  CallOfRun& operator=(const CallOfRun&) = delete;

 private:
  VmState& state_;
};

}  // namespace armlet::lang
