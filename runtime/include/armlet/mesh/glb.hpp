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

// The appearance of a surface.
//
// color      red, green, blue, opacity, 0 to 1, linear; a texture is multiplied by it.
// texture    the image on it; -1: none.
// two_sided  whether its back is drawn too.
struct GlbMaterial {
  std::string name;
  std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
  double metallic = 0.0;
  double roughness = 0.6;
  int texture = -1;
  bool two_sided = false;
};

// A picture in the format of its own file, PNG or JPEG.
struct GlbImage {
  std::string name;
  std::string bytes;
};

// Triangles of one material.
//
// positions  in the frame of the node, m.
// normals    as many, unit vectors.
// on_image   point of the texture at each position, 0 to 1 from its upper left corner; empty: none.
// colors     of each position, linear, times that of the material; empty: none.
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

// The joint of a node, about or along its own z axis. q is the joint value that is contained in
// T_parent_node of the node, as its last factor.
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

// notes  what the source of the scene had and the scene lacks, a sentence each; glb_notes reads
//        them.
struct GlbScene {
  std::vector<GlbMaterial> materials;
  std::vector<GlbNode> nodes;
  std::vector<GlbImage> images{};
  std::vector<std::string> notes{};
};

// The bytes of a file, the same for the same scene. glTF has y up: nodes without a parent get a
// parent that rotates z to y.
//
// throws  ArgumentError for a parent that does not come before its node, a material or an image
//         that does not exist, an image of another format, parts whose arrays do not match, and a
//         file of more than 4 GB.
// source  Khronos Group, glTF 2.0 specification, 2021, chapters 3 and 4.4 (GLB).
std::string write_glb(const GlbScene& scene);

// Adds the triangles of a mesh, with flat shading.
void add_triangles(const TriangleMesh& mesh, const Eigen::Isometry3d& T_node_mesh, GlbPart& part);

// The triangles of a scene, all nodes together, z up, in the frame of the file. Points and lines
// are left out. Files that the bytes refer to are not opened. Every number is checked before it is
// used; a file needs at most 40 times its size of memory, and 300 MB.
//
// returns  an error whose message is a sentence without a full stop: a file of another format or
//          incomplete, sizes and indices that do not match, unsupported extensions that the
//          geometry needs, and what TriangleMesh refuses.
// source   as write_glb.
Result<TriangleMesh> read_glb(std::string_view bytes);
// The error of read_glb, or of `scaled` of its result; nothing if both succeed. It does not build
// the mesh, which takes most of the time.
//
// factors  along the axes of the mesh.
std::optional<Error> glb_fault(std::string_view bytes,
                               const Eigen::Vector3d& factors = Eigen::Vector3d::Ones());
inline constexpr std::size_t kMostGlbBytes = std::size_t{128}
                                             << 20;  // of a file that a program names

// A GLB of a JSON description and its binary part, with notes like those of GlbScene.
//
// throws  ArgumentError for a file of more than 4 GB.
std::string make_glb(std::string json, std::string binary, const std::vector<std::string>& notes);

// The notes of a file, which are in a chunk of their own that other programs ignore; none if there
// is no such chunk or the file is broken.
std::vector<std::string> glb_notes(std::string_view bytes);

// The nesting depth of a JSON text, complete or not.
int json_depth(std::string_view text);

// The format of a mesh by the ending of its name, in lower case without the dot ("obj"), if armlet
// or its converter can read it; otherwise empty.
std::string_view mesh_format(std::string_view name);
inline constexpr std::string_view kMeshFormats = "OBJ, 3DS, VRML 2.0, STL, DAE, PLY, glTF and GLB";

// A node of a scene that has triangles.
//
// name         of the node, or "node 3"; repeated names get " 2", " 3" at the end.
// T_world_thing  its pose, z up; scaling and shearing are applied to its triangles.
// look, color  the colour of its first material, linear and as "#rrggbb"; empty: none.
// mass, fixed  from `extras` of the node, if they are there; kg.
// node, shape  its number in the file, and the matrix from the axes of its mesh to those of the
//              thing.
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
// returns  an error as read_glb, with the faulty node; also for more than kMostThings nodes with
//          triangles, and a name that no node has.
inline constexpr std::size_t kMostThings = 10'000;
Result<std::vector<GlbThing>> read_glb_things(std::string_view bytes, const std::string& only = {});

// A file with one thing at the origin, with the materials, pictures and arrays that it uses in the
// file that it was read from. Pictures, materials, normals and colours that are broken, or in
// another file, are left out.
//
// returns  an error as read_glb if the thing was not read from these bytes.
Result<std::string> cut_glb(std::string_view bytes, const GlbThing& thing);

// Whether the name of a file ends in ".glb", in upper or lower case.
bool is_glb_name(std::string_view name);

}  // namespace armlet
