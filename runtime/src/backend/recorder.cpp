#include "armlet/backend/recorder.hpp"

namespace armlet {

void Recorder::begin(const RunInfo& run) { run_ = run; }

void Recorder::robot_added(std::int64_t, const RobotInfo& robot) { run_.robots.push_back(robot); }

void Recorder::joint_sample(const JointSample& sample) {
  joints_.push_back({.t_ns = sample.t_ns,
                     .robot = sample.robot,
                     .q = {sample.q.begin(), sample.q.end()},
                     .qd = {sample.qd.begin(), sample.qd.end()},
                     .qdd = {sample.qdd.begin(), sample.qdd.end()},
                     .T_world_tool = sample.T_world_tool.matrix()});
}

void Recorder::object_added(std::int64_t t_ns, const ObjectInfo& object) {
  objects_.push_back(
      {.t_ns = t_ns, .name = object.name, .T_world_obj = object.T_world_obj.matrix()});
}

void Recorder::object_sample(const ObjectSample& sample) {
  objects_.push_back({.t_ns = sample.t_ns,
                      .name = std::string(sample.name),
                      .T_world_obj = sample.T_world_obj.matrix()});
}

void Recorder::object_event(const ObjectEvent& event) {
  events_.push_back({.t_ns = event.t_ns,
                     .change = event.change,
                     .name = std::string(event.name),
                     .robot = event.robot});
}

void Recorder::note(const Note& note) {
  notes_.push_back({.t_ns = note.t_ns, .kind = note.kind, .text = std::string(note.text)});
}

void Recorder::end(std::int64_t t_ns) { end_ns_ = t_ns; }

bool Recorder::same_as(const Recorder& other) const {
  return joints_ == other.joints_ && objects_ == other.objects_ && events_ == other.events_ &&
         notes_ == other.notes_ && end_ns_ == other.end_ns_;
}

}  // namespace armlet
