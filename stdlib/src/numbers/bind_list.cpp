// Lists: construction, statistics, order, and functions applied to every element (language
// reference, section 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "armlet/interpreter/sorting.hpp"
#include "armlet/interpreter/work.hpp"
#include "rules/matrix_rules.hpp"
#include "values/bind.hpp"
#include "values/blocks.hpp"
#include "values/matrices.hpp"

namespace armlet::bind {
namespace {

constexpr std::int64_t kLongestRange = 100'000'000;

Answer<ListObj*> range(Vm& vm, std::int64_t first, std::int64_t last, std::int64_t step) {
  if (step == 0) return failure(vm, "R0609", "range with a step of 0 never ends", at("step"));
  __extension__ using Wide = __int128;
  const Wide distance = step > 0 ? Wide{last} - first : Wide{first} - last;
  const Wide stride = step > 0 ? Wide{step} : -Wide{step};
  const Wide count = distance > 0 ? (distance + stride - 1) / stride : Wide{0};
  if (count > kLongestRange)
    return failure(vm, "R0613",
                   fmt::format("range would have more than {} numbers", kLongestRange));
  return numbers_of(vm, static_cast<std::size_t>(count), [=](Slot& to, std::size_t i) {
    to.i = first + static_cast<std::int64_t>(i) * step;
  });
}
// A value that is this close to the end of a range, in steps, is the end.
constexpr double kEndOfRange = 1e-9;

// Each value is computed from its index, since repeated addition would accumulate errors.
Answer<ListObj*> range_of_quantities(Vm& vm, double first, double last, double step) {
  for (const double given : {first, last, step}) {
    if (!std::isfinite(given)) return not_finite(vm, "a value given to range", given, at("a"));
  }
  if (step == 0.0) return failure(vm, "R0609", "range with a step of 0 never ends", at("step"));
  const double steps = (last - first) / step;
  if (!(steps <= static_cast<double>(kLongestRange)))
    return failure(vm, "R0613",
                   fmt::format("range would have more than {} numbers", kLongestRange));
  const double count = std::max(0.0, std::ceil(steps - kEndOfRange));
  return numbers_of(vm, static_cast<std::size_t>(count),
                    [=](Slot& to, std::size_t i) { to.d = first + static_cast<double>(i) * step; });
}
Answer<ListObj*> range_to(Vm& vm, std::int64_t last) { return range(vm, 0, last, 1); }

Answer<ListObj*> linspace(Vm& vm, double a, double b, std::int64_t n) {
  for (const double end : {a, b}) {
    if (!std::isfinite(end))
      return not_finite(vm, "an end given to linspace", end, std::isfinite(a) ? at("b") : at("a"));
  }
  if (n < 2)
    return failure(vm, "R0609", fmt::format("linspace with {} values: it needs at least 2", n),
                   at("n"));
  if (n > kLongestRange) {
    return failure(vm, "R0609",
                   fmt::format("linspace with {} values: a list has at most {}", n, kLongestRange),
                   at("n"));
  }
  const auto last = static_cast<std::size_t>(n - 1);
  return numbers_of(vm, last + 1, [=](Slot& to, std::size_t i) {
    to.d = i == last ? b : a + (b - a) * static_cast<double>(i) / static_cast<double>(last);
  });
}

template <int kValue>
Answer<ListObj*> filled_list(Vm& vm, std::int64_t n) {
  if (n < 0 || n > kLongestRange)
    return failure(vm, "R0613", fmt::format("a list cannot have {} values", n), at("n"));
  return numbers_of(vm, static_cast<std::size_t>(n), [](Slot& to, std::size_t) { to.d = kValue; });
}

Answer<std::int64_t> sum_int(Vm& vm, std::span<const Slot> xs) {
  std::int64_t sum = 0;
  bool fits = true;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && fits; ++i)
      fits = !__builtin_add_overflow(sum, xs[i].i, &sum);
    return fits;
  };
  if (in_blocks(vm, xs.size(), kCost, add)) return sum;
  return fits ? Failed{} : failure(vm, "R0610", "the sum is too large for an int", at("xs"));
}
// The sum of f(i) in the order of i.
template <class F>
Answer<double> add_up(Vm& vm, std::size_t count, F f) {
  double sum = 0.0;
  const bool done = in_blocks(vm, count, kCost, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sum += f(i);
  });
  if (!done) return Failed{};
  return sum;
}
Answer<double> total(Vm& vm, std::span<const double> xs) {
  return add_up(vm, xs.size(), [xs](std::size_t i) { return xs[i]; });
}
// The result if it is defined; otherwise a failure that names the first element that is not finite.
Answer<double> defined(Vm& vm, Answer<double> result, std::span<const double> xs,
                       std::string_view what) {
  if (!result || !std::isnan(*result)) return result;
  std::size_t bad = xs.size();
  if (!find_number(vm, xs, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad == xs.size()) return not_finite(vm, what, *result, CallPart::first());
  return not_finite(vm, fmt::format("element {} of the list", bad), xs[bad], CallPart::first());
}
Answer<double> sum_real(Vm& vm, std::span<const double> xs) {
  return defined(vm, total(vm, xs), xs, "the sum");
}
Answer<double> mean(Vm& vm, std::span<const double> xs) {
  if (xs.empty()) return failure(vm, "R0613", "an empty list has no mean", at("xs"));
  const Answer<double> sum = total(vm, xs);
  if (!sum) return Failed{};
  return defined(vm, *sum / static_cast<double>(xs.size()), xs, "the mean");
}
// The sample standard deviation: divided by n - 1.
Answer<double> deviation(Vm& vm, std::span<const double> xs) {
  if (xs.size() < 2)
    return failure(
        vm, "R0613",
        fmt::format("the deviation of {} values is not defined; it needs at least 2", xs.size()),
        at("xs"));
  const Answer<double> sum = total(vm, xs);
  if (!sum) return Failed{};
  const double m = *sum / static_cast<double>(xs.size());
  const Answer<double> squares =
      add_up(vm, xs.size(), [&](std::size_t i) { return (xs[i] - m) * (xs[i] - m); });
  if (!squares) return Failed{};
  return defined(vm, std::sqrt(*squares / static_cast<double>(xs.size() - 1)), xs, "the deviation");
}
// The middle element in order, or the mean of the two in the middle.
Answer<double> median(Vm& vm, std::span<const double> xs) {
  if (xs.empty()) return failure(vm, "R0613", "an empty list has no median", at("xs"));
  std::size_t bad = xs.size();
  if (!find_number(vm, xs, bad, [](double x) { return std::isnan(x); })) return Failed{};
  if (bad != xs.size())
    return not_finite(vm, fmt::format("element {} of the list", bad), xs[bad], at("xs"));
  const Scratch scratch(vm, 2 * xs.size() * sizeof(double));
  if (!scratch.granted() || !charge_work(vm, kCost * xs.size())) return Failed{};
  std::vector<double> sorted(xs.begin(), xs.end());
  std::vector<double> room(xs.size());
  std::less<double> order;
  if (!sort_stably(vm, std::span(sorted), std::span(room), order)) return Failed{};
  const double above = sorted[xs.size() / 2];
  const double below = sorted[(xs.size() - 1) / 2];
  if (above == below) return above;
  const double middle = below + 0.5 * (above - below);
  return defined(vm, std::isfinite(middle) ? middle : 0.5 * below + 0.5 * above, xs, "the median");
}

// The cumulative sums.
Answer<ListObj*> running_sums(Vm& vm, std::span<const double> xs) {
  double sum = 0.0;
  ListObj* sums = numbers_of(vm, xs.size(), [&](Slot& to, std::size_t i) { to.d = sum += xs[i]; });
  if (sums == nullptr || defined(vm, sum, xs, "the sum")) return sums;
  release(vm, sums);
  return Failed{};
}
Answer<ListObj*> running_sums_int(Vm& vm, std::span<const Slot> xs) {
  std::int64_t sum = 0;
  std::size_t overflow = xs.size();
  ListObj* sums = numbers_of(vm, xs.size(), [&](Slot& to, std::size_t i) {
    if (__builtin_add_overflow(sum, xs[i].i, &sum)) overflow = std::min(overflow, i);
    to.i = sum;
  });
  if (sums == nullptr || overflow == xs.size()) return sums;
  release(vm, sums);
  return failure(vm, "R0610",
                 fmt::format("the sum up to element {} is too large for an int", overflow),
                 at("xs"));
}

ListObj* differences(Vm& vm, std::span<const double> xs) {
  return numbers_of(vm, xs.empty() ? 0 : xs.size() - 1,
                    [xs](Slot& to, std::size_t i) { to.d = xs[i + 1] - xs[i]; });
}
Answer<double> trapezoids(Vm& vm, std::span<const double> y, std::span<const double> x) {
  if (y.size() != x.size()) return size_failure(vm, "trapz", y.size(), x.size());
  const auto strip = [&](std::size_t i) { return 0.5 * (y[i + 1] + y[i]) * (x[i + 1] - x[i]); };
  return defined(vm, add_up(vm, y.empty() ? 0 : y.size() - 1, strip), y, "the area");
}

// ---- order and search ---------------------------------------------------------------------------

// Ints and doubles: equal elements cannot be distinguished, so the sort need not be stable.
ListObj* sort_int(Vm& vm, const ListObj& xs, bool descending) {
  const auto less = [](Slot a, Slot b) { return a.i < b.i; };
  return sorted_list(vm, xs, InDirection(less, descending));
}
Answer<ListObj*> sort_real(Vm& vm, const ListObj& list, bool descending) {
  const auto xs = list.reals();
  std::size_t bad = xs.size();
  if (!find_number(vm, xs, bad, [](double x) { return std::isnan(x); })) return Failed{};
  if (bad != xs.size()) return not_finite(vm, "a value of the list to sort", xs[bad], at("xs"));
  const auto less = [](Slot a, Slot b) { return a.d < b.d; };
  return sorted_list(vm, list, InDirection(less, descending));
}
ListObj* sort_text(Vm& vm, const ListObj& xs, bool descending) {
  return sorted_list(vm, xs, InDirection(TextOrder(vm), descending), TextOrder::kCost);
}
ListObj* reverse(Vm& vm, const ListObj& xs) {
  return list_of(vm, xs.size, xs.holds_references(),
                 [&xs](Slot& to, std::size_t i) { to = xs.data[xs.size - 1 - i]; });
}

constexpr NativeFunction kListFunctions[] = {
    def<range_to>("range(b: int) -> int[]", "The whole numbers from 0 up to but excluding b.",
                  "range(3)"),
    def<range>("range(a: int, b: int, step: int = 1) -> int[]",
               "The whole numbers from a up to but excluding b.", "range(2, 8, 2)"),
    def<range_of_quantities>("range(a: D, b: D, step: D) -> D[]",
                             "a, a + step, a + 2 step and so on, up to but excluding b; what is "
                             "within a billionth of a step counts as b.",
                             "range(0mm, 100mm, 20mm)"),
    def<linspace>("linspace(a: D, b: D, n: int) -> D[]", "n evenly spaced values from a to b.",
                  "linspace(0s, 2s, 5)"),
    def<filled_list<0>>("zeros(n: int) -> double[]", "A list of n zeros.", "zeros(3)",
                        {.check = check_filled_list}),
    def<filled_list<1>>("ones(n: int) -> double[]", "A list of n ones.", "ones(3)",
                        {.check = check_filled_list}),
    def<sum_int>("sum(xs: int[]) -> int", "The sum of a list.", "sum([1, 2, 3])"),
    def<sum_real>("sum(xs: D[]) -> D", "The sum of a list.", "sum([1mm, 2mm])"),
    def<mean>("mean(xs: D[]) -> D", "The mean of a list.", "mean([1.0, 2.0])"),
    def<deviation>("std(xs: D[]) -> D", "The standard deviation of a sample.",
                   "std([1.0, 2.0, 4.0])"),
    def<median>(
        "median(xs: D[]) -> D",
        "The value in the middle of the list in order; of an even number, the mean of the two.",
        "median([3.0, 1.0, 10.0])"),
    def<running_sums_int>("cumsum(xs: int[]) -> int[]", "The sums of the elements up to each.",
                          "cumsum([1, 2, 3])"),
    def<running_sums>("cumsum(xs: D[]) -> D[]", "The sums of the elements up to each.",
                      "cumsum([1mm, 2mm])"),
    def<differences>("diff(xs: D[]) -> D[]", "The differences of neighbours.",
                     "diff([1.0, 3.0, 6.0])"),
    def<trapezoids>("trapz(y: D[], x: E[]) -> D*E", "The area under y over x, by trapezoids.",
                    "trapz([1.0, 2.0], [0.0, 1.0])"),
    def<index_of_extreme<false, std::int64_t>>(
        "argmin(xs: int[]) -> int", "Where the smallest element stands for the first time.",
        "argmin([3, 1, 2])"),
    def<index_of_extreme<false, double>>("argmin(xs: D[]) -> int",
                                         "Where the smallest element stands for the first time.",
                                         "argmin([3mm, 1mm])"),
    def<index_of_extreme<true, std::int64_t>>(
        "argmax(xs: int[]) -> int", "Where the largest element stands for the first time.",
        "argmax([3, 1, 2])"),
    def<index_of_extreme<true, double>>("argmax(xs: D[]) -> int",
                                        "Where the largest element stands for the first time.",
                                        "argmax([3mm, 1mm])"),
    def<sort_int>("sort(xs: int[], descending: bool = false) -> int[]",
                  "A new list in ascending order, or in descending order.", "sort([3, 1, 2])"),
    def<sort_real>("sort(xs: D[], descending: bool = false) -> D[]",
                   "A new list in ascending order, or in descending order.",
                   "sort([3mm, 1mm], descending: true)"),
    def<sort_text>("sort(xs: string[], descending: bool = false) -> string[]",
                   "A new list in the order of the letters, or in the opposite one.",
                   "sort([\"b\", \"a\"])"),
    def<reverse>("reverse(xs: T[]) -> T[]", "A new list in the opposite order.",
                 "reverse([1, 2, 3])"),
    declare("contains(xs: T[], x: T) -> bool", "Whether x is in the list.", "contains([1, 2], 2)"),
    declare("indexOf(xs: T[], x: T) -> int",
            "Where x stands in the list for the first time; -1 if it does not.",
            "indexOf([1, 2], 2)"),
    declare("map(xs: T[], f: fn(T) -> U) -> U[]", "What f gives for each element.",
            "[1, 2, 3].map(fn(x) => x^2)"),
    declare("filter(xs: T[], f: fn(T) -> bool) -> T[]", "The elements for which f is true.",
            "[1, 2, 3].filter(fn(x) => x > 1)"),
    declare("fold(xs: T[], start: U, f: fn(U, T) -> U) -> U",
            "Everything in one: f(f(f(start, xs[0]), xs[1]), xs[2]) ...",
            "[1, 2, 3].fold(1, fn(product, x) => product * x)"),
    declare("any(xs: T[], f: fn(T) -> bool) -> bool",
            "Whether f is true for some element; looks no further than the first one.",
            "[1, 2, 3].any(fn(x) => x > 2)"),
    declare("all(xs: T[], f: fn(T) -> bool) -> bool",
            "Whether f is true for every element; looks no further than the first that is not.",
            "[1, 2, 3].all(fn(x) => x > 0)"),
    declare(
        "sort(xs: T[], by: fn(T) -> U, descending: bool = false) -> T[]",
        "A new list in ascending order of what `by` gives, a number or a text, or in descending "
        "order; equals keep their order.",
        "[\"ccc\", \"a\", \"bb\"].sort(by: fn(s) => s.length)"),
    declare("zip(xs: T[], ys: U[]) -> Pair{first: T, second: U}[]",
            "The elements of two lists of one length side by side.",
            "zip([1, 2], [\"a\", \"b\"])[0].second"),
};

}  // namespace

std::span<const NativeFunction> list_functions() { return kListFunctions; }

}  // namespace armlet::bind
