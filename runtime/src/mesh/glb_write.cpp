#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "armlet/core/error.hpp"
#include "armlet/mesh/glb.hpp"
#include "mesh/glb_format.hpp"

namespace armlet {
namespace {

using OrderedJson = nlohmann::ordered_json;

void append_u32(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xffU);
}

void pad(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
}

OrderedJson rotation_of(const Eigen::Isometry3d& T) {
  Eigen::Quaterniond turn(T.linear());
  turn.normalize();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  return {turn.x(), turn.y(), turn.z(), turn.w()};
}

void check_part(const GlbScene& scene, const GlbNode& node, const GlbPart& part) {
  const auto in_range = [](std::size_t index, std::size_t size) { return index < size; };
  const bool fits = part.positions.size() == part.normals.size() && part.corners.size() % 3 == 0 &&
                    !part.corners.empty() && part.material >= 0 &&
                    in_range(static_cast<std::size_t>(part.material), scene.materials.size()) &&
                    std::ranges::all_of(part.corners, [&](std::uint32_t i) {
                      return in_range(i, part.positions.size());
                    });
  if (!fits)
    throw ArgumentError(fmt::format("A part of node \"{}\" does not fit together.", node.name));
}

class Writer {
 public:
  explicit Writer(const GlbScene& scene) : scene_(scene) {}

  std::string bytes() {
    for (const GlbMaterial& each : scene_.materials) add_material(each);
    OrderedJson roots = OrderedJson::array();
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) add_node(static_cast<int>(i), roots);
    OrderedJson upright = {{"name", "z up"},
                           {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}},
                           {"children", roots}};
    nodes_.push_back(upright);
    OrderedJson json = {{"asset", {{"version", "2.0"}, {"generator", "armlet"}}},
                        {"scene", 0},
                        {"scenes", {{{"nodes", {nodes_.size() - 1}}}}},
                        {"nodes", nodes_}};
    if (!meshes_.empty()) {
      json["meshes"] = meshes_;
      json["materials"] = materials_;
      json["accessors"] = accessors_;
      json["bufferViews"] = views_;
      json["buffers"] = {{{"byteLength", binary_.size()}}};
    }
    return with_header(json.dump());
  }

 private:
  [[nodiscard]] std::string with_header(std::string json) {
    pad(json, ' ');
    const std::size_t binary = binary_.empty() ? 0 : 8 + binary_.size();
    const std::size_t length = 20 + json.size() + binary;
    if (length > std::numeric_limits<std::uint32_t>::max())
      throw ArgumentError("The scene would be a file of more than 4 GB.");
    std::string bytes;
    bytes.reserve(length);
    append_u32(bytes, glb::kMagic);
    append_u32(bytes, 2);
    append_u32(bytes, static_cast<std::uint32_t>(length));
    append_u32(bytes, static_cast<std::uint32_t>(json.size()));
    append_u32(bytes, glb::kJsonChunk);
    bytes += json;
    if (!binary_.empty()) {
      append_u32(bytes, static_cast<std::uint32_t>(binary_.size()));
      append_u32(bytes, glb::kBinaryChunk);
      bytes += binary_;
    }
    return bytes;
  }

  void add_material(const GlbMaterial& material) {
    materials_.push_back({{"name", material.name},
                          {"pbrMetallicRoughness",
                           {{"baseColorFactor", material.color},
                            {"metallicFactor", material.metallic},
                            {"roughnessFactor", material.roughness}}}});
  }

  // With its place in its parent, or in `roots`.
  void add_node(int index, OrderedJson& roots) {
    const GlbNode& node = scene_.nodes[static_cast<std::size_t>(index)];
    if (node.parent >= index || node.parent < -1)
      throw ArgumentError(
          fmt::format("The parent of node \"{}\" does not come before it.", node.name));
    const Eigen::Vector3d& p = node.T_parent_node.translation();
    OrderedJson json = {{"name", node.name},
                        {"translation", {p.x(), p.y(), p.z()}},
                        {"rotation", rotation_of(node.T_parent_node)}};
    if (!node.parts.empty()) json["mesh"] = add_mesh(node);
    if (node.joint) json["extras"] = extras_of(*node.joint);
    nodes_.push_back(json);
    OrderedJson& siblings =
        node.parent < 0 ? roots : nodes_[static_cast<std::size_t>(node.parent)]["children"];
    siblings.push_back(index);
  }

  static OrderedJson extras_of(const GlbJoint& joint) {
    OrderedJson extras = {{"joint", joint.turns ? "revolute" : "prismatic"}, {"q", joint.q}};
    if (std::isfinite(joint.lower)) extras["lower"] = joint.lower;
    if (std::isfinite(joint.upper)) extras["upper"] = joint.upper;
    return extras;
  }

  std::size_t add_mesh(const GlbNode& node) {
    OrderedJson primitives = OrderedJson::array();
    for (const GlbPart& part : node.parts) {
      check_part(scene_, node, part);
      primitives.push_back({{"attributes",
                             {{"POSITION", add_vectors(part.positions, true)},
                              {"NORMAL", add_vectors(part.normals, false)}}},
                            {"indices", add_indices(part.corners)},
                            {"material", part.material}});
    }
    meshes_.push_back({{"name", node.name}, {"primitives", primitives}});
    return meshes_.size() - 1;
  }

  std::size_t add_view(std::size_t offset, int target) {
    views_.push_back({{"buffer", 0},
                      {"byteOffset", offset},
                      {"byteLength", binary_.size() - offset},
                      {"target", target}});
    return views_.size() - 1;
  }

  std::size_t add_vectors(const std::vector<Eigen::Vector3f>& vectors, bool with_bounds) {
    const std::size_t offset = binary_.size();
    Eigen::Vector3f low = vectors.front(), high = vectors.front();
    for (const Eigen::Vector3f& each : vectors) {
      low = low.cwiseMin(each);
      high = high.cwiseMax(each);
      for (const float x : each) append_u32(binary_, std::bit_cast<std::uint32_t>(x));
    }
    OrderedJson accessor = {{"bufferView", add_view(offset, glb::kArrayBuffer)},
                            {"componentType", glb::kFloat},
                            {"count", vectors.size()},
                            {"type", "VEC3"}};
    if (with_bounds) {
      accessor["min"] = {low.x(), low.y(), low.z()};
      accessor["max"] = {high.x(), high.y(), high.z()};
    }
    accessors_.push_back(accessor);
    return accessors_.size() - 1;
  }

  std::size_t add_indices(const std::vector<std::uint32_t>& indices) {
    const std::size_t offset = binary_.size();
    for (const std::uint32_t each : indices) append_u32(binary_, each);
    accessors_.push_back({{"bufferView", add_view(offset, glb::kElementArrayBuffer)},
                          {"componentType", glb::kUnsignedInt},
                          {"count", indices.size()},
                          {"type", "SCALAR"}});
    return accessors_.size() - 1;
  }

  const GlbScene& scene_;
  std::string binary_;
  OrderedJson nodes_ = OrderedJson::array(), meshes_ = OrderedJson::array(),
              materials_ = OrderedJson::array(), accessors_ = OrderedJson::array(),
              views_ = OrderedJson::array();
};

}  // namespace

std::string write_glb(const GlbScene& scene) { return Writer(scene).bytes(); }

bool is_glb_name(std::string_view name) {
  constexpr std::string_view kEnding = ".glb";
  if (name.size() < kEnding.size()) return false;
  const std::string_view ending = name.substr(name.size() - kEnding.size());
  return std::equal(ending.begin(), ending.end(), kEnding.begin(),
                    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b); });
}

}  // namespace armlet
