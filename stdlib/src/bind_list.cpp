// Lists: making, statistics, order, and the functions that visit every element (language reference,
// section 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/interpreter/sorting.hpp"
#include "armlet/interpreter/work.hpp"
#include "bind.hpp"
#include "blocks.hpp"
#include "matrices.hpp"

namespace armlet::bind {
namespace {

constexpr std::int64_t kLongestRange = 100'000'000;

Signal make_range(Vm& vm, Slot* args, std::int64_t first, std::int64_t last, std::int64_t step) {
  if (step == 0) return failure(vm, "R0609", "range with a step of 0 never ends", 2);
  __extension__ using Wide = __int128;
  const Wide distance = step > 0 ? Wide{last} - first : Wide{first} - last;
  const Wide stride = step > 0 ? Wide{step} : -Wide{step};
  const Wide count = distance > 0 ? (distance + stride - 1) / stride : Wide{0};
  if (count > kLongestRange)
    return failure(vm, "R0613",
                   fmt::format("range would have more than {} numbers", kLongestRange));
  return give_numbers(vm, args, static_cast<std::size_t>(count), [=](Slot& to, std::size_t i) {
    to.i = first + static_cast<std::int64_t>(i) * step;
  });
}
Signal range_to(Vm& vm, Slot* args) { return make_range(vm, args, 0, args[0].i, 1); }
Signal range_between(Vm& vm, Slot* args) {
  return make_range(vm, args, args[0].i, args[1].i, args[2].i);
}

Signal linspace(Vm& vm, Slot* args) {
  const double a = args[0].d;
  const double b = args[1].d;
  const std::int64_t n = args[2].i;
  for (int i = 0; i < 2; ++i) {
    if (!std::isfinite(args[i].d)) return not_finite(vm, "an end given to linspace", args[i].d, i);
  }
  if (n < 2)
    return failure(vm, "R0609", fmt::format("linspace with {} values: it needs at least 2", n), 2);
  if (n > kLongestRange) {
    return failure(vm, "R0609",
                   fmt::format("linspace with {} values: a list has at most {}", n, kLongestRange),
                   2);
  }
  const auto last = static_cast<std::size_t>(n - 1);
  return give_numbers(vm, args, last + 1, [=](Slot& to, std::size_t i) {
    to.d = i == last ? b : a + (b - a) * static_cast<double>(i) / static_cast<double>(last);
  });
}

template <int kValue>
Signal filled(Vm& vm, Slot* args) {
  const std::int64_t n = args[0].i;
  if (n < 0 || n > kLongestRange)
    return failure(vm, "R0613", fmt::format("a list cannot have {} values", n), 0);
  return give_numbers(vm, args, static_cast<std::size_t>(n),
                      [](Slot& to, std::size_t) { to.d = kValue; });
}

Signal sum_int(Vm& vm, Slot* args) {
  std::int64_t sum = 0;
  bool fits = true;
  const auto xs = items_value(args[0]);
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && fits; ++i)
      fits = !__builtin_add_overflow(sum, xs[i].i, &sum);
    return fits;
  };
  if (in_blocks(vm, xs.size(), kCost, add)) return give(args, sum);
  return fits ? Signal::kFail : failure(vm, "R0610", "the sum is too large for an int", 0);
}
// The sum of f(i) in the order of i. False: the failure is set.
template <class F>
bool add_up(Vm& vm, std::size_t count, double& sum, F f) {
  sum = 0.0;
  return in_blocks(vm, count, kCost, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sum += f(i);
  });
}
bool total(Vm& vm, std::span<const double> xs, double& sum) {
  return add_up(vm, xs.size(), sum, [xs](std::size_t i) { return xs[i]; });
}
// The result, unless it is undefined: then the first element that is not finite is to blame.
Signal give_defined(Vm& vm, Slot* args, double result, std::string_view what) {
  if (!std::isnan(result)) return give(args, result);
  const auto xs = reals_value(args[0]);
  std::size_t bad = xs.size();
  if (!find_number(vm, xs, bad, [](double x) { return !std::isfinite(x); })) return Signal::kFail;
  if (bad == xs.size()) return not_finite(vm, what, result, 0);
  return not_finite(vm, fmt::format("element {} of the list", bad), xs[bad], 0);
}
Signal sum_real(Vm& vm, Slot* args) {
  double sum = 0.0;
  if (!total(vm, reals_value(args[0]), sum)) return Signal::kFail;
  return give_defined(vm, args, sum, "the sum");
}
Signal mean(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  if (xs.empty()) return failure(vm, "R0613", "an empty list has no mean", 0);
  double sum = 0.0;
  if (!total(vm, xs, sum)) return Signal::kFail;
  return give_defined(vm, args, sum / static_cast<double>(xs.size()), "the mean");
}
// The sample deviation: divided by n - 1.
Signal deviation(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  if (xs.size() < 2)
    return failure(
        vm, "R0613",
        fmt::format("the deviation of {} values is not defined; it needs at least 2", xs.size()),
        0);
  double sum = 0.0;
  double squares = 0.0;
  if (!total(vm, xs, sum)) return Signal::kFail;
  const double m = sum / static_cast<double>(xs.size());
  const auto square = [&](std::size_t i) { return (xs[i] - m) * (xs[i] - m); };
  if (!add_up(vm, xs.size(), squares, square)) return Signal::kFail;
  return give_defined(vm, args, std::sqrt(squares / static_cast<double>(xs.size() - 1)),
                      "the deviation");
}
Signal differences(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  return give_numbers(vm, args, xs.empty() ? 0 : xs.size() - 1,
                      [xs](Slot& to, std::size_t i) { to.d = xs[i + 1] - xs[i]; });
}
Signal trapezoids(Vm& vm, Slot* args) {
  const auto y = reals_value(args[0]);
  const auto x = reals_value(args[1]);
  if (y.size() != x.size()) return size_failure(vm, "trapz", y.size(), x.size());
  double area = 0.0;
  const auto strip = [&](std::size_t i) { return 0.5 * (y[i + 1] + y[i]) * (x[i + 1] - x[i]); };
  if (!add_up(vm, y.empty() ? 0 : y.size() - 1, area, strip)) return Signal::kFail;
  return give_defined(vm, args, area, "the area");
}

