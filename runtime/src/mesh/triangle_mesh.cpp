#include "armlet/mesh/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "mesh/edges.hpp"
#include "mesh/rays.hpp"
#include "mesh/shells.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/triangle_tree.hpp"

namespace armlet {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool comes_before(const Vector3d& p, const Vector3d& q) {
  if (p.x() != q.x()) return p.x() < q.x();
  if (p.y() != q.y()) return p.y() < q.y();
  return p.z() < q.z();
}

// Whether no vertex is farther than `rounding` in front of the plane of a triangle; of very many
// triangles only a sample is tested. Degenerate triangles have no plane.
bool lies_behind_all(const TriangleMesh& mesh, double rounding) {
  constexpr std::size_t kMostLooks = 5'000;
  const std::size_t step = mesh.triangles().size() / kMostLooks + 1;
  for (std::size_t i = 0; i < mesh.triangles().size(); i += step) {
    constexpr std::uint64_t kLook = 20'000;  // operations
    checkpoint(kLook);
    const Vector3d &a = mesh.corner(i, 0), u = mesh.corner(i, 1) - a, v = mesh.corner(i, 2) - a;
    const Vector3d n = u.cross(v);
    const double area = n.norm();
    if (area < 1e-5 * std::max(u.squaredNorm(), v.squaredNorm())) continue;
    if ((mesh.farthest(n) - a).dot(n) > rounding * area) return false;
  }
  return true;
}

}  // namespace

TriangleMesh::TriangleMesh(std::vector<Vector3d> vertices, std::vector<Corners> triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
  check_surface(vertices_, triangles_);
  drop_doubles();
  tree_ = make_tree(vertices_, triangles_);
  for (const Vector3d& each : vertices_) reach_ = std::max(reach_, each.norm());
  look_at_edges();
  if (!is_closed()) return;
  weigh();
  if (mass_->volume < 0.0) {
    turn_inside_out();
    look_at_edges();
    weigh();
  }
  set_shells_right();
  const double size = (high() - low()).maxCoeff();
  if (!(mass_->volume > 1e-15 * size * size * size)) {
    mass_.reset();
    is_convex_ = false;
    open_because_ = "its surface holds nothing";
  }
}

// Sorts vertices by their coordinates, and keeps each used one once.
void TriangleMesh::drop_doubles() {
  std::vector<bool> used(vertices_.size(), false);
  for (const Corners& each : triangles_) {
    for (const std::uint32_t k : each) used[k] = true;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    if (used[i]) order.push_back(i);
  }
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    if (comes_before(vertices_[a], vertices_[b])) return true;
    return !comes_before(vertices_[b], vertices_[a]) && a < b;
  });
  std::vector<std::uint32_t> number(vertices_.size(), 0);
  std::vector<Vector3d> distinct;
  for (const std::uint32_t i : order) {
    if (distinct.empty() || distinct.back() != vertices_[i]) distinct.push_back(vertices_[i]);
    number[i] = static_cast<std::uint32_t>(distinct.size() - 1);
  }
  vertices_ = std::move(distinct);
  for (Corners& each : triangles_) {
    for (std::uint32_t& k : each) k = number[k];
  }
  std::erase_if(triangles_,
                [](const Corners& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; });
}

void TriangleMesh::look_at_edges() {
  // Files have single precision: corners of one plane differ from it by rounding.
  const double rounding = 4e-7 * reach_;
  const EdgeReport report = look_at(vertices_, triangles_, rounding);
  open_because_ = report.open_because;
  is_convex_ = report.is_convex && lies_behind_all(*this, rounding);
  is_one_shell_ = report.is_one_shell;
}

void TriangleMesh::set_shells_right() {
  if (is_one_shell_) return;
  const Shells shells = shells_of(triangles_);
  if (shells.count < 2) return;
  doubled_because_ = armlet::set_shells_right(vertices_, triangles_, tree_, shells);
  weigh();
}

void TriangleMesh::turn_inside_out() {
  for (Corners& each : triangles_) std::swap(each[1], each[2]);
}

