#pragma once
// Stores the nearest triangle of every sample.

#include <cstdint>
#include <cstring>
#include <vector>

#include "camera/raster/coverage.hpp"

namespace armlet::raster {

// Four numbers: every operation is applied to each, on every instruction set.
using F4 = float __attribute__((vector_size(16)));
using I4 = std::int32_t __attribute__((vector_size(16)));

inline F4 smaller(F4 a, F4 b) { return a < b ? a : b; }
inline F4 larger(F4 a, F4 b) { return a > b ? a : b; }
inline F4 within(F4 x, float low, float high) {
  return smaller(larger(x, F4{} + low), F4{} + high);
}
inline constexpr I4 kCount{0, 1, 2, 3};

template <class V, class T>
V load4(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof(v));
  return v;
}
template <class V, class T>
void store4(T* to, V v) {
  std::memcpy(to, &v, sizeof(v));
}

// A triangle in the picture with the quantity whose largest value is visible: 1/z for a camera, the
// height towards the light for a shadow map. It is a u + b v + c at pixel (u, v), clamped to low
// and high: rounded corners are a little outside of the exact ones, where the value of a steep
// plane would be far off.
struct DrawnTriangle {
  FixedTriangle corners;
  float low, high;
  double a, b, c;
  std::int32_t number;  // stored for its samples
};

// Samples of some rows of a grid; rows are padded to groups of four.
struct SampleRows {
  std::vector<float> nearness;
  std::vector<std::int32_t> number;  // empty for shadow maps
  std::size_t stride = 0;

  static std::size_t stride_of(int columns) {
    return (static_cast<std::size_t>(columns) + 3) / 4 * 4;
  }
  // Reuses allocated memory.
  void resize(int columns, int rows, bool with_numbers) {
    stride = stride_of(columns);
    const std::size_t size = stride * static_cast<std::size_t>(rows);
    if (nearness.size() < size) nearness.resize(size);
    if (with_numbers && number.size() < size) number.resize(size);
  }
};

// Fills one row of samples from column `first` to `last` - 1. Every sample is computed from
// `first`, so that results do not depend on the groups.
template <bool kNumbers>
inline void fill_span(const DrawnTriangle& t, double u_first, float slope, double v, int first,
                      int last, float* nearness, std::int32_t* number) {
  const F4 start = F4{} + static_cast<float>(t.a * u_first + (t.b * v + t.c));
  for (int column = first & ~3; column < last; column += 4) {
    const I4 at = kCount + column;
    const F4 steps = __builtin_convertvector(at - first, F4);
    const F4 value = within(start + slope * steps, t.low, t.high);
    const F4 before = load4<F4>(nearness + column);
    const I4 wins = (value > before) & (at >= first) & (at < last);
    store4(nearness + column, wins ? value : before);
    if constexpr (kNumbers) {
      const I4 old = load4<I4>(number + column);
      store4(number + column, wins ? I4{} + t.number : old);
    }
  }
}

// Rows begin to end - 1 of a grid, of which `rows` holds those from `begin` on.
template <bool kNumbers>
void fill(const DrawnTriangle& t, const SampleGrid& grid, int begin, int end, SampleRows& rows) {
  const float slope = static_cast<float>(t.a * grid.step * (1.0 / kOne));
  cover(t.corners, grid, begin, end, [&](int row, int first, int last) {
    const std::size_t offset = static_cast<std::size_t>(row - begin) * rows.stride;
    fill_span<kNumbers>(t, grid.u(first), slope, grid.v(row), first, last,
                        rows.nearness.data() + offset,
                        kNumbers ? rows.number.data() + offset : nullptr);
  });
}

}  // namespace armlet::raster
