#include "armlet/collision/resting.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "armlet/collision/solid.hpp"
#include "armlet/world/world.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

constexpr double kTouch = 1e-9;     // m
constexpr double kAside = 1e-6;     // m: a smaller sideways overlap is ignored
constexpr double kSteepest = 1e-3;  // least vertical part of a normal that carries
constexpr int kSteps = 200;

// Along z of the world.
struct Extent {
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
};

Extent around(const Eigen::Isometry3d& T, const Vector3d& low, const Vector3d& high) {
  const Vector3d middle = T * (0.5 * (low + high));
  const Vector3d half = T.linear().cwiseAbs() * (0.5 * (high - low));
  return {middle - half, middle + half};
}

// The solid enlarged by `margin`.
Extent around(const Solid& solid) {
  const Vector3d margin = Vector3d::Constant(solid.margin);
  const bool in_mesh = solid.mesh != nullptr;
  const Vector3d low = in_mesh ? solid.mesh->low() : Vector3d(-solid.half);
  const Vector3d high = in_mesh ? solid.mesh->high() : solid.half;
  const Extent core = around(solid.T, low, high);
  return {core.low - margin, core.high + margin};
}

Extent around_triangle(const Solid& solid) {
  Extent extent;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d p = solid.T * solid.mesh->corner(solid.triangle, k);
    extent.low = k == 0 ? p : extent.low.cwiseMin(p).eval();
    extent.high = k == 0 ? p : extent.high.cwiseMax(p).eval();
  }
  return extent;
}

bool is_aside(const Extent& a, const Extent& b) {
  return (a.low - b.high).head<2>().maxCoeff() > -kAside ||
         (b.low - a.high).head<2>().maxCoeff() > -kAside;
}

// Height by which `a` has to be raised from its present position to rest on `b` from above, both
// convex.
std::optional<double> rise_of_convex(Solid a, const Solid& b, const Extent& of_a,
                                     const Extent& of_b) {
  constexpr double kRoom = 1e-3;  // m
  const double z = a.T.translation().z();
  double rise = of_b.high.z() - of_a.low.z() + kRoom;
  double up = 1.0;
  for (int step = 0; step < kSteps; ++step) {
    a.T.translation().z() = z + rise;
    const Gap gap = gap_between(a, b);
    if (gap.distance <= kTouch) break;
    up = gap.away.z();
    if (up < kSteepest) return std::nullopt;
    rise -= gap.distance / up;
  }
  // Tests whether it would separate more easily sideways when pressed a little deeper.
  a.T.translation().z() = z + rise - 2.0 * kAside / up;
  if (-gap_between(a, b).distance < kAside) return std::nullopt;
  return rise;
}

// Visits the pieces of both bodies that can meet, by the trees of boxes around triangles; a convex
// body is one piece. Keeps the highest rise that is not above `most`.
class Descent {
 public:
  Descent(const Solid& a, const Solid& b) : a_(a), b_(b) {}

  std::optional<double> rise() {
    visit(0, 0);
    return best_;
  }

 private:
  static bool is_leaf(const Solid& solid, std::uint32_t node) {
    return solid.is_convex() || solid.mesh->tree().nodes[node].second == 0;
  }
  static Extent extent(const Solid& solid, std::uint32_t node) {
    if (solid.is_convex()) return around(solid);
    const TriangleTree::Node& box = solid.mesh->tree().nodes[node];
    return around(solid.T, box.low, box.high);
  }
  static std::vector<std::uint32_t> children(const Solid& solid, std::uint32_t node) {
    return {node + 1, solid.mesh->tree().nodes[node].second};
  }

  [[nodiscard]] bool may_count(const Extent& a, const Extent& b) const {
    if (is_aside(a, b)) return false;
    const double most = b.high.z() - a.low.z(), least = b.low.z() - a.high.z();
    return least <= kRestTolerance && (!best_ || most > *best_ + kTouch);
  }

  void visit(std::uint32_t a, std::uint32_t b) {
    const Extent of_a = extent(a_, a), of_b = extent(b_, b);
    if (!may_count(of_a, of_b)) return;
    if (is_leaf(a_, a) && is_leaf(b_, b)) {
      look(a, b);
      return;
    }
    const bool split_a = !is_leaf(a_, a) && (is_leaf(b_, b) || (of_a.high - of_a.low).norm() >
                                                                   (of_b.high - of_b.low).norm());
    std::vector<std::pair<double, std::uint32_t>> parts;
    for (const std::uint32_t child : split_a ? children(a_, a) : children(b_, b)) {
      const Extent e = split_a ? extent(a_, child) : extent(b_, child);
      parts.emplace_back(split_a ? e.low.z() : -e.high.z(), child);
    }
    // The pairs with the highest possible contact first.
    std::ranges::sort(parts);
    for (const auto& [height, child] : parts) split_a ? visit(child, b) : visit(a, child);
  }

  template <class Visit>
  static void for_each_piece(const Solid& solid, std::uint32_t node, Visit&& visit) {
    if (solid.is_convex()) {
      visit(solid, around(solid));
      return;
    }
    const TriangleTree& tree = solid.mesh->tree();
    for (std::uint32_t k = tree.nodes[node].begin; k < tree.nodes[node].end; ++k) {
      const Solid piece{.core = Solid::Core::kTriangle,
                        .triangle = tree.order[k],
                        .half = solid.half,
                        .mesh = solid.mesh,
                        .T = solid.T};
      visit(piece, around_triangle(piece));
    }
  }

  void look(std::uint32_t a, std::uint32_t b) {
    for_each_piece(a_, a, [&](const Solid& upper, const Extent& of_upper) {
      for_each_piece(b_, b, [&](const Solid& lower, const Extent& of_lower) {
        if (!may_count(of_upper, of_lower)) return;
        const auto rise = rise_of_convex(upper, lower, of_upper, of_lower);
        if (rise && *rise <= kRestTolerance) best_ = std::max(best_.value_or(*rise), *rise);
      });
    });
  }

  const Solid& a_;
  const Solid& b_;
  std::optional<double> best_{};
};

}  // namespace

std::optional<double> resting_height_of_shapes(const Object& falling, const Object& below) {
  Solid a = solid_of(falling.shape), b = solid_of(below.shape);
  a.T = falling.T_world_obj;
  b.T = below.T_world_obj;
  const auto rise = Descent(a, b).rise();
  if (!rise) return std::nullopt;
  return falling.T_world_obj.translation().z() + *rise;
}

}  // namespace armlet
