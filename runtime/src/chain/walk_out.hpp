#pragma once

#include "joint_sines.hpp"

namespace armlet {

// A vector stored such that two elements are processed at once.
struct WalkAxis {
  Lanes xy;
  double z;

  static WalkAxis load(const double* p) { return {load_pair(p), p[2]}; }
  // Stores the vector and `last`, as a column of a 4x4 matrix.
  void store(double* p, double last) const {
    store_pair(p, xy);
    store_pair(p + 2, Lanes{z, last});
  }
  friend WalkAxis operator+(const WalkAxis& a, const WalkAxis& b) {
    return {a.xy + b.xy, a.z + b.z};
  }
  friend WalkAxis operator-(const WalkAxis& a, const WalkAxis& b) {
    return {a.xy - b.xy, a.z - b.z};
  }
  friend WalkAxis operator*(Lanes s, const WalkAxis& a) { return {s * a.xy, s[0] * a.z}; }
  friend WalkAxis operator-(const WalkAxis& a) { return {-a.xy, -a.z}; }
};

// A frame as four vectors: its axes and its origin in the world.
struct WalkFrame {
  WalkAxis x, y, z, p;

  // A column-major 4x4 matrix; flip is the sign of the y and z axes.
  void store(double* T, double flip) const {
    x.store(T, 0.0);
    (both(flip) * y).store(T + 4, 0.0);
    (both(flip) * z).store(T + 8, 0.0);
    p.store(T + 12, 1.0);
  }

  // Applies X_i.
  [[gnu::always_inline]] void step_x(const WalkPlan& plan, std::size_t i) {
    if (plan.has_a[i]) p = p + both(plan.a[i]) * x;
    const WalkAxis y_before = y;
    if (plan.right_angle(i)) {
      y = z;
      z = -y_before;
    } else if (plan.any_angle(i)) {
      const Lanes s = both(plan.sin_alpha[i]);
      const Lanes c = both(plan.cos_alpha[i]);
      y = c * y_before + s * z;
      z = c * z - s * y_before;
    }
  }

  // Applies T of the plan.
  [[gnu::always_inline]] void step_tool(const WalkPlan& plan) {
    const double* T = plan.tool.data();
    const auto sum = [T](int column, const WalkAxis& a, const WalkAxis& b, const WalkAxis& c) {
      return both(T[column]) * a + both(T[4 + column]) * b + both(T[8 + column]) * c;
    };
    p = p + sum(3, x, y, z);
    if (plan.tool_is_flip) {
      y = both(T[5]) * y;
      z = both(T[10]) * z;
      return;
    }
    const WalkAxis x0 = x, y0 = y, z0 = z;
    x = sum(0, x0, y0, z0);
    y = sum(1, x0, y0, z0);
    z = sum(2, x0, y0, z0);
  }
};

// The outward recursion from the base to the last joint. A step is two plane rotations, of which
// those by zero or a right angle cost nothing, and a multiply-add for each length that is not zero.
//
// SinesOf<N>         computes the sines and cosines of the joints.
// at_axis(i, frame)  is called after Z_i: frame.z is the axis of joint i except for its flip,
//                    frame.p a point on it; the link frame of the modified convention.
// at_link(i, frame)  is called after X_{i+1} for i + 1 < n: the link frame of the standard
//                    convention.
// returns            the frame before T.
template <int N, template <int> class SinesOf = JointSines, class AtAxis, class AtLink>
[[gnu::always_inline]] inline WalkFrame walk_out(const WalkPlan& plan, const double* q,
                                                 const AtAxis& at_axis, const AtLink& at_link) {
  const SinesOf<N> sines(plan, q);
  const double* B = plan.base.data();
  WalkFrame frame = {WalkAxis::load(B), WalkAxis::load(B + 3), WalkAxis::load(B + 6),
                     WalkAxis::load(B + 9)};
  const int n = joint_count<N>(plan);
#pragma GCC unroll 8
  for (int joint = 0; joint < n; ++joint) {
    const std::size_t i = static_cast<std::size_t>(joint);
    if (i > 0) {
      frame.step_x(plan, i);
      at_link(i - 1, frame);
    }
    if (plan.has_d[i]) frame.p = frame.p + both(plan.d[i] + q[i] * plan.q_to_d[i]) * frame.z;
    const Lanes s = sines.sine(joint);
    const Lanes c = sines.cosine(joint);
    const WalkAxis x_before = frame.x;
    frame.x = c * x_before + s * frame.y;
    frame.y = c * frame.y - s * x_before;
    at_axis(i, frame);
  }
  return frame;
}

}  // namespace armlet
