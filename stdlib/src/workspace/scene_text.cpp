// Converts files that describe worlds to programs that declare objects.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "armlet/core/files.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/mesh/glb.hpp"
#include "armlet/model/urdf.hpp"
#include "armlet/stdlib/load_world.hpp"
#include "armlet/world/object.hpp"
#include "values/bind.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr std::size_t kMostText = 16 << 20;
constexpr std::size_t kMostObjects = kMostThings;

Error broken(std::string why) { return Error{"world", std::move(why)}; }

// Exact to 1e-12, without an exponent, which could not precede a unit.
std::string digits(double value) {
  std::string text = fmt::format("{:.12f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string place_text(const Isometry3d& T) {
  const Vector3d p = T.translation();
  std::string text = fmt::format("xyz({}m, {}m, {}m)", digits(p.x()), digits(p.y()), digits(p.z()));
  const Vector3d rpy = rpy_from_R(T.linear());
  constexpr const char* kTurns[] = {"rotX", "rotY", "rotZ"};
  for (const int axis : {2, 1, 0}) {
    if (const std::string angle = digits(rpy[axis]); angle != "0")
      text += fmt::format(" * {}({}rad)", kTurns[axis], angle);
  }
  return text;
}

// A text between quotes; names in scenes may contain any character.
std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= ' ') out += c;
  }
  return out + "\"";
}

// Names that are valid in programs, each used once.
class Names {
 public:
  std::string make(std::string_view name) {
    std::string clean;
    for (const char c : name.substr(0, 60)) {
      const bool fits =
          std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
      clean += fits ? c : '_';
    }
    if (clean.empty() || std::isdigit(static_cast<unsigned char>(clean[0])) != 0 ||
        clean.find_first_not_of('_') == std::string::npos)
      clean = "thing_" + clean;
    if (is_taken(clean)) clean += "_";
    std::string unique = clean;
    for (int k = 2; !used_.insert(unique).second; ++k) unique = fmt::format("{}_{}", clean, k);
    return unique;
  }

 private:
  // Words of the language and names of library functions, which the text itself needs.
  static bool is_taken(const std::string& name) {
    static const std::set<std::string, std::less<>> taken = [] {
      std::set<std::string, std::less<>> names;
      for (const LanguageWord& word : reserved_and_soft_words()) names.emplace(word.text);
      for (const bind::Chapter& chapter : bind::chapters())
        for (const NativeFunction& function : chapter.functions) names.emplace(function.name);
      return names;
    }();
    return taken.contains(name);
  }
  std::set<std::string> used_;
};

// One declaration of an object.
struct Declared {
  std::string name;
  std::string shape;
  Isometry3d T_on_obj = Isometry3d::Identity();
  std::string rest;  // further fields, each after "; "

  [[nodiscard]] std::string text() const {
    return fmt::format("object {} {{ shape: {}; at: {}{} }}\n", name, shape, place_text(T_on_obj),
                       rest);
  }
};

// ---- GLB

// notes  gets the parts that are left out because they are empty; not all parts may be.
Result<std::string> text_of_glb(const std::string& bytes, const std::string& file,
                                std::vector<std::string>& notes) {
  const Result<std::vector<GlbThing>> things = read_glb_things(bytes);
  if (!things.ok()) return things.error();
  Names names;
  std::string text;
  for (const GlbThing& each : *things) {
    if (!each.triangles.is_closed()) {
      notes.push_back(fmt::format("node \"{}\": {}; an object needs an inside to have a volume",
                                  each.name, each.triangles.open_because()));
      continue;
    }
    const Vector3d middle = 0.5 * (each.triangles.low() + each.triangles.high());
    Declared object{
        .name = names.make(each.name),
        .shape = fmt::format("mesh({}, part: {})", in_quotes(file), in_quotes(each.name)),
        .T_on_obj = each.T_world_thing * Eigen::Translation3d(middle)};
    if (each.mass) object.rest += fmt::format("; mass: {}kg", digits(*each.mass));
    if (!each.color.empty()) object.rest += fmt::format("; color: \"{}\"", each.color);
    if (each.fixed.value_or(false)) object.rest += "; fixed: true";
    text += object.text();
  }
  if (text.empty()) return broken(notes.front());
  return text;
}

// ---- URDF

