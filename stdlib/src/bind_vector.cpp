// Lists of numbers as vectors (language reference, section 8).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/math/det_math.hpp"
#include "bind.hpp"
#include "blocks.hpp"
#include "matrices.hpp"

namespace armlet::bind {
namespace {

Signal dot(Vm& vm, Slot* args) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != b.size()) return size_failure(vm, "dot", a.size(), b.size());
  double sum = 0.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sum += a[i] * b[i];
  };
  if (!in_blocks(vm, a.size(), kCost, add)) return Signal::kFail;
  if (std::isnan(sum)) return not_finite(vm, "the product", sum, -1);
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
Signal norm(Vm& vm, Slot* args) {
  double length = 0.0;
  if (!length_of(vm, reals_value(args[0]), length)) return Signal::kFail;
  if (std::isnan(length)) return not_finite(vm, "the length of the list", length, 0);
  return give(args, length);
}

// ---- element by element -------------------------------------------------------------------------

template <class F>
Signal zip_reals(Vm& vm, Slot* args, std::string_view what, F f) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != b.size()) return size_failure(vm, what, a.size(), b.size());
  return give_numbers(vm, args, a.size(), [&](Slot& to, std::size_t i) { to.d = f(a[i], b[i]); });
}
template <class F>
Signal map_reals(Vm& vm, Slot* args, std::span<const double> xs, F f) {
  return give_numbers(vm, args, xs.size(), [&](Slot& to, std::size_t i) { to.d = f(xs[i]); });
}
constexpr double plus(double a, double b) { return a + b; }
constexpr double minus(double a, double b) { return a - b; }
constexpr double times(double a, double b) { return a * b; }
constexpr double over(double a, double b) { return a / b; }

using Operation = double (*)(double, double);

template <Operation kOperation>
constexpr std::string_view kDoing = "dividing element by element";
template <>
constexpr std::string_view kDoing<plus> = "adding lists";
template <>
constexpr std::string_view kDoing<minus> = "subtracting lists";
template <>
constexpr std::string_view kDoing<times> = "multiplying element by element";

template <Operation kOperation>
Signal lists(Vm& vm, Slot* args) {
  return zip_reals(vm, args, kDoing<kOperation>, kOperation);
}
template <Operation kOperation>
Signal list_and_number(Vm& vm, Slot* args) {
  const double k = args[1].d;
  return map_reals(vm, args, reals_value(args[0]), [k](double x) { return kOperation(x, k); });
}
template <Operation kOperation>
Signal number_and_list(Vm& vm, Slot* args) {
  const double k = args[0].d;
  return map_reals(vm, args, reals_value(args[1]), [k](double x) { return kOperation(k, x); });
}
Signal negate(Vm& vm, Slot* args) {
  return map_reals(vm, args, reals_value(args[0]), [](double x) { return -x; });
}

// Powers: a negative number has only whole ones.
Signal raise(Vm& vm, Slot* args, std::span<const double> xs, std::span<const double> exponents) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), false);
  if (list == nullptr) return Signal::kFail;
  const auto power_of = [&](std::size_t i) {
    const double n = exponents[exponents.size() == 1 ? 0 : i];
    const double power = det::pow(xs[i], n);
    list->data[i].d = power;
    if (!std::isnan(power) || std::isnan(xs[i]) || std::isnan(n)) return true;
    (void)failure(vm, "R0609",
                  fmt::format("element {} of the list is {:.15g}, and a negative number has no "
                              "power of {:.15g}",
                              i, xs[i], n),
                  0);
    return false;
  };
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!power_of(i)) return false;
    }
    return true;
  };
  if (in_blocks(vm, xs.size(), 2 * kFunctionCost, fill)) return give(args, list);
  release(vm, list);
  return Signal::kFail;
}
Signal raise_lists(Vm& vm, Slot* args) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != b.size()) return size_failure(vm, "powers of lists", a.size(), b.size());
  return raise(vm, args, a, b);
}
Signal raise_list(Vm& vm, Slot* args) {
  const double n = args[1].d;
  return raise(vm, args, reals_value(args[0]), {&n, 1});
}

template <char kOperator>
bool combine(std::int64_t a, std::int64_t b, std::int64_t& out) {
  if (kOperator == '+') return !__builtin_add_overflow(a, b, &out);
  if (kOperator == '-') return !__builtin_sub_overflow(a, b, &out);
  return !__builtin_mul_overflow(a, b, &out);
}
// Two lists, or a list and a number that goes with every element.
template <char kOperator>
Signal whole_numbers(Vm& vm, Slot* args, std::span<const Slot> a, std::span<const Slot> b) {
  const std::size_t size = std::max(a.size(), b.size());
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(size), false);
  if (list == nullptr) return Signal::kFail;
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::int64_t left = a[i < a.size() ? i : 0].i;
      const std::int64_t right = b[i < b.size() ? i : 0].i;
      if (combine<kOperator>(left, right, list->data[i].i)) continue;
      (void)failure(vm, "R0610", fmt::format("element {} is too large for an int", i));
      return false;
    }
    return true;
  };
  if (in_blocks(vm, size, kCost, fill)) return give(args, list);
  release(vm, list);
  return Signal::kFail;
}
template <char kOperator>
Signal int_lists(Vm& vm, Slot* args) {
  const auto a = items_value(args[0]);
  const auto b = items_value(args[1]);
  constexpr std::string_view kWhat = kOperator == '+'   ? "adding lists"
                                     : kOperator == '-' ? "subtracting lists"
                                                        : "multiplying lists";
  if (a.size() != b.size()) return size_failure(vm, kWhat, a.size(), b.size());
  return whole_numbers<kOperator>(vm, args, a, b);
}
template <char kOperator>
Signal ints_and_int(Vm& vm, Slot* args) {
  const auto a = items_value(args[0]);
  const Slot k = args[1];
  return whole_numbers<kOperator>(vm, args, a, std::span(&k, a.empty() ? 0 : 1));
}
template <char kOperator>
Signal int_and_ints(Vm& vm, Slot* args) {
  const Slot k = args[0];
  const auto b = items_value(args[1]);
  return whole_numbers<kOperator>(vm, args, std::span(&k, b.empty() ? 0 : 1), b);
}

