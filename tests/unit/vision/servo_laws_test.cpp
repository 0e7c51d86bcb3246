#include "armlet/vision/servo_laws.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "refusal_of.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

Isometry3d pose(const Vector3d& rotation, const Vector3d& translation) {
  Isometry3d T = Isometry3d::Identity();
  T.linear() = rotation_exp(rotation);
  T.translation() = translation;
  return T;
}

// Where the camera is after it moved by a constant twist in its own axes for a time.
Isometry3d moved(const Isometry3d& T, const Vector6d& twist, double dt) {
  return T * pose_exp(twist * dt);
}

// A square of 0.2 m in the plane z = 0 of the world, seen by a camera.
struct Seen {
  PlanePoints points{4, 2};
  Eigen::VectorXd depths{4};
};
Seen square_seen(const Isometry3d& T_world_camera) {
  const Vector3d corners[] = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}};
  Seen out;
  for (int i = 0; i < 4; ++i) {
    const Vector3d p = T_world_camera.inverse() * corners[i];
    out.points.row(i) << p.x() / p.z(), p.y() / p.z();
    out.depths[i] = p.z();
  }
  return out;
}

// Looking at the square along -z of the world from a height, rotated about the optical axis.
Isometry3d above(double height, double turn) {
  Isometry3d T = Isometry3d::Identity();
  T.linear() = rot_x(kPi) * rot_z(turn);
  T.translation() = Vector3d(0, 0, height);
  return T;
}

ImageGoal goal_of(const Isometry3d& T_camera, const Isometry3d& T_wanted) {
  const Seen now = square_seen(T_camera), then = square_seen(T_wanted);
  return {now.points, then.points, now.depths, then.depths};
}

Vector6d image_twist(ImageLaw law, const ImageGoal& goal, double gain) {
  return servo_step(law_interaction(law, goal), image_error(goal), gain).motion;
}

// How a run from a rotation about the optical axis goes: the heights that it passes, and its end.
struct Run {
  double lowest = 0.5, highest = 0.5, error = 0.0;
  int steps = 0;
};
Run run_from_turn(ImageLaw law, double turn) {
  const Isometry3d wanted = above(0.5, 0.0);
  Isometry3d T = above(0.5, turn);
  Run out;
  for (; out.steps < 2000; ++out.steps) {
    const ImageGoal goal = goal_of(T, wanted);
    out.error = image_error(goal).norm();
    if (out.error < 1e-6 || goal.depths.minCoeff() < 1e-3 || goal.depths.maxCoeff() > 50.0) break;
    T = moved(T, image_twist(law, goal, 1.0), 0.04);
    out.lowest = std::min(out.lowest, T.translation().z());
    out.highest = std::max(out.highest, T.translation().z());
  }
  return out;
}

}  // namespace

TEST_CASE("the interaction matrix is the derivative of the points") {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d P(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.3, 3.0));
    const Vector6d twist = Vector6d::NullaryExpr([&] { return random.uniform(-1, 1); });
    const PlanePoints point = (PlanePoints(1, 2) << P.x() / P.z(), P.y() / P.z()).finished();
    const Eigen::VectorXd speed =
        point_interaction(point, Eigen::VectorXd::Constant(1, P.z())) * twist;
    const double h = 1e-5;
    Eigen::Vector2d ends[2];
    for (int side = 0; side < 2; ++side) {
      const Isometry3d T = moved(Isometry3d::Identity(), twist, side == 0 ? -h : h);
      const Vector3d p = T.inverse() * P;
      ends[side] << p.x() / p.z(), p.y() / p.z();
    }
    CHECK(((ends[1] - ends[0]) / (2 * h) - speed).norm() < 1e-7 * (1.0 + speed.norm()));
  }
}

