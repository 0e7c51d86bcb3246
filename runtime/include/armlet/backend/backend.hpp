// Listeners of a run. Nothing that they do changes the run.
#pragma once

#include <string>

#include "armlet/backend/event.hpp"

namespace armlet {

// A listener of a run. Events come in the order of time, except after an Undone, which says that
// the run went back: BeginRun first, EndRun last, each once. No backend may throw because an output
// fails.
class Backend {
 public:
  virtual ~Backend() = default;

  // event  is valid only during the call, with everything that it points to.
  virtual void on(const Event& event) = 0;

  // The events that this backend ignores; they need not be sent to it.
  [[nodiscard]] virtual EventKinds ignores() const { return {}; }

  // Whether joint samples need the frames of the links, which take time to compute.
  [[nodiscard]] virtual bool wants_link_poses() const { return false; }

  // Empty while every output succeeded; otherwise a sentence about the first failure.
  [[nodiscard]] virtual std::string error() const { return {}; }
};

}  // namespace armlet
