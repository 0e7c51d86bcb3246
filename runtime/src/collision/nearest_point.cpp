#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "collision/difference.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

double with_sign(double size, double d) { return d < 0.0 ? -size : size; }

const Vector3d& triangle_support(const TriangleMesh& mesh, std::size_t triangle,
                                 const Vector3d& d) {
  const Vector3d &a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1),
                 &c = mesh.corner(triangle, 2);
  const double at_a = d.dot(a), at_b = d.dot(b), at_c = d.dot(c);
  if (at_a >= at_b) return at_a >= at_c ? a : c;
  return at_b >= at_c ? b : c;
}

// Barycentric weights of a simplex's point nearest to the origin; zero: the corner is not needed.
using Weights = std::array<double, 4>;
struct Candidate {
  Weights weights{};
  Vector3d w = Vector3d::Zero();
  double square = std::numeric_limits<double>::infinity();
};

using Points = std::array<DifferencePoint, 4>;

Candidate candidate(const Points& points, const Weights& weights) {
  Candidate made{.weights = weights};
  for (std::size_t i = 0; i < 4; ++i) {
    if (weights[i] > 0.0) made.w += weights[i] * points[i].w;
  }
  made.square = made.w.squaredNorm();
  return made;
}

void keep_nearer(Candidate& best, const Candidate& other) {
  if (other.square < best.square) best = other;
}

Candidate nearest_on_segment(const Points& points, std::size_t i, std::size_t j) {
  const Vector3d along = points[j].w - points[i].w;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp(-points[i].w.dot(along) / square, 0.0, 1.0) : 0.0;
  Weights weights{};
  weights[i] = 1.0 - t;
  weights[j] = t;
  return candidate(points, weights);
}

// Inside of the triangle if the foot of the perpendicular is there, otherwise on one of its sides.
Candidate nearest_on_triangle(const Points& points, std::size_t i, std::size_t j, std::size_t k) {
  const Vector3d &a = points[i].w, &b = points[j].w, &c = points[k].w;
  const Vector3d normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  const double u = normal.dot(b.cross(c)), v = normal.dot(c.cross(a)), w = normal.dot(a.cross(b));
  if (square > 0.0 && u >= 0.0 && v >= 0.0 && w >= 0.0 && u + v + w > 0.0) {
    Weights weights{};
    weights[i] = u / (u + v + w);
    weights[j] = v / (u + v + w);
    weights[k] = w / (u + v + w);
    Candidate inside = candidate(points, weights);
    // The distance of the plane has less rounding than the weighted sum of the corners.
    const Vector3d foot = normal * (normal.dot(a) / square);
    if (foot.squaredNorm() < inside.square) {
      inside.w = foot;
      inside.square = foot.squaredNorm();
    }
    return inside;
  }
  Candidate best = nearest_on_segment(points, i, j);
  keep_nearer(best, nearest_on_segment(points, j, k));
  keep_nearer(best, nearest_on_segment(points, k, i));
  return best;
}

// Whether the plane through three points separates the origin from the fourth, or all four are in
// one plane.
// flat.
bool is_outside(const Points& points, std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
  const Vector3d& a = points[i].w;
  const Vector3d normal = (points[j].w - a).cross(points[k].w - a);
  const double inner = normal.dot(points[l].w - a), origin = -normal.dot(a);
  return !(inner * origin > 0.0);
}

}  // namespace

Vector3d core_support(const Solid& solid, const Vector3d& d) {
  const Vector3d& half = solid.half;
  switch (solid.core) {
    case Solid::Core::kPoint:
      return Vector3d::Zero();
    case Solid::Core::kSegment:
      return {0.0, 0.0, with_sign(half.z(), d.z())};
    case Solid::Core::kBox:
      return {with_sign(half.x(), d.x()), with_sign(half.y(), d.y()), with_sign(half.z(), d.z())};
    case Solid::Core::kTriangle:
      return triangle_support(*solid.mesh, solid.triangle, d);
    case Solid::Core::kHull:
    case Solid::Core::kMesh:
      return solid.mesh->farthest(d);
    case Solid::Core::kCylinder:
    case Solid::Core::kCone:
      break;
  }
  const double across = std::sqrt(d.x() * d.x() + d.y() * d.y());
  const double part = across > 0.0 ? half.x() / across : 0.0;
  const bool is_tip =
      solid.core == Solid::Core::kCone && half.z() * d.z() >= half.x() * across - half.z() * d.z();
  if (is_tip) return {0.0, 0.0, half.z()};
  const double z = solid.core == Solid::Core::kCone ? -half.z() : with_sign(half.z(), d.z());
  return {part * d.x(), part * d.y(), z};
}

