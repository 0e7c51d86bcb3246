#include "armlet/math/pose.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/rotation.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

Vector3d random_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Isometry3d random_pose(Random& random) {
  return make_pose(rotation_exp(random_vector(random, 1.8)), random_vector(random, 1.0));
}

double difference(const Isometry3d& A, const Isometry3d& B) {
  return (A.matrix() - B.matrix()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("the exponential undoes the logarithm for every angle") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Isometry3d T = random_pose(random);
    CHECK(difference(pose_exp(pose_log(T)), T) < 1e-14);
  }
  // Across the change from series to closed form, and at half a revolution where cot is 0.
  const Vector3d axis = Vector3d(1, -2, 3).normalized();
  for (const double angle : {0.0, 1e-10, 1e-3, 0.00999, 0.01001, 1.0, 3.0, kPi - 1e-9, kPi}) {
    const Isometry3d T = make_pose(R_from_axis_angle(axis, angle), {0.3, -0.2, 0.7});
    CHECK(difference(pose_exp(pose_log(T)), T) < 1e-14);
  }
}

TEST_CASE("the exponential solves the equation of constant motion") {
  Vector6d xi;
  xi << 0.3, -0.1, 0.4, 0.5, 0.9, -0.2;
  // (I + hat(xi)/N)^N tends to exp(xi) with an error of |xi|^2 / 2N.
  Eigen::Matrix4d step = Eigen::Matrix4d::Zero();
  constexpr int kDoublings = 24;
  step.topLeftCorner<3, 3>() = hat(xi.tail<3>());
  step.topRightCorner<3, 1>() = xi.head<3>();
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity() + step / std::ldexp(1.0, kDoublings);
  for (int i = 0; i < kDoublings; ++i) product = (product * product).eval();
  CHECK((product - pose_exp(xi).matrix()).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("the error of two poses leads from one to the other") {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Isometry3d T_1 = random_pose(random), T_2 = random_pose(random);
    const Vector6d error = pose_error(T_1, T_2);
    CHECK((T_1.translation() + error.head<3>() - T_2.translation()).norm() < 1e-15);
    const Eigen::Matrix3d R = rotation_exp(error.tail<3>()) * T_1.linear();
    CHECK((R - T_2.linear()).norm() < 1e-14);
    CHECK(error.tail<3>().norm() == doctest::Approx(angle_between(T_1, T_2)).epsilon(1e-12));
  }
}

TEST_CASE("interpolation follows the straight line and keeps its ends exactly") {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Isometry3d T_0 = random_pose(random), T_1 = random_pose(random);
    CHECK(difference(interpolate(T_0, T_1, 0.0), T_0) == 0.0);
    CHECK(difference(interpolate(T_0, T_1, 1.0), T_1) == 0.0);
    const Isometry3d half = interpolate(T_0, T_1, 0.5);
    CHECK((half.translation() - 0.5 * (T_0.translation() + T_1.translation())).norm() < 1e-15);
    CHECK(difference(interpolate_screw(T_0, T_1, 1.0), T_1) == 0.0);
    const Isometry3d a = interpolate_screw(T_0, T_1, 0.3);
    CHECK(difference(interpolate_screw(T_0, a, 0.5), interpolate_screw(T_0, T_1, 0.15)) < 1e-13);
  }
}

TEST_CASE("a matrix that is not a rotation is named") {
  Isometry3d T = Isometry3d::Identity();
  CHECK_NOTHROW(check_pose("goal", T));
  T.matrix()(0, 0) = 1.1;
  CHECK_THROWS_WITH_AS(check_pose("goal", T), doctest::Contains("`goal` is not a rotation"),
                       ArgumentError);
  T.matrix()(0, 0) = -1.0;  // a mirror: orthonormal, but left-handed
  CHECK_THROWS_AS(check_pose("goal", T), ArgumentError);
  T.matrix()(0, 0) = NAN;
  CHECK_THROWS_WITH_AS(check_pose("goal", T), doctest::Contains("nan"), ArgumentError);
}

TEST_CASE("products that have drifted are made rigid again") {
  Isometry3d T = make_pose(rot_z(0.1), {1, 2, 3});
  T.matrix()(0, 0) += 1e-8;
  CHECK(is_rotation(renormalised(T).linear(), 1e-15));
}

TEST_CASE("poses are shown in millimetres and degrees") {
  CHECK(format_pose(pose_from_rpy({0.18, -0.2642, 0.02}, {kPi, 0, kPi / 2})) ==
        "(180, -264.2, 20) mm, rpy (180, 0, 90) deg");
}
