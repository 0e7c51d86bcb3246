#pragma once
// The recordings of a run: the values that `record` samples, and the instants of the samples.

#include <cstdint>
#include <functional>
#include <vector>

#include "vm/state/state.hpp"

namespace armlet::lang {

// Samples are taken after the world has reached an instant, before any condition is evaluated and
// any task continues.
class Recordings {
 public:
  explicit Recordings(VmState& state) : state_(state) {}
  ~Recordings();
  Recordings(const Recordings&) = delete;
  Recordings& operator=(const Recordings&) = delete;

  // Makes the table with the first sample. Returns null if it failed.
  [[nodiscard]] RecordObj* start(ClosureObj* sample, std::int64_t period_ns);
  // Takes the last sample, unless one was taken at this instant. Returns false if it failed.
  [[nodiscard]] bool end(const RecordObj* table);

  // The next instant with a sample of any recording, ns.
  [[nodiscard]] std::int64_t next_ns() const;
  // Takes the samples of this instant. A recording ends with a sample that fails; `failed` is then
  // called with the task that began the recording, and state.fault is set.
  void take_due(const std::function<void(Task&)>& failed);

 private:
  struct Recording {
    ClosureObj* sample;
    RecordObj* table;
    Task* task;
    std::int64_t period_ns;
    std::int64_t next_ns;
    std::int64_t last_ns;
    bool failed;
  };
  [[nodiscard]] bool take(Recording& recording);
  void release(const Recording& recording);

  VmState& state_;
  std::vector<Recording> recordings_;
};

// The function of LanguageFunctions that starts a recording.
extern const NativeFunction kStartRecording;
extern const NativeFunction kEndRecording;
extern const NativeFunction kTableColumn;
extern const NativeFunction kTableRows;
extern const NativeFunction kTableLength;

}  // namespace armlet::lang
