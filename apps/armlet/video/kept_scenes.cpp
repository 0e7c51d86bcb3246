#include "video/kept_scenes.hpp"

#include <algorithm>
#include <utility>

namespace armlet::cli {
namespace {

bool is_same(const Material& a, const Material& b) {
  return a.color == b.color && a.texture == b.texture;
}

bool is_same(const SceneBody& a, const SceneBody& b) {
  return a.surface == b.surface && a.T_world_body.matrix() == b.T_world_body.matrix() &&
         a.casts_shadow == b.casts_shadow &&
         std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                    [](const Material& one, const Material& other) { return is_same(one, other); });
}

}  // namespace

std::uint32_t KeptScenes::number_of(const SceneBody& body) {
  const auto next = static_cast<std::uint32_t>(bodies_.size());
  const auto [last, is_new] = last_.try_emplace(body.name, next);
  if (!is_new && is_same(bodies_[last->second], body)) return last->second;
  bodies_.push_back(body);
  last->second = next;
  return next;
}

void KeptScenes::add(const Scene& scene) {
  Kept now;
  now.ground_z = scene.ground.z;
  now.bodies.reserve(scene.bodies.size());
  for (const SceneBody& body : scene.bodies) now.bodies.push_back(number_of(body));
  if (kept_.empty()) {
    around_ = scene;
    around_.bodies.clear();
  }
  if (kept_.empty() || kept_.back() != now) kept_.push_back(std::move(now));
  scenes_.push_back(static_cast<std::uint32_t>(kept_.size() - 1));
}

Scene KeptScenes::at(std::size_t i) const {
  const Kept& kept = kept_[scenes_[i]];
  Scene scene = around_;
  scene.ground.z = kept.ground_z;
  scene.bodies.reserve(kept.bodies.size());
  for (const std::uint32_t number : kept.bodies) scene.bodies.push_back(bodies_[number]);
  return scene;
}

}  // namespace armlet::cli
