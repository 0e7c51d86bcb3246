#pragma once

#include <Eigen/Geometry>

#include "../math/det_kernels.hpp"
#include "armlet/model/chain.hpp"

namespace armlet {

// A frame as four vectors: its axes and its origin in the world. A step along the chain is then two
// plane rotations and three multiply-adds.
struct Frame {
  Eigen::Vector3d x, y, z, p;

  explicit Frame(const Eigen::Isometry3d& T)
      : x(T.matrix().col(0).head<3>()),
        y(T.matrix().col(1).head<3>()),
        z(T.matrix().col(2).head<3>()),
        p(T.matrix().col(3).head<3>()) {}

  // Rx(alpha) Tx(a)
  void step_x(double a, double sin_alpha, double cos_alpha) {
    p += a * x;
    const Eigen::Vector3d y_before = y;
    y = cos_alpha * y + sin_alpha * z;
    z = cos_alpha * z - sin_alpha * y_before;
  }

  // Rz(theta) Tz(d)
  void step_z(double d, double sin_theta, double cos_theta) {
    p += d * z;
    const Eigen::Vector3d x_before = x;
    x = cos_theta * x + sin_theta * y;
    y = cos_theta * y - sin_theta * x_before;
  }

  // The pose of T given in this frame.
  void step(const Eigen::Isometry3d& T) {
    const auto& M = T.matrix();
    const Eigen::Vector3d x0 = x, y0 = y, z0 = z;
    x = M(0, 0) * x0 + M(1, 0) * y0 + M(2, 0) * z0;
    y = M(0, 1) * x0 + M(1, 1) * y0 + M(2, 1) * z0;
    z = M(0, 2) * x0 + M(1, 2) * y0 + M(2, 2) * z0;
    p += M(0, 3) * x0 + M(1, 3) * y0 + M(2, 3) * z0;
  }

  Eigen::Isometry3d pose() const {
    Eigen::Isometry3d T;
    T.matrix() << x.x(), y.x(), z.x(), p.x(),  //
        x.y(), y.y(), z.y(), p.y(),            //
        x.z(), y.z(), z.z(), p.z(),            //
        0.0, 0.0, 0.0, 1.0;
    return T;
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
  Frame frame(chain.T_world_base);
  frame.step_x(chain.a[0], chain.sin_alpha[0], chain.cos_alpha[0]);
  const std::size_t n = static_cast<std::size_t>(chain.n);
  for (std::size_t i = 0; i < n; ++i) {
    if (chain.revolute[i]) {
      const det::SinCos turn = det::sincos_inline(chain.theta[i] + q[i]);
      frame.step_z(chain.d[i], turn.sin, turn.cos);
    } else {
      frame.step_z(chain.d[i] + q[i], chain.sin_theta[i], chain.cos_theta[i]);
    }
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
