#include "trajectory/sample_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "math/det_lanes.hpp"

namespace armlet {
namespace {

using det::Lanes;

constexpr std::size_t kFewPieces = 16;  // up to here starts are counted without a search
constexpr std::size_t kCellsPerPiece = 2;
constexpr std::uint32_t kFewInCell = 4;
constexpr double kNever = std::numeric_limits<double>::infinity();

std::size_t even(std::size_t n) { return n + (n & 1); }

Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

struct LaneSample {
  Lanes q, qd, half_qdd;
};

// Horner's scheme for the value and, from its partial sums, both derivatives in one pass. The first
// two steps omit additions to zero.
//
// c(k)  the coefficients of the power k.
template <int kDegree, class Coefficients>
[[gnu::always_inline]] inline LaneSample horner(const Coefficients& c, Lanes u) {
  static_assert(kDegree >= 2);
  LaneSample s{c(kDegree) * u + c(kDegree - 1), c(kDegree), c(kDegree)};
  s.qd = s.qd * u + s.q;
  s.q = s.q * u + c(kDegree - 2);
#pragma GCC unroll 8
  for (int k = kDegree - 3; k >= 0; --k) {
    s.half_qdd = s.half_qdd * u + s.qd;
    s.qd = s.qd * u + s.q;
    s.q = s.q * u + c(k);
  }
  return s;
}

// The state of joints i and i + 1, of which the second may not exist.
[[gnu::always_inline]] inline void store(const StateOut& out, std::size_t i, std::size_t n,
                                         const LaneSample& s) {
  const Lanes qdd = 2.0 * s.half_qdd;
  const std::size_t size = i + 1 < n ? sizeof(Lanes) : sizeof(double);
  if (size == sizeof(Lanes)) {
    std::memcpy(out.q + i, &s.q, sizeof(Lanes));
    std::memcpy(out.qd + i, &s.qd, sizeof(Lanes));
    std::memcpy(out.qdd + i, &qdd, sizeof(Lanes));
  } else {
    out.q[i] = s.q[0];
    out.qd[i] = s.qd[0];
    out.qdd[i] = qdd[0];
  }
}

bool stands(const JointPath& path) { return path.segments.empty(); }

// A joint without pieces reads this polynomial, and its result is not used.
constexpr Segment kNoPiece{};

const Segment& piece_of(const JointPath& path, std::size_t k) {
  return stands(path) ? kNoPiece : path.segments[k];
}

bool same_starts(const JointPath& a, const JointPath& b) {
  return std::ranges::equal(a.segments, b.segments, {}, &Segment::start, &Segment::start);
}

// Before the start: the first positions at rest.
void sample_before(std::span<const JointPath> joints, const StateOut& out) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointPath& path = joints[i];
    out.q[i] = stands(path) ? path.q_end : path.segments.front().c[0];
    out.qd[i] = out.qdd[i] = 0.0;
  }
}

}  // namespace

SampleTable::SampleTable(std::span<const JointPath> joints, double duration) {
  ends_.reserve(even(joints.size()));
  goals_.reserve(even(joints.size()));
  const auto moving = std::ranges::find_if_not(joints, stands);
  first_end_ = moving == joints.end() ? -1.0 : duration;
  for (const JointPath& path : joints) {
    const double end = stands(path) ? -1.0 : std::min(path.segments.back().end(), duration);
    ends_.push_back(end);
    goals_.push_back(path.q_end);
    if (stands(path)) continue;
    first_end_ = std::min(first_end_, end);
    most_pieces_ = std::max(most_pieces_, path.segments.size());
    for (const Segment& piece : path.segments) degree_ = std::max(degree_, piece.degree);
    shared_ = shared_ && same_starts(*moving, path);
  }
  ends_.resize(even(joints.size()), -1.0);
  goals_.resize(even(joints.size()), 0.0);
  if (!shared_) {
    index_each(joints);
  } else if (most_pieces_ > 0) {
    index_shared(*moving);
    copy_polynomials(joints);
  }
}

// There are so many cells that few pieces begin in one, unless some pieces are much shorter than
// others.
void SampleTable::index_shared(const JointPath& path) {
  const std::size_t pieces = path.segments.size();
  starts_.reserve(pieces + 1);
  for (const Segment& piece : path.segments) starts_.push_back(piece.start);
  starts_.push_back(kNever);
  const std::size_t count = kCellsPerPiece * pieces;
  cells_per_second_ = static_cast<double>(count) / path.segments.back().end();
  if (pieces <= kFewPieces || !std::isfinite(cells_per_second_)) return;
  cells_.reserve(count + 2);
  std::uint32_t piece = 0;
  for (std::size_t cell = 0; cell <= count + 1; ++cell) {
    const std::uint32_t before = piece;
    // The index of a cell, computed from t as a search does. A piece that begins in a cell
    // therefore begins no earlier than the pieces of the cells before.
    while (starts_[piece + 1] * cells_per_second_ < static_cast<double>(cell)) ++piece;
    cells_.push_back(piece);
    most_in_cell_ = std::max(most_in_cell_, piece - before);
  }
}

