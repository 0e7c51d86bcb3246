#include <doctest/doctest.h>

#include "armlet/camera/renderer.hpp"
#include "count_allocations.hpp"
#include "sample_scenes.hpp"

using namespace armlet;
using namespace armlet::test;

TEST_CASE("pictures of one size after the first allocate nothing") {
  Renderer renderer;
  Pictures pictures;
  const Scene scene = pictured();
  const PictureOptions all{.depth = true, .bodies = true};
  for (const bool distorted : {false, true}) {
    Intrinsics i = intrinsics_from_fov(160, 120, 0.9);
    if (distorted) i.distortion[0] = -0.2;
    const Pinhole camera(i);
    const Eigen::Isometry3d T = looking_at({0.4, 0.0, 0.0}, {0.5, -0.5, 0.5});
    renderer.render(scene, camera, T, all, pictures);
    const long before = allocations;
    for (int n = 0; n < 3; ++n) renderer.render(scene, camera, T, all, pictures);
    CHECK(allocations == before);
  }
}
