#pragma once

#include <cstddef>
#include <cstdint>

// The part of SUSAN that is compiled for several instruction sets. Plain data only: the linker
// would keep one copy of an inline function, possibly with instructions that the processor does not
// have.
namespace armlet {

// Similarities of brightnesses, 0 to 100, by absolute difference.
//
// last_alike  the largest difference of similarity 100.
// steps       the entries from last_alike on, up to the first 0; at most 256 - last_alike.
struct SusanTable {
  std::uint8_t similarity[256];
  int last_alike;
  int steps;
};

inline constexpr int kSusanLimit = 1850;  // half of the mask's area, hundredths of a pixel

// Writes for `count` consecutive pixels the areas n in hundredths of a pixel; for areas of at least
// kSusanLimit, any number that is not below it.
//
// nucleus  the first pixel; 3 pixels around all of them are read.
// stride   bytes from row to row.
using SusanRow = void(const std::uint8_t* nucleus, std::ptrdiff_t stride, int count,
                      const SusanTable& table, std::uint16_t* areas);

SusanRow susan_row_scalar;
#if defined(__x86_64__)
SusanRow susan_row_avx2;
#else  // other processors never use it (is_supported)
inline constexpr SusanRow* susan_row_avx2 = susan_row_scalar;
#endif

}  // namespace armlet
