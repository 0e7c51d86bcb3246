#include "collision/mesh_gap.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "collision/difference.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

struct BoxAround {
  Vector3d low, high;
};

double distance(const BoxAround& a, const BoxAround& b) {
  return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

Solid hull_of(Solid solid) {
  if (!solid.is_convex()) solid.core = Solid::Core::kHull;
  return solid;
}

Vector3d farthest_point(const Solid& solid, const Vector3d& n) {
  return solid.T * core_support(solid, solid.T.linear().transpose() * n) + solid.margin * n;
}

// A body as a tree of convex pieces with boxes: the triangles of a mesh, or the body itself. Boxes
// are in a common frame of both bodies.
class PieceTree {
 public:
  PieceTree(const Solid& solid, const Eigen::Isometry3d& T_world_frame) : solid_(solid) {
    const Eigen::Isometry3d T_frame_solid = T_world_frame.inverse() * solid.T;
    R_ = T_frame_solid.linear();
    p_ = T_frame_solid.translation();
    if (!solid.is_convex()) return;
    for (int k = 0; k < 3; ++k) {
      const Vector3d axis = T_world_frame.linear().col(k);
      const double origin = axis.dot(T_world_frame.translation());
      whole_.low[k] = farthest_point(solid, -axis).dot(axis) - origin;
      whole_.high[k] = farthest_point(solid, axis).dot(axis) - origin;
    }
  }

  [[nodiscard]] bool is_leaf(std::uint32_t node) const {
    return solid_.is_convex() || nodes()[node].second == 0;
  }
  [[nodiscard]] std::array<std::uint32_t, 2> children(std::uint32_t node) const {
    return {node + 1, nodes()[node].second};
  }
  [[nodiscard]] BoxAround box(std::uint32_t node) const {
    if (solid_.is_convex()) return whole_;
    const Vector3d middle = R_ * (0.5 * (nodes()[node].low + nodes()[node].high)) + p_;
    const Vector3d half = R_.cwiseAbs() * (0.5 * (nodes()[node].high - nodes()[node].low));
    return {middle - half, middle + half};
  }
  [[nodiscard]] double size(std::uint32_t node) const {
    return solid_.is_convex() ? 0.0 : (nodes()[node].high - nodes()[node].low).sum();
  }
  [[nodiscard]] std::uint32_t count(std::uint32_t node) const {
    return solid_.is_convex() ? 1 : nodes()[node].end - nodes()[node].begin;
  }
  // Piece `i` of a leaf.
  [[nodiscard]] Solid piece(std::uint32_t node, std::uint32_t i) const {
    if (solid_.is_convex()) return solid_;
    Solid triangle = solid_;
    triangle.core = Solid::Core::kTriangle;
    triangle.triangle = solid_.mesh->tree().order[nodes()[node].begin + i];
    return triangle;
  }

 private:
  [[nodiscard]] const std::vector<TriangleTree::Node>& nodes() const {
    return solid_.mesh->tree().nodes;
  }

  const Solid& solid_;
  Eigen::Matrix3d R_;
  Vector3d p_;
  BoxAround whole_{};
};

// Visits all pairs of pieces whose boxes are nearer than `limit`, nearer boxes first; visits may
// reduce the limit. visit(a, b) returns whether to continue.
template <class Visit>
void for_each_near(const Solid& a, const Solid& b, const double& limit, Visit&& visit) {
  const PieceTree first(a, a.T), second(b, a.T);
  struct Pair {
    std::uint32_t a, b;
    double distance;
  };
  std::vector<Pair> open = {{0, 0, distance(first.box(0), second.box(0))}};
  const auto look_inside = [&](const Pair& pair) {
    for (std::uint32_t i = 0; i < first.count(pair.a); ++i) {
      for (std::uint32_t k = 0; k < second.count(pair.b); ++k) {
        if (!visit(first.piece(pair.a, i), second.piece(pair.b, k))) return false;
      }
    }
    return true;
  };
  while (!open.empty()) {
    const Pair pair = open.back();
    open.pop_back();
    if (pair.distance > limit) continue;
    const bool leaf_a = first.is_leaf(pair.a), leaf_b = second.is_leaf(pair.b);
    if (leaf_a && leaf_b) {
      if (!look_inside(pair)) return;
      continue;
    }
    const bool halve_a = !leaf_a && (leaf_b || first.size(pair.a) >= second.size(pair.b));
    Pair halves[2];
    for (std::size_t side = 0; side < 2; ++side) {
      halves[side] = pair;
      if (halve_a) {
        halves[side].a = first.children(pair.a)[side];
      } else {
        halves[side].b = second.children(pair.b)[side];
      }
      halves[side].distance = distance(first.box(halves[side].a), second.box(halves[side].b));
    }
    if (halves[0].distance < halves[1].distance) std::swap(halves[0], halves[1]);
    open.insert(open.end(), {halves[0], halves[1]});
  }
}

// Any point of a body.
Vector3d some_point(const Solid& solid) {
  return solid.mesh != nullptr ? solid.T * solid.mesh->corner(0, 0)
                               : Vector3d(solid.T.translation());
}

bool is_inside(const Solid& mesh, const Solid& other) {
  return !mesh.is_convex() && mesh.mesh->holds(mesh.T.inverse() * some_point(other));
}

Vector3d outward(const Solid& triangle) {
  const auto corner = [&](std::size_t k) -> const Vector3d& {
    return triangle.mesh->corner(triangle.triangle, k);
  };
  return triangle.T.linear() * (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

// Whether a piece of a closed mesh is left towards its outside by moving along -n.
bool leaves_outside(const Solid& piece, const Vector3d& n) {
  constexpr double kAlong = 1e-6;
  return piece.core != Solid::Core::kTriangle || !piece.mesh->is_closed() ||
         outward(piece).dot(n) > -kAlong;
}

// The depth of `other` behind the plane of a triangle, which it leaves along its normal. `first`:
// the triangle belongs to the first body.
Gap behind_plane(const Solid& triangle, const Solid& other, bool first) {
  const Vector3d n = outward(triangle), deepest = farthest_point(other, -n);
  const double depth = n.dot(triangle.T * triangle.mesh->corner(triangle.triangle, 0) - deepest);
  const Vector3d on_plane = deepest + depth * n;
  if (first) return {.distance = -depth, .p_a = on_plane, .p_b = deepest, .away = -n};
  return {.distance = -depth, .p_a = deepest, .p_b = on_plane, .away = n};
}

// The piece with the largest depth among those that overlap and can be separated towards the
// outside; if there are none, the shortest displacement through an overlapped face.
Gap deepest_piece(const Solid& a, const Solid& b) {
  std::optional<Gap> deepest, out;
  const double limit = 0.0;
  for_each_near(a, b, limit, [&](const Solid& piece, const Solid& other) {
    if (is_farther(piece, other, 0.0)) return true;
    const Gap gap = gap_between(piece, other);
    const bool good = leaves_outside(piece, -gap.away) && leaves_outside(other, gap.away);
    if (good) {
      if (!deepest || gap.distance < deepest->distance) deepest = gap;
      return true;
    }
    const bool of_a = piece.core == Solid::Core::kTriangle;
    const Gap plane = of_a ? behind_plane(piece, other, true) : behind_plane(other, piece, false);
    if (!out || plane.distance > out->distance) out = plane;
    return true;
  });
  if (deepest) return *deepest;
  return out ? *out : Gap{};
}

// The deepest vertex of `inner` in `outer`, as a gap of the first and the second body.
void look_at_vertices(const Solid& outer, const Solid& inner, bool outer_first, Gap& deepest) {
  if (outer.is_convex() || !outer.mesh->is_closed()) return;
  const Eigen::Isometry3d T_outer_inner = outer.T.inverse() * inner.T;
  for (const Vector3d& each : inner.mesh->vertices()) {
    if (!outer.mesh->holds(T_outer_inner * each)) continue;
    Solid point;
    point.T.translation() = inner.T * each;
    Gap best{.distance = std::numeric_limits<double>::infinity()};
    for_each_near(outer, point, best.distance, [&](const Solid& piece, const Solid& other) {
      const Gap gap = gap_between(piece, other);
      if (gap.distance < best.distance) best = gap;
      return true;
    });
    if (-best.distance >= deepest.distance) continue;
    // The point leaves towards the surface.
    deepest = {.distance = -best.distance, .p_a = best.p_a, .p_b = best.p_b, .away = -best.away};
    if (outer_first) continue;
    std::swap(deepest.p_a, deepest.p_b);
    deepest.away = -deepest.away;
  }
}

Gap overlapping_meshes(const Solid& a, const Solid& b) {
  Gap gap = deepest_piece(a, b);
  if (!a.is_convex() && !b.is_convex()) {
    look_at_vertices(a, b, true, gap);
    look_at_vertices(b, a, false, gap);
  }
  // The depth is at most that of the hulls.
  const Gap hull = gap_between(hull_of(a), hull_of(b));
  return hull.distance > gap.distance ? hull : gap;
}

// The displacement through the nearest point of the surface. The last point of the inner body to
// leave, and the point of that plane at which it leaves, are the pair of deepest penetration.
Gap enclosed(const Solid& a, const Solid& b, const Gap& nearest) {
  const bool b_is_inner = is_inside(a, b);
  const Solid& inner = b_is_inner ? b : a;
  const Vector3d n = nearest.away;
  const double width = (farthest_point(inner, n) - farthest_point(inner, -n)).dot(n);
  const double depth = nearest.distance + width;
  const Vector3d last = farthest_point(inner, b_is_inner ? Vector3d(-n) : n);
  const Gap gap{.distance = -depth,
                .p_a = b_is_inner ? Vector3d(last + depth * n) : last,
                .p_b = b_is_inner ? last : Vector3d(last - depth * n),
                .away = -n};
  const Gap hull = gap_between(hull_of(a), hull_of(b));
  return hull.distance > gap.distance ? hull : gap;
}

}  // namespace

Gap mesh_gap(const Solid& a, const Solid& b) {
  Gap best{.distance = std::numeric_limits<double>::infinity()};
  for_each_near(a, b, best.distance, [&](const Solid& piece, const Solid& other) {
    if (best.distance < std::numeric_limits<double>::infinity() &&
        is_farther(piece, other, best.distance))
      return true;
    const Gap gap = gap_between(piece, other);
    if (gap.distance < best.distance) best = gap;
    return best.distance > 0.0;
  });
  if (best.distance <= 0.0) return overlapping_meshes(a, b);
  if (is_inside(a, b) || is_inside(b, a)) return enclosed(a, b, best);
  return best;
}

bool is_mesh_farther(const Solid& a, const Solid& b, double distance) {
  if (is_farther(hull_of(a), hull_of(b), distance)) return true;
  bool near = false;
  for_each_near(a, b, distance, [&](const Solid& piece, const Solid& other) {
    near = !is_farther(piece, other, distance);
    return !near;
  });
  return !near && !is_inside(a, b) && !is_inside(b, a);
}

}  // namespace armlet
