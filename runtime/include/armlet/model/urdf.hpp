#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"

namespace armlet {

struct UrdfOptions {
  InertiaCheck inertia_check = InertiaCheck::kRigidBody;
  // Says whether a mesh exists, by the name that the file gives ("package://arm/link1.stl"). Null:
  // meshes are not looked for.
  std::function<bool(const std::string&)> has_mesh{};
  // Reads one as GLB, or gives null for a kind of file that is not read. Null: no meshes are read.
  // Called once for each name. Triangles are made of those for collisions; of those that are only
  // drawn the bytes are kept (LinkMesh::picture).
  std::function<Result<std::shared_ptr<const std::string>>(const std::string&)> load_glb{};
};

// The links and joints of a robot description (URDF 1.0) as a mechanism, the root link as its base.
// Mimic joints become couplings, continuous joints have no limits (kNoLimit),
// angles within 1e-5 rad of a right angle count as right ("1.5708"), an effort or a speed of 0 as
// one that the file does not give. Damping and friction belong to the joint; URDF knows no rotor
// and no gear.
//
// An inertia that no body has is left out (Body::inertia_fault), and so is a mesh that is missing
// or cannot be read; MechanismSpec::notes says so of meshes.
//
// returns  an error that names the link or joint: broken XML, a link that is its own parent,
//          missing or not connected, a joint of a kind that an arm has not, numbers that are none,
//          swapped limits, elements of a xacro file.
Result<Mechanism> read_urdf(std::string_view text, const UrdfOptions& options = {});

// A part of a link of a fixed scene.
//
// mesh   file that the scene names, if it is one; otherwise empty, and `solid` says what it is.
// scale  of the mesh, along its axes.
// color  "#rrggbb"; empty: none.
struct UrdfPart {
  LinkSolid solid{};
  std::string mesh{};
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Isometry3d T_link_part = Eigen::Isometry3d::Identity();
  std::string color{};
};

// A link of a fixed scene, the one before it first.
//
// parent        index of the link that it is fixed to; -1: none, or it is free to move.
// T_world_link  pose of the link in the scene.
// link          mass, centre of mass and inertia, in the frame of the link.
struct UrdfLink {
  std::string name;
  int parent = -1;
  bool is_free = false;
  Eigen::Isometry3d T_world_link = Eigen::Isometry3d::Identity();
  Link link;
  std::vector<UrdfPart> parts;
};

// What a robot description shows that has no joints of a robot: a scene of links that are fixed to
// each other or float. Parts are those of visual elements, or of collision elements of a link
// without visual ones.
//
// returns  an error as read_urdf, and for a joint that turns or slides.
Result<std::vector<UrdfLink>> read_urdf_scene(std::string_view text);

// The mechanism as a URDF that read_urdf and others understand; numbers read back to the same bits
// but for rotations, of which URDF gives the angles. Tips become links of their own. A comment at a
// joint says what URDF cannot: the inertia of its rotor, friction that differs between the
// directions or sticks.
//
// throws  ArgumentError if a joint is driven by several actuators at once, which URDF cannot say.
std::string write_urdf(const Mechanism& mechanism);

// Where packages are besides the folders around a URDF.
//
// named    folders of packages by name.
// folders  which hold packages as folders of their name, or are one, as ROS_PACKAGE_PATH lists
//          them.
struct PackageFolders {
  std::map<std::string, std::string> named{};
  std::vector<std::string> folders{};
};

// Finds a mesh that a URDF names: relative to the folder of the URDF, "file://" and
// "package://name/...", where the package is a folder of that name at or above the URDF, or one of
// `packages`.
//
// urdf_folder  folder of the URDF.
// top          nothing above this folder is looked at but packages; empty: no limit.
// returns      the path, or an empty text if there is no such file.
std::string find_mesh(const std::string& urdf_folder, const std::string& top,
                      const std::string& name, const PackageFolders& packages = {});

}  // namespace armlet
