// Lists of numbers as vectors, and what else lists can do (language reference, sections 8
// and 19.2).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bind.hpp"
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
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(count), false);
  if (list == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < list->size; ++i)
    list->data[i].i = first + static_cast<std::int64_t>(i) * step;
  return give(args, list);
}
Signal range_to(Vm& vm, Slot* args) { return make_range(vm, args, 0, args[0].i, 1); }
Signal range_between(Vm& vm, Slot* args) {
  return make_range(vm, args, args[0].i, args[1].i, args[2].i);
}

Signal linspace(Vm& vm, Slot* args) {
  const double a = args[0].d;
  const double b = args[1].d;
  const std::int64_t n = args[2].i;
  if (n < 2 || n > kLongestRange)
    return failure(vm, "R0609", fmt::format("linspace with {} values: it needs at least 2", n), 2);
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(n), false);
  if (list == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < list->size; ++i) {
    list->data[i].d =
        i + 1 == list->size ? b : a + (b - a) * static_cast<double>(i) / static_cast<double>(n - 1);
  }
  return give(args, list);
}

template <int kValue>
Signal filled(Vm& vm, Slot* args) {
  const std::int64_t n = args[0].i;
  if (n < 0 || n > kLongestRange)
    return failure(vm, "R0613", fmt::format("a list cannot have {} values", n), 0);
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(n), false);
  if (list == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < list->size; ++i) list->data[i].d = kValue;
  return give(args, list);
}

Signal sum_int(Vm& vm, Slot* args) {
  std::int64_t sum = 0;
  for (const Slot x : items_value(args[0])) {
    if (__builtin_add_overflow(sum, x.i, &sum))
      return failure(vm, "R0610", "the sum is too large for an int", 0);
  }
  return give(args, sum);
}
double total(std::span<const double> xs) {
  double sum = 0.0;
  for (const double x : xs) sum += x;
  return sum;
}
Signal sum_real(Vm&, Slot* args) { return give(args, total(reals_value(args[0]))); }
Signal mean(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  if (xs.empty()) return failure(vm, "R0613", "an empty list has no mean", 0);
  return give(args, total(xs) / static_cast<double>(xs.size()));
}
// The sample deviation: divided by n - 1.
Signal deviation(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  if (xs.size() < 2)
    return failure(
        vm, "R0613",
        fmt::format("the deviation of {} values is not defined; it needs at least 2", xs.size()),
        0);
  const double m = total(xs) / static_cast<double>(xs.size());
  double squares = 0.0;
  for (const double x : xs) squares += (x - m) * (x - m);
  return give(args, std::sqrt(squares / static_cast<double>(xs.size() - 1)));
}
Signal differences(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  ListObj* list = new_list(vm, xs.empty() ? 0 : static_cast<std::uint32_t>(xs.size() - 1), false);
  if (list == nullptr) return Signal::kFail;
  for (std::uint32_t i = 0; i < list->size; ++i) list->data[i].d = xs[i + 1] - xs[i];
  return give(args, list);
}
Signal trapezoids(Vm& vm, Slot* args) {
  const auto y = reals_value(args[0]);
  const auto x = reals_value(args[1]);
  if (y.size() != x.size()) return size_failure(vm, "trapz", y.size(), x.size());
  double area = 0.0;
  for (std::size_t i = 1; i < y.size(); ++i) area += 0.5 * (y[i] + y[i - 1]) * (x[i] - x[i - 1]);
  return give(args, area);
}

Signal dot(Vm& vm, Slot* args) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != b.size()) return size_failure(vm, "dot", a.size(), b.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return give(args, sum);
}
Signal cross(Vm& vm, Slot* args) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != 3 || b.size() != 3)
    return size_failure(vm, "cross needs two lists of 3 values", a.size(), b.size());
  const std::array<double, 3> c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                   a[0] * b[1] - a[1] * b[0]};
  return give(args, new_reals(vm, c));
}
Signal norm(Vm&, Slot* args) { return give(args, length_of(reals_value(args[0]))); }

// ---- element by element
// ----------------------------------------------------------------------------------------

