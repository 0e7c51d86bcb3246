#include "mesh/edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace armlet {
namespace {

using Eigen::Vector3d;

// An edge of a triangle: its ends, lower number first, whether its direction is from there, and the
// opposite corner of the triangle.
struct HalfEdge {
  std::uint64_t ends;
  bool forward;
  std::uint32_t triangle;
  std::uint32_t opposite;
};

std::vector<HalfEdge> half_edges(std::span<const Corners> triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Corners& c = triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t from = c[k], to = c[(k + 1) % 3];
      edges.push_back({.ends = std::min(from, to) << 32 | std::max(from, to),
                       .forward = from < to,
                       .triangle = i,
                       .opposite = c[(k + 2) % 3]});
    }
  }
  std::ranges::sort(edges, [](const HalfEdge& a, const HalfEdge& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
  });
  return edges;
}

// Sets of triangles that are connected by edges.
class Pieces {
 public:
  explicit Pieces(std::size_t n) : parent_(n), count_(n) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  std::uint32_t root(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::size_t count_;
};

// Whether a vertex is behind the plane of a triangle, or in it within rounding.
bool is_behind(std::span<const Vector3d> vertices, const Corners& c, std::uint32_t vertex,
               double rounding) {
  const Vector3d &a = vertices[c[0]], u = vertices[c[1]] - a, v = vertices[c[2]] - a;
  const Vector3d n = u.cross(v);
  return (vertices[vertex] - a).dot(n) <= rounding * n.norm();
}

std::string why_open(std::size_t single, std::size_t turned) {
  const auto edges = [](std::size_t n) { return n == 1 ? "1 edge" : fmt::format("{} edges", n); };
  if (single > 0) {
    return fmt::format("its surface is open: {} {} to one triangle alone", edges(single),
                       single == 1 ? "belongs" : "belong");
  }
  if (turned > 0) {
    return fmt::format(
        "its triangles do not agree which side is outside: {} {} gone twice the same way",
        edges(turned), turned == 1 ? "is" : "are");
  }
  return {};
}

}  // namespace

EdgeReport look_at(std::span<const Vector3d> vertices, std::span<const Corners> triangles,
                   double rounding) {
  const std::vector<HalfEdge> edges = half_edges(triangles);
  Pieces pieces(triangles.size());
  std::size_t count = 0, single = 0, turned = 0;
  bool convex = true, simple = true;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end, ++count) {
    long balance = 0;
    for (end = i; end < edges.size() && edges[end].ends == edges[i].ends; ++end) {
      balance += edges[end].forward ? 1 : -1;
      pieces.join(edges[i].triangle, edges[end].triangle);
    }
    if (balance != 0) ++(end - i == 1 ? single : turned);
    simple = simple && end - i == 2;
    convex = convex && end - i == 2 && balance == 0 &&
             is_behind(vertices, triangles[edges[i].triangle], edges[i + 1].opposite, rounding) &&
             is_behind(vertices, triangles[edges[i + 1].triangle], edges[i].opposite, rounding);
  }
  // A sphere has V - E + F = 2 (Euler).
  const bool sphere = vertices.size() + triangles.size() == count + 2 && pieces.count() == 1;
  return {.open_because = why_open(single, turned),
          .is_convex = convex && sphere,
          .is_one_shell = simple && pieces.count() == 1};
}

namespace {

// Whether each piece at an edge, edges[begin] to edges[end - 1], uses it as often in one direction
// as in the other.
bool is_balanced(std::span<const HalfEdge> edges, Pieces& pieces) {
  std::map<std::uint32_t, int> balances;
  for (const HalfEdge& each : edges) balances[pieces.root(each.triangle)] += each.forward ? 1 : -1;
  return std::ranges::all_of(balances, [](const auto& each) { return each.second == 0; });
}

}  // namespace

Shells shells_of(std::span<const Corners> triangles) {
  const std::vector<HalfEdge> edges = half_edges(triangles);
  Pieces pieces(triangles.size());
  std::vector<std::pair<std::size_t, std::size_t>> busy;  // edges of more than two triangles
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i; end < edges.size() && edges[end].ends == edges[i].ends; ++end) {
    }
    if (end - i == 2) pieces.join(edges[i].triangle, edges[i + 1].triangle);
    if (end - i > 2) busy.emplace_back(i, end);
  }
  // After a few rounds all connected triangles count as one piece.
  constexpr int kRounds = 10;
  bool has_joined = true;
  for (int round = 0; has_joined && round <= kRounds; ++round) {
    has_joined = false;
    for (const auto& [begin, end] : busy) {
      const auto at_edge = std::span(edges).subspan(begin, end - begin);
      if (round < kRounds && is_balanced(at_edge, pieces)) continue;
      for (std::size_t i = begin; i < end; ++i)
        pieces.join(edges[begin].triangle, edges[i].triangle);
      has_joined = true;
    }
  }
  Shells shells{.of = std::vector<std::uint32_t>(triangles.size()), .count = 0};
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t root = pieces.root(i);  // the first triangle of its piece
    shells.of[i] = root == i ? static_cast<std::uint32_t>(shells.count++) : shells.of[root];
  }
  return shells;
}

}  // namespace armlet
