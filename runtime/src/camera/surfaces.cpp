#include "armlet/camera/surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kFaces = 48;  // about an axis
constexpr int kBands = 24;  // of a sphere from pole to pole

class Builder {
 public:
  std::uint32_t point(const Vector3d& p, const Vector3d& n, const Vector2d& on_image) {
    parts_.positions.push_back(p);
    parts_.normals.push_back(n.cast<float>());
    parts_.on_image.push_back(on_image.cast<float>());
    return static_cast<std::uint32_t>(parts_.positions.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint8_t material) {
    parts_.corners.push_back({a, b, c});
    parts_.materials.push_back(material);
  }
  // A flat rectangle seen from outside: its texture has `right` to the right and `up` upwards.
  void quad(const Vector3d& middle, const Vector3d& right, const Vector3d& up,
            std::uint8_t material) {
    const Vector3d n = right.cross(up).normalized();
    const std::uint32_t a = point(middle - right - up, n, {0.0, 1.0}),
                        b = point(middle + right - up, n, {1.0, 1.0}),
                        c = point(middle + right + up, n, {1.0, 0.0}),
                        d = point(middle - right + up, n, {0.0, 0.0});
    triangle(a, b, c, material);
    triangle(a, c, d, material);
  }
  // The band about z between two circles, from the lower to the upper; n are the components of
  // normals away from z and along it.
  void band(const Vector2d& low, const Vector2d& n_low, const Vector2d& high,
            const Vector2d& n_high, double v_low, double v_high, std::uint8_t material) {
    std::uint32_t before_low = 0, before_high = 0;
    for (int k = 0; k <= kFaces; ++k) {
      const det::SinCos turn = det::sincos(2.0 * std::numbers::pi * (k % kFaces) / kFaces);
      const auto on_circle = [&](const Vector2d& at) {
        return Vector3d(at[0] * turn.cos, at[0] * turn.sin, at[1]);
      };
      const double u = static_cast<double>(k) / kFaces;
      const std::uint32_t here_low = point(on_circle(low), on_circle(n_low), {u, v_low});
      const std::uint32_t here_high = point(on_circle(high), on_circle(n_high), {u, v_high});
      if (k > 0) {
        if (low[0] > 0.0) triangle(before_low, here_low, here_high, material);
        if (high[0] > 0.0) triangle(before_low, here_high, before_high, material);
      }
      before_low = here_low;
      before_high = here_high;
    }
  }
  void disc(double radius, double z, double up) {
    const Vector2d rim(radius, z), middle(0.0, z), n(0.0, up);
    if (up > 0.0) {
      band(rim, n, middle, n, 1.0, 0.0, 0);
    } else {
      band(middle, n, rim, n, 1.0, 0.0, 0);
    }
  }
  SurfaceParts& parts() { return parts_; }

 private:
  SurfaceParts parts_;
};

std::array<Vector3d, 4> rectangle(double x, double y, double z) {
  return {Vector3d(-x, -y, z), Vector3d(x, -y, z), Vector3d(x, y, z), Vector3d(-x, y, z)};
}

void build(const Box& box, Builder& out) {
  const Vector3d half = 0.5 * box.size;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d away = half[axis] * Vector3d::Unit(axis);
    const Vector3d right = half[(axis + 1) % 3] * Vector3d::Unit((axis + 1) % 3);
    const Vector3d up = half[(axis + 2) % 3] * Vector3d::Unit((axis + 2) % 3);
    out.quad(away, right, up, axis == 2 ? kPicturedMaterial : 0);
    out.quad(-away, up, right, 0);
  }
  for (const double z : {half.z(), -half.z()}) {
    for (const Vector3d& p : rectangle(half.x(), half.y(), z)) out.parts().features.push_back(p);
  }
}

void build(const Cylinder& cylinder, Builder& out) {
  const double r = cylinder.radius, h = 0.5 * cylinder.height;
  out.band({r, -h}, {1.0, 0.0}, {r, h}, {1.0, 0.0}, 1.0, 0.0, kPicturedMaterial);
  out.disc(r, h, 1.0);
  out.disc(r, -h, -1.0);
}

void build(const Sphere& sphere, Builder& out) {
  const auto at = [&](int i) {
    const auto [s, c] = det::sincos(std::numbers::pi * i / kBands);
    return i == 0 || i == kBands ? Vector2d(0.0, i == 0 ? -1.0 : 1.0) : Vector2d(s, -c);
  };
  for (int i = 0; i < kBands; ++i)
    out.band(sphere.radius * at(i), at(i), sphere.radius * at(i + 1), at(i + 1),
             1.0 - static_cast<double>(i) / kBands, 1.0 - (i + 1.0) / kBands, kPicturedMaterial);
}

void build(const Cone& cone, Builder& out) {
  const double r = cone.radius, h = 0.5 * cone.height;
  const Vector2d n = Vector2d(cone.height, r).normalized();
  out.band({r, -h}, n, {0.0, h}, n, 1.0, 0.0, kPicturedMaterial);
  out.disc(r, -h, -1.0);
  out.parts().features.emplace_back(0.0, 0.0, h);
}

