// Bodies that fall straight down together.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/world/world.hpp"
#include "world/support.hpp"

namespace armlet {
namespace {

// A sheet that lies on a surface carries what falls onto it.
constexpr double kSameHeight = 1e-9;  // m

}  // namespace

std::optional<double> World::rests_at(const Object& falling, const Object& below) const {
  if (resting_ != nullptr && !(has_plain_footprint(falling) && has_plain_footprint(below)))
    return resting_(falling, below);
  return resting_height(falling, below);
}

// Distance of a part from a body below it onto which it would fall.
std::optional<double> World::gap_above(const Object& part, const Object& below) const {
  const auto z_rest = rests_at(part, below);
  if (!z_rest) return std::nullopt;
  const double gap = part.T_world_obj.translation().z() - *z_rest;
  return gap < -kRestTolerance ? std::nullopt : std::optional(gap);
}

// The fall of a body with what is fastened on it, down to the first surface; the bodies `falls` are
// ignored.
std::optional<Drop> World::fall(const Body& falling, const std::set<std::uint32_t>& falls) const {
  const std::vector<const Body*> parts = compound(falling);
  std::set<std::uint32_t> own;
  for (const Body* part : parts) own.insert(part->id);
  std::optional<Drop> drop;
  const auto consider = [&](double gap, const std::string& support, bool is_sheet) {
    if (gap < -kRestTolerance) return;
    if (drop && gap >= drop->distance + (is_sheet ? kSameHeight : 0.0)) return;
    drop = Drop{.distance = gap, .support = support};
  };
  for (const Body* part : parts) {
    const double z = part->object.T_world_obj.translation().z();
    if (floor_z_) consider(z - (*floor_z_ + half_height(part->object)), "floor", false);
    for (const std::uint32_t id : in_column(part->object)) {
      if (falls.contains(id) || own.contains(id)) continue;
      const Object& each = body(id).object;
      if (const auto gap = gap_above(part->object, each))
        consider(*gap, each.name, std::holds_alternative<Plane>(each.shape));
    }
  }
  return drop;
}

// Only bodies in the same columns can be above one another.
std::vector<std::vector<World::Above>> World::find_above(const std::vector<Parts>& parts) const {
  std::unordered_map<std::uint32_t, std::size_t> owner;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const Body* part : parts[i]) owner.emplace(part->id, i);
  }
  std::vector<std::vector<Above>> above(parts.size());
  for (std::size_t j = 0; j < parts.size(); ++j) {
    std::set<std::size_t> in_columns;
    for (const Body* lower : parts[j]) {
      for (const std::uint32_t id : in_column(lower->object)) {
        const auto found = owner.find(id);
        if (found != owner.end() && found->second != j) in_columns.insert(found->second);
      }
    }
    for (const std::size_t i : in_columns) {
      for (const Body* lower : parts[j]) {
        for (const Body* part : parts[i]) {
          if (const auto gap = gap_above(part->object, lower->object))
            above[j].push_back({i, std::max(*gap, 0.0), lower});
        }
      }
    }
  }
  return above;
}

// The distances d obey d_i <= d_j + gap for every body i that is above another one j of them, and
// d_i <= the distance that `fall` returns; the largest such distances are shortest paths in the
// graph of the gaps.
//
// source  T. H. Cormen et al., Introduction to Algorithms, 3rd edition, 2009, 24.4 (difference
//         constraints), by the algorithm of Dijkstra.
std::vector<World::Landing> World::land(const std::vector<std::size_t>& roots) const {
  const std::size_t n = roots.size();
  std::set<std::uint32_t> falls;
  std::vector<Parts> parts;
  for (const std::size_t root : roots) {
    parts.push_back(compound(*bodies_[root]));
    for (const Body* part : parts.back()) falls.insert(part->id);
  }
  std::vector<std::optional<Drop>> drops;
  for (const std::size_t root : roots) drops.push_back(fall(*bodies_[root], falls));
  const std::vector<std::vector<Above>> above = find_above(parts);
  std::vector<bool> has_below(n, false);
  for (const std::vector<Above>& each : above) {
    for (const Above& upper : each) has_below[upper.who] = true;
  }
  // A body with nothing below it does not fall.
  for (std::size_t i = 0; i < n; ++i) {
    if (!drops[i] && !has_below[i]) drops[i] = Drop{};
  }
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto key = [&](std::size_t i) {
    return std::pair(drops[i] ? drops[i]->distance : kUnknown, i);
  };
  std::set<std::pair<double, std::size_t>> waiting;
  for (std::size_t i = 0; i < n; ++i) waiting.insert(key(i));
  std::vector<Landing> landings;
  while (!waiting.empty()) {
    const std::size_t next = waiting.begin()->second;
    waiting.erase(waiting.begin());
    const Drop landed = drops[next].value_or(Drop{});
    landings.push_back({roots[next], landed});
    for (const Above& each : above[next]) {
      std::optional<Drop>& drop = drops[each.who];
      const double distance = landed.distance + each.gap;
      const bool is_sheet = std::holds_alternative<Plane>(each.on->object.shape);
      if (drop && distance >= drop->distance + (is_sheet ? kSameHeight : 0.0)) continue;
      const bool is_waiting = waiting.erase(key(each.who)) > 0;
      drop = Drop{.distance = distance, .support = each.on->object.name};
      if (is_waiting) waiting.insert(key(each.who));
    }
  }
  return landings;
}

