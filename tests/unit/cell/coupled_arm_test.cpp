// An arm with joints that copy others in a cell: its description, its links, what presses on them.
#include <doctest/doctest.h>

#include <memory>
#include <numbers>
#include <sstream>

#include "armlet/backend/jsonl_backend.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "cell/descriptions.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

namespace {

// A ball of 30 mm on one of its links, counted from 1.
std::shared_ptr<const Robot> palletiser(int link) {
  RobotSpec spec{.name = "palletiser", .convention = DhConvention::kModified};
  constexpr double kRight = std::numbers::pi / 2.0;
  spec.joints.resize(6);
  spec.joints[0].dh = {0.0, 0.1, 0.0, 0.0};
  spec.joints[1].dh = {0.0, 0.0, 0.05, -kRight};
  spec.joints[2].dh = {0.3, 0.0, 0.2, 0.0};
  spec.joints[3].dh = {0.0, 0.0, 0.0, 0.0};
  spec.joints[4].dh = {0.0, 0.0, 0.25, 0.0};
  spec.joints[5].dh = {0.0, 0.03, 0.02, -kRight};
  spec.joints[2].drive = {.of = 1, .ratio = -0.5, .offset = 0.1};
  spec.joints[4].drive = {.of = 3, .ratio = -1.0};
  spec.links.resize(6);
  spec.links[static_cast<std::size_t>(link - 1)].solids.push_back(
      {.kind = LinkSolidKind::kSphere,
       .size = {0.03, 0.0, 0.0},
       .T_link_solid = make_translation({0.1, 0.02, 0.01})});
  return std::make_shared<const Robot>(spec);
}

}  // namespace

TEST_CASE("a description of an arm with copying joints has one entry for each link") {
  Cell cell;
  const int arm = cell.add_robot(palletiser(3));
  const RobotInfo info = robot_info(cell.robot(arm));
  REQUIRE(info.joints.size() == 4);
  REQUIRE(info.link_count() == 6);
  const VectorXd q = Vector4d(0.3, -0.4, 0.5, 0.6);
  const auto frames = link_frames(*cell.robot(arm).model, q);
  Isometry3d T = info.T_world_base;
  for (std::size_t k = 0; k < info.rows.size(); ++k) {
    const RowInfo& row = info.rows[k];
    const double value = row.ratio * q[row.joint] + row.offset;
    T = T * row.moves.T_before_joint * Eigen::AngleAxisd(value, Vector3d::UnitZ()) *
        row.moves.T_joint_link;
    CHECK((T.matrix() - frames[k].matrix()).norm() < 1e-12);
  }
  std::ostringstream text;
  const auto backend = make_jsonl_backend(text);
  cell.set_backend(backend.get());
  cell.begin();
  cell.end();
  CHECK(text.str().find(R"("joint":1,"ratio":-0.5,"offset":0.1})") != std::string::npos);
}

TEST_CASE("links of an arm with copying joints are counted by rows") {
  Cell cell;
  const int arm = cell.add_robot(palletiser(3));
  const VectorXd q = Vector4d(0.3, -0.4, 0.5, 0.6);
  cell.set_joints(arm, q);
  const Robot& model = *cell.robot(arm).model;
  for (int link = 0; link <= 6; ++link) {
    const Isometry3d T = link_frame(model, q, link);
    CHECK((cell.T_world_link(arm, link).matrix() - T.matrix()).norm() < 1e-12);
  }
  CHECK((cell.T_world_flange(arm).matrix() - link_frame(model, q, 6).matrix()).norm() < 1e-12);
  CHECK_THROWS_AS((void)cell.T_world_link(arm, 7), ArgumentError);
}

TEST_CASE("cameras see an arm with copying joints where an arm of as many motors stands") {
  const std::shared_ptr<const Robot> arm = palletiser(4);
  const VectorXd q = Vector4d(0.3, -0.4, 0.5, 0.6);
  const auto bodies_of = [](const std::shared_ptr<const Robot>& model, const VectorXd& values) {
    Cell cell;
    cell.set_joints(cell.add_robot(model, "arm"), values);
    return cell.cameras().scene(cell, cell.cameras().add({.name = "eye"})).bodies;
  };
  const auto seen = bodies_of(arm, q);
  const auto expected =
      bodies_of(std::make_shared<const Robot>(arm->uncoupled()), row_values(*arm, q));
  REQUIRE(seen.size() == expected.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CAPTURE(seen[i].name);
    CHECK(seen[i].name == expected[i].name);
    CHECK((seen[i].T_world_body.matrix() - expected[i].T_world_body.matrix()).norm() < 1e-12);
  }
}

TEST_CASE("what presses on a link loads the joints by how they move the point of contact") {
  for (const int link : {2, 3, 4, 5}) {
    CAPTURE(link);
    Cell cell;
    const int arm = cell.add_robot(palletiser(link));
    const Robot& model = *cell.robot(arm).model;
    const VectorXd q0 = Vector4d(0.1, 0.2, 0.3, 0.0), q1 = Vector4d(0.3, 0.45, 0.6, 0.2);
    cell.set_joints(arm, q0);
    const Vector3d in_link(0.1, 0.02, 0.01);
    const Vector3d from = link_frame(model, q0, link) * in_link,
                   to = link_frame(model, q1, link) * in_link;
    // At the end of the move the two balls overlap by 5 mm.
    Object ball{.name = "ball", .shape = Sphere{0.02}, .friction = 0.0, .stiffness = 1e4};
    ball.T_world_obj = make_translation(to + 0.045 * (to - from).normalized());
    cell.insert(ball);
    MotionPlan plan = plan_joint_move(PlannerSet(), model, {.q0 = q0, .q1 = q1, .time = 1.0});
    REQUIRE(plan.ok());
    cell.start(arm, *std::move(plan.trajectory));
    cell.advance_to(1'000'000'000);
    const std::vector<Press> presses = cell.presses(arm);
    REQUIRE(presses.size() == 1);
    CHECK(presses[0].frame == link);
    CHECK(presses[0].force.norm() == doctest::Approx(50.0).epsilon(0.1));
    const Vector3d p = link_frame(model, q1, link).inverse() * presses[0].p;
    const VectorXd tau = cell.contact_forces(arm);
    REQUIRE(tau.size() == 4);
    constexpr double kStep = 1e-6;
    for (int j = 0; j < 4; ++j) {
      const VectorXd step = kStep * VectorXd::Unit(4, j);
      const Vector3d moved =
          (link_frame(model, q1 + step, link) * p - link_frame(model, q1 - step, link) * p) /
          (2.0 * kStep);
      CHECK(tau[j] == doctest::Approx(moved.dot(presses[0].force)).epsilon(1e-6).scale(1.0));
    }
  }
}
