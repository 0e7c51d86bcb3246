#include "armlet/camera/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/hash.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/math/pose.hpp"

namespace armlet {
namespace {

constexpr double kFarthest = 1e4;  // m

void check_length(const char* name, std::size_t given, std::size_t expected, const char* of) {
  if (given == 0 || given == expected) return;
  throw ArgumentError(fmt::format("A surface has {} {} for {} {}; expected as many, or none.",
                                  given, name, expected, of));
}

void check_parts(const SurfaceParts& parts) {
  if (parts.corners.empty()) throw ArgumentError("A surface has no triangles.");
  check_length("normals", parts.normals.size(), parts.positions.size(), "positions");
  check_length("places on a picture", parts.on_image.size(), parts.positions.size(), "positions");
  check_length("materials", parts.materials.size(), parts.corners.size(), "triangles");
  for (std::size_t i = 0; i < parts.positions.size(); ++i) {
    for (const double x : parts.positions[i]) {
      if (!(std::abs(x) <= kFarthest)) {
        throw ArgumentError(fmt::format(
            "Position {} of a surface has a coordinate of {} m; expected at most 10 km.", i, x));
      }
    }
  }
  const auto is_finite = [](const auto& v) { return v.allFinite(); };
  if (!std::ranges::all_of(parts.normals, is_finite))
    throw ArgumentError("A normal of a surface is not finite.");
  if (!std::ranges::all_of(parts.on_image, is_finite))
    throw ArgumentError("A place on the picture of a surface is not finite.");
  if (!std::ranges::all_of(parts.features, is_finite))
    throw ArgumentError("A corner of a surface is not finite.");
  for (std::size_t i = 0; i < parts.corners.size(); ++i) {
    for (const std::uint32_t corner : parts.corners[i]) {
      if (corner >= parts.positions.size()) {
        throw ArgumentError(
            fmt::format("Triangle {} of a surface has a corner at position {}, but "
                        "there are {}.",
                        i, corner, parts.positions.size()));
      }
    }
  }
}

template <class T>
void add(Fnv1a& hash, const std::vector<T>& values) {
  hash.add(static_cast<std::uint64_t>(values.size()));
  hash.add_bytes({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
}

std::uint64_t fingerprint_of(const SurfaceParts& parts) {
  Fnv1a hash;
  add(hash, parts.positions);
  add(hash, parts.normals);
  add(hash, parts.on_image);
  add(hash, parts.corners);
  add(hash, parts.materials);
  hash.add(parts.closed ? 1 : 0);
  return hash.value();
}

}  // namespace

Surface::Surface(SurfaceParts parts) : parts_(std::move(parts)) {
  check_parts(parts_);
  low_ = high_ = parts_.positions.front();
  for (const Eigen::Vector3d& p : parts_.positions) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  middle_ = 0.5 * (low_ + high_);
  for (const Eigen::Vector3d& p : parts_.positions)
    radius_ = std::max(radius_, (p - middle_).norm());
  for (const std::uint8_t material : parts_.materials)
    material_count_ = std::max(material_count_, material + 1);
  fingerprint_ = fingerprint_of(parts_);
}

void check_scene(const Scene& scene) {
  check_finite("direction to the light", scene.light.towards);
  if (scene.light.towards.norm() == 0.0)
    throw ArgumentError("The direction to the light is (0, 0, 0); expected a vector.");
  check_finite("key light", scene.light.key);
  check_finite("light of the sky", scene.light.sky_up);
  check_finite("light from below", scene.light.sky_down);
  check_finite("height of the ground", scene.ground.z);
  for (const SceneBody& body : scene.bodies) {
    if (!body.surface)
      throw ArgumentError(fmt::format("The body `{}` of a scene has no surface.", body.name));
    const auto given = static_cast<int>(body.materials.size());
    if (given < body.surface->material_count()) {
      throw ArgumentError(fmt::format("The body `{}` has {} materials; its surface needs {}.",
                                      body.name, given, body.surface->material_count()));
    }
    check_pose(body.name, body.T_world_body);
    if (body.T_world_body.translation().cwiseAbs().maxCoeff() > kFarthest) {
      throw ArgumentError(
          fmt::format("The body `{}` is {:.0f} m from the origin; expected at most "
                      "10 km.",
                      body.name, body.T_world_body.translation().norm()));
    }
  }
}

void check_body(const Scene& scene, int body) {
  if (body >= 0 && static_cast<std::size_t>(body) < scene.bodies.size()) return;
  throw ArgumentError(
      fmt::format("The scene has {} bodies, counted from 0; there is none with the number {}.",
                  scene.bodies.size(), body));
}

}  // namespace armlet
