#include "mesh/triangle_tree.hpp"

#include <algorithm>
#include <numeric>

namespace armlet {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kLeaf = 4;

class TreeMaker {
 public:
  TreeMaker(std::span<const Vector3d> vertices, std::span<const Corners> triangles)
      : vertices_(vertices), triangles_(triangles) {
    tree_.order.resize(triangles.size());
    std::iota(tree_.order.begin(), tree_.order.end(), 0U);
    middles_.reserve(triangles.size());
    for (const Corners& each : triangles)
      middles_.emplace_back(low_of(each) + high_of(each));  // twice the middle
  }

  TriangleTree make() {
    add(0, static_cast<std::uint32_t>(triangles_.size()));
    return std::move(tree_);
  }

 private:
  [[nodiscard]] Vector3d low_of(const Corners& c) const {
    return vertices_[c[0]].cwiseMin(vertices_[c[1]]).cwiseMin(vertices_[c[2]]);
  }
  [[nodiscard]] Vector3d high_of(const Corners& c) const {
    return vertices_[c[0]].cwiseMax(vertices_[c[1]]).cwiseMax(vertices_[c[2]]);
  }

  // The depth is that of halving the number: 18 for a million triangles.
  void add(std::uint32_t begin, std::uint32_t end) {
    TriangleTree::Node node;
    node.begin = begin;
    node.end = end;
    node.low = low_of(triangles_[tree_.order[begin]]);
    node.high = high_of(triangles_[tree_.order[begin]]);
    for (std::uint32_t i = begin + 1; i < end; ++i) {
      node.low = node.low.cwiseMin(low_of(triangles_[tree_.order[i]]));
      node.high = node.high.cwiseMax(high_of(triangles_[tree_.order[i]]));
    }
    const std::size_t at = tree_.nodes.size();
    tree_.nodes.push_back(node);
    if (end - begin <= kLeaf) {
      // The set of triangles here follows from their centres, but the order in which nth_element
      // leaves them depends on the library.
      std::sort(tree_.order.begin() + begin, tree_.order.begin() + end);
      return;
    }
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const auto less = [&](std::uint32_t a, std::uint32_t b) {
      return middles_[a][axis] < middles_[b][axis] ||
             (middles_[a][axis] == middles_[b][axis] && a < b);
    };
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(tree_.order.begin() + begin, tree_.order.begin() + middle,
                     tree_.order.begin() + end, less);
    add(begin, middle);
    tree_.nodes[at].second = static_cast<std::uint32_t>(tree_.nodes.size());
    add(middle, end);
  }

  std::span<const Vector3d> vertices_;
  std::span<const Corners> triangles_;
  std::vector<Vector3d> middles_;
  TriangleTree tree_;
};

}  // namespace

TriangleTree make_tree(std::span<const Vector3d> vertices, std::span<const Corners> triangles) {
  return TreeMaker(vertices, triangles).make();
}

}  // namespace armlet
