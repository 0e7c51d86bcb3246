#include "armlet/collision/solid.hpp"

namespace armlet {
namespace {

Solid round_solid(Solid::Core core, double radius, double height) {
  return {.core = core, .half = {radius, radius, 0.5 * height}};
}

struct OfShape {
  Solid operator()(const Box& box) const {
    return {.core = Solid::Core::kBox, .half = 0.5 * box.size};
  }
  Solid operator()(const Cylinder& cylinder) const {
    return round_solid(Solid::Core::kCylinder, cylinder.radius, cylinder.height);
  }
  Solid operator()(const Cone& cone) const {
    return round_solid(Solid::Core::kCone, cone.radius, cone.height);
  }
  Solid operator()(const Plane& plane) const {
    return {.core = Solid::Core::kBox, .half = {0.5 * plane.size.x(), 0.5 * plane.size.y(), 0.0}};
  }
  Solid operator()(const Mesh& mesh) const { return solid_of(*mesh.triangles); }
  Solid operator()(const Sphere& sphere) const { return {.margin = sphere.radius}; }
};

}  // namespace

double Solid::reach() const {
  if (mesh != nullptr) return mesh->reach() + margin;
  // A box reaches its corner; round bodies have the radius twice in `half`.
  const bool round = core == Core::kCylinder || core == Core::kCone;
  const double across = round ? half.x() : std::sqrt(half.x() * half.x() + half.y() * half.y());
  return std::sqrt(across * across + half.z() * half.z()) + margin;
}

Solid solid_of(const Shape& shape) { return std::visit(OfShape{}, shape); }

Solid solid_of(const TriangleMesh& mesh) {
  return {.core = mesh.is_convex() ? Solid::Core::kHull : Solid::Core::kMesh,
          .half = 0.5 * (mesh.high() - mesh.low()),
          .mesh = &mesh};
}

Solid solid_of(const LinkShape& shape) {
  Solid solid;
  switch (shape.kind) {
    case LinkShapeKind::kCapsule:
      solid = {.core = Solid::Core::kSegment,
               .half = {0.0, 0.0, 0.5 * shape.length},
               .margin = shape.radius};
      break;
    case LinkShapeKind::kCylinder:
    case LinkShapeKind::kRing:
      solid = round_solid(Solid::Core::kCylinder, shape.radius, shape.length);
      break;
    case LinkShapeKind::kBox:
      solid = {.core = Solid::Core::kBox, .half = 0.5 * shape.size};
      break;
  }
  solid.T = shape.T_link_shape;
  return solid;
}

}  // namespace armlet
