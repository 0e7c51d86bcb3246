// Mathematics (language reference, section 19). The same functions have a second name in Math.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "armlet/math/det_math.hpp"
#include "armlet/stdlib/host.hpp"
#include "numbers/real_functions.hpp"
#include "values/bind.hpp"
#include "values/blocks.hpp"

namespace armlet::bind {
namespace {

using Real2 = double (*)(double, double);

bool fits_int(double x) {
  constexpr double kLimit = 9223372036854775808.0;
  return x >= -kLimit && x < kLimit;
}

// A function that is defined everywhere, except that the sine of an infinite angle does not exist.
template <Real1 kFunction>
Answer<double> real1(Vm& vm, double x) {
  const double y = kFunction(x);
  if (std::isnan(y)) return not_finite(vm, "the value", x, CallPart::first());
  return y;
}

// One function applied to every element of a list.
template <Real1 kFunction>
ListObj* each(Vm& vm, std::span<const double> xs) {
  const auto compute = [&](Slot& to, std::size_t i) -> Answer<void> {
    to.d = kFunction(xs[i]);
    if (!std::isnan(to.d)) return {};
    return failure(
        vm, "R0609",
        fmt::format("element {} of the list is {:.15g}, where the function has no value", i, xs[i]),
        at("xs"));
  };
  return checked_items(vm, xs.size(), kFunctionCost, compute);
}

// A rounding function applied to every element of a list, with ints as results.
template <Real1 kRound>
ListObj* each_to_int(Vm& vm, std::span<const double> xs) {
  const auto compute = [&](Slot& to, std::size_t i) -> Answer<void> {
    const double x = kRound(xs[i]);
    if (!std::isfinite(x))
      return not_finite(vm, fmt::format("element {} of the list", i), x, at("xs"));
    if (!fits_int(x)) {
      return failure(vm, "R0610",
                     fmt::format("element {} of the list is {:.15g}, too large for an int", i, x),
                     at("xs"));
    }
    to.i = static_cast<std::int64_t>(x);
    return {};
  };
  return checked_items(vm, xs.size(), kCost, compute);
}
template <auto kFunction>
ListObj* each_int(Vm& vm, std::span<const Slot> xs) {
  const auto compute = [&](Slot& to, std::size_t i) -> Answer<void> {
    const Answer<std::int64_t> y = kFunction(vm, xs[i].i);
    if (!y) return Failed{};
    to.i = *y;
    return {};
  };
  return checked_items(vm, xs.size(), kCost, compute);
}

double to_radians(double x) { return x * (std::numbers::pi / 180.0); }
double to_degrees(double x) { return x * (180.0 / std::numbers::pi); }
double log_10(double x) { return det::log(x) / std::numbers::ln10; }
double sign_of(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x == 0.0 ? 0.0 : x; }

Answer<double> sqrt_checked(Vm& vm, double x) {
  if (!(x >= 0.0)) return domain_failure(vm, "sqrt", x, "not be negative");
  return std::sqrt(x);
}

constexpr double kJustOutside = 1e-6;

template <Real1 kFunction, bool kCosine>
Answer<double> inverse_of_sine(Vm& vm, double x) {
  if (std::abs(x) <= 1.0) return kFunction(x);
  const std::string_view name = kCosine ? "acos" : "asin";
  std::string fix;
  if (std::abs(x) < 1.0 + kJustOutside) {
    fix = fmt::format("rounding can push a {} just past 1: {}(clamp({{arg}}, -1, 1))",
                      kCosine ? "cosine" : "sine", name);
  }
  return domain_failure(vm, name, x, "lie between -1 and 1", std::move(fix));
}

Answer<double> atan_2(Vm& vm, double y, double x) {
  if (!std::isfinite(y)) return not_finite(vm, "the first value given to atan2", y, at("y"));
  if (!std::isfinite(x)) return not_finite(vm, "the second value given to atan2", x, at("x"));
  return det::atan2(y, x);
}

double angle_of(double y, double x) {
  return std::isfinite(y) && std::isfinite(x) ? det::atan2(y, x) : std::nan("");
}

double hypotenuse(double a, double b) { return det::hypot(a, b); }

Answer<double> exponential(Vm& vm, double x) {
  if (std::isnan(x)) return not_finite(vm, "the value given to exp", x, at("x"));
  return det::exp(x);
}

template <Real1 kFunction, bool kTen>
Answer<double> logarithm(Vm& vm, double x) {
  if (!(x > 0.0)) return domain_failure(vm, kTen ? "log10" : "log", x, "be greater than 0");
  return kFunction(x);
}

Answer<double> power(Vm& vm, double x, double y) {
  const double result = det::pow(x, y);
  if (std::isnan(result)) {
    if (!std::isfinite(x)) return not_finite(vm, "the first value given to pow", x, at("x"));
    if (!std::isfinite(y)) return not_finite(vm, "the second value given to pow", y, at("y"));
    return domain_failure(vm, "pow", x,
                          fmt::format("not be negative when the exponent is {:.15g}", y));
  }
  return result;
}

template <double (*kRound)(double)>
Answer<std::int64_t> to_int(Vm& vm, double given_x) {
  const double x = kRound(given_x);
  if (!std::isfinite(x)) return not_finite(vm, "the value", x, at("x"));
  if (!fits_int(x))
    return failure(vm, "R0610", fmt::format("{:.15g} is too large for an int", x), at("x"));
  return static_cast<std::int64_t>(x);
}
// Rounds as Java does: halves go up.
double half_up(double x) {
  const double down = std::floor(x);
  return x - down >= 0.5 ? down + 1.0 : down;
}
double toward_zero(double x) { return std::trunc(x); }

// The remainder with the sign of b; the result of `%` has the sign of a.
Answer<std::int64_t> modulus_int(Vm& vm, std::int64_t a, std::int64_t b) {
  if (b == 0) return failure(vm, "R0611", "mod divides by zero", at("b"));
  if (b == -1) return 0;  // the smallest int divided by -1 would overflow
  const std::int64_t rest = a % b;
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}
Answer<double> modulus(Vm& vm, double a, double b) {
  if (!std::isfinite(a)) return not_finite(vm, "the value given to mod", a, at("a"));
  if (!std::isfinite(b)) return not_finite(vm, "the second value given to mod", b, at("b"));
  if (b == 0.0) return failure(vm, "R0611", "mod divides by zero", at("b"));
  const double rest = std::fmod(a, b);
  if (rest == 0.0) return std::copysign(0.0, b);
  return (rest < 0.0) != (b < 0.0) ? rest + b : rest;
}

// The most digits to round to: a double has no more, and powers of ten up to there are exact.
constexpr std::int64_t kMostDigits = 15;

// The double nearest to x rounded in decimal; if x is exactly a half, it goes up, as for whole
// numbers.
double rounded(double x, int digits) {
  const double power = std::pow(10.0, std::abs(digits));  // exact up to 10^22
  if (digits < 0) return half_up(x / power) * power;
  const double scaled = x * power;
  if (!(std::abs(scaled) < 4503599627370496.0)) return x;  // 2^52: no fraction is left
  const bool is_exact = std::fma(x, power, -scaled) == 0.0;
  if (is_exact && scaled - std::floor(scaled) == 0.5) return (std::floor(scaled) + 1.0) / power;
  return std::strtod(fmt::format("{:.{}f}", x, digits).c_str(), nullptr);
}
Answer<double> round_to(Vm& vm, double x, std::int64_t digits) {
  if (!std::isfinite(x)) return not_finite(vm, "the value", x, at("x"));
  if (digits >= -kMostDigits && digits <= kMostDigits) return rounded(x, static_cast<int>(digits));
  return failure(vm, "R0609",
                 fmt::format("round to {} digits: a double has at most {}", digits, kMostDigits),
                 at("digits"));
}

Answer<std::int64_t> abs_int(Vm& vm, std::int64_t x) {
  if (x == INT64_MIN)
    return failure(vm, "R0610", "the absolute value of the smallest int does not fit an int",
                   at("x"));
  return x < 0 ? -x : x;
}
std::int64_t sign_int(Vm&, std::int64_t x) { return static_cast<std::int64_t>((x > 0) - (x < 0)); }

std::int64_t min_int(std::int64_t a, std::int64_t b) { return std::min(a, b); }
std::int64_t max_int(std::int64_t a, std::int64_t b) { return std::max(a, b); }
double smaller(double a, double b) { return std::isnan(a) || a < b ? a : b; }
double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }
// One of the two arguments is not a number; otherwise the direct call would have been used.
template <Real2 kFunction>
Answer<double> extreme_of_two(Vm& vm, double a, double b) {
  if (std::isnan(a)) return not_finite(vm, "the first value", a, at("a"));
  if (std::isnan(b)) return not_finite(vm, "the second value", b, at("b"));
  return kFunction(a, b);
}

template <bool kMax, class Number>
Answer<Number> extreme(Vm& vm, std::span<const Slot> xs) {
  const auto place = index_of_extreme<kMax, Number>(vm, xs);
  if (!place) return Failed{};
  return number_in<Number>(xs[static_cast<std::size_t>(*place)]);
}

Answer<std::int64_t> clamp_int(Vm& vm, std::int64_t x, std::int64_t lo, std::int64_t hi) {
  if (lo > hi)
    return failure(
        vm, "R0609",
        fmt::format("clamp between {} and {}: the lower limit is above the upper one", lo, hi),
        at("lo"));
  return std::clamp(x, lo, hi);
}
Answer<double> clamp_real(Vm& vm, double x, double lo, double hi) {
  if (!(lo <= hi))
    return failure(
        vm, "R0609",
        fmt::format("clamp between {:.15g} and {:.15g}: the lower limit is above the upper one", lo,
                    hi),
        at("lo"));
  return x < lo ? lo : x > hi ? hi : x;
}
double between(double x, double lo, double hi) {
  if (!(lo <= hi)) return std::nan("");
  return x < lo ? lo : x > hi ? hi : x;
}

Answer<double> lerp_real(Vm& vm, double a, double b, double s) {
  for (const auto& [value, part] : {std::pair(a, at("a")), {b, at("b")}, {s, at("s")}})
    if (!std::isfinite(value)) return not_finite(vm, "a value given to lerp", value, part);
  return a + (b - a) * s;
}
double part_of_range(double a, double b, double s) {
  const bool finite = std::isfinite(a) && std::isfinite(b) && std::isfinite(s);
  return finite ? a + (b - a) * s : std::nan("");
}
Answer<Obj*> lerp_list(Vm& vm, std::span<const double> a, std::span<const double> b, double s) {
  if (a.size() != b.size()) return size_failure(vm, "lerp", a.size(), b.size());
  if (!std::isfinite(s)) return not_finite(vm, "the fraction", s, at("s"));
  return numbers_of(vm, a.size(),
                    [=](Slot& to, std::size_t i) { to.d = a[i] + (b[i] - a[i]) * s; });
}

bool near_real(double a, double b, double tol) { return std::abs(a - b) <= tol; }
Answer<bool> near_list(Vm& vm, std::span<const double> a, std::span<const double> b, double tol) {
  if (a.size() != b.size()) return false;
  bool is_near = true;
  const auto look = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && is_near; ++i) is_near = std::abs(a[i] - b[i]) <= tol;
    return is_near;
  };
  if (!in_blocks(vm, a.size(), kCost, look) && is_near) return Failed{};
  return is_near;
}

