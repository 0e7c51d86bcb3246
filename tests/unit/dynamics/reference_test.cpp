#include <doctest/doctest.h>

#include "armlet/dynamics/forward_dynamics.hpp"
#include "armlet/dynamics/inverse_dynamics.hpp"
#include "reference_robot.hpp"

// The dynamics of tests/reference/robots: Robotics Toolbox, Orocos KDL, DART and a complex-step
// Lagrangian.
using namespace armlet;
using namespace armlet::reference;

namespace {

// Torques and matrices to 1e-9 of the largest of them, which the README of the reference promises.
double relative_error(const Eigen::MatrixXd& ours, const Eigen::MatrixXd& theirs) {
  return (ours - theirs).cwiseAbs().maxCoeff() / std::max(1.0, theirs.cwiseAbs().maxCoeff());
}

template <class Check>
void for_each_dynamic_sample(const Check& check) {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const Json file = load(name);
    const Robot robot = robot_of(file.at("robot"));
    for (const Json& sample : file.at("dynamics")) {
      const Eigen::VectorXd q = vector_of(sample.at("q"));
      CAPTURE(q.transpose());
      check(robot, sample, q, vector_of(sample.at("qd")));
    }
  }
}

}  // namespace

TEST_CASE(
    "torques, gravity, Coriolis forces and friction of 14 arms are those of other libraries") {
  for_each_dynamic_sample([](const Robot& robot, const Json& sample, const auto& q,
                             const auto& qd) {
    const Eigen::VectorXd qdd = vector_of(sample.at("qdd"));
    CHECK(relative_error(inverse_dynamics(robot, q, qd, qdd), vector_of(sample.at("tau"))) < 1e-9);
    CHECK(relative_error(gravity_forces(robot, q), vector_of(sample.at("gravity_torque"))) < 1e-9);
    CHECK(relative_error(coriolis_forces(robot, q, qd), vector_of(sample.at("Cqd"))) < 1e-9);
    CHECK(relative_error(friction_forces(robot, qd), vector_of(sample.at("friction"))) < 1e-9);
    CHECK(relative_error(mass_matrix(robot, q), matrix_of(sample.at("M"))) < 1e-9);
  });
}

TEST_CASE("accelerations of 14 arms are those of other libraries") {
  for_each_dynamic_sample(
      [](const Robot& robot, const Json& sample, const auto& q, const auto& qd) {
        const Json& accel = sample.at("accel");
        const Eigen::VectorXd tau = vector_of(accel.at("tau_in")), qdd = vector_of(accel.at("qdd"));
        CHECK(relative_error(forward_dynamics(robot, q, qd, tau), qdd) < 1e-9);
        CHECK(relative_error(articulated_body(robot, q, qd, tau), qdd) < 1e-9);
      });
}

TEST_CASE("a wrench at the tool changes the torques of 14 arms as in other libraries") {
  for_each_dynamic_sample([](const Robot& robot, const Json& sample, const auto& q,
                             const auto& qd) {
    const Json& loaded = sample.at("tool_wrench");
    const Vector6d wrench = vector_of(loaded.at("W"));
    const Eigen::VectorXd qdd = vector_of(sample.at("qdd"));
    CHECK(relative_error(inverse_dynamics(robot, q, qd, qdd, wrench), vector_of(loaded.at("tau"))) <
          1e-9);
  });
}

// A point mass, given in the frame of the last link.
TEST_CASE("a payload changes the torques of 14 arms as in other libraries") {
  for_each_dynamic_sample(
      [](const Robot& robot, const Json& sample, const auto& q, const auto& qd) {
        const Json& loaded = sample.at("payload");
        const Robot carrying =
            robot.with_payload({.mass = loaded.at("m"), .com = vector_of(loaded.at("p"))});
        const Eigen::VectorXd qdd = vector_of(sample.at("qdd"));
        CHECK(relative_error(inverse_dynamics(carrying, q, qd, qdd), vector_of(loaded.at("tau"))) <
              1e-9);
      });
}
