#pragma once
#pragma GCC system_header
// Sorting for a C++ library without the algorithms of ranges. It is one function for elements of
// all types, which knows them by their numbers; a sort for each type takes 2 kB of code.

#include <cstdint>
#include <iterator>
#include <utility>

namespace std {
namespace ranges {
namespace missing {

// What a sort asks of a row of elements.
struct Sorted {
  bool (*less)(const void* row, uint32_t a, uint32_t b);
  void (*swap)(const void* row, uint32_t a, uint32_t b);
};

// Puts `count` elements in order and leaves those that are alike as they stand.
void sort_row(const void* row, uint32_t count, const Sorted& sorted);

template <class It, class Less>
struct SortedRow {
  It begin;
  Less& less;

  static const SortedRow& of(const void* row) { return *static_cast<const SortedRow*>(row); }
  static constexpr Sorted kSorted = {[](const void* row, uint32_t a, uint32_t b) -> bool {
                                       return of(row).less(of(row).begin[a], of(row).begin[b]);
                                     },
                                     [](const void* row, uint32_t a, uint32_t b) {
                                       std::iter_swap(of(row).begin + a, of(row).begin + b);
                                     }};
};

template <class It, class Less>
void sort(It begin, It end, Less less) {
  using Row = SortedRow<It, Less>;
  const Row row{begin, less};
  sort_row(&row, static_cast<uint32_t>(end - begin), Row::kSorted);
}

}  // namespace missing
}  // namespace ranges
}  // namespace std
