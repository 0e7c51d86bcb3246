// Splines of degree 4 and 5, and the paths of lift-off, travel and set-down; spline.hpp names the
// sources (de Boor 1963; Fu, Gonzalez, Lee 1987).

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/profile.hpp"
#include "armlet/trajectory/spline.hpp"
#include "trajectory/splines/spline_points.hpp"

namespace armlet {
namespace {

Segment placed(Segment piece, double start) {
  piece.start = start;
  return piece;
}

void check_four(std::span<const double> t, std::span<const double> q) {
  check_points(t, q);
  if (t.size() != 4) {
    throw ArgumentError(fmt::format(
        "A path of lift-off, travel and set-down has 4 points; {} were given.", t.size()));
  }
}

// The quartic that ends with the acceleration to.a, made as the mirror image in time of one that
// begins with it.
Segment quartic_ending(const AxisState& from, const AxisState& to, double T, double start) {
  return reversed(
      quartic_segment({.q = to.q, .v = -to.v, .a = to.a}, {.q = from.q, .v = -from.v}, T), start);
}

// Two quartics of equal duration between two points. At its end a quartic has the acceleration
// a0 - 12 D / h^2 + 6 (v0 + v) / h and the jerk (-48 D + (30 v0 + 18 v) h + 6 a0 h^2) / h^3; equal
// ones from both sides decide speed and position halfway.
std::vector<Segment> two_quartics(std::span<const double> q, double T, const PathEnds& ends) {
  const double h = 0.5 * T;
  const AxisState middle{.q = 0.5 * (q[0] + q[1]) + 0.3125 * h * (ends.v_start - ends.v_end) +
                              h * h * (ends.a_start + ends.a_end) / 16.0,
                         .v = (q[1] - q[0]) / h - 0.5 * (ends.v_start + ends.v_end) +
                              h * (ends.a_end - ends.a_start) / 12.0};
  return {quartic_segment({.q = q[0], .v = ends.v_start, .a = ends.a_start}, middle, h),
          quartic_ending(middle, {.q = q[1], .v = ends.v_end, .a = ends.a_end}, h, h)};
}

// The speeds at the points follow from the continuity of the acceleration; the system is
// tridiagonal and diagonally dominant.
std::vector<double> quartic_speeds(std::span<const double> t, std::span<const double> q,
                                   const PathEnds& ends) {
  const std::size_t last = t.size() - 1;
  std::vector<double> upper(t.size(), 0.0);
  std::vector<double> v(t.size(), 0.0);
  v[0] = ends.v_start;
  v[last] = ends.v_end;
  for (std::size_t i = 1; i < last; ++i) {
    const bool first = i == 1, final = i + 1 == last;
    const double h0 = t[i] - t[i - 1], h1 = t[i + 1] - t[i];
    const double lower = (first ? 6.0 : 2.0) / h0;
    const double above = (final ? 6.0 : 2.0) / h1;
    const double diagonal = (first ? 6.0 : 4.0) / h0 + (final ? 6.0 : 4.0) / h1;
    const double rhs = (first ? 12.0 : 6.0) * (q[i] - q[i - 1]) / (h0 * h0) +
                       (final ? 12.0 : 6.0) * (q[i + 1] - q[i]) / (h1 * h1) -
                       (first ? ends.a_start : 0.0) + (final ? ends.a_end : 0.0);
    const double pivot = diagonal - lower * upper[i - 1];
    upper[i] = above / pivot;
    v[i] = (rhs - lower * v[i - 1]) / pivot;
  }
  for (std::size_t i = last - 1; i > 0; --i) v[i] -= upper[i] * v[i + 1];
  return v;
}

// Speed and acceleration at a point.
using Rates = Eigen::Vector2d;

// Speeds and accelerations at the points from continuity of the third and fourth derivative: block
// tridiagonal.
std::vector<Rates> quintic_rates(std::span<const double> t, std::span<const double> q,
                                 const PathEnds& ends) {
  const std::size_t last = t.size() - 1;
  std::vector<Eigen::Matrix2d> upper(t.size(), Eigen::Matrix2d::Zero());
  std::vector<Rates> x(t.size(), Rates::Zero());
  x[0] = {ends.v_start, ends.a_start};
  x[last] = {ends.v_end, ends.a_end};
  for (std::size_t i = 1; i < last; ++i) {
    const double h0 = t[i] - t[i - 1], h1 = t[i + 1] - t[i];
    const double g0 = 1.0 / h0, g1 = 1.0 / h1;
    const double D0 = q[i] - q[i - 1], D1 = q[i + 1] - q[i];
    Eigen::Matrix2d lower, diagonal, above;
    lower << -24.0 * g0 * g0, -3.0 * g0, -168.0 * g0 * g0 * g0, -24.0 * g0 * g0;
    diagonal << 36.0 * (g1 * g1 - g0 * g0), 9.0 * (g0 + g1), -192.0 * (g0 * g0 * g0 + g1 * g1 * g1),
        36.0 * (g0 * g0 - g1 * g1);
    above << 24.0 * g1 * g1, -3.0 * g1, -168.0 * g1 * g1 * g1, 24.0 * g1 * g1;
    const Rates rhs{60.0 * (D1 * g1 * g1 * g1 - D0 * g0 * g0 * g0),
                    -360.0 * (D1 * g1 * g1 * g1 * g1 + D0 * g0 * g0 * g0 * g0)};
    const Eigen::Matrix2d pivot = (diagonal - lower * upper[i - 1]).inverse();
    upper[i] = pivot * above;
    x[i] = pivot * (rhs - lower * x[i - 1]);
  }
  for (std::size_t i = last - 1; i > 0; --i) x[i] -= upper[i] * x[i + 1];
  return x;
}

}  // namespace

std::vector<Segment> cubic_interpolator(std::span<const double> t, std::span<const double> q,
                                        const PathEnds& ends) {
  check_points(t, q);
  const std::size_t last = t.size() - 1;
  std::vector<double> v(t.size(), 0.0);
  v[0] = ends.v_start;
  v[last] = ends.v_end;
  for (std::size_t i = 1; i < last; ++i) {
    const double before = (q[i] - q[i - 1]) / (t[i] - t[i - 1]);
    const double behind = (q[i + 1] - q[i]) / (t[i + 1] - t[i]);
    v[i] = before * behind > 0.0 ? 0.5 * (before + behind) : 0.0;
  }
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < last; ++i) {
    pieces.push_back(placed(
        cubic_segment({.q = q[i], .v = v[i]}, {.q = q[i + 1], .v = v[i + 1]}, t[i + 1] - t[i]),
        t[i]));
  }
  return pieces;
}

