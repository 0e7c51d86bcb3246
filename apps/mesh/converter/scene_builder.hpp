#pragma once
// Triangles of any origin as a scene that can be written as GLB, each number checked.

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
// normal    of any length; zero: follows from the triangle.
// on_image  0 to 1 from the lower left corner of the picture, v up, as OBJ, VRML and DAE have it.
// color     red, green, blue, opacity as on a screen (sRGB).
struct Corner {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector2d> on_image{};
  std::optional<Eigen::Vector4d> color{};
};

// The picture of a name, checked: PNG or JPEG, whole as far as its parts say, at most 8192 pixels
// wide and high and 32 MB.
//
// returns  nothing and a note if it is not there or of another kind.
// throws   ArgumentError if it is there and cannot be used.
std::optional<GlbImage> load_image(Files& files, const std::string& name,
                                   std::vector<std::string>& notes);
// throws  as load_image, for bytes that are at hand.
void check_image(std::string_view bytes, const std::string& name);

class SceneBuilder {
 public:
  // unit  m in one unit of the file.
  SceneBuilder(Files& files, double unit) : files_(files), unit_(unit) {}

  // A colour of a screen.
  //
  // texture  the name of a picture; empty: none.
  // returns  the index of the material; the same one for the same values.
  int material(const std::string& name, const Eigen::Vector4d& color, const std::string& texture,
               bool two_sided);
  void note(std::string text);

  // throws  ArgumentError for numbers that are none or beyond 10 km, and for too many triangles.
  void add_triangle(int material, const std::array<Corner, 3>& corners);

  [[nodiscard]] std::size_t triangles() const { return triangles_; }
  // throws  ArgumentError if there are no triangles.
  [[nodiscard]] GlbScene finish(const std::string& name) &&;

 private:
  // Of the vertices that are there already, in single precision.
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
