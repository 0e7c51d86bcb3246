#pragma once
// Long computations that can be stopped from outside.
//
// A kernel that may take long reports its progress at checkpoints. The caller's supervisor decides
// whether it continues: the virtual machine counts such work as steps of the program. Results never
// depend on it. Without a supervisor a checkpoint is one comparison.

#include <cstdint>
#include <utility>

namespace armlet {

// Thrown by a checkpoint when work is to stop, and caught where the supervisor was set. It is not a
// std::exception, so that nobody in between takes it for a failure of the work.
class Stopped {};

class Supervisor {
 public:
  virtual ~Supervisor() = default;
  // Returns whether work may continue after this number of elementary operations, each about a
  // nanosecond.
  [[nodiscard]] virtual bool go_on(std::uint64_t operations) = 0;
};

namespace detail {
// In position-independent code each access would be a function call, were it not known to be in the
// static thread-local storage.
[[gnu::tls_model("initial-exec")]] extern constinit thread_local Supervisor* present_supervisor;
}  // namespace detail

// During its lifetime, checkpoints in this thread ask `supervisor`, or none if it is null.
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
