#include "mesh/glb_things.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "armlet/mesh/glb.hpp"

namespace armlet {

Eigen::Matrix3d rotation_in(const Eigen::Matrix3d& linear) {
  Eigen::Matrix3d R = linear;
  if (!(R.col(0).norm() > 0.0)) return Eigen::Matrix3d::Identity();
  R.col(0).normalize();
  R.col(1) -= R.col(0) * R.col(0).dot(R.col(1));
  if (!(R.col(1).norm() > 1e-12 * linear.norm())) return Eigen::Matrix3d::Identity();
  R.col(1).normalize();
  R.col(2) = R.col(0).cross(R.col(1));
  return R;
}

std::string unique_name(std::string name, std::uint64_t number, std::set<std::string>& names) {
  std::erase_if(
      name, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '"' || c == '\\'; });
  std::size_t end = std::min<std::size_t>(name.size(), 100);
  while (end < name.size() && end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0U) == 0x80U)
    --end;
  name.resize(end);
  if (name.empty()) name = fmt::format("node {}", number);
  const std::string first = name;
  for (int k = 2; !names.insert(name).second; ++k) name = fmt::format("{} {}", first, k);
  return name;
}

std::string shown_color(const double linear[3]) {
  std::string text = "#";
  for (int k = 0; k < 3; ++k) {
    const double c = std::clamp(linear[k], 0.0, 1.0);
    const double shown = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
    text += fmt::format("{:02x}", static_cast<int>(std::lround(255.0 * shown)));
  }
  return text;
}

void add_triangles(const TriangleMesh& mesh, const Eigen::Isometry3d& T_node_mesh, GlbPart& part) {
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Eigen::Vector3d a = T_node_mesh * mesh.corner(i, 0), b = T_node_mesh * mesh.corner(i, 1),
                          c = T_node_mesh * mesh.corner(i, 2);
    const Eigen::Vector3f n = (b - a).cross(c - a).stableNormalized().cast<float>();
    for (const Eigen::Vector3d& each : {a, b, c}) {
      part.corners.push_back(static_cast<std::uint32_t>(part.positions.size()));
      part.positions.emplace_back(each.cast<float>());
      part.normals.push_back(n);
    }
  }
}

}  // namespace armlet
