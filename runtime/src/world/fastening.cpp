// Bodies fastened on others and on frames of carriers.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

void World::fasten(std::string_view name, std::string_view on) {
  Body& upper = body(name);
  Body& lower = body(on);
  if (root_of(on) == root_of(name)) {
    throw ArgumentError(fmt::format("\"{}\" cannot be on \"{}\", which is {}.", name, on,
                                    &upper == &lower ? "itself" : "fastened on it"));
  }
  carry(upper, std::nullopt);
  fasten_to(upper, lower);
  upper.T_on_obj = renormalised(lower.object.T_world_obj.inverse() * upper.object.T_world_obj);
  bring(lower, upper);
  bring_fastened(upper);
}

void World::mount(std::string_view name, int carrier, int frame,
                  const Eigen::Isometry3d& T_world_frame) {
  Body& mounted = body(name);
  (void)unfasten(mounted);
  carry(mounted, Attachment{.carrier = carrier,
                            .T_carrier_obj =
                                renormalised(T_world_frame.inverse() * mounted.object.T_world_obj),
                            .frame = frame,
                            .mounted = true});
  if (!has_mounted(carrier)) mounted_.push_back(carrier);
  bring_fastened(mounted);
}

bool World::has_mounted(int carrier) const {
  return std::ranges::find(mounted_, carrier) != mounted_.end();
}

bool World::are_fastened(std::string_view a, std::string_view b) const {
  return a == b || (fastened_ > 0 && root_of(a) == root_of(b));
}

std::string_view World::root_of(std::string_view name) const {
  const Body* root = &body(name);
  while (!root->fastened_on.empty()) root = &body(root->fastened_on);
  return root->object.name;
}

std::vector<const World::Body*> World::compound(const Body& root) const {
  std::vector<const Body*> all{&root};
  for (std::size_t next = 0; next < all.size(); ++next) {
    for (const std::uint32_t id : all[next]->fastened) all.push_back(&body(id));
  }
  return all;
}

std::vector<const Object*> World::thing(std::string_view name) const {
  std::vector<const Object*> objects;
  for (const Body* each : compound(body(name))) objects.push_back(&each->object);
  return objects;
}

std::vector<std::string> World::fastened_with(std::string_view name) const {
  std::vector<std::string> names;
  if (fastened_ == 0) return names;
  std::vector<const Body*> all = compound(body(root_of(name)));
  std::ranges::sort(all, {}, &Body::id);
  for (const Body* each : all) {
    if (!each->fastened_on.empty()) names.push_back(each->object.name);
  }
  return names;
}

void World::bring(const Body& lower, Body& upper) {
  upper.object.T_world_obj = lower.object.T_world_obj * upper.T_on_obj;
  has_moved(upper);
  std::optional<Attachment> attachment = lower.attachment;
  if (attachment) {
    attachment->T_carrier_obj = lower.attachment->T_carrier_obj * upper.T_on_obj;
    attachment->on = lower.object.name;
  }
  carry(upper, std::move(attachment));
}

void World::bring_fastened(const Body& lower) {
  std::vector<const Body*> open{&lower};
  for (std::size_t next = 0; next < open.size(); ++next) {
    for (const std::uint32_t id : open[next]->fastened) {
      bring(*open[next], body(id));
      open.push_back(&body(id));
    }
  }
}

// Releases what was fastened on a removed body. Fixed bodies do not move, so they are not among
// those that fall.
void World::let_loose(const Body& removed, std::vector<std::string>& above) {
  const std::vector<std::uint32_t> loose = removed.fastened;
  for (const std::uint32_t id : loose) {
    Body& each = body(id);
    (void)unfasten(each);
    carry(each, std::nullopt);
    bring_fastened(each);
    if (each.object.fixed) std::erase(above, each.object.name);
  }
}

}  // namespace armlet
