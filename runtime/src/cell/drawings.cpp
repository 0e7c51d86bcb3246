// Shapes that are only shown (world/drawings.hpp).

#include <fmt/format.h>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"

namespace armlet {

void Cell::draw(Drawing drawing) {
  const Mount on = drawing.on;
  const Eigen::Isometry3d T_world_on = T_world_mount(on);
  if (on.base == FrameBase::kFrame) {  // stays where the frame is now
    drawing.on = world_.mount_of_frame(on.on);
    drawing.T_on_drawing = T_world_mount(drawing.on).inverse() * T_world_on * drawing.T_on_drawing;
  }
  publish_drawing(drawings_.put(std::move(drawing)), false);
}

bool Cell::undraw(std::string_view name) {
  const Drawing* known = drawings_.find(name);
  if (known == nullptr) return false;
  publish_drawing(*known, true);
  return drawings_.remove(name);
}

Eigen::Isometry3d Cell::T_world_drawing(std::string_view name) const {
  const Drawing* drawing = drawings_.find(name);
  if (drawing == nullptr) throw ArgumentError(fmt::format("There is no drawing \"{}\".", name));
  return T_world_mount(drawing->on) * drawing->T_on_drawing;
}

}  // namespace armlet
