// Scenes of triangles as GLB, the binary form of glTF 2.0.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// How a surface looks.
//
// color      red, green, blue, opacity, 0 to 1, linear; a texture is multiplied by it.
// texture    the image that is laid over it; -1: none.
// two_sided  whether it is seen from inside too.
struct GlbMaterial {
  std::string name;
  std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
  double metallic = 0.0;
  double roughness = 0.6;
  int texture = -1;
  bool two_sided = false;
};

// A picture as it is in its own file, a PNG or a JPEG.
struct GlbImage {
  std::string name;
  std::string bytes;
};

// Triangles of one material.
//
// positions  in the frame of the node, m.
// normals    as many, unit vectors.
// on_image   where each lies on the picture, 0 to 1 from its upper left corner; empty: nowhere.
// colors     of each, linear, times that of the material; empty: none.
// corners    three indices for each triangle, counterclockwise seen from outside.
// material   -1: none.
struct GlbPart {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> on_image{};
  std::vector<Eigen::Vector4f> colors{};
  std::vector<std::uint32_t> corners;
  int material = 0;
};

// What a node is moved by: about or along its own z axis. q is the position that T_parent_node of
// the node contains, as its last factor.
struct GlbJoint {
  bool turns = true;
  double q = 0.0;      // rad or m
  double lower = 0.0;  // infinite: none
  double upper = 0.0;
};

// parent  an earlier node; -1: none.
// parts   empty: the node is a frame alone.
struct GlbNode {
  std::string name;
  int parent = -1;
  Eigen::Isometry3d T_parent_node = Eigen::Isometry3d::Identity();
  std::optional<GlbJoint> joint;
  std::vector<GlbPart> parts;
};

// notes  what the scene lacks of what it was made from, a sentence each; glb_notes reads them.
struct GlbScene {
  std::vector<GlbMaterial> materials;
  std::vector<GlbNode> nodes;
  std::vector<GlbImage> images{};
  std::vector<std::string> notes{};
};

// The bytes of a file, the same for the same scene. glTF has y up: nodes without a parent get one
// that turns z up into it.
//
// throws  ArgumentError for a parent that does not come before its node, a material or an image
//         that is not there, an image of another kind, parts whose arrays do not fit together, and
//         a file of more than 4 GB.
// source  Khronos Group, glTF 2.0 specification, 2021, chapters 3 and 4.4 (GLB).
std::string write_glb(const GlbScene& scene);

// Adds the triangles of a mesh, every one flat.
void add_triangles(const TriangleMesh& mesh, const Eigen::Isometry3d& T_node_mesh, GlbPart& part);

// The triangles of a scene, all nodes together, z up, in the frame of the file. Points and lines
// are left out. Only the bytes are read: nothing that they name is opened. Every number is checked
// before it is used; a file takes at most 40 times its size, and 300 MB.
//
// returns  an error whose message says what is wrong, as a sentence without an end: a file that is
//          none or is cut off, sizes and indices that do not fit, extensions that the geometry
//          needs, and what TriangleMesh refuses.
// source   as write_glb.
Result<TriangleMesh> read_glb(std::string_view bytes);
// The error of read_glb, or of `scaled` of what it gives; nothing if both succeed. No mesh is made,
// which takes most of the time.
//
// factors  along the axes of the mesh.
std::optional<Error> glb_fault(std::string_view bytes,
                               const Eigen::Vector3d& factors = Eigen::Vector3d::Ones());
inline constexpr std::size_t kMostGlbBytes = std::size_t{128}
                                             << 20;  // of a file that a program names

// A GLB of a description and its binary part, with notes as GlbScene has them.
//
// throws  ArgumentError for a file of more than 4 GB.
std::string make_glb(std::string json, std::string binary, const std::vector<std::string>& notes);

// The notes of a file, which stand in a chunk of their own that other programs pass over; none if
// there is no such chunk or the file is broken.
std::vector<std::string> glb_notes(std::string_view bytes);

// How many lists and objects of a JSON text lie in one another at most, whether it is whole or not.
int json_depth(std::string_view text);

// The format of a mesh by the ending of its name, in lower case without the dot ("obj"), if armlet
// or its converter reads it; otherwise empty.
std::string_view mesh_format(std::string_view name);
inline constexpr std::string_view kMeshFormats = "OBJ, 3DS, VRML 2.0, STL, DAE, PLY, glTF and GLB";

// A node of a scene that has triangles.
//
// name         of the node, or "node 3"; one that several have gets " 2", " 3" behind it.
// T_world_thing  where it is, z up; what is scaled or sheared is so in its triangles.
// look, color  the colour of its first material, linear and as "#rrggbb"; empty: none.
// mass, fixed  what `extras` of the node say, if anything; kg.
// node, shape  its number in the file, and how the axes of its mesh lie in those of the thing.
struct GlbThing {
  std::string name;
  Eigen::Isometry3d T_world_thing = Eigen::Isometry3d::Identity();
  GlbMaterial look{};
  std::string color{};
  std::optional<double> mass{};
  std::optional<bool> fixed{};
  std::size_t node = 0;
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();
  TriangleMesh triangles;
};

// The nodes of a scene, each with its own triangles, z up; or only the one of that name.
//
// returns  an error as read_glb, which names the node where one is at fault; also for more than
//          kMostThings nodes with triangles, and a name that no node has.
inline constexpr std::size_t kMostThings = 10'000;
Result<std::vector<GlbThing>> read_glb_things(std::string_view bytes, const std::string& only = {});

// A file of one thing at the origin as it is drawn in the file that it was read from: its
// materials, and of the pictures and arrays those that it uses. Pictures, materials, normals and
// colours that are broken, or lie in another file, are left out.
//
// returns  an error as read_glb for bytes that the thing was not read from.
Result<std::string> cut_glb(std::string_view bytes, const GlbThing& thing);

// Whether a file is one by its name, ".glb" in whatever case.
bool is_glb_name(std::string_view name);

}  // namespace armlet
