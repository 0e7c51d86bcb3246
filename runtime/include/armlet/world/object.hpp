#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// Shapes, each in its own frame with the origin in the centre; a cylinder stands along z. A cone
// stands on its base, its frame at half the height; a plane is a rectangle without thickness that
// faces up. Metres.
struct Box {
  Eigen::Vector3d size{0.04, 0.04, 0.04};
  bool operator==(const Box&) const = default;
};
struct Cylinder {
  double radius = 0.02;
  double height = 0.04;
  bool operator==(const Cylinder&) const = default;
};
struct Sphere {
  double radius = 0.02;
  bool operator==(const Sphere&) const = default;
};
struct Cone {
  double radius = 0.02;
  double height = 0.04;
  bool operator==(const Cone&) const = default;
};
struct Plane {
  Eigen::Vector2d size{0.1, 0.1};
  bool operator==(const Plane&) const = default;
};
// A closed surface of triangles about the centre of its bounding box, in which its frame lies.
//
// triangles  shared by all objects of the shape; never null in an object.
// density    kg/m^3; 0: not known.
// file       from which it was read, for messages.
struct Mesh {
  std::shared_ptr<const TriangleMesh> triangles;
  double density = 0.0;
  std::string file;
  bool operator==(const Mesh&) const = default;
};
using Shape = std::variant<Box, Cylinder, Sphere, Cone, Plane, Mesh>;

// Moves the centre of the bounding box of a mesh into the origin.
//
// throws  ArgumentError with the reason if the surface is open or encloses no volume.
Mesh make_mesh(const TriangleMesh& triangles, double density = 0.0, std::string file = {});

// Mass from the density of a shape, kg; 0 if it has no density.
double mass_of(const Shape& shape);

// Volume, m^3; 0 for a plane.
double volume_of(const Shape& shape);

// The range of sizes, kSmallest to kLargest, and of positions, up to kLargest from the origin. In
// it distances are exact to nanometres near the origin and to micrometres at its end.
inline constexpr double kSmallest = 1e-6;  // m
inline constexpr double kLargest = 1e4;    // m

// A rigid body in the cell. Its frame is the centre of its shape.
//
// T_world_obj  pose of the object.
// p_obj_grasp  grasp point, in its own frame; the centre unless given.
// mass         kg, 0 if unknown.
// friction     coefficient of Coulomb friction on its surface.
// stiffness    contact force for each metre of depth, N/m.
// color        a name or "#rrggbb".
// texture      bytes of a PNG or JPEG that its surface shows, shared with renderers; null: none.
// p_obj_com    its centre of mass, m; nothing: that of a body of uniform density.
// inertia_com  about its centre of mass along the object's axes, kg m^2; nothing: likewise.
// fixed        true for parts of the cell, such as a table: they cannot be grasped.
struct Object {
  std::string name;
  Shape shape;
  Eigen::Isometry3d T_world_obj = Eigen::Isometry3d::Identity();
  Eigen::Vector3d p_obj_grasp = Eigen::Vector3d::Zero();
  double mass = 0.0;
  double friction = 0.5;
  double stiffness = 5e4;
  std::string color = "gray";
  std::shared_ptr<const std::string> texture{};
  std::optional<Eigen::Vector3d> p_obj_com{};
  std::optional<Eigen::Matrix3d> inertia_com{};
  bool fixed = false;
};

// Throws ArgumentError with the object and the wrong number: an empty name, a size or position that
// is out of range, a negative mass or friction, a stiffness that is not above zero, a matrix that
// is not a pose.
void check_object(const Object& object);
// Throws ArgumentError with the object and the wrong number for an invalid pose.
void check_place(std::string_view name, const Eigen::Isometry3d& T_world_obj);

// Centre of mass in its own frame, m. For uniform density it is the origin, except for a cone or
// mesh.
Eigen::Vector3d center_of_mass(const Object& object);

// Inertia about the centre of mass in the object's axes, kg m^2: that of uniform density unless it
// was given.
Eigen::Matrix3d inertia(const Object& object);

// Opening that a parallel gripper needs to close on the object, m: its full width along the
// direction in which the fingers move.
//
// across  unit vector along which the fingers close, in world axes (the x axis of the tool).
double grasp_width(const Object& object, const Eigen::Vector3d& across);

// The grasp line of a long body, on which a gripper may take it in addition to its grasp point. It
// runs through the centre along the longest side, to both sides by half of the amount by which that
// side is longer than the next one. Returns the vector from the centre to the end of the line, in
// the object's frame; zero for a cube, a sphere, a flat disc.
Eigen::Vector3d grasp_line(const Object& object);

// Distance from a point of the world to the nearest point at which a gripper may take the object
// (its grasp point, its centre or its grasp line), m.
double grasp_distance(const Object& object, const Eigen::Vector3d& p_world);

// The point at which a gripper that comes from above takes the object, in the world: its grasp
// point if it has one, otherwise its centre, or for a long body that is not horizontal the upper
// part of its grasp line.
Eigen::Vector3d grasp_from_above(const Object& object);

// "box", "cylinder", "sphere", "cone", "plane" or "mesh".
std::string shape_name(const Shape& shape);

}  // namespace armlet
