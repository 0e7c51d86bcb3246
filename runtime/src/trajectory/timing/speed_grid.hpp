// The positions for the speed along a path, and the limits there.
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

// The piece that begins at a position or contains the interval after it; knots of different joints
// that differ by rounding count as one position. `piece` is an earlier one.
std::size_t piece_behind(std::span<const Segment> pieces, std::size_t piece, double s);

// Positions along the path: its knots, the ends of zones, and enough in between.
std::vector<double> positions_along(const Course& course, int intervals);

// First and second derivative of a path.
struct PathSlopes {
  double first = 0.0, second = 0.0;
};

class SpeedGrid {
 public:
  SpeedGrid(const Course& course, std::vector<double> positions);

  // Reduces limits that a motion exceeds between the positions; returns the largest excess, as a
  // factor of time.
  double tighten(const std::vector<double>& x);

  // The relative distance of a motion from all limits in each interval.
  [[nodiscard]] std::vector<double> idle(const std::vector<double>& x) const;

  [[nodiscard]] const std::vector<double>& s() const { return s_; }

  // The motors; null: no force limits.
  [[nodiscard]] ForceBounds* motors() { return motors_.get(); }

  // The limits between position k and the next: those at k, and those at k + 1 with the speed
  // there.
  const SpeedStrips& between(std::size_t k);

  // The range of u within all strips at x: the lowest upper and highest lower bound.
  struct Range {
    BoundLine lower, upper;  // the lines
    double least = -kUnbounded, most = kUnbounded;
  };
  [[nodiscard]] Range range(double x) const;

  static constexpr double kUnbounded = 1e100;

 private:
  // The factors by which limits are exceeded in an interval, and by which they are then divided.
  struct Over {
    double speed = 1.0, acceleration = 1.0;
  };
  // The motion at a fraction of an interval.
  struct Spot {
    double s, x, u;
  };
  [[nodiscard]] Spot spot_at(std::size_t k, double part, const std::vector<double>& x) const;
  // The highest squared speed of the speed limits at a position; where zones meet, the lower of
  // both.
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