class UrdfText {
 public:
  UrdfText(const std::vector<UrdfLink>& links, std::string folder, const MeshConverter& convert)
      : links_(links), folder_(std::move(folder)), convert_(convert) {}

  Result<std::string> make() {
    std::size_t count = 0;
    for (const UrdfLink& each : links_) count += each.parts.size();
    if (count > kMostObjects)
      return broken(fmt::format("it has {} bodies; expected {} at most", count, kMostObjects));
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (auto error = add(i)) return *error;
    }
    if (text_.empty()) return broken("no link of it has a shape");
    return std::move(text_);
  }

 private:
  // The body that a link is fixed to: an object, or the world.
  struct Known {
    std::string object;  // empty: none
    Isometry3d T_world_obj = Isometry3d::Identity();
    bool is_fixed = true;
  };

  std::optional<Error> add(std::size_t i) {
    const UrdfLink& link = links_[i];
    if (!(link.link.mass >= 0.0)) {
      return broken(fmt::format("the mass of link `{}` is {} kg; expected 0 or more", link.name,
                                link.link.mass));
    }
    Known at = link.parent < 0 ? Known{} : known_[static_cast<std::size_t>(link.parent)];
    const bool begins = link.parent < 0;
    if (begins) at.is_fixed = !link.is_free && link.link.mass == 0.0;
    bool first = true;
    for (const UrdfPart& part : link.parts) {
      auto shape = shape_of(link, part);
      if (!shape.ok()) return shape.error();
      const Isometry3d T_world_obj = link.T_world_link * part.T_link_part * shape->T_part_obj;
      const bool is_on = !at.is_fixed && !at.object.empty();
      Declared object{
          .name = names_.make(link.name),
          .shape = std::move(shape->text),
          .T_on_obj = is_on ? Isometry3d(at.T_world_obj.inverse() * T_world_obj) : T_world_obj};
      if (is_on) object.rest += "; on: " + at.object;
      if (first && link.link.mass > 0.0)
        object.rest += mass_text(link, T_world_obj.inverse() * link.T_world_link);
      if (!part.color.empty()) object.rest += fmt::format("; color: \"{}\"", part.color);
      if (is_on || at.is_fixed) object.rest += "; fixed: true";
      text_ += object.text();
      if (at.object.empty() || (first && at.is_fixed))
        at = {.object = object.name, .T_world_obj = T_world_obj, .is_fixed = at.is_fixed};
      first = false;
    }
    known_.push_back(at);
    return std::nullopt;
  }

  static std::string mass_text(const UrdfLink& link, const Isometry3d& T_obj_link) {
    const Vector3d com = T_obj_link * link.link.com;
    std::string text = fmt::format("; mass: {}kg; com: [{}m, {}m, {}m]", digits(link.link.mass),
                                   digits(com.x()), digits(com.y()), digits(com.z()));
    if (link.link.inertia.isZero(0.0)) return text;
    const Eigen::Matrix3d turned =
        T_obj_link.linear() * link.link.inertia * T_obj_link.linear().transpose();
    const Eigen::Matrix3d I = 0.5 * (turned + turned.transpose());
    text += "; inertia: [";
    for (int row = 0; row < 3; ++row) {
      text += fmt::format("{}[{}, {}, {}]", row == 0 ? "" : ", ", I(row, 0) + 0.0, I(row, 1) + 0.0,
                          I(row, 2) + 0.0);
    }
    return text + "]";
  }

  struct ShapeText {
    std::string text;
    Isometry3d T_part_obj = Isometry3d::Identity();
  };
  Result<ShapeText> shape_of(const UrdfLink& link, const UrdfPart& part) const {
    const Vector3d& size = part.solid.size;
    if (!part.mesh.empty()) return mesh_of(link, part);
    switch (part.solid.kind) {
      case LinkSolidKind::kBox:
        return ShapeText{fmt::format("box({}m, {}m, {}m)", digits(size.x()), digits(size.y()),
                                     digits(size.z()))};
      case LinkSolidKind::kCylinder:
        return ShapeText{
            fmt::format("cylinder(radius: {}m, height: {}m)", digits(size.x()), digits(size.y()))};
      case LinkSolidKind::kSphere:
        return ShapeText{fmt::format("sphere({}m)", digits(size.x()))};
    }
    return broken("a link has a shape of no kind");
  }

  Result<ShapeText> mesh_of(const UrdfLink& link, const UrdfPart& part) const {
    const auto refuse = [&](const std::string& why) {
      return broken(fmt::format("the mesh \"{}\" of link `{}` cannot be used: {}", part.mesh,
                                link.name, why));
    };
    const double scale = part.scale.x();
    if (part.scale.y() != scale || part.scale.z() != scale)
      return refuse("it is scaled by other factors along its axes; write them into the file");
    const std::string path = find_mesh(folder_, folder_, part.mesh);
    if (path.empty()) return refuse("there is no such file in the folder of the world");
    const std::string name =
        std::filesystem::path(path).lexically_relative(folder_).generic_string();
    const Result<std::string> bytes = glb_of(name);
    if (!bytes.ok()) return refuse(bytes.error().message);
    const Result<TriangleMesh> mesh = read_glb(*bytes);
    if (!mesh.ok()) return refuse(mesh.error().message);
    if (!mesh->is_closed()) return refuse(mesh->open_because());
    ShapeText shape{.text = fmt::format("mesh({}{})", in_quotes(name),
                                        scale == 1.0 ? "" : fmt::format(", scale: {}", scale))};
    shape.T_part_obj.translation() = 0.5 * scale * (mesh->low() + mesh->high());
    return shape;
  }

  [[nodiscard]] Result<std::string> glb_of(const std::string& name) const {
    if (!is_glb_name(name) && !mesh_format(name).empty() && convert_)
      return convert_(folder_, name, 0.0, {});
    const Result<Folder> folder = Folder::open(folder_);
    return folder.ok() ? folder->read(name, kMostGlbBytes) : folder.error();
  }

  const std::vector<UrdfLink>& links_;
  std::string folder_;
  const MeshConverter& convert_;
  Names names_;
  std::vector<Known> known_;
  std::string text_;
};