// ---- random numbers: seeded generators, one for the program and one for each branch of a parallel

double random_unit(Vm& vm) { return vm.random().uniform(); }
Answer<double> random_between(Vm& vm, double lo, double hi) {
  if (!std::isfinite(lo)) return not_finite(vm, "the lower end given to random", lo, at("lo"));
  if (!std::isfinite(hi)) return not_finite(vm, "the upper end given to random", hi, at("hi"));
  if (lo > hi)
    return failure(
        vm, "R0609",
        fmt::format("random between {:.15g} and {:.15g}: the lower end is above the upper one", lo,
                    hi),
        at("lo"));
  return vm.random().uniform(lo, hi);
}
Answer<std::int64_t> random_int(Vm& vm, std::int64_t n) {
  if (n <= 0)
    return failure(vm, "R0609",
                   fmt::format("randomInt of {}: the number of choices must be greater than 0", n),
                   at("n"));
  return static_cast<std::int64_t>(vm.random().below(static_cast<std::uint64_t>(n)));
}
// Marsaglia's polar method; only one value of the pair is used, so that the generator has no
// further state.
double normal(Random& random, double mean, double sd) {
  double u = 0.0;
  double s = 0.0;
  do {
    u = 2.0 * random.uniform() - 1.0;
    const double v = 2.0 * random.uniform() - 1.0;
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  return mean + sd * u * std::sqrt(-2.0 * det::log(s) / s);
}
double random_standard(Vm& vm) { return normal(vm.random(), 0.0, 1.0); }
Answer<double> random_normal(Vm& vm, double mean, double sd) {
  if (!std::isfinite(mean)) return not_finite(vm, "the mean", mean, at("mean"));
  if (!(sd >= 0.0 && std::isfinite(sd)))
    return domain_failure(vm, "randomNormal", sd, "not be a negative deviation", {}, at("sd"));
  return normal(vm.random(), mean, sd);
}
void set_seed(Vm& vm, std::int64_t n) { vm.seed(static_cast<std::uint64_t>(n)); }

constexpr NativeFunction kMathFunctions[] = {
    def<real1<det::sin>>("sin(x: double) -> double",
                         "Sine of an angle; a plain number counts radians.", "sin(30deg)",
                         {.real1 = det::sin}),
    def<real1<det::cos>>("cos(x: double) -> double",
                         "Cosine of an angle; a plain number counts radians.", "cos(60deg)",
                         {.real1 = det::cos}),
    def<real1<det::tan>>("tan(x: double) -> double",
                         "Tangent of an angle; a plain number counts radians.", "tan(45deg)",
                         {.real1 = det::tan}),
    def<each<det::sin>>("sin(xs: double[]) -> double[]", "Sine of each angle.",
                        "sin([0deg, 90deg])"),
    def<each<det::cos>>("cos(xs: double[]) -> double[]", "Cosine of each angle.",
                        "cos([0deg, 90deg])"),
    def<each<det::tan>>("tan(xs: double[]) -> double[]", "Tangent of each angle.",
                        "tan([0deg, 45deg])"),
    def<inverse_of_sine<det::asin, false>>("asin(x: double) -> angle", "Angle whose sine is x.",
                                           "asin(0.5)"),
    def<inverse_of_sine<det::acos, true>>("acos(x: double) -> angle", "Angle whose cosine is x.",
                                          "acos(0.5)"),
    def<real1<det::atan>>("atan(x: double) -> angle", "Angle whose tangent is x.", "atan(1.0)",
                          {.real1 = det::atan}),
    def<each<det::asin>>("asin(xs: double[]) -> angle[]", "Angle of each sine.",
                         "asin([0.0, 0.5])"),
    def<each<det::acos>>("acos(xs: double[]) -> angle[]", "Angle of each cosine.",
                         "acos([0.0, 0.5])"),
    def<each<det::atan>>("atan(xs: double[]) -> angle[]", "Angle of each tangent.",
                         "atan([0.0, 1.0])"),
    def<atan_2>("atan2(y: D, x: D) -> angle",
                "Angle of the point (x, y) seen from the origin, in all four quadrants.",
                "atan2(1.0, -1.0)", {.real2 = angle_of}),
    def<hypotenuse>("hypot(a: D, b: D) -> D", "Length of the diagonal with sides a and b.",
                    "hypot(3.0, 4.0)", {.real2 = det::hypot}),
    def<sqrt_checked>("sqrt(x: D^2) -> D", "Square root; the root of an area is a length.",
                      "sqrt(2.0)"),
    def<each<square_root>>("sqrt(xs: (D^2)[]) -> D[]", "Square root of each element.",
                           "sqrt([1.0, 4.0])"),
    def<power>("pow(x: double, y: double) -> double", "x to the power y.", "pow(2.0, 0.5)",
               {.real2 = det::pow}),
    def<exponential>("exp(x: double) -> double", "e to the power x.", "exp(1.0)",
                     {.real1 = det::exp}),
    def<each<det::exp>>("exp(xs: double[]) -> double[]", "e to the power of each element.",
                        "exp([0.0, 1.0])"),
    def<logarithm<det::log, false>>("log(x: double) -> double", "Natural logarithm.", "log(10.0)"),
    def<each<det::log>>("log(xs: double[]) -> double[]", "Natural logarithm of each element.",
                        "log([1.0, 2.0])"),
    def<logarithm<log_10, true>>("log10(x: double) -> double", "Logarithm to base 10.",
                                 "log10(1000.0)"),
    def<each<log_10>>("log10(xs: double[]) -> double[]", "Logarithm to base 10 of each element.",
                      "log10([1.0, 10.0])"),
    def<modulus_int>("mod(a: int, b: int) -> int",
                     "The rest of a division, with the sign of b; `a % b` has the sign of a.",
                     "mod(-1, 4)"),
    def<modulus>("mod(a: D, b: D) -> D",
                 "The rest of a division, with the sign of b: an angle in one revolution.",
                 "mod(-90deg, 360deg)"),
    def<abs_int>("abs(x: int) -> int", "Absolute value.", "abs(-3)"),
    def<real1<absolute>>("abs(x: D) -> D", "Absolute value.", "abs(-20mm)", {.real1 = absolute}),
    def<each_int<abs_int>>("abs(xs: int[]) -> int[]", "Absolute value of each element.",
                           "abs([-1, 2])"),
    def<each<absolute>>("abs(xs: D[]) -> D[]", "Absolute value of each element.",
                        "abs([-1.0, 2.0])"),
    def<sign_int>("sign(x: int) -> int", "-1, 0 or 1.", "sign(-3)"),
    def<real1<sign_of>>("sign(x: D) -> double", "-1, 0 or 1.", "sign(-20mm)", {.real1 = sign_of}),
    def<each_int<sign_int>>("sign(xs: int[]) -> int[]", "-1, 0 or 1 for each element.",
                            "sign([-3, 0])"),
    def<each<sign_of>>("sign(xs: D[]) -> double[]", "-1, 0 or 1 for each element.",
                       "sign([-2mm, 0mm])"),
    def<real1<round_down>>("floor(x: double) -> double", "The whole number at or below x.",
                           "floor(2.7)", {.real1 = round_down}),
    def<real1<round_up>>("ceil(x: double) -> double", "The whole number at or above x.",
                         "ceil(2.1)", {.real1 = round_up}),
    def<each<round_down>>("floor(xs: double[]) -> double[]",
                          "The whole number at or below each element.", "floor([2.7])"),
    def<each<round_up>>("ceil(xs: double[]) -> double[]",
                        "The whole number at or above each element.", "ceil([2.1])"),
    def<to_int<half_up>>("round(x: double) -> int", "The nearest whole number; halves go up.",
                         "round(2.5)"),
    def<round_to>("round(x: double, digits: int) -> double",
                  "x with so many digits behind the point; halves go up.", "round(2.345, 2)"),
    def<to_int<toward_zero>>("trunc(x: double) -> int", "x without its fraction.", "trunc(-2.7)"),
    def<each_to_int<half_up>>("round(xs: double[]) -> int[]",
                              "The nearest whole number to each element.", "round([1.5, 2.4])"),
    def<each_to_int<toward_zero>>("trunc(xs: double[]) -> int[]",
                                  "Each element without its fraction.", "trunc([1.5, -2.4])"),
    def<min_int>("min(a: int, b: int) -> int", "The smaller of two.", "min(2, 3)"),
    def<max_int>("max(a: int, b: int) -> int", "The larger of two.", "max(2, 3)"),
    def<extreme_of_two<smaller>>("min(a: D, b: D) -> D", "The smaller of two.", "min(2mm, 3mm)",
                                 {.real2 = smaller}),
    def<extreme_of_two<larger>>("max(a: D, b: D) -> D", "The larger of two.", "max(2mm, 3mm)",
                                {.real2 = larger}),
    def<extreme<false, std::int64_t>>("min(xs: int[]) -> int", "The smallest of a list.",
                                      "min([3, 1, 2])"),
    def<extreme<true, std::int64_t>>("max(xs: int[]) -> int", "The largest of a list.",
                                     "max([3, 1, 2])"),
    def<extreme<false, double>>("min(xs: D[]) -> D", "The smallest of a list.", "min([3mm, 1mm])"),
    def<extreme<true, double>>("max(xs: D[]) -> D", "The largest of a list.", "max([3mm, 1mm])"),
    def<clamp_int>("clamp(x: int, lo: int, hi: int) -> int",
                   "x, but not below lo and not above hi.", "clamp(7, 0, 5)"),
    def<clamp_real>("clamp(x: D, lo: D, hi: D) -> D", "x, but not below lo and not above hi.",
                    "clamp(1.2, -1.0, 1.0)", {.real3 = between}),
    def<lerp_real>("lerp(a: D, b: D, s: double) -> D",
                   "The value the fraction s of the way from a to b.", "lerp(0mm, 10mm, 0.5)",
                   {.real3 = part_of_range}),
    def<lerp_list>("lerp(a: D[], b: D[], s: double) -> D[]",
                   "The values the fraction s of the way from a to b.",
                   "lerp([0.0, 1.0], [1.0, 3.0], 0.5)"),
    def<real1<to_radians>>("toRadians(x: double) -> angle", "The angle of x degrees.",
                           "toRadians(180.0)", {.real1 = to_radians}),
    def<real1<to_degrees>>("toDegrees(x: double) -> double",
                           "An angle in radians as a number of degrees.", "toDegrees(3.14)",
                           {.real1 = to_degrees}),
    def<each<to_radians>>("toRadians(xs: double[]) -> angle[]", "The angles of some degrees.",
                          "toRadians([90.0, 180.0])"),
    def<each<to_degrees>>("toDegrees(xs: double[]) -> double[]",
                          "Angles in radians as numbers of degrees.", "toDegrees([0.5, 3.14])"),
    def<near_real>("near(a: D, b: D, tol: D) -> bool", "Whether a and b differ by at most tol.",
                   "near(1mm, 1.01mm, tol: 0.1mm)"),
    def<near_list>("near(a: D[], b: D[], tol: D) -> bool",
                   "Whether two lists differ by at most tol in every element.",
                   "near([1.0, 2.0], [1.0, 2.01], tol: 0.1)"),
};

constexpr NativeFunction kRandomFunctions[] = {
    def<random_unit>("random() -> double",
                     "A number from 0 up to but excluding 1; the same ones in every run.",
                     "random()"),
    def<random_between>("random(lo: D, hi: D) -> D", "A number between lo and hi.",
                        "random(1mm, 5mm)"),
    def<random_int>("randomInt(n: int) -> int", "A whole number from 0 up to but excluding n.",
                    "randomInt(6)"),
    def<random_standard>("randomNormal() -> double",
                         "A number that is normally distributed about 0 with deviation 1.",
                         "randomNormal()"),
    def<random_normal>("randomNormal(mean: D = 0.0, sd: D) -> D", "A normally distributed number.",
                       "randomNormal(0mm, 1mm)"),
    def<set_seed>("seed(n: int)", "Starts the numbers of random anew from n.", "seed(7)"),
};

}  // namespace

std::span<const NativeFunction> math_functions() { return kMathFunctions; }
std::span<const NativeFunction> random_functions() { return kRandomFunctions; }

}  // namespace armlet::bind
