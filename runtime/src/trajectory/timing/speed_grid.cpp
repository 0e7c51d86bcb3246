#include "trajectory/timing/speed_grid.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"

namespace armlet {
namespace {

PathSlopes slopes_at(const Segment& p, double s) {
  const double u = s - p.start;
  return {p.c[1] + u * (2.0 * p.c[2] + u * 3.0 * p.c[3]), 2.0 * p.c[2] + 6.0 * u * p.c[3]};
}

}  // namespace

std::size_t piece_behind(std::span<const Segment> pieces, std::size_t piece, double s) {
  while (piece + 1 < pieces.size() && pieces[piece + 1].start <= s + kSameKnot) ++piece;
  return piece;
}

std::vector<double> positions_along(const Course& course, int intervals) {
  std::vector<double> knots = course.path.knots();
  for (const SpeedZone& zone : course.zones) {
    for (const double border : {zone.from, zone.to}) {
      const auto behind = std::ranges::lower_bound(knots, border - kSameKnot);
      if (behind == knots.end() || *behind <= border + kSameKnot) continue;
      if (behind != knots.begin()) knots.insert(behind, border);
    }
  }
  const double widest = course.path.duration() / intervals;
  std::vector<double> s = {0.0};
  s.reserve(static_cast<std::size_t>(intervals) + knots.size() + 1);
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double length = knots[k + 1] - knots[k];
    const int parts = std::max(1, static_cast<int>(std::ceil(length / widest - 1e-9)));
    for (int j = 1; j < parts; ++j) s.push_back(knots[k] + length * j / parts);
    s.push_back(knots[k + 1]);
  }
  return s;
}

SpeedGrid::SpeedGrid(const Course& course, std::vector<double> positions)
    : course_(course),
      s_(std::move(positions)),
      limits_(course.limits),
      zones_(course.zones),
      n_(course.limits.size()) {
  const std::size_t count = s_.size();
  first_.resize(count * n_);
  second_.resize(count * n_);
  for (std::size_t i = 0; i < n_; ++i) {
    const std::vector<Segment>& pieces = course.path.joint(static_cast<int>(i)).segments;
    fill(pieces, n_, &first_[i], &second_[i]);
  }
  travel_first_.assign(count, 1.0);
  travel_second_.assign(count, 0.0);
  if (!course.travel.empty()) fill(course.travel, 1, travel_first_.data(), travel_second_.data());
  over_.assign(count, {});
  bound_.resize(count);
  for (std::size_t k = 0; k < count; ++k) bound_[k] = speed_bound(k);
  if (course.arm == nullptr) return;
  motors_ = std::make_unique<ForceBounds>(*course.arm, course.path);
  motors_->lay(s_, bound_);
}

double SpeedGrid::tighten(const std::vector<double>& x) {
  double worst = 1.0;
  std::vector<std::size_t> piece(n_ + 1, 0);
  for (std::size_t k = 0; k + 1 < s_.size(); ++k) {
    Over over;
    for (const double part : {0.2, 0.5, 0.8}) {
      const Spot spot = spot_at(k, part, x);
      look(spot, piece, over);
      if (motors_ != nullptr) worst = std::max(worst, motors_->tighten(k, spot.s, spot.x, spot.u));
    }
    over_[k].speed *= over.speed;
    over_[k].acceleration *= over.acceleration;
    worst = std::max({worst, over.speed, std::sqrt(over.acceleration)});
  }
  for (std::size_t k = 0; k < s_.size(); ++k) bound_[k] = speed_bound(k);
  return worst;
}

std::vector<double> SpeedGrid::idle(const std::vector<double>& x) const {
  std::vector<double> out;
  std::vector<std::size_t> piece(n_ + 1, 0);
  for (std::size_t k = 0; k + 1 < s_.size(); ++k) {
    double least = 1.0;
    for (const double part : {0.01, 0.5, 0.99}) {
      const Spot spot = spot_at(k, part, x);
      Over load{0.0, 0.0};
      look(spot, piece, load);
      double most = std::max(load.speed, load.acceleration);
      if (motors_ != nullptr) most = std::max(most, motors_->share(spot.s, spot.x, spot.u));
      least = std::min(least, most);
    }
    out.push_back(1.0 - least);
  }
  return out;
}

double SpeedGrid::speed_bound(std::size_t k) const {
  double least = std::sqrt(kUnbounded);
  for (const SpeedZone& zone : zones_) {
    const bool inside = s_[k] >= zone.from - kSameKnot && s_[k] <= zone.to + kSameKnot;
    const double slope = std::abs(travel_first_[k]);
    if (inside && slope * least > zone.speed) least = zone.speed / slope;
  }
  for (std::size_t i = 0; i < n_; ++i) {
    const double slope = std::abs(first_[k * n_ + i]);
    if (slope * least > limits_[i].speed) least = limits_[i].speed / slope;
  }
  least /= std::max(over_[k].speed, k > 0 ? over_[k - 1].speed : 1.0);
  return least * least;
}

