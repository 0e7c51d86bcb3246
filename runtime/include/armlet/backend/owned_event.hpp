#pragma once

#include <memory>
#include <string>
#include <vector>

#include "armlet/backend/event.hpp"

namespace armlet {

// A copy of an event with everything that it points to. It cannot be moved, because the event
// points into it.
class OwnedEvent {
 public:
  explicit OwnedEvent(const Event& event);
  OwnedEvent(const OwnedEvent&) = delete;
  OwnedEvent& operator=(const OwnedEvent&) = delete;

  [[nodiscard]] const Event& event() const { return event_; }

 private:
  void own(JointSample& sample);
  void own(std::string_view& text);
  void own(const Figure*& figure);
  void own(ImageFrame& frame);

  std::vector<double> numbers_;
  std::vector<Eigen::Isometry3d> poses_;
  std::string text_;
  std::string file_;
  std::vector<std::uint8_t> pixels_;
  std::unique_ptr<const Figure> figure_;
  Event event_;
};

}  // namespace armlet