// The integral of x x' over a tetrahedron with corners 0, a, b, c is
// det / 120 (a a' + b b' + c c' + s s'), s = a + b + c.
void TriangleMesh::weigh() {
  const Vector3d origin = 0.5 * (low() + high());
  double volume = 0.0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const Vector3d a = corner(i, 0) - origin, b = corner(i, 1) - origin, c = corner(i, 2) - origin;
    const double det = a.dot(b.cross(c));
    const Vector3d sum = a + b + c;
    volume += det / 6.0;
    first += det / 24.0 * sum;
    second += det / 120.0 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  MassProperties mass{.volume = volume};
  const Vector3d middle = first / volume;
  mass.center_of_mass = origin + middle;
  second -= volume * middle * middle.transpose();
  mass.inertia = second.trace() * Matrix3d::Identity() - second;
  mass_ = mass;
}

const Vector3d& TriangleMesh::farthest(const Vector3d& d) const {
  const auto most = [&](const TriangleTree::Node& node) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += d[k] * (d[k] < 0.0 ? node.low[k] : node.high[k]);
    return sum;
  };
  std::uint32_t best = triangles_[0][0];
  double height = d.dot(vertices_[best]);
  std::array<std::uint32_t, 64> open{};
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t at = open[--count];
    const TriangleTree::Node& node = tree_.nodes[at];
    if (most(node) <= height) continue;
    if (node.second != 0) {
      const bool second_first = most(tree_.nodes[node.second]) > most(tree_.nodes[at + 1]);
      open[count++] = second_first ? at + 1 : node.second;
      open[count++] = second_first ? node.second : at + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      for (const std::uint32_t k : triangles_[tree_.order[i]]) {
        const double z = d.dot(vertices_[k]);
        if (z <= height) continue;
        height = z;
        best = k;
      }
    }
  }
  return vertices_[best];
}

bool TriangleMesh::holds(const Vector3d& p) const {
  if (!is_closed() || (p - low()).minCoeff() < 0.0 || (high() - p).minCoeff() < 0.0) return false;
  int inside = 0, outside = 0;
  for (const Vector3d& ray : rays::kDirections) {
    int crossings = 0;
    const bool doubt = rays::cast(vertices_, triangles_, tree_, p, ray,
                                  [&](std::uint32_t, int way) { crossings += way; });
    if (!doubt) return crossings > 0;
    ++(crossings > 0 ? inside : outside);
  }
  return inside > outside;
}

TriangleMesh TriangleMesh::scaled(const Vector3d& factors) const {
  std::vector<Vector3d> vertices;
  vertices.reserve(vertices_.size());
  for (const Vector3d& each : vertices_) vertices.emplace_back(factors.cwiseProduct(each));
  std::vector<Corners> triangles = triangles_;
  if (factors.prod() < 0.0) {
    for (Corners& each : triangles) std::swap(each[1], each[2]);
  }
  TriangleMesh mesh(std::move(vertices), std::move(triangles));
  mesh.source_ = {.bytes = source_.bytes,
                  .T_mesh_file = factors.asDiagonal() * source_.T_mesh_file};
  return mesh;
}

TriangleMesh TriangleMesh::moved(const Eigen::Isometry3d& T) const {
  if (T.linear() != Matrix3d::Identity()) {
    std::vector<Vector3d> vertices;
    vertices.reserve(vertices_.size());
    for (const Vector3d& each : vertices_) vertices.emplace_back(T * each);
    TriangleMesh mesh(std::move(vertices), triangles_);
    mesh.source_ = {.bytes = source_.bytes, .T_mesh_file = T * source_.T_mesh_file};
    return mesh;
  }
  // Rounding is monotone, so the boxes still contain their triangles.
  const Vector3d p = T.translation();
  TriangleMesh mesh = *this;
  mesh.source_.T_mesh_file = T * source_.T_mesh_file;
  mesh.reach_ = 0.0;
  for (Vector3d& each : mesh.vertices_) {
    each += p;
    mesh.reach_ = std::max(mesh.reach_, each.norm());
  }
  for (TriangleTree::Node& each : mesh.tree_.nodes) {
    each.low += p;
    each.high += p;
  }
  if (mesh.mass_) mesh.mass_->center_of_mass += p;
  return mesh;
}

}  // namespace armlet
