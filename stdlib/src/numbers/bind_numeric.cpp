// Polynomials, interpolation, roots and minima (language reference, section 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/script_function.hpp"
#include "armlet/math/find_root.hpp"
#include "armlet/math/fit.hpp"
#include "armlet/math/minimise.hpp"
#include "armlet/math/ode.hpp"
#include "armlet/math/real_roots.hpp"
#include "values/bind.hpp"
#include "values/blocks.hpp"
#include "values/matrices.hpp"

namespace armlet::bind {
namespace {

using Eigen::Map;
using Eigen::VectorXd;

Map<const VectorXd> vector_of(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}
Obj* list_of(Vm& vm, const VectorXd& values) {
  return new_reals(vm, {values.data(), static_cast<std::size_t>(values.size())});
}

// R0612 for the first element that is infinite or undefined.
Answer<void> require_finite(Vm& vm, std::span<const double> values, std::string_view what,
                            CallPart part) {
  std::size_t bad = values.size();
  if (!find_number(vm, values, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad == values.size()) return {};
  return not_finite(vm, fmt::format("element {} of {}", bad, what), values[bad], part);
}

// ---- polynomials: the language writes the highest power first, the runtime the constant term ----

Answer<Obj*> polyfit(Vm& vm, std::span<const double> x, std::span<const double> y,
                     std::int64_t degree) {
  if (x.size() != y.size()) return size_failure(vm, "polyfit", x.size(), y.size());
  if (!require_finite(vm, x, "x", at("x")) || !require_finite(vm, y, "y", at("y"))) return Failed{};
  if (degree < 0 || degree > 50)
    return failure(vm, "R0609", fmt::format("polyfit of degree {}: it must be 0 to 50", degree),
                   at("n"));
  // Counts memory for the points and for their x in ascending order.
  const Scratch scratch(vm, x.size() * 3 * sizeof(double));
  if (!scratch.granted()) return Failed{};
  try {
    return list_of(vm,
                   fit_polynomial(vector_of(x), vector_of(y), static_cast<int>(degree)).reverse());
  } catch (const ArgumentError& error) {
    return failure(vm, "R0609", "these points do not decide a polynomial of that degree", at("x"),
                   clause_of(error));
  }
}

double horner(std::span<const double> c, double x, double value = 0.0) {
  for (const double coefficient : c) value = value * x + coefficient;
  return value;
}
// Horner's scheme for any number of coefficients.
Answer<double> long_horner(Vm& vm, std::span<const double> c, double x) {
  double value = 0.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    value = horner(c.subspan(begin, end - begin), x, value);
  };
  if (!in_blocks(vm, c.size(), kCost, add)) return Failed{};
  return value;
}
Answer<double> polyval(Vm& vm, std::span<const double> c, double x) {
  const Answer<double> value = long_horner(vm, c, x);
  if (value && std::isnan(*value)) return not_finite(vm, "the polynomial's value", *value, {});
  return value;
}
Answer<ListObj*> polyval_list(Vm& vm, std::span<const double> c, std::span<const double> xs) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(xs.size()), false);
  if (list == nullptr) return Failed{};
  const bool is_long = c.size() * kCost > kBlockWork;
  const auto value_at = [&](std::size_t i) -> Answer<void> {
    const Answer<double> value = is_long ? long_horner(vm, c, xs[i]) : horner(c, xs[i]);
    if (!value) return Failed{};
    list->data[i].d = *value;
    if (!std::isnan(*value)) return {};
    return not_finite(vm, fmt::format("the polynomial's value at element {}", i), *value, {});
  };
  const auto compute = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!value_at(i)) return false;
    }
    return true;
  };
  const auto cost = static_cast<unsigned>(kCost + (is_long ? 0 : kCost * c.size()));
  if (in_blocks(vm, xs.size(), cost, compute)) return list;
  release(vm, list);
  return Failed{};
}

Answer<Obj*> roots(Vm& vm, std::span<const double> c) {
  constexpr std::size_t kMost = 100'000;  // coefficients, including leading zeros
  if (c.size() > kMost) {
    return failure(
        vm, "R0609",
        fmt::format("roots of {} coefficients: at most {} are possible", c.size(), kMost), at("c"));
  }
  if (!require_finite(vm, c, "the coefficients", at("c"))) return Failed{};
  try {
    return new_reals(vm, real_roots(vector_of(c).reverse()));
  } catch (const ArgumentError& error) {
    return failure(vm, "R0609", "the roots of this polynomial cannot be told", at("c"),
                   clause_of(error));
  }
}