// Closed forms of the twist for a rotation about the optical axis over a symmetric target.
TEST_CASE("a rotation about the optical axis has the known twist under each law") {
  const double gain = 0.7, Z = 0.5;
  for (const double turn : {0.1, 0.5, 1.0, 2.0, 2.8}) {
    CAPTURE(turn);
    // The camera was rotated by `turn`, so the wanted one is `-turn` away.
    const ImageGoal goal = goal_of(above(Z, turn), above(Z, 0.0));
    const auto check = [&](ImageLaw law, double v_z, double w_z) {
      const Vector6d twist = image_twist(law, goal, gain);
      CHECK(twist[2] == doctest::Approx(v_z).epsilon(1e-9).scale(1.0));
      CHECK(twist[5] == doctest::Approx(-w_z).epsilon(1e-9).scale(1.0));
      CHECK(twist.head<2>().norm() + twist.segment<2>(3).norm() < 1e-9);
    };
    check(ImageLaw::kCurrent, -gain * Z * (1 - std::cos(turn)), gain * std::sin(turn));
    check(ImageLaw::kDesired, gain * Z * (1 - std::cos(turn)), gain * std::sin(turn));
    check(ImageLaw::kMean, 0.0, 2 * gain * std::tan(turn / 2));
  }
}

TEST_CASE("rotations of 150, 179 and 180 degrees end as they are known to under each law") {
  const double degree = kPi / 180;
  const Run current = run_from_turn(ImageLaw::kCurrent, 150 * degree);
  CHECK(current.error < 1e-6);
  CHECK(current.highest == doctest::Approx(2.04).epsilon(0.01));
  const Run desired = run_from_turn(ImageLaw::kDesired, 150 * degree);
  CHECK(desired.lowest < 1e-3);  // through the plane of the target
  const Run mean = run_from_turn(ImageLaw::kMean, 150 * degree);
  CHECK(mean.error < 1e-6);
  CHECK(mean.lowest == doctest::Approx(0.5).epsilon(1e-6));
  CHECK(mean.highest == doctest::Approx(0.5).epsilon(1e-6));

  CHECK(run_from_turn(ImageLaw::kCurrent, 179 * degree).highest > 50.0);
  const Run nearly = run_from_turn(ImageLaw::kMean, 179 * degree);
  CHECK(nearly.error < 1e-6);
  CHECK(nearly.highest == doctest::Approx(0.5).epsilon(1e-6));
  for (const ImageLaw law : {ImageLaw::kCurrent, ImageLaw::kDesired, ImageLaw::kMean})
    CHECK(run_from_turn(law, 180 * degree).error > 0.1);
}

TEST_CASE("image-based laws converge from moderate displacements, as fast as their gain says") {
  Random random(11);
  const Isometry3d wanted = above(0.5, 0.0);
  for (int trial = 0; trial < 200; ++trial) {
    const auto part = [&](double most) {
      return Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                      random.uniform(-most, most));
    };
    Isometry3d T = wanted * pose(part(0.15), part(0.06));
    const auto law = static_cast<ImageLaw>(trial % 3);
    int steps = 0;
    double error = 1.0;
    for (; steps < 600 && error > 1e-6; ++steps) {
      const ImageGoal goal = goal_of(T, wanted);
      error = image_error(goal).norm();
      T = moved(T, image_twist(law, goal, 1.0), 0.04);
    }
    CAPTURE(trial);
    CHECK(error <= 1e-6);
    CHECK(steps < 350);
  }
}

TEST_CASE("the position-based law moves the camera straight and rotates it about a fixed axis") {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto part = [&](double most) {
      return Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                      random.uniform(-most, most));
    };
    Isometry3d T = pose(part(1.5), part(1.0));  // of the camera, seen from the wanted one
    const Vector3d line = T.translation().normalized();
    const Vector3d axis = rotation_log(T.linear()).normalized();
    for (int step = 0; step < 400; ++step) {
      const Vector6d twist = position_twist(T, 1.0);
      // Small steps: the straight line is that of the continuous law.
      Isometry3d next = T;
      next.translation() += T.linear() * twist.head<3>() * 0.04;
      next.linear() = T.linear() * rotation_exp(twist.tail<3>() * 0.04);
      T = next;
      CHECK(T.translation().cross(line).norm() < 1e-9);
      if (step < 100) CHECK(rotation_log(T.linear()).cross(axis).norm() < 1e-9);
    }
    CHECK(T.translation().norm() < 1e-6);
    CHECK(rotation_log(T.linear()).norm() < 1e-6);
  }
}

