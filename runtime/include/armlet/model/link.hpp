#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// Friction at the motor's shaft, which rotates at w = gear qd. The joint friction is
//
//   f(qd) = gear^2 viscous qd + |gear| t(w) with the torque of dry friction
//   t(w) = coulomb_plus + (static_torque - coulomb_plus) exp(-(w / stribeck_speed)^2), qd > 0,
//   t(w) = coulomb_minus - (static_torque + coulomb_minus) exp(-(w / stribeck_speed)^2), qd < 0,
//
// and 0 for qd = 0. Without a Stribeck speed t is coulomb_plus or coulomb_minus.
//
// source  R. Stribeck, Die wesentlichen Eigenschaften der Gleit- und Rollenlager, 1902, in the form
//         of B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, Automatica 30(7), 1994.
struct Friction {
  double viscous = 0.0;         // N m s/rad, >= 0
  double coulomb_plus = 0.0;    // N m, >= 0
  double coulomb_minus = 0.0;   // N m, <= 0
  double static_torque = 0.0;   // N m, at least that of Coulomb if there is a Stribeck speed
  double stribeck_speed = 0.0;  // rad/s at the motor, > 0; 0: none
};

// A description may give a link different shapes for drawing and for collision checks.
enum class LinkSolidUse { kBoth, kPicture, kCollision };

// A mesh fixed to a link; shared by all copies of the robot.
//
// triangles  null if the mesh is only drawn and its triangles are made when needed (triangles_of).
// picture    the file that it is drawn from and its scale, if there are no triangles.
struct LinkMesh {
  std::shared_ptr<const TriangleMesh> triangles;
  Eigen::Isometry3d T_link_mesh = Eigen::Isometry3d::Identity();
  LinkSolidUse use = LinkSolidUse::kBoth;
  MeshSource picture{};

  const MeshSource& source() const { return triangles ? triangles->source() : picture; }
};

// Its triangles, or those of its picture.
//
// throws  ArgumentError if it has neither, or a file that read_glb refuses.
std::shared_ptr<const TriangleMesh> triangles_of(const LinkMesh& mesh);

// A simple body fixed to a link, with its centre in its frame's origin; a cylinder lies along z.
//
// size  m: the sides of a box; (radius, length, 0) of a cylinder; (radius, 0, 0) of a sphere.
enum class LinkSolidKind { kBox, kCylinder, kSphere };
struct LinkSolid {
  LinkSolidKind kind = LinkSolidKind::kBox;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Isometry3d T_link_solid = Eigen::Isometry3d::Identity();
  LinkSolidUse use = LinkSolidUse::kBoth;
};

// The rigid body moved by a joint, and the motor of the joint. Positions are in the link's own DH
// frame: the far end of the link for the standard convention, the near end for the modified one.
struct Link {
  double mass = 0.0;                                  // kg
  Eigen::Vector3d com = Eigen::Vector3d::Zero();      // centre of mass, m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre of mass, kg m^2
  double motor_inertia = 0.0;                         // of the rotor, kg m^2
  // motor revolutions per joint revolution; may be negative
  double gear = 1.0;
  Friction friction;
  std::string mesh;               // file of the shape; empty: none
  double mesh_unit = 0.0;         // m in one unit of it; 0: as the file says
  double mesh_scale = 1.0;        // of the shape in the file
  std::vector<LinkMesh> bodies;   // meshes that were read; they replace shapes from the table
  std::vector<LinkSolid> solids;  // simple bodies, likewise
  // In a robot description: its own name, then those of the links that are fixed to it.
  std::vector<std::string> names;

  // Whether a shape was given, so that none is made from the joint table.
  bool has_shape() const { return !bodies.empty() || !solids.empty(); }
  // Whether drawings show one of its meshes, or one of its simple bodies.
  bool draws_mesh() const { return any_drawn(bodies); }
  bool draws_solid() const { return any_drawn(solids); }

 private:
  template <class Parts>
  static bool any_drawn(const Parts& parts) {
    for (const auto& each : parts) {
      if (each.use != LinkSolidUse::kCollision) return true;
    }
    return false;
  }
};

// A rigid body fixed to the flange in addition to the last link: the held object.
//
// com      its centre of mass in the frame of the flange, m.
// inertia  about its centre of mass along the axes of the flange, kg m^2; zero: a point mass.
struct Payload {
  double mass = 0.0;  // kg
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

// The rigid body composed of both.
Payload together(const Payload& a, const Payload& b);

}  // namespace armlet
