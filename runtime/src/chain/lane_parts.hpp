#pragma once

#include <cstddef>

#include "math/det_lanes.hpp"

// Vectors of three parts, each of which is a vector register of any width. As in det_lanes.hpp, all
// functions are always inlined and need nothing from the standard library, because sources for
// larger instruction sets include them.
namespace armlet {

// Vectors that need not be aligned.
template <class V>
[[gnu::always_inline]] inline V load_lanes(const double* p) {
  V v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
template <class V>
[[gnu::always_inline]] inline void store_lanes(double* p, V v) {
  __builtin_memcpy(p, &v, sizeof v);
}

// A vector with the same number in every lane; subtracting 0 keeps the sign of -0.
template <class V>
[[gnu::always_inline]] inline V all_lanes(double value) {
  return value - V{};
}

// A vector of three parts, one arm per lane, or one part of two columns side by side.
template <class V>
struct Parts {
  V x, y, z;

  // X of twist alpha, applied to the parts.
  [[gnu::always_inline]] void rotate_x(V sin_alpha, V cos_alpha) {
    const V y_before = y;
    y = cos_alpha * y_before - sin_alpha * z;
    z = sin_alpha * y_before + cos_alpha * z;
  }

  // Z of angle theta, applied to the parts.
  [[gnu::always_inline]] void rotate_z(V sine, V cosine) {
    const V x_before = x;
    x = cosine * x_before - sine * y;
    y = sine * x_before + cosine * y;
  }

  // Z after an X of a right angle, which only exchanges parts.
  [[gnu::always_inline]] void rotate_right_z(V sine, V cosine) {
    const V x_before = x, y_before = y;
    x = cosine * x_before + sine * z;
    y = sine * x_before - cosine * z;
    z = y_before;
  }

  // The rotation of a column-major frame B, applied to the parts.
  [[gnu::always_inline]] void rotate_base(const double* B) {
    const V x_before = x, y_before = y, z_before = z;
    x = B[0] * x_before + B[3] * y_before + B[6] * z_before;
    y = B[1] * x_before + B[4] * y_before + B[7] * z_before;
    z = B[2] * x_before + B[5] * y_before + B[8] * z_before;
  }
};

template <class V>
[[gnu::always_inline]] inline Parts<V> operator+(const Parts<V>& a, const Parts<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
[[gnu::always_inline]] inline Parts<V> operator-(const Parts<V>& a, const Parts<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
[[gnu::always_inline]] inline Parts<V> operator*(V s, const Parts<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class V>
[[gnu::always_inline]] inline Parts<V> cross(const Parts<V>& a, const Parts<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A 3D vector with the same components in every lane.
template <class V>
[[gnu::always_inline]] inline Parts<V> all_lanes_of(const double* vector) {
  return {all_lanes<V>(vector[0]), all_lanes<V>(vector[1]), all_lanes<V>(vector[2])};
}

// Consecutive vectors, `count` numbers apart.
template <class V>
[[gnu::always_inline]] inline void store_parts(double* out, std::size_t count, const Parts<V>& v) {
  store_lanes(out, v.x);
  store_lanes(out + count, v.y);
  store_lanes(out + 2 * count, v.z);
}

}  // namespace armlet
