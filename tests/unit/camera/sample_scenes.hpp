// Scenes that tests of the camera draw.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/surfaces.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "mesh_bodies.hpp"

namespace armlet::test {

inline Eigen::Isometry3d at(double x, double y, double z, double yaw = 0.0, double pitch = 0.0) {
  return pose_from_rpy({x, y, z}, {0.0, pitch, yaw});
}

inline SceneBody body_of(std::string name, const Shape& shape, const Eigen::Isometry3d& T,
                         LinearRgb color, std::shared_ptr<const Texture> picture = nullptr) {
  return {.name = std::move(name),
          .surface = std::make_shared<const Surface>(surface_of(shape)),
          .T_world_body = T,
          .materials = {Material{color},
                        Material{picture ? LinearRgb{1.0F, 1.0F, 1.0F} : color, picture}}};
}

// Squares of 4 x 4 pixels, black and orange, with a white border.
inline std::shared_ptr<const Texture> checks(int side) {
  Image picture(side, side, PixelKind::kRgb);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const bool border = x < 4 || y < 4 || x >= side - 4 || y >= side - 4;
      const bool dark = (x / 4 + y / 4) % 2 == 0;
      std::uint8_t* rgb = picture.row(y) + 3 * x;
      rgb[0] = border ? 255 : dark ? 20 : 235;
      rgb[1] = border ? 255 : dark ? 20 : 150;
      rgb[2] = border ? 255 : dark ? 20 : 40;
    }
  }
  return std::make_shared<const Texture>(picture);
}

inline Scene boxes() {
  Scene scene;
  scene.bodies.push_back(
      body_of("table", Box{{0.8, 0.6, 0.04}}, at(0.4, 0.0, 0.18), {0.5F, 0.42F, 0.33F}));
  scene.bodies.push_back(
      body_of("red", Box{{0.06, 0.06, 0.06}}, at(0.3, 0.05, 0.23, 0.5), {0.6F, 0.05F, 0.05F}));
  scene.bodies.push_back(
      body_of("blue", Box{{0.1, 0.05, 0.08}}, at(0.45, -0.1, 0.24, -0.3), {0.0F, 0.17F, 0.45F}));
  scene.bodies.push_back(body_of("leaning", Box{{0.02, 0.2, 0.12}}, at(0.5, 0.12, 0.27, 0.2, 0.4),
                                 {0.2F, 0.5F, 0.2F}));
  return scene;
}

inline Scene shapes() {
  Scene scene;
  scene.bodies.push_back(body_of("ball", Sphere{0.08}, at(0.3, 0.1, 0.08), {0.8F, 0.35F, 0.05F}));
  scene.bodies.push_back(
      body_of("can", Cylinder{0.05, 0.16}, at(0.45, -0.1, 0.08), {0.1F, 0.4F, 0.6F}));
  scene.bodies.push_back(
      body_of("hat", Cone{0.07, 0.15}, at(0.3, -0.15, 0.075), {0.6F, 0.1F, 0.4F}));
  scene.bodies.push_back(body_of("iron", Mesh{std::make_shared<const TriangleMesh>(angle_iron())},
                                 at(0.5, 0.15, 0.0, 0.7), {0.4F, 0.4F, 0.45F}));
  return scene;
}

inline Scene pictured() {
  Scene scene;
  scene.bodies.push_back(
      body_of("sheet", Plane{{0.3, 0.3}}, at(0.4, 0.0, 0.0, 0.3), {1, 1, 1}, checks(64)));
  scene.bodies.push_back(body_of("box", Box{{0.1, 0.1, 0.1}}, at(0.45, -0.2, 0.05, 0.2),
                                 {0.3F, 0.3F, 0.3F}, checks(32)));
  scene.bodies.push_back(
      body_of("can", Cylinder{0.05, 0.12}, at(0.25, 0.2, 0.06), {0.3F, 0.3F, 0.3F}, checks(32)));
  return scene;
}

// Many facets, some of which cut into one another.
inline Scene balls(int bands, int count = 4) {
  Scene scene;
  const auto mesh = std::make_shared<const TriangleMesh>(ball_mesh(0.12, bands));
  for (int i = 0; i < count; ++i)
    scene.bodies.push_back(body_of("ball", Mesh{mesh},
                                   at(0.25 + 0.12 * (i % 2), -0.2 + 0.13 * i, 0.1 + 0.03 * i),
                                   {0.2F + 0.1F * static_cast<float>(i % 5), 0.4F, 0.6F}));
  return scene;
}

// Facets far larger than the picture, and bodies about the camera.
inline Scene hall() {
  Scene scene = boxes();
  scene.bodies.push_back(
      body_of("wall", Box{{0.1, 60.0, 8.0}}, at(3.0, 0.0, 4.0), {0.6F, 0.6F, 0.55F}));
  scene.bodies.push_back(
      body_of("around", Box{{4.0, 4.0, 4.0}}, at(0.0, 0.0, 1.0), {0.9F, 0.0F, 0.0F}));
  scene.bodies.back().casts_shadow = false;
  scene.bodies.push_back(
      body_of("street", Plane{{500.0, 0.2}}, at(0.0, -0.45, 0.001), {0.2F, 0.2F, 0.25F}));
  return scene;
}

inline Scene flat() {
  Scene scene = shapes();
  scene.light = Light::flat();
  scene.ground.drawn = false;
  return scene;
}

inline std::vector<Scene> sample_scenes() {
  std::vector<Scene> scenes{boxes(), shapes(), pictured(), balls(12), hall(), flat()};
  return scenes;
}

// A camera somewhere about (0.4, 0, 0.15), which it sees.
inline Eigen::Isometry3d random_eye(Random& random) {
  // One after the other: compilers order the arguments of a call as they like.
  const Eigen::Vector3d middle(0.4, 0.0, 0.65), size(0.9, 0.9, 0.35);
  Eigen::Vector3d from, to(0.4, 0.0, 0.15);
  for (int k = 0; k < 3; ++k) from[k] = middle[k] + random.uniform(-size[k], size[k]);
  for (int k = 0; k < 3; ++k) to[k] += random.uniform(-0.1, 0.1);
  return looking_at(to, from);
}

}  // namespace armlet::test
