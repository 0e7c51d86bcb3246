#include "armlet/backend/recorder.hpp"

namespace armlet {
namespace {

constexpr Ignore<FigureChanged, FinalFigure, DrawingChanged> kNotKept{};

}  // namespace

void Recorder::on(const Event& event) {
  std::visit(Overload{[this](const auto& each) { keep(each); }, kNotKept}, event);
}

EventKinds Recorder::ignores() const { return kNotKept.kinds(); }

void Recorder::keep(const BeginRun& begin) { run_ = begin.run; }

void Recorder::keep(const RobotAdded& added) { run_.robots.push_back(added.robot); }

void Recorder::keep(const RobotChanged& changed) {
  run_.robots.at(static_cast<std::size_t>(changed.index)) = changed.robot;
}

void Recorder::keep(const JointSample& sample) {
  joints_.push_back({.t_ns = sample.t_ns,
                     .robot = sample.robot,
                     .q = {sample.q.begin(), sample.q.end()},
                     .qd = {sample.qd.begin(), sample.qd.end()},
                     .qdd = {sample.qdd.begin(), sample.qdd.end()},
                     .T_world_tool = sample.T_world_tool.matrix()});
}

void Recorder::keep(const ObjectAdded& added) {
  objects_.push_back({.t_ns = added.t_ns,
                      .name = added.object.name,
                      .T_world_obj = added.object.T_world_obj.matrix()});
}

void Recorder::keep(const ObjectSample& sample) {
  objects_.push_back({.t_ns = sample.t_ns,
                      .name = std::string(sample.name),
                      .T_world_obj = sample.T_world_obj.matrix()});
}

void Recorder::keep(const ObjectEvent& event) {
  events_.push_back({.t_ns = event.t_ns,
                     .change = event.change,
                     .name = std::string(event.name),
                     .robot = event.robot});
}

void Recorder::keep(const Note& note) {
  notes_.push_back({.t_ns = note.t_ns, .kind = note.kind, .text = std::string(note.text)});
}

void Recorder::keep(const CameraAdded& added) { run_.cameras.push_back(added.camera); }

void Recorder::keep(const ImageFrame& frame) {
  frames_.push_back({.t_ns = frame.t_ns,
                     .camera = std::string(frame.camera),
                     .frame = frame.frame,
                     .width = frame.width,
                     .height = frame.height,
                     .channels = frame.channels,
                     .pixels = pixel_hash(frame),
                     .T_world_camera = frame.T_world_camera.matrix()});
}

void Recorder::keep(const Undone& undone) {
  undoings_.push_back({undone.t_ns, undone.number, undone.from, undone.back_ns});
}

void Recorder::keep(const EndRun& end) { end_ns_ = end.t_ns; }

bool Recorder::same_as(const Recorder& other) const {
  return joints_ == other.joints_ && objects_ == other.objects_ && events_ == other.events_ &&
         notes_ == other.notes_ && frames_ == other.frames_ && undoings_ == other.undoings_ &&
         end_ns_ == other.end_ns_;
}

}  // namespace armlet
