#include "armlet/cell/overview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "armlet/camera/renderer.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr double kAcross = 0.7;  // rad, the angle across the picture
constexpr double kFilled = 0.9;  // of the picture, largest share
constexpr double kLeast = 0.1;   // m, smallest width that a picture shows

Vector3d corner(const AlignedBox3d& box, int i) {
  return box.corner(static_cast<AlignedBox3d::CornerType>(i));
}

AlignedBox3d own_box(const SceneBody& body) { return {body.surface->low(), body.surface->high()}; }

AlignedBox3d box_around(const SceneBody& body) {
  AlignedBox3d box;
  for (int i = 0; i < 8; ++i) box.extend(body.T_world_body * corner(own_box(body), i));
  return box;
}

}  // namespace

Image picture_from(const Viewpoint& from, const Scene& scene) {
  Renderer renderer;
  Pictures pictures;
  renderer.render(scene, from.lens, from.T_world_camera, {.samples = 4}, pictures);
  return std::move(pictures.color);
}

Overview::Overview(int width, int height) {
  if (std::min(width, height) < 1 || std::max(width, height) > Image::kMostSide) {
    throw ArgumentError(fmt::format("A picture has {} x {} pixels; expected 1 to {} for each side.",
                                    width, height, Image::kMostSide));
  }
  lens_ = intrinsics_from_fov(width, height, kAcross);
  R_ = looking_at(Vector3d::Zero(), {0.75, -1.0, 0.6}).linear();
  k_x_ = kFilled * std::tan(0.5 * kAcross);
  k_y_ = k_x_ * height / width;
  nearest_ = std::numeric_limits<double>::infinity();
  right_ = left_ = down_ = up_ = far_ = -nearest_;
}

void Overview::add(const AlignedBox3d& box, const Isometry3d& T_world_box) {
  if (box.isEmpty()) throw ArgumentError("A box that is to be seen is empty.");
  check_finite("box", box.min());
  check_finite("box", box.max());
  check_finite("T_world_box", T_world_box.matrix());
  for (int i = 0; i < 8; ++i) {
    const Vector3d p = R_.transpose() * (T_world_box * corner(box, i));
    right_ = std::max(right_, p.x() - k_x_ * p.z());
    left_ = std::max(left_, -p.x() - k_x_ * p.z());
    down_ = std::max(down_, p.y() - k_y_ * p.z());
    up_ = std::max(up_, -p.y() - k_y_ * p.z());
    far_ = std::max(far_, p.z());
    nearest_ = std::min(nearest_, p.z());
  }
}

void Overview::add(const Cell& cell, const Scene& scene) {
  const std::span<const SceneBody> bodies = scene.bodies;  // objects first, then robots
  const std::size_t objects = cell.world().size();
  AlignedBox3d robots;
  for (std::size_t i = objects; i < bodies.size() && cell.robot_count() > 0; ++i)
    robots.extend(box_around(bodies[i]));
  if (!robots.isEmpty()) {
    const Vector3d around = Vector3d::Constant(0.5 * robots.diagonal().norm());
    robots = {robots.min() - around, robots.max() + around};
  }
  for (const SceneBody& body : bodies) {
    const AlignedBox3d box = box_around(body);
    if (robots.isEmpty() || robots.contains(box)) {
      add(own_box(body), body.T_world_body);
    } else if (robots.intersects(box)) {
      add(robots.intersection(box), Isometry3d::Identity());
    }
  }
}

Viewpoint Overview::viewpoint() const {
  Overview shown = *this;
  if (far_ < nearest_) {
    const Vector3d half = Vector3d::Constant(0.5);
    shown.add(AlignedBox3d(-half, half), Isometry3d::Identity());
  }
  return shown.place();
}

// A camera at (a, b, c) in its own axes has (x, y, z) in its picture if |x - a| <= k_x (z - c) and
// |y - b| <= k_y (z - c).
Viewpoint Overview::place() const {
  const double c = std::min({-(right_ + left_) / (2.0 * k_x_), -(down_ + up_) / (2.0 * k_y_),
                             nearest_ - kLeast / (2.0 * std::min(k_x_, k_y_))});
  Isometry3d T = Isometry3d::Identity();
  T.linear() = R_;
  T.translation() = R_ * Vector3d(0.5 * (right_ - left_), 0.5 * (down_ - up_), c);
  Intrinsics lens = lens_;
  constexpr double kFar = 20.0;                 // m
  lens.far = std::max(kFar, 4.0 * (far_ - c));  // the ground fades beyond the shown objects
  return {Pinhole(lens), T};
}

}  // namespace armlet
