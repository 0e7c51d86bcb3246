#pragma once
// The scene before a camera: surfaces of bodies, a light and the ground.

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "armlet/camera/texture.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Triangles in the frame of a body, made once and drawn in every picture.
//
// positions  m.
// normals    unit vectors, one for each position; empty: every triangle is flat.
// on_image   point of the texture at each position, 0 to 1 from its upper left corner; empty: there
//            is no texture.
// corners    three positions of each triangle, counterclockwise seen from outside.
// materials  index of the material of each triangle; empty: the first one.
// closed     whether the surface encloses a body: then its triangles are not drawn from inside.
//            Others are drawn from both sides.
// features   points that count as the corners of the body (seen_corners).
struct SurfaceParts {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3f> normals{};
  std::vector<Eigen::Vector2f> on_image{};
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint8_t> materials{};
  bool closed = true;
  std::vector<Eigen::Vector3d> features{};
};

// A checked surface, with its bounding box and bounding ball.
class Surface {
 public:
  // throws  ArgumentError with the error: no triangles, a position that does not exist, arrays
  //         whose lengths do not match, a number that is not finite or beyond 10 km.
  explicit Surface(SurfaceParts parts);

  [[nodiscard]] const SurfaceParts& parts() const { return parts_; }
  [[nodiscard]] const Eigen::Vector3d& low() const { return low_; }
  [[nodiscard]] const Eigen::Vector3d& high() const { return high_; }
  [[nodiscard]] const Eigen::Vector3d& middle() const { return middle_; }
  [[nodiscard]] double radius() const { return radius_; }  // of the ball about the middle, m
  [[nodiscard]] int material_count() const { return material_count_; }  // the highest one + 1
  // A hash of all that is drawn.
  [[nodiscard]] std::uint64_t fingerprint() const { return fingerprint_; }

 private:
  SurfaceParts parts_;
  Eigen::Vector3d low_, high_, middle_;
  double radius_ = 0.0;
  int material_count_ = 1;
  std::uint64_t fingerprint_ = 0;
};

// texture  its colours are multiplied by `color`; null: none.
struct Material {
  LinearRgb color{0.5F, 0.5F, 0.5F};
  std::shared_ptr<const Texture> texture{};
};

// surface  shared by bodies of the same shape and by pictures; must not be null when drawn.
struct SceneBody {
  std::string name;
  std::shared_ptr<const Surface> surface;
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  std::vector<Material> materials{Material{}};
  bool casts_shadow = true;
};

// A surface of reflectance c has the brightness c (ambient + key max(0, n . l)) in the light, and c
// ambient in the shadow. Ambient light comes from a sky that is brighter above.
//
// towards           direction to the light, in the world; any length but zero.
// key               strength of the directed light.
// sky_up, sky_down  ambient light of surfaces that face up or down, linear in between.
// shadows           whether bodies cast shadows.
struct Light {
  Eigen::Vector3d towards{-0.35, -0.95, 1.6};
  double key = 0.62;
  double sky_up = 0.45;
  double sky_down = 0.25;
  bool shadows = true;

  // A light in which every surface has its own colour, in any orientation.
  static Light flat() { return {.key = 0.0, .sky_up = 1.0, .sky_down = 1.0, .shadows = false}; }
};

// A plane at height z of the world that is seen from above, with lines every metre and finer ones
// every tenth of a metre. It fades into the background towards the camera's `far`.
struct Ground {
  bool drawn = true;
  bool grid = true;
  double z = 0.0;
  LinearRgb color{0.52F, 0.54F, 0.57F};
  LinearRgb line{0.27F, 0.29F, 0.33F};
};

struct Scene {
  std::vector<SceneBody> bodies{};
  Light light{};
  Ground ground{};
  LinearRgb background{0.78F, 0.81F, 0.85F};
};

// Throws ArgumentError with the wrong body or number: a body without a surface or with fewer
// materials than it needs, a matrix that is not a pose or a position beyond 10 km, a light without
// direction.
void check_scene(const Scene& scene);
// Throws ArgumentError unless the scene has a body of that number, from 0.
void check_body(const Scene& scene, int body);

}  // namespace armlet