template <class F>
Signal zip_reals(Vm& vm, Slot* args, std::string_view what, F f) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != b.size()) return size_failure(vm, what, a.size(), b.size());
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(a.size()), false);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < a.size(); ++i) list->data[i].d = f(a[i], b[i]);
  return give(args, list);
}
template <class F>
Signal map_reals(Vm& vm, Slot* args, std::span<const double> xs, F f) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), false);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < xs.size(); ++i) list->data[i].d = f(xs[i]);
  return give(args, list);
}
Signal add(Vm& vm, Slot* args) {
  return zip_reals(vm, args, "adding lists", [](double a, double b) { return a + b; });
}
Signal subtract(Vm& vm, Slot* args) {
  return zip_reals(vm, args, "subtracting lists", [](double a, double b) { return a - b; });
}
Signal times_elements(Vm& vm, Slot* args) {
  return zip_reals(vm, args, "multiplying element by element",
                   [](double a, double b) { return a * b; });
}
Signal over_elements(Vm& vm, Slot* args) {
  return zip_reals(vm, args, "dividing element by element",
                   [](double a, double b) { return a / b; });
}
Signal list_times(Vm& vm, Slot* args) {
  const double k = args[1].d;
  return map_reals(vm, args, reals_value(args[0]), [k](double x) { return x * k; });
}
Signal times_list(Vm& vm, Slot* args) {
  const double k = args[0].d;
  return map_reals(vm, args, reals_value(args[1]), [k](double x) { return k * x; });
}
Signal list_over(Vm& vm, Slot* args) {
  const double k = args[1].d;
  return map_reals(vm, args, reals_value(args[0]), [k](double x) { return x / k; });
}
Signal negate(Vm& vm, Slot* args) {
  return map_reals(vm, args, reals_value(args[0]), [](double x) { return -x; });
}

template <char kOperator>
Signal zip_ints(Vm& vm, Slot* args) {
  const auto a = items_value(args[0]);
  const auto b = items_value(args[1]);
  if (a.size() != b.size()) return size_failure(vm, "lists of int", a.size(), b.size());
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(a.size()), false);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::int64_t& out = list->data[i].i;
    const bool overflow = kOperator == '+'   ? __builtin_add_overflow(a[i].i, b[i].i, &out)
                          : kOperator == '-' ? __builtin_sub_overflow(a[i].i, b[i].i, &out)
                                             : __builtin_mul_overflow(a[i].i, b[i].i, &out);
    if (overflow) {
      release(vm, list);
      return failure(vm, "R0610", fmt::format("element {} is too large for an int", i));
    }
  }
  return give(args, list);
}

// ---- order and search
// ------------------------------------------------------------------------------------------

Signal sort_int(Vm& vm, Slot* args) {
  const auto xs = items_value(args[0]);
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), false);
  if (list == nullptr) return Signal::kFail;
  std::copy(xs.begin(), xs.end(), list->data);
  std::sort(list->data, list->data + list->size, [](Slot a, Slot b) { return a.i < b.i; });
  return give(args, list);
}
Signal sort_real(Vm& vm, Slot* args) {
  const auto xs = reals_value(args[0]);
  for (const double x : xs) {
    if (std::isnan(x)) return not_finite(vm, "a value of the list to sort", x, 0);
  }
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), false);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < xs.size(); ++i) list->data[i].d = xs[i];
  std::stable_sort(list->data, list->data + list->size, [](Slot a, Slot b) { return a.d < b.d; });
  return give(args, list);
}
ListObj* shared_copy(Vm& vm, std::vector<Slot> items) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(items.size()), true);
  if (list == nullptr) return nullptr;
  for (std::size_t i = 0; i < items.size(); ++i) {
    retain(items[i].o);
    list->data[i] = items[i];
  }
  return list;
}
Signal sort_text(Vm& vm, Slot* args) {
  const auto xs = items_value(args[0]);
  std::vector<Slot> sorted(xs.begin(), xs.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](Slot a, Slot b) { return text_value(a) < text_value(b); });
  return give(args, shared_copy(vm, std::move(sorted)));
}
Signal reverse(Vm& vm, Slot* args) {
  const auto xs = items_value(args[0]);
  const bool references = static_cast<const ListObj*>(args[0].o)->holds_references();
  std::vector<Slot> items(xs.rbegin(), xs.rend());
  if (references) return give(args, shared_copy(vm, std::move(items)));
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(items.size()), false);
  if (list == nullptr) return Signal::kFail;
  std::copy(items.begin(), items.end(), list->data);
  return give(args, list);
}

