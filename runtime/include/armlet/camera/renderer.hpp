#pragma once
// Pictures of a scene, computed without a graphics processor, with the same bits on every machine.

#include <cstdint>
#include <memory>
#include <vector>

#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/scene.hpp"
#include "armlet/image/image.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Value of pixels at which no body is seen.
inline constexpr std::int32_t kNoBody = -1;
inline constexpr std::int32_t kGroundBody = -2;

// samples  of the coloured picture in each pixel: 1, in its centre, or 4, in two rows of two.
//          Depths and bodies are always those at the centre.
struct PictureOptions {
  int samples = 4;
  bool color = true;
  bool depth = false;
  bool bodies = false;
};

// The requested pictures; others are unchanged.
//
// depth   z in the camera's frame, m; 0 where nothing is seen between near and far.
// bodies  row by row, the number of the body in the scene, kGroundBody or kNoBody.
struct Pictures {
  Image color;
  Image depth;
  std::vector<std::int32_t> bodies;
};

// Draws scenes with a z-buffer over edges in 24.8 fixed-point numbers. Memory is reused: only the
// first picture of a size allocates. Pixels are computed with additions, multiplications, divisions
// and square roots of IEEE 754 numbers and with integers alone.
//
// For a camera with distortion an undistorted picture of its whole field of view is drawn first;
// every pixel then takes the value at its ray: colours interpolated between four pixels, depths and
// bodies of the nearest one. So straight lines become curves without being divided into short ones.
// Pixels without a ray are black and have no body.
//
// A closed body is not seen from inside: a camera in it sees what is behind it.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  // T_world_eye  pose of the camera.
  // throws       ArgumentError for what check_scene and check_pose refuse, samples other than 1 and
  //              4, and a distortion whose undistorted picture has a side above Image::kMostSide.
  // source       J. Pineda, A parallel algorithm for polygon rasterization, Computer Graphics
  //              22(4), 1988 (edges and their rule); shadows: L. Williams, 1978.
  void render(const Scene& scene, const Pinhole& camera, const Eigen::Isometry3d& T_world_eye,
              const PictureOptions& options, Pictures& pictures);

  // Share of the pixels of a body that are in the picture and not hidden by other bodies, 0 to 1,
  // of all pixels that it would cover alone, up to one picture beyond each border. 0 if it covers
  // none. The distortion of the camera is ignored.
  //
  // body    number in the scene.
  // throws  as render, and for a number that no body has.
  double visible_share(const Scene& scene, const Pinhole& camera,
                       const Eigen::Isometry3d& T_world_eye, int body);

 private:
  class Frame;
  std::unique_ptr<Frame> frame_;
};

}  // namespace armlet
