#include "armlet/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  return bodies_.back().object;
}

void World::remove(std::string_view name) {
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(index_of(name)));
}

std::vector<std::string> World::names() const {
  std::vector<std::string> names;
  for (const Body& each : bodies_) names.push_back(each.object.name);
  return names;
}

const Object* World::find(std::string_view name) const {
  const auto found =
      std::ranges::find_if(bodies_, [&](const Body& each) { return each.object.name == name; });
  return found == bodies_.end() ? nullptr : &found->object;
}

const Object& World::at(std::string_view name) const { return bodies_[index_of(name)].object; }

std::optional<std::string> World::similar_name(std::string_view name) const {
  std::vector<std::string_view> candidates;
  for (const Body& each : bodies_) candidates.push_back(each.object.name);
  const auto similar = most_similar(name, candidates);
  return similar ? std::optional<std::string>(*similar) : std::nullopt;
}

std::size_t World::index_of(std::string_view name) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].object.name == name) return i;
  }
  const auto similar = similar_name(name);
  throw ArgumentError(fmt::format("There is no object \"{}\"{}", name,
                                  similar ? fmt::format("; did you mean \"{}\"?", *similar) : "."));
}

void World::set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj) {
  Body& moved = bodies_[index_of(name)];
  check_pose(fmt::format("the pose of \"{}\"", name), T_world_obj);
  moved.attachment.reset();
  moved.object.T_world_obj = renormalised(T_world_obj);
}

void World::attach(std::string_view name, int carrier, const Eigen::Isometry3d& T_world_carrier) {
  Body& carried = bodies_[index_of(name)];
  const Eigen::Isometry3d T_carrier_world = T_world_carrier.inverse();
  carried.attachment =
      Attachment{.carrier = carrier, .T_carrier_obj = T_carrier_world * carried.object.T_world_obj};
}

void World::detach(std::string_view name) { bodies_[index_of(name)].attachment.reset(); }

const std::optional<Attachment>& World::attachment(std::string_view name) const {
  return bodies_[index_of(name)].attachment;
}

std::string_view World::carried_by(int carrier) const {
  for (const Body& each : bodies_) {
    if (each.attachment && each.attachment->carrier == carrier) return each.object.name;
  }
  return {};
}

void World::move_carried(int carrier, const Eigen::Isometry3d& T_world_carrier) {
  for (Body& each : bodies_) {
    if (!each.attachment || each.attachment->carrier != carrier) continue;
    each.object.T_world_obj = T_world_carrier * each.attachment->T_carrier_obj;
  }
}

Drop World::fall(const Body& falling) const {
  const double z = falling.object.T_world_obj.translation().z();
  Drop drop;
  bool found = false;
  const auto consider = [&](double z_rest, const std::string& support) {
    const double distance = z - z_rest;
    if (distance < -kRestTolerance || (found && distance >= drop.distance)) return;
    drop = {.distance = distance, .support = support};
    found = true;
  };
  if (floor_z_) consider(*floor_z_ + half_height(falling.object), "floor");
  for (const Body& each : bodies_) {
    if (&each == &falling || each.attachment) continue;
    const auto z_rest = resting_height(falling.object, each.object);
    if (z_rest) consider(*z_rest, each.object.name);
  }
  return drop;
}

Drop World::drop(std::string_view name) {
  Body& falling = bodies_[index_of(name)];
  falling.attachment.reset();
  const Drop drop = fall(falling);
  falling.object.T_world_obj.translation().z() -= drop.distance;
  return drop;
}

std::string World::resting_on(std::string_view name) const {
  const Drop drop = fall(bodies_[index_of(name)]);
  return std::abs(drop.distance) <= kRestTolerance ? drop.support : std::string();
}

}  // namespace armlet
