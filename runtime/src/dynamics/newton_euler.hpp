#pragma once

#include "duo.hpp"
#include "dynamics_plan.hpp"

// Inverse dynamics by the Newton-Euler recursion, of one configuration (V = double) or of one per
// lane. All functions are always inlined and need nothing from the standard library, because
// sources for larger instruction sets include them.
//
// With the matrix A = [alpha]x + [omega]x [omega]x of a link, the point r of it accelerates by
// a + A r, so that the integrals over the link are
//
//   f = m a + A h,    n = h x a + axial vector of A S,    h = integral r dm, S = integral r r' dm.
//
// source  J. Y. S. Luh, M. W. Walker, R. P. C. Paul, On-line computational scheme for mechanical
//         manipulators, 1980; base parameters: M. Gautier, W. Khalil, Direct calculation of minimum
//         set of inertial parameters of serial robots, IEEE Trans. RA 6(3), 1990.
namespace armlet {

template <class V>
struct LinkLoad {
  Triple<V> f, n;  // force and moment about the origin, in the axes of the link
};

// The matrix A of a link, from its angular velocity and acceleration.
template <class V>
struct SpinMatrix {
  V minus_xx, xy, xz, yx, minus_yy, yz, zx, zy, minus_zz;
  V zz_yy, xx_zz, yy_xx;  // differences of the diagonal