std::int64_t find_int(Slot list, Slot x) {
  const auto xs = items_value(list);
  const auto it = std::find_if(xs.begin(), xs.end(), [x](Slot y) { return y.i == x.i; });
  return it == xs.end() ? -1 : it - xs.begin();
}
std::int64_t find_real(Slot list, Slot x) {
  const auto xs = items_value(list);
  const auto it = std::find_if(xs.begin(), xs.end(), [x](Slot y) { return y.d == x.d; });
  return it == xs.end() ? -1 : it - xs.begin();
}
std::int64_t find_text(Slot list, Slot x) {
  const auto xs = items_value(list);
  const auto it =
      std::find_if(xs.begin(), xs.end(), [x](Slot y) { return text_value(y) == text_value(x); });
  return it == xs.end() ? -1 : it - xs.begin();
}
template <std::int64_t (*kFind)(Slot, Slot)>
Signal index_of(Vm&, Slot* args) {
  return give(args, kFind(args[0], args[1]));
}
template <std::int64_t (*kFind)(Slot, Slot)>
Signal contains(Vm&, Slot* args) {
  return give(args, kFind(args[0], args[1]) >= 0);
}

constexpr NativeFunction kFunctions[] = {
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
    {"dot", "(a: D[], b: E[]) -> D*E", "The inner product.", "dot([1.0, 2.0], [3.0, 4.0])", dot},
    {"cross", "(a: D[], b: E[]) -> (D*E)[]", "The vector product of two lists of three.",
     "cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])", cross},
    {"norm", "(v: D[]) -> D", "The length of a vector.", "norm([3mm, 4mm])", norm},
    {"operator+", "(a: int[], b: int[]) -> int[]", "Adds element by element.", "[1, 2] + [3, 4]",
     zip_ints<'+'>},
    {"operator-", "(a: int[], b: int[]) -> int[]", "Subtracts element by element.",
     "[1, 2] - [3, 4]", zip_ints<'-'>},
    {"operator.*", "(a: int[], b: int[]) -> int[]", "Multiplies element by element.",
     "[1, 2] .* [3, 4]", zip_ints<'*'>},
    {"operator+", "(a: D[], b: D[]) -> D[]", "Adds element by element.", "[1.0, 2.0] + [3.0, 4.0]",
     add},
    {"operator-", "(a: D[], b: D[]) -> D[]", "Subtracts element by element.",
     "[1.0, 2.0] - [3.0, 4.0]", subtract},
    {"operator.*", "(a: D[], b: E[]) -> (D*E)[]", "Multiplies element by element.",
     "[1.0, 2.0] .* [3.0, 4.0]", times_elements},
    {"operator./", "(a: D[], b: E[]) -> (D/E)[]", "Divides element by element.",
     "[1.0, 2.0] ./ [3.0, 4.0]", over_elements},
    {"operator*", "(a: D[], k: E) -> (D*E)[]", "Every element times a number.", "[1.0, 2.0] * 3.0",
     list_times},
    {"operator*", "(k: D, a: E[]) -> (D*E)[]", "Every element times a number.", "3.0 * [1.0, 2.0]",
     times_list},
    {"operator/", "(a: D[], k: E) -> (D/E)[]", "Every element divided by a number.",
     "[1.0, 2.0] / 2.0", list_over},
    {"operator-", "(a: D[]) -> D[]", "Every element with the other sign.", "-[1.0, 2.0]", negate},
    {"sort", "(xs: int[]) -> int[]", "A new list in ascending order.", "sort([3, 1, 2])", sort_int},
    {"sort", "(xs: D[]) -> D[]", "A new list in ascending order.", "sort([3mm, 1mm])", sort_real},
    {"sort", "(xs: string[]) -> string[]", "A new list in the order of the letters.",
     "sort([\"b\", \"a\"])", sort_text},
    {"reverse", "(xs: T[]) -> T[]", "A new list in the opposite order.", "reverse([1, 2, 3])",
     reverse},
    {"contains", "(xs: int[], x: int) -> bool", "Whether x is in the list.", "contains([1, 2], 2)",
     contains<find_int>},
    {"contains", "(xs: D[], x: D) -> bool", "Whether x is in the list.",
     "contains([1.0, 2.0], 2.0)", contains<find_real>},
    {"contains", "(xs: string[], x: string) -> bool", "Whether x is in the list.",
     "contains([\"a\"], \"a\")", contains<find_text>},
    {"indexOf", "(xs: int[], x: int) -> int", "Where x stands in the list; -1 if it does not.",
     "indexOf([1, 2], 2)", index_of<find_int>},
    {"indexOf", "(xs: D[], x: D) -> int", "Where x stands in the list; -1 if it does not.",
     "indexOf([1.0, 2.0], 2.0)", index_of<find_real>},
    {"indexOf", "(xs: string[], x: string) -> int",
     "Where x stands in the list; -1 if it does not.", "indexOf([\"a\"], \"a\")",
     index_of<find_text>},
};

}  // namespace

std::span<const NativeFunction> list_functions() { return kFunctions; }

}  // namespace armlet::bind