const SpeedStrips& SpeedGrid::between(std::size_t k) {
  checkpoint(40 * n_);
  const double twice = 2.0 * (s_[k + 1] - s_[k]);
  strips_.upper.clear();
  strips_.lower.clear();
  strips_.x_most = bound_[k];
  for (std::size_t i = 0; i < n_; ++i) {
    const double A = limits_[i].acceleration / over_[k].acceleration;
    if (!std::isfinite(A)) continue;
    strips_.add_both(first_[k * n_ + i], second_[k * n_ + i], A);
    const double curve = second_[(k + 1) * n_ + i];
    strips_.add_both(first_[(k + 1) * n_ + i] + twice * curve, curve, A);
  }
  for (const SpeedZone& zone : zones_) {
    const bool overlaps = s_[k + 1] > zone.from + kSameKnot && s_[k] < zone.to - kSameKnot;
    if (!overlaps || !std::isfinite(zone.acceleration)) continue;
    const double A = zone.acceleration / over_[k].acceleration;
    strips_.add_both(travel_first_[k], travel_second_[k], A);
    strips_.add_both(travel_first_[k + 1] + twice * travel_second_[k + 1], travel_second_[k + 1],
                     A);
  }
  if (motors_ != nullptr) motors_->add_to(strips_, k, twice);
  return strips_;
}

SpeedGrid::Range SpeedGrid::range(double x) const {
  Range r;
  // Values are selected without branches: the active line differs at each position, so branches
  // would be mispredicted.
  const BoundLine* best = &r.upper;
  for (const BoundLine& line : strips_.upper) {
    const double u = line.at_rest + line.slope * x;
    best = u < r.most ? &line : best;
    r.most = u < r.most ? u : r.most;
  }
  r.upper = *best;
  best = &r.lower;
  for (const BoundLine& line : strips_.lower) {
    const double u = line.at_rest + line.slope * x;
    best = u > r.least ? &line : best;
    r.least = u > r.least ? u : r.least;
  }
  r.lower = *best;
  return r;
}

// Derivatives at all positions; for a curve without pieces they are zero.
void SpeedGrid::fill(std::span<const Segment> pieces, std::size_t stride, double* first,
                     double* second) const {
  std::size_t piece = 0;
  for (std::size_t k = 0; k < s_.size(); ++k) {
    PathSlopes slopes;
    if (!pieces.empty()) {
      piece = piece_behind(pieces, piece, s_[k]);
      slopes = slopes_at(pieces[piece], s_[k]);
    }
    first[k * stride] = slopes.first;
    second[k * stride] = slopes.second;
  }
}

SpeedGrid::Spot SpeedGrid::spot_at(std::size_t k, double part, const std::vector<double>& x) const {
  const double length = s_[k + 1] - s_[k];
  return {.s = s_[k] + part * length,
          .x = x[k] + part * (x[k + 1] - x[k]),
          .u = (x[k + 1] - x[k]) / (2.0 * length)};
}

// Computes the excess at a spot.
void SpeedGrid::look(const Spot& spot, std::vector<std::size_t>& piece, Over& over) const {
  const double speed = std::sqrt(spot.x);
  const auto compare = [&](const PathSlopes& slopes, double V, double A) {
    over.speed = std::max(over.speed, std::abs(slopes.first) * speed / V);
    const double a = std::abs(slopes.first * spot.u + slopes.second * spot.x);
    over.acceleration = std::max(over.acceleration, a / A);
  };
  for (std::size_t i = 0; i < n_; ++i) {
    const std::vector<Segment>& pieces = course_.path.joint(static_cast<int>(i)).segments;
    if (pieces.empty()) continue;
    piece[i] = piece_behind(pieces, piece[i], spot.s);
    compare(slopes_at(pieces[piece[i]], spot.s), limits_[i].speed, limits_[i].acceleration);
  }
  PathSlopes travel{1.0, 0.0};
  if (!course_.travel.empty()) {
    piece[n_] = piece_behind(course_.travel, piece[n_], spot.s);
    travel = slopes_at(course_.travel[piece[n_]], spot.s);
  }
  for (const SpeedZone& zone : zones_) {
    if (spot.s > zone.from && spot.s < zone.to) compare(travel, zone.speed, zone.acceleration);
  }
}

}  // namespace armlet
