#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "armlet/mesh/glb.hpp"
#include "mesh/glb_document.hpp"
#include "mesh/glb_format.hpp"
#include "mesh/glb_things.hpp"
#include "mesh/surface_check.hpp"

namespace armlet {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;
using glb::Chunks;
using glb::chunks_of;
using glb::Document;
using glb::Json;
using glb::refuse;
using glb::u32;

constexpr std::size_t kMostVertices = 3 * kMostTriangles;
constexpr std::size_t kMostParts = kMostTriangles;

// ---- the numbers of the binary part

// A list of `count` elements, `stride` bytes apart, completely inside of the binary part.
struct Elements {
  const char* bytes = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;
  int component = 0;
};

std::size_t size_of(int component) {
  switch (component) {
    case glb::kUnsignedByte:
      return 1;
    case glb::kUnsignedShort:
      return 2;
    default:
      return 4;
  }
}

class Binary {
 public:
  Binary(const Document& document, std::string_view bytes) : document_(document), bytes_(bytes) {}

  // type, width  of an element: "VEC3" of 3 numbers.
  [[nodiscard]] Elements elements(std::uint64_t accessor, const std::string& type,
                                  std::size_t width, std::initializer_list<int> components) const {
    const Json& json = document_.element("accessors", accessor, "accessor");
    const auto wrong = [&](const std::string& why) {
      refuse(fmt::format("accessor {} {}", accessor, why));
    };
    if (json.contains("sparse")) wrong("is sparse, which is not read");
    if (Document::member(json, "type") != type) wrong(fmt::format("has not the type {}", type));
    const int component = static_cast<int>(Document::number(json, "componentType"));
    if (std::find(components.begin(), components.end(), component) == components.end())
      wrong(fmt::format("has numbers of the kind {}, which is not read there", component));
    if (Document::member(json, "normalized") == true) wrong("is normalized, which is not read");
    const std::uint64_t count = Document::number(json, "count");
    if (count == 0 || !json.contains("bufferView")) wrong("has no elements");
    const std::uint64_t size = size_of(component) * width;
    const std::uint64_t at = Document::number(json, "bufferView");
    const Json& view = document_.element("bufferViews", at, "bufferView");
    const std::uint64_t stride = Document::number(view, "byteStride", size);
    if (stride < size || stride > 252) wrong(fmt::format("has elements {} bytes apart", stride));
    const std::uint64_t offset = Document::number(json, "byteOffset", 0);
    const std::string_view part = view_of(view, at);
    if (offset + (count - 1) * stride + size > part.size()) {
      wrong(fmt::format("has {} elements, more than the {} bytes of its view hold", count,
                        part.size()));
    }
    return {part.data() + static_cast<std::size_t>(offset), static_cast<std::size_t>(count),
            static_cast<std::size_t>(stride), component};
  }

 private:
  [[nodiscard]] std::string_view view_of(const Json& view, std::uint64_t number) const {
    const std::uint64_t buffer = Document::number(view, "buffer");
    const Json& json = document_.element("buffers", buffer, "buffer");
    if (buffer != 0 || json.contains("uri"))
      refuse("its geometry lies in another file; a GLB for programs has everything in itself");
    const std::uint64_t length = Document::number(json, "byteLength");
    if (length > bytes_.size()) {
      refuse(fmt::format("its buffer has {} bytes, but its binary part only {}", length,
                         bytes_.size()));
    }
    const std::uint64_t offset = Document::number(view, "byteOffset", 0);
    const std::uint64_t size = Document::number(view, "byteLength");
    if (offset + size > length)
      refuse(fmt::format("bufferView {} does not fit into its buffer", number));
    return bytes_.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
  }

