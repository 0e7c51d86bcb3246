#pragma once

#include <cstddef>

// The inward recursion from the tool to the base with vectors that are fixed in the tool, such as
// the columns of its pose: before each joint they are expressed in the axes of another frame. All
// functions are always inlined and need nothing from the standard library, because sources for
// larger instruction sets include them.
//
// The visitor has these functions; the first three do to all its vectors what the functions of the
// same names in lane_parts.hpp do to one:
//
//   rotate_z(sine, cosine), rotate_right_z(sine, cosine), rotate_x(sin_alpha, cos_alpha)
//   start(plan, sine, cosine)    becomes T of the plan, rotated by the last joint
//   shift_z(d), shift_x(a)       the origin of the frame moves along its axis
//   place(base)                  from the base to the world; left out where they are the same
namespace armlet {

// Applies Z_i after X_{i+1}. A plan is a WalkPlan or a BatchArm.
template <class Plan, class V, class Carried>
[[gnu::always_inline]] inline void step_in(const Plan& plan, std::size_t i, V sine, V cosine,
                                           Carried& carried) {
  if (plan.right_angle(i + 1)) {
    carried.rotate_right_z(sine, cosine);
    return;
  }
  if (plan.any_angle(i + 1)) carried.rotate_x(plan.sin_alpha[i + 1], plan.cos_alpha[i + 1]);
  carried.rotate_z(sine, cosine);
}

// Applies all n joints of one configuration.
template <class Plan, class Sines, class Carried>
[[gnu::always_inline]] inline void walk_in(const Plan& plan, int n, const double* q,
                                           const Sines& angles, Carried& carried) {
  const auto shift = [&](int i) __attribute__((always_inline)) {
    if (plan.has_d[i]) carried.shift_z(plan.d[i] + q[i] * plan.q_to_d[i]);
    if (i > 0 && plan.has_a[i]) carried.shift_x(plan.a[i]);
  };
  carried.start(plan, angles.sine(n - 1), angles.cosine(n - 1));
  shift(n - 1);
#pragma GCC unroll 8
  for (int joint = n - 2; joint >= 0; --joint) {
    step_in(plan, static_cast<std::size_t>(joint), angles.sine(joint), angles.cosine(joint),
            carried);
    shift(joint);
  }
  if (!plan.base_is_none) carried.place(&plan.base[0]);
}

}  // namespace armlet