// ---- order and search
// ------------------------------------------------------------------------------------------

// Of these two, equals cannot be told apart.
Signal sort_int(Vm& vm, Slot* args) {
  return give_sorted(vm, args, [](Slot a, Slot b) { return a.i < b.i; });
}
Signal sort_real(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  std::size_t bad = xs.size();
  if (!find_number(vm, xs, bad, [](double x) { return std::isnan(x); })) return Signal::kFail;
  if (bad != xs.size()) return not_finite(vm, "a value of the list to sort", xs[bad], 0);
  return give_sorted(vm, args, [](Slot a, Slot b) { return a.d < b.d; });
}
Signal sort_text(Vm& vm, Slot* args) { return give_sorted(vm, args, TextOrder(vm)); }
Signal reverse(Vm& vm, Slot* args) {
  const auto xs = items_value(args[0]);
  const bool references = static_cast<const ListObj*>(args[0].o)->holds_references();
  return give_items(vm, args, xs.size(), references,
                    [xs](Slot& to, std::size_t i) { to = xs[xs.size() - 1 - i]; });
}

constexpr NativeFunction kListFunctions[] = {
    {"range", "(b: int) -> int[]", "The whole numbers from 0 up to but excluding b.", "range(3)",
     range_to},
    {"range", "(a: int, b: int, step: int = 1) -> int[]",
     "The whole numbers from a up to but excluding b.", "range(2, 8, 2)", range_between},
    {"linspace", "(a: D, b: D, n: int) -> D[]", "n evenly spaced values from a to b.",
     "linspace(0s, 2s, 5)", linspace},
    {"zeros", "(n: int) -> double[]", "A list of n zeros.", "zeros(3)", filled<0>, nullptr, nullptr,
     check_filled_list},
    {"ones", "(n: int) -> double[]", "A list of n ones.", "ones(3)", filled<1>, nullptr, nullptr,
     check_filled_list},
    {"sum", "(xs: int[]) -> int", "The sum of a list.", "sum([1, 2, 3])", sum_int},
    {"sum", "(xs: D[]) -> D", "The sum of a list.", "sum([1mm, 2mm])", sum_real},
    {"mean", "(xs: D[]) -> D", "The mean of a list.", "mean([1.0, 2.0])", mean},
    {"std", "(xs: D[]) -> D", "The standard deviation of a sample.", "std([1.0, 2.0, 4.0])",
     deviation},
    {"diff", "(xs: D[]) -> D[]", "The differences of neighbours.", "diff([1.0, 3.0, 6.0])",
     differences},
    {"trapz", "(y: D[], x: E[]) -> D*E", "The area under y over x, by trapezoids.",
     "trapz([1.0, 2.0], [0.0, 1.0])", trapezoids},
    {"sort", "(xs: int[]) -> int[]", "A new list in ascending order.", "sort([3, 1, 2])", sort_int},
    {"sort", "(xs: D[]) -> D[]", "A new list in ascending order.", "sort([3mm, 1mm])", sort_real},
    {"sort", "(xs: string[]) -> string[]", "A new list in the order of the letters.",
     "sort([\"b\", \"a\"])", sort_text},
    {"reverse", "(xs: T[]) -> T[]", "A new list in the opposite order.", "reverse([1, 2, 3])",
     reverse},
    {"contains", "(xs: T[], x: T) -> bool", "Whether x is in the list.", "contains([1, 2], 2)"},
    {"indexOf", "(xs: T[], x: T) -> int",
     "Where x stands in the list for the first time; -1 if it does not.", "indexOf([1, 2], 2)"},
    {"map", "(xs: T[], f: fn(T) -> U) -> U[]", "What f gives for each element.",
     "[1, 2, 3].map(fn(x) => x^2)"},
    {"filter", "(xs: T[], f: fn(T) -> bool) -> T[]", "The elements for which f is true.",
     "[1, 2, 3].filter(fn(x) => x > 1)"},
    {"fold", "(xs: T[], start: U, f: fn(U, T) -> U) -> U",
     "Everything in one: f(f(f(start, xs[0]), xs[1]), xs[2]) ...",
     "[1, 2, 3].fold(1, fn(product, x) => product * x)"},
    {"any", "(xs: T[], f: fn(T) -> bool) -> bool",
     "Whether f is true for some element; looks no further than the first one.",
     "[1, 2, 3].any(fn(x) => x > 2)"},
    {"all", "(xs: T[], f: fn(T) -> bool) -> bool",
     "Whether f is true for every element; looks no further than the first that is not.",
     "[1, 2, 3].all(fn(x) => x > 0)"},
    {"sort", "(xs: T[], by: fn(T) -> U) -> T[]",
     "A new list in ascending order of what `by` gives, a number or a text; equals keep their "
     "order.",
     "[\"ccc\", \"a\", \"bb\"].sort(by: fn(s) => s.length)"},
    {"zip", "(xs: T[], ys: U[]) -> Pair{first: T, second: U}[]",
     "The elements of two lists of one length side by side.",
     "zip([1, 2], [\"a\", \"b\"])[0].second"},
};

}  // namespace

std::span<const NativeFunction> list_functions() { return kListFunctions; }

}  // namespace armlet::bind
