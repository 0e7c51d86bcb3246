#include "armlet/math/rotation.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "math/solvers.hpp"

using namespace armlet;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Vector3d random_direction(Random& random) {
  Vector3d v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (v.norm() < 0.1 || v.norm() > 1.0);
  return v / v.norm();
}

Matrix3d random_rotation(Random& random) {
  return R_from_axis_angle(random_direction(random), random.uniform(-kPi, kPi));
}

double difference(const Matrix3d& A, const Matrix3d& B) { return (A - B).cwiseAbs().maxCoeff(); }

}  // namespace

// Round trips are exact to a few units in the last place, which 1e-14 allows for.
TEST_CASE("every parametrisation gives back the rotation it came from") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Matrix3d R = random_rotation(random);
    REQUIRE(is_rotation(R, 1e-14));
    CHECK(difference(R_from_rpy(rpy_from_R(R)), R) < 1e-14);
    CHECK(difference(R_from_quaternion(quaternion_from_R(R)), R) < 1e-14);
    CHECK(difference(rotation_exp(rotation_log(R)), R) < 1e-14);
    for (const std::string sequence :
         {"XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ", "XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
      CHECK(difference(R_from_euler(sequence, euler_from_R(sequence, R)), R) < 1e-14);
    }
  }
}

TEST_CASE("round trips hold at gimbal lock too") {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const double a = random.uniform(-3, 3), c = random.uniform(-3, 3);
    const double pitch = random.below(2) == 0 ? kPi / 2 : -kPi / 2;
    const Matrix3d R = R_from_rpy({a, pitch, c});
    CHECK(rpy_from_R(R)[0] == 0.0);
    CHECK(difference(R_from_rpy(rpy_from_R(R)), R) < 1e-14);
    for (const double middle : {0.0, kPi}) {
      const Matrix3d Z = R_from_euler("ZYZ", {a, middle, c});
      CHECK(difference(R_from_euler("ZYZ", euler_from_R("ZYZ", Z)), Z) < 1e-14);
    }
    const Matrix3d X = R_from_euler("XYZ", {a, pitch, c});
    CHECK(difference(R_from_euler("XYZ", euler_from_R("XYZ", X)), X) < 1e-14);
  }
}

TEST_CASE("Euler angles lie in the ranges of their sequence, and the first is 0 where it is free") {
  Random random(8);
  for (const std::string sequence :
       {"XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ", "XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
    const bool proper = sequence[0] == sequence[2];
    for (int i = 0; i < 200; ++i) {
      const Matrix3d R = random_rotation(random);
      const double middle = euler_from_R(sequence, R)[1];
      CHECK(middle >= (proper ? 0.0 : -kPi / 2));
      CHECK(middle <= (proper ? kPi : kPi / 2));
      CHECK_FALSE(is_euler_singular(sequence, R));
      // The first and third axis are made to coincide.
      const double side = random.below(2) == 0 ? 0.0 : kPi;
      const double locked = proper ? side : kPi / 2 - side;
      const Matrix3d L =
          R_from_euler(sequence, {random.uniform(-3, 3), locked, random.uniform(-3, 3)});
      CHECK(is_euler_singular(sequence, L));
      CHECK(euler_from_R(sequence, L)[0] == 0.0);
      CHECK(difference(R_from_euler(sequence, euler_from_R(sequence, L)), L) < 1e-14);
    }
  }
}

// Corke, Robotics, Vision and Control, 2011, section 2.2.1: four decimals are printed there.
TEST_CASE("the angles and the quaternion of a textbook") {
  const Matrix3d R = R_from_euler("ZYZ", {0.1, 0.2, 0.3});
  Matrix3d printed;
  printed << 0.9021, -0.3836, 0.1977, 0.3875, 0.9216, 0.0198, -0.1898, 0.0587, 0.9801;
  CHECK(difference(R, printed) < 5e-5);
  const Vector3d flipped = euler_from_R("ZYZ", R_from_euler("ZYZ", {0.1, -0.2, 0.3}));
  CHECK((flipped - Vector3d(-3.0416, 0.2, -2.8416)).cwiseAbs().maxCoeff() < 5e-5);
  const Eigen::Vector4d q = quaternion_from_R(R_from_rpy({0.1, 0.2, 0.3}));
  CHECK((q - Eigen::Vector4d(0.98335, 0.034271, 0.10602, 0.14357)).cwiseAbs().maxCoeff() < 5e-6);
}

TEST_CASE("the axis of a rotation is a unit vector along its logarithm; that of none is z") {
  Random random(9);
  CHECK(axis_of_rotation(Matrix3d::Identity()) == Vector3d::UnitZ());
  for (const double angle : {1e-12, 1e-6, 0.3, 3.0, kPi}) {
    for (int i = 0; i < 100; ++i) {
      const Matrix3d R = R_from_axis_angle(random_direction(random), angle);
      const Vector3d axis = axis_of_rotation(R);
      CHECK(axis.norm() == doctest::Approx(1.0).epsilon(1e-14));
      CHECK((angle * axis - rotation_log(R)).norm() < 1e-14);
    }
  }
}

TEST_CASE("roll, pitch and yaw rotate about the fixed axes x, y and z in this order") {
  CHECK(difference(R_from_rpy({0.1, 0.2, 0.3}), rot_z(0.3) * rot_y(0.2) * rot_x(0.1)) < 1e-16);
  CHECK(difference(R_from_rpy({0.1, 0.2, 0.3}), R_from_euler("ZYX", {0.3, 0.2, 0.1})) < 1e-16);
  CHECK((R_from_rpy({kPi / 2, 0, 0}) * Vector3d::UnitY() - Vector3d::UnitZ()).norm() < 1e-15);
}

// The textbook formula theta = acos((trace - 1)/2) has errors up to 13 rad here.
TEST_CASE("the logarithm is exact up to half a revolution") {
  Random random(3);
  for (const double angle : {1e-9, 1e-3, 1.0, kPi - 1e-3, kPi - 1e-6}) {
    for (int i = 0; i < 200; ++i) {
      const Vector3d axis = random_direction(random);
      const Vector3d phi = rotation_log(R_from_axis_angle(axis, angle));
      CHECK((phi - angle * axis).norm() < 1e-14);
    }
  }
  for (const Vector3d& direction : {Vector3d(1, 1, 1), Vector3d(1, -2, 3), Vector3d(0, 1, -1),
                                    Vector3d(0, 0, 1), Vector3d(0, -1, 1)}) {
    const Vector3d axis = direction / direction.norm();
    const Vector3d phi = rotation_log(R_from_axis_angle(axis, kPi));
    // At half a revolution the first component that is not zero is positive.
    const double sign =
        axis.x() < -1e-9 || (std::abs(axis.x()) < 1e-9 && axis.y() < -1e-9) ? -1 : 1;
    CHECK((phi - sign * kPi * axis).norm() < 1e-14);
  }
}

TEST_CASE("quaternions have a non-negative first component and any length is accepted") {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector4d q = quaternion_from_R(random_rotation(random));
    CHECK(q[0] >= 0.0);
    CHECK(q.norm() == doctest::Approx(1.0).epsilon(1e-15));
    CHECK(difference(R_from_quaternion(q), R_from_quaternion(-3.0 * q)) < 4e-15);
  }
  CHECK(difference(R_from_quaternion({std::sqrt(0.5), 0, 0, std::sqrt(0.5)}), rot_z(kPi / 2)) <
        1e-15);
}

