// Bodies fastened on others and on frames of carriers.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

void World::fasten(std::string_view name, std::string_view on) {
  Body& upper = bodies_[index_of(name)];
  const Body& lower = bodies_[index_of(on)];
  if (root_of(on) == root_of(name)) {
    throw ArgumentError(fmt::format("\"{}\" cannot be on \"{}\", which is {}.", name, on,
                                    &upper == &lower ? "itself" : "fastened on it"));
  }
  if (upper.fastened_on.empty()) ++fastened_;
  upper.attachment.reset();
  upper.fastened_on = lower.object.name;
  upper.T_on_obj = renormalised(lower.object.T_world_obj.inverse() * upper.object.T_world_obj);
  bring_fastened(lower);
}

void World::mount(std::string_view name, int carrier, int frame,
                  const Eigen::Isometry3d& T_world_frame) {
  Body& body = bodies_[index_of(name)];
  if (!std::exchange(body.fastened_on, {}).empty()) --fastened_;
  body.attachment =
      Attachment{.carrier = carrier,
                 .T_carrier_obj = renormalised(T_world_frame.inverse() * body.object.T_world_obj),
                 .frame = frame,
                 .mounted = true};
  if (!has_mounted(carrier)) mounted_.push_back(carrier);
  bring_fastened(body);
}

bool World::has_mounted(int carrier) const {
  return std::ranges::find(mounted_, carrier) != mounted_.end();
}

bool World::are_fastened(std::string_view a, std::string_view b) const {
  return a == b || (fastened_ > 0 && root_of(a) == root_of(b));
}

std::string_view World::root_of(std::string_view name) const {
  const Body* body = &bodies_[index_of(name)];
  while (!body->fastened_on.empty()) body = &bodies_[index_of(body->fastened_on)];
  return body->object.name;
}

std::vector<const World::Body*> World::compound(const Body& root) const {
  std::vector<const Body*> all{&root};
  for (std::size_t next = 0; fastened_ > 0 && next < all.size(); ++next) {
    for (const Body& each : bodies_) {
      if (each.fastened_on == all[next]->object.name) all.push_back(&each);
    }
  }
  return all;
}

std::vector<const Object*> World::thing(std::string_view name) const {
  std::vector<const Object*> objects;
  for (const Body* each : compound(bodies_[index_of(name)])) objects.push_back(&each->object);
  return objects;
}

void World::bring_fastened(const Body& lower) {
  std::vector<const Body*> open{&lower};
  for (std::size_t next = 0; fastened_ > 0 && next < open.size(); ++next) {
    const Body& below = *open[next];
    for (Body& each : bodies_) {
      if (each.fastened_on != below.object.name) continue;
      each.object.T_world_obj = below.object.T_world_obj * each.T_on_obj;
      each.attachment = below.attachment;
      if (each.attachment) {
        each.attachment->T_carrier_obj = below.attachment->T_carrier_obj * each.T_on_obj;
        each.attachment->on = below.object.name;
      }
      open.push_back(&each);
    }
  }
}

// What was fastened on a body that is removed belongs to nothing any more. What is fixed stays
// where it is, so that it does not count among what falls.
void World::let_loose(std::string_view removed, std::vector<std::string>& above) {
  for (Body& each : bodies_) {
    if (fastened_ == 0 || each.fastened_on != removed) continue;
    each.fastened_on.clear();
    --fastened_;
    each.attachment.reset();
    bring_fastened(each);
    if (each.object.fixed) std::erase(above, each.object.name);
  }
}

}  // namespace armlet
