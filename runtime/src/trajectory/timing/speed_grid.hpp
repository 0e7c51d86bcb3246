// Where the speed along a path is looked for, and what limits it there.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/timing/course.hpp"
#include "trajectory/timing/force_bounds.hpp"

namespace armlet {

constexpr double kSameKnot = 1e-9;  // as in Trajectory::knots

// The piece that begins at a position or goes on behind it; knots of different joints that differ
// by rounding are one position. `piece` is one before.
std::size_t piece_behind(std::span<const Segment> pieces, std::size_t piece, double s);

// Positions along the path: its knots, where zones begin and end, and enough in between.
std::vector<double> positions_along(const Course& course, int intervals);

// First and second derivative of a path.
struct PathSlopes {
  double first = 0.0, second = 0.0;
};

class SpeedGrid {
 public:
  SpeedGrid(const Course& course, std::vector<double> positions);

  // Makes limits stricter where a run exceeds them between the positions; by how much the worst is
  // exceeded, as a factor of time.
  double tighten(const std::vector<double>& x);

  // How far a run stays below all limits in each interval, as a part of them.
  [[nodiscard]] std::vector<double> idle(const std::vector<double>& x) const;

  [[nodiscard]] const std::vector<double>& s() const { return s_; }

  // The motors; null: they do not count.
  [[nodiscard]] ForceBounds* motors() { return motors_.get(); }

  // What holds between position k and the next: the limits at k, and those at k + 1 with the speed
  // reached there.
  const SpeedStrips& between(std::size_t k);

  // The u between all strips at x: the lowest upper and highest lower bound.
  struct Range {
    BoundLine lower, upper;  // the lines
    double least = -kUnbounded, most = kUnbounded;
  };
  [[nodiscard]] Range range(double x) const;

  static constexpr double kUnbounded = 1e100;

 private:
  // By how much limits are exceeded in an interval, so that they are divided by it.
  struct Over {
    double speed = 1.0, acceleration = 1.0;
  };
  // The run at a part of an interval.
  struct Spot {
    double s, x, u;
  };
  [[nodiscard]] Spot spot_at(std::size_t k, double part, const std::vector<double>& x) const;
  // The highest squared speed of the speed limits at a position, where zones meet that of both.
  [[nodiscard]] double speed_bound(std::size_t k) const;
  void fill(std::span<const Segment> pieces, std::size_t stride, double* first,
            double* second) const;
  void look(const Spot& spot, std::vector<std::size_t>& piece, Over& over) const;

  Course course_;
  std::vector<double> s_;
  std::span<const AxisLimits> limits_;
  std::span<const SpeedZone> zones_;
  std::size_t n_;
  std::vector<double> first_, second_;  // by position, then by joint
  std::vector<double> travel_first_, travel_second_;
  std::vector<Over> over_;     // by interval
  std::vector<double> bound_;  // squared speed
  std::unique_ptr<ForceBounds> motors_;
  SpeedStrips strips_;
};

}  // namespace armlet
