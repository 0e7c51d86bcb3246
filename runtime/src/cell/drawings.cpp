// Shapes that are only shown (world/drawings.hpp).

#include <fmt/format.h>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"

namespace armlet {

void Cell::draw(Drawing drawing) {
  const Mount& on = drawing.on;
  if (on.base == FrameBase::kObject) (void)world_.at(on.on);
  if (on.base == FrameBase::kCarrier && on.frame != kTipFrame)
    (void)T_world_link(on.carrier, on.frame);
  if (on.base == FrameBase::kCarrier) (void)robot(on.carrier);
  if (on.base == FrameBase::kFrame) {
    const std::string frame = on.on;
    const Mount to = world_.mount_of_frame(frame);
    const auto T_world_frame = world_.T_world_frame(frame);
    if (!T_world_frame) {
      throw ArgumentError(
          fmt::format("The frame \"{}\" is on \"{}\", which was removed.", frame, to.on));
    }
    drawing.on = to;
    if (drawing.on.base == FrameBase::kFrame) drawing.on.base = FrameBase::kWorld;
    Eigen::Isometry3d T_world_on = Eigen::Isometry3d::Identity();
    if (to.base == FrameBase::kObject) T_world_on = world_.at(to.on).T_world_obj;
    if (to.base == FrameBase::kCarrier) T_world_on = T_world_link(to.carrier, to.frame);
    drawing.T_on_drawing = T_world_on.inverse() * *T_world_frame * drawing.T_on_drawing;
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
  const Mount& on = drawing->on;
  if (on.base == FrameBase::kObject) return world_.at(on.on).T_world_obj * drawing->T_on_drawing;
  if (on.base != FrameBase::kCarrier) return drawing->T_on_drawing;
  const Eigen::Isometry3d T_world_frame =
      on.frame == kTipFrame ? T_world_tool(on.carrier) : T_world_link(on.carrier, on.frame);
  return T_world_frame * drawing->T_on_drawing;
}

}  // namespace armlet