void SampleTable::copy_polynomials(std::span<const JointPath> joints) {
  const auto powers = static_cast<std::size_t>(degree_) + 1;
  polynomials_.resize((starts_.size() - 1) * even(joints.size()) * powers);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    double* to = polynomials_.data() + (i / 2) * 2 * powers + i % 2;
    for (std::size_t piece = 0; piece + 1 < starts_.size(); ++piece) {
      if (stands(joints[i])) {
        to[0] = joints[i].q_end;
      } else {
        const auto& c = joints[i].segments[piece].c;
        for (std::size_t k = 0; k < powers; ++k) to[2 * k] = c[k];
      }
      to += even(joints.size()) * powers;
    }
  }
}

void SampleTable::index_each(std::span<const JointPath> joints) {
  if (most_pieces_ > kFewPieces) return;
  const std::size_t width = even(joints.size());
  later_starts_.assign(width * (most_pieces_ - 1), kNever);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& pieces = joints[i].segments;
    for (std::size_t k = 1; k < pieces.size(); ++k)
      later_starts_[(k - 1) * width + i] = pieces[k].start;
  }
}

// The last piece that begins at t or before, for 0 <= t.
std::size_t SampleTable::shared_piece(double t) const {
  const double* starts = starts_.data();
  const std::size_t last = starts_.size() - 2;
  std::size_t piece = 0;
  if (cells_.empty()) {  // counting needs no branch that could be mispredicted
    for (std::size_t k = 1; k <= last; ++k) piece += starts[k] <= t ? 1 : 0;
    return piece;
  }
  t = std::min(t, starts[last]);
  const auto cell = static_cast<std::size_t>(t * cells_per_second_);
  piece = cells_[cell];
  // Nor does this: the number of steps does not depend on the time.
  if (most_in_cell_ <= kFewInCell) {
    for (std::uint32_t k = 0; k < most_in_cell_; ++k) piece += starts[piece + 1] <= t ? 1 : 0;
    return piece;
  }
  const double* after = std::upper_bound(starts + piece + 1, starts + cells_[cell + 1] + 1, t);
  return static_cast<std::size_t>(after - starts) - 1;
}

// Samples all joints in the same piece.
template <int kDegree>
void SampleTable::sample_moving(double t, std::size_t n, const StateOut& out) const {
  constexpr std::size_t kPowers = kDegree + 1;
  const std::size_t piece = shared_piece(t);
  const double after = t - starts_[piece];
  const Lanes u = {after, after};
  const double* c = polynomials_.data() + piece * even(n) * kPowers;
  for (std::size_t i = 0; i < n; i += 2) {
    store(out, i, n, horner<kDegree>([c](int k) { return load(c + 2 * k); }, u));
    c += 2 * kPowers;
  }
}

// Samples every joint in its own piece, or at its end.
template <int kDegree>
void SampleTable::sample_any(std::span<const JointPath> joints, double t,
                             const StateOut& out) const {
  const std::size_t n = joints.size();
  const std::size_t width = even(n);
  const Lanes now = {t, t};
  const std::size_t common = shared_ && most_pieces_ > 0 ? shared_piece(t) : 0;
  const auto own_piece = [&](std::size_t i) -> const Segment& {
    const auto& pieces = joints[i].segments;
    if (pieces.empty()) return kNoPiece;
    const auto after =
        std::upper_bound(pieces.begin() + 1, pieces.end(), t,
                         [](double time, const Segment& piece) { return time < piece.start; });
    return *(after - 1);
  };
  for (std::size_t i = 0; i < n; i += 2) {
    const std::size_t next = std::min(i + 1, n - 1);
    const Segment *a, *b;
    if (shared_) {
      a = &piece_of(joints[i], common);
      b = &piece_of(joints[next], common);
    } else if (most_pieces_ <= kFewPieces) {
      det::LaneBits<Lanes> behind = {};
      for (std::size_t k = i; k < later_starts_.size(); k += width)
        behind -= load(later_starts_.data() + k) <= now;
      a = &piece_of(joints[i], static_cast<std::size_t>(behind[0]));
      b = &piece_of(joints[next], static_cast<std::size_t>(behind[1]));
    } else {
      a = &own_piece(i);
      b = &own_piece(next);
    }
    const Lanes after = now - Lanes{a->start, b->start};
    const Lanes lengths = {a->duration, b->duration};
    const auto power = [a, b](int k) {
      return Lanes{a->c[static_cast<std::size_t>(k)], b->c[static_cast<std::size_t>(k)]};
    };
    LaneSample s = horner<kDegree>(power, after < lengths ? after : lengths);
    const Lanes end = load(ends_.data() + i);
    s.q = now < end ? s.q : load(goals_.data() + i);
    s.qd = now <= end ? s.qd : Lanes{};
    s.half_qdd = now <= end ? s.half_qdd : Lanes{};
    store(out, i, n, s);
  }
}

template <int kDegree>
void SampleTable::sample_as(std::span<const JointPath> joints, double t,
                            const StateOut& out) const {
  if (shared_ && t < first_end_) return sample_moving<kDegree>(t, joints.size(), out);
  sample_any<kDegree>(joints, t, out);
}

void SampleTable::sample(std::span<const JointPath> joints, double t, const StateOut& out) const {
  if (!(t >= 0.0)) return sample_before(joints, out);
  switch (degree_) {
    case 3:
      return sample_as<3>(joints, t, out);
    case 4:
      return sample_as<4>(joints, t, out);
    case 5:
      return sample_as<5>(joints, t, out);
    case 6:
      return sample_as<6>(joints, t, out);
    case 7:
      return sample_as<7>(joints, t, out);
    default:
      return sample_as<2>(joints, t, out);
  }
}

}  // namespace armlet
