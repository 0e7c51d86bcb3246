#pragma once

#include "det_lanes.hpp"

// Angles of directions, several in parallel; for sources of any instruction set like det_lanes.hpp.
namespace armlet::det {

// The bits of `a` where the mask is set, else those of `b`.
template <class V>
[[gnu::always_inline]] inline V choose(LaneBits<V> mask, V a, V b) {
  if constexpr (sizeof(V) > sizeof(Lanes)) {
    return mask ? a : b;
  } else {
    return V((mask & LaneBits<V>(a)) | (~mask & LaneBits<V>(b)));
  }
}

// The angle of each direction (x, y) in [-pi, pi], without branches, with an error of about one
// unit in the last place. Lengths are between 1e-150 and 1e150; a vector of length zero gives NaN.
//
// The ratio of the smaller to the larger part is reduced to a number near zero by the tangent of a
// difference, with base points 0, 1/2 and 1; the polynomial is fdlibm's (det_polynomials.hpp).
template <class V>
[[gnu::always_inline]] inline V atan2_lanes(V y, V x) {
  using Bits = LaneBits<V>;
  constexpr double A0 = 3.33333333333329318027e-01, A1 = -1.99999999998764832476e-01,
                   A2 = 1.42857142725034663711e-01, A3 = -1.11111104054623557880e-01,
                   A4 = 9.09088713343650656196e-02, A5 = -7.69187620504482999495e-02,
                   A6 = 6.66107313738753120669e-02, A7 = -5.83357013379057348645e-02,
                   A8 = 4.97687799461593236017e-02, A9 = -3.65315727442169155270e-02,
                   A10 = 1.62858201153657823623e-02;
  constexpr auto kSignBit = static_cast<std::int64_t>(std::uint64_t{1} << 63U);
  const Bits sign = Bits{} + kSignBit;
  const V ax = V(Bits(x) & ~sign);
  const V ay = V(Bits(y) & ~sign);
  const Bits steep = ay > ax;
  const V small = choose<V>(steep, ax, ay);
  const V large = choose<V>(steep, ay, ax);
  const Bits middle = small >= 0.4375 * large;
  const Bits far = small >= 0.6875 * large;
  const V none = V{};
  const V base = choose<V>(far, none + 1.0, choose<V>(middle, none + 0.5, none));
  const V t = (small - base * large) / (large + base * small);
  const V z = t * t;
  const V w = z * z;
  const V even = z * (A0 + w * (A2 + w * (A4 + w * (A6 + w * (A8 + w * A10)))));
  const V odd = w * (A1 + w * (A3 + w * (A5 + w * (A7 + w * A9))));
  const V angle_hi = choose<V>(far, none + 7.85398163397448278999e-01,
                               choose<V>(middle, none + 4.63647609000806093515e-01, none));
  const V angle_lo = choose<V>(far, none + 3.06161699786838301793e-17,
                               choose<V>(middle, none + 2.26987774529616870924e-17, none));
  const V first = angle_hi + (t - (t * (even + odd) - angle_lo));
  const V up =
      choose<V>(steep, (1.57079632679489655800e+00 - first) + 6.12323399573676603587e-17, first);
  const V around = (3.14159265358979311600e+00 - up) + 1.22464679914735320717e-16;
  const V angle = choose<V>(Bits(x < none), around, up);
  return V(Bits(angle) | (Bits(y) & sign));
}

}  // namespace armlet::det
