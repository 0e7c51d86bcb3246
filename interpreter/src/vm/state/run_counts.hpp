#pragma once
// The counts of a run are kept apart from those of calls by its host. Calls that a host makes
// between two slices therefore change neither the steps nor the statements nor the limits of the
// run.

#include <cstdint>

namespace armlet::lang {

struct VmState;

struct RunCounts {
  std::uint64_t steps = 0;
  std::uint64_t since_pause = 0;  // steps
  std::uint64_t limit = 0;       // of steps since a pause; lower while the program is being stopped
  std::uint64_t work = 0;        // of kernels, less than one step
  std::uint64_t statements = 0;  // that have begun
  bool is_leaving = false;       // the program is being stopped
  bool is_stopped = false;       // by a stop request
};

// In the lifetime of a CountOfRun the counters are those of the run. Before and after it the counts
// of the run are stored apart.
class CountOfRun {
 public:
  explicit CountOfRun(VmState& state);
  ~CountOfRun();
  CountOfRun(const CountOfRun&) = delete;
  CountOfRun& operator=(const CountOfRun&) = delete;

 private:
  VmState& state_;
};

// In the lifetime of a CallOfRun a call by the host counts for the run, since a replay has to
// repeat the call. The limit of steps between two pauses of the run does not apply to it.
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