// ---- interpolation --------------------------------------------------------------------------

Answer<double> interpolate(Vm& vm, std::span<const double> x, std::span<const double> y,
                           double x0) {
  if (x.size() != y.size()) return size_failure(vm, "interp", x.size(), y.size());
  if (x.empty()) return failure(vm, "R0613", "interp needs at least one point", at("x"));
  if (!require_finite(vm, x, "x", at("x")) || !require_finite(vm, y, "y", at("y"))) return Failed{};
  if (!std::isfinite(x0)) return not_finite(vm, "the place", x0, at("at"));
  std::size_t turn = x.size();
  const auto rises = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (x[i] < x[i + 1]) continue;
      turn = i;
      return false;
    }
    return true;
  };
  if (!in_blocks(vm, x.size() - 1, kCost, rises) && turn == x.size()) return Failed{};
  if (turn != x.size()) {
    return failure(vm, "R0609",
                   fmt::format("interp needs x in rising order: element {} is {:.15g} and element "
                               "{} is {:.15g}",
                               turn, x[turn], turn + 1, x[turn + 1]),
                   at("x"), {}, "sort the points by x first");
  }
  if (x0 < x.front() || x0 > x.back()) {
    const double gap = x0 < x.front() ? x.front() - x0 : x0 - x.back();
    return failure(vm, "R0609",
                   fmt::format("interp at {:.15g}: the points reach from {:.15g} to {:.15g}", x0,
                               x.front(), x.back()),
                   at("at"),
                   fmt::format("the place is {:.15g} outside, and interp does not go beyond its "
                               "points",
                               gap));
  }
  // Only the two neighbours remain to be found.
  const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), x0) - x.begin());
  const std::size_t first = above < 2 ? 0 : above - 2;
  const auto count = static_cast<Eigen::Index>(std::min<std::size_t>(4, x.size() - first));
  return value_between(Map<const VectorXd>(x.data() + first, count),
                       Map<const VectorXd>(y.data() + first, count), x0);
}

// ---- functions of the program ---------------------------------------------------------------

// A list passed to a function of the program repeatedly: a new list only if the program kept it.
class ListArgument {
 public:
  explicit ListArgument(Vm& vm) : vm_(vm) {}
  ~ListArgument() { release(vm_, list_); }
  ListArgument(const ListArgument&) = delete;
  ListArgument& operator=(const ListArgument&) = delete;

  // Null: it failed, and the failure is set.
  ListObj* with(std::span<const double> values) {
    if (list_ == nullptr || list_->refs != 1) {
      release(vm_, list_);
      list_ = new_list(vm_, static_cast<std::uint32_t>(values.size()), false);
      if (list_ == nullptr) return nullptr;
    }
    const auto copy = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) list_->data[i].d = values[i];
    };
    return in_blocks(vm_, values.size(), kCost, copy) ? list_ : nullptr;
  }

 private:
  Vm& vm_;
  ListObj* list_ = nullptr;
};

Failed cannot_solve(Vm& vm, const RootSearch& found, double lo, double hi) {
  // A value this close to zero is the rounding of the bisection.
  const double x = std::abs(found.x) < 1e-15 * std::abs(hi - lo) ? 0.0 : found.x;
  switch (found.status) {
    case RootSearch::Status::kSameSign:
      return failure(
          vm, "R0609",
          fmt::format("solve needs a change of sign between {:.15g} and {:.15g}", lo, hi), at("lo"),
          fmt::format("the function is {:.6g} at the one end and {:.6g} at the other", found.at_lo,
                      found.at_hi),
          "choose ends where the function has different signs");
    case RootSearch::Status::kJump:
      return failure(vm, "R0609",
                     fmt::format("solve found no root: the function jumps at {:.15g}", x), at("f"),
                     fmt::format("its sign changes there while its size stays at {:.6g}",
                                 std::abs(found.value)));
    default:
      return not_finite(vm, fmt::format("the function at {:.15g}", x), found.value, at("f"));
  }
}