TEST_CASE("the angle between rotations needs no threshold") {
  Random random(5);
  for (const double angle : {0.0, 1e-8, 0.5, 3.1, kPi}) {
    const Matrix3d R = random_rotation(random);
    const Vector3d axis = random_direction(random);
    CHECK(angle_between(R, Matrix3d(R * R_from_axis_angle(axis, angle))) ==
          doctest::Approx(angle).epsilon(1e-12));
  }
}

TEST_CASE("interpolation rotates at constant speed about one axis") {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const Matrix3d R_0 = random_rotation(random), R_1 = random_rotation(random);
    const double angle = angle_between(R_0, R_1);
    for (int k = 0; k < 10; ++k) {
      const Matrix3d a = interpolate(R_0, R_1, k / 10.0);
      const Matrix3d b = interpolate(R_0, R_1, (k + 1) / 10.0);
      CHECK(std::abs(angle_between(a, b) - angle / 10.0) < 1e-12);
    }
    CHECK(difference(interpolate(R_0, R_1, 1.0), R_1) < 1e-14);
  }
}

TEST_CASE("a drifted matrix is made orthonormal again") {
  Random random(7);
  Matrix3d R = random_rotation(random);
  R(0, 1) += 1e-7;
  CHECK_FALSE(is_rotation(R, 1e-9));
  CHECK(is_rotation(renormalised(R), 1e-15));
  CHECK(difference(renormalised(R), R) < 2e-7);
}

TEST_CASE("what has no direction or no meaning is refused") {
  CHECK_THROWS_AS(R_from_axis_angle(Vector3d::Zero(), 1.0), ArgumentError);
  CHECK_THROWS_AS(R_from_quaternion(Eigen::Vector4d::Zero()), ArgumentError);
  CHECK_THROWS_AS(R_from_euler("ZZX", Vector3d::Zero()), ArgumentError);
  CHECK_THROWS_AS(R_from_euler("XY", Vector3d::Zero()), ArgumentError);
  CHECK_THROWS_AS(euler_from_R("xyz", Matrix3d::Identity()), ArgumentError);
}

TEST_CASE("the rotation from z to a direction is one, however near the opposite it is") {
  Random random(31);
  for (int i = 0; i < 4000; ++i) {
    Vector3d along = random_direction(random);
    if (i % 2 == 1) {  // off the z axis by 1 down to 1e-16
      const double off = std::pow(10.0, -random.uniform(0.0, 16.0));
      along = {off * along.x(), off * along.y(), i % 4 == 1 ? 1.0 : -1.0};
    }
    CAPTURE(along.transpose());
    const Matrix3d R = rotation_from_z(3.0 * along);
    CHECK((R.transpose() * R - Matrix3d::Identity()).norm() < 4e-15);
    CHECK((R.col(2) - along.normalized()).norm() < 2e-15);
    // About an axis in the plane of x and y, so that no smaller angle does it.
    CHECK(std::abs(R(0, 1) - R(1, 0)) < 1e-15);
  }
  CHECK(rotation_from_z(-Vector3d::UnitZ()) == Matrix3d(Vector3d(1, -1, -1).asDiagonal()));
}
