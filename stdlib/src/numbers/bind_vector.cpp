// Lists of numbers as vectors (language reference, section 8).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/math/det_math.hpp"
#include "values/bind.hpp"
#include "values/blocks.hpp"
#include "values/matrices.hpp"

namespace armlet::bind {
namespace {

Answer<double> dot(Vm& vm, std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return size_failure(vm, "dot", a.size(), b.size());
  double sum = 0.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sum += a[i] * b[i];
  };
  if (!in_blocks(vm, a.size(), kCost, add)) return Failed{};
  if (std::isnan(sum)) return not_finite(vm, "the product", sum, {});
  return sum;
}
Answer<std::vector<double>> cross(Vm& vm, std::span<const double> a, std::span<const double> b) {
  if (a.size() != 3 || b.size() != 3)
    return size_failure(vm, "cross needs two lists of 3 values", a.size(), b.size());
  return std::vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
}
Answer<double> norm(Vm& vm, std::span<const double> v) {
  double length = 0.0;
  if (!length_of(vm, v, length)) return Failed{};
  if (std::isnan(length)) return not_finite(vm, "the length of the list", length, at("v"));
  return length;
}

// ---- element by element -------------------------------------------------------------------------

template <class F>
ListObj* map_reals(Vm& vm, std::span<const double> xs, F f) {
  return numbers_of(vm, xs.size(), [&](Slot& to, std::size_t i) { to.d = f(xs[i]); });
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
Answer<ListObj*> lists(Vm& vm, std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return size_failure(vm, kDoing<kOperation>, a.size(), b.size());
  return numbers_of(vm, a.size(), [&](Slot& to, std::size_t i) { to.d = kOperation(a[i], b[i]); });
}
template <Operation kOperation>
ListObj* list_and_number(Vm& vm, std::span<const double> a, double k) {
  return map_reals(vm, a, [k](double x) { return kOperation(x, k); });
}
template <Operation kOperation>
ListObj* number_and_list(Vm& vm, double k, std::span<const double> a) {
  return map_reals(vm, a, [k](double x) { return kOperation(k, x); });
}
ListObj* negate(Vm& vm, std::span<const double> a) {
  return map_reals(vm, a, [](double x) { return -x; });
}

// Powers: a negative number has only powers with whole exponents.
ListObj* raise_each(Vm& vm, std::span<const double> xs, std::span<const double> exponents) {
  const auto power_of = [&](Slot& to, std::size_t i) -> Answer<void> {
    const double n = exponents[exponents.size() == 1 ? 0 : i];
    to.d = det::pow(xs[i], n);
    if (!std::isnan(to.d) || std::isnan(xs[i]) || std::isnan(n)) return {};
    return failure(vm, "R0609",
                   fmt::format("element {} of the list is {:.15g}, and a negative number has no "
                               "power of {:.15g}",
                               i, xs[i], n),
                   at("a"));
  };
  return checked_items(vm, xs.size(), 2 * kFunctionCost, power_of);
}
Answer<ListObj*> raise_lists(Vm& vm, std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return size_failure(vm, "powers of lists", a.size(), b.size());
  return raise_each(vm, a, b);
}
ListObj* raise_list(Vm& vm, std::span<const double> a, double n) {
  return raise_each(vm, a, {&n, 1});
}

template <char kOperator>
bool combine(std::int64_t a, std::int64_t b, std::int64_t& out) {
  if (kOperator == '+') return !__builtin_add_overflow(a, b, &out);
  if (kOperator == '-') return !__builtin_sub_overflow(a, b, &out);
  return !__builtin_mul_overflow(a, b, &out);
}
// Two lists, or a list and a number that is combined with every element.
template <char kOperator>
ListObj* whole_numbers(Vm& vm, std::span<const Slot> a, std::span<const Slot> b) {
  const auto combined = [&](Slot& to, std::size_t i) -> Answer<void> {
    const std::int64_t left = a[i < a.size() ? i : 0].i;
    const std::int64_t right = b[i < b.size() ? i : 0].i;
    if (combine<kOperator>(left, right, to.i)) return {};
    return failure(vm, "R0610", fmt::format("element {} is too large for an int", i));
  };
  return checked_items(vm, std::max(a.size(), b.size()), kCost, combined);
}
template <char kOperator>
Answer<ListObj*> int_lists(Vm& vm, std::span<const Slot> a, std::span<const Slot> b) {
  constexpr std::string_view kWhat = kOperator == '+'   ? "adding lists"
                                     : kOperator == '-' ? "subtracting lists"
                                                        : "multiplying lists";
  if (a.size() != b.size()) return size_failure(vm, kWhat, a.size(), b.size());
  return whole_numbers<kOperator>(vm, a, b);
}
template <char kOperator>
ListObj* ints_and_int(Vm& vm, std::span<const Slot> a, std::int64_t k) {
  const Slot number = slot_of(k);
  return whole_numbers<kOperator>(vm, a, std::span(&number, a.empty() ? 0 : 1));
}
template <char kOperator>
ListObj* int_and_ints(Vm& vm, std::int64_t k, std::span<const Slot> b) {
  const Slot number = slot_of(k);
  return whole_numbers<kOperator>(vm, std::span(&number, b.empty() ? 0 : 1), b);
}

constexpr NativeFunction kVectorFunctions[] = {
    def<dot>("dot(a: D[], b: E[]) -> D*E", "The inner product.", "dot([1.0, 2.0], [3.0, 4.0])"),
    def<cross>("cross(a: D[], b: E[]) -> (D*E)[]", "The vector product of two lists of three.",
               "cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])"),
    def<norm>("norm(v: D[]) -> D", "The length of a vector.", "norm([3mm, 4mm])"),
    def<int_lists<'+'>>("operator+(a: int[], b: int[]) -> int[]", "Adds element by element.",
                        "[1, 2] + [3, 4]"),
    def<int_lists<'-'>>("operator-(a: int[], b: int[]) -> int[]", "Subtracts element by element.",
                        "[1, 2] - [3, 4]"),
    def<int_lists<'*'>>("operator.*(a: int[], b: int[]) -> int[]", "Multiplies element by element.",
                        "[1, 2] .* [3, 4]"),
    def<ints_and_int<'+'>>("operator+(a: int[], k: int) -> int[]", "Every element plus a number.",
                           "[1, 2] + 3"),
    def<ints_and_int<'-'>>("operator-(a: int[], k: int) -> int[]", "Every element minus a number.",
                           "[1, 2] - 3"),
    def<ints_and_int<'*'>>("operator.*(a: int[], k: int) -> int[]", "Every element times a number.",
                           "[1, 2] .* 3"),
    def<int_and_ints<'+'>>("operator+(k: int, a: int[]) -> int[]", "A number plus every element.",
                           "3 + [1, 2]"),
    def<int_and_ints<'-'>>("operator-(k: int, a: int[]) -> int[]", "A number minus every element.",
                           "3 - [1, 2]"),
    def<int_and_ints<'*'>>("operator.*(k: int, a: int[]) -> int[]", "A number times every element.",
                           "3 .* [1, 2]"),
    def<lists<plus>>("operator+(a: D[], b: D[]) -> D[]", "Adds element by element.",
                     "[1.0, 2.0] + [3.0, 4.0]"),
    def<lists<minus>>("operator-(a: D[], b: D[]) -> D[]", "Subtracts element by element.",
                      "[1.0, 2.0] - [3.0, 4.0]"),
    def<lists<times>>("operator.*(a: D[], b: E[]) -> (D*E)[]", "Multiplies element by element.",
                      "[1.0, 2.0] .* [3.0, 4.0]"),
    def<lists<over>>("operator./(a: D[], b: E[]) -> (D/E)[]", "Divides element by element.",
                     "[1.0, 2.0] ./ [3.0, 4.0]"),
    def<raise_lists>("operator.^(a: double[], b: double[]) -> double[]",
                     "Raises element by element.", "[1.0, 2.0] .^ [3.0, 4.0]"),
    def<list_and_number<plus>>("operator+(a: D[], k: D) -> D[]", "Every element plus a number.",
                               "[1mm, 2mm] + 3mm"),
    def<list_and_number<minus>>("operator-(a: D[], k: D) -> D[]", "Every element minus a number.",
                                "[1mm, 2mm] - 3mm"),
    def<list_and_number<times>>("operator*(a: D[], k: E) -> (D*E)[]",
                                "Every element times a number.", "[1.0, 2.0] * 3.0"),
    def<list_and_number<times>>("operator.*(a: D[], k: E) -> (D*E)[]",
                                "Every element times a number.", "[1.0, 2.0] .* 3.0"),
    def<list_and_number<over>>("operator/(a: D[], k: E) -> (D/E)[]",
                               "Every element divided by a number.", "[1.0, 2.0] / 2.0"),
    def<list_and_number<over>>("operator./(a: D[], k: E) -> (D/E)[]",
                               "Every element divided by a number.", "[1.0, 2.0] ./ 2.0"),
    def<raise_list>("operator.^(a: double[], n: double) -> double[]", "Every element to a power.",
                    "[1.0, 2.0] .^ 2"),
    def<number_and_list<plus>>("operator+(k: D, a: D[]) -> D[]", "A number plus every element.",
                               "3mm + [1mm, 2mm]"),
    def<number_and_list<minus>>("operator-(k: D, a: D[]) -> D[]", "A number minus every element.",
                                "3mm - [1mm, 2mm]"),
    def<number_and_list<times>>("operator*(k: D, a: E[]) -> (D*E)[]",
                                "A number times every element.", "3.0 * [1.0, 2.0]"),
    def<number_and_list<times>>("operator.*(k: D, a: E[]) -> (D*E)[]",
                                "A number times every element.", "3.0 .* [1.0, 2.0]"),
    def<number_and_list<over>>("operator./(k: D, a: E[]) -> (D/E)[]",
                               "A number divided by every element.", "3.0 ./ [1.0, 2.0]"),
    def<negate>("operator-(a: D[]) -> D[]", "Every element with the other sign.", "-[1.0, 2.0]"),
};

}  // namespace

std::span<const NativeFunction> vector_functions() { return kVectorFunctions; }

}  // namespace armlet::bind
