#pragma once
// The triangles of a scene that may be visible, ready to be drawn.

#include <array>
#include <cstdint>
#include <vector>

#include "armlet/camera/scene.hpp"
#include "camera/raster/fill.hpp"
#include "camera/raster/view.hpp"

namespace armlet::raster {

// The light in pictures: unit vector, and the members of Light as floats.
struct Lighting {
  Eigen::Vector3d towards;
  float key, sky_middle, sky_half;

  explicit Lighting(const Light& light);
  // Ambient light where the normal has the height `up`.
  [[nodiscard]] float sky(float up) const { return sky_middle + sky_half * up; }
};

// The shading data of a triangle.
//
// nearness   1/z.
// is_smooth  key and sky are interpolated: their products with 1/z are linear; otherwise key[0].c
//            and sky.c are the numbers themselves.
// slope      of its plane towards the light, m per m along the axes of the shadow map.
// picture    index of its texture coordinates, -1: no texture.
struct TriangleLook {
  Linear nearness;
  Linear key, sky;
  LinearRgb color;
  std::array<float, 2> slope;
  bool is_smooth;
  bool meets_light;
  std::int32_t picture;
  std::int32_t body;
};

// Texture coordinates of a triangle, as products with 1/z.
struct PicturePlace {
  Linear u, v;
  const Texture* texture;
};

// Axes of the shadow map in the world: x, y across and `towards` along the light.
struct LightFrame {
  Eigen::Vector3d x, y, towards;
  explicit LightFrame(const Eigen::Vector3d& direction);
};

// A vertex of a body in the picture.
//
// is_plain  in front of the camera and within the guard, so that it needs no clipping.
struct SeenVertex {
  Eigen::Vector3d p;  // in the camera's frame
  std::int32_t x, y;
  float nearness, key, up;  // products of the normal with the light and the vertical
  bool is_plain;
};

// A part of the image plane, in pixels, possibly larger than the picture; triangles outside are
// left out.
struct Window {
  int left = 0, top = 0, width = 0, height = 0;
};

// Owns its memory, which is reused for the next picture.
struct SceneTriangles {
  std::vector<DrawnTriangle> drawn;  // number: index of its look
  std::vector<TriangleLook> looks;
  std::vector<PicturePlace> places;
  std::vector<SeenVertex> vertices;  // of one body

  void clear();
  // Adds the triangles of a body that face the camera and whose box meets the window.
  void add(const SceneBody& body, std::int32_t number, const View& view, const Window& window,
           const Lighting& lighting, const LightFrame& light);
};

// Whether a ball about a point of the camera's frame may be visible in a window.
bool may_be_seen(const Eigen::Vector3d& middle, double radius, const Intrinsics& camera,
                 const Window& window);

}  // namespace armlet::raster
