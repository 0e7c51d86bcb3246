#pragma once
// Collects triangles of any origin, with checks of each number, to a scene that is written as GLB.

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "armlet/mesh/glb.hpp"
#include "converter/files.hpp"

namespace armlet::mesh {

// A corner of a triangle.
//
// position  units of the file, z up.
// normal    of any length; zero: computed from the triangle.
// on_image  texture coordinates, 0 to 1 from the lower left corner of the picture, v up, as in OBJ,
//           VRML and DAE.
// color     red, green, blue, opacity in sRGB.
struct Corner {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector2d> on_image{};
  std::optional<Eigen::Vector4d> color{};
};

// The picture with a name, after checks: PNG or JPEG, complete according to its header, at most
// 8192 pixels wide and high, and 32 MB.
//
// returns  nullopt and a note if it does not exist or has another format.
// throws   ArgumentError if it exists and cannot be used.
std::optional<GlbImage> load_image(Files& files, const std::string& name,
                                   std::vector<std::string>& notes);
// throws  as load_image, for bytes in memory.
void check_image(std::string_view bytes, const std::string& name);

class SceneBuilder {
 public:
  // unit  length of one unit of the file, m.
  SceneBuilder(Files& files, double unit) : files_(files), unit_(unit) {}

  // color    in sRGB.
  // texture  the name of a picture; empty: none.
  // returns  the index of the material; equal materials have the same
  //          index.
  int material(const std::string& name, const Eigen::Vector4d& color, const std::string& texture,
               bool two_sided);
  void note(std::string text);

  // throws  ArgumentError for numbers that are not finite or beyond 10 km, and for too many
  //         triangles.
  void add_triangle(int material, const std::array<Corner, 3>& corners);

  [[nodiscard]] std::size_t triangles() const { return triangles_; }
  // throws  ArgumentError if there are no triangles.
  [[nodiscard]] GlbScene finish(const std::string& name) &&;

 private:
  // The key by which equal vertices are found, in single precision.
  using Key = std::array<float, 12>;
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  struct Part {
    GlbPart part;
    std::unordered_map<Key, std::uint32_t, Hash> known;
  };

  int texture(const std::string& name);
  [[nodiscard]] Key key_of(const Corner& corner, const Eigen::Vector3d& normal) const;

  Files& files_;
  double unit_;
  std::size_t triangles_ = 0;
  GlbScene scene_;
  std::map<std::string, int> images_;
  std::map<std::string, int> materials_;
  std::map<std::array<int, 3>, Part> parts_;  // material, with pictures, with colours
};

}  // namespace armlet::mesh
