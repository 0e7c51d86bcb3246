#pragma once
// Operations that take virtual time, and the clock of the host.

#include <cstdint>
#include <string>

#include "armlet/interpreter/binding/thunk.hpp"
#include "armlet/interpreter/failure.hpp"
#include "armlet/interpreter/object.hpp"

namespace armlet {

// An operation that takes virtual time, from a pausing call until it is over.
class Waiting {
 public:
  virtual ~Waiting() = default;
  // The virtual time, ns, of its end if it is not stopped. The time may change when it is stopped.
  [[nodiscard]] virtual std::int64_t due_ns() const = 0;
  [[nodiscard]] virtual bool is_over() const = 0;
  // Begins a controlled stop (a guard became true, the task is cancelled); is_over is true at
  // due_ns.
  virtual void stop() = 0;
  // Work before the end, at an instant that due_ns has returned; work() runs as the waiting task.
  // Returns false, with the failure set, if it fails.
  [[nodiscard]] virtual bool has_work() const { return false; }
  virtual bool work(Vm&) { return true; }
  // Called once at the end: stores the result and returns kDone, or fails.
  virtual Signal finish(Vm& vm, Slot& result) = 0;
  // The name of the operation for reports about stuck programs: "run of left".
  [[nodiscard]] virtual std::string what() const = 0;
  // The resource that the operation commands; its type is null if there is none.
  [[nodiscard]] virtual Resource resource() const { return {}; }
};

// The virtual clock that the host owns.
class Timeline {
 public:
  virtual ~Timeline() = default;
  [[nodiscard]] virtual std::int64_t now_ns() const = 0;
  // The interval at which conditions are checked.
  [[nodiscard]] virtual std::int64_t tick_ns() const = 0;
  // Moves the host to time t >= now, or to an earlier one and is then called again, so that stop
  // requests take effect in between. Returns false if the host requests a stop.
  virtual bool advance_to(std::int64_t t_ns) = 0;
};

}  // namespace armlet
