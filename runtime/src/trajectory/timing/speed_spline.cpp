#include "trajectory/timing/speed_spline.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "trajectory/cube_root.hpp"

namespace armlet {
namespace {

constexpr double kNarrower = 0.04;   // factor of the barrier from stage to stage
constexpr double kWide = 0.6;        // barrier of the first stage, as a fraction of the duration,
constexpr double kAgain = 0.024;     // and of the first stage that begins with an earlier result
constexpr int kMostSteps = 100;      // of one stage; about 20 were the most that were needed
constexpr double kCentred = 0.3;     // squared Newton decrement, as a fraction of the barrier
constexpr std::size_t kRowWork = 5;  // operations for a row
constexpr int kMostHalvings = 40;
constexpr int kFewShrinks = 6;  // after more of them a new start is better
constexpr int kMostShrinks = 2000;
constexpr double kGrows = 0.2;  // growth of a coefficient from cell to cell, at the start

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

SpeedSpline::SpeedSpline(std::vector<double> knots) : knots_(std::move(knots)) {}

double SpeedSpline::at(std::size_t cell, double part) const {
  return part == 1.0 ? knots_[cell + 1] : knots_[cell] + part * (knots_[cell + 1] - knots_[cell]);
}

std::size_t SpeedSpline::cell_at(double u, std::size_t cell) const {
  while (cell + 1 < cells() && knots_[cell + 1] <= u) ++cell;
  return cell;
}

SpeedSpline::Basis SpeedSpline::basis(std::size_t cell, double u) const {
  const double t0 = knots_[cell], t1 = knots_[cell + 1];
  const double before = cell > 0 ? knots_[cell - 1] : t0;
  const double behind = cell + 2 < knots_.size() ? knots_[cell + 2] : t1;
  const double p = 1.0 / ((t1 - before) * (t1 - t0)), q = 1.0 / ((behind - t0) * (t1 - t0));
  Basis b;
  b.value = {p * (t1 - u) * (t1 - u), 0.0, q * (u - t0) * (u - t0)};
  b.value[1] = 1.0 - b.value[0] - b.value[2];
  b.rate = {-2.0 * p * (t1 - u), 0.0, 2.0 * q * (u - t0)};
  b.rate[1] = -b.rate[0] - b.rate[2];
  b.curve = {2.0 * p, -2.0 * (p + q), 2.0 * q};
  return b;
}

void SpeedSpline::clear_points() {
  points_.clear();
  rows_.clear();
  forces_.clear();
}

SpeedSpline::Point& SpeedSpline::add_point(std::size_t cell, double part, double weight) {
  const Basis b = basis(cell, at(cell, part));
  points_.push_back({.cell = cell,
                     .value = b.value,
                     .rate = b.rate,
                     .curve = b.curve,
                     .weight = weight * (knots_[cell + 1] - knots_[cell]),
                     .rows = rows_.size(),
                     .rows_end = rows_.size(),
                     .forces = forces_.size(),
                     .forces_end = forces_.size()});
  return points_.back();
}

void SpeedSpline::add_row(const Row& row) {
  rows_.push_back(row);
  points_.back().rows_end = rows_.size();
}

void SpeedSpline::add_force(const Force& force) {
  forces_.push_back(force);
  points_.back().forces_end = forces_.size();
}

// The highest b that a point allows for a spline whose coefficients change little from cell to
// cell.
double SpeedSpline::room_of(const Point& point) const {
  const double h = knots_[point.cell + 1] - knots_[point.cell];
  double most = point.most;
  for (std::size_t k = point.rows; k < point.rows_end; ++k) {
    const Row& row = rows_[k];
    const double y = std::abs(row.ya) * kGrows / h + std::abs(row.yb);
    if (y * most > 1.0) most = 1.0 / y;
    const double z =
        (2.0 * std::abs(row.za) / h + std::abs(row.zb)) * kGrows / h + std::abs(row.zc);
    if (z * most * std::sqrt(most) > 1.0) {
      const double root = cube_root(1.0 / z);
      most = root * root;
    }
  }
  for (std::size_t k = point.forces; k < point.forces_end; ++k) {
    const Force& force = forces_[k];
    const double y = std::abs(force.ya) * kGrows / h + std::abs(force.yb);
    const double room = std::min(force.high, -force.low), v = std::abs(force.v);
    // The root of y x^2 + v x - room.
    const double x = 2.0 * room / (v + std::sqrt(v * v + 4.0 * y * room));
    most = std::min(most, x * x);
  }
  return most;
}

// Coefficients well within the limits: half of what they allow, and changing little.
std::vector<double> SpeedSpline::slow_start() const {
  std::vector<double> c(cells() + 2, std::numeric_limits<double>::infinity());
  for (const Point& point : points_) {
    const double most = 0.5 * room_of(point);
    for (std::size_t i = 0; i < 3; ++i) c[point.cell + i] = std::min(c[point.cell + i], most);
  }
  if (!std::isfinite(*std::ranges::min_element(c)))
    throw ArgumentError("Nothing limits the speed along this path.");
  for (std::size_t i = 1; i < c.size(); ++i) c[i] = std::min(c[i], (1.0 + kGrows) * c[i - 1]);
  for (std::size_t i = c.size() - 1; i-- > 0;) c[i] = std::min(c[i], (1.0 + kGrows) * c[i + 1]);
  return c;
}

// Reduces the coefficients until they keep the limits; false if that takes more than `most` rounds.
bool SpeedSpline::shrink(int most) {
  for (int k = 0; !keeps_limits(c_); ++k) {
    if (k == most) return false;
    for (double& c : c_) c *= 0.9;
  }
  return true;
}

// Adds the barriers of the forces of one point; false if one is beyond its limits.
bool SpeedSpline::add_force_barriers(const Point& point, double mu,
                                     const std::array<double, 3>& b) {
  const double root = std::sqrt(b[0]);
  for (std::size_t k = point.forces; k < point.forces_end; ++k) {
    const Force& force = forces_[k];
    const double f = force.ya * b[1] + force.yb * b[0] + force.v * root;
    const double above = force.high - f, below = f - force.low;
    if (!(above > 0.0 && below > 0.0)) return false;
    const double p = 1.0 / above, q = 1.0 / below;
    const double by_b = force.yb + 0.5 * force.v / root;
    // Only the part of the curvature of friction that makes a barrier more convex.
    const double bent = 0.25 * std::abs(force.v) / (b[0] * root) * (force.v > 0.0 ? q : p);
    const double slope = mu * (p - q), curve = mu * (p * p + q * q);
    g_[0] += slope * by_b;
    g_[1] += slope * force.ya;
    h_[0][0] += curve * by_b * by_b + mu * bent;
    h_[0][1] += curve * by_b * force.ya;
    h_[1][1] += curve * force.ya * force.ya;
  }
  return true;
}

// Adds the barriers of one point at b, b', b''; false if a limit is not kept.
bool SpeedSpline::add_barriers(const Point& point, double mu, const std::array<double, 3>& b) {
  const double slack = point.most - b[0];
  if (!(slack > 0.0)) return false;
  double g0 = 0.0, g1 = 0.0, g2 = 0.0;
  double h00 = 0.0, h01 = 0.0, h02 = 0.0, h11 = 0.0, h12 = 0.0, h22 = 0.0;
  if (std::isfinite(slack)) {
    g0 = 1.0 / slack;
    h00 = g0 * g0;
  }
  const double R = 1.0 / std::sqrt(b[0]), R1 = -0.5 * R / b[0];
  for (std::size_t k = point.rows; k < point.rows_end; ++k) {
    const Row row = rows_[k];
    const double y = row.ya * b[1] + row.yb * b[0];
    const double room = 1.0 - y * y;
    const double z = row.za * b[2] + row.zb * b[1] + row.zc * b[0];
    const double jerk_room = (R + z) * (R - z);
    if (!(room > 0.0 && R - std::abs(z) > 0.0)) return false;
    const double w = 1.0 / room;
    const double e = 2.0 * y * w, f = 2.0 * (1.0 + y * y) * w * w;
    g0 += e * row.yb;
    g1 += e * row.ya;
    h00 += f * row.yb * row.yb;
    h01 += f * row.yb * row.ya;
    h11 += f * row.ya * row.ya;
    // 1 / (R + z) and 1 / (R - z), their sums and differences and those of their squares.
    const double v = 1.0 / jerk_room;
    const double both = 2.0 * R * v, first = -2.0 * z * v;
    const double sum = 0.5 * (both * both + first * first), apart = both * first;
    g0 -= R1 * both + first * row.zc;
    g1 -= first * row.zb;
    g2 -= first * row.za;
    h00 += sum * (R1 * R1 + row.zc * row.zc) + 2.0 * apart * R1 * row.zc;
    h01 += (sum * row.zc + apart * R1) * row.zb;
    h02 += (sum * row.zc + apart * R1) * row.za;
    h11 += sum * row.zb * row.zb;
    h12 += sum * row.zb * row.za;
    h22 += sum * row.za * row.za;
  }
  g_[0] += mu * g0;
  g_[1] += mu * g1;
  g_[2] += mu * g2;
  h_[0][0] += mu * h00;
  h_[0][1] += mu * h01;
  h_[0][2] += mu * h02;
  h_[1][1] += mu * h11;
  h_[1][2] += mu * h12;
  h_[2][2] += mu * h22;
  return add_force_barriers(point, mu, b);
}

// b, b' and b'' at a point.
std::array<double, 3> SpeedSpline::at(const Point& point, const std::vector<double>& c) {
  const std::array<double, 3> own = {c[point.cell], c[point.cell + 1], c[point.cell + 2]};
  return {dot(point.value, own), dot(point.rate, own), dot(point.curve, own)};
}

bool SpeedSpline::keeps_limits(const std::vector<double>& c) const {
  checkpoint(kRowWork * (rows_.size() + forces_.size()));
  // This ensures that the spline is above zero between the points too.
  if (!(*std::ranges::min_element(c) > 0.0)) return false;
  for (const Point& point : points_) {
    const std::array<double, 3> b = at(point, c);
    if (!(b[0] > 0.0 && b[0] < point.most)) return false;
    for (std::size_t k = point.rows; k < point.rows_end; ++k) {
      const Row& row = rows_[k];
      const double y = row.ya * b[1] + row.yb * b[0];
      const double z = row.za * b[2] + row.zb * b[1] + row.zc * b[0];
      if (!(y * y < 1.0 && z * z * b[0] < 1.0)) return false;
    }
    for (std::size_t k = point.forces; k < point.forces_end; ++k) {
      const Force& force = forces_[k];
      const double f = force.ya * b[1] + force.yb * b[0] + force.v * std::sqrt(b[0]);
      if (!(f < force.high && f > force.low)) return false;
    }
  }
  return true;
}

// The duration with the barriers, and its derivatives; false if a limit is not kept.
bool SpeedSpline::evaluate(const std::vector<double>& c, double mu) {
  checkpoint(4 * kRowWork * (rows_.size() + forces_.size()));
  time_ = 0.0;
  gradient_.assign(c.size(), 0.0);
  hessian_.assign(c.size(), {});
  // Coefficients stay above zero (see keeps_limits). Without barriers of their own, one of them
  // could come so near to zero that every step ends there: next to a much slower piece a
  // coefficient has to become small.
  for (std::size_t i = 0; i < c.size(); ++i) {
    gradient_[i] = -mu / c[i];
    hessian_[i][0] = mu / (c[i] * c[i]);
  }
  for (const Point& point : points_) {
    const std::array<double, 3> b = at(point, c);
    if (!(b[0] > 0.0)) return false;
    const double slow = point.weight / std::sqrt(b[0]);
    time_ += slow;
    g_ = {-0.5 * slow / b[0], 0.0, 0.0};
    h_ = {};
    h_[0][0] = 0.75 * slow / (b[0] * b[0]);
    if (!add_barriers(point, mu, b)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      const double v = point.value[i], r = point.rate[i], k = point.curve[i];
      gradient_[point.cell + i] += g_[0] * v + g_[1] * r + g_[2] * k;
      const double x = h_[0][0] * v + h_[0][1] * r + h_[0][2] * k;
      const double y = h_[0][1] * v + h_[1][1] * r + h_[1][2] * k;
      const double z = h_[0][2] * v + h_[1][2] * r + h_[2][2] * k;
      for (std::size_t j = i; j < 3; ++j) {
        hessian_[point.cell + i][j - i] +=
            x * point.value[j] + y * point.rate[j] + z * point.curve[j];
      }
    }
  }
  return true;
}

// -H^-1 g by L D L' of the band.
std::vector<double> SpeedSpline::newton_step() const {
  const std::size_t n = gradient_.size();
  std::vector<std::array<double, 3>> band = hessian_;
  std::vector<double> d(n);
  for (std::size_t i = 0; i < n; ++i) d[i] = -gradient_[i];
  for (std::size_t i = 0; i < n; ++i) {
    const double pivot = band[i][0] * (1.0 + 1e-13) + 1e-300;
    const double one = band[i][1] / pivot, two = band[i][2] / pivot;
    if (i + 1 < n) {
      band[i + 1][0] -= one * band[i][1];
      band[i + 1][1] -= one * band[i][2];
      d[i + 1] -= one * d[i];
    }
    if (i + 2 < n) {
      band[i + 2][0] -= two * band[i][2];
      d[i + 2] -= two * d[i];
    }
    band[i] = {pivot, one, two};
  }
  for (std::size_t i = n; i-- > 0;) {
    d[i] /= band[i][0];
    if (i + 1 < n) d[i] -= band[i][1] * d[i + 1];
    if (i + 2 < n) d[i] -= band[i][2] * d[i + 2];
  }
  return d;
}

// One step of Newton's method (S. Boyd, L. Vandenberghe, Convex Optimization, 2004, sections 9.5
// and 11.3), shortened until it keeps the limits and does not lead beyond the lowest point by much.
SpeedSpline::Step SpeedSpline::step(double mu) {
  const std::vector<double> d = newton_step();
  const auto slope = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < d.size(); ++i) sum += gradient_[i] * d[i];
    return sum;
  };
  const double before = slope();
  if (!(before < 0.0)) return {0.0, false};
  const std::vector<double> from = c_;
  double length = 1.0;
  for (int k = 0; k < kMostHalvings; ++k) {
    for (std::size_t i = 0; i < d.size(); ++i) c_[i] = from[i] + length * d[i];
    if (keeps_limits(c_) && evaluate(c_, mu) && slope() < -0.5 * before) return {-before, true};
    length *= 0.6;
  }
  c_ = from;
  evaluate(c_, mu);
  return {-before, false};
}