void build(const Plane& plane, Builder& out) {
  const double x = 0.5 * plane.size.x(), y = 0.5 * plane.size.y();
  out.quad(Vector3d::Zero(), x * Vector3d::UnitX(), y * Vector3d::UnitY(), kPicturedMaterial);
  out.parts().closed = false;
  for (const Vector3d& p : rectangle(x, y, 0.0)) out.parts().features.push_back(p);
}

void build(const Mesh& mesh, Builder& out) {
  if (!mesh.triangles) throw ArgumentError("A mesh has no triangles.");
  out.parts().positions = mesh.triangles->vertices();
  out.parts().corners = mesh.triangles->triangles();
  out.parts().materials.assign(out.parts().corners.size(), kPicturedMaterial);
}

// Merges repeated points of the builders, so that a shared point is projected once.
void merge_equal_points(SurfaceParts& parts) {
  using Key = std::array<double, 8>;
  std::map<Key, std::uint32_t> numbers;
  std::vector<std::uint32_t> number_of(parts.positions.size());
  SurfaceParts merged;
  for (std::size_t i = 0; i < parts.positions.size(); ++i) {
    const Vector3d& p = parts.positions[i];
    const Eigen::Vector3f& n = parts.normals[i];
    const Eigen::Vector2f& at = parts.on_image[i];
    const Key key{p[0], p[1], p[2], n[0], n[1], n[2], at[0], at[1]};
    const auto number = static_cast<std::uint32_t>(merged.positions.size());
    const auto [found, is_new] = numbers.emplace(key, number);
    number_of[i] = found->second;
    if (!is_new) continue;
    merged.positions.push_back(p);
    merged.normals.push_back(n);
    merged.on_image.push_back(at);
  }
  for (auto& corners : parts.corners) {
    for (std::uint32_t& corner : corners) corner = number_of.at(corner);
  }
  parts.positions = std::move(merged.positions);
  parts.normals = std::move(merged.normals);
  parts.on_image = std::move(merged.on_image);
}

// Whether every position is finite, as keys need, and has a normal and texture coordinates.
bool can_be_merged(const SurfaceParts& parts) {
  const auto is_finite = [](const auto& v) { return v.allFinite(); };
  return parts.normals.size() == parts.positions.size() &&
         parts.on_image.size() == parts.positions.size() &&
         std::ranges::all_of(parts.positions, is_finite) &&
         std::ranges::all_of(parts.normals, is_finite) &&
         std::ranges::all_of(parts.on_image, is_finite) &&
         std::ranges::all_of(parts.corners, [&](const auto& corners) {
           return *std::max_element(corners.begin(), corners.end()) < parts.positions.size();
         });
}

Surface merged_surface(SurfaceParts parts) {
  if (can_be_merged(parts)) merge_equal_points(parts);
  return Surface(std::move(parts));
}

}  // namespace

Surface surface_of(const Shape& shape) {
  Builder builder;
  std::visit([&](const auto& each) { build(each, builder); }, shape);
  return merged_surface(std::move(builder.parts()));
}

Surface surface_of(const std::vector<GlbPart>& parts, bool closed) {
  SurfaceParts out;
  out.closed = closed;
  for (const GlbPart& part : parts) {
    if (part.material > 255) {
      throw ArgumentError(
          fmt::format("A surface has material {}; the highest number is 255.", part.material));
    }
    if (part.normals.size() != part.positions.size() || part.corners.size() % 3 != 0)
      throw ArgumentError("A part of a scene has arrays that do not fit together.");
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    for (const Eigen::Vector3f& p : part.positions) out.positions.push_back(p.cast<double>());
    out.normals.insert(out.normals.end(), part.normals.begin(), part.normals.end());
    out.on_image.insert(out.on_image.end(), part.on_image.begin(), part.on_image.end());
    out.on_image.resize(out.positions.size(), Eigen::Vector2f::Zero());
    for (std::size_t i = 0; i < part.corners.size(); i += 3) {
      out.corners.push_back(
          {first + part.corners[i], first + part.corners[i + 1], first + part.corners[i + 2]});
      out.materials.push_back(static_cast<std::uint8_t>(std::max(part.material, 0)));
    }
  }
  return merged_surface(std::move(out));
}

std::vector<SceneBody> bodies_of(const GlbScene& scene) {
  std::vector<Material> materials;
  for (const GlbMaterial& look : scene.materials)
    materials.push_back(
        {.color = {static_cast<float>(look.color[0]), static_cast<float>(look.color[1]),
                   static_cast<float>(look.color[2])}});
  if (materials.empty()) materials.emplace_back();
  std::vector<Eigen::Isometry3d> poses;
  std::vector<SceneBody> bodies;
  for (const GlbNode& node : scene.nodes) {
    if (node.parent >= static_cast<int>(poses.size()))
      throw ArgumentError(fmt::format("The node `{}` comes before its parent.", node.name));
    poses.push_back(node.parent < 0
                        ? node.T_parent_node
                        : poses[static_cast<std::size_t>(node.parent)] * node.T_parent_node);
    if (node.parts.empty()) continue;
    bodies.push_back({.name = node.name,
                      .surface = std::make_shared<const Surface>(surface_of(node.parts)),
                      .T_world_body = poses.back(),
                      .materials = materials});
  }
  return bodies;
}

}  // namespace armlet