std::vector<Segment> quartic_spline(std::span<const double> t, std::span<const double> q,
                                    const PathEnds& ends) {
  check_points(t, q);
  if (t.size() == 2) return two_quartics(q, t[1], ends);
  const std::size_t last = t.size() - 1;
  const std::vector<double> v = quartic_speeds(t, q, ends);
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < last; ++i) {
    const double h = t[i + 1] - t[i];
    const AxisState from{.q = q[i], .v = v[i], .a = ends.a_start};
    const AxisState to{.q = q[i + 1], .v = v[i + 1], .a = ends.a_end};
    if (i == 0) {
      pieces.push_back(quartic_segment(from, to, h));
    } else if (i + 1 == last) {
      pieces.push_back(quartic_ending(from, to, h, t[i]));
    } else {
      pieces.push_back(placed(cubic_segment(from, to, h), t[i]));
    }
  }
  return pieces;
}

std::vector<Segment> quintic_spline(std::span<const double> t, std::span<const double> q,
                                    const PathEnds& ends) {
  check_points(t, q);
  const std::vector<Rates> x = quintic_rates(t, q, ends);
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    pieces.push_back(placed(
        quintic_segment({.q = q[i], .v = x[i][0], .a = x[i][1]},
                        {.q = q[i + 1], .v = x[i + 1][0], .a = x[i + 1][1]}, t[i + 1] - t[i]),
        t[i]));
  }
  return pieces;
}

std::vector<Segment> path_353(std::span<const double> t, std::span<const double> q,
                              const PathEnds& ends) {
  check_four(t, q);
  const double T1 = t[1], T2 = t[2] - t[1], T3 = t[3] - t[2];
  // The cubic from a complete state to a position; the one to a complete state is its mirror image.
  const auto lift = [](double q0, double v0, double a0, double q1, double T) {
    const double jerk_part = (q1 - q0 - T * (v0 + 0.5 * a0 * T)) / (T * T * T);
    return Segment{.duration = T, .degree = 3, .c = {q0, v0, 0.5 * a0, jerk_part}};
  };
  const Segment up = lift(q[0], ends.v_start, ends.a_start, q[1], T1);
  const Segment down = reversed(lift(q[3], -ends.v_end, ends.a_end, q[2], T3), t[2]);
  const AxisState from{.q = q[1], .v = up.value(T1, 1), .a = up.value(T1, 2)};
  const AxisState to{.q = q[2], .v = down.value(0.0, 1), .a = down.value(0.0, 2)};
  return {up, placed(quintic_segment(from, to, T2), t[1]), down};
}

std::vector<Segment> path_five_cubics(std::span<const double> t, std::span<const double> q,
                                      const PathEnds& ends) {
  check_four(t, q);
  const double h = 0.5 * t[1], H = t[2] - t[1], k = 0.5 * (t[3] - t[2]);
  const double a0 = ends.a_start, a5 = ends.a_end;
  // The free points are X + h^2 a / 6 and Y + k^2 a / 6, with the accelerations a at these points.
  const double X = q[0] + h * ends.v_start + h * h * a0 / 3.0;
  const double Y = q[3] - k * ends.v_end + k * k * a5 / 3.0;
  // The continuity of speed at the two given points contains only their accelerations.
  const double slope = (q[2] - q[1]) / H;
  const double r1 = slope - (q[1] - X) / h;
  const double r2 = (Y - q[2]) / k - slope;
  const double d1 = (h + H) / 3.0, d2 = (H + k) / 3.0, e = H / 6.0;
  const double determinant = d1 * d2 - e * e;
  const double a2 = (d2 * r1 - e * r2) / determinant;
  const double a3 = (d1 * r2 - e * r1) / determinant;
  const double a1 = ((q[0] + q[1] - 2.0 * X) / h - h * (a0 + a2) / 6.0) / h;
  const double a4 = ((q[3] + q[2] - 2.0 * Y) / k - k * (a5 + a3) / 6.0) / k;
  const std::array<double, 6> a{a0, a1, a2, a3, a4, a5};
  const std::array<double, 6> p{q[0], X + h * h * a1 / 6.0, q[1], q[2], Y + k * k * a4 / 6.0, q[3]};
  const std::array<double, 5> lengths{h, h, H, k, k};
  std::vector<Segment> pieces;
  double start = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    const double T = lengths[i];
    const double v = (p[i + 1] - p[i]) / T - T * (2.0 * a[i] + a[i + 1]) / 6.0;
    pieces.push_back({.start = start,
                      .duration = T,
                      .degree = 3,
                      .c = {p[i], v, 0.5 * a[i], (a[i + 1] - a[i]) / (6.0 * T)}});
    start += T;
  }
  return pieces;
}

}  // namespace armlet
