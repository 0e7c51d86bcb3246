#pragma once

#include "chain/batch_arm.hpp"
#include "chain/lane_parts.hpp"

// Two numbers with the same operations, such as an angular velocity and an angular acceleration:
// one vector register in kernels of one configuration, two where every lane is a configuration of
// its own. Operations and bits are the same.
namespace armlet {

template <class V>
struct Duo {
  V a, b;

  [[gnu::always_inline]] V first() const { return a; }
  [[gnu::always_inline]] V second() const { return b; }
  [[gnu::always_inline]] friend Duo operator+(Duo x, Duo y) { return {x.a + y.a, x.b + y.b}; }
  [[gnu::always_inline]] friend Duo operator-(Duo x, Duo y) { return {x.a - y.a, x.b - y.b}; }
  [[gnu::always_inline]] friend Duo operator*(V s, Duo x) { return {s * x.a, s * x.b}; }
  [[gnu::always_inline]] Duo operator-() const { return {-a, -b}; }
};

template <>
struct Duo<double> {
  det::Lanes v;

  [[gnu::always_inline]] Duo() : v{} {}
  [[gnu::always_inline]] Duo(double a, double b) : v{a, b} {}
  [[gnu::always_inline]] explicit Duo(det::Lanes lanes) : v(lanes) {}
  [[gnu::always_inline]] double first() const { return v[0]; }
  [[gnu::always_inline]] double second() const { return v[1]; }
  [[gnu::always_inline]] friend Duo operator+(Duo x, Duo y) { return Duo(x.v + y.v); }
  [[gnu::always_inline]] friend Duo operator-(Duo x, Duo y) { return Duo(x.v - y.v); }
  [[gnu::always_inline]] friend Duo operator*(double s, Duo x) {
    return Duo(det::Lanes{s, s} * x.v);
  }
  [[gnu::always_inline]] Duo operator-() const { return Duo(-v); }
};

// The number in every lane.
template <class V>
[[gnu::always_inline]] inline V constant(double value) {
  if constexpr (sizeof(V) == sizeof(double)) {
    return value;
  } else {
    return all_lanes<V>(value);
  }
}

// Calls body(i) for i = begin .. end - 1, or in reverse: unrolled in kernels for a number of joints
// N, a loop in those for any number, whose unrolled code would not fit into the cache of decoded
// instructions.
template <int N, class Body>
[[gnu::always_inline]] inline void upward(int begin, int end, const Body& body) {
  if constexpr (N == 0) {
#pragma GCC unroll 1
    for (int i = begin; i < end; ++i) body(i);
  } else {
#pragma GCC unroll 8
    for (int i = begin; i < end; ++i) body(i);
  }
}
template <int N, class Body>
[[gnu::always_inline]] inline void downward(int end, int begin, const Body& body) {
  if constexpr (N == 0) {
#pragma GCC unroll 1
    for (int i = end - 1; i >= begin; --i) body(i);
  } else {
#pragma GCC unroll 8
    for (int i = end - 1; i >= begin; --i) body(i);
  }
}

// A vector of three components, each a number, a Duo of them or one number per lane.
template <class T>
struct Triple {
  T x, y, z;

  [[gnu::always_inline]] friend Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
};

// Transforms from the axes of frame i-1 to those of frame i: the inverse of X_i and of the rotation
// of Z_i. A link is a PlanLink.
template <class V, class T, class Link>
[[gnu::always_inline]] inline Triple<T> turn_out(const Link& link, V sine, V cosine,
                                                 const Triple<T>& v) {
  T y = v.y, z = v.z;
  if (link.twist == kRightTwist) {
    y = v.z;
    z = -v.y;
  } else if (link.twist == kAnyTwist) {
    const V s = constant<V>(link.sin_alpha), c = constant<V>(link.cos_alpha);
    y = c * v.y + s * v.z;
    z = c * v.z - s * v.y;
  }
  return {cosine * v.x + sine * y, cosine * y - sine * v.x, z};
}

// Transforms a vector along z from the axes of frame i-1 to those of frame i.
template <class V, class T, class Link>
[[gnu::always_inline]] inline Triple<T> turn_axis_out(const Link& link, V sine, V cosine,
                                                      const T& axis) {
  const T nothing = {constant<V>(0.0), constant<V>(0.0)};
  if (link.twist == kRightTwist) return {sine * axis, cosine * axis, nothing};
  if (link.twist != kAnyTwist) return {nothing, nothing, axis};
  const T y = constant<V>(link.sin_alpha) * axis;
  return {sine * y, cosine * y, constant<V>(link.cos_alpha) * axis};
}

// Transforms from the axes of frame i to those of frame i-1, in two steps between which the origin
// moves.
template <class V, class T>
[[gnu::always_inline]] inline Triple<T> turn_in_z(V sine, V cosine, const Triple<T>& v) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}
template <class V, class T, class Link>
[[gnu::always_inline]] inline Triple<T> turn_in_x(const Link& link, const Triple<T>& v) {
  if (link.twist == kRightTwist) return {v.x, -v.z, v.y};
  if (link.twist == kAnyTwist) {
    const V s = constant<V>(link.sin_alpha), c = constant<V>(link.cos_alpha);
    return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
  }
  return v;
}

}  // namespace armlet
