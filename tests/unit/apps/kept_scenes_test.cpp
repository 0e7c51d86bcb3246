#include "video/kept_scenes.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "armlet/camera/surfaces.hpp"
#include "armlet/core/random.hpp"

using namespace armlet;
using armlet::cli::KeptScenes;

namespace {

bool is_same_body(const SceneBody& a, const SceneBody& b) {
  return a.name == b.name && a.surface == b.surface && a.casts_shadow == b.casts_shadow &&
         a.T_world_body.matrix() == b.T_world_body.matrix() &&
         a.materials.size() == b.materials.size() &&
         a.materials.front().color == b.materials.front().color &&
         a.materials.front().texture == b.materials.front().texture;
}

bool is_same_scene(const Scene& a, const Scene& b) {
  if (a.bodies.size() != b.bodies.size() || a.ground.z != b.ground.z) return false;
  for (std::size_t i = 0; i < a.bodies.size(); ++i)
    if (!is_same_body(a.bodies[i], b.bodies[i])) return false;
  return a.light.key == b.light.key && a.background == b.background;
}

// One random change, or none.
void change(Scene& scene, Random& random, const std::vector<std::shared_ptr<const Surface>>& all) {
  const double what = random.uniform();
  const auto any = [&random](std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(random.uniform() * static_cast<double>(count)));
  };
  if (what < 0.3) return;
  if (scene.bodies.empty() || what < 0.45) {  // two may have one name
    scene.bodies.insert(
        scene.bodies.begin() + static_cast<std::ptrdiff_t>(any(scene.bodies.size() + 1)),
        {.name = std::string(1, static_cast<char>('a' + any(5))), .surface = all[any(all.size())]});
    return;
  }
  SceneBody& body = scene.bodies[any(scene.bodies.size())];
  if (what < 0.7) body.T_world_body.translation().x() += random.uniform();
  if (what >= 0.7 && what < 0.8) body.materials.front().color.g = random.uniform() < 0.5 ? 0 : 1;
  if (what >= 0.8 && what < 0.85) body.surface = all[any(all.size())];
  if (what >= 0.85 && what < 0.9) scene.ground.z = random.uniform();
  if (what >= 0.9) scene.bodies.erase(scene.bodies.begin());
}

}  // namespace

TEST_CASE("kept scenes are those that were added, and those that changed are known") {
  const std::vector<std::shared_ptr<const Surface>> surfaces{
      std::make_shared<const Surface>(surface_of(Shape(Sphere{0.1}))),
      std::make_shared<const Surface>(surface_of(Shape(Cylinder{0.1, 0.2})))};
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    CAPTURE(trial);
    KeptScenes kept;
    std::vector<Scene> scenes;
    Scene scene;
    for (int i = 0; i < 60; ++i) {
      change(scene, random, surfaces);
      scenes.push_back(scene);
      kept.add(scene);
    }
    REQUIRE(kept.size() == scenes.size());
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      CHECK(is_same_scene(kept.at(i), scenes[i]));
      // Of two bodies of one name that take turns a copy may be kept once more.
      if (i > 0 && kept.is_as_before(i)) CHECK(is_same_scene(scenes[i], scenes[i - 1]));
    }
  }
}

TEST_CASE("a scene that stays as it is is as before") {
  KeptScenes kept;
  Scene scene;
  scene.bodies.push_back(
      {.name = "ball", .surface = std::make_shared<const Surface>(surface_of(Shape(Sphere{0.1})))});
  for (int i = 0; i < 3; ++i) kept.add(scene);
  scene.bodies.front().T_world_body.translation().z() = 0.5;
  kept.add(scene);
  CHECK_FALSE(kept.is_as_before(0));
  CHECK(kept.is_as_before(1));
  CHECK(kept.is_as_before(2));
  CHECK_FALSE(kept.is_as_before(3));
}
