#pragma once
// How long computations are stopped from outside.
//
// A kernel that may take long says now and then how much it has done. Who called it decides whether
// it goes on: the virtual machine counts such work as steps of the program. What is computed never
// depends on it. Where nobody supervises, a checkpoint is one comparison.

#include <cstdint>
#include <utility>

namespace armlet {

// Thrown by a checkpoint where work is not to go on. It is caught by whoever set the supervisor,
// and is no std::exception, so that nobody in between takes it for a failure of the work.
class Stopped {};

class Supervisor {
 public:
  virtual ~Supervisor() = default;
  // Whether work may go on after so many elementary operations, each about a nanosecond.
  [[nodiscard]] virtual bool go_on(std::uint64_t operations) = 0;
};

namespace detail {
// Asking for it is a call in code that can be moved, unless it is known to lie beside the thread.
[[gnu::tls_model("initial-exec")]] extern constinit thread_local Supervisor* present_supervisor;
}  // namespace detail

// While it lives, checkpoints in this thread ask `supervisor`, or nobody if it is null.
class Supervised {
 public:
  explicit Supervised(Supervisor* supervisor)
      : before_(std::exchange(detail::present_supervisor, supervisor)) {}
  ~Supervised() { detail::present_supervisor = before_; }
  Supervised(const Supervised&) = delete;
  Supervised& operator=(const Supervised&) = delete;

 private:
  Supervisor* before_;
};

// throws  Stopped if the supervisor of this thread wants work to stop.
void checkpoint(std::uint64_t operations);

}  // namespace armlet
