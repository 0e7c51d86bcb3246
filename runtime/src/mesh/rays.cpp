#include "mesh/rays.hpp"

namespace armlet::rays {

using Eigen::Vector3d;

int crossing(const Vector3d& p, const Vector3d& d, const Vector3d& a, const Vector3d& b,
             const Vector3d& c, bool& doubt) {
  constexpr double kClose = 1e-9;
  const Vector3d u = b - a, v = c - a, h = d.cross(v);
  const double det = u.dot(h);
  const double scale = std::sqrt(u.squaredNorm() * v.squaredNorm());
  if (std::abs(det) <= kClose * scale) {
    // A triangle seen along its plane: it matters only if the ray comes near, which is tested
    // roughly.
    if (scale > 0.0 && std::abs((p - a).dot(u.cross(v))) <= kClose * scale * (1.0 + (p - a).norm()))
      doubt = true;
    return 0;
  }
  const Vector3d s = p - a, q = s.cross(u);
  const double x = s.dot(h) / det, y = d.dot(q) / det, t = v.dot(q) / det;
  const double inner = std::min({x, y, 1.0 - x - y});
  if (t <= 0.0 || inner < -kClose) return 0;
  if (inner < kClose) doubt = true;
  return det > 0.0 ? -1 : 1;
}

bool meets(const TriangleTree::Node& node, const Vector3d& p, const Vector3d& d) {
  double from = 0.0, to = 1e30;
  for (int k = 0; k < 3; ++k) {
    const double first = (node.low[k] - p[k]) / d[k], second = (node.high[k] - p[k]) / d[k];
    const double pad = 1e-9 * (1.0 + std::abs(first) + std::abs(second));
    from = std::max(from, std::min(first, second) - pad);
    to = std::min(to, std::max(first, second) + pad);
  }
  return from <= to;
}

}  // namespace armlet::rays