CoreDifference::CoreDifference(const Solid& a, const Solid& b)
    : a_(a),
      b_(b),
      R_a_b_(a.T.linear().transpose() * b.T.linear()),
      p_a_b_(a.T.linear().transpose() * (b.T.translation() - a.T.translation())),
      scale_(a.reach() + b.reach() + p_a_b_.cwiseAbs().maxCoeff()) {}

DifferencePoint CoreDifference::support(const Vector3d& d) const {
  const Vector3d a = core_support(a_, d);
  const Vector3d b = p_a_b_ + R_a_b_ * core_support(b_, R_a_b_.transpose() * -d);
  return {a - b, a, b};
}

bool Simplex::has(const DifferencePoint& point) const {
  return std::any_of(points.begin(), points.begin() + n,
                     [&](const DifferencePoint& each) { return each.w == point.w; });
}

void Simplex::collapse() {
  DifferencePoint all{w, Vector3d::Zero(), Vector3d::Zero()};
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    all.a += weights[i] * points[i].a;
    all.b += weights[i] * points[i].b;
  }
  points[0] = all;
  weights[0] = 1.0;
  n = 1;
}

bool Simplex::reduce() {
  Candidate best;
  if (n == 1) best = candidate(points, {1.0});
  if (n == 2) best = nearest_on_segment(points, 0, 1);
  if (n == 3) best = nearest_on_triangle(points, 0, 1, 2);
  if (n == 4) {
    constexpr std::size_t kFaces[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    bool inside = true;
    for (const auto& f : kFaces) {
      if (!is_outside(points, f[0], f[1], f[2], f[3])) continue;
      inside = false;
      keep_nearer(best, nearest_on_triangle(points, f[0], f[1], f[2]));
    }
    if (inside) {
      w.setZero();
      return true;
    }
  }
  int kept = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    if (!(best.weights[i] > 0.0)) continue;
    points[static_cast<std::size_t>(kept)] = points[i];
    weights[static_cast<std::size_t>(kept)] = best.weights[i];
    ++kept;
  }
  n = kept;
  w = best.w;
  return false;
}

Nearest nearest_point(const CoreDifference& difference, std::optional<double> question) {
  constexpr int kMostSteps = 128;
  constexpr double kEnough = 2e-10;  // m, and relative, between both bounds
  constexpr double kRounding = 1e-14;
  Nearest nearest;
  Simplex& simplex = nearest.simplex;
  const double touching = kRounding * difference.scale();
  Vector3d away = -difference.p_a_b();
  if (away.isZero(0.0)) away = Vector3d::UnitZ();
  simplex.points[0] = difference.support(-away);
  simplex.n = 1;
  simplex.reduce();
  bool collapsed = true;
  for (int step = 0; step < kMostSteps; ++step) {
    const double distance = simplex.w.norm();
    if (distance <= touching) {
      nearest.overlap = true;
      return nearest;
    }
    if (question && distance <= *question) return nearest;
    const DifferencePoint next = difference.support(-simplex.w);
    const double slab = simplex.w.dot(next.w) / distance;
    if (slab > nearest.at_least || step == 0) {
      nearest.at_least = std::max(slab, 0.0);
      nearest.away = simplex.w / distance;
    }
    if (question && nearest.at_least > *question) return nearest;
    if (distance - nearest.at_least <= kEnough * std::max(1.0, distance)) return nearest;
    Simplex grown = simplex;
    grown.points[static_cast<std::size_t>(grown.n++)] = next;
    if (!simplex.has(next) && grown.reduce()) {
      simplex = grown;
      nearest.overlap = true;
      nearest.at_least = 0.0;
      return nearest;
    }
    if (!simplex.has(next) && grown.w.squaredNorm() < simplex.w.squaredNorm()) {
      simplex = grown;
      collapsed = false;
      continue;
    }
    // If corners nearly coincide, as on a round body, rounding errors hide the next direction; the
    // nearest point itself can replace them.
    if (collapsed) return nearest;
    simplex.collapse();
    collapsed = true;
  }
  return nearest;
}

}  // namespace armlet
