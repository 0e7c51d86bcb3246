// Shapes of arms without meshes: whole, connected in every position, and no larger than the arm.

#include "armlet/model/link_shapes.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/model/tool.hpp"

using namespace armlet;

namespace {

// How far a point is outside of a shape; 0: inside.
double distance_to(const LinkShape& shape, const Eigen::Vector3d& p_link) {
  const Eigen::Vector3d p = shape.T_link_shape.inverse() * p_link;
  if (shape.kind == LinkShapeKind::kBox)
    return (p.cwiseAbs() - 0.5 * shape.size).cwiseMax(0.0).norm();
  const double beyond = std::max(0.0, std::abs(p.z()) - 0.5 * shape.length);
  const double aside = std::hypot(p.x(), p.y());
  if (shape.kind == LinkShapeKind::kCapsule)
    return std::max(0.0, std::hypot(aside, beyond) - shape.radius);
  return std::hypot(std::max(0.0, aside - shape.radius), beyond);
}

double nearest(const std::vector<LinkShape>& shapes, int link, const Eigen::Vector3d& p_link) {
  double least = 1e9;
  for (const LinkShape& shape : shapes) {
    if (shape.link == link) least = std::min(least, distance_to(shape, p_link));
  }
  return least;
}

Eigen::Isometry3d row_of(const Robot& robot, int i) {
  return dh_pose(robot.spec().convention, robot.joint(i).dh);
}

// The frames of the shapes at a position: 0 base, i + 1 moving with joint i, n + 1 flange.
std::vector<Eigen::Isometry3d> frames(const Robot& robot, const Eigen::VectorXd& q) {
  const bool is_standard = robot.spec().convention == DhConvention::kStandard;
  std::vector<Eigen::Isometry3d> out{robot.T_world_base()};
  Eigen::Isometry3d T = robot.T_world_base();
  for (int i = 0; i < robot.n(); ++i) {
    if (!is_standard) T = T * row_of(robot, i);
    if (robot.is_revolute(i)) {
      T.rotate(Eigen::AngleAxisd(q[i], Eigen::Vector3d::UnitZ()));
    } else {
      T.translate(Eigen::Vector3d(0.0, 0.0, q[i]));
    }
    out.push_back(T);
    if (is_standard) T = T * row_of(robot, i);
  }
  out.push_back(T);
  return out;
}

double extent(const LinkShape& shape) {
  if (shape.kind == LinkShapeKind::kBox) return 0.5 * shape.size.norm();
  return 0.5 * shape.length + shape.radius;
}

}  // namespace

TEST_CASE("shapes: every arm of the catalogue has a body for each link, of sound size") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const auto robot = make_robot(name);
    const std::vector<LinkShape> shapes = link_shapes(*robot);
    std::vector<int> count(static_cast<std::size_t>(robot->n()) + 2, 0);
    for (const LinkShape& shape : shapes) {
      REQUIRE(shape.link >= 0);
      REQUIRE(shape.link <= robot->n() + 1);
      ++count[static_cast<std::size_t>(shape.link)];
      CHECK(shape.T_link_shape.matrix().allFinite());
      CHECK((shape.T_link_shape.linear().transpose() * shape.T_link_shape.linear())
                .isApprox(Eigen::Matrix3d::Identity(), 1e-12));
      if (shape.kind == LinkShapeKind::kBox) {
        CHECK(shape.size.minCoeff() > 0.0);
      } else {
        CHECK(shape.radius > 0.0);
        CHECK(shape.length > 0.0);
        CHECK(shape.radius < 0.2 * robot->reach());
      }
    }
    for (const int each : count) CHECK(each > 0);
  }
}

// Where a joint is, the links on both sides of it must be, whatever the position.
TEST_CASE("shapes: neighbouring links meet at their joint in every position") {
  Random random(7);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const auto robot = make_robot(name);
    const std::vector<LinkShape> shapes = link_shapes(*robot);
    for (int trial = 0; trial < 20; ++trial) {
      Eigen::VectorXd q(robot->n());
      for (int i = 0; i < robot->n(); ++i)
        q[i] = robot->lower()[i] + random.uniform() * (robot->upper()[i] - robot->lower()[i]);
      const std::vector<Eigen::Isometry3d> T_world_frames = frames(*robot, q);
      for (int i = 0; i <= robot->n(); ++i) {
        CAPTURE(i);
        const auto after = static_cast<std::size_t>(i + 1);
        // A sliding joint is where it was at rest.
        Eigen::Vector3d p_world = T_world_frames[after].translation();
        if (i < robot->n() && !robot->is_revolute(i))
          p_world -= q[i] * T_world_frames[after].linear().col(2);
        const double touch = 1e-9 + 0.02 * robot->reach();
        CHECK(nearest(shapes, i, T_world_frames[after - 1].inverse() * p_world) < touch);
        CHECK(nearest(shapes, i + 1, T_world_frames[after].inverse() * p_world) < touch);
      }
    }
  }
}

TEST_CASE("shapes: an arm is drawn within its reach") {
  Random random(8);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const auto robot = make_robot(name);
    const std::vector<LinkShape> shapes = link_shapes(*robot);
    Eigen::VectorXd q = robot->home();
    // A rod stands out behind its sleeve by its stroke.
    double stroke = 0.0;
    for (int i = 0; i < robot->n(); ++i)
      if (!robot->is_revolute(i)) stroke += robot->upper()[i] - robot->lower()[i];
    for (int trial = 0; trial < 20; ++trial) {
      const std::vector<Eigen::Isometry3d> T_world_frames = frames(*robot, q);
      for (const LinkShape& shape : shapes) {
        const Eigen::Vector3d p =
            T_world_frames[static_cast<std::size_t>(shape.link)] * shape.T_link_shape.translation();
        const double far = (p - robot->T_world_base().translation()).norm();
        CHECK(far <= 1.2 * robot->reach() + stroke + extent(shape));
      }
      for (int i = 0; i < robot->n(); ++i)
        q[i] = robot->lower()[i] + random.uniform() * (robot->upper()[i] - robot->lower()[i]);
    }
  }
}

TEST_CASE("shapes: the tip of every gripper is the tool point") {
  const auto arm = make_robot("scara");
  for (const Tool& tool : {parallel_gripper(0.08), suction_cup(0.015), point_tool(0.1)}) {
    const Robot robot = arm->with_tool(tool);
    bool reaches = false;
    for (const LinkShape& shape : link_shapes(robot)) {
      if (shape.role != LinkShapeRole::kTool && shape.role != LinkShapeRole::kFingerLeft) continue;
      const double half =
          shape.kind == LinkShapeKind::kBox ? 0.5 * shape.size.z() : 0.5 * shape.length;
      const double tip = shape.T_link_shape.translation().z() + half;
      CHECK(tip <= robot.T_flange_tool().translation().z() + 1e-12);
      reaches = reaches || std::abs(tip - robot.T_flange_tool().translation().z()) < 1e-12;
    }
    CHECK(reaches);
  }
  for (const LinkShape& shape : link_shapes(arm->with_tool(Tool{})))
    CHECK(shape.role != LinkShapeRole::kTool);
}
