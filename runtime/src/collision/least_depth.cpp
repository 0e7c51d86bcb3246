#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "collision/difference.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

struct Face {
  std::array<int, 3> corners;
  Vector3d normal;  // zero: too thin to have a normal
  double distance;
};

class Expansion {
 public:
  explicit Expansion(const CoreDifference& difference)
      : difference_(difference), rounding_(1e-14 * difference.scale()) {}

  Depth run(const Simplex& start) {
    for (int i = 0; i < start.n; ++i) {
      const DifferencePoint& point = start.points[static_cast<std::size_t>(i)];
      if (points_.empty() || off_hull(point.w) > thin()) points_.push_back(point);
    }
    if (!make_tetrahedron()) return flat();
    constexpr int kMostSteps = 256;
    constexpr double kEnough = 5e-8;  // m, and relative to the bodies
    const double enough = kEnough * std::max(1.0, difference_.scale());
    for (int step = 0; step < kMostSteps; ++step) {
      const auto face = std::ranges::min_element(faces_, {}, &Face::distance);
      if (!std::isfinite(face->distance)) break;
      const Face nearest = *face;
      const auto at_face = static_cast<std::size_t>(face - faces_.begin());
      const DifferencePoint next = difference_.support(nearest.normal);
      const double depth = nearest.normal.dot(next.w);
      if (depth < best_.depth) best_ = {.depth = depth, .direction = nearest.normal};
      if (best_.depth - nearest.distance <= enough || !grow(at_face, next)) break;
    }
    return best_;
  }

 private:
  // Makes a tetrahedron that is not flat and does not have the origin outside; false if the
  // difference is flat.
  bool make_tetrahedron() {
    while (points_.size() < 4) {
      std::vector<Vector3d> tries;
      if (points_.size() == 3) {
        const Vector3d normal = plane_normal();
        tries = {normal, -normal};
      } else if (points_.size() == 2) {
        const Vector3d along = points_[1].w - points_[0].w;
        const Vector3d side = along.unitOrthogonal();
        const Vector3d other = along.cross(side).normalized();
        tries = {side, -side, other, -other};
      } else {
        for (int i = 0; i < 3; ++i) {
          tries.push_back(Vector3d::Unit(i));
          tries.push_back(-Vector3d::Unit(i));
        }
      }
      if (!add_off_hull(tries)) return false;
    }
    const Vector3d normal = (points_[1].w - points_[0].w).cross(points_[2].w - points_[0].w);
    if (normal.dot(points_[3].w - points_[0].w) > 0.0) std::swap(points_[1], points_[2]);
    for (const auto& corners : {std::array{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
      add_face(corners);
    return true;
  }

  [[nodiscard]] Vector3d plane_normal() const {
    const Vector3d normal = (points_[1].w - points_[0].w).cross(points_[2].w - points_[0].w);
    const double size = normal.norm();
    return size > rounding_ * rounding_ ? Vector3d(normal / size) : Vector3d(Vector3d::Zero());
  }

  // Adds the farthest of the points that are not on the hull of the present ones.
  bool add_off_hull(const std::vector<Vector3d>& tries) {
    double farthest = thin();
    DifferencePoint found{};
    for (const Vector3d& direction : tries) {
      const DifferencePoint point = difference_.support(direction);
      const double off = off_hull(point.w);
      if (!(off > farthest)) continue;
      farthest = off;
      found = point;
    }
    if (farthest <= thin()) return false;
    points_.push_back(found);
    return true;
  }

  // A point nearer to the hull of the earlier ones counts as on it, m.
  [[nodiscard]] double thin() const { return 1e-11 * difference_.scale(); }

  [[nodiscard]] double off_hull(const Vector3d& w) const {
    const Vector3d from = w - points_[0].w;
    if (points_.size() == 1) return from.norm();
    const Vector3d along = points_[1].w - points_[0].w;
    if (points_.size() == 2) return from.cross(along).norm() / along.norm();
    return std::abs(from.dot(plane_normal()));
  }

  // The whole difference is on one side of a plane through the origin: the cores only touch, so the
  // depth is zero.
  Depth flat() {
    Vector3d normal = Vector3d::UnitZ();
    if (points_.size() == 3) normal = plane_normal();
    if (points_.size() == 2) normal = (points_[1].w - points_[0].w).unitOrthogonal();
    for (const Vector3d& n : {normal, Vector3d(-normal)}) {
      const double depth = std::max(n.dot(difference_.support(n).w), 0.0);
      if (depth < best_.depth) best_ = {.depth = depth, .direction = n};
    }
    return best_;
  }

  void add_face(const std::array<int, 3>& corners) {
    const Vector3d& a = at(corners[0]).w;
    const Vector3d normal = (at(corners[1]).w - a).cross(at(corners[2]).w - a);
    const double size = normal.norm();
    if (!(size > rounding_ * rounding_)) {
      faces_.push_back({corners, Vector3d::Zero(), std::numeric_limits<double>::infinity()});
      return;
    }
    const Vector3d unit = normal / size;
    faces_.push_back({corners, unit, std::max(unit.dot(a), 0.0)});
  }

  // The face on the other side of an edge; it exists because the polytope is closed.
  [[nodiscard]] std::size_t neighbour(int from, int to) const {
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      const auto& corners = faces_[k].corners;
      for (std::size_t i = 0; i < 3; ++i) {
        if (corners[i] == to && corners[(i + 1) % 3] == from) return k;
      }
    }
    return faces_.size();
  }

  [[nodiscard]] bool sees(const Face& face, const DifferencePoint& point) const {
    if (face.normal.isZero(0.0)) return true;
    return face.normal.dot(point.w - at(face.corners[0]).w) > rounding_;
  }

  // Replaces the faces that are visible from the point and connected to `first` by faces to it. The
  // removed faces are connected in spite of rounding, so the polytope stays closed. False if it
  // cannot grow.
  bool grow(std::size_t first, const DifferencePoint& point) {
    std::vector<bool> gone(faces_.size(), false);
    std::vector<std::size_t> open = {first};
    gone[first] = true;
    std::vector<std::pair<int, int>> rim;
    while (!open.empty()) {
      const std::array<int, 3> corners = faces_[open.back()].corners;
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = neighbour(corners[i], corners[(i + 1) % 3]);
        if (next == faces_.size()) return false;
        if (gone[next]) continue;
        if (!sees(faces_[next], point)) {
          rim.emplace_back(corners[i], corners[(i + 1) % 3]);
          continue;
        }
        gone[next] = true;
        open.push_back(next);
      }
    }
    // Edges whose other face was found visible later are not on the rim.
    std::erase_if(rim, [&](const auto& edge) { return gone[neighbour(edge.first, edge.second)]; });
    if (rim.size() < 3) return false;
    std::vector<Face> kept;
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      if (!gone[k]) kept.push_back(faces_[k]);
    }
    faces_ = std::move(kept);
    const int apex = static_cast<int>(points_.size());
    points_.push_back(point);
    for (const auto& [from, to] : rim) add_face({from, to, apex});
    return true;
  }

  [[nodiscard]] const DifferencePoint& at(int i) const {
    return points_[static_cast<std::size_t>(i)];
  }

  const CoreDifference& difference_;
  double rounding_;
  std::vector<DifferencePoint> points_;
  std::vector<Face> faces_;
  Depth best_{.depth = std::numeric_limits<double>::infinity()};
};

}  // namespace

Depth least_depth(const CoreDifference& difference, const Simplex& around_origin) {
  Depth least = Expansion(difference).run(around_origin);
  if (!std::isfinite(least.depth)) least.depth = 0.0;
  return least;
}

}  // namespace armlet
