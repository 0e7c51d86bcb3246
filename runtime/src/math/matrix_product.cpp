#include "armlet/math/matrix_product.hpp"

#include <algorithm>
#include <cstring>

namespace armlet {

namespace {

// Two neighbouring elements at once. The lanes are independent, so the order of the sums is
// unchanged.
using Pair [[gnu::vector_size(16)]] = double;

Pair load(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
void store(double* to, Pair pair) { std::memcpy(to, &pair, sizeof pair); }

// Products of square matrices whose size is known at compile time: the sums of a row stay in
// registers.
template <std::size_t kSize>
void multiply_small(const double* a, const double* b, double* c) {
  constexpr std::size_t kPairs = kSize / 2;
  constexpr bool kOdd = kSize % 2 != 0;
  for (std::size_t i = 0; i < kSize; ++i, a += kSize, c += kSize) {
    Pair sums[kPairs] = {};
    double last = 0.0;
#pragma GCC unroll 6
    for (std::size_t k = 0; k < kSize; ++k) {
#pragma GCC unroll 3
      for (std::size_t j = 0; j < kPairs; ++j) sums[j] += a[k] * load(b + k * kSize + 2 * j);
      if constexpr (kOdd) last += a[k] * b[k * kSize + kSize - 1];
    }
#pragma GCC unroll 3
    for (std::size_t j = 0; j < kPairs; ++j) store(c + 2 * j, sums[j]);
    if constexpr (kOdd) c[kSize - 1] = last;
  }
}

bool multiply_square(const double* a, const double* b, double* c, std::size_t size) {
  switch (size) {
    case 2:
      multiply_small<2>(a, b, c);
      return true;
    case 3:
      multiply_small<3>(a, b, c);
      return true;
    case 4:
      multiply_small<4>(a, b, c);
      return true;
    case 5:
      multiply_small<5>(a, b, c);
      return true;
    case 6:
      multiply_small<6>(a, b, c);
      return true;
    default:
      return false;
  }
}

void multiply_plainly(const double* a, const double* b, double* c, std::size_t rows,
                      std::size_t inner, std::size_t cols) {
  for (std::size_t i = 0; i < rows; ++i) {
    double* row = c + i * cols;
    std::fill_n(row, cols, 0.0);
    for (std::size_t k = 0; k < inner; ++k) {
      for (std::size_t j = 0; j < cols; ++j) row[j] += a[i * inner + k] * b[k * cols + j];
    }
  }
}

constexpr std::size_t kRows = 4;     // rows of c at once
constexpr std::size_t kCols = 4;     // columns of c at once
constexpr std::size_t kDepth = 256;  // rows of a strip of b, which fits the first-level cache

// Adds `depth` products to 4 columns of c. strip: those columns of b, row by row. The compiler
// unrolls the loops over rows, so that all sums stay in registers.
template <std::size_t kHeight>
void add_products(const double* a, std::size_t stride, const double* strip, std::size_t depth,
                  double* c, std::size_t c_stride) {
  Pair left[kHeight];
  Pair right[kHeight];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < kHeight; ++i) {
    left[i] = load(c + i * c_stride);
    right[i] = load(c + i * c_stride + 2);
  }
  for (std::size_t k = 0; k < depth; ++k) {
    const Pair b_left = load(strip + k * kCols);
    const Pair b_right = load(strip + k * kCols + 2);
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kHeight; ++i) {
      const double factor = a[i * stride + k];
      left[i] += factor * b_left;
      right[i] += factor * b_right;
    }
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < kHeight; ++i) {
    store(c + i * c_stride, left[i]);
    store(c + i * c_stride + 2, right[i]);
  }
}

// If fewer than four columns are left, they are padded with zeros.
template <std::size_t kHeight>
void add_products_at_edge(const double* a, std::size_t stride, const double* strip,
                          std::size_t depth, double* c, std::size_t c_stride, std::size_t width) {
  if (width == kCols) return add_products<kHeight>(a, stride, strip, depth, c, c_stride);
  double margin[kHeight * kCols] = {};
  for (std::size_t i = 0; i < kHeight; ++i)
    std::copy_n(c + i * c_stride, width, margin + i * kCols);
  add_products<kHeight>(a, stride, strip, depth, margin, kCols);
  for (std::size_t i = 0; i < kHeight; ++i)
    std::copy_n(margin + i * kCols, width, c + i * c_stride);
}

void fill_strip(const double* b, std::size_t stride, std::size_t depth, std::size_t width,
                double* strip) {
  if (width < kCols) std::fill_n(strip, depth * kCols, 0.0);
  for (std::size_t k = 0; k < depth; ++k) std::copy_n(b + k * stride, width, strip + k * kCols);
}

// Multiplies all rows of a by one strip.
void add_strip(const double* a, std::size_t a_stride, const double* strip, std::size_t depth,
               double* c, std::size_t c_stride, std::size_t rows, std::size_t width) {
  std::size_t i = 0;
  for (; i + kRows <= rows; i += kRows) {
    add_products_at_edge<kRows>(a + i * a_stride, a_stride, strip, depth, c + i * c_stride,
                                c_stride, width);
  }
  a += i * a_stride;
  c += i * c_stride;
  switch (rows - i) {
    case 3:
      return add_products_at_edge<3>(a, a_stride, strip, depth, c, c_stride, width);
    case 2:
      return add_products_at_edge<2>(a, a_stride, strip, depth, c, c_stride, width);
    case 1:
      return add_products_at_edge<1>(a, a_stride, strip, depth, c, c_stride, width);
    default:
      return;
  }
}

}  // namespace

void multiply(const double* a, const double* b, double* c, std::size_t rows, std::size_t inner,
              std::size_t cols) {
  if (rows == inner && inner == cols && multiply_square(a, b, c, rows)) return;
  if (rows < kRows || cols < kCols) return multiply_plainly(a, b, c, rows, inner, cols);
  std::fill_n(c, rows * cols, 0.0);
  double strip[kDepth * kCols];
  for (std::size_t k = 0; k < inner; k += kDepth) {
    const std::size_t depth = std::min(kDepth, inner - k);
    for (std::size_t j = 0; j < cols; j += kCols) {
      const std::size_t width = std::min(kCols, cols - j);
      fill_strip(b + k * cols + j, cols, depth, width, strip);
      add_strip(a + k, inner, strip, depth, c + j, cols, rows, width);
    }
  }
}

void multiply_vector(const double* a, const double* x, double* y, std::size_t rows,
                     std::size_t cols) {
  std::size_t i = 0;
  for (; i + 4 <= rows; i += 4) {
    const double* row = a + i * cols;
    double sums[4] = {};
    for (std::size_t k = 0; k < cols; ++k) {
      for (std::size_t n = 0; n < 4; ++n) sums[n] += row[n * cols + k] * x[k];
    }
    std::copy_n(sums, 4, y + i);
  }
  for (; i < rows; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < cols; ++k) sum += a[i * cols + k] * x[k];
    y[i] = sum;
  }
}

}  // namespace armlet
