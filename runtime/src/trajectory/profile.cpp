#include "armlet/trajectory/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/error.hpp"

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
                  {std::cbrt(60.0 * D / limits.jerk), LimitKind::kJerk}});
}

Trapezoid fastest_trapezoid(double travel, const AxisLimits& limits) {
  const double D = std::abs(travel);
  const double V = limits.speed;
  const double A = limits.acceleration;
  // Without an acceleration limit there is no ramp, without either limit no time at all.
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
  // A triangle that fits exactly may miss by rounding.
  if (discriminant < -1e-12 * A * T * A * T) return std::nullopt;
  // The smaller root of V^2 - A T V + A D = 0, written so that nothing cancels.
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
  // Pieces shorter than the clock's resolution carry nothing but rounding.
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
