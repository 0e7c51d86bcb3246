// Shapes that are only shown: arrows, lines, texts, disks, ellipsoids and capsules.
//
// They are no bodies: nothing collides with them, rests on them or measures a distance to them.
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

// The frame of a robot that is at its tool point, beside those of Mount.
inline constexpr int kTipFrame = -2;

// size  m: length along z and width of an arrow or a line; height of a text; radius of a disk,
//       which faces along z; semi-axes of an ellipsoid; radius and length of a capsule, which is
//       along z and round behind both ends. What is not named is zero.
// on    what it moves with: the world, an object, or a frame of a robot or its tool point.
// T_on_drawing  its frame there: at the beginning of an arrow, a line and a capsule, in the middle
//               of the others.
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

// Throws ArgumentError that names the drawing and what is wrong: an empty name, no text, a length
// of zero, sizes or positions that are no numbers or out of range, a pose that is none.
void check_drawing(const Drawing& drawing);

// Drawings by name, in the order of their names.
class Drawings {
 public:
  // As many as pages draw without delay.
  static constexpr std::size_t kMost = 20'000;

  // One of that name is replaced.
  // throws  ArgumentError for what check_drawing refuses, and for more than kMost.
  const Drawing& put(Drawing drawing);
  // False: there is none.
  bool remove(std::string_view name);
  // The names of those that are on an object.
  [[nodiscard]] std::vector<std::string> on_object(std::string_view object) const;

  [[nodiscard]] std::size_t size() const { return by_name_.size(); }
  // Null if there is none.
  [[nodiscard]] const Drawing* find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::map<std::string, Drawing, std::less<>> by_name_;
  std::size_t on_objects_ = 0;  // how many are
};

}  // namespace armlet
