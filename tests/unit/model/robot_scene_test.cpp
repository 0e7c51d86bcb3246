// Arms as triangles: every corner lies on the shape that it belongs to.

#include "armlet/model/robot_scene.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/model/catalog.hpp"
#include "armlet/model/link_shapes.hpp"
#include "armlet/model/tool.hpp"

using namespace armlet;

namespace {

// How far a point is from the surface of a shape, m, where it is near one; corners of triangles on
// caps lie inside of no shape.
double from_surface(const LinkShape& shape, const Eigen::Vector3d& p_link) {
  const Eigen::Vector3d p = shape.T_link_shape.inverse() * p_link;
  const double aside = std::hypot(p.x(), p.y()), h = 0.5 * shape.length;
  if (shape.kind == LinkShapeKind::kBox) return (p.cwiseAbs() - 0.5 * shape.size).norm();
  if (shape.kind == LinkShapeKind::kCapsule)
    return std::abs(std::hypot(aside, std::max(0.0, std::abs(p.z()) - h)) - shape.radius);
  const bool on_end = aside <= shape.radius + 1e-6 && std::abs(std::abs(p.z()) - h) < 1e-6;
  return on_end ? 0.0 : std::hypot(aside - shape.radius, std::max(0.0, std::abs(p.z()) - h));
}

}  // namespace

TEST_CASE(
    "every corner of an arm's triangles lies on one of its shapes, in the frame of its link") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const auto bare = make_robot(name);
    const Robot robot =
        bare->with_tool({.kind = ToolKind::kParallelGripper, .stroke = 0.08, .length = 0.12});
    const std::vector<LinkShape> shapes = link_shapes(robot);
    const GlbScene scene = robot_scene(robot);
    REQUIRE(scene.nodes.size() == static_cast<std::size_t>(robot.n()) + 3);
    for (int link = 0; link < robot.n() + 2; ++link) {
      for (const GlbPart& part : scene.nodes[static_cast<std::size_t>(link)].parts) {
        double worst = 0.0;
        for (const Eigen::Vector3f& each : part.positions) {
          double nearest = 1.0;
          for (const LinkShape& shape : shapes) {
            if (shape.link == link)
              nearest = std::min(nearest, from_surface(shape, each.cast<double>()));
          }
          worst = std::max(worst, nearest);
        }
        CHECK(worst < 1e-6);  // single precision of a metre
      }
    }
  }
}

TEST_CASE("the nodes of an arm stand at home") {
  const auto robot = make_robot("panda");  // modified convention
  const GlbScene scene = robot_scene(*robot);
  for (int i = 0; i < robot->n(); ++i) {
    const GlbNode& node = scene.nodes[static_cast<std::size_t>(i) + 1];
    REQUIRE(node.joint);
    CHECK(node.joint->q == robot->home()[i]);
    CHECK(node.joint->upper == robot->upper()[i]);
    CHECK(node.parent == i);
  }
}
