#include "armlet/camera/pinhole.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "random_pose.hpp"
#include "refusal_of.hpp"

using namespace armlet;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  std::stringstream rest(line.substr(line.find(',') + 1));
  for (std::string field; std::getline(rest, field, ',');) numbers.push_back(std::stod(field));
  return numbers;
}

Intrinsics random_camera(Random& random) {
  Intrinsics i = intrinsics_from_fov(640, 480, random.uniform(0.5, 1.4));
  i.fy *= random.uniform(0.9, 1.1);
  i.cx += random.uniform(-20.0, 20.0);
  i.cy += random.uniform(-20.0, 20.0);
  i.distortion = {random.uniform(-0.3, 0.2), random.uniform(-0.05, 0.1),
                  random.uniform(-0.003, 0.003), random.uniform(-0.003, 0.003),
                  random.uniform(-0.02, 0.02)};
  return i;
}

}  // namespace

TEST_CASE("points lie where OpenCV projects them") {
  std::ifstream file(ARMLET_REFERENCE_DIR "/vision/project_points.csv");
  REQUIRE(file.is_open());
  Intrinsics i;
  int points = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#")) continue;
    const std::vector<double> n = numbers_of(line);
    if (line.starts_with("camera")) {
      i = {.fx = n[0], .fy = n[1], .cx = n[2], .cy = n[3]};
      i.distortion = {n[4], n[5], n[6], n[7], n[8]};
      continue;
    }
    const Result<Vector2d> pixel = Pinhole(i).project({n[0], n[1], n[2]});
    REQUIRE(pixel);
    CHECK((pixel.value() - Vector2d(n[3], n[4])).norm() < 1e-10);
    ++points;
  }
  CHECK(points == 40);
}

TEST_CASE("pixels lead back to the points that are seen at them") {
  Random random(1);
  int seen = 0;
  for (int k = 0; k < 500; ++k) {
    const Pinhole camera(random_camera(random));
    for (int n = 0; n < 20; ++n) {
      const double z = random.uniform(0.05, 5.0);
      const Vector3d p(z * random.uniform(-0.9, 0.9), z * random.uniform(-0.7, 0.7), z);
      const Result<Vector2d> pixel = camera.project(p);
      if (!pixel) continue;
      // Next to the fold a pixel says little about the radius, where rounding counts more.
      if ((p.head<2>() / z).norm() > 0.95 * camera.largest_radius()) continue;
      ++seen;
      const Result<Vector3d> back = camera.unproject(pixel.value(), z);
      REQUIRE(back);
      CHECK((back.value() - p).norm() < 1e-10);
      const Result<Vector2d> again = camera.project(back.value());
      REQUIRE(again);
      CHECK((again.value() - pixel.value()).norm() < 1e-10);
    }
  }
  CHECK(seen > 5000);
}