// Whether the minimum was reached, near enough for the next barrier and for the gap.
bool SpeedSpline::centre(double mu) {
  evaluate(c_, mu);
  for (int k = 0; k < kMostSteps; ++k) {
    const Step taken = step(mu);
    if (taken.decrement <= kCentred * mu) return true;
    if (!taken.moved) return false;
  }
  return false;
}

bool SpeedSpline::find_fastest(double gap) {
  const auto barriers =
      static_cast<double>(cells() + 2 + points_.size() + 4 * rows_.size() + 2 * forces_.size());
  bool again = !c_.empty();
  if (!again || !shrink(kFewShrinks)) {
    again = false;
    c_ = slow_start();
    if (!shrink(kMostShrinks)) throw ArgumentError("No speed along this path keeps the limits.");
  }
  evaluate(c_, 0.0);
  double mu = (again ? kAgain : kWide) * time_ / barriers;
  for (;; mu *= kNarrower) {
    const bool is_centred = centre(mu);
    if (mu * barriers <= gap * time_) return is_centred;
  }
}

SpeedSpline::Rate SpeedSpline::rate_at(double u, std::size_t cell) const {
  const Basis here = basis(cell, u);
  const std::array<double, 3> own = {c_[cell], c_[cell + 1], c_[cell + 2]};
  return {std::sqrt(dot(here.value, own)), 0.5 * dot(here.rate, own)};
}

double SpeedSpline::time_between(double from, double to, std::size_t cell) const {
  // Gauss and Legendre's rule of five points.
  static constexpr std::array<double, 5> kPlaces = {-0.9061798459386640, -0.5384693101056831, 0.0,
                                                    0.5384693101056831, 0.9061798459386640};
  static constexpr std::array<double, 5> kWeights = {0.2369268850561891, 0.4786286704993665,
                                                     0.5688888888888889, 0.4786286704993665,
                                                     0.2369268850561891};
  const double half = 0.5 * (to - from);
  double time = 0.0;
  for (std::size_t k = 0; k < kPlaces.size(); ++k)
    time += kWeights[k] / rate_at(from + half * (1.0 + kPlaces[k]), cell).speed;
  return half * time;
}

}  // namespace armlet