// A body that rests on a carried one is carried by the same robot.
void World::ride(Body& body) {
  if (body.object.fixed || carried_.empty()) return;
  const auto under = fall(body);
  if (!under || std::abs(under->distance) > kRestTolerance) return;
  const Body* lower = find_body(under->support);
  if (lower == nullptr || !lower->attachment) return;
  const Eigen::Isometry3d T_lower_body =
      lower->object.T_world_obj.inverse() * body.object.T_world_obj;
  carry(body, Attachment{.carrier = lower->attachment->carrier,
                         .T_carrier_obj = lower->attachment->T_carrier_obj * T_lower_body,
                         .on = lower->object.name,
                         .frame = lower->attachment->frame,
                         .mounted = lower->attachment->mounted});
}

// Moves a body to where it comes to rest. The sum of gaps is exact to rounding; on its support it
// gets the height that it would have if it had fallen alone.
void World::put_down(Body& body, const Drop& drop) {
  double& z = body.object.T_world_obj.translation().z();
  z -= drop.distance;
  has_moved(body);
  const Object* support = find(drop.support);
  if (support == nullptr || !body.fastened.empty()) return;
  const auto z_rest = rests_at(body.object, *support);
  if (z_rest && std::abs(*z_rest - z) <= kRestTolerance) z = *z_rest;
  has_moved(body);
}

// Lets all bodies fall together, beginning with the smallest distance.
std::vector<Fall> World::settle(const std::vector<std::string>& names) {
  std::vector<std::size_t> roots;
  for (const std::string& name : names) {
    const std::size_t i = index_of(name);
    if (bodies_[i]->fastened_on.empty()) roots.push_back(i);
  }
  for (const std::size_t i : roots) carry(*bodies_[i], std::nullopt);
  const std::vector<Landing> landings = land(roots);
  std::vector<Fall> falls;
  for (const Landing& each : landings) {
    Body& body = *bodies_[each.body];
    if (each.drop.distance > kRestTolerance) {
      put_down(body, each.drop);
      falls.push_back({.name = body.object.name, .drop = each.drop});
    }
    bring_fastened(body);
  }
  for (const Landing& each : landings) {
    ride(*bodies_[each.body]);
    bring_fastened(*bodies_[each.body]);
  }
  const auto bottom = [this](const Fall& each) {
    const Object& object = at(each.name);
    return object.T_world_obj.translation().z() - half_height(object);
  };
  std::ranges::stable_sort(falls, {}, bottom);
  return falls;
}

Drop World::drop(std::string_view name) {
  std::vector<std::string> falling = stacked_on(name);
  Body& dropped = body(name);
  (void)unfasten(dropped);
  falling.insert(falling.begin(), dropped.object.name);
  for (const Fall& each : settle(falling)) {
    if (each.name == name) return each.drop;
  }
  // It rests there already, within the tolerance.
  const Drop drop = fall(dropped).value_or(Drop{});
  put_down(dropped, drop);
  bring_fastened(dropped);
  return drop;
}

std::string World::resting_on(std::string_view name) const {
  const auto drop = fall(body(name));
  return drop && std::abs(drop->distance) <= kRestTolerance ? drop->support : std::string();
}

}  // namespace armlet
