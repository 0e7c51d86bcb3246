#include "armlet/kinematics/limits.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

TEST_CASE("joints outside their range are listed with the bound they pass") {
  const Robot scara = *make_robot("scara");
  const Eigen::Vector4d q(0.0, deg_to_rad(152), -0.01, 0.0);
  const std::vector<LimitViolation> violations = limit_violations(scara, q);
  REQUIRE(violations.size() == 2);
  CHECK(violations[0].joint == 1);
  CHECK(violations[0].limit == doctest::Approx(deg_to_rad(140)));
  CHECK(violations[0].excess() == doctest::Approx(deg_to_rad(12)));
  CHECK(describe(scara, violations[0]) ==
        "joint 2 would turn to 152 deg; its range is -140 deg to 140 deg");
  CHECK(violations[1].excess() == doctest::Approx(0.01));
  CHECK(describe(scara, violations[1]) ==
        "joint 3 would slide to -10 mm; its range is 0 mm to 200 mm");
}

TEST_CASE("a value that is not a number is outside") {
  const Robot scara = *make_robot("scara");
  const Eigen::Vector4d q(0.0, NAN, 0.0, 0.0);
  CHECK_FALSE(within_limits(scara, q));
  REQUIRE(limit_violations(scara, q).size() == 1);
  CHECK(limit_violations(scara, q)[0].joint == 1);
}

TEST_CASE("the bounds themselves are within the limits") {
  const Robot puma = *make_robot("puma560");
  CHECK(within_limits(puma, puma.lower()));
  CHECK(within_limits(puma, puma.upper(), 0.0));
  CHECK(limit_violations(puma, puma.upper()).empty());
  CHECK_FALSE(within_limits(puma, puma.upper() + 1e-6 * Eigen::VectorXd::Ones(6)));
}

TEST_CASE("clamping moves each joint to the nearest allowed value") {
  const Robot scara = *make_robot("scara");
  const Eigen::VectorXd q = clamp_to_limits(scara, Eigen::Vector4d(9.0, -9.0, 0.1, 1.0));
  CHECK(q[0] == scara.upper()[0]);
  CHECK(q[1] == scara.lower()[1]);
  CHECK(q[2] == 0.1);
  CHECK(q[3] == 1.0);
}

TEST_CASE("whole revolutions bring a joint near, but never out of its range") {
  const Robot ur5 = *make_robot("ur5");  // limits of one revolution to either side
  Eigen::VectorXd near = Eigen::VectorXd::Zero(6), q = Eigen::VectorXd::Zero(6);
  near[5] = deg_to_rad(200);
  q[5] = deg_to_rad(-170);
  CHECK(wrap_near(ur5, q, near)[5] == doctest::Approx(deg_to_rad(190)));
  near[5] = deg_to_rad(355);
  q[5] = deg_to_rad(10);
  CHECK(wrap_near(ur5, q, near)[5] == doctest::Approx(deg_to_rad(10)));

  const Robot scara = *make_robot("scara");  // joint 2: 140 deg to either side
  Eigen::Vector4d a(0, deg_to_rad(300), 0.1, 0), b(0, deg_to_rad(200), 7.0, 0);
  CHECK(wrap_near(scara, a, scara.home())[1] == doctest::Approx(deg_to_rad(-60)));
  // No copy of 200 deg is allowed; -160 deg is 20 deg outside, 200 deg is 60 deg outside.
  CHECK(wrap_near(scara, b, scara.home())[1] == doctest::Approx(deg_to_rad(-160)));
  CHECK(wrap_near(scara, b, scara.home())[2] == 7.0);  // prismatic joints stay
}

TEST_CASE("vectors of a wrong size are refused") {
  const Robot scara = *make_robot("scara");
  CHECK_THROWS_AS(limit_violations(scara, Eigen::Vector3d::Zero()), ArgumentError);
  CHECK_THROWS_AS(within_limits(scara, Eigen::Vector3d::Zero()), ArgumentError);
  CHECK_THROWS_AS(clamp_to_limits(scara, Eigen::Vector3d::Zero()), ArgumentError);
  CHECK_THROWS_AS(wrap_near(scara, Eigen::Vector4d::Zero(), Eigen::Vector3d::Zero()),
                  ArgumentError);
}
