#include "armlet/cell/motion.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/cell/clock.hpp"

namespace armlet {
namespace {

constexpr double kLongestPiece = 1e-3;  // s
constexpr double kSlack = 1e-9;         // relative, of an acceleration
constexpr double kSameTime = 1e-9;      // s, resolution of the clock
constexpr std::size_t kMostPieces = 200'000;

}  // namespace

Motion::Motion(Trajectory trajectory, std::int64_t start_ns)
    : trajectory_(std::move(trajectory)),
      start_ns_(start_ns),
      end_ns_(start_ns + to_ns(trajectory_.duration())),
      u_end_(trajectory_.duration()) {}

bool Motion::stands_at(double u) const {
  for (int i = 0; i < trajectory_.n(); ++i) {
    if (trajectory_.value(i, u, 1) != 0.0) return false;
  }
  return true;
}

Eigen::VectorXd Motion::allowed(const Eigen::VectorXd& max_accel) const {
  Eigen::VectorXd limits = max_accel;
  for (int i = 0; i < trajectory_.n(); ++i)
    limits[i] = std::max(limits[i], trajectory_.peak(i, 2)) * (1.0 + kSlack);
  return limits;
}

// The steepest slope of the rate at the start of a piece: the joint has the acceleration
// q'' rate^2 + q' slope. As |q''| is allowed at rate 1, slope 0 always is.
double Motion::steepest(const Piece& at, const Eigen::VectorXd& allowed) const {
  double slope = -at.rate / kSameTime;  // stands at once
  for (int i = 0; i < trajectory_.n(); ++i) {
    const double speed = trajectory_.value(i, at.u, 1);
    const double bend = trajectory_.value(i, at.u, 2) * at.rate * at.rate;
    if (speed > 0.0) slope = std::max(slope, (-allowed[i] - bend) / speed);
    if (speed < 0.0) slope = std::max(slope, (allowed[i] - bend) / speed);
  }
  return std::min(slope, 0.0);
}

// Sampled, because the product has no handy extremes; a piece is short against what it follows.
bool Motion::fits(const Piece& piece, const Eigen::VectorXd& allowed) const {
  constexpr int kSamples = 4;
  constexpr double kInside = 1e-3;  // where an acceleration jumps, the side that counts
  for (int k = 0; k <= kSamples; ++k) {
    const double dt = piece.duration * std::max(static_cast<double>(k) / kSamples, kInside);
    const double u = piece.u_at(dt);
    const double rate = piece.rate_at(dt);
    for (int i = 0; i < trajectory_.n(); ++i) {
      const double accel =
          trajectory_.value(i, u, 2) * rate * rate + trajectory_.value(i, u, 1) * piece.slope;
      if (std::abs(accel) > allowed[i]) return false;
    }
  }
  return true;
}

// The next piece from a state, at most `longest` path time long; nothing if it would reach the end
// of the path.
std::optional<Motion::Piece> Motion::next_piece(const Piece& at, double longest,
                                                const Eigen::VectorXd& allowed) const {
  constexpr int kHalvings = 8;
  Piece piece = at;
  piece.duration =
      std::min(std::min(kLongestPiece, 0.01 * trajectory_.duration()), longest / piece.rate);
  piece.slope = steepest(piece, allowed);
  if (piece.rate_at(piece.duration) < 0.0) piece.duration = piece.rate / -piece.slope;
  if (!fits(piece, allowed)) {
    // What the start allows is too much further on; the steepest slope that fits lies in between.
    const double too_steep = piece.slope;
    double fraction = 0.0;
    double step = 0.5;
    for (int i = 0; i < kHalvings; ++i, step *= 0.5) {
      piece.slope = too_steep * (fraction + step);
      if (fits(piece, allowed)) fraction += step;
    }
    piece.slope = too_steep * fraction;
  }
  if (piece.u_at(piece.duration) >= trajectory_.duration() - kSameTime) return std::nullopt;
  return piece;
}

void Motion::stop(std::int64_t t_ns, const Eigen::VectorXd& max_accel) {
  if (stop_ns_ != kNever || t_ns >= end_ns_) return;
  stop_ns_ = t_ns;
  Piece at{.t = 0.0, .u = to_seconds(t_ns - start_ns_), .rate = 1.0, .slope = 0.0, .duration = 0.0};
  if (stands_at(at.u)) {
    end_ns_ = t_ns;
    u_end_ = at.u;
    return;
  }
  const Eigen::VectorXd limits = allowed(max_accel);
  const std::vector<double> knots = trajectory_.knots();
  constexpr double kStands = 1e-9;  // of the rate, where rounding keeps it from zero
  while (at.rate > kStands) {
    // Accelerations may jump between the pieces of the trajectory, so none of ours spans two.
    const auto knot = std::ranges::upper_bound(knots, at.u + kSameTime);
    const double longest = knot == knots.end() ? kLongestPiece : *knot - at.u;
    const auto piece = next_piece(at, longest, limits);
    if (!piece || slowing_.size() >= kMostPieces) {
      slowing_.clear();  // arriving is as quick as stopping
      return;
    }
    slowing_.push_back(*piece);
    at = {.t = piece->t + piece->duration,
          .u = piece->u_at(piece->duration),
          .rate = piece->rate_at(piece->duration),
          .slope = 0.0,
          .duration = 0.0};
  }
  end_ns_ = t_ns + to_ns(at.t);
  u_end_ = at.u;
}

void Motion::sample(std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd,
                    Eigen::VectorXd& qdd) const {
  if (t_ns >= end_ns_) {
    trajectory_.sample(u_end_, q, qd, qdd);
    qd.setZero();
    qdd.setZero();
  } else if (slowing_.empty() || t_ns <= stop_ns_) {
    trajectory_.sample(to_seconds(t_ns - start_ns_), q, qd, qdd);
  } else {
    const double t = to_seconds(t_ns - stop_ns_);
    const auto behind = std::ranges::upper_bound(slowing_, t, {}, &Piece::t);
    const Piece& piece = *(behind - 1);
    const double dt = std::min(t - piece.t, piece.duration);
    const double rate = piece.rate_at(dt);
    trajectory_.sample(piece.u_at(dt), q, qd, qdd);
    qdd = qdd * (rate * rate) + qd * piece.slope;
    qd *= rate;
  }
}

}  // namespace armlet
