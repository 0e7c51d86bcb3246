#include "mesh/shell_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace armlet {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Vector3d, 3>;

// The point at which the edge from p to q intersects a triangle.
std::optional<Vector3d> piercing(const Vector3d& p, const Vector3d& q, const Triangle& t,
                                 double rounding) {
  const Vector3d n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area = n.norm();
  const double from = (p - t[0]).dot(n), to = (q - t[0]).dot(n), least = rounding * area;
  if (!(area > 0.0) || (from > 0.0) == (to > 0.0)) return {};
  if (std::abs(from) <= least || std::abs(to) <= least) return {};
  const Vector3d x = p + from / (from - to) * (q - p);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d side = t[(k + 1) % 3] - t[k];
    if (side.cross(x - t[k]).dot(n) <= least * side.norm()) return {};
  }
  return x;
}

class CrossingSearch {
 public:
  CrossingSearch(std::span<const Vector3d> vertices, std::span<const Corners> triangles,
                 const TriangleTree& tree, std::span<const std::uint32_t> shell_of, double rounding)
      : vertices_(vertices),
        triangles_(triangles),
        tree_(tree),
        shell_of_(shell_of),
        rounding_(rounding),
        shell_in_(tree.nodes.size(), kNoShell) {
    // Children come after their parents.
    for (std::size_t i = tree.nodes.size(); i-- > 0;) shell_in_[i] = shell_in(i);
  }

  std::optional<Vector3d> run() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, 0}};
    while (!open.empty() && looks_ < kMostLooks) {
      const auto [a, b] = open.back();
      open.pop_back();
      ++looks_;
      if (shell_in_[a] != kNoShell && shell_in_[a] == shell_in_[b]) continue;
      const TriangleTree::Node &first = tree_.nodes[a], &second = tree_.nodes[b];
      if (a != b && ((first.low.array() > second.high.array()).any() ||
                     (second.low.array() > first.high.array()).any()))
        continue;
      const bool splits_first = first.second != 0, splits_second = second.second != 0;
      if (!splits_first && !splits_second) {
        if (auto found = look_at(first, second)) return found;
      } else if (a == b) {
        open.insert(open.end(),
                    {{a + 1, first.second}, {first.second, first.second}, {a + 1, a + 1}});
      } else if (splits_first &&
                 (!splits_second || first.end - first.begin >= second.end - second.begin)) {
        open.insert(open.end(), {{a + 1, b}, {first.second, b}});
      } else {
        open.insert(open.end(), {{a, b + 1}, {a, second.second}});
      }
    }
    return {};
  }

 private:
  static constexpr std::size_t kMostLooks = 20'000'000;

  // The shell to which all triangles of a node belong; kNoShell if there is none.
  [[nodiscard]] std::uint32_t shell_in(std::size_t at) const {
    const TriangleTree::Node& node = tree_.nodes[at];
    if (node.second != 0)
      return shell_in_[at + 1] == shell_in_[node.second] ? shell_in_[at + 1] : kNoShell;
    const std::uint32_t shell = shell_of_[tree_.order[node.begin]];
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (shell_of_[tree_.order[i]] != shell) return kNoShell;
    }
    return shell;
  }

  [[nodiscard]] Triangle corners(std::uint32_t triangle) const {
    const Corners& c = triangles_[triangle];
    return {vertices_[c[0]], vertices_[c[1]], vertices_[c[2]]};
  }

  std::optional<Vector3d> look_at(const TriangleTree::Node& first,
                                  const TriangleTree::Node& second) {
    for (std::uint32_t i = first.begin; i < first.end; ++i) {
      for (std::uint32_t k = second.begin; k < second.end; ++k) {
        const std::uint32_t a = tree_.order[i], b = tree_.order[k];
        if (shell_of_[a] == shell_of_[b] || shell_of_[a] == kNoShell || shell_of_[b] == kNoShell)
          continue;
        ++looks_;
        const Triangle one = corners(a), other = corners(b);
        for (std::size_t edge = 0; edge < 3; ++edge) {
          if (auto x = piercing(one[edge], one[(edge + 1) % 3], other, rounding_)) return x;
          if (auto x = piercing(other[edge], other[(edge + 1) % 3], one, rounding_)) return x;
        }
      }
    }
    return {};
  }

  std::span<const Vector3d> vertices_;
  std::span<const Corners> triangles_;
  const TriangleTree& tree_;
  std::span<const std::uint32_t> shell_of_;
  double rounding_;
  std::vector<std::uint32_t> shell_in_;
  std::size_t looks_ = 0;
};

}  // namespace

std::optional<Vector3d> find_crossing(std::span<const Vector3d> vertices,
                                      std::span<const Corners> triangles, const TriangleTree& tree,
                                      std::span<const std::uint32_t> shell_of, double rounding) {
  return CrossingSearch(vertices, triangles, tree, shell_of, rounding).run();
}

}  // namespace armlet
