#include "missing_sorting.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace std {
namespace ranges {
namespace missing {

namespace {

using Less = bool (*)(const void* row, uint32_t a, uint32_t b);
constexpr uint32_t kFew = 12;

// Sorts numbers of elements by insertion.
void insert_each(const void* row, Less less, uint32_t* begin, uint32_t* end) {
  for (uint32_t* next = begin + 1; next < end; ++next) {
    const uint32_t taken = *next;
    uint32_t* place = next;
    for (; place > begin && less(row, taken, place[-1]); --place) *place = place[-1];
    *place = taken;
  }
}

// Merges [begin, middle) and [middle, end), both in order, through `other`.
void merge_halves(const void* row, Less less, uint32_t* begin, uint32_t* middle, uint32_t* end,
                  uint32_t* other) {
  if (!less(row, *middle, middle[-1])) return;
  uint32_t* const first_end = std::copy(begin, middle, other);
  uint32_t* out = begin;
  for (uint32_t* first = other; first < first_end;)
    *out++ = middle < end && less(row, *middle, *first) ? *middle++ : *first++;
}

void sort_numbers(const void* row, Less less, uint32_t* begin, uint32_t* end, uint32_t* other) {
  if (end - begin <= kFew) return insert_each(row, less, begin, end);
  uint32_t* const middle = begin + (end - begin) / 2;
  sort_numbers(row, less, begin, middle, other);
  sort_numbers(row, less, middle, end, other);
  merge_halves(row, less, begin, middle, end, other);
}

}  // namespace

void sort_row(const void* row, uint32_t count, const Sorted& sorted) {
  if (count < 2) return;
  uint32_t few[kFew];
  vector<uint32_t> many(count > kFew ? count + count / 2 : 0);
  uint32_t* const order = count > kFew ? many.data() : few;
  std::iota(order, order + count, 0U);
  sort_numbers(row, sorted.less, order, order + count, order + count);
  // The element for index i has been swapped away if its number is below i. It is now at the old
  // index of its replacement, which `order` holds for the finished indexes.
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t from = order[i];
    while (from < i) from = order[from];
    order[i] = from;
    if (from != i) sorted.swap(row, i, from);
  }
}

}  // namespace missing
}  // namespace ranges
}  // namespace std
