#pragma once

#include <cstddef>

namespace armlet {

// Products of matrices in row-major order.
//
// Every element is the sum of its products from the first to the last, each rounded, beginning with
// 0: the same bits on every machine, whatever the vector width. The result must not overlap the
// factors. Arguments are not checked; no exceptions.

// c = a b, where a is rows x inner and b is inner x cols.
void multiply(const double* a, const double* b, double* c, std::size_t rows, std::size_t inner,
              std::size_t cols);

// y = a x, where a is rows x cols.
void multiply_vector(const double* a, const double* x, double* y, std::size_t rows,
                     std::size_t cols);

}  // namespace armlet