TEST_CASE(
    "the hybrid law takes its point straight through the image and the camera to its position") {
  Random random(5);
  const Vector3d P(0.05, -0.03, 0.0);  // of the world; the camera is wanted 0.5 m above
  const Isometry3d wanted = above(0.5, 0.0);
  const auto seen = [&](const Isometry3d& T) { return Vector3d(T.inverse() * P); };
  const Vector3d there = seen(wanted);
  for (int trial = 0; trial < 50; ++trial) {
    const auto part = [&](double most) {
      return Vector3d(random.uniform(-most, most), random.uniform(-most, most),
                      random.uniform(-most, most));
    };
    Isometry3d T = wanted * pose(part(0.8), part(0.15));
    const Eigen::Vector2d end(there.x() / there.z(), there.y() / there.z());
    for (int step = 0; step < 2000; ++step) {
      const Vector3d p = seen(T);
      const Eigen::Vector2d point(p.x() / p.z(), p.y() / p.z());
      const Vector6d twist =
          hybrid_twist(point, end, p.z(), there.z(), wanted.linear().transpose() * T.linear(), 1.0);
      const PlanePoints one = point.transpose();
      const Eigen::Vector2d speed =
          point_interaction(one, Eigen::VectorXd::Constant(1, p.z())) * twist;
      CHECK((speed + (point - end)).norm() < 1e-9);  // straight to its position
      T = moved(T, twist, 0.01);
    }
    CHECK((wanted.inverse() * T).translation().norm() < 1e-6);
    CHECK(rotation_log(wanted.linear().transpose() * T.linear()).norm() < 1e-6);
  }
}

TEST_CASE("joint speeds give the camera the twist that the Jacobian says") {
  Random random(13);
  for (int trial = 0; trial < 100; ++trial) {
    const auto any = [&] { return random.uniform(-1, 1); };
    const Eigen::MatrixXd J = Eigen::MatrixXd::NullaryExpr(6, 7, any);
    const Isometry3d T_world_tool =
        pose(Vector3d::NullaryExpr(any) * 2.0, Vector3d::NullaryExpr(any));
    const Isometry3d T_tool_camera =
        pose(Vector3d::NullaryExpr(any) * 2.0, Vector3d::NullaryExpr(any));
    const Eigen::VectorXd qd = Eigen::VectorXd::NullaryExpr(7, any);
    const Vector6d tool = rotate_twist(T_world_tool.linear().transpose(), Vector6d(J * qd));
    const Vector6d camera = adjoint(T_tool_camera.inverse()) * tool;
    CHECK((camera_jacobian(J, T_world_tool.linear(), T_tool_camera) * qd - camera).norm() < 1e-12);
  }
}

TEST_CASE("what a motion cannot reach is reported") {
  // Two points: of their four numbers a camera that only slides sideways moves two.
  const PlanePoints two = (PlanePoints(2, 2) << 0.1, 0.2, -0.3, 0.1).finished();
  const Eigen::MatrixXd L = point_interaction(two, Eigen::VectorXd::Constant(1, 0.5)).leftCols(2);
  const Eigen::VectorXd apart = (Eigen::VectorXd(4) << 1, 0, -1, 0).finished();
  const ServoStep step = servo_step(L, apart, 1.0);
  CHECK(step.rank == 2);
  CHECK(step.motion.norm() < 1e-12);
  CHECK(step.unreachable == doctest::Approx(1.0));
  const Eigen::MatrixXd blind = uncontrollable_directions(L);
  CHECK(blind.cols() == 2);
  CHECK((blind.transpose() * L).norm() < 1e-12);
  CHECK((blind * blind.transpose() * apart - apart).norm() < 1e-12);
  // Nothing that is seen moves: no speed, and infinite condition.
  const ServoStep still = servo_step(Eigen::MatrixXd::Zero(4, 3), apart, 1.0);
  CHECK(still.rank == 0);
  CHECK(still.motion == Eigen::VectorXd::Zero(3));
  CHECK(still.condition == std::numeric_limits<double>::infinity());
}

