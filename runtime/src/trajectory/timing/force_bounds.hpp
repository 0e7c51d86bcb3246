// Motor limits along a path: bounds on its acceleration that are linear in the squared speed.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// A bound on the acceleration u along a path that is linear in the squared speed x there: at_rest +
// slope x.
struct BoundLine {
  double at_rest = 0.0, slope = 0.0;
};

constexpr double kNoSlope = 1e-12;  // a coefficient below it does not restrict the acceleration

// Between two positions along a path: u is at most each of `upper` and at least each of `lower`,
// and x is at most x_most.
struct SpeedStrips {
  std::vector<BoundLine> upper, lower;
  double x_most = 0.0;

  // Adds a u + b x <= c. If a is nearly zero it is a limit of x.
  void add(double a, double b, double c);
  // Adds |a u + b x| <= c.
  void add_both(double a, double b, double c) {
    const double size = std::abs(a);
    if (size < kNoSlope) {
      if (std::abs(b) * x_most > c) x_most = std::max(c, 0.0) / std::abs(b);
      return;
    }
    const double at_rest = c / size, slope = -b / a;
    upper.push_back({at_rest, slope});
    lower.push_back({-at_rest, slope});
  }
};

// At a point of a path q(s) the forces of the joints are a u + b x + d sqrt(x) + g and dry
// friction, u being the acceleration along the path and x the squared speed.
struct ForceTerms {
  Eigen::VectorXd a, b, d, g;
};

// q              at the point.
// first, second  derivatives of q by s there.
// throws         ArgumentError where forces are beyond the range of numbers.
ForceTerms force_terms(const Robot& robot, const Eigen::VectorXd& q, const Eigen::VectorXd& first,
                       const Eigen::VectorXd& second);

// The smallest and largest dry friction of a joint with these rates; for Stribeck friction the
// larger of its values at rest and in motion.
struct DryFriction {
  double low = 0.0, high = 0.0;
};
DryFriction dry_friction(const Link& link, std::span<const double> rates);

// The motors of an arm along q(s). At path speed sqrt(x) and acceleration u along the path a joint
// takes the force
//
//   a(s) u + b(s) x + d(s) sqrt(x) + g(s) + t,
//
// a = M q', b = M q'' + (C(q, q') q'), d = viscous friction q', g = gravity, t = dry friction in
// the direction of the joint. Viscous friction is not linear in x: if it adds to the force its
// tangent replaces it, if it reduces the force its chord from rest to the highest speed there. Both
// are on the safe side. Dry friction with a Stribeck effect counts with the larger of its values at
// rest and in motion.
//
// source  K. G. Shin, N. D. McKay, Minimum-time control of robotic manipulators with geometric path
//         constraints, IEEE TAC 30(6), 1985.
class ForceBounds {
 public:
  // Keeps references to both.
  ForceBounds(const Robot& robot, const Trajectory& path);

  // Sets the positions and upper bounds of the squared speeds there. The tangents are those at half
  // of the highest speed.
  void lay(const std::vector<double>& s, const std::vector<double>& x_most);

  // Whether motors can hold the arm everywhere, and move it slowly.
  [[nodiscard]] bool hold() const { return holds_; }
  [[nodiscard]] bool have_viscous_friction() const { return have_viscous_friction_; }

  // Uses tangents to viscous friction at these squared speeds from now on, and chords up to `reach`
  // times them, reach > 1, which become the upper bounds. Squared speeds that kept the bounds
  // before still keep them.
  void linearise_at(const std::vector<double>& x, double reach);

  // Adds the bounds between position k and the next; `twice` is 2 (s[k + 1] - s[k]).
  void add_to(SpeedStrips& strips, std::size_t k, double twice) const;

  // The largest ratio of a joint's force to its limit at s.
  [[nodiscard]] double share(double s, double x, double u) const;
  // Reduces the limits in interval k by the excess of a joint there; returns the excess as a factor
  // of time.
  double tighten(std::size_t k, double s, double x, double u);

 private:
  [[nodiscard]] DryFriction dry_within(std::size_t k, Eigen::Index i) const;
  [[nodiscard]] Eigen::VectorXd forces_at(double s, double x, double u) const;
  void add_row(SpeedStrips& strips, std::size_t position, Eigen::Index i, double dry, double limit,
               double sign, double twice) const;
  void check_holding();

  const Robot& robot_;
  const Trajectory& path_;
  Eigen::VectorXd limits_;
  bool have_viscous_friction_ = false;
  std::vector<double> s_, x_most_, tangent_at_, chord_to_;
  std::vector<ForceTerms> at_;                 // by position
  std::vector<Eigen::VectorXd> less_;          // by interval: reduction of the limits
  std::vector<std::vector<DryFriction>> dry_;  // by interval, then by joint
  bool holds_ = true;
};

}  // namespace armlet
