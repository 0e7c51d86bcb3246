#pragma once

#include <vector>

#include "armlet/backend/backend.hpp"

namespace armlet {

// Several backends as one; each receives every event, in the given order.
class FanOut : public Backend {
 public:
  // backends  not owned; they live at least as long as this.
  // throws    ArgumentError if one of them is null.
  explicit FanOut(std::vector<Backend*> backends);

  // Passes the event to every backend, even after one has thrown; the first exception is rethrown
  // at the end.
  void on(const Event& event) override;

  // Replaces the backends.
  void set_backends(std::vector<Backend*> backends);

  // While it is muted, no event is passed on.
  void set_muted(bool muted) { muted_ = muted; }

  // The kinds of events that all of them ignore.
  [[nodiscard]] EventKinds ignores() const override;

  // Whether any of them wants link poses.
  [[nodiscard]] bool wants_link_poses() const override;

  // The error of the first backend that has one.
  [[nodiscard]] std::string error() const override;

 private:
  std::vector<Backend*> backends_;
  bool muted_ = false;
};

}  // namespace armlet
