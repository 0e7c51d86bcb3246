// Shapes that are only shown: arrows, lines, texts, disks, ellipsoids and capsules.
//
// They are not bodies: nothing collides with them, rests on them or measures a distance to them.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/world/world.hpp"

namespace armlet {

enum class DrawingKind : std::uint8_t { kArrow, kLine, kText, kDisk, kEllipsoid, kCapsule };

// The frame of a robot at its tool point, in addition to those of Mount.
inline constexpr int kTipFrame = -2;

// size  m: length along z and width of an arrow or a line; height of a text; radius of a disk,
//       which faces along z; semi-axes of an ellipsoid; radius and length of a capsule, which lies
//       along z with a half ball beyond each end. Other elements are zero.
// on    what the shape moves with: the world, an object, or a frame of a robot or its tool point.
// T_on_drawing  its pose there: the origin is at the start of an arrow, a line and a capsule, and
//               in the centre of other shapes.
struct Drawing {
  std::string name;
  DrawingKind kind = DrawingKind::kArrow;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  std::string text{};
  std::string color = "gray";
  Mount on{};
  Eigen::Isometry3d T_on_drawing = Eigen::Isometry3d::Identity();
};

// "arrow", "line", "text", "disk", "ellipsoid" or "capsule".
std::string_view to_text(DrawingKind kind);

// The frame of an arrow, a line or a capsule from one point to another: z along it. The points may
// be the same; then z is up.
Eigen::Isometry3d frame_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// Throws ArgumentError with the name of the drawing and the error: an empty name, no text, a length
// of zero, sizes or positions that are not finite or out of range, a matrix that is not a pose.
void check_drawing(const Drawing& drawing);

// Drawings by name, in the order of their names.
class Drawings {
 public:
  // The number that pages draw without delay.
  static constexpr std::size_t kMost = 20'000;

  // Adds a drawing, or replaces the one of that name.
  // throws  ArgumentError for what check_drawing refuses, and for more than kMost.
  const Drawing& put(Drawing drawing);
  // Removes a drawing; false: there is none.
  bool remove(std::string_view name);
  // The names of the drawings that are mounted on an object.
  [[nodiscard]] std::vector<std::string> on_object(std::string_view object) const;

  [[nodiscard]] std::size_t size() const { return by_name_.size(); }
  // Null if there is none.
  [[nodiscard]] const Drawing* find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::map<std::string, Drawing, std::less<>> by_name_;
  std::size_t on_objects_ = 0;  // number of drawings mounted on objects
};

}  // namespace armlet