Result<std::string> text_of_urdf(const std::string& urdf, const std::string& folder,
                                 const MeshConverter& convert) {
  const Result<std::vector<UrdfLink>> links = read_urdf_scene(urdf);
  if (!links.ok()) return links.error();
  return UrdfText(*links, folder, convert).make();
}

}  // namespace

// An error for a file that is neither a text nor a scene; a mesh is only one body of a world.
std::optional<Error> no_world(const std::string& file, std::string_view text) {
  const std::string_view format = mesh_format(file);
  const bool is_text = text.find('\0') == std::string_view::npos;
  if (format.empty() && is_text) return std::nullopt;
  constexpr std::string_view kWorlds =
      "a world is a .rbt file that declares objects, or a scene as GLB or URDF";
  if (format.empty()) return broken(fmt::format("it is no text; {}", kWorlds));
  const std::string scene = std::filesystem::path(file).stem().string() + ".glb";
  if (format == "gltf") {
    return broken(
        fmt::format("{}; make a GLB of it: armlet mesh convert {} {}", kWorlds, file, scene));
  }
  return broken(fmt::format(
      "it is a mesh; {}, such as one with the line object part {{ shape: mesh({}); at: "
      "xyz(400mm, 0mm, 200mm) }}, or the GLB that this makes: armlet mesh convert {} {}",
      kWorlds, in_quotes(file), file, scene));
}

Result<WorldText> load_world(const std::string& path, const MeshConverter& convert) {
  const std::filesystem::path file(path);
  const std::string folder = file.parent_path().empty() ? "." : file.parent_path().string();
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_glb = ending == ".glb", is_urdf = ending == ".urdf" || ending == ".xml";
  Result<std::string> text = read_file(path, is_glb ? kMostGlbBytes : kMostText);
  if (!text.ok()) return text.error();
  std::vector<std::string> notes;
  if (!is_glb) {
    if (auto error = no_world(file.filename().string(), *text)) return *error;
  }
  if (is_glb) text = text_of_glb(*text, file.filename().string(), notes);
  if (is_urdf) text = text_of_urdf(*text, folder, convert);
  if (!text.ok()) return text.error();
  const std::string name =
      is_glb || is_urdf || ending == ".rbt" ? file.stem().string() : file.filename().string();
  return WorldText{
      .name = name, .text = std::move(text).value(), .folder = folder, .notes = std::move(notes)};
}

}  // namespace armlet
