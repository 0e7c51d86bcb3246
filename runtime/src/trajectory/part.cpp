#include "armlet/trajectory/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"

namespace armlet {
namespace {

constexpr double kNothing = 1e-12;  // s; shorter pieces are dropped

// The rest of a piece from `u` seconds after its start, as a polynomial in the time from there.
Segment shifted(const Segment& piece, double u, double start, double duration) {
  Segment out{.start = start, .duration = duration, .degree = piece.degree};
  double factorial = 1.0;
  for (int k = 0; k <= piece.degree; ++k) {
    if (k > 0) factorial *= k;
    out.c[static_cast<std::size_t>(k)] = piece.value(u, k) / factorial;
  }
  return out;
}

}  // namespace

Trajectory part_of(const Trajectory& motion, double from, double to) {
  const bool inside = std::isfinite(from) && std::isfinite(to) && from >= 0.0 && from <= to;
  if (!inside || from > motion.duration()) {
    throw ArgumentError(fmt::format("There is no part from {} s to {} s of a motion of {} s.", from,
                                    to, motion.duration()));
  }
  std::vector<JointPath> joints;
  double longest = 0.0;
  for (int i = 0; i < motion.n(); ++i) {
    JointPath path{.q_end = motion.value(i, to)};
    double at = 0.0;
    for (const Segment& piece : motion.joint(i).segments) {
      const double begin = std::max(piece.start, from);
      const double duration = std::min(piece.end(), to) - begin;
      if (duration <= kNothing) continue;
      path.segments.push_back(shifted(piece, begin - piece.start, at, duration));
      at = path.segments.back().end();
    }
    longest = std::max(longest, at);
    joints.push_back(std::move(path));
  }
  return {std::move(joints), std::max(longest, std::min(to, motion.duration()) - from)};
}

}  // namespace armlet
