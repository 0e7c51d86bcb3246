#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "armlet/core/error.hpp"
#include "armlet/image/picture_size.hpp"
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
  const auto fits_all = [&](std::size_t size) {
    return size == 0 || size == part.positions.size();
  };
  const bool fits =
      part.positions.size() == part.normals.size() && part.corners.size() % 3 == 0 &&
      fits_all(part.on_image.size()) && fits_all(part.colors.size()) && !part.corners.empty() &&
      part.material >= -1 && part.material < static_cast<int>(scene.materials.size()) &&
      std::ranges::all_of(part.corners,
                          [&](std::uint32_t i) { return in_range(i, part.positions.size()); });
  if (!fits)
    throw ArgumentError(fmt::format("A part of node \"{}\" does not fit together.", node.name));
}

class Writer {
 public:
  explicit Writer(const GlbScene& scene) : scene_(scene) {}

  std::string bytes() {
    for (const GlbImage& each : scene_.images) add_image(each);
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
      if (!images_.empty()) {
        json["images"] = images_;
        json["textures"] = textures_;
      }
      json["bufferViews"] = views_;
      json["buffers"] = {{{"byteLength", binary_.size()}}};
    }
    return make_glb(json.dump(), std::move(binary_), scene_.notes);
  }

 private:
  void add_image(const GlbImage& image) {
    const std::string_view kind = image_kind(image.bytes);
    if (kind.empty())
      throw ArgumentError(fmt::format("The image \"{}\" is no PNG and no JPEG.", image.name));
    pad(binary_, '\0');
    const std::size_t offset = binary_.size();
    binary_ += image.bytes;
    images_.push_back(
        {{"name", image.name}, {"mimeType", kind}, {"bufferView", add_view(offset, 0)}});
    textures_.push_back({{"source", images_.size() - 1}});
    pad(binary_, '\0');
  }

  void add_material(const GlbMaterial& material) {
    OrderedJson look = {{"baseColorFactor", material.color},
                        {"metallicFactor", material.metallic},
                        {"roughnessFactor", material.roughness}};
    if (material.texture >= static_cast<int>(scene_.images.size()))
      throw ArgumentError(
          fmt::format("The image of the material \"{}\" is not there.", material.name));
    if (material.texture >= 0) look["baseColorTexture"] = {{"index", material.texture}};
    OrderedJson json = {{"name", material.name}, {"pbrMetallicRoughness", look}};
    if (material.two_sided) json["doubleSided"] = true;
    if (material.color[3] < 1.0) json["alphaMode"] = "BLEND";
    materials_.push_back(json);
  }

  // Adds a node to its parent, or to `roots`.
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
      OrderedJson attributes = {{"POSITION", add_vectors(part.positions, true)},
                                {"NORMAL", add_vectors(part.normals, false)}};
      if (!part.on_image.empty()) attributes["TEXCOORD_0"] = add_vectors(part.on_image, false);
      if (!part.colors.empty()) attributes["COLOR_0"] = add_vectors(part.colors, false);
      OrderedJson json = {{"attributes", attributes}, {"indices", add_indices(part.corners)}};
      if (part.material >= 0) json["material"] = part.material;
      primitives.push_back(std::move(json));
    }
    meshes_.push_back({{"name", node.name}, {"primitives", primitives}});
    return meshes_.size() - 1;
  }

  // target  0: the data are neither vertices nor indices.
  std::size_t add_view(std::size_t offset, int target) {
    OrderedJson view = {
        {"buffer", 0}, {"byteOffset", offset}, {"byteLength", binary_.size() - offset}};
    if (target != 0) view["target"] = target;
    views_.push_back(view);
    return views_.size() - 1;
  }

  template <int kWidth>
  std::size_t add_vectors(const std::vector<Eigen::Matrix<float, kWidth, 1>>& vectors,
                          bool with_bounds) {
    using Vector = Eigen::Matrix<float, kWidth, 1>;
    const std::size_t offset = binary_.size();
    Vector low = vectors.front(), high = vectors.front();
    for (const Vector& each : vectors) {
      low = low.cwiseMin(each);
      high = high.cwiseMax(each);
      for (const float x : each) append_u32(binary_, std::bit_cast<std::uint32_t>(x));
    }
    OrderedJson accessor = {{"bufferView", add_view(offset, glb::kArrayBuffer)},
                            {"componentType", glb::kFloat},
                            {"count", vectors.size()},
                            {"type", fmt::format("VEC{}", kWidth)}};
    if (with_bounds) {
      accessor["min"] = std::vector<float>(low.begin(), low.end());
      accessor["max"] = std::vector<float>(high.begin(), high.end());
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
              views_ = OrderedJson::array(), images_ = OrderedJson::array(),
              textures_ = OrderedJson::array();
};

}  // namespace

std::string write_glb(const GlbScene& scene) { return Writer(scene).bytes(); }

}  // namespace armlet
