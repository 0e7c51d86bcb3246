#pragma once

#include <vector>

#include "armlet/backend/backend.hpp"

namespace armlet {

// Several backends as one; each is told everything, in the order given.
class FanOut : public Backend {
 public:
  // backends  not owned; they live at least as long as this.
  // throws    ArgumentError if one of them is null.
  explicit FanOut(std::vector<Backend*> backends);

  // Passes the event to every backend, also behind one that throws; the first exception is thrown
  // at the end.
  void on(const Event& event) override;

  // Others take the place of those that were told so far.
  void set_backends(std::vector<Backend*> backends);

  // While it is muted, nothing is passed on.
  void set_muted(bool muted) { muted_ = muted; }

  // What all of them ignore.
  [[nodiscard]] EventKinds ignores() const override;

  // What any of them wants.
  [[nodiscard]] bool wants_link_poses() const override;

  // The error of the first backend that has one.
  [[nodiscard]] std::string error() const override;

 private:
  std::vector<Backend*> backends_;
  bool muted_ = false;
};

}  // namespace armlet
