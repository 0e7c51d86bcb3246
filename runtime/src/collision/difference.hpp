// The Minkowski difference of two cores, and the searches in it.
#pragma once

#include <array>
#include <optional>

#include "armlet/collision/solid.hpp"

namespace armlet {

// The point of a core that is farthest along d, in its own frame.
Eigen::Vector3d core_support(const Solid& solid, const Eigen::Vector3d& d);

// A point of the difference, w = a - b, and the points of both cores with this difference; all in
// the frame of the first body.
struct DifferencePoint {
  Eigen::Vector3d w, a, b;
};

// The difference a - b of the cores of two bodies. It contains the origin exactly if they overlap,
// and its distance from the origin is the distance between them.
class CoreDifference {
 public:
  CoreDifference(const Solid& a, const Solid& b);

  // The point of the difference that is farthest along d.
  [[nodiscard]] DifferencePoint support(const Eigen::Vector3d& d) const;
  [[nodiscard]] const Eigen::Vector3d& p_a_b() const { return p_a_b_; }
  // A length for judging rounding errors, m.
  [[nodiscard]] double scale() const { return scale_; }

 private:
  const Solid& a_;
  const Solid& b_;
  Eigen::Matrix3d R_a_b_;
  Eigen::Vector3d p_a_b_;
  double scale_;
};

// 1 to 4 points of the difference, and the point of their hull that is nearest to the origin:
// w = sum weight_i w_i.
struct Simplex {
  std::array<DifferencePoint, 4> points;
  std::array<double, 4> weights{};
  int n = 0;
  Eigen::Vector3d w = Eigen::Vector3d::Zero();

  // Finds the nearest point and removes the points that it does not need. Returns whether the
  // origin is inside of four points, all of which are then kept.
  bool reduce();
  [[nodiscard]] bool has(const DifferencePoint& point) const;
  // Replaces the corners by the nearest point.
  void collapse();
};

// The result of the search for the nearest point.
//
// overlap   the cores overlap or touch.
// at_least  lower bound of the distance of the cores, m: a slab of this width across `away`, a unit
//           vector from the second body to the first, is between them.
struct Nearest {
  Simplex simplex;
  bool overlap = false;
  double at_least = 0.0;
  Eigen::Vector3d away = Eigen::Vector3d::UnitZ();
};

// The point of the difference that is nearest to the origin (Gilbert, Johnson, Keerthi). With a
// `question`, a distance, the search ends as soon as it is certain whether the cores are farther
// apart.
Nearest nearest_point(const CoreDifference& difference, std::optional<double> question = {});

// The smallest displacement that separates overlapping cores: of the first along -direction, by
// `depth`.
struct Depth {
  double depth = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

// Expands a polytope inside of the difference until a face of it is a face of the difference (van
// den Bergen). Every result separates the bodies; the smallest is known to 1e-7 m.
Depth least_depth(const CoreDifference& difference, const Simplex& around_origin);

}  // namespace armlet
