#include "armlet/camera/surfaces.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>
#include <string>

#include "armlet/model/catalog.hpp"
#include "armlet/model/robot_scene.hpp"
#include "mesh_bodies.hpp"
#include "refusal_of.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

TriangleMesh mesh_of(const Surface& surface) {
  return {surface.parts().positions, surface.parts().corners};
}

}  // namespace

TEST_CASE("surfaces of shapes are closed, face outward and hold their volume") {
  const std::vector<std::pair<Shape, double>> shapes{
      {Box{{0.1, 0.2, 0.3}}, 0.006},
      {Cylinder{0.1, 0.3}, std::numbers::pi * 0.003},
      {Sphere{0.1}, 4.0 / 3.0 * std::numbers::pi * 0.001},
      {Cone{0.1, 0.3}, std::numbers::pi * 0.001}};
  for (const auto& [shape, volume] : shapes) {
    const Surface surface = surface_of(shape);
    const std::string body(shape_name(shape));
    CAPTURE(body);
    // Signed tetrahedra; a mesh would reverse itself.
    double sum = 0.0;
    const SurfaceParts& parts = surface.parts();
    for (const auto& c : parts.corners)
      sum += parts.positions[c[0]].dot(parts.positions[c[1]].cross(parts.positions[c[2]])) / 6.0;
    CHECK(sum == doctest::Approx(volume).epsilon(0.01));  // 48 faces for a circle
    CHECK(mesh_of(surface).is_closed());
    for (std::size_t i = 0; i < parts.corners.size(); ++i) {
      const auto& c = parts.corners[i];
      const Vector3d n = (parts.positions[c[1]] - parts.positions[c[0]])
                             .cross(parts.positions[c[2]] - parts.positions[c[0]]);
      for (const std::uint32_t k : c) {
        CHECK(parts.normals[k].norm() == doctest::Approx(1.0).epsilon(1e-6));
        CHECK(parts.normals[k].cast<double>().dot(n) > 0.0);
      }
    }
  }
}

TEST_CASE("pictures on a box and a plane have their right side along x and their top along y") {
  for (const Shape& shape : {Shape(Box{{0.2, 0.1, 0.1}}), Shape(Plane{{0.2, 0.1}})}) {
    const Surface surface = surface_of(shape);
    const SurfaceParts& parts = surface.parts();
    int pictured = 0;
    for (std::size_t i = 0; i < parts.corners.size(); ++i) {
      if (parts.materials[i] != kPicturedMaterial) continue;
      ++pictured;
      for (const std::uint32_t k : parts.corners[i]) {
        CHECK(parts.on_image[k].x() == doctest::Approx(parts.positions[k].x() / 0.2 + 0.5));
        CHECK(parts.on_image[k].y() == doctest::Approx(0.5 - parts.positions[k].y() / 0.1));
      }
    }
    CHECK(pictured == 2);
  }
}

TEST_CASE("features of a box are its upper corners, then its lower ones") {
  const Surface surface = surface_of(Box{{0.2, 0.4, 0.6}});
  const std::vector<Vector3d>& f = surface.parts().features;
  REQUIRE(f.size() == 8);
  CHECK(f[0] == Vector3d(-0.1, -0.2, 0.3));
  CHECK(f[1] == Vector3d(0.1, -0.2, 0.3));
  CHECK(f[2] == Vector3d(0.1, 0.2, 0.3));
  CHECK(f[7] == Vector3d(-0.1, 0.2, -0.3));
  CHECK(surface_of(Plane{}).parts().features.size() == 4);
  CHECK(surface_of(Sphere{}).parts().features.empty());
}

TEST_CASE("an arm is a body for each link, where its nodes are") {
  const GlbScene scene = robot_scene(*make_robot("puma560"));
  const std::vector<SceneBody> bodies = bodies_of(scene);
  CHECK(bodies.size() == 8);
  CHECK(bodies[0].name == "base");
  CHECK_NOTHROW(check_scene({.bodies = bodies}));
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < 3; ++i) T = T * scene.nodes[i].T_parent_node;
  CHECK(bodies[2].T_world_body.isApprox(T, 1e-12));
}

TEST_CASE("surfaces that do not fit together are refused") {
  SurfaceParts parts;
  CHECK(refusal_of([&] { (void)Surface(parts); }) == "A surface has no triangles.");
  parts.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  parts.corners = {{0, 1, 3}};
  CHECK(refusal_of([&] { (void)Surface(parts); }) ==
        "Triangle 0 of a surface has a corner at position 3, but there are 3.");
  parts.corners = {{0, 1, 2}};
  CHECK_NOTHROW((void)Surface(parts));
  parts.normals.resize(2);
  CHECK(refusal_of([&] { (void)Surface(parts); }) ==
        "A surface has 2 normals for 3 positions; expected as many, or none.");
  parts.normals.clear();
  parts.positions[1].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal_of([&] { (void)Surface(parts); }).find("Position 1") == 0);
  CHECK_THROWS_AS((void)surface_of(Mesh{}), ArgumentError);
}