  [[gnu::always_inline]] explicit SpinMatrix(const Triple<Duo<V>>& spin) {
    const V wx = spin.x.first(), wy = spin.y.first(), wz = spin.z.first();
    const V ex = spin.x.second(), ey = spin.y.second(), ez = spin.z.second();
    const V wxx = wx * wx, wyy = wy * wy, wzz = wz * wz;
    const V wxy = wx * wy, wxz = wx * wz, wyz = wy * wz;
    minus_xx = wyy + wzz;
    minus_yy = wxx + wzz;
    minus_zz = wxx + wyy;
    xy = wxy - ez;
    yx = wxy + ez;
    xz = wxz + ey;
    zx = wxz - ey;
    yz = wyz - ex;
    zy = wyz + ex;
    zz_yy = wzz - wyy;
    xx_zz = wxx - wzz;
    yy_xx = wyy - wxx;
  }
};

// f and n of a link whose origin accelerates by a. A revolute link has seven numbers.
template <class V, bool kSlides>
[[gnu::always_inline]] inline LinkLoad<V> link_load(const PlanLink& link, const SpinMatrix<V>& A,
                                                    const Triple<V>& a) {
  const V hx = constant<V>(link.h[0]), hy = constant<V>(link.h[1]);
  const V Sxx = constant<V>(link.Sxx), Sxy = constant<V>(link.Sxy), Sxz = constant<V>(link.Sxz);
  const V Syy = constant<V>(link.Syy), Syz = constant<V>(link.Syz);
  LinkLoad<V> load;
  load.f = {A.xy * hy - A.minus_xx * hx, A.yx * hx - A.minus_yy * hy, A.zx * hx + A.zy * hy};
  load.n.x = (hy * a.z + A.zx * Sxy) + (A.zy * Syy + A.zz_yy * Syz) - A.yx * Sxz;
  load.n.y = (A.xx_zz * Sxz + A.xy * Syz) - (hx * a.z + A.zx * Sxx) - A.zy * Sxy;
  load.n.z = (hx * a.y - hy * a.x) + (A.yx * Sxx - A.xy * Syy) +
             (A.yy_xx * Sxy + (A.yz * Sxz - A.xz * Syz));
  if (kSlides && link.slides) {
    const V m = constant<V>(link.mass), hz = constant<V>(link.h[2]), Szz = constant<V>(link.Szz);
    load.f.x += m * a.x + A.xz * hz;
    load.f.y += m * a.y + A.yz * hz;
    load.f.z += m * a.z - A.minus_zz * hz;
    load.n.x -= hz * a.y + A.yz * Szz;
    load.n.y += hz * a.x + A.xz * Szz;
  }
  return load;
}

// The same for a planar link (DynamicsPlan::flat): its force and n.z, the only component that
// matters.
//
// square, change  of the rate about the axis: its square, and the angular acceleration.
template <class V, bool kSlides>
[[gnu::always_inline]] inline LinkLoad<V> flat_load(const PlanLink& link, V square, V change,
                                                    const Triple<V>& a) {
  const V hx = constant<V>(link.h[0]), hy = constant<V>(link.h[1]);
  LinkLoad<V> load;
  load.f = {-(square * hx + change * hy), change * hx - square * hy, constant<V>(0.0)};
  load.n.z = (hx * a.y - hy * a.x) + constant<V>(link.Sxx + link.Syy) * change;
  if (kSlides && link.slides) {
    const V m = constant<V>(link.mass);
    load.f = {load.f.x + m * a.x, load.f.y + m * a.y, m * a.z};
  }
  return load;
}

// The shift of Z_i along its axis.
template <class V, bool kSlides, class Motion>
[[gnu::always_inline]] inline V shift_along(const PlanLink& link, const Motion& motion, int i) {
  const V d = constant<V>(link.d);
  return kSlides && link.slides ? d + motion.q(i) : d;
}

// Moves the reference point of a force and a moment from the origin of frame i to that of frame i -
// 1, and rotates them to its axes.
template <class V>
[[gnu::always_inline]] inline LinkLoad<V> step_in(const PlanLink& link, V sine, V cosine, V d,
                                                  const LinkLoad<V>& load) {
  LinkLoad<V> out = {turn_in_z<V>(sine, cosine, load.f), turn_in_z<V>(sine, cosine, load.n)};
  if (link.has_d) {
    out.n.x = out.n.x - d * out.f.y;
    out.n.y = out.n.y + d * out.f.x;
  }
  out = {turn_in_x<V>(link, out.f), turn_in_x<V>(link, out.n)};
  if (link.has_a) {
    const V length = constant<V>(link.a);
    out.n.y = out.n.y - length * out.f.z;
    out.n.z = out.n.z + length * out.f.y;
  }
  return out;
}

// From the last link to the first: the joint forces for the loads of the links.
template <class V, int N, bool kSlides, class Sines, class Motion, class Give>
[[gnu::always_inline]] inline void bring_in(const DynamicsPlan& plan, const Sines& sines,
                                            const Motion& motion, const LinkLoad<V>* loads,
                                            const Give& give) {
  const int n = N == 0 ? static_cast<int>(plan.n) : N;
  const int flat = flat_links<N, kSlides>(plan);
  LinkLoad<V> sum;
  const auto step = [&](int i) __attribute__((always_inline)) {
    const PlanLink& link = plan.links[i];
    give(i, kSlides && link.slides ? sum.f.z : sum.n.z);
    const V d = shift_along<V, kSlides>(link, motion, i);
    sum = step_in<V>(link, sines.sine(i), sines.cosine(i), d, sum);
    sum.f = sum.f + loads[i - 1].f;
  };
  sum.f = loads[n - 1].f;
  if (n > flat) {
    sum.n = loads[n - 1].n;
    downward<kSlides ? 0 : N>(
        n, flat + 1, [&](int i) __attribute__((always_inline)) {
          step(i);
          sum.n = sum.n + loads[i - 1].n;
        });
    step(flat);
    sum.n.z = sum.n.z + loads[flat - 1].n.z;
  } else {
    sum.n.z = loads[n - 1].n.z;
  }
  downward<0>(
      n > flat ? flat : n, 1, [&](int i) __attribute__((always_inline)) {
        const PlanLink& link = plan.links[i];
        give(i, kSlides && link.slides ? sum.f.z : sum.n.z);
        sum.f = turn_in_z<V>(sines.sine(i), sines.cosine(i), sum.f);
        if (link.has_a) sum.n.z = sum.n.z + constant<V>(link.a) * sum.f.y;
        sum.f = sum.f + loads[i - 1].f;
        sum.n.z = sum.n.z + loads[i - 1].n.z;
      });
  give(0, kSlides && plan.links[0].slides ? sum.f.z : sum.n.z);
}

// The planar links: one rate about the axis, and its derivative. The links after them follow from
// `a` and `spin`, which are those of the next frame.
template <class V, bool kSlides, class Sines, class Rates>
[[gnu::always_inline]] inline void flat_outward(const DynamicsPlan& plan, int n, int flat,
                                                const Sines& sines, const Rates& rates,
                                                Triple<V>& a, Triple<Duo<V>>& spin,
                                                LinkLoad<V>* loads) {
  const V zero = constant<V>(0.0);
  V rate = zero, change = zero, square = zero;
  const auto shift = [&](const PlanLink& link) __attribute__((always_inline)) {
    if (!link.has_a) return;
    const V length = constant<V>(link.a);
    a.x = a.x - length * square;
    a.y = a.y + length * change;
  };
  upward<0>(
      0, flat, [&](int i) __attribute__((always_inline)) {
        const PlanLink& link = plan.links[i];
        if (i > 0) shift(link);
        const V sine = sines.sine(i), cosine = sines.cosine(i);
        a = {cosine * a.x + sine * a.y, cosine * a.y - sine * a.x, a.z};
        if (kSlides && link.slides) {
          a.z = a.z + rates.change(i);
        } else {
          rate = i > 0 ? rate + rates.rate(i) : rates.rate(i);
          change = i > 0 ? change + rates.change(i) : rates.change(i);
          square = rate * rate;
        }
        loads[i] = flat_load<V, kSlides>(link, square, change, a);
      });
  if (flat >= n) return;
  const PlanLink& link = plan.links[flat];
  const V sine = sines.sine(flat), cosine = sines.cosine(flat);
  shift(link);
  a = turn_out<V>(link, sine, cosine, a);
  spin = turn_axis_out<V>(link, sine, cosine, Duo<V>{rate, change});
}

// The rates of the joints, and their accelerations if there are any.
template <class V, bool kAccel, class Motion>
struct JointRates {
  const Motion& motion;
  [[gnu::always_inline]] V rate(int i) const { return motion.qd(i); }
  [[gnu::always_inline]] V change(int i) const {
    if constexpr (kAccel) return motion.qdd(i);
    return constant<V>(0.0);
  }
};

// Joint forces of a rigid arm, without motors and friction.
//
// kSlides   whether there may be prismatic joints, or a second axis parallel to the first.
// kAccel    whether the joints accelerate; otherwise qdd is not read.
// sines     sine(i), cosine(i) of the rotation of Z_i.
// motion    q(i), qd(i), qdd(i), with the plan's sign; q only of prismatic joints.
// gravity   three numbers: the acceleration of the base, in the axes of B.
// give(i, force)  receives the force of joint i, with the plan's sign, from the last to the first.
template <class V, int N, bool kSlides, bool kAccel, class Sines, class Motion, class Give>
[[gnu::always_inline]] inline void newton_euler(const DynamicsPlan& plan, const Sines& sines,
                                                const Motion& motion, const double* gravity,
                                                const Give& give) {
  const int n = N == 0 ? static_cast<int>(plan.n) : N;
  const int flat = flat_links<N, kSlides>(plan);
  constexpr int kCapacity = N == 0 ? static_cast<int>(kPlanJoints) : N;
  LinkLoad<V> loads[kCapacity];
  const JointRates<V, kAccel, Motion> rates = {motion};
  Triple<V> a = {constant<V>(gravity[0]), constant<V>(gravity[1]), constant<V>(gravity[2])};
  Triple<Duo<V>> spin;
  flat_outward<V, kSlides>(plan, n, flat, sines, rates, a, spin, loads);
  upward<kSlides ? 0 : N>(
      flat, n, [&](int i) __attribute__((always_inline)) {
        const PlanLink& link = plan.links[i];
        const V rate = rates.rate(i);
        if (!kSlides || !link.slides) {
          const V nothing = constant<V>(-0.0);  // adding it changes no number
          spin.x = spin.x + Duo<V>{nothing, spin.y.first() * rate};
          spin.y = spin.y - Duo<V>{-nothing, spin.x.first() * rate};
          spin.z = spin.z + Duo<V>{rate, rates.change(i)};
        }
        const SpinMatrix<V> A(spin);
        if (link.has_d) {
          const V d = shift_along<V, kSlides>(link, motion, i);
          a = {a.x + d * A.xz, a.y + d * A.yz, a.z - d * A.minus_zz};
        }
        if (kSlides && link.slides) {
          const V twice = rate + rate;
          a = {a.x + spin.y.first() * twice, a.y - spin.x.first() * twice, a.z + rates.change(i)};
        }
        loads[i] = link_load<V, kSlides>(link, A, a);
        if (i + 1 == n) return;
        const PlanLink& next = plan.links[i + 1];
        const V sine = sines.sine(i + 1), cosine = sines.cosine(i + 1);
        if (next.has_a) {
          const V length = constant<V>(next.a);
          a = {a.x - length * A.minus_xx, a.y + length * A.yx, a.z + length * A.zx};
        }
        a = turn_out<V>(next, sine, cosine, a);
        spin = turn_out<V>(next, sine, cosine, spin);
      });
  bring_in<V, N, kSlides>(plan, sines, motion, loads, give);
}

}  // namespace armlet
