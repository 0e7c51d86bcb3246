#include "armlet/world/drawings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "armlet/core/error.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

constexpr std::size_t kLongestText = 1000;  // bytes

// Number of elements of `size` that a shape uses.
int size_count(DrawingKind kind) {
  switch (kind) {
    case DrawingKind::kText:
    case DrawingKind::kDisk:
      return 1;
    case DrawingKind::kEllipsoid:
      return 3;
    case DrawingKind::kArrow:
    case DrawingKind::kLine:
    case DrawingKind::kCapsule:
      return 2;
  }
  return 0;
}

bool is_on_object(const Drawing& drawing) { return drawing.on.base == FrameBase::kObject; }

}  // namespace

std::string_view to_text(DrawingKind kind) {
  switch (kind) {
    case DrawingKind::kArrow:
      return "arrow";
    case DrawingKind::kLine:
      return "line";
    case DrawingKind::kText:
      return "text";
    case DrawingKind::kDisk:
      return "disk";
    case DrawingKind::kEllipsoid:
      return "ellipsoid";
    case DrawingKind::kCapsule:
      return "capsule";
  }
  return "";
}

Eigen::Isometry3d frame_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = from;
  const Eigen::Vector3d along = to - from;
  const double length = along.norm();
  if (!(length > 0.0) || !std::isfinite(length)) return T;
  T.linear() = rotation_from_z(along);
  return T;
}

void check_drawing(const Drawing& drawing) {
  if (drawing.name.empty()) throw ArgumentError("A drawing needs a name.");
  check_place(drawing.name, drawing.T_on_drawing);
  if (drawing.kind == DrawingKind::kText) {
    if (drawing.text.empty())
      throw ArgumentError(fmt::format("The text \"{}\" says nothing.", drawing.name));
    if (drawing.text.size() > kLongestText) {
      throw ArgumentError(fmt::format("The text \"{}\" has {} bytes; at most {} are drawn.",
                                      drawing.name, drawing.text.size(), kLongestText));
    }
  }
  const bool has_length = drawing.kind == DrawingKind::kArrow || drawing.kind == DrawingKind::kLine;
  if (has_length && drawing.size[0] == 0.0) {
    throw ArgumentError(fmt::format("The {} \"{}\" has no length: it ends where it begins.",
                                    to_text(drawing.kind), drawing.name));
  }
  for (int i = 0; i < size_count(drawing.kind); ++i) {
    const double size = drawing.size[i];
    if (std::isfinite(size) && size >= kSmallest && size <= kLargest) continue;
    const std::string given = std::abs(size) < 1.0 ? fmt::format("{:.6g} mm", size * 1000.0)
                                                   : fmt::format("{:.6g} m", size);
    throw ArgumentError(fmt::format("A size of the {} \"{}\" is {}; expected 0.001 mm to 10 km.",
                                    to_text(drawing.kind), drawing.name, given));
  }
}

const Drawing& Drawings::put(Drawing drawing) {
  check_drawing(drawing);
  auto at = by_name_.find(drawing.name);
  if (at == by_name_.end()) {
    if (by_name_.size() >= kMost) {
      throw ArgumentError(fmt::format(
          "\"{}\" would be one drawing more than the {} that there may be.", drawing.name, kMost));
    }
    std::string name = drawing.name;
    at = by_name_.emplace(std::move(name), Drawing{}).first;
  }
  on_objects_ += is_on_object(drawing) ? 1U : 0U;
  on_objects_ -= is_on_object(at->second) ? 1U : 0U;
  at->second = std::move(drawing);
  return at->second;
}

bool Drawings::remove(std::string_view name) {
  const auto at = by_name_.find(name);
  if (at == by_name_.end()) return false;
  on_objects_ -= is_on_object(at->second) ? 1U : 0U;
  by_name_.erase(at);
  return true;
}

std::vector<std::string> Drawings::on_object(std::string_view object) const {
  std::vector<std::string> names;
  if (on_objects_ == 0) return names;
  for (const auto& [name, drawing] : by_name_) {
    if (is_on_object(drawing) && drawing.on.on == object) names.push_back(name);
  }
  return names;
}

const Drawing* Drawings::find(std::string_view name) const {
  const auto at = by_name_.find(name);
  return at == by_name_.end() ? nullptr : &at->second;
}

std::vector<std::string> Drawings::names() const {
  std::vector<std::string> names;
  for (const auto& [name, drawing] : by_name_) names.push_back(name);
  return names;
}

}  // namespace armlet