  const Document& document_;
  std::string_view bytes_;
};

// ---- the scene

Affine3d placement_of(const Json& node) {
  double m[16];
  Affine3d T = Affine3d::Identity();
  if (Document::numbers(node, "matrix", m, 16)) {
    for (int k = 0; k < 12; ++k) T(k % 3, k / 3) = m[k / 3 * 4 + k % 3];
    return T;
  }
  if (Document::numbers(node, "translation", m, 3)) T.translate(Vector3d(m[0], m[1], m[2]));
  if (Document::numbers(node, "rotation", m, 4)) {
    const Eigen::Quaterniond turn(m[3], m[0], m[1], m[2]);
    if (!(std::abs(turn.norm() - 1.0) < 1e-2))
      refuse("the rotation of a node is no unit quaternion");
    T.rotate(turn.normalized());
  }
  if (Document::numbers(node, "scale", m, 3)) T.scale(Vector3d(m[0], m[1], m[2]));
  return T;
}

class SceneReader {
 public:
  SceneReader(const Document& document, std::string_view binary)
      : document_(document), binary_(document, binary), seen_(document.count("nodes"), false) {}

  TriangleMesh read() {
    add_all();
    return {std::move(vertices_), std::move(triangles_)};
  }

  // Whether `read` and then `scaled` would succeed.
  void check(const Vector3d& factors) {
    add_all();
    check_surface(vertices_, triangles_);
    if (factors == Vector3d::Ones()) return;
    for (Vector3d& each : vertices_) each = factors.cwiseProduct(each);
    check_surface(vertices_, triangles_);
  }

  std::vector<GlbThing> read_things(const std::string& only) {
    std::vector<GlbThing> things;
    std::set<std::string> names;
    std::size_t count = 0;
    walk([&](const Json& node, std::uint64_t number, const Placement& at) {
      if (++count > kMostThings) {
        refuse(fmt::format("it has more than {} nodes with triangles", kMostThings));
      }
      const std::string name = name_of(node, number, names);
      if (!only.empty() && name != only) return;
      try {
        Affine3d T = Affine3d::Identity();
        T.linear() = up() * at.R.transpose() * up().transpose() * at.T.linear();
        add_mesh(Document::number(node, "mesh"), T);
        if (triangles_.empty()) return;
        things.push_back(
            {.name = name,
             .node = static_cast<std::size_t>(number),
             .shape = T.linear(),
             .triangles = {std::exchange(vertices_, {}), std::exchange(triangles_, {})}});
        read_look(Document::number(node, "mesh"), things.back());
        things.back().T_world_thing.translation() = at.T.translation();
        things.back().T_world_thing.linear() = up() * at.R * up().transpose();
        read_extras(node, things.back());
      } catch (const ArgumentError& error) {
        refuse(fmt::format("node \"{}\": {}", name, error.what()));
      }
    });
    if (things.empty())
      refuse(only.empty() ? "there are no triangles in it"
                          : fmt::format("it has no node \"{}\" with triangles", only));
    return things;
  }

 private:
  // The pose of a node: z up, rotated from the axes of the file, without scaling.
  struct Placement {
    Affine3d T;
    Eigen::Matrix3d R;
  };

  // From y up to z up.
  static Eigen::Matrix3d up() {
    Eigen::Matrix3d R;
    R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return R;
  }

  void add_all() {
    walk([&](const Json& node, std::uint64_t, const Placement& at) {
      add_mesh(Document::number(node, "mesh"), at.T);
    });
    if (triangles_.empty()) refuse("there are no triangles in it");
  }

  // Visits all nodes of the scene that have a mesh.
  template <class Visit>
  void walk(Visit&& visit) {
    check_extensions();
    struct Open {
      std::uint64_t node;
      Placement at;
    };
    Affine3d T_up = Affine3d::Identity();
    T_up.linear() = up();
    std::vector<Open> open;
    for (const std::uint64_t root : roots())
      open.push_back({root, {T_up, Eigen::Matrix3d::Identity()}});
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const Json& node = document_.element("nodes", next.node, "node");
      const auto at_node = static_cast<std::size_t>(next.node);
      if (seen_[at_node])
        refuse(fmt::format("node {} is below itself or below two others", next.node));
      seen_[at_node] = true;
      const Affine3d T_node = placement_of(node);
      const Placement at{next.at.T * T_node, next.at.R * rotation_in(T_node.linear())};
      if (node.contains("mesh")) visit(node, next.node, at);
      const Json& children = Document::member(node, "children");
      for (std::size_t k = children.is_array() ? children.size() : 0; k-- > 0;)
        open.push_back({index(children[k], "child of a node"), at});
    }
  }