TEST_CASE("distances that distortion folds back are refused in both directions") {
  Intrinsics i = intrinsics_from_focal(640, 480, 400.0);
  i.distortion = {-0.3, 0.0, 0.0, 0.0, 0.0};  // r - 0.3 r^3 is largest at r = 1 / sqrt(0.9)
  const Pinhole camera(i);
  const double fold = 1.0 / std::sqrt(0.9);
  CHECK(camera.largest_radius() == doctest::Approx(fold).epsilon(1e-12));
  CHECK(camera.project({0.99 * fold, 0.0, 1.0}).ok());
  CHECK(camera.project({1.01 * fold, 0.0, 1.0}).error().code == "beyond_distortion");
  const double edge = 319.5 + 400.0 * (2.0 / 3.0) * fold;
  CHECK(camera.ray({edge - 0.1, 239.5}).ok());
  CHECK(camera.ray({edge + 0.1, 239.5}).error().message ==
        "No point is seen at pixel (600.7, 239.5): the distortion of the camera folds back at "
        "1.054 times the focal length from its axis.");
  CHECK(Pinhole(intrinsics_from_focal(64, 48, 50.0)).largest_radius() ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("undistorted pixels are those of a camera without distortion") {
  Random random(2);
  for (int k = 0; k < 200; ++k) {
    const Intrinsics i = random_camera(random);
    Intrinsics plain = i;
    plain.distortion = {};
    const Vector3d p(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 1.0);
    const Result<Vector2d> pixel = Pinhole(i).project(p);
    REQUIRE(pixel);
    CHECK((Pinhole(i).undistort(pixel.value()).value() - Pinhole(plain).project(p).value()).norm() <
          1e-9);
  }
}

TEST_CASE("the angle of view spans the picture from the left border to the right one") {
  const Pinhole camera(intrinsics_from_fov(640, 480, 1.0));
  CHECK(camera.ray({-0.5, 0.0})->x() == doctest::Approx(-std::tan(0.5)).epsilon(1e-14));
  CHECK(camera.ray({639.5, 0.0})->x() == doctest::Approx(std::tan(0.5)).epsilon(1e-14));
  CHECK(camera.is_inside({-0.5, 479.4}));
  CHECK_FALSE(camera.is_inside({639.5, 10.0}));
}

TEST_CASE("points at or behind the near plane are not projected") {
  const Pinhole camera(intrinsics_from_focal(640, 480, 600.0));
  CHECK(camera.project({0.0, 0.0, 0.011}).ok());
  CHECK(camera.project({0.0, 0.0, 0.01}).error().code == "behind_camera");
  CHECK(camera.project({0.1, 0.0, -2.0}).error().message ==
        "The point (100, 0, -2000) mm of the camera's frame is not in front of the camera: its "
        "depth is -2000 mm, what is seen begins at 10 mm.");
  CHECK_THROWS_AS((void)camera.project({NAN, 0.0, 1.0}), ArgumentError);
  CHECK_THROWS_AS((void)camera.ray({0.0, INFINITY}), ArgumentError);
  CHECK_THROWS_AS((void)camera.unproject({0.0, 0.0}, 0.0), ArgumentError);
}

TEST_CASE("wrong intrinsics are refused with their numbers") {
  CHECK(refusal_of([] { (void)intrinsics_from_focal(0, 100'000, 600.0); }) ==
        "The picture of a camera has sides of 1 to 8192 pixels, not 0 x 100000.");
  CHECK(refusal_of([] { (void)intrinsics_from_fov(640, 480, 3.2); }) ==
        "The angle of view of a camera lies between 0 and 180 deg, not at 183.3 deg.");
  CHECK_THROWS_AS((void)intrinsics_from_fov(640, 480, NAN), ArgumentError);
  CHECK_THROWS_AS((void)intrinsics_from_focal(640, 480, -1.0), ArgumentError);
  Intrinsics i;
  i.near = 30.0;
  CHECK(refusal_of([&] { (void)Pinhole(i); }) ==
        "A camera sees from `near` to `far`: near is 30 m, far 20 m; expected near < far.");
  i = {};
  i.distortion[4] = NAN;
  CHECK(refusal_of([&] { (void)Pinhole(i); }).find("k3") != std::string::npos);
}

TEST_CASE("a camera that looks at a point sees it in the middle, with up upwards") {
  Random random(3);
  const Pinhole camera(intrinsics_from_focal(640, 480, 600.0));
  for (int k = 0; k < 200; ++k) {
    const Vector3d p = random_vector(random, 1.0);
    const Vector3d from =
        p + Vector3d(random.uniform(0.2, 1.0), random.uniform(0.2, 1.0), random.uniform(-1.0, 1.0));
    const Eigen::Isometry3d T_world_eye = looking_at(p, from);
    CHECK(is_rotation(T_world_eye.linear(), 1e-12));
    const Eigen::Isometry3d T_eye_world = T_world_eye.inverse();
    CHECK((camera.project(T_eye_world * p).value() - Vector2d(319.5, 239.5)).norm() < 1e-9);
    const Vector2d above = camera.project(T_eye_world * (p + 0.01 * Vector3d::UnitZ())).value();
    CHECK(above.x() == doctest::Approx(319.5).epsilon(1e-9));
    CHECK(above.y() < 239.5);
  }
}

TEST_CASE("a camera straight above a table has the axes of the world in its picture") {
  const Eigen::Isometry3d T = looking_at({0.3, 0.2, 0.0}, {0.3, 0.2, 1.0});
  CHECK((T.linear() * Vector3d::UnitX() - Vector3d::UnitX()).norm() < 1e-12);
  CHECK((T.linear() * Vector3d::UnitY() + Vector3d::UnitY()).norm() < 1e-12);
  CHECK(is_rotation(looking_at({1, 0, 0}, {0, 0, 0}, {1, 0, 0}).linear(), 1e-12));
  CHECK(refusal_of([] {
          (void)looking_at({0.1, 0, 0}, {0.1, 0, 0});
        }) == "A camera at (100, 0, 0) mm cannot look at (100, 0, 0) mm: it is the same point.");
  CHECK_THROWS_AS((void)looking_at({1, 0, 0}, {0, 0, 0}, {0, 0, 0}), ArgumentError);
}
