#pragma once
// What a camera sees: surfaces of bodies, a light and the ground.

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
// on_image   where each position lies on a picture, 0 to 1 from its upper left corner; empty: there
//            is no picture.
// corners    three positions of each triangle, counterclockwise seen from outside.
// materials  which material of the body each triangle has; empty: the first one.
// closed     whether it surrounds a body: its triangles are not drawn from inside. Others are drawn
//            from both sides.
// features   points whose pixels are asked for as the corners of the body.
struct SurfaceParts {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3f> normals{};
  std::vector<Eigen::Vector2f> on_image{};
  std::vector<std::array<std::uint32_t, 3>> corners;
  std::vector<std::uint8_t> materials{};
  bool closed = true;
  std::vector<Eigen::Vector3d> features{};
};

// Parts that fit together, with a box and a ball around them.
class Surface {
 public:
  // throws  ArgumentError that says what is wrong: no triangles, a position that does not exist,
  //         arrays of other lengths than they need, a number that is not finite or beyond 10 km.
  explicit Surface(SurfaceParts parts);

  [[nodiscard]] const SurfaceParts& parts() const { return parts_; }
  [[nodiscard]] const Eigen::Vector3d& low() const { return low_; }
  [[nodiscard]] const Eigen::Vector3d& high() const { return high_; }
  [[nodiscard]] const Eigen::Vector3d& middle() const { return middle_; }
  [[nodiscard]] double radius() const { return radius_; }  // of the ball about the middle, m
  [[nodiscard]] int material_count() const { return material_count_; }  // the highest one + 1
  // A hash of what is drawn of it.
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

// surface  shared by bodies of the same shape and by pictures; never null when it is drawn.
struct SceneBody {
  std::string name;
  std::shared_ptr<const Surface> surface;
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  std::vector<Material> materials{Material{}};
  bool casts_shadow = true;
};

// A surface of reflectance c looks c (ambient + key max(0, n . l)) where the light reaches it, and
// c ambient in the shadow. Ambient light comes from a sky that is brighter above.
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

  // Every surface shows its own colour, whichever way it faces.
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

// Throws ArgumentError that names the body or number that is wrong: a body without a surface or
// with fewer materials than that needs, a pose that is none or beyond 10 km, a light from nowhere.
void check_scene(const Scene& scene);
// Throws ArgumentError unless the scene has a body of that number, counted from 0.
void check_body(const Scene& scene, int body);

}  // namespace armlet
