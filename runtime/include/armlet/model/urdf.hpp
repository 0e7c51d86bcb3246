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
  // Returns whether a mesh exists, by its name in the file ("package://arm/link1.stl"). Null: the
  // existence of meshes is not checked.
  std::function<bool(const std::string&)> has_mesh{};
  // Reads a mesh as GLB, or returns null for a file type that is not supported; called once for
  // each name. Null: no meshes are read. Meshes for collision checks become triangles; of meshes
  // that are only drawn the bytes are kept (LinkMesh::picture).
  std::function<Result<std::shared_ptr<const std::string>>(const std::string&)> load_glb{};
};

// The links and joints of a robot description (URDF 1.0) as a mechanism, the root link as its base.
// Mimic joints become couplings, and continuous joints have no limits (kNoLimit). Angles within
// 1e-5 rad of a right angle count as right ("1.5708"). An effort or a speed of 0 counts as not
// given. Damping and friction belong to the joint; URDF has neither rotor inertia nor gear.
//
// An inertia that no body has is ignored (Body::inertia_fault), and so is a mesh that is missing or
// cannot be read; MechanismSpec::notes reports the meshes.
//
// returns  an error that names the link or joint: broken XML; a link that is its own parent,
//          missing or not connected; a kind of joint that an arm cannot have; texts that are not
//          numbers; swapped limits; elements of a xacro file.
Result<Mechanism> read_urdf(std::string_view text, const UrdfOptions& options = {});

// A part of a link of a fixed scene.
//
// mesh   file that the scene names, if the part is a mesh; otherwise empty, and `solid` is its
//        shape.
// scale  of the mesh, along its axes.
// color  "#rrggbb"; empty: none.
struct UrdfPart {
  LinkSolid solid{};
  std::string mesh{};
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Isometry3d T_link_part = Eigen::Isometry3d::Identity();
  std::string color{};
};

// A link of a fixed scene; the link that it is fixed to comes before it.
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

// A robot description as a scene of links that are fixed to each other or free. Its parts are those
// of visual elements, or of collision elements of a link without visual ones.
//
// returns  an error as read_urdf, and for a revolute or prismatic joint.
Result<std::vector<UrdfLink>> read_urdf_scene(std::string_view text);

// The mechanism as a URDF that read_urdf and other programs read. Numbers read back to the same
// bits, except rotations, which URDF stores as angles. Tips become links of their own. A comment at
// a joint has what URDF cannot express: the inertia of its rotor, friction that differs between the
// directions or has static friction.
//
// throws  ArgumentError if a joint is driven by several actuators at once, which URDF cannot
//         express.
std::string write_urdf(const Mechanism& mechanism);

// Folders of packages, in addition to the folders around a URDF.
//
// named    folders of packages by name.
// folders  that contain packages as folders of their name, or are packages, as in ROS_PACKAGE_PATH.
struct PackageFolders {
  std::map<std::string, std::string> named{};
  std::vector<std::string> folders{};
};

// Finds a mesh that a URDF names: relative to the folder of the URDF, "file://" and
// "package://name/...", where the package is a folder of that name at or above the URDF, or one of
// `packages`.
//
// urdf_folder  folder of the URDF.
// top          folders above this one are not searched, except `packages`; empty: no limit.
// returns      the path, or an empty text if there is no such file.
std::string find_mesh(const std::string& urdf_folder, const std::string& top,
                      const std::string& name, const PackageFolders& packages = {});

}  // namespace armlet