TEST_CASE("a null motion leaves the error alone and is the nearest to the requested one") {
  Random random(19);
  const auto any = [&] { return random.uniform(-1, 1); };
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::MatrixXd A =
        Eigen::MatrixXd::NullaryExpr(8, 5, any) * Eigen::MatrixXd::NullaryExpr(5, 7, any);
    CHECK(rank_above(A, 1e-9) == 5);
    const Eigen::VectorXd wished = Eigen::VectorXd::NullaryExpr(7, any);
    const Eigen::VectorXd motion = null_motion(A, wished);
    CHECK((A * motion).norm() < 1e-12);
    CHECK((null_motion(A, motion) - motion).norm() < 1e-12);
    CHECK(std::abs(motion.dot(wished - motion)) < 1e-12);
  }
  CHECK(rank_above(Eigen::Vector3d(1.0, 0.01, 0.0).asDiagonal().toDenseMatrix(), 0.1) == 1);
  CHECK(rank_above(Eigen::MatrixXd::Zero(3, 3), 0.1) == 0);
  CHECK_FALSE(refusal_of([] {
                null_motion(Eigen::MatrixXd::Ones(2, 3), Eigen::VectorXd::Ones(2));
              }).empty());
}

TEST_CASE("the adaptive gain goes from one value to the other with the slope that it is given") {
  const AdaptiveGain gain{4.0, 0.4, 30.0};
  CHECK(gain.at(0.0) == doctest::Approx(4.0));
  CHECK(gain.at(100.0) == doctest::Approx(0.4));
  CHECK((gain.at(1e-6) - gain.at(0.0)) / 1e-6 == doctest::Approx(-30.0).epsilon(1e-4));
  CHECK(AdaptiveGain{1.0, 1.0, 5.0}.at(3.0) == 1.0);
  for (double e = 0.0; e < 1.0; e += 0.01) CHECK(gain.at(e + 0.01) < gain.at(e));
}

TEST_CASE("numbers that no servo has are refused with themselves") {
  const PlanePoints one = (PlanePoints(1, 2) << 0.1, 0.2).finished();
  const auto depth = [](double Z) { return Eigen::VectorXd::Constant(1, Z); };
  CHECK(refusal_of([&] { point_interaction(one, depth(0.0)); }) ==
        "`depth` is 0; it must be greater than zero.");
  CHECK(refusal_of([&] { point_interaction(one, Eigen::VectorXd::Ones(3)); }) ==
        "1 points have 3 depths; give one for each, or one for all.");
  CHECK(refusal_of([&] {
          law_interaction(ImageLaw::kMean, {one, PlanePoints::Zero(2, 2), depth(1), depth(1)});
        }) == "1 points are seen and 2 are wanted.");
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal_of([&] {
          servo_step(Eigen::MatrixXd::Ones(2, 6), Eigen::VectorXd::Ones(2), -1);
        }) == "`gain` is -1; it must be greater than zero.");
  CHECK_FALSE(refusal_of([&] { point_interaction(one, depth(nothing)); }).empty());
  CHECK_FALSE(refusal_of([&] {
                servo_step(Eigen::MatrixXd::Constant(2, 6, nothing), Eigen::VectorXd::Ones(2), 1);
              }).empty());
  CHECK_FALSE(refusal_of([&] { (void)AdaptiveGain{1.0, 2.0, 3.0}.at(0.1); }).empty());
}
