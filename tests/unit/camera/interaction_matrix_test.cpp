#include "armlet/camera/interaction_matrix.hpp"

#include <doctest/doctest.h>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "refusal_of.hpp"

using namespace armlet;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;

TEST_CASE("the interaction matrix is the derivative of the projection by the camera's twist") {
  Random random(4);
  for (int k = 0; k < 200; ++k) {
    Intrinsics i = intrinsics_from_focal(640, 480, random.uniform(300.0, 900.0));
    if (k % 2 == 1) i.distortion = {random.uniform(-0.2, 0.2), 0.05, 0.002, -0.001, 0.01};
    const Pinhole camera(i);
    const double Z = random.uniform(0.2, 2.0);
    const Vector3d p(Z * random.uniform(-0.4, 0.4), Z * random.uniform(-0.3, 0.3), Z);
    const Vector2d pixel = camera.project(p).value();
    const MatrixXd L =
        interaction_matrix(camera, pixel.transpose(), Eigen::VectorXd::Constant(1, Z)).value();
    REQUIRE(L.rows() == 2);
    for (int axis = 0; axis < 6; ++axis) {
      constexpr double kStep = 1e-5;  // central: the error is of order 1e-10 times f
      const Vector6d twist = kStep * Vector6d::Unit(axis);
      const Vector2d after = camera.project(pose_exp(twist).inverse() * p).value();
      const Vector2d before = camera.project(pose_exp(twist) * p).value();
      CHECK((L.col(axis) - (after - before) / (2.0 * kStep)).norm() <
            1e-6 * (1.0 + L.col(axis).norm()));
    }
  }
}

TEST_CASE("one depth counts for all points") {
  const Pinhole camera(intrinsics_from_focal(640, 480, 600.0));
  const MatrixXd s{{300.0, 200.0}, {340.0, 200.0}, {340.0, 260.0}};
  const MatrixXd one = interaction_matrix(camera, s, Eigen::VectorXd::Constant(1, 0.5)).value();
  CHECK(one == interaction_matrix(camera, s, Eigen::Vector3d::Constant(0.5)).value());
  CHECK(one.rows() == 6);
}

TEST_CASE("points and depths that do not fit are refused") {
  const Pinhole camera(intrinsics_from_focal(640, 480, 600.0));
  const MatrixXd s = MatrixXd::Constant(3, 2, 200.0);
  CHECK(refusal_of([&] { (void)interaction_matrix(camera, s, Eigen::Vector2d(1.0, 1.0)); }) ==
        "3 points have 2 depths; give one for each, or one for all.");
  CHECK(refusal_of([&] {
          (void)interaction_matrix(camera, s.transpose(), Eigen::Vector3d(1.0, 1.0, 1.0));
        }) == "Points of a picture are rows of two pixels, not a matrix of 2 x 3.");
  CHECK_THROWS_AS((void)interaction_matrix(camera, s, Eigen::Vector3d(1.0, 0.0, 1.0)),
                  ArgumentError);
}
