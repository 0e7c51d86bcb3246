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
// color  red, green, blue, opacity, 0 to 1, linear.
struct GlbMaterial {
  std::string name;
  std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
  double metallic = 0.0;
  double roughness = 0.6;
};

// Triangles of one material.
//
// positions  in the frame of the node, m.
// normals    as many, unit vectors.
// corners    three indices for each triangle, counterclockwise seen from outside.
struct GlbPart {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
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

struct GlbScene {
  std::vector<GlbMaterial> materials;
  std::vector<GlbNode> nodes;
};

// The bytes of a file, the same for the same scene. glTF has y up: nodes without a parent get one
// that turns z up into it.
//
// throws  ArgumentError for a parent that does not come before its node, a material that is not
//         there, parts whose arrays do not fit together, and a file of more than 4 GB.
// source  Khronos Group, glTF 2.0 specification, 2021, chapters 3 and 4.4 (GLB).
std::string write_glb(const GlbScene& scene);

// The triangles of a scene, all nodes together, z up, in the frame of the file. Points and lines
// are left out. Only the bytes are read: nothing that they name is opened. Every number is checked
// before it is used; a file takes at most 40 times its size, and 300 MB.
//
// returns  an error whose message says what is wrong, as a sentence without an end: a file that is
//          none or is cut off, sizes and indices that do not fit, extensions that the geometry
//          needs, and what TriangleMesh refuses.
// source   as write_glb.
Result<TriangleMesh> read_glb(std::string_view bytes);

// A node of a scene that has triangles.
//
// name         of the node, or "node 3"; one that several have gets " 2", " 3" behind it.
// T_world_thing  where it is, z up; what is scaled or sheared is so in its triangles.
// color        "#rrggbb" of its first material; empty: none.
// mass, fixed  what `extras` of the node say, if anything; kg.
struct GlbThing {
  std::string name;
  Eigen::Isometry3d T_world_thing = Eigen::Isometry3d::Identity();
  std::string color{};
  std::optional<double> mass{};
  std::optional<bool> fixed{};
  TriangleMesh triangles;
};

// The nodes of a scene, each with its own triangles, z up; or only the one of that name.
//
// returns  an error as read_glb, which names the node where one is at fault; also for more than
//          kMostThings nodes with triangles, and a name that no node has.
inline constexpr std::size_t kMostThings = 10'000;
Result<std::vector<GlbThing>> read_glb_things(std::string_view bytes,
                                              const std::string& only = {});

// Whether a file is one by its name, ".glb" in whatever case.
bool is_glb_name(std::string_view name);

}  // namespace armlet
