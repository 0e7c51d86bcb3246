#include "armlet/backend/owned_event.hpp"

namespace armlet {

OwnedEvent::OwnedEvent(const Event& event) : event_(event) {
  std::visit(
      Overload{
          [this](JointSample& each) { own(each); }, [this](ObjectSample& each) { own(each.name); },
          [this](ObjectEvent& each) { own(each.name); }, [this](Note& each) { own(each.text); },
          [this](FigureChanged& each) { own(each.figure); },
          [this](FinalFigure& each) { own(each.figure); }, [this](ImageFrame& each) { own(each); },
          // These events own their data.
          [](BeginRun&) {}, [](RobotAdded&) {}, [](RobotChanged&) {}, [](ObjectAdded&) {},
          [](Undone&) {}, [](EndRun&) {}, [](DrawingChanged&) {}, [](CameraAdded&) {}},
      event_);
}

void OwnedEvent::own(JointSample& sample) {
  numbers_.reserve(sample.q.size() + sample.qd.size() + sample.qdd.size());
  for (std::span<const double>* part : {&sample.q, &sample.qd, &sample.qdd}) {
    const std::size_t begin = numbers_.size();
    numbers_.insert(numbers_.end(), part->begin(), part->end());
    *part = {numbers_.data() + begin, part->size()};
  }
  poses_.assign(sample.T_world_links.begin(), sample.T_world_links.end());
  sample.T_world_links = poses_;
}

void OwnedEvent::own(std::string_view& text) {
  text_ = text;
  text = text_;
}

void OwnedEvent::own(ImageFrame& frame) {
  own(frame.camera);
  file_ = frame.file;
  frame.file = file_;
  pixels_.assign(frame.pixels.begin(), frame.pixels.end());
  frame.pixels = pixels_;
}

void OwnedEvent::own(const Figure*& figure) {
  if (figure == nullptr) return;
  figure_ = std::make_unique<const Figure>(*figure);
  figure = figure_.get();
}

}  // namespace armlet