  std::string name_of(const Json& node, std::uint64_t number, std::set<std::string>& names) const {
    const Json& given = Document::member(node, "name");
    return unique_name(given.is_string() ? given.get<std::string>() : std::string(), number, names);
  }

  // The base colour of the first material of a mesh.
  void read_look(std::uint64_t mesh, GlbThing& thing) const {
    const Json& parts = Document::member(document_.element("meshes", mesh, "mesh"), "primitives");
    for (const Json& part : parts) {
      if (!part.is_object() || !part.contains("material")) continue;
      const Json& material =
          document_.element("materials", Document::number(part, "material"), "material");
      const Json& look = Document::member(material, "pbrMetallicRoughness");
      if (!look.is_object()) return;
      if (Document::numbers(look, "baseColorFactor", thing.look.color.data(), 4))
        thing.color = shown_color(thing.look.color.data());
      return;
    }
  }

  static void read_extras(const Json& node, GlbThing& thing) {
    const Json& extras = Document::member(node, "extras");
    if (!extras.is_object()) return;
    const Json& mass = Document::member(extras, "mass");
    if (mass.is_number()) {
      thing.mass = mass.get<double>();
      if (!std::isfinite(*thing.mass) || *thing.mass < 0.0)
        refuse(fmt::format("its mass is {} kg; expected 0 or more", *thing.mass));
    }
    const Json& fixed = Document::member(extras, "fixed");
    if (fixed.is_boolean()) thing.fixed = fixed.get<bool>();
  }

  void check_extensions() const {
    const Json& required = Document::member(document_.root(), "extensionsRequired");
    if (!required.is_array()) return;
    for (const Json& each : required) {
      const std::string name = each.is_string() ? each.get<std::string>() : std::string("?");
      if (name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_") ||
          name.starts_with("EXT_texture_") || name.starts_with("KHR_lights_"))
        continue;
      refuse(fmt::format("it needs the extension \"{:.60}\", which is not read", name));
    }
  }

  static std::uint64_t index(const Json& value, const char* what) {
    if (!value.is_number_unsigned()) refuse(fmt::format("the {} is no index", what));
    return value.get<std::uint64_t>();
  }

