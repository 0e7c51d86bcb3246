#include "armlet/backend/fan_out.hpp"

#include <algorithm>

#include "armlet/core/error.hpp"

namespace armlet {

FanOut::FanOut(std::vector<Backend*> backends) : backends_(std::move(backends)) {
  if (std::ranges::find(backends_, nullptr) != backends_.end()) {
    throw ArgumentError("A backend of the fan-out is null; leave it out instead.");
  }
}

void FanOut::begin(const RunInfo& run) {
  for (Backend* each : backends_) each->begin(run);
}

void FanOut::robot_added(std::int64_t t_ns, const RobotInfo& robot) {
  for (Backend* each : backends_) each->robot_added(t_ns, robot);
}

void FanOut::joint_sample(const JointSample& sample) {
  for (Backend* each : backends_) each->joint_sample(sample);
}

void FanOut::object_added(std::int64_t t_ns, const ObjectInfo& object) {
  for (Backend* each : backends_) each->object_added(t_ns, object);
}

void FanOut::object_sample(const ObjectSample& sample) {
  for (Backend* each : backends_) each->object_sample(sample);
}

void FanOut::object_event(const ObjectEvent& event) {
  for (Backend* each : backends_) each->object_event(event);
}

void FanOut::note(const Note& note) {
  for (Backend* each : backends_) each->note(note);
}

void FanOut::figure(std::int64_t t_ns, const Figure& figure) {
  for (Backend* each : backends_) each->figure(t_ns, figure);
}

void FanOut::end(std::int64_t t_ns) {
  for (Backend* each : backends_) each->end(t_ns);
}

std::string FanOut::error() const {
  for (const Backend* each : backends_) {
    if (std::string error = each->error(); !error.empty()) return error;
  }
  return {};
}

}  // namespace armlet
