#pragma once

#include "chain/walk_out.hpp"

namespace armlet {

// v and w of a revolute joint about `axis` through a point at -r from the tool.
[[gnu::always_inline]] inline void store_revolute(double* column, const WalkAxis& axis,
                                                  const WalkAxis& r) {
  const Lanes r_yx = {r.xy[1], r.xy[0]};
  const Lanes products = axis.xy * r_yx;
  store_pair(column, Lanes{axis.xy[1], axis.z} * Lanes{r.z, r.xy[0]} -
                         Lanes{axis.z, axis.xy[0]} * Lanes{r.xy[1], r.z});
  store_pair(column + 2, Lanes{products[0] - products[1], axis.xy[0]});
  store_pair(column + 4, Lanes{axis.xy[1], axis.z});
}

[[gnu::always_inline]] inline void store_sliding(double* column, const WalkAxis& axis) {
  axis.store(column, 0.0);
  store_pair(column + 4, both(0.0));
}

// The outward recursion stores axis and origin of each joint; one cross product each gives the
// columns.
//
// source  Siciliano et al., Robotics, 2009, equation 3.30.
template <int N, template <int> class SinesOf = JointSines>
[[gnu::always_inline]] inline WalkFrame walk_jacobian(const WalkPlan& plan, const double* q,
                                                      double* J) {
  std::array<WalkAxis, kJointCapacity<N>> axis, point;
  WalkFrame frame = walk_out<N, SinesOf>(
      plan, q,
      [&](std::size_t i, const WalkFrame& f) {
        axis[i] = f.z;
        point[i] = f.p;
      },
      [](std::size_t, const WalkFrame&) {});
  frame.step_tool(plan);
  const std::size_t n = static_cast<std::size_t>(joint_count<N>(plan));
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; ++i) {
    if (plan.q_to_theta[i] != 0.0) {
      store_revolute(J + 6 * i, both(plan.q_to_theta[i]) * axis[i], frame.p - point[i]);
    } else {
      store_sliding(J + 6 * i, both(plan.q_to_d[i]) * axis[i]);
    }
  }
  return frame;
}

}  // namespace armlet
