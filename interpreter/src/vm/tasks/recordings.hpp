#pragma once
// The recordings of a run: what `record` samples, and when.

#include <cstdint>
#include <functional>
#include <vector>

#include "vm/state/state.hpp"

namespace armlet::lang {

// Samples are taken when the world has been brought to an instant, before any condition is
// evaluated or task goes on.
class Recordings {
 public:
  explicit Recordings(VmState& state) : state_(state) {}
  ~Recordings();
  Recordings(const Recordings&) = delete;
  Recordings& operator=(const Recordings&) = delete;

  // Makes the table, with the first sample in it. Null: it failed.
  [[nodiscard]] RecordObj* start(ClosureObj* sample, std::int64_t period_ns);
  // Takes the last sample, unless one was taken at this instant. False: it failed.
  [[nodiscard]] bool end(const RecordObj* table);

  // The next instant at which one of them takes a sample.
  [[nodiscard]] std::int64_t next_ns() const;
  // Takes the samples of this instant. One that fails is the last of its recording; `failed` gets
  // the task that began it, with the failure in the state.
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

// As LanguageFunctions says.
extern const NativeFunction kStartRecording;
extern const NativeFunction kEndRecording;
extern const NativeFunction kTableColumn;
extern const NativeFunction kTableRows;
extern const NativeFunction kTableLength;

}  // namespace armlet::lang
