#pragma once
// A loop of visual servoing over an ideal camera.

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "armlet/camera/visual_servo.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet::servoing {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

inline constexpr double kDegree = kPi / 180;
inline constexpr double kInf = std::numeric_limits<double>::infinity();

inline Pinhole lens_of(double focal) {
  Intrinsics of = intrinsics_from_focal(640, 480, focal);
  of.far = 50.0;
  return Pinhole(of);
}

// Looking along -z of the world at its origin from a height, rotated about the optical axis.
inline Isometry3d above(double height, double turn) {
  Isometry3d T = Isometry3d::Identity();
  T.linear() = rot_x(kPi) * rot_z(turn);
  T.translation() = Vector3d(0, 0, height);
  return T;
}

inline Isometry3d displaced(const Isometry3d& T, const Vector3d& rotation,
                            const Vector3d& translation) {
  Isometry3d by = Isometry3d::Identity();
  by.linear() = rotation_exp(rotation);
  by.translation() = translation;
  return T * by;
}

// A square of 0.2 m in the plane z = 0 of the world.
inline ObjectPoints square() {
  return ObjectPoints{{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}};
}

// What an ideal camera sees of points, and how deep they lie; nothing if one is behind it.
struct Seen {
  PlanePoints pixels;
  VectorXd depths;
};
inline std::optional<Seen> seen_by(const Pinhole& lens, const Isometry3d& T_world_camera,
                                   const ObjectPoints& points) {
  Seen out{PlanePoints(points.rows(), 2), VectorXd(points.rows())};
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vector3d p = T_world_camera.inverse() * Vector3d(points.row(i).transpose());
    const auto pixel = lens.project(p);
    if (!pixel) return {};
    out.pixels.row(i) = pixel->transpose();
    out.depths[i] = p.z();
  }
  return out;
}

// An arm whose joints are directions of motion of the camera.
inline ServoArm free_arm(Eigen::Index joints = 6) {
  ServoArm arm;
  arm.lower = VectorXd::Constant(joints, -kInf);
  arm.upper = arm.max_speed = arm.max_accel = VectorXd::Constant(joints, kInf);
  arm.turns.assign(static_cast<std::size_t>(joints), true);
  arm.rank = std::min<Eigen::Index>(6, joints);
  return arm;
}

// A loop over an ideal camera.
struct Loop {
  Pinhole lens = lens_of(600.0);
  ObjectPoints points = square();
  Isometry3d wanted = above(0.5, 0.0);
  Isometry3d T = above(0.5, 0.0);
  ServoArm arm = free_arm();
  MatrixXd J = MatrixXd::Identity(6, 6);
  ServoOptions options{
      .law = ServoLaw::kMean, .gain = {1.0, 1.0, 1.0}, .within = 1e-3, .timeout = 100.0};
  bool knows_points = false;  // else the depths at the goal
  bool knows_depths = true;   // those of every picture
  double depth_factor = 1.0;
  std::function<void(ServoSight&, int)> spoil{};
  VectorXd q = VectorXd::Zero(6);
  double lowest = kInf, highest = 0.0;

  [[nodiscard]] ServoGoal goal() const {
    const Seen at_goal = *seen_by(lens, wanted, points);
    ServoGoal out{.wanted = at_goal.pixels};
    if (knows_points) out.points = points;
    if (!knows_points) out.depths = at_goal.depths * depth_factor;
    return out;
  }
  VisualServo run() {
    VisualServo servo(lens, goal(), arm, options);
    VectorXd qd = VectorXd::Zero(J.cols());
    for (int k = 0; servo.end() == ServoEnd::kNone; ++k) {
      ServoSight sight{.t = k * options.period, .J_camera = J, .q = q, .qd = qd};
      if (const auto seen = seen_by(lens, T, points)) {
        sight.pixels = seen->pixels;
        if (knows_depths && !knows_points) sight.depths = seen->depths;
      }
      if (spoil) spoil(sight, k);
      qd = servo.look(sight);
      q += options.period * qd;
      T = T * pose_exp(Vector6d(options.period * (J * qd)));
      lowest = std::min(lowest, T.translation().z());
      highest = std::max(highest, T.translation().z());
    }
    return servo;
  }
};

inline Loop from_turn(ServoLaw law, double turn) {
  Loop loop;
  loop.T = above(0.5, turn);
  loop.options.law = law;
  loop.knows_points = law >= ServoLaw::kPosition;
  return loop;
}

inline Vector3d any_vector(Random& random, double most) {
  return {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
}

// Nearly normal, standard deviation 1.
inline double noise(Random& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

}  // namespace armlet::servoing
