#include "armlet/cell/cameras.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "armlet/camera/renderer.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

Object box_at(std::string name, const Vector3d& size, const Vector3d& p) {
  Object object;
  object.name = std::move(name);
  object.shape = Box{size};
  object.T_world_obj.translation() = p;
  object.fixed = true;
  return object;
}

Camera above(double height) {
  Camera camera;
  camera.name = "eye";
  camera.T_on_camera = looking_at({0.5, 0.1, 0.0}, {0.4, -0.2, height});
  camera.lens = Pinhole(intrinsics_from_fov(160, 120, 1.0));
  return camera;
}

int add_arm(Cell& cell, const std::string& name) { return cell.add_robot(make_robot(name), "arm"); }

Eigen::VectorXd random_joints(const Robot& robot, Random& random) {
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    q[i] = random.uniform(std::max(-2.0, robot.lower()[i]), std::min(2.0, robot.upper()[i]));
  return q;
}

}  // namespace

TEST_CASE("what is drawn of an arm goes with its links") {
  Random random(7);
  for (const std::string name : {"puma560", "scara", "pa10", "iiwa14", "scorbot"}) {
    CAPTURE(name);
    Cell cell;
    const int arm = add_arm(cell, name);
    const int eye = cell.cameras().add(above(1.0));
    for (int trial = 0; trial < 5; ++trial) {
      cell.set_joints(arm, random_joints(*cell.robot(arm).model, random));
      int flanges = 0;
      for (const SceneBody& body : cell.cameras().scene(cell, eye).bodies) {
        if (body.name != "arm flange") continue;
        ++flanges;
        // Two products for the same frame: rounding of at most eight products.
        CHECK(body.T_world_body.isApprox(cell.T_world_flange(arm), 1e-12));
      }
      CHECK(flanges <= 1);
      const auto bodies = cell.cameras().scene(cell, eye).bodies;
      REQUIRE(!bodies.empty());
      CHECK(bodies.front().T_world_body.isApprox(cell.T_world_base(arm), 1e-12));
    }
  }
}

TEST_CASE("objects are seen where the lens projects them, with their depth") {
  Random random(11);
  Cell cell;
  cell.insert(box_at("one", {0.05, 0.05, 0.05}, {0.5, 0.1, 0.025}));
  cell.insert(box_at("two", {0.04, 0.06, 0.02}, {0.4, 0.0, 0.3}));
  const int eye = cell.cameras().add(above(1.2));
  const Isometry3d T = cell.cameras().T_world_camera(cell, eye);
  const auto ids = cell.cameras().bodies(cell, eye, T);
  const Image depth = cell.cameras().depth(cell, eye, T);
  for (int i = 0; i < 2; ++i) {
    const Object& object = cell.world().object(static_cast<std::size_t>(i));
    const Vector3d top =
        object.T_world_obj * Vector3d(0.0, 0.0, 0.5 * std::get<Box>(object.shape).size.z());
    const Vector3d in_eye = T.inverse() * top;
    const Eigen::Vector2d pixel = *cell.cameras().at(eye).lens.project(in_eye);
    const int u = static_cast<int>(std::lround(pixel.x())),
              v = static_cast<int>(std::lround(pixel.y()));
    CHECK(ids[static_cast<std::size_t>(v * 160 + u)] == i);
    // Half a pixel of an oblique plane at this distance: 0.5 / 146 px of 1.2 m.
    CHECK(depth.depth_row(v)[u] == doctest::Approx(in_eye.z()).epsilon(0.005));
  }
  CHECK(cell.cameras().corners(cell, eye, "two").size() >= 4);
  CHECK(cell.cameras().visible_share(cell, eye, "two") == doctest::Approx(1.0));
  CHECK_THROWS_AS((void)cell.cameras().corners(cell, eye, "three"), ArgumentError);
}

TEST_CASE("a camera goes with what it is on, and shows where it would be") {
  Random random(3);
  Cell cell;
  const int arm = add_arm(cell, "puma560");
  cell.insert(box_at("cart", {0.1, 0.1, 0.1}, {1.0, 1.0, 0.05}));
  Camera camera = above(0.0);
  camera.T_on_camera = pose_from_rpy({0.01, 0.02, 0.06}, {0.1, -0.2, 0.3});
  camera.on = {.base = FrameBase::kCarrier, .on = "arm", .carrier = arm};
  const int eye = cell.cameras().add(camera);
  camera.name = "elbow";
  camera.on.frame = 2;
  const int elbow = cell.cameras().add(camera);
  camera.name = "on the cart";
  camera.on = {.base = FrameBase::kObject, .on = "cart"};
  const int on_cart = cell.cameras().add(camera);
  const Isometry3d T = camera.T_on_camera;
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd q = random_joints(*cell.robot(arm).model, random);
    const Eigen::VectorXd other = random_joints(*cell.robot(arm).model, random);
    cell.set_joints(arm, other);
    const Isometry3d there = cell.T_world_tool(arm);
    const Isometry3d seen_there = cell.cameras().T_world_camera(cell, eye);
    cell.set_joints(arm, q);
    CHECK(cell.cameras().T_world_camera(cell, eye).isApprox(cell.T_world_flange(arm) * T, 1e-12));
    CHECK(
        cell.cameras().T_world_camera(cell, elbow).isApprox(cell.T_world_link(arm, 2) * T, 1e-12));
    CHECK(cell.cameras().T_world_camera_for(cell, eye, there).isApprox(seen_there, 1e-9));
  }
  CHECK_THROWS_AS((void)cell.cameras().T_world_camera_for(cell, elbow, Isometry3d::Identity()),
                  ArgumentError);
  cell.set_pose("cart", pose_from_rpy({0.2, 0.3, 0.05}, {0.0, 0.0, 0.5}));
  CHECK(cell.cameras()
            .T_world_camera(cell, on_cart)
            .isApprox(cell.world().at("cart").T_world_obj * T, 1e-12));
  cell.remove("cart");
  CHECK_THROWS_AS((void)cell.cameras().T_world_camera(cell, on_cart), ArgumentError);
}

