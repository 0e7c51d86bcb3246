// The closed form that an arm shares with its copies.
#include <doctest/doctest.h>

#include <array>
#include <thread>
#include <vector>

#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;

namespace {

bool has_same_bits(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same_bits);
}

// Some part of the range of each joint.
Robot with_narrow_limits(const Robot& robot, Random& random) {
  Eigen::VectorXd lower = robot.lower(), upper = robot.upper();
  for (int i = 0; i < robot.n(); ++i) {
    const double a = random.uniform(robot.lower()[i], robot.upper()[i]);
    const double b = random.uniform(robot.lower()[i], robot.upper()[i]);
    lower[i] = std::min(a, b);
    upper[i] = std::max(a, b);
  }
  return robot.with_limits(lower, upper);
}

// Kept with each robot beside its closed form.
struct SumOfRows {
  double sum = 0.0;
  explicit SumOfRows(const Chain& chain) {
    for (const double a : chain.a) sum += std::abs(a);
  }
};

}  // namespace

TEST_CASE("copies that differ in limits, rates, home or name have the same closed form") {
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    const ClosedForm& closed = closed_form(robot);
    const double sum = robot.derived<SumOfRows>().sum;
    Random random(1);
    const Robot narrow = with_narrow_limits(robot, random);
    for (const Robot& copy : {robot, narrow, narrow.with_acceleration(0.25), robot.with_name("b"),
                              robot.with_home(random_joints(robot, random))}) {
      CHECK(&closed_form(copy) == &closed);
      CHECK(copy.derived<SumOfRows>().sum == sum);
    }
    RobotSpec longer = robot.spec();
    longer.joints[0].dh.a += 0.01;
    for (const Robot& copy :
         {robot.with_base(robot.T_world_base() * make_translation({0, 0, 0.1})),
          robot.with_tool_point(robot.T_flange_tool() * make_translation({0, 0, 0.1})),
          Robot(longer)}) {
      CHECK(&closed_form(copy) != &closed);
    }
  }
}

// The shared closed form against one of the copy's own.
TEST_CASE("a copy with other limits has the solutions of an arm made with these limits") {
  int solved = 0, outside = 0;
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    Random random(7);
    for (int k = 0; k < 20; ++k) {
      closed_form(robot);
      const Robot copy = with_narrow_limits(robot, random);
      const Robot own(copy.spec());
      REQUIRE(&closed_form(copy) == &closed_form(robot));
      const Eigen::VectorXd q = random_joints(k % 2 == 0 ? copy : robot, random);
      const Eigen::Isometry3d goal = forward(robot, q);
      const IkResult shared = solve_ik(copy, goal, {.diagnose = false});
      const IkResult fresh = solve_ik(own, goal, {.diagnose = false});
      REQUIRE(shared.status == fresh.status);
      REQUIRE(has_same_bits(shared.q, fresh.q));
      if (!shared.ok()) {
        ++outside;
        continue;
      }
      ++solved;
      REQUIRE((shared.q.array() >= copy.lower().array() - 1e-9).all());
      REQUIRE((shared.q.array() <= copy.upper().array() + 1e-9).all());
    }
  }
  CHECK(solved > 100);
  CHECK(outside > 50);
}

TEST_CASE("a moved arm with another tool solves for where it stands now") {
  Random random(3);
  for (const char* name : {"puma560", "ur5", "scara", "panda"}) {
    const Robot robot = *make_robot(name);
    closed_form(robot);
    const Robot moved = robot.with_base(make_translation({0.3, -0.2, 0.1}))
                            .with_tool_point(make_translation({0, 0, 0.15}));
    for (int k = 0; k < 50; ++k) {
      const Eigen::VectorXd q = random_joints(moved, random);
      const IkResult result = solve_ik(moved, forward(moved, q), {.seed = q});
      REQUIRE(result.ok());
      CHECK((forward(moved, result.q).matrix() - forward(moved, q).matrix()).norm() < 1e-6);
    }
  }
}

TEST_CASE("threads that share an arm and copies of it get one closed form") {
  for (int round = 0; round < 50; ++round) {
    const Robot robot = *make_robot("puma560");
    std::array<const ClosedForm*, 6> seen{};
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      threads.emplace_back([&seen, &robot, k] {
        const Robot copy = k % 2 == 0 ? robot : robot.with_acceleration(0.5);
        seen[k] = &closed_form(copy);
      });
    }
    threads.clear();
    for (const ClosedForm* closed : seen) REQUIRE(closed == &closed_form(robot));
  }
}
