// The lists and grids that find neighbouring bodies of a world.
#include <algorithm>
#include <utility>

#include "armlet/world/world.hpp"
#include "world/support.hpp"

namespace armlet {
namespace {

// Largest distance of bodies that rest on one another, with rounding.
constexpr double kTouch = 0.001 + kRestTolerance;  // m

void put_in_order(std::vector<std::uint32_t>& ids, std::uint32_t id) {
  const auto at = std::ranges::lower_bound(ids, id);
  if (at == ids.end() || *at != id) ids.insert(at, id);
}

void take_out(std::vector<std::uint32_t>& ids, std::uint32_t id) {
  const auto at = std::ranges::lower_bound(ids, id);
  if (at != ids.end() && *at == id) ids.erase(at);
}

}  // namespace

std::size_t World::index_of_id(std::uint32_t id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(ids_, id) - ids_.begin());
}

World::Body* World::find_body(std::string_view name) {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : &body(found->second);
}

void World::has_moved(const Body& body) {
  const Eigen::Vector3d p = body.object.T_world_obj.translation();
  const double reach = resting_reach(body.object.shape), core = resting_core(body.object.shape);
  near_.put(body.id, p, reach, core);
  columns_.put(body.id, p, reach, core);
}

void World::carry(Body& body, std::optional<Attachment> attachment) {
  const auto lower = [&]() -> Body* {
    const bool rides = body.attachment && !body.attachment->on.empty();
    return rides ? find_body(body.attachment->on) : nullptr;
  };
  if (Body* before = lower()) take_out(before->riding, body.id);
  body.attachment = std::move(attachment);
  if (Body* now = lower()) put_in_order(now->riding, body.id);
  if (body.attachment) {
    carried_.insert(body.id);
  } else {
    carried_.erase(body.id);
  }
}

void World::fasten_to(Body& body, Body& lower) {
  (void)unfasten(body);
  body.fastened_on = lower.object.name;
  put_in_order(lower.fastened, body.id);
  ++fastened_;
}

bool World::unfasten(Body& body) {
  const std::string on = std::exchange(body.fastened_on, {});
  if (on.empty()) return false;
  if (Body* lower = find_body(on)) take_out(lower->fastened, body.id);
  --fastened_;
  return true;
}

// Bodies that overlap deeply neither carry each other nor fall on each other.
std::vector<std::uint32_t> World::touching(const Object& object) const {
  return near_.touching(object.T_world_obj.translation(), resting_reach(object.shape) + kTouch,
                        resting_core(object.shape) - kTouch);
}

std::vector<std::uint32_t> World::in_column(const Object& object) const {
  return columns_.touching(object.T_world_obj.translation(), resting_reach(object.shape) + kTouch,
                           resting_core(object.shape) - kTouch);
}

std::vector<std::size_t> World::carried() const {
  std::vector<std::size_t> indices;
  for (const std::uint32_t id : carried_) indices.push_back(index_of_id(id));
  return indices;
}

std::vector<std::size_t> World::near(const Eigen::Vector3d& middle, double radius) const {
  std::vector<std::size_t> indices;
  for (const std::uint32_t id : near_.touching(middle, radius)) indices.push_back(index_of_id(id));
  return indices;
}

}  // namespace armlet
