#pragma once

#include <cstddef>

namespace armlet {

// Products of matrices that lie row by row in memory.
//
// Every element is the sum of its products from the first to the last, each rounded, beginning
// with 0: the same bits on every machine, however many elements are worked on at once.
// The result may not overlap the factors. Nothing is checked and nothing is thrown.

// c = a b, where a is rows x inner and b is inner x cols.
void multiply(const double* a, const double* b, double* c, std::size_t rows, std::size_t inner,
              std::size_t cols);

// y = a x, where a is rows x cols.
void multiply_vector(const double* a, const double* x, double* y, std::size_t rows,
                     std::size_t cols);

}  // namespace armlet