TEST_CASE("pictures of a noisy camera differ, and are the same in the same run") {
  const auto taken = [] {
    Cell cell;
    cell.insert(box_at("one", {0.3, 0.3, 0.05}, {0.5, 0.1, 0.025}));
    Camera camera = above(0.9);
    camera.noise = 4.0;
    const int eye = cell.cameras().add(camera);
    const Isometry3d T = cell.cameras().T_world_camera(cell, eye);
    std::vector<Image> images;
    for (int i = 0; i < 2; ++i) {
      images.push_back(cell.cameras().color(cell, eye, T));
      (void)cell.cameras().depth(cell, eye, T);
    }
    return images;
  };
  const auto first = taken(), again = taken();
  CHECK(first == again);
  CHECK_FALSE(first[0] == first[1]);
}

TEST_CASE("what changes its looks is drawn anew, and shapes that are only shown are seen") {
  Cell cell;
  cell.insert(box_at("one", {0.4, 0.4, 0.05}, {0.5, 0.1, 0.025}));
  Camera camera = above(1.0);
  camera.key_light = false;
  const int eye = cell.cameras().add(camera);
  const Isometry3d T = cell.cameras().T_world_camera(cell, eye);
  const Image before = cell.cameras().color(cell, eye, T);
  cell.remove("one");
  Object red = box_at("one", {0.4, 0.4, 0.05}, {0.5, 0.1, 0.025});
  red.color = "red";
  cell.insert(red);
  const Image after = cell.cameras().color(cell, eye, T);
  CHECK_FALSE(before == after);
  const std::uint8_t* middle = after.row(60) + 3 * 80;
  CHECK(middle[0] == 255);
  CHECK(middle[1] == 0);
  for (const DrawingKind kind : {DrawingKind::kArrow, DrawingKind::kLine, DrawingKind::kDisk,
                                 DrawingKind::kEllipsoid, DrawingKind::kCapsule}) {
    Drawing drawing;
    drawing.name = "shown";
    drawing.kind = kind;
    drawing.size = {0.2, 0.05, 0.1};
    drawing.color = "blue";
    drawing.T_on_drawing.translation() = Vector3d(0.5, 0.1, 0.06);
    cell.draw(drawing);
    CAPTURE(std::string(to_text(kind)));
    CHECK_FALSE(cell.cameras().color(cell, eye, T) == after);
  }
}

TEST_CASE("surfaces of what is gone are forgotten, those of the rest are kept") {
  Cell cell;
  const int eye = cell.cameras().add(above(1.0));
  const auto surface_of = [&](const std::string& name) -> std::weak_ptr<const Surface> {
    for (const SceneBody& body : cell.cameras().scene(cell, eye).bodies)
      if (body.name == name) return body.surface;
    return {};
  };
  Drawing drawing;
  drawing.name = "shown";
  drawing.kind = DrawingKind::kLine;
  drawing.size = {0.2, 0.01, 0.0};
  cell.draw(drawing);
  cell.insert(box_at("table", {1.0, 1.0, 0.02}, {0.5, 0.1, 0.01}));
  const auto table = surface_of("table"), line = surface_of("shown");
  std::vector<std::weak_ptr<const Surface>> parts;
  for (int k = 0; k < 20; ++k) {
    const std::string name = "part" + std::to_string(k);
    cell.insert(box_at(name, {0.05, 0.05, 0.05 + 0.01 * k}, {0.5, 0.1, 0.2}));
    parts.push_back(surface_of(name));
    CHECK_FALSE(parts.back().expired());
    cell.remove(name);
  }
  cell.undraw("shown");
  CHECK(surface_of("table").lock() == table.lock());
  CHECK_FALSE(table.expired());
  CHECK(line.expired());
  for (const auto& each : parts) CHECK(each.expired());
}

TEST_CASE("a camera that cannot be made is refused with its numbers") {
  Cell cell;
  const auto refused = [&](auto change) {
    Camera camera = above(1.0);
    change(camera);
    CHECK_THROWS_AS(cell.cameras().add(camera), ArgumentError);
  };
  refused([](Camera& c) { c.name.clear(); });
  refused([](Camera& c) { c.samples = 3; });
  refused([](Camera& c) { c.noise = NAN; });
  refused([](Camera& c) { c.blur = 31.0; });
  refused([](Camera& c) { c.T_on_camera.matrix()(0, 0) = 2.0; });
  refused([](Camera& c) { c.lens = Pinhole(intrinsics_from_fov(8000, 8000, 1.0)); });
  CHECK(cell.cameras().add(above(1.0)) == 0);
  refused([](Camera&) {});  // the same name
  CHECK_THROWS_AS((void)cell.cameras().at(1), ArgumentError);
}
