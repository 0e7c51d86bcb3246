#include "armlet/math/twist.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

using namespace armlet;

namespace {

Eigen::Vector3d random_vector(Random& random, double size = 1.0) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Eigen::Isometry3d random_pose(Random& random) {
  return make_pose(rotation_exp(random_vector(random, 2.0)), random_vector(random));
}

Vector6d random_twist(Random& random) {
  Vector6d twist;
  twist << random_vector(random), random_vector(random);
  return twist;
}

}  // namespace

TEST_CASE("hat is the cross product and vee undoes it") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d a = random_vector(random), b = random_vector(random);
    CHECK((hat(a) * b - a.cross(b)).norm() < 1e-15);
    CHECK((vee(hat(a)) - a).norm() == 0.0);
  }
}

TEST_CASE("the adjoint moves the exponential: T exp(xi) T^-1 = exp(Ad(T) xi)") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry3d T = random_pose(random);
    const Vector6d xi = random_twist(random);
    const Eigen::Isometry3d left = T * pose_exp(xi) * T.inverse();
    CHECK((left.matrix() - pose_exp(adjoint(T) * xi).matrix()).norm() < 1e-14);
  }
}

TEST_CASE("moving a twist and a wrench to another point keeps their power") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vector6d twist = random_twist(random), wrench = random_twist(random);
    const Eigen::Vector3d r = random_vector(random);
    const double power = twist.dot(wrench);
    CHECK(move_twist(twist, r).dot(move_wrench(wrench, r)) ==
          doctest::Approx(power).epsilon(1e-12));
    const Eigen::Matrix3d R = rotation_exp(random_vector(random));
    CHECK(rotate_twist(R, twist).dot(rotate_twist(R, wrench)) ==
          doctest::Approx(power).epsilon(1e-12));
  }
}

TEST_CASE("a rotating disc moves its rim sideways") {
  Vector6d twist;
  twist << 0, 0, 0, 0, 0, 2;
  const Vector6d rim = move_twist(twist, {0.5, 0, 0});
  CHECK((rim.head<3>() - Eigen::Vector3d(0, 1, 0)).norm() < 1e-15);
}
