#include "armlet/trajectory/accelerations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

// The coefficients of the second derivative of a piece, for the time from `u` seconds after its
// start.
Segment accelerations_from(const Segment& piece, double u) {
  Segment a;
  a.degree = std::max(piece.degree - 2, 0);
  for (int k = 0; k + 2 <= piece.degree; ++k)
    a.c[static_cast<std::size_t>(k)] =
        (k + 1.0) * (k + 2.0) * piece.c[static_cast<std::size_t>(k + 2)];
  // Repeated Horner scheme: the coefficients of the polynomial about the new start (D. E. Knuth,
  // The Art of Computer Programming 2, 1997, section 4.6.4).
  for (int low = 0; low < a.degree; ++low) {
    for (int k = a.degree - 1; k >= low; --k)
      a.c[static_cast<std::size_t>(k)] += u * a.c[static_cast<std::size_t>(k + 1)];
  }
  return a;
}

}  // namespace

std::vector<Segment> acceleration_pieces(const Trajectory& motion, int i) {
  if (i < 0 || i >= motion.n()) {
    throw ArgumentError(fmt::format("There is no joint {}; the motion has {}.", i, motion.n()));
  }
  const std::vector<double> knots = motion.knots();
  const std::vector<Segment>& pieces = motion.joint(i).segments;
  std::vector<Segment> accelerations;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double middle = 0.5 * (knots[k] + knots[k + 1]);
    const auto piece =
        std::ranges::find_if(pieces, [middle](const Segment& each) { return middle < each.end(); });
    Segment a =
        piece == pieces.end() ? Segment{} : accelerations_from(*piece, knots[k] - piece->start);
    a.start = knots[k];
    a.duration = knots[k + 1] - knots[k];
    accelerations.push_back(a);
  }
  return accelerations;
}

}  // namespace armlet
