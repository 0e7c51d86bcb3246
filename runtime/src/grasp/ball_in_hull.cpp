#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/grasp/grasp_quality.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

// Points of contacts are on circles and symmetric, so many of them share a facet. After a random
// displacement of this size, a facet has only as many points as dimensions.
constexpr double kShake = 1e-8;
constexpr double kFlat = 1e-6;  // a smaller ball is an effect of the displacement
constexpr int kDimensions = 6;  // at most

using Corners = std::array<int, kDimensions>;  // the first `dimensions` of them, in order

// A simplex of one dimension less: n . x = offset, n a unit vector that points outwards.
struct Facet {
  Corners corners{};
  Eigen::VectorXd n;
  double offset = 0.0;
};

// A polytope that grows to the hull, first where its facets are nearest to the origin: van den
// Bergen's expanding polytope, in up to six dimensions and for any position of the origin.
class GrowingHull {
 public:
  explicit GrowingHull(const Eigen::MatrixXd& points)
      : points_(points), dimensions_(static_cast<int>(points.rows())) {}

  double ball() {
    if (!begin()) return 0.0;
    for (;;) {
      const auto nearest = std::ranges::min_element(facets_, {}, &Facet::offset);
      Eigen::Index far = 0;
      const double beyond = (nearest->n.transpose() * points_).maxCoeff(&far) - nearest->offset;
      if (beyond <= 1e-12) return nearest->offset;
      add(static_cast<int>(far));
    }
  }

 private:
  // A first simplex: each corner as far as possible from the affine subspace of those before it.
  bool begin() {
    if (points_.cols() <= dimensions_) return false;
    std::vector<int> corners{0};
    Eigen::MatrixXd basis(dimensions_, 0);
    while (static_cast<int>(corners.size()) <= dimensions_) {
      Eigen::MatrixXd off = points_.colwise() - points_.col(0);
      off -= basis * (basis.transpose() * off);
      Eigen::Index far = 0;
      const double distance = off.colwise().norm().maxCoeff(&far);
      if (!(distance > 1e-11)) return false;
      basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
      basis.rightCols(1) = off.col(far) / distance;
      corners.push_back(static_cast<int>(far));
    }
    inside_ = Eigen::VectorXd::Zero(dimensions_);
    for (const int each : corners) inside_ += points_.col(each) / (dimensions_ + 1);
    for (std::size_t left_out = 0; left_out < corners.size(); ++left_out) {
      Corners facet{};
      int count = 0;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i != left_out) facet[static_cast<std::size_t>(count++)] = corners[i];
      }
      add_facet(facet);
    }
    return true;
  }

  void add_facet(Corners corners) {
    std::stable_sort(corners.begin(), corners.begin() + dimensions_);
    Eigen::MatrixXd edges(dimensions_ - 1, dimensions_);
    const auto corner = [&](int i) { return points_.col(corners[static_cast<std::size_t>(i)]); };
    for (int i = 1; i < dimensions_; ++i)
      edges.row(i - 1) = (corner(i) - corner(0)).normalized().transpose();
    Facet facet{.corners = corners, .n = direction_across(edges)};
    facet.offset = facet.n.dot(corner(0));
    if (facet.n.dot(inside_) > facet.offset) {
      facet.n = -facet.n;
      facet.offset = -facet.offset;
    }
    facets_.push_back(std::move(facet));
  }

  // Replaces the facets that are visible from the point by those that connect it with their rim.
  void add(int point) {
    std::map<Corners, int> rims;
    std::erase_if(facets_, [&](const Facet& each) {
      if (each.n.dot(points_.col(point)) <= each.offset) return false;
      for (int left_out = 0; left_out < dimensions_; ++left_out) {
        Corners rim{};
        int count = 0;
        for (int i = 0; i < dimensions_; ++i) {
          if (i != left_out)
            rim[static_cast<std::size_t>(count++)] = each.corners[static_cast<std::size_t>(i)];
        }
        ++rims[rim];
      }
      return true;
    });
    for (const auto& [rim, times] : rims) {
      if (times != 1) continue;
      Corners corners = rim;
      corners[static_cast<std::size_t>(dimensions_ - 1)] = point;
      add_facet(corners);
    }
  }

  const Eigen::MatrixXd& points_;
  int dimensions_;
  Eigen::VectorXd inside_;
  std::vector<Facet> facets_;
};

}  // namespace

double ball_in_hull(const Eigen::MatrixXd& points) {
  if (points.size() == 0) return 0.0;
  const double longest = points.colwise().norm().maxCoeff();
  if (!(longest > 0.0)) return 0.0;
  Random random(0x6772617370);
  Eigen::MatrixXd shaken = points / longest;
  for (Eigen::Index i = 0; i < shaken.size(); ++i)
    shaken.data()[i] += random.uniform(-kShake, kShake);
  const double radius = GrowingHull(shaken).ball();
  return radius > kFlat ? radius * longest : 0.0;
}

}  // namespace armlet
