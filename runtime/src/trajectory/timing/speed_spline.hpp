// The squared speed along a path as a spline, and the fastest one within limits.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace armlet {

// b(u) = (du/dt)^2, a quadratic spline above zero, with the least duration, which is the integral
// of 1 / sqrt(b), under the conditions at every point
//
//   b < most,  |ya b' + yb b| < 1  and  |za b'' + zb b' + zc b| sqrt(b) < 1
//
// for every row of the point, and low < ya b' + yb b + v sqrt(b) < high for every force. A limit
// that is not convex (the third condition, and one side of a force with v) is replaced by its
// tangent, in 1 / sqrt(b) and in b, which is computed anew in each step of the interior point
// method; whether the limit itself is kept is checked before the step is taken.
class SpeedSpline {
 public:
  struct Point {
    std::size_t cell = 0;
    // derivatives of b, b', b'' by the coefficients
    std::array<double, 3> value{}, rate{}, curve{};
    double weight = 0.0;  // in the integral
    double most = std::numeric_limits<double>::infinity();
    std::size_t rows = 0, rows_end = 0;
    std::size_t forces = 0, forces_end = 0;
  };
  struct Row {
    double ya = 0.0, yb = 0.0, za = 0.0, zb = 0.0, zc = 0.0;
  };
  // low < 0 < high.
  struct Force {
    double ya = 0.0, yb = 0.0, v = 0.0, low = 0.0, high = 0.0;
  };
  // du/dt and its derivative by time.
  struct Rate {
    double speed, acceleration;
  };

  SpeedSpline() = default;
  // Knots ascend.
  explicit SpeedSpline(std::vector<double> knots);

  [[nodiscard]] std::size_t cells() const { return knots_.size() - 1; }
  // The u at a fraction of a cell, 0 to 1.
  [[nodiscard]] double at(std::size_t cell, double part) const;
  // The cell that contains u, searched from an earlier one.
  [[nodiscard]] std::size_t cell_at(double u, std::size_t cell) const;

  void clear_points();
  // weight  in the mean over the cell. The reference is valid until the next point.
  Point& add_point(std::size_t cell, double part, double weight);
  // Adds a row to the last point.
  void add_row(const Row& row);
  void add_force(const Force& force);

  // Finds the fastest spline, starting from an earlier result, if there is one.
  //
  // gap      allowed relative distance of the duration from the least at these points.
  // returns  false if the search ended before it was that near; the result keeps the limits.
  // throws   ArgumentError if nothing limits the speed.
  bool find_fastest(double gap);

  // Results, after find_fastest.
  [[nodiscard]] double duration() const { return time_; }
  [[nodiscard]] Rate rate_at(double u, std::size_t cell) const;
  // The time between two positions of a cell, s.
  [[nodiscard]] double time_between(double from, double to, std::size_t cell) const;

 private:
  // Basis functions of a cell at u, and their derivatives.
  struct Basis {
    std::array<double, 3> value, rate, curve;
  };
  [[nodiscard]] Basis basis(std::size_t cell, double u) const;
  [[nodiscard]] double room_of(const Point& point) const;
  [[nodiscard]] std::vector<double> slow_start() const;
  bool shrink(int most);
  [[nodiscard]] static std::array<double, 3> at(const Point& point, const std::vector<double>& c);
  [[nodiscard]] bool keeps_limits(const std::vector<double>& c) const;
  bool evaluate(const std::vector<double>& c, double mu);
  bool add_force_barriers(const Point& point, double mu, const std::array<double, 3>& b);
  bool add_barriers(const Point& point, double mu, const std::array<double, 3>& b);
  [[nodiscard]] std::vector<double> newton_step() const;
  // The squared Newton decrement before a step, and whether a step could be taken.
  struct Step {
    double decrement;
    bool moved;
  };
  Step step(double mu);
  bool centre(double mu);

  std::vector<double> knots_;
  std::vector<double> c_;  // coefficients of b: number of cells plus two
  std::vector<Point> points_;
  std::vector<Row> rows_;
  std::vector<Force> forces_;
  // The last evaluation: the duration, gradient and the upper half of the second derivatives.
  double time_ = 0.0;
  std::vector<double> gradient_;
  std::vector<std::array<double, 3>> hessian_;
  std::array<double, 3> g_{};  // of one point, by b, b', b''
  std::array<std::array<double, 3>, 3> h_{};
};

}  // namespace armlet
