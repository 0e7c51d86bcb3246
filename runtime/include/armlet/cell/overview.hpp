#pragma once
// Views of a whole cell, for pictures that no camera of a program takes.

#include <Eigen/Geometry>

#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/scene.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

// The pose and the lens of a picture.
struct Viewpoint {
  Pinhole lens;
  Eigen::Isometry3d T_world_camera;
};

// The picture from a viewpoint, with four samples in each pixel.
//
// throws  ArgumentError as Renderer::render does.
[[nodiscard]] Image picture_from(const Viewpoint& from, const Scene& scene);

// Finds a viewpoint from which boxes are seen from the front, the right and above (from +x, -y,
// +z), as close as possible with a margin of a twentieth of the picture.
class Overview {
 public:
  // width, height  of the picture, px.
  // throws         ArgumentError for sides below 1 or above Image::kMostSide.
  Overview(int width, int height);

  // Adds the eight corners of a box, given in its own frame.
  //
  // throws  ArgumentError for an empty box and numbers that are not finite.
  void add(const Eigen::AlignedBox3d& box, const Eigen::Isometry3d& T_world_box);
  // Adds what a picture of a cell should show: its robots and their surroundings up to half their
  // size; without robots, everything. Floors and walls beyond that are cut off.
  //
  // scene  of this cell, at this instant (Cameras::scene).
  void add(const Cell& cell, const Scene& scene);

  // The viewpoint for the boxes added so far; for a metre about the origin if there are none.
  [[nodiscard]] Viewpoint viewpoint() const;

 private:
  [[nodiscard]] Viewpoint place() const;

  Intrinsics lens_;
  Eigen::Matrix3d R_;  // of the camera in the world
  double k_x_, k_y_;   // half the width and height of the view at depth 1
  // Largest values over all points, in the axes of the camera: of x - k_x z, -x - k_x z, y - k_y z,
  // -y - k_y z, and z.
  double right_, left_, down_, up_, far_;
  double nearest_;  // least z
};

}  // namespace armlet
