#pragma once

#include "duo.hpp"
#include "dynamics_plan.hpp"

// Inverse dynamics by the recursion of Newton and Euler, of one configuration (V = double) or of
// one per lane. Everything is inlined by force and needs nothing from the standard library, because
// sources for larger instruction sets include it.
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
  V xx, xy, xz, yx, yy, yz, zx, zy, zz;
  V zz_yy, xx_zz, yy_xx;  // differences of the diagonal

  [[gnu::always_inline]] explicit SpinMatrix(const Triple<Duo<V>>& spin) {
    const V wx = spin.x.first(), wy = spin.y.first(), wz = spin.z.first();
    const V ex = spin.x.second(), ey = spin.y.second(), ez = spin.z.second();
    const V wxx = wx * wx, wyy = wy * wy, wzz = wz * wz;
    const V wxy = wx * wy, wxz = wx * wz, wyz = wy * wz;
    xx = -(wyy + wzz);
    yy = -(wxx + wzz);
    zz = -(wxx + wyy);
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
  load.f = {A.xx * hx + A.xy * hy, A.yx * hx + A.yy * hy, A.zx * hx + A.zy * hy};
  load.n.x = (hy * a.z + A.zx * Sxy) + (A.zy * Syy + A.zz_yy * Syz) - A.yx * Sxz;
  load.n.y = (A.xx_zz * Sxz + A.xy * Syz) - (hx * a.z + A.zx * Sxx) - A.zy * Sxy;
  load.n.z = (hx * a.y - hy * a.x) + (A.yx * Sxx - A.xy * Syy) +
             (A.yy_xx * Sxy + (A.yz * Sxz - A.xz * Syz));
  if (kSlides && link.slides) {
    const V m = constant<V>(link.mass), hz = constant<V>(link.h[2]), Szz = constant<V>(link.Szz);
    load.f.x += m * a.x + A.xz * hz;
    load.f.y += m * a.y + A.yz * hz;
    load.f.z += m * a.z + A.zz * hz;
    load.n.x -= hz * a.y + A.yz * Szz;
    load.n.y += hz * a.x + A.xz * Szz;
  }
  return load;
}

// The link behind the fixed base: it only spins about its axis, or does not spin at all.
template <class V, bool kSlides>
[[gnu::always_inline]] inline Triple<Duo<V>> first_spin(const PlanLink& link, V rate, V rate_rate) {
  const V zero = constant<V>(0.0);
  const Duo<V> none = {zero, zero};
  if (kSlides && link.slides) return {none, none, none};
  return {none, none, {rate, rate_rate}};
}

// Joint forces of a rigid arm, without motors and friction.
//
// kSlides   whether there may be sliding joints.
// kAccel    whether the joints accelerate; otherwise qdd is not asked for.
// sines     sine(i), cosine(i) of the rotation of Z_i.
// motion    q(i), qd(i), qdd(i), already with the plan's sign; q only of sliding joints.
// gravity   three numbers: what the base accelerates by, in the axes of B.
// give(i, force)  receives the force of joint i, with the plan's sign, from the last to the first.
template <class V, int N, bool kSlides, bool kAccel, class Sines, class Motion, class Give>
[[gnu::always_inline]] inline void newton_euler(const DynamicsPlan& plan, const Sines& sines,
                                                const Motion& motion, const double* gravity,
                                                const Give& give) {
  const int n = N == 0 ? static_cast<int>(plan.n) : N;
  constexpr int kCapacity = N == 0 ? static_cast<int>(kPlanJoints) : N;
  LinkLoad<V> loads[kCapacity];
  Triple<V> a = {constant<V>(gravity[0]), constant<V>(gravity[1]), constant<V>(gravity[2])};
  const auto rate_rate = [&](int i) __attribute__((always_inline)) {
    if constexpr (kAccel) return motion.qdd(i);
    return constant<V>(0.0);
  };
  const auto shift = [&](int i) __attribute__((always_inline)) {
    const V d = constant<V>(plan.links[i].d);
    return kSlides && plan.links[i].slides ? d + motion.q(i) : d;
  };
  Triple<Duo<V>> spin = first_spin<V, kSlides>(plan.links[0], motion.qd(0), rate_rate(0));
  SpinMatrix<V> A(spin);
  {
    const PlanLink& link = plan.links[0];
    a = {sines.cosine(0) * a.x + sines.sine(0) * a.y, sines.cosine(0) * a.y - sines.sine(0) * a.x,
         a.z};
    if (kSlides && link.slides) a.z = a.z + rate_rate(0);
    loads[0] = link_load<V, kSlides>(link, A, a);
  }
  upward<N>(
      1, n, [&](int i) __attribute__((always_inline)) {
        const PlanLink& link = plan.links[i];
        const V sine = sines.sine(i), cosine = sines.cosine(i);
        if (link.has_a) {
          const V length = constant<V>(link.a);
          a = {a.x + length * A.xx, a.y + length * A.yx, a.z + length * A.zx};
        }
        a = turn_out<V>(link, sine, cosine, a);
        spin = turn_out<V>(link, sine, cosine, spin);
        const V rate = motion.qd(i);
        if (!kSlides || !link.slides) {
          const V zero = constant<V>(0.0);
          spin.x = spin.x + Duo<V>{zero, spin.y.first() * rate};
          spin.y = spin.y - Duo<V>{zero, spin.x.first() * rate};
          spin.z = spin.z + Duo<V>{rate, rate_rate(i)};
        }
        A = SpinMatrix<V>(spin);
        if (link.has_d) {
          const V d = shift(i);
          a = {a.x + d * A.xz, a.y + d * A.yz, a.z + d * A.zz};
        }
        if (kSlides && link.slides) {
          const V twice = rate + rate;
          a = {a.x + spin.y.first() * twice, a.y - spin.x.first() * twice, a.z + rate_rate(i)};
        }
        loads[i] = link_load<V, kSlides>(link, A, a);
      });
  Triple<V> f = loads[n - 1].f, moment = loads[n - 1].n;
  downward<N>(
      n, 1, [&](int i) __attribute__((always_inline)) {
        const PlanLink& link = plan.links[i];
        give(i, kSlides && link.slides ? f.z : moment.z);
        const V sine = sines.sine(i), cosine = sines.cosine(i);
        if (link.has_d) {
          const V d = shift(i);
          moment.x -= d * f.y;
          moment.y += d * f.x;
        }
        f = turn_in_x<V>(link, turn_in_z<V>(sine, cosine, f));
        moment = turn_in_x<V>(link, turn_in_z<V>(sine, cosine, moment));
        if (link.has_a) {
          const V length = constant<V>(link.a);
          moment.y -= length * f.z;
          moment.z += length * f.y;
        }
        f = f + loads[i - 1].f;
        moment = moment + loads[i - 1].n;
      });
  give(0, kSlides && plan.links[0].slides ? f.z : moment.z);
}

}  // namespace armlet
