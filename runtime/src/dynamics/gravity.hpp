#pragma once

#include "duo.hpp"
#include "dynamics_plan.hpp"

namespace armlet {

// Joint forces that hold an arm at rest, from the last joint to the first. The weight beyond a
// joint acts by the first moment of all links beyond it about the joint's frame.
//
// motion, sines, gravity, give  as for newton_euler().
template <class V, int N, bool kSlides, class Sines, class Motion, class Give>
[[gnu::always_inline]] inline void gravity_recursion(const DynamicsPlan& plan, const Sines& sines,
                                                     const Motion& motion, const double* gravity,
                                                     const Give& give) {
  const int n = N == 0 ? static_cast<int>(plan.n) : N;
  constexpr int kCapacity = N == 0 ? static_cast<int>(kPlanJoints) : N;
  Triple<V> a[kCapacity];
  {
    const V x = constant<V>(gravity[0]), y = constant<V>(gravity[1]);
    const V sine = sines.sine(0), cosine = sines.cosine(0);
    a[0] = {cosine * x + sine * y, cosine * y - sine * x, constant<V>(gravity[2])};
  }
#pragma GCC unroll 8
  for (int i = 1; i < n; ++i) {
    a[i] = turn_out<V>(plan.links[i], sines.sine(i), sines.cosine(i), a[i - 1]);
  }
  Triple<V> h;
#pragma GCC unroll 8
  for (int i = n - 1; i >= 0; --i) {
    const PlanLink& link = plan.links[i];
    const Triple<V> own = {constant<V>(link.gravity.h[0]), constant<V>(link.gravity.h[1]),
                           constant<V>(link.gravity.h[2])};
    h = i == n - 1 ? own : h + own;
    if (kSlides && link.slides) {
      const V mass = constant<V>(link.gravity.mass);
      give(i, mass * a[i].z);
      h.z = h.z + mass * motion.q(i);
    } else {
      give(i, h.x * a[i].y - h.y * a[i].x);
    }
    if (i > 0) h = turn_in_x<V>(link, turn_in_z<V>(sines.sine(i), sines.cosine(i), h));
  }
}

}  // namespace armlet
