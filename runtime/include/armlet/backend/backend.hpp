// Who listens to a run. Backends only listen: nothing they do changes the run.
#pragma once

#include <string>

#include "armlet/backend/event.hpp"

namespace armlet {

// Listens to a run. Events come in the order of time, but where an Undone says
// that the run went back: BeginRun first, EndRun last, each once. No
// backend may throw because the outside fails.
class Backend {
 public:
  virtual ~Backend() = default;

  // event  lives only during the call, with everything that it points to.
  virtual void on(const Event& event) = 0;

  // The events that it does nothing with; it need not be told of them.
  [[nodiscard]] virtual EventKinds ignores() const { return {}; }

  // Whether samples of joints are to carry the frames of the links, which have to be computed.
  [[nodiscard]] virtual bool wants_link_poses() const { return false; }

  // Empty while everything was written; otherwise a sentence about the first thing that failed.
  [[nodiscard]] virtual std::string error() const { return {}; }
};

}  // namespace armlet
