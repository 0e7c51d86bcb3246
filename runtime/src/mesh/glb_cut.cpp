// A node of a file as a file of its own, with its materials.
#include <map>
#include <utility>

#include "armlet/mesh/glb.hpp"
#include "mesh/glb_document.hpp"

namespace armlet {
namespace {

using glb::Document;
using glb::Json;
using glb::refuse;

// Rotates y up, as in files, to z up.
Eigen::Matrix3d from_file() {
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return R;
}

bool is_drawn(const std::string& attribute) {
  return attribute == "POSITION" || attribute == "NORMAL" || attribute == "TANGENT" ||
         attribute.starts_with("TEXCOORD_") || attribute.starts_with("COLOR_");
}

// Copies the parts of a file that a node needs. Elements get new numbers: each is copied once, in
// the order of its first use.
class NodeCut {
 public:
  NodeCut(const Document& document, std::string_view binary)
      : document_(document), binary_(binary) {}

  std::string glb(const GlbThing& thing) {
    const Json& node = document_.element("nodes", thing.node, "node");
    const Json mesh = mesh_of(Document::number(node, "mesh"));
    const Eigen::Matrix3d M = from_file().transpose() * thing.shape;
    Json matrix = Json::array();
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row)
        matrix.push_back(column < 3 && row < 3 ? M(row, column) : row == column ? 1.0 : 0.0);
    }
    Json root = {{"asset", {{"version", "2.0"}, {"generator", "armlet"}}},
                 {"scene", 0},
                 {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
                 {"nodes", Json::array({{{"name", thing.name}, {"mesh", 0}, {"matrix", matrix}}})},
                 {"meshes", Json::array({mesh})},
                 {"buffers", Json::array({{{"byteLength", cut_.size()}}})}};
    for (auto& [list, kept] : lists_) {
      if (!kept.elements.empty()) root[list] = std::move(kept.elements);
    }
    for (const char* each : {"extensionsUsed", "extensionsRequired"}) {
      const Json& names = Document::member(document_.root(), each);
      if (names.is_array()) root[each] = names;
    }
    return make_glb(root.dump(-1, ' ', false, Json::error_handler_t::replace), std::move(cut_), {});
  }

 private:
  // The copied elements of one list, and their new numbers.
  struct Kept {
    Json elements = Json::array();
    std::map<std::uint64_t, std::size_t> numbers{};
  };

  // adapt  changes the references in the copy to the new numbers.
  template <class Adapt>
  std::size_t keep(const char* list, std::uint64_t number, Adapt&& adapt) {
    if (const auto known = lists_[list].numbers.find(number); known != lists_[list].numbers.end())
      return known->second;
    Json copy = document_.element(list, number, list);
    adapt(copy);
    Kept& kept = lists_[list];
    const std::size_t at = kept.elements.size();
    kept.numbers.emplace(number, at);
    kept.elements.push_back(std::move(copy));
    return at;
  }

  Json mesh_of(std::uint64_t number) {
    const Json& given = document_.element("meshes", number, "mesh");
    Json parts = Json::array();
    const Json& all = Document::member(given, "primitives");
    for (std::size_t i = 0; all.is_array() && i < all.size(); ++i) {
      if (all[i].is_object() && has_triangles(all[i])) add_part(all[i], parts);
    }
    if (parts.empty()) refuse("there are no triangles in it");
    return {{"primitives", parts}};
  }

  // Whether a mesh has triangles. Points and lines are left out, as in read_glb_things.
  static bool has_triangles(const Json& given) {
    const std::uint64_t mode = Document::number(given, "mode", glb::kTriangles);
    return mode >= glb::kTriangles && mode <= 6;
  }

