#include "armlet/trajectory/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"
#include "trajectory/cube_root.hpp"

namespace armlet {
namespace {

void check_duration(double T) {
  if (!std::isfinite(T) || !(T > 0.0)) {
    throw ArgumentError(fmt::format("A law of {} s cannot be made; expected more than 0 s.", T));
  }
}

LeastTime longest(std::initializer_list<LeastTime> times) {
  return *std::ranges::max_element(times, {}, &LeastTime::time);
}

}  // namespace

Segment cubic_segment(const AxisState& from, const AxisState& to, double T) {
  check_duration(T);
  const double D = to.q - from.q;
  return {.start = 0.0,
          .duration = T,
          .degree = 3,
          .c = {from.q, from.v, (3.0 * D - (2.0 * from.v + to.v) * T) / (T * T),
                (-2.0 * D + (from.v + to.v) * T) / (T * T * T)}};
}

Segment quintic_segment(const AxisState& from, const AxisState& to, double T) {
  check_duration(T);
  const double D = to.q - from.q;
  const double T2 = T * T;
  return {
      .start = 0.0,
      .duration = T,
      .degree = 5,
      .c = {from.q, from.v, 0.5 * from.a,
            (20.0 * D - (8.0 * to.v + 12.0 * from.v) * T - (3.0 * from.a - to.a) * T2) /
                (2.0 * T2 * T),
            (-30.0 * D + (14.0 * to.v + 16.0 * from.v) * T + (3.0 * from.a - 2.0 * to.a) * T2) /
                (2.0 * T2 * T2),
            (12.0 * D - 6.0 * (to.v + from.v) * T + (to.a - from.a) * T2) / (2.0 * T2 * T2 * T)}};
}

Segment quartic_segment(const AxisState& from, const AxisState& to, double T) {
  check_duration(T);
  const double D = to.q - from.q;
  const double T2 = T * T;
  return {.start = 0.0,
          .duration = T,
          .degree = 4,
          .c = {from.q, from.v, 0.5 * from.a,
                (4.0 * D - (3.0 * from.v + to.v) * T - from.a * T2) / (T2 * T),
                (-3.0 * D + (2.0 * from.v + to.v) * T + 0.5 * from.a * T2) / (T2 * T2)}};
}

Segment septic_segment(double q0, double q1, double T) {
  check_duration(T);
  const double D = q1 - q0;
  const double T4 = T * T * T * T;
  return {.start = 0.0,
          .duration = T,
          .degree = 7,
          .c = {q0, 0.0, 0.0, 0.0, 35.0 * D / T4, -84.0 * D / (T4 * T), 70.0 * D / (T4 * T * T),
                -20.0 * D / (T4 * T * T * T)}};
}

namespace {

// The four derivatives of a curve at one end of a piece, in units of the piece's length.
using Ends = std::array<double, 4>;

// The polynomial of degree 7 on [0, 1] with these values and first, second and third derivatives at
// its ends.
std::array<double, 8> septic_between(const Ends& a, const Ends& b) {
  std::array<double, 8> c{a[0], a[1], 0.5 * a[2], a[3] / 6.0};
  // The values that the upper four coefficients must add at x = 1.
  const double p = b[0] - (c[0] + c[1] + c[2] + c[3]);
  const double v = b[1] - (c[1] + 2.0 * c[2] + 3.0 * c[3]);
  const double s = b[2] - (2.0 * c[2] + 6.0 * c[3]);
  const double j = b[3] - 6.0 * c[3];
  c[4] = 35.0 * p - 15.0 * v + 2.5 * s - j / 6.0;
  c[5] = -84.0 * p + 39.0 * v - 7.0 * s + 0.5 * j;
  c[6] = 70.0 * p - 34.0 * v + 6.5 * s - 0.5 * j;
  c[7] = -20.0 * p + 10.0 * v - 2.0 * s + j / 6.0;
  return c;
}

}  // namespace

std::vector<Segment> cycloid_segments(double q0, double q1, double T) {
  check_duration(T);
  constexpr int kPieces = 32;
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  const double D = q1 - q0;
  const auto ends = [&](int k) {
    const double x = static_cast<double>(k) / kPieces;
    const double h = 1.0 / kPieces;
    const auto [s, c] = det::sincos(kRevolution * x);
    return Ends{q0 + D * (x - s / kRevolution), D * h * (1.0 - c), D * h * h * kRevolution * s,
                D * h * h * h * kRevolution * kRevolution * c};
  };
  std::vector<Segment> pieces;
  const double h = T / kPieces;
  for (int k = 0; k < kPieces; ++k) {
    Segment piece{
        .start = k * h, .duration = h, .degree = 7, .c = septic_between(ends(k), ends(k + 1))};
    double scale = 1.0;
    for (double& c : piece.c) {
      c *= scale;
      scale /= h;
    }
    pieces.push_back(piece);
  }
  return pieces;
}

Segment reversed(const Segment& piece, double start) {
  Segment back{.start = start, .duration = piece.duration, .degree = piece.degree};
  double factorial = 1.0, sign = 1.0;
  for (int k = 0; k <= piece.degree; ++k) {
    back.c[static_cast<std::size_t>(k)] = sign * piece.value(piece.duration, k) / factorial;
    factorial *= k + 1;
    sign = -sign;
  }
  return back;
}

LeastTime cubic_least_time(double travel, const AxisLimits& limits) {
  const double D = std::abs(travel);
  return longest({{1.5 * D / limits.speed, LimitKind::kSpeed},
                  {std::sqrt(6.0 * D / limits.acceleration), LimitKind::kAcceleration}});
}

LeastTime quintic_least_time(double travel, const AxisLimits& limits) {
  const double D = std::abs(travel);
  const double peak = 10.0 * std::numbers::inv_sqrt3;
  return longest({{1.875 * D / limits.speed, LimitKind::kSpeed},
                  {std::sqrt(peak * D / limits.acceleration), LimitKind::kAcceleration},
                  {cube_root(60.0 * D / limits.jerk), LimitKind::kJerk}});
}

LeastTime septic_least_time(double travel, const AxisLimits& limits) {
  const double D = std::abs(travel);
  const double peak = 84.0 * std::sqrt(5.0) / 25.0;
  return longest({{35.0 / 16.0 * D / limits.speed, LimitKind::kSpeed},
                  {std::sqrt(peak * D / limits.acceleration), LimitKind::kAcceleration},
                  {cube_root(52.5 * D / limits.jerk), LimitKind::kJerk}});
}

LeastTime cycloid_least_time(double travel, const AxisLimits& limits) {
  constexpr double kRevolution = 2.0 * std::numbers::pi;
  const double D = std::abs(travel);
  return longest({{2.0 * D / limits.speed, LimitKind::kSpeed},
                  {std::sqrt(kRevolution * D / limits.acceleration), LimitKind::kAcceleration},
                  {cube_root(kRevolution * kRevolution * D / limits.jerk), LimitKind::kJerk}});
}

Trapezoid fastest_trapezoid(double travel, const AxisLimits& limits) {
  const double D = std::abs(travel);
  const double V = limits.speed;
  const double A = limits.acceleration;
  // Without an acceleration limit the motion has no ramps; without any limit it takes no time.
  if (D == 0.0 || (std::isinf(V) && std::isinf(A))) return {};
  if (std::isinf(A)) return {.ramp = 0.0, .speed = V, .duration = D / V};
  if (std::isinf(V) || D < V * V / A) {
    const double ramp = std::sqrt(D / A);
    return {.ramp = ramp, .speed = A * ramp, .duration = 2.0 * ramp};
  }
  return {.ramp = V / A, .speed = V, .duration = D / V + V / A};
}

LeastTime trapezoid_least_time(double travel, const AxisLimits& limits) {
  const Trapezoid shape = fastest_trapezoid(travel, limits);
  const bool triangle = shape.speed < limits.speed;
  return {shape.duration, triangle ? LimitKind::kAcceleration : LimitKind::kSpeed};
}

std::optional<Trapezoid> trapezoid_in_time(double travel, double T, double A) {
  check_duration(T);
  const double D = std::abs(travel);
  if (std::isinf(A)) return Trapezoid{.ramp = 0.0, .speed = D / T, .duration = T};
  const double discriminant = A * T * A * T - 4.0 * A * D;
  // Rounding errors may make a triangle that fits exactly seem too long.
  if (discriminant < -1e-12 * A * T * A * T) return std::nullopt;
  // The smaller root of V^2 - A T V + A D = 0, in the form without cancellation.
  const double V = 2.0 * A * D / (A * T + std::sqrt(std::max(discriminant, 0.0)));
  return Trapezoid{.ramp = V / A, .speed = V, .duration = T};
}

Trapezoid trapezoid_with_ramp(double travel, double T, double ramp) {
  check_duration(T);
  return {.ramp = ramp, .speed = std::abs(travel) / (T - ramp), .duration = T};
}

std::vector<Segment> trapezoid_segments(double q, double travel, const Trapezoid& shape) {
  check_duration(shape.duration);
  const double v = std::copysign(shape.speed, travel);
  const double cruise = shape.duration - 2.0 * shape.ramp;
  const double covered = 0.5 * v * shape.ramp;
  // Pieces shorter than the clock's resolution contain only rounding errors.
  constexpr double kShortest = 1e-12;
  std::vector<Segment> pieces;
  double t = 0.0;
  if (shape.ramp > kShortest) {
    const double a = v / shape.ramp;
    pieces.push_back({.start = t, .duration = shape.ramp, .degree = 2, .c = {q, 0.0, 0.5 * a}});
    t += shape.ramp;
  }
  if (cruise > kShortest) {
    pieces.push_back({.start = t, .duration = cruise, .degree = 1, .c = {q + covered, v}});
    t += cruise;
  }
  if (shape.ramp > kShortest) {
    const double a = v / shape.ramp;
    const double from = q + travel - covered;
    pieces.push_back(
        {.start = t, .duration = shape.duration - t, .degree = 2, .c = {from, v, -0.5 * a}});
  }
  return pieces;
}

}  // namespace armlet
