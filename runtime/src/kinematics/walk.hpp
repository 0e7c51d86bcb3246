#pragma once

#include <Eigen/Geometry>
#include <array>

#include "../math/det_kernels.hpp"
#include "armlet/model/chain.hpp"

namespace armlet {

// A vector of which two elements are worked on at once.
struct Vec3 {
  det::Lanes xy;
  double z;

  Vec3() = default;
  Vec3(det::Lanes xy_, double z_) : xy(xy_), z(z_) {}
  explicit Vec3(const Eigen::Vector3d& v) : xy{v.x(), v.y()}, z(v.z()) {}
  Eigen::Vector3d to_eigen() const { return {xy[0], xy[1], z}; }

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.xy + b.xy, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.xy - b.xy, a.z - b.z}; }
  friend Vec3 operator*(double s, const Vec3& a) { return {s * a.xy, s * a.z}; }
};

// a x b
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {det::Lanes{a.xy[1] * b.z - a.z * b.xy[1], a.z * b.xy[0] - a.xy[0] * b.z},
          a.xy[0] * b.xy[1] - a.xy[1] * b.xy[0]};
}

// A frame as four vectors: its axes and its origin in the world. A step along the chain is then two
// plane rotations and three multiply-adds.
struct Frame {
  Vec3 x, y, z, p;

  explicit Frame(const Eigen::Isometry3d& T)
      : x(T.matrix().col(0).head<3>()),
        y(T.matrix().col(1).head<3>()),
        z(T.matrix().col(2).head<3>()),
        p(T.matrix().col(3).head<3>()) {}

  // Rx(alpha) Tx(a)
  void step_x(double a, double sin_alpha, double cos_alpha) {
    p = p + a * x;
    const Vec3 y_before = y;
    y = cos_alpha * y + sin_alpha * z;
    z = cos_alpha * z - sin_alpha * y_before;
  }

  // Rz(theta) Tz(d)
  void step_z(double d, double sin_theta, double cos_theta) {
    p = p + d * z;
    const Vec3 x_before = x;
    x = cos_theta * x + sin_theta * y;
    y = cos_theta * y - sin_theta * x_before;
  }

  // The pose of T given in this frame.
  void step(const Eigen::Isometry3d& T) {
    const auto& M = T.matrix();
    const Vec3 x0 = x, y0 = y, z0 = z;
    x = M(0, 0) * x0 + M(1, 0) * y0 + M(2, 0) * z0;
    y = M(0, 1) * x0 + M(1, 1) * y0 + M(2, 1) * z0;
    z = M(0, 2) * x0 + M(1, 2) * y0 + M(2, 2) * z0;
    p = p + (M(0, 3) * x0 + M(1, 3) * y0 + M(2, 3) * z0);
  }

  Eigen::Matrix3d rotation() const {
    Eigen::Matrix3d R;
    R << x.to_eigen(), y.to_eigen(), z.to_eigen();
    return R;
  }

  Eigen::Isometry3d pose() const {
    Eigen::Isometry3d T;
    double* column = T.matrix().data();
    for (const Vec3* v : {&x, &y, &z, &p}) {
      column[0] = v->xy[0];
      column[1] = v->xy[1];
      column[2] = v->z;
      column[3] = v == &p ? 1.0 : 0.0;
      column += 4;
    }
    return T;
  }
};

// Angles of all joints and their sines and cosines, two at a time.
struct Turns {
  std::array<double, kMaxJoints> sine, cosine;

  Turns(const Chain& chain, const double* q) {
    std::array<double, kMaxJoints + 1> angle;
    const std::size_t n = static_cast<std::size_t>(chain.n);
    for (std::size_t i = 0; i < n; ++i) angle[i] = chain.theta[i] + q[i] * chain.turns[i];
    angle[n] = 0.0;
    for (std::size_t i = 0; i < n; i += 2) {
      det::sincos_pair(angle.data() + i, sine.data() + i, cosine.data() + i);
    }
  }
};

// Walks from the base to the flange.
//
// at_axis(i, frame)  after Z_i: frame.z is the axis of joint i and frame.p a point on it; the link
//                    frame of the modified convention.
// at_end(i, frame)   after X_{i+1}: the link frame of the standard convention.
// returns            the flange.
template <class AtAxis, class AtEnd>
inline Frame walk(const Chain& chain, const double* q, AtAxis&& at_axis, AtEnd&& at_end) {
  const Turns turns(chain, q);
  Frame frame(chain.T_world_base);
  frame.step_x(chain.a[0], chain.sin_alpha[0], chain.cos_alpha[0]);
  const std::size_t n = static_cast<std::size_t>(chain.n);
  for (std::size_t i = 0; i < n; ++i) {
    frame.step_z(chain.d[i] + q[i] * chain.slides[i], turns.sine[i], turns.cosine[i]);
    at_axis(i, frame);
    frame.step_x(chain.a[i + 1], chain.sin_alpha[i + 1], chain.cos_alpha[i + 1]);
    at_end(i, frame);
  }
  return frame;
}

template <class AtAxis>
inline Frame walk(const Chain& chain, const double* q, AtAxis&& at_axis) {
  return walk(chain, q, at_axis, [](std::size_t, const Frame&) {});
}

inline Frame walk(const Chain& chain, const double* q) {
  return walk(chain, q, [](std::size_t, const Frame&) {});
}

}  // namespace armlet
