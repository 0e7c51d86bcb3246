#include <algorithm>
#include <cmath>

#include "collision/difference.hpp"
#include "collision/mesh_gap.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

// Moves points of the cores to the surfaces of the bodies along `away`.
Gap gap_at(const Solid& a, const Solid& b, double distance, const Vector3d& p_a,
           const Vector3d& p_b, const Vector3d& away) {
  const Vector3d out = a.T.linear() * away;
  return {.distance = distance - a.margin - b.margin,
          .p_a = a.T * p_a - a.margin * out,
          .p_b = a.T * p_b + b.margin * out,
          .away = out};
}

// The pair of deepest points: after `a` has moved along `away` by the depth, and a little more so
// that the cores are certainly apart, these points are the nearest ones. The points of the
// polytope's face cannot be used: where several of its triangles are in one plane, the point may be
// outside of the triangle that was found.
Gap overlapping(const Solid& a, const Solid& b, const CoreDifference& difference,
                const Simplex& simplex) {
  constexpr double kFree = 2e-7;  // m, and relative to the bodies
  const Depth least = least_depth(difference, simplex);
  const Vector3d away = -least.direction;
  Solid moved = a;
  moved.T.translation() +=
      a.T.linear() * ((least.depth + kFree * std::max(1.0, difference.scale())) * away);
  const Nearest nearest = nearest_point(CoreDifference(moved, b));
  Vector3d p_a = Vector3d::Zero();
  for (int i = 0; i < nearest.simplex.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    p_a += nearest.simplex.weights[k] * nearest.simplex.points[k].a;
  }
  return gap_at(a, b, -least.depth, p_a, p_a + least.depth * away, away);
}

Gap apart(const Solid& a, const Solid& b, const Nearest& nearest) {
  const Simplex& simplex = nearest.simplex;
  Vector3d p_a = Vector3d::Zero(), p_b = Vector3d::Zero();
  for (int i = 0; i < simplex.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    p_a += simplex.weights[k] * simplex.points[k].a;
    p_b += simplex.weights[k] * simplex.points[k].b;
  }
  const double distance = simplex.w.norm();
  Gap gap = gap_at(a, b, distance, p_a, p_b, simplex.w / distance);
  gap.away = a.T.linear() * nearest.away;
  return gap;
}

}  // namespace

Gap gap_between(const Solid& a, const Solid& b) {
  if (!a.is_convex() || !b.is_convex()) return mesh_gap(a, b);
  const CoreDifference difference(a, b);
  const Nearest nearest = nearest_point(difference);
  return nearest.overlap ? overlapping(a, b, difference, nearest.simplex) : apart(a, b, nearest);
}

bool is_whole_depth(const Solid& a, const Solid& b, const Gap& gap) {
  if (a.is_convex() && b.is_convex()) return true;
  constexpr double kFree = 1e-6;  // m
  Solid moved = a;
  moved.T.translation() += (kFree - gap.distance) * gap.away;
  return gap_between(moved, b).distance > -kFree;
}

bool is_farther(const Solid& a, const Solid& b, double distance) {
  if (!a.is_convex() || !b.is_convex()) return is_mesh_farther(a, b, distance);
  const double wanted = distance + a.margin + b.margin;
  return nearest_point(CoreDifference(a, b), wanted).at_least > wanted;
}

}  // namespace armlet
