#pragma once
// Stops the compilation if types of Eigen would have another memory layout than in the library.
//
// Headers of the runtime contain types of Eigen, whose alignment depends on compiler flags. If a
// host with other flags passed such a struct to the library, its members would be read at wrong
// addresses without any error: sizeof(Event) is 496 with SSE, 544 with -mavx and 704 with -mavx512f
// instead of 456.

#include <Eigen/Core>
#include <cstddef>

#if EIGEN_MAX_STATIC_ALIGN_BYTES != 0 || \
    (EIGEN_MAX_ALIGN_BYTES != 0 && !EIGEN_MALLOC_ALREADY_ALIGNED)
#error \
    "Armlet was compiled with EIGEN_DONT_VECTORIZE, and every source that includes its headers must be: \
link armlet::runtime or armlet::stdlib with CMake, which says so, or add -DEIGEN_DONT_VECTORIZE"
#endif

static_assert(sizeof(Eigen::Index) == sizeof(std::ptrdiff_t) && !Eigen::Matrix2d::IsRowMajor,
              "Armlet was compiled without EIGEN_DEFAULT_DENSE_INDEX_TYPE and "
              "EIGEN_DEFAULT_TO_ROW_MAJOR; leave them out");
