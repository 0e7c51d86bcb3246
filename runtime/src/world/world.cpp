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
  const std::uint32_t id = next_id_++;
  by_name_.emplace(object.name, id);
  ids_.push_back(id);
  bodies_.emplace_back(Body{.object = std::move(object), .id = id});
  Body& body = *bodies_.back();
  has_moved(body);
  ride(body);
  return body.object;
}

std::vector<Fall> World::remove(std::string_view name) {
  std::vector<std::string> above = stacked_on(name);
  const std::size_t index = index_of(name);
  Body& removed = *bodies_[index];
  let_loose(removed, above);
  (void)unfasten(removed);
  carry(removed, std::nullopt);
  near_.take(removed.id);
  columns_.take(removed.id);
  by_name_.erase(removed.object.name);
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(index));
  ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(index));
  return settle(above);
}

std::vector<std::string> World::names() const {
  std::vector<std::string> names;
  for (const Owned<Body>& each : bodies_) names.push_back(each->object.name);
  return names;
}

const Object* World::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &body(found->second).object;
}

const Object& World::at(std::string_view name) const { return body(name).object; }

std::optional<std::string> World::similar_name(std::string_view name) const {
  std::vector<std::string_view> candidates;
  for (const Owned<Body>& each : bodies_) candidates.push_back(each->object.name);
  const auto similar = most_similar(name, candidates);
  return similar ? std::optional<std::string>(*similar) : std::nullopt;
}

std::size_t World::index_of(std::string_view name) const {
  const auto found = by_name_.find(name);
  if (found != by_name_.end()) return index_of_id(found->second);
  const auto similar = similar_name(name);
  throw ArgumentError(fmt::format("There is no object \"{}\"{}", name,
                                  similar ? fmt::format("; did you mean \"{}\"?", *similar) : "."));
}

std::vector<Fall> World::set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj) {
  Body& moved = body(name);
  check_place(name, T_world_obj);
  const std::vector<std::string> above = stacked_on(name);
  const Eigen::Isometry3d T_old_new = moved.object.T_world_obj.inverse() * T_world_obj;
  moved.object.T_world_obj = renormalised(T_world_obj);
  has_moved(moved);
  if (moved.object.fixed && (moved.attachment || !moved.fastened_on.empty())) {
    if (moved.attachment)
      moved.attachment->T_carrier_obj = renormalised(moved.attachment->T_carrier_obj * T_old_new);
    moved.T_on_obj = renormalised(moved.T_on_obj * T_old_new);
  } else {
    carry(moved, std::nullopt);
    (void)unfasten(moved);
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
  const std::uint32_t bottom = body(name).id;
  std::set<std::uint32_t> in_stack = {bottom};
  std::vector<std::uint32_t> open = {bottom};
  while (!open.empty()) {
    const Body& lower = body(open.back());
    open.pop_back();
    const auto look = [&](const std::vector<std::uint32_t>& ids) {
      for (const std::uint32_t id : ids) {
        if (in_stack.contains(id) || !is_carried_on(body(id), lower)) continue;
        in_stack.insert(id);
        open.push_back(id);
      }
    };
    look(lower.fastened);
    look(lower.riding);
    look(touching(lower.object));
  }
  in_stack.erase(bottom);
  std::vector<std::string> names;
  for (const std::uint32_t id : in_stack) names.push_back(body(id).object.name);
  return names;
}

// The first of the bodies that move along on which another body is carried.
const World::Body& World::lower_in(const std::set<std::uint32_t>& stack, const Body& upper) const {
  std::vector<std::uint32_t> ids = touching(upper.object);
  for (const std::string* on :
       {&upper.fastened_on, upper.attachment ? &upper.attachment->on : nullptr}) {
    const auto known = on == nullptr ? by_name_.end() : by_name_.find(*on);
    if (known != by_name_.end()) ids.push_back(known->second);
  }
  std::ranges::sort(ids);
  return body(*std::ranges::find_if(
      ids, [&](std::uint32_t id) { return stack.contains(id) && is_carried_on(upper, body(id)); }));
}

void World::attach(std::string_view name, int carrier, const Eigen::Isometry3d& T_world_carrier) {
  const Eigen::Isometry3d T_carrier_world = T_world_carrier.inverse();
  Body& taken = body(name);
  const std::vector<std::string> above = stacked_on(name);
  const auto carry_along = [&](Body& body, std::string on) {
    carry(body, Attachment{.carrier = carrier,
                           .T_carrier_obj = T_carrier_world * body.object.T_world_obj,
                           .on = std::move(on)});
  };
  // The supports are determined before any body counts as carried.
  std::set<std::uint32_t> stack = {taken.id};
  for (const std::string& each : above) stack.insert(body(each).id);
  std::vector<std::string> lower;
  for (const std::string& each : above) lower.push_back(lower_in(stack, body(each)).object.name);
  (void)unfasten(taken);
  carry_along(taken, {});
  for (std::size_t i = 0; i < above.size(); ++i) carry_along(body(above[i]), lower[i]);
}

void World::detach(std::string_view name) {
  for (const std::string& each : stacked_on(name)) carry(body(each), std::nullopt);
  carry(body(name), std::nullopt);
}

const std::optional<Attachment>& World::attachment(std::string_view name) const {
  return body(name).attachment;
}

std::string_view World::carried_by(int carrier) const {
  for (const std::uint32_t id : carried_) {
    const Body& each = body(id);
    if (each.attachment->carrier == carrier && each.attachment->on.empty() &&
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
  for (const std::uint32_t id : carried_) {
    Body& each = body(id);
    if (each.attachment->carrier != carrier) continue;
    each.object.T_world_obj = frame(each.attachment->frame) * each.attachment->T_carrier_obj;
    has_moved(each);
  }
  for (NamedFrame& each : frames_) {
    if (each.base == FrameBase::kCarrier && each.carrier == carrier)
      each.T_world_carrier = frame(each.frame);
  }
}

}  // namespace armlet