  // The root nodes of the scene that is to be shown; without scenes, all nodes without a parent.
  [[nodiscard]] std::vector<std::uint64_t> roots() const {
    std::vector<std::uint64_t> found;
    if (document_.count("scenes") > 0) {
      const std::uint64_t at = Document::number(document_.root(), "scene", 0);
      const Json& nodes = Document::member(document_.element("scenes", at, "scene"), "nodes");
      if (nodes.is_array()) {
        for (const Json& each : nodes) found.push_back(index(each, "node of a scene"));
      }
      return found;
    }
    std::vector<bool> below(document_.count("nodes"), false);
    for (std::size_t i = 0; i < below.size(); ++i) {
      const Json& children = Document::member(document_.element("nodes", i, "node"), "children");
      if (!children.is_array()) continue;
      for (const Json& each : children) {
        const std::uint64_t child = index(each, "child of a node");
        if (child < below.size()) below[static_cast<std::size_t>(child)] = true;
      }
    }
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (!below[i]) found.push_back(i);
    }
    return found;
  }

  void add_mesh(std::uint64_t number, const Affine3d& T) {
    const Json& parts = Document::member(document_.element("meshes", number, "mesh"), "primitives");
    if (!parts.is_array()) refuse(fmt::format("mesh {} has no primitives", number));
    for (const Json& part : parts) {
      if (++parts_ > kMostParts) refuse("it has more than a million parts");
      if (!part.is_object()) refuse(fmt::format("a primitive of mesh {} is broken", number));
      const std::uint64_t mode = Document::number(part, "mode", glb::kTriangles);
      if (mode >= glb::kTriangles && mode <= 6) add_part(part, mode, T);
    }
  }

  void add_part(const Json& part, std::uint64_t mode, const Affine3d& T) {
    const Json& attributes = Document::member(part, "attributes");
    if (!attributes.is_object() || !attributes.contains("POSITION")) return;  // as glTF demands
    const Elements positions =
        binary_.elements(Document::number(attributes, "POSITION"), "VEC3", 3, {glb::kFloat});
    std::optional<Elements> indices;
    if (part.contains("indices")) {
      indices = binary_.elements(Document::number(part, "indices"), "SCALAR", 1,
                                 {glb::kUnsignedByte, glb::kUnsignedShort, glb::kUnsignedInt});
    }
    const std::size_t corners = indices ? indices->count : positions.count;
    const bool single = mode == glb::kTriangles;
    if (single && corners % 3 != 0) refuse(fmt::format("{} corners make no triangles", corners));
    const std::size_t count = single ? corners / 3 : std::max<std::size_t>(corners, 2) - 2;
    if (triangles_.size() + count > kMostTriangles) {
      refuse(fmt::format("it has more than {} triangles", kMostTriangles));
    }
    if (vertices_.size() + positions.count > kMostVertices)
      refuse(fmt::format("it has more than {} vertices", kMostVertices));
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    add_vertices(positions, T);
    const bool mirrored = T.linear().determinant() < 0.0;
    const auto corner = [&](std::size_t k) {
      return first +
             (indices ? index_at(*indices, k, positions.count) : static_cast<std::uint32_t>(k));
    };
    for (std::size_t i = 0; i < count; ++i) {
      Corners c = single       ? Corners{corner(3 * i), corner(3 * i + 1), corner(3 * i + 2)}
                  : mode == 6  ? Corners{corner(0), corner(i + 1), corner(i + 2)}
                  : i % 2 == 0 ? Corners{corner(i), corner(i + 1), corner(i + 2)}
                               : Corners{corner(i + 1), corner(i), corner(i + 2)};
      if (mirrored) std::swap(c[1], c[2]);
      triangles_.push_back(c);
    }
  }

  void add_vertices(const Elements& positions, const Affine3d& T) {
    for (std::size_t i = 0; i < positions.count; ++i) {
      float p[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string_view bytes(positions.bytes + i * positions.stride + 4 * k, 4);
        p[k] = std::bit_cast<float>(u32(bytes, 0));
      }
      vertices_.emplace_back(T * Vector3d(p[0], p[1], p[2]));
    }
  }

  static std::uint32_t index_at(const Elements& indices, std::size_t k, std::size_t vertices) {
    std::uint32_t value = 0;
    const char* bytes = indices.bytes + k * indices.stride;
    for (std::size_t byte = size_of(indices.component); byte-- > 0;)
      value = value << 8 | static_cast<unsigned char>(bytes[byte]);
    if (value >= vertices)
      refuse(fmt::format("index {} is {}, but there are {} vertices", k, value, vertices));
    return value;
  }

  const Document& document_;
  Binary binary_;
  std::vector<bool> seen_;
  std::size_t parts_ = 0;
  std::vector<Vector3d> vertices_;
  std::vector<Corners> triangles_;
};

}  // namespace

Result<std::vector<GlbThing>> read_glb_things(std::string_view bytes, const std::string& only) try {
  const Chunks chunks = chunks_of(bytes);
  const Document document(chunks.json);
  return SceneReader(document, chunks.binary).read_things(only);
} catch (const ArgumentError& error) {
  return Error{"mesh", error.what()};
}

std::optional<Error> glb_fault(std::string_view bytes, const Vector3d& factors) try {
  const Chunks chunks = chunks_of(bytes);
  const Document document(chunks.json);
  SceneReader(document, chunks.binary).check(factors);
  return std::nullopt;
} catch (const ArgumentError& error) {
  return Error{"mesh", error.what()};
}

Result<TriangleMesh> read_glb(std::string_view bytes) try {
  const Chunks chunks = chunks_of(bytes);
  const Document document(chunks.json);
  return SceneReader(document, chunks.binary).read();
} catch (const ArgumentError& error) {
  return Error{"mesh", error.what()};
}

}  // namespace armlet