Answer<double> root_between(Vm& vm, const ScriptFunction<double(double)>& f, double lo, double hi) {
  if (!std::isfinite(lo)) return not_finite(vm, "the lower end", lo, at("lo"));
  if (!std::isfinite(hi)) return not_finite(vm, "the upper end", hi, at("hi"));
  const RootSearch found =
      find_root([&](double x, double& value) { return f.call(value, x); }, lo, hi);
  if (found.status == RootSearch::Status::kFound) return found.x;
  if (found.status == RootSearch::Status::kStopped) return Failed{};
  return cannot_solve(vm, found, lo, hi);
}

Failed cannot_minimise(Vm& vm, const Minimum& found) {
  std::string place;
  for (const double x : found.x) place += fmt::format("{}{:.6g}", place.empty() ? "" : ", ", x);
  place = "[" + place + "]";
  switch (found.status) {
    case Minimum::Status::kTooMany:
      return failure(vm, "R0609",
                     fmt::format("minimise did not settle within {} calls", found.evaluations),
                     at("f"), fmt::format("the best so far is {:.6g} at {}", found.value, place),
                     "start nearer to the minimum, or scale the variables to about the same size");
    case Minimum::Status::kBottomless:
      return failure(vm, "R0609", "minimise found no bottom: the function falls without end",
                     at("f"), fmt::format("it is -inf at {}", place));
    default:
      return failure(vm, "R0612", fmt::format("the function is not a number at {}", place),
                     at("f"));
  }
}

Answer<Obj*> minimum(Vm& vm, FunctionValue f, std::span<const double> start) {
  if (start.empty())
    return failure(vm, "R0613", "minimise needs a start of at least one value", at("start"));
  if (!require_finite(vm, start, "the start", at("start"))) return Failed{};
  // The vertices of the simplex, one more than there are variables.
  const std::uint64_t n = start.size();
  const Scratch scratch(vm, (n + 5) * n * sizeof(double));
  if (!scratch.granted()) return Failed{};
  ListArgument argument(vm);
  const auto call = [&](const VectorXd& x, double& value) {
    const Slot list{.o = argument.with({x.data(), static_cast<std::size_t>(x.size())})};
    Slot result;
    if (list.o == nullptr || !vm.call(f.object, {&list, 1}, result)) return false;
    value = result.d;
    return true;
  };
  const Minimum found = minimise(call, vector_of(start));
  if (found.status == Minimum::Status::kFound) return list_of(vm, found.x);
  if (found.status == Minimum::Status::kStopped) return Failed{};
  return cannot_minimise(vm, found);
}

constexpr NativeFunction kNumericFunctions[] = {
    def<polyfit>("polyfit(x: double[], y: double[], n: int) -> double[]",
                 "The polynomial of degree n that fits the points best by least squares: its "
                 "coefficients, the "
                 "one of the highest power first.",
                 "polyfit([0.0, 1.0, 2.0], [1.0, 2.0, 4.0], 1)"),
    def<polyval>(
        "polyval(c: double[], x: double) -> double",
        "The value at x of the polynomial with coefficients c, the one of the highest power first.",
        "polyval([1.0, 0.0, -2.0], 3.0)"),
    def<polyval_list>("polyval(c: double[], xs: double[]) -> double[]",
                      "The polynomial's value at each x.", "polyval([1.0, 0.0, -2.0], [1.0, 2.0])"),
    def<roots>(
        "roots(c: double[]) -> double[]",
        "The real roots of the polynomial with coefficients c, the one of the highest power first: "
        "smallest first, a multiple root once, complex ones left out.",
        "roots([1.0, 0.0, -2.0])"),
    def<interpolate>("interp(x: D[], y: E[], at: D) -> E",
                     "The value at a place between points, on the straight line through its "
                     "neighbours; x rises.",
                     "interp([0s, 1s, 3s], [0mm, 20mm, 30mm], 2s)"),
    def<root_between>(
        "solve(f: fn(double) -> double, lo: double, hi: double) -> double",
        "Where f is zero between lo and hi, at which it has different signs; exact to the last "
        "digits.",
        "solve(fn(x) => x^2 - 2.0, 0.0, 2.0)"),
    def<minimum>("minimise(f: fn(double[]) -> double, start: double[]) -> double[]",
                 "Where f is smallest, looked for downhill from the start without derivatives.",
                 "minimise(fn(v) => (v[0] - 1.0)^2 + (v[1] - 2.0)^2, [0.0, 0.0])"),
};

}  // namespace

std::span<const NativeFunction> numeric_functions() { return kNumericFunctions; }

}  // namespace armlet::bind
