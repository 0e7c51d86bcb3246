#include "armlet/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/math/pose.hpp"
#include "world/support.hpp"

namespace armlet {

World::World(std::optional<double> floor_z) : floor_z_(floor_z) {
  if (floor_z) check_finite("floor_z", *floor_z);
}

const Object& World::insert(Object object) {
  check_object(object);
  if (find(object.name) != nullptr) {
    throw ArgumentError(fmt::format("There is already an object \"{}\".", object.name));
  }
  object.T_world_obj = renormalised(object.T_world_obj);
  bodies_.push_back({.object = std::move(object), .attachment = std::nullopt});
  index_from(bodies_.size() - 1);
  ride(bodies_.back());
  return bodies_.back().object;
}

std::vector<Fall> World::remove(std::string_view name) {
  std::vector<std::string> above = stacked_on(name);
  const std::size_t index = index_of(name);
  let_loose(bodies_[index].object.name, above);
  if (!bodies_[index].fastened_on.empty()) --fastened_;
  index_.erase(bodies_[index].object.name);
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(index));
  index_from(index);
  return settle(above);
}

void World::index_from(std::size_t first) {
  for (std::size_t i = first; i < bodies_.size(); ++i) index_[bodies_[i].object.name] = i;
}

std::vector<std::string> World::names() const {
  std::vector<std::string> names;
  for (const Body& each : bodies_) names.push_back(each.object.name);
  return names;
}

const Object* World::find(std::string_view name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? nullptr : &bodies_[found->second].object;
}

const Object& World::at(std::string_view name) const { return bodies_[index_of(name)].object; }

std::optional<std::string> World::similar_name(std::string_view name) const {
  std::vector<std::string_view> candidates;
  for (const Body& each : bodies_) candidates.push_back(each.object.name);
  const auto similar = most_similar(name, candidates);
  return similar ? std::optional<std::string>(*similar) : std::nullopt;
}

std::size_t World::index_of(std::string_view name) const {
  const auto found = index_.find(name);
  if (found != index_.end()) return found->second;
  const auto similar = similar_name(name);
  throw ArgumentError(fmt::format("There is no object \"{}\"{}", name,
                                  similar ? fmt::format("; did you mean \"{}\"?", *similar) : "."));
}

std::vector<Fall> World::set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj) {
  Body& moved = bodies_[index_of(name)];
  check_place(name, T_world_obj);
  const std::vector<std::string> above = stacked_on(name);
  const Eigen::Isometry3d T_old_new = moved.object.T_world_obj.inverse() * T_world_obj;
  moved.object.T_world_obj = renormalised(T_world_obj);
  if (moved.object.fixed && (moved.attachment || !moved.fastened_on.empty())) {
    if (moved.attachment)
      moved.attachment->T_carrier_obj = renormalised(moved.attachment->T_carrier_obj * T_old_new);
    moved.T_on_obj = renormalised(moved.T_on_obj * T_old_new);
  } else {
    moved.attachment.reset();
    if (!std::exchange(moved.fastened_on, {}).empty()) --fastened_;
    ride(moved);
  }
  bring_fastened(moved);
  return settle(above);
}

bool World::is_carried_on(const Body& upper, const Body& lower) const {
  if (&upper == &lower) return false;
  if (!upper.fastened_on.empty()) return upper.fastened_on == lower.object.name;
  if (upper.attachment) return upper.attachment->on == lower.object.name;
  if (upper.object.fixed) return false;
  const auto z_rest = rests_at(upper.object, lower.object);
  return z_rest && std::abs(upper.object.T_world_obj.translation().z() - *z_rest) <= kRestTolerance;
}

std::vector<std::string> World::stacked_on(std::string_view name) const {
  std::vector<bool> in_stack(bodies_.size(), false);
  std::vector<std::size_t> open = {index_of(name)};
  in_stack[open.front()] = true;
  while (!open.empty()) {
    const Body& lower = bodies_[open.back()];
    open.pop_back();
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (in_stack[i] || !is_carried_on(bodies_[i], lower)) continue;
      in_stack[i] = true;
      open.push_back(i);
    }
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (in_stack[i] && bodies_[i].object.name != name) names.push_back(bodies_[i].object.name);
  }
  return names;
}

void World::attach(std::string_view name, int carrier, const Eigen::Isometry3d& T_world_carrier) {
  const Eigen::Isometry3d T_carrier_world = T_world_carrier.inverse();
  const std::vector<std::string> above = stacked_on(name);
  const auto carry = [&](Body& body, std::string on) {
    body.attachment = Attachment{.carrier = carrier,
                                 .T_carrier_obj = T_carrier_world * body.object.T_world_obj,
                                 .on = std::move(on)};
  };
  // What each one rests on is asked before any of them counts as carried.
  std::vector<std::string> lower;
  for (const std::string& each : above) {
    const Body& upper = bodies_[index_of(each)];
    const auto is_lower = [&](const Body& body) {
      return is_carried_on(upper, body) &&
             (body.object.name == name ||
              std::ranges::find(above, body.object.name) != above.end());
    };
    lower.push_back(std::ranges::find_if(bodies_, is_lower)->object.name);
  }
  Body& taken = bodies_[index_of(name)];
  if (!std::exchange(taken.fastened_on, {}).empty()) --fastened_;
  carry(taken, {});
  for (std::size_t i = 0; i < above.size(); ++i) carry(bodies_[index_of(above[i])], lower[i]);
}

void World::detach(std::string_view name) {
  for (const std::string& each : stacked_on(name)) bodies_[index_of(each)].attachment.reset();
  bodies_[index_of(name)].attachment.reset();
}

const std::optional<Attachment>& World::attachment(std::string_view name) const {
  return bodies_[index_of(name)].attachment;
}

std::string_view World::carried_by(int carrier) const {
  for (const Body& each : bodies_) {
    if (each.attachment && each.attachment->carrier == carrier && each.attachment->on.empty() &&
        !each.attachment->mounted)
      return each.object.name;
  }
  return {};
}

void World::move_carried(int carrier, std::span<const Eigen::Isometry3d> T_world_frames) {
  const auto frame = [&](int index) -> const Eigen::Isometry3d& {
    return index == kFlange ? T_world_frames.back()
                            : T_world_frames[static_cast<std::size_t>(index)];
  };
  for (Body& each : bodies_) {
    if (!each.attachment || each.attachment->carrier != carrier) continue;
    each.object.T_world_obj = frame(each.attachment->frame) * each.attachment->T_carrier_obj;
  }
  for (NamedFrame& each : frames_) {
    if (each.base == FrameBase::kCarrier && each.carrier == carrier)
      each.T_world_carrier = frame(each.frame);
  }
}

}  // namespace armlet
