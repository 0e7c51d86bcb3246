#include "converter/scene_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "armlet/core/error.hpp"

namespace armlet::mesh {
namespace {

using Eigen::Vector3d;

constexpr double kFarthest = 1e4;  // m

// source  IEC 61966-2-1:1999, as in the glTF 2.0 specification, 3.9.2.
double linear(double screen) {
  const double x = std::clamp(std::isfinite(screen) ? screen : 0.0, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

Vector3d direction(const Vector3d& n, const Vector3d& otherwise) {
  const double length = n.norm();
  if (std::isfinite(length) && length > 1e-12) return n / length;
  return otherwise;
}

}  // namespace

std::size_t SceneBuilder::Hash::operator()(const Key& key) const {
  std::uint64_t value = 0xCBF29CE484222325;
  for (const float each : key) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &each, sizeof bits);
    value = (value ^ bits) * 0x9E3779B97F4A7C15;
    value ^= value >> 29;
  }
  return value;
}

void SceneBuilder::note(std::string text) {
  constexpr std::size_t kMostNotes = 20;
  if (scene_.notes.size() >= kMostNotes) return;
  text = shown_text(text);
  if (std::ranges::find(scene_.notes, text) == scene_.notes.end())
    scene_.notes.push_back(std::move(text));
}

int SceneBuilder::texture(const std::string& name) {
  if (name.empty()) return -1;
  const auto known = images_.find(name);
  if (known != images_.end()) return known->second;
  std::vector<std::string> notes;
  std::optional<GlbImage> image = load_image(files_, name, notes);
  for (std::string& each : notes) note(std::move(each));
  int index = -1;
  if (image) {
    index = static_cast<int>(scene_.images.size());
    scene_.images.push_back(std::move(*image));
  }
  images_.emplace(name, index);
  return index;
}

int SceneBuilder::material(const std::string& name, const Eigen::Vector4d& color,
                           const std::string& texture_name, bool two_sided) {
  GlbMaterial made;
  made.name = shown_text(name);
  for (int k = 0; k < 3; ++k) made.color[static_cast<std::size_t>(k)] = linear(color[k]);
  made.color[3] = std::isfinite(color[3]) ? std::clamp(color[3], 0.0, 1.0) : 1.0;
  made.texture = texture(texture_name);
  made.two_sided = two_sided;
  const std::string key = fmt::format("{}|{}|{}|{}|{}|{}|{}", made.color[0], made.color[1],
                                      made.color[2], made.color[3], made.texture, two_sided, name);
  const auto [at, is_new] = materials_.emplace(key, static_cast<int>(scene_.materials.size()));
  if (is_new) scene_.materials.push_back(std::move(made));
  return at->second;
}

SceneBuilder::Key SceneBuilder::key_of(const Corner& corner, const Vector3d& normal) const {
  const Vector3d p = corner.position * unit_;
  for (const double x : p) {
    if (!std::isfinite(x)) throw ArgumentError("a coordinate of a vertex is no number");
    if (!(std::abs(x) <= kFarthest))
      throw ArgumentError(fmt::format("a vertex lies at {:.3g} m; expected 10 km at most", x));
  }
  Key key{};
  for (int k = 0; k < 3; ++k) {
    // 0.0F + x makes -0 and +0 equal.
    key[static_cast<std::size_t>(k)] = 0.0F + static_cast<float>(p[k]);
    key[static_cast<std::size_t>(3 + k)] = 0.0F + static_cast<float>(normal[k]);
  }
  if (corner.on_image) {
    for (int k = 0; k < 2; ++k) {
      const double x = k == 0 ? (*corner.on_image)[0] : 1.0 - (*corner.on_image)[1];
      if (!(std::abs(x) < 1e6)) throw ArgumentError("a position on a picture is no number");
      key[static_cast<std::size_t>(6 + k)] = 0.0F + static_cast<float>(x);
    }
  }
  if (corner.color) {
    for (int k = 0; k < 3; ++k)
      key[static_cast<std::size_t>(8 + k)] = static_cast<float>(linear((*corner.color)[k]));
    const double opacity = (*corner.color)[3];
    key[11] = static_cast<float>(std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1.0);
  }
  return key;
}

void SceneBuilder::add_triangle(int material, const std::array<Corner, 3>& corners) {
  if (++triangles_ > kMostTriangles)
    throw ArgumentError(fmt::format("it has more than {} triangles", kMostTriangles));
  const auto all_have = [&](auto member) {
    return std::ranges::all_of(corners, [&](const Corner& c) { return (c.*member).has_value(); });
  };
  const bool pictured = all_have(&Corner::on_image);
  const bool colored = all_have(&Corner::color);
  Part& part = parts_[{material, pictured ? 1 : 0, colored ? 1 : 0}];
  part.part.material = material;
  const Vector3d across =
      (corners[1].position - corners[0].position).cross(corners[2].position - corners[0].position);
  const Vector3d face = direction(across, Vector3d::UnitZ());
  for (const Corner& each : corners) {
    Corner corner = each;
    if (!pictured) corner.on_image.reset();
    if (!colored) corner.color.reset();
    const Key key = key_of(corner, direction(corner.normal, face));
    const auto [at, is_new] =
        part.known.emplace(key, static_cast<std::uint32_t>(part.part.positions.size()));
    if (is_new) {
      part.part.positions.emplace_back(key[0], key[1], key[2]);
      part.part.normals.emplace_back(key[3], key[4], key[5]);
      if (pictured) part.part.on_image.emplace_back(key[6], key[7]);
      if (colored) part.part.colors.emplace_back(key[8], key[9], key[10], key[11]);
    }
    part.part.corners.push_back(at->second);
  }
}

GlbScene SceneBuilder::finish(const std::string& name) && {
  if (triangles_ == 0) throw ArgumentError("there are no triangles in it");
  GlbNode node;
  node.name = shown_text(name);
  for (auto& [kind, part] : parts_) node.parts.push_back(std::move(part.part));
  scene_.nodes.push_back(std::move(node));
  return std::move(scene_);
}

}  // namespace armlet::mesh
