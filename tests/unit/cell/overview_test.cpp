// Pictures of a whole cell: all of what is to be seen is in them, and as large as it can be.

#include "armlet/cell/overview.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;
using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

// How far the corners of a box reach from the middle of the picture towards its border: 1 is the
// border.
double reach(const Viewpoint& from, const AlignedBox3d& box) {
  double most = 0.0;
  const Intrinsics& in = from.lens.intrinsics();
  for (int i = 0; i < 8; ++i) {
    const Vector3d p =
        from.T_world_camera.inverse() * box.corner(static_cast<AlignedBox3d::CornerType>(i));
    const auto pixel = from.lens.project(p);
    REQUIRE(pixel.ok());
    most = std::max({most, std::abs(pixel->x() - in.cx) / (0.5 * in.width),
                     std::abs(pixel->y() - in.cy) / (0.5 * in.height)});
  }
  return most;
}

Viewpoint view_of(const AlignedBox3d& box, int width, int height) {
  Overview view(width, height);
  view.add(box, Isometry3d::Identity());
  return view.viewpoint();
}

Viewpoint view_of(Cell& cell) {
  Overview view(64, 48);
  view.add(cell, cell.cameras().scene(cell));
  return view.viewpoint();
}

Object box_at(std::string name, const Vector3d& size, const Vector3d& p) {
  Object object;
  object.name = std::move(name);
  object.shape = Box{size};
  object.T_world_obj.translation() = p;
  object.fixed = true;
  return object;
}

}  // namespace

TEST_CASE("a box fills its picture and stays in it") {
  Random random(12);
  for (int trial = 0; trial < 300; ++trial) {
    const Vector3d middle(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-1, 3));
    const Vector3d half(random.uniform(0.06, 2), random.uniform(0.06, 2), random.uniform(0.06, 2));
    const AlignedBox3d box(middle - half, middle + half);
    const int width = 100 + static_cast<int>(random.below(900)),
              height = 100 + static_cast<int>(random.below(900));
    const double most = reach(view_of(box, width, height), box);
    CHECK(most == doctest::Approx(0.9).epsilon(1e-6));
  }
}

TEST_CASE("points and flat boxes have a picture, empty ones and endless ones do not") {
  const AlignedBox3d point(Vector3d(1, 2, 3), Vector3d(1, 2, 3));
  CHECK(reach(view_of(point, 64, 48), point) < 0.15);
  const AlignedBox3d plate(Vector3d(-1, -1, 0), Vector3d(1, 1, 0));
  CHECK(reach(view_of(plate, 64, 48), plate) < 0.91);
  CHECK_THROWS_AS((void)view_of(AlignedBox3d(), 64, 48), ArgumentError);
  CHECK_THROWS_AS(
      (void)view_of(AlignedBox3d(Vector3d::Zero(),
                                 Vector3d::Constant(std::numeric_limits<double>::infinity())),
                    64, 48),
      ArgumentError);
  CHECK_THROWS_AS((void)view_of(plate, 0, 48), ArgumentError);
}

TEST_CASE("a picture shows the robots and what is around them, a floor as far as they are large") {
  const auto distance = [](Cell& cell) {
    return view_of(cell).T_world_camera.translation().norm();
  };
  Cell cell;
  CHECK(distance(cell) < 5.0);
  cell.insert(box_at("floor", {100.0, 100.0, 0.1}, {0.0, 0.0, -0.05}));
  CHECK(distance(cell) > 100.0);
  cell.add_robot(make_robot("puma560"), "arm");
  cell.insert(box_at("part", {0.1, 0.1, 0.1}, {0.5, 0.2, 0.05}));
  const Viewpoint from = view_of(cell);
  CHECK(from.T_world_camera.translation().norm() < 10.0);
  const Vector3d tool = cell.T_world_tool(0).translation();
  CHECK(reach(from, AlignedBox3d(tool, tool)) < 0.91);
  CHECK(reach(from, AlignedBox3d(Vector3d(0.45, 0.15, 0.0), Vector3d(0.55, 0.25, 0.1))) < 0.91);
  const Scene scene = cell.cameras().scene(cell);
  const Image picture = picture_from(from, scene);
  CHECK(picture.width() == 64);
  CHECK(picture.height() == 48);
  CHECK(picture == picture_from(from, scene));
}
