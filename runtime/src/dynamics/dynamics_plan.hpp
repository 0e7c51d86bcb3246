#pragma once

#include <cstddef>

// An arm in the form of the dynamic recursions; plain data only, because sources for larger
// instruction sets include it.
namespace armlet {

inline constexpr std::size_t kPlanJoints = 12;

// Friction at a joint.
struct PlanFriction {
  double viscous, coulomb_plus, coulomb_minus;
  double static_extra_plus, static_extra_minus;  // static minus Coulomb friction
  double stribeck_rate;                          // 1 / the joint's Stribeck speed, or 0
};

// The masses of a link and all beyond it for gravity, regrouped as in PlanLink.
struct PlanGravity {
  double mass;
  // First moment, including the masses beyond the next joint that have a constant position in the
  // link's frame.
  double h[3];
};

// One joint and the link that it moves, in frame i of the WalkPlan (after Z_i), whose z axis is the
// joint's.
//
// Mass on the axis of a revolute joint may be moved to the link before without changing any torque.
// This is done: the mass, the z component of the first moment and the zz entry of the second moment
// of such a link are zero, which leaves seven of ten numbers. Links of prismatic joints keep all
// ten.
struct PlanLink {
  double sin_alpha, cos_alpha, a;  // X_i before joint i > 0
  double d;                        // Z_i, without the joint's value
  double sign;                     // of the joint's value in Z_i, 1 or -1

  double mass;
  double h[3];                          // first moment, the integral of r dm: x, y, z
  double Sxx, Sxy, Sxz, Syy, Syz, Szz;  // second moment, the integral of r r' dm

  PlanGravity gravity;
  double motor_inertia;  // G^2 J, at the joint
  PlanFriction friction;

  unsigned char twist;  // LinkTwist of X_i
  bool has_a, has_d, slides;
};

enum class FrictionKind : unsigned char { kNone, kCoulomb, kStribeck };

struct DynamicsPlan {
  std::size_t n;
  double base_acceleration[3];  // minus gravity, in the axes of B of the WalkPlan
  bool any_slides;
  // Number of links, from the first on, with axes parallel to the first: they move in one plane, so
  // one rate describes their rotations, and only the moment about that axis of their forces
  // matters. At least 1.
  std::size_t flat;
  FrictionKind friction;
  PlanLink links[kPlanJoints];

  // Whether kernels have to distinguish joints: prismatic ones, and those of `flat`.
  [[nodiscard]] bool is_mixed() const { return any_slides || flat > 1; }
};

// DynamicsPlan::flat, in a kernel for N joints, 0: any number; kSlides: for a plan that is mixed.
template <int N, bool kSlides>
[[gnu::always_inline]] inline int flat_links(const DynamicsPlan& plan) {
  if (!kSlides || N == 1) return 1;
  const int flat = static_cast<int>(plan.flat);
  if (flat < 1) __builtin_unreachable();
  return flat;
}

}  // namespace armlet