  // Positions and corners are required; anything else that cannot be used is left out.
  void add_part(const Json& given, Json& parts) {
    const Json& attributes = Document::member(given, "attributes");
    if (!attributes.is_object() || !attributes.contains("POSITION")) return;
    Json part = {{"attributes", {{"POSITION", accessor(attributes["POSITION"])}}}};
    for (const auto& [name, index] : attributes.items()) {
      if (name == "POSITION" || !is_drawn(name)) continue;
      if_usable([&, &key = name, &at = index] {
        if (is_plain(at)) part["attributes"][key] = accessor(at);
      });
    }
    if (given.contains("indices")) part["indices"] = accessor(Document::member(given, "indices"));
    if (given.contains("mode")) part["mode"] = Document::number(given, "mode");
    if_usable([&] {
      if (given.contains("material"))
        part["material"] = material(Document::number(given, "material"));
    });
    parts.push_back(std::move(part));
  }

  template <class Take>
  static void if_usable(Take&& take) try {
    take();
  } catch (const ArgumentError&) {  // it is drawn without this
  }

  // Whether an array is stored plainly in the binary part.
  [[nodiscard]] bool is_plain(const Json& index) const {
    if (!index.is_number_unsigned()) return false;
    const Json& json = document_.element("accessors", index.get<std::uint64_t>(), "accessor");
    return json.contains("bufferView") && !json.contains("sparse");
  }

  std::size_t accessor(const Json& index) {
    if (!is_plain(index)) refuse("an accessor has no elements");
    return keep("accessors", index.get<std::uint64_t>(), [&](Json& json) {
      json["bufferView"] = view(Document::number(json, "bufferView"));
    });
  }

  std::size_t view(std::uint64_t number) {
    return keep("bufferViews", number, [&](Json& json) {
      const std::uint64_t offset = Document::number(json, "byteOffset", 0);
      const std::uint64_t size = Document::number(json, "byteLength");
      if (Document::number(json, "buffer") != 0 || offset + size > binary_.size())
        refuse(fmt::format("bufferView {} does not fit into its buffer", number));
      cut_.resize((cut_.size() + 3) / 4 * 4, '\0');
      json["byteOffset"] = cut_.size();
      cut_ += binary_.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
    });
  }

  std::size_t material(std::uint64_t number) {
    return keep("materials", number, [&](Json& json) { keep_textures(json); });
  }

  // Copies all members called ...Texture, also in extensions.
  void keep_textures(Json& json) {
    if (!json.is_object()) return;
    for (auto each = json.begin(); each != json.end();) {
      const bool is_texture = each.key().ends_with("Texture") && each->is_object();
      if (is_texture && !keep_texture(*each)) {
        each = json.erase(each);
        continue;
      }
      if (!is_texture) keep_textures(*each);
      ++each;
    }
  }

  // False: its picture cannot be used.
  bool keep_texture(Json& reference) try {
    reference["index"] = keep("textures", Document::number(reference, "index"), [&](Json& json) {
      bool has_picture = keep_picture(json);
      if (json.contains("sampler"))
        json["sampler"] = keep("samplers", Document::number(json, "sampler"), [](Json&) {});
      if (json.contains("extensions") && json["extensions"].is_object()) {
        for (auto& each : json["extensions"]) {
          if (each.is_object()) has_picture = keep_picture(each) || has_picture;
        }
      }
      if (!has_picture) refuse("a texture has no picture");
    });
    return true;
  } catch (const ArgumentError&) {
    return false;
  }

  bool keep_picture(Json& json) {
    if (!json.contains("source")) return false;
    json["source"] = keep("images", Document::number(json, "source"), [&](Json& image) {
      if (image.contains("bufferView")) {
        image["bufferView"] = view(Document::number(image, "bufferView"));
        return;
      }
      const Json& uri = Document::member(image, "uri");
      if (!uri.is_string() || !uri.get<std::string>().starts_with("data:"))
        refuse("a picture lies in another file");
    });
    return true;
  }

  const Document& document_;
  std::string_view binary_;
  std::string cut_;
  std::map<std::string, Kept> lists_;
};

}  // namespace

Result<std::string> cut_glb(std::string_view bytes, const GlbThing& thing) try {
  const glb::Chunks chunks = glb::chunks_of(bytes);
  const Document document(chunks.json);
  return NodeCut(document, chunks.binary).glb(thing);
} catch (const ArgumentError& error) {
  return Error{"mesh", error.what()};
}

}  // namespace armlet
