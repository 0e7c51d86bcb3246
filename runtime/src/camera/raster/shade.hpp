#pragma once
// Colours of pixels from the triangles that are seen there.

#include "armlet/camera/scene.hpp"
#include "camera/raster/shadow_map.hpp"
#include "camera/raster/srgb_tables.hpp"
#include "camera/raster/triangles.hpp"

namespace armlet::raster {

inline constexpr std::int32_t kBackground = -1;
inline constexpr std::int32_t kGroundNumber = -2;

// The ground in a picture.
//
// nearness  1/z where it is seen; elsewhere below that of `far`.
// x, y      world coordinates as products with 1/z, from `origin`.
struct GroundView {
  bool is_seen = false;
  Linear nearness, x, y;
  Eigen::Vector2d origin{0.0, 0.0};

  GroundView() = default;
  GroundView(const Ground& ground, const View& view);
};

// Neighbouring pixels of one row: the first at (u, v), `count` of them, one pixel apart.
struct PixelRun {
  double u, v;
  int count;
};

class Shader {
 public:
  Shader(const Scene& scene, const View& view, const SceneTriangles& triangles,
         const ShadowMap& shadows, const GroundView& ground, const Lighting& lighting);

  // Writes three bytes for each pixel of a run that shows the same triangle, the ground or the
  // background.
  void shade(std::int32_t number, const PixelRun& run, std::uint8_t* out) const;

  // Whether the colour changes so much within a pixel that each of its samples is computed.
  [[nodiscard]] bool is_pictured(std::int32_t number) const {
    return number >= 0 && triangles_.looks[static_cast<std::size_t>(number)].picture >= 0;
  }

 private:
  struct Lights;
  struct Steps;
  void shade_triangle(const TriangleLook& look, const PixelRun& run, std::uint8_t* out) const;
  void shade_picture(const TriangleLook& look, const PixelRun& run, std::uint8_t* out) const;
  void shade_ground(const PixelRun& run, std::uint8_t* out) const;
  [[nodiscard]] F4 lines_at(F4 x, F4 y, F4 width_x, F4 width_y, float spacing, float half) const;
  void write(F4 r, F4 g, F4 b, int count, std::uint8_t* out) const;

  const View& view_;
  const SceneTriangles& triangles_;
  const ShadowMap& shadows_;
  const GroundView& ground_view_;
  const Ground& ground_;
  LinearRgb background_;
  std::array<std::uint8_t, 3> background_bytes_;
  const SrgbTables& tables_;
  float ground_sky_, ground_key_;
  std::array<float, 2> ground_slope_;
};

}  // namespace armlet::raster
