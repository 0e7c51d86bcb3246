#pragma once
// The parts of a scene that the light reaches.

#include "armlet/camera/scene.hpp"
#include "camera/raster/triangles.hpp"

namespace armlet::raster {

// Heights, towards the light, of the surfaces nearest to it, in squares of one size over the
// visible part of the scene: along its longer side 1.6 times as many squares as the picture has
// pixels.
//
// source  L. Williams, Casting curved shadows on curved surfaces, Computer Graphics 12(3), 1978;
//         the mean of four comparisons: W. T. Reeves, D. H. Salesin, R. L. Cook, Rendering
//         antialiased shadows with depth maps, Computer Graphics 21(4), 1987.
class ShadowMap {
 public:
  static constexpr int kMostSquares = 1024;  // along a side

  // Draws the bodies that cast shadows.
  void draw(const Scene& scene, const View& view, const LightFrame& light);

  void clear() { columns_ = 0; }
  // Whether no body casts a shadow in the picture.
  [[nodiscard]] bool is_empty() const { return columns_ == 0; }

  // Coordinates in the map of the point at depth 1/w at a pixel: x.at(u, v) / w + x0; in squares,
  // for h in metres.
  [[nodiscard]] const Linear& x() const { return x_; }
  [[nodiscard]] const Linear& y() const { return y_; }
  [[nodiscard]] const Linear& h() const { return h_; }
  [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; }
  [[nodiscard]] float square() const { return static_cast<float>(square_); }  // m

  // Share of the light, 0 to 1, at a point of a plane with slopes in m per square.
  [[nodiscard]] float light_at(float x, float y, float h, float slope_x, float slope_y) const {
    if (!(x >= 0.0F && y >= 0.0F && x < last_x_ && y < last_y_)) return 1.0F;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    const float right = x - static_cast<float>(column), below = y - static_cast<float>(row);
    const float* at = rows_.nearness.data() + static_cast<std::size_t>(row) * rows_.stride +
                      static_cast<std::size_t>(column);
    const float* under = at + rows_.stride;
    const float plane = h + bias_ - right * slope_x - below * slope_y;
    const float a = at[0] > plane ? 0.0F : 1.0F;
    const float b = at[1] > plane + slope_x ? 0.0F : 1.0F;
    const float c = under[0] > plane + slope_y ? 0.0F : 1.0F;
    const float d = under[1] > plane + slope_x + slope_y ? 0.0F : 1.0F;
    const float above = a + right * (b - a);
    return above + below * (c + right * (d - c) - above);
  }

 private:
  struct Extent;
  [[nodiscard]] bool choose_part(const Scene& scene, const View& view, const LightFrame& light);
  void draw_body(const SceneBody& body, const LightFrame& light);
  void add_triangle(const SurfaceParts& parts, std::size_t i);
  void fill_part(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& p,
                 const Eigen::Vector3d& n);

  SampleRows rows_;
  SampleGrid grid_;
  std::vector<Eigen::Vector3d> points_;  // of one body: squares, squares, metres
  Eigen::Vector2d corner_{0.0, 0.0};     // of the map along the axes of the light, m
  double square_ = 1.0;
  int columns_ = 0;
  float last_x_ = 0.0F, last_y_ = 0.0F, bias_ = 0.0F;
  Linear x_, y_, h_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace armlet::raster
