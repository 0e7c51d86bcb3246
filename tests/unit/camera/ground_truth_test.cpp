#include "armlet/camera/ground_truth.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "ray_caster.hpp"
#include "refusal_of.hpp"
#include "sample_scenes.hpp"

using namespace armlet;
using namespace armlet::test;
using Eigen::Vector3d;

TEST_CASE("a camera above a box sees the four corners of its upper face, in their order") {
  Scene scene;
  scene.bodies.push_back(body_of("box", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 0.05), {}));
  const Pinhole camera(intrinsics_from_focal(640, 480, 600.0));
  const Eigen::Isometry3d T = looking_at({0, 0, 0}, {0.0, 0.0, 0.6});
  const std::vector<SeenCorner> seen = seen_corners(scene, camera, T, 0);
  REQUIRE(seen.size() == 4);
  // 0.05 m beside the axis at a depth of 0.5 m are 60 pixels; y of the world is up.
  constexpr double kSigns[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(seen[k].number == static_cast<int>(k));
    CHECK(seen[k].pixel.x() == doctest::Approx(319.5 + 60.0 * kSigns[k][0]));
    CHECK(seen[k].pixel.y() == doctest::Approx(239.5 + 60.0 * kSigns[k][1]));
  }
  // A lid over two of them.
  scene.bodies.push_back(body_of("lid", Box{{0.1, 0.2, 0.01}}, at(0.08, 0.0, 0.15), {}));
  const std::vector<SeenCorner> rest = seen_corners(scene, camera, T, 0);
  REQUIRE(rest.size() == 2);
  CHECK(rest[0].number == 0);
  CHECK(rest[1].number == 3);
}

TEST_CASE("corners beside the picture, behind the camera and too far are not seen") {
  Scene scene;
  scene.bodies.push_back(body_of("box", Box{{0.1, 0.1, 0.1}}, at(0.0, 0.0, 0.05), {}));
  const Pinhole camera(intrinsics_from_focal(640, 480, 600.0));
  CHECK(seen_corners(scene, camera, looking_at({2, 0, 0}, {2.0, 0.0, 0.6}), 0).empty());
  CHECK(seen_corners(scene, camera, looking_at({0, 0, 2}, {0.0, 0.0, 1.0}), 0).empty());
  CHECK(seen_corners(scene, camera, looking_at({0, 0, 0}, {0.0, 0.0, 30.0}), 0).empty());
  CHECK_THROWS_AS(seen_corners(scene, camera, looking_at({0, 0, 0}, {1, 0, 0}), 1), ArgumentError);
}

TEST_CASE("rays meet the same bodies at the same distances as computed otherwise") {
  Random random(15);
  int met = 0;
  for (const Scene& scene : {boxes(), shapes(), hall()}) {
    for (int n = 0; n < 300; ++n) {
      const Vector3d p{random.uniform(-0.5, 1.2), random.uniform(-0.8, 0.8),
                       random.uniform(0.01, 1.0)};
      const Vector3d d{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                       random.uniform(-1.0, 0.3)};
      const Met expected = cast(scene, p, d, 0.0);
      const std::optional<RayHit> hit = first_hit(scene, p, d);
      REQUIRE(hit.has_value() == std::isfinite(expected.t));
      if (!hit) continue;
      ++met;
      CHECK(hit->body == expected.body);
      CHECK(hit->t == doctest::Approx(expected.t).epsilon(1e-9));
    }
  }
  CHECK(met > 400);
  CHECK_THROWS_AS(first_hit(boxes(), {0, 0, 1}, {0, 0, 0}), ArgumentError);
  CHECK_THROWS_AS(first_hit(boxes(), {0, 0, NAN}, {0, 0, 1}), ArgumentError);
}
