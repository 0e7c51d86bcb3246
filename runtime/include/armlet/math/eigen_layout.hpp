#pragma once
// Stops the compiler where types of Eigen would have another layout than in the library.
//
// Headers of the runtime keep and pass types of Eigen, whose alignment follows from the flags of
// the compiler. A host that passes such a struct to the library would be read wrongly, without a
// word: sizeof(Event) would be 496 with SSE, 544 with -mavx and 704 with -mavx512f instead of 456.

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