constexpr NativeFunction kVectorFunctions[] = {
    {"dot", "(a: D[], b: E[]) -> D*E", "The inner product.", "dot([1.0, 2.0], [3.0, 4.0])", dot},
    {"cross", "(a: D[], b: E[]) -> (D*E)[]", "The vector product of two lists of three.",
     "cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])", cross},
    {"norm", "(v: D[]) -> D", "The length of a vector.", "norm([3mm, 4mm])", norm},
    {"operator+", "(a: int[], b: int[]) -> int[]", "Adds element by element.", "[1, 2] + [3, 4]",
     int_lists<'+'>},
    {"operator-", "(a: int[], b: int[]) -> int[]", "Subtracts element by element.",
     "[1, 2] - [3, 4]", int_lists<'-'>},
    {"operator.*", "(a: int[], b: int[]) -> int[]", "Multiplies element by element.",
     "[1, 2] .* [3, 4]", int_lists<'*'>},
    {"operator+", "(a: int[], k: int) -> int[]", "Every element plus a number.", "[1, 2] + 3",
     ints_and_int<'+'>},
    {"operator-", "(a: int[], k: int) -> int[]", "Every element minus a number.", "[1, 2] - 3",
     ints_and_int<'-'>},
    {"operator.*", "(a: int[], k: int) -> int[]", "Every element times a number.", "[1, 2] .* 3",
     ints_and_int<'*'>},
    {"operator+", "(k: int, a: int[]) -> int[]", "A number plus every element.", "3 + [1, 2]",
     int_and_ints<'+'>},
    {"operator-", "(k: int, a: int[]) -> int[]", "A number minus every element.", "3 - [1, 2]",
     int_and_ints<'-'>},
    {"operator.*", "(k: int, a: int[]) -> int[]", "A number times every element.", "3 .* [1, 2]",
     int_and_ints<'*'>},
    {"operator+", "(a: D[], b: D[]) -> D[]", "Adds element by element.", "[1.0, 2.0] + [3.0, 4.0]",
     lists<plus>},
    {"operator-", "(a: D[], b: D[]) -> D[]", "Subtracts element by element.",
     "[1.0, 2.0] - [3.0, 4.0]", lists<minus>},
    {"operator.*", "(a: D[], b: E[]) -> (D*E)[]", "Multiplies element by element.",
     "[1.0, 2.0] .* [3.0, 4.0]", lists<times>},
    {"operator./", "(a: D[], b: E[]) -> (D/E)[]", "Divides element by element.",
     "[1.0, 2.0] ./ [3.0, 4.0]", lists<over>},
    {"operator.^", "(a: double[], b: double[]) -> double[]", "Raises element by element.",
     "[1.0, 2.0] .^ [3.0, 4.0]", raise_lists},
    {"operator+", "(a: D[], k: D) -> D[]", "Every element plus a number.", "[1mm, 2mm] + 3mm",
     list_and_number<plus>},
    {"operator-", "(a: D[], k: D) -> D[]", "Every element minus a number.", "[1mm, 2mm] - 3mm",
     list_and_number<minus>},
    {"operator*", "(a: D[], k: E) -> (D*E)[]", "Every element times a number.", "[1.0, 2.0] * 3.0",
     list_and_number<times>},
    {"operator.*", "(a: D[], k: E) -> (D*E)[]", "Every element times a number.",
     "[1.0, 2.0] .* 3.0", list_and_number<times>},
    {"operator/", "(a: D[], k: E) -> (D/E)[]", "Every element divided by a number.",
     "[1.0, 2.0] / 2.0", list_and_number<over>},
    {"operator./", "(a: D[], k: E) -> (D/E)[]", "Every element divided by a number.",
     "[1.0, 2.0] ./ 2.0", list_and_number<over>},
    {"operator.^", "(a: double[], n: double) -> double[]", "Every element to a power.",
     "[1.0, 2.0] .^ 2", raise_list},
    {"operator+", "(k: D, a: D[]) -> D[]", "A number plus every element.", "3mm + [1mm, 2mm]",
     number_and_list<plus>},
    {"operator-", "(k: D, a: D[]) -> D[]", "A number minus every element.", "3mm - [1mm, 2mm]",
     number_and_list<minus>},
    {"operator*", "(k: D, a: E[]) -> (D*E)[]", "A number times every element.", "3.0 * [1.0, 2.0]",
     number_and_list<times>},
    {"operator.*", "(k: D, a: E[]) -> (D*E)[]", "A number times every element.",
     "3.0 .* [1.0, 2.0]", number_and_list<times>},
    {"operator./", "(k: D, a: E[]) -> (D/E)[]", "A number divided by every element.",
     "3.0 ./ [1.0, 2.0]", number_and_list<over>},
    {"operator-", "(a: D[]) -> D[]", "Every element with the other sign.", "-[1.0, 2.0]", negate},
};

}  // namespace

std::span<const NativeFunction> vector_functions() { return kVectorFunctions; }

}  // namespace armlet::bind
