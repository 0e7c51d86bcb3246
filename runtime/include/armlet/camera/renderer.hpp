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

// Where no body is seen.
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

// What was asked for; the rest stays as it was.
//
// depth   z in the camera's frame, m; 0 where nothing is seen between near and far.
// bodies  row by row, the number of the body in the scene, kGroundBody or kNoBody.
struct Pictures {
  Image color;
  Image depth;
  std::vector<std::int32_t> bodies;
};

// Draws scenes with a z-buffer over edges in 24.8 fixed-point numbers. It keeps its memory:
// pictures of one size after the first allocate nothing. Only additions, multiplications, divisions
// and square roots of IEEE 754 numbers and whole numbers decide on a pixel.
//
// A camera with distortion is drawn without it, as large as it sees, and every pixel then takes
// what lies at its ray: colours between four pixels, depths and bodies of the nearest one. So
// straight lines bend without being cut into short ones first. Pixels without a ray are black and
// show no body.
//
// A closed body is not seen from inside: with the camera in it, what lies behind it is seen.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  // T_world_eye  pose of the camera.
  // throws       ArgumentError for what check_scene and check_pose refuse, samples other than 1 and
  //              4, and a distortion whose picture without it has a side above Image::kMostSide.
  // source       J. Pineda, A parallel algorithm for polygon rasterization, Computer Graphics
  //              22(4), 1988 (edges and their rule); shadows: L. Williams, 1978.
  void render(const Scene& scene, const Pinhole& camera, const Eigen::Isometry3d& T_world_eye,
              const PictureOptions& options, Pictures& pictures);

  // Share of the pixels of a body that is not hidden by others and lies in the picture, 0 to 1: of
  // those that it covers alone, up to one picture beyond each border. 0 if it covers none. Of a
  // camera with distortion it is counted without it.
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
