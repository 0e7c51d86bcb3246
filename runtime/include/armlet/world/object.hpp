#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "armlet/mesh/triangle_mesh.hpp"

namespace armlet {

// Shapes in their own frame, which lies in the centre; a cylinder stands along z. A cone stands on
// its base, its frame at half the height; a plane is a rectangle without thickness that faces up.
// Metres.
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
// A closed surface of triangles about the middle of the box around it, in which its frame lies.
//
// triangles  shared by all objects of the shape; never null in an object.
// density    kg/m^3; 0: not known.
// file       where it comes from, for people.
struct Mesh {
  std::shared_ptr<const TriangleMesh> triangles;
  double density = 0.0;
  std::string file;
  bool operator==(const Mesh&) const = default;
};
using Shape = std::variant<Box, Cylinder, Sphere, Cone, Plane, Mesh>;

// Moves the middle of the box around a mesh into the origin.
//
// throws  ArgumentError if the surface is open or holds nothing, and why.
Mesh make_mesh(const TriangleMesh& triangles, double density = 0.0, std::string file = {});

// Mass that follows from the density of a shape, kg; 0 if it has none.
double mass_of(const Shape& shape);

// m^3; 0 for a plane.
double volume_of(const Shape& shape);

// Sizes from kSmallest to kLargest and positions up to kLargest from the origin can be computed
// with: distances are right to nanometres next to the origin and to micrometres there.
inline constexpr double kSmallest = 1e-6;  // m
inline constexpr double kLargest = 1e4;    // m

// A rigid body in the cell. Its frame is the centre of its shape.
//
// T_world_obj  where it is.
// p_obj_grasp  where a hand takes it, in its own frame; the centre unless told otherwise.
// mass         kg, 0 if unknown.
// friction     coefficient of Coulomb friction on its surface.
// stiffness    force on what is pressed into it, for each metre of depth, N/m.
// color        a name or "#rrggbb".
// texture      bytes of a PNG or JPEG that its surface shows, shared with who draws it; null: none.
// p_obj_com    its centre of mass, m; nothing: that of an even body.
// inertia_com  about its centre of mass along the object's axes, kg m^2; nothing: the same.
// fixed        true for what belongs to the cell, such as a table: it cannot be grasped.
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

// Throws ArgumentError that names the object and the number that is wrong: an empty name, a size
// or position that is out of range, a negative mass or friction, a stiffness that is not above
// zero, a pose that is not one.
void check_object(const Object& object);
// The same for a pose alone.
void check_place(std::string_view name, const Eigen::Isometry3d& T_world_obj);

// Centre of mass in its own frame, m: of a body of even density the origin, but for a cone or mesh.
Eigen::Vector3d center_of_mass(const Object& object);

// Inertia about the centre of mass in the object's axes, kg m^2: that of a body of even density
// unless it was given.
Eigen::Matrix3d inertia(const Object& object);

// How far a parallel gripper must open to close on the object, m: its whole width along the line on
// which the fingers move.
//
// across  unit vector along which the fingers close, in world axes (the x axis of the tool).
double grasp_width(const Object& object, const Eigen::Vector3d& across);

// Where a hand may take a long body besides its grasp point: on the line through its centre along
// its longest side, to both sides as far as half of what that side is longer than the next one. The
// returned vector leads from the centre to the end of that line, in the object's frame; zero for a
// cube, a sphere, a flat disc.
Eigen::Vector3d grasp_line(const Object& object);

// Distance from a point of the world to where a hand may take the object: its grasp point, its
// centre or its grasp line, whichever is nearest, m.
double grasp_distance(const Object& object, const Eigen::Vector3d& p_world);

// Where a hand that comes from above takes the object, in the world: its grasp point if it has one,
// otherwise its centre, or for a long body that does not lie the upper part of its grasp line.
Eigen::Vector3d grasp_from_above(const Object& object);

// "box", "cylinder", "sphere", "cone", "plane" or "mesh".
std::string shape_name(const Shape& shape);

}  // namespace armlet
