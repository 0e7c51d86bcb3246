// Named frames, which move with what they are mounted on.
#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

void World::insert_frame(NamedFrame frame) {
  if (frame.name.empty()) throw ArgumentError("A frame needs a name.");
  if (find_frame(frame.name) != nullptr)
    throw ArgumentError(fmt::format("There is already a frame \"{}\".", frame.name));
  check_place(frame.name, frame.T_on_frame);
  if (!T_world_base(frame)) {
    throw ArgumentError(fmt::format("The frame \"{}\" would be on \"{}\", which is not there.",
                                    frame.name, frame.on));
  }
  frame.T_on_frame = renormalised(frame.T_on_frame);
  if (frame.base == FrameBase::kCarrier && !has_mounted(frame.carrier))
    mounted_.push_back(frame.carrier);
  frame_index_.emplace(frame.name, frames_.size());
  frames_.push_back(std::move(frame));
}

const NamedFrame* World::find_frame(std::string_view name) const {
  const auto found = frame_index_.find(name);
  return found == frame_index_.end() ? nullptr : &frames_[found->second];
}

std::vector<std::string> World::frame_names() const {
  std::vector<std::string> names;
  for (const NamedFrame& each : frames_) names.push_back(each.name);
  return names;
}

// A frame comes after the one that it is mounted on, so the loop ends.
std::optional<Eigen::Isometry3d> World::T_world_base(const NamedFrame& frame) const {
  Eigen::Isometry3d T_below_base = Eigen::Isometry3d::Identity();
  const NamedFrame* upper = &frame;
  while (upper->base == FrameBase::kFrame) {
    upper = find_frame(upper->on);
    if (upper == nullptr) return std::nullopt;
    T_below_base = upper->T_on_frame * T_below_base;
  }
  if (upper->base == FrameBase::kWorld) return T_below_base;
  if (upper->base == FrameBase::kCarrier) return upper->T_world_carrier * T_below_base;
  const Object* object = find(upper->on);
  if (object == nullptr) return std::nullopt;
  return object->T_world_obj * T_below_base;
}

Mount World::mount_of_frame(std::string_view name) const {
  const NamedFrame* frame = find_frame(name);
  while (frame != nullptr && frame->base == FrameBase::kFrame) frame = find_frame(frame->on);
  if (frame == nullptr) throw ArgumentError(fmt::format("There is no frame \"{}\".", name));
  return {.base = frame->base, .on = frame->on, .carrier = frame->carrier, .frame = frame->frame};
}

std::optional<Eigen::Isometry3d> World::T_world_frame(std::string_view name) const {
  const NamedFrame* frame = find_frame(name);
  if (frame == nullptr) throw ArgumentError(fmt::format("There is no frame \"{}\".", name));
  const auto T_world_on = T_world_base(*frame);
  if (!T_world_on) return std::nullopt;
  return *T_world_on * frame->T_on_frame;
}

void World::set_frame(std::string_view name, const Eigen::Isometry3d& T_world_frame) {
  const auto found = frame_index_.find(name);
  if (found == frame_index_.end())
    throw ArgumentError(fmt::format("There is no frame \"{}\".", name));
  NamedFrame* const frame = &frames_[found->second];
  check_place(name, T_world_frame);
  const auto T_world_on = T_world_base(*frame);
  if (!T_world_on) {
    throw ArgumentError(
        fmt::format("The frame \"{}\" is on \"{}\", which was removed.", name, frame->on));
  }
  frame->T_on_frame = renormalised(T_world_on->inverse() * T_world_frame);
}

}  // namespace armlet
