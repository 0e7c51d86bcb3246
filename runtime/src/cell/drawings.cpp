// Shapes that are only shown (world/drawings.hpp), and trails, which are made of them.

#include <fmt/format.h>

#include <algorithm>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"

namespace armlet {

void Cell::draw(Drawing drawing) {
  const Mount on = drawing.on;
  const Eigen::Isometry3d T_world_on = T_world_mount(on);
  if (on.base == FrameBase::kFrame) {  // keeps the present pose of the frame
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

// ---- trails ---------------------------------------------------------------------------------

namespace {

constexpr double kWidestTrail = 1.0;       // m
constexpr double kShortestPiece = 0.0001;  // m; shorter pieces are not drawn

std::string piece_name(const Cell& cell, int robot, int piece) {
  return fmt::format("trail of {} {}", cell.robot(robot).name, piece);
}

}  // namespace

void Trails::begin(const Cell& cell, int robot, std::string color, double width) {
  if (!(width > 0.0) || width > kWidestTrail) {
    throw ArgumentError(
        fmt::format("The width of a trail is {} m; expected more than 0 and at most 1 m.", width));
  }
  const Eigen::Vector3d now = cell.T_world_tool(robot).translation();
  const auto known = std::ranges::find(trails_, robot, &Trail::robot);
  if (known == trails_.end()) {
    trails_.push_back({robot, std::move(color), width, now});
    return;
  }
  known->color = std::move(color);
  known->width = width;
}

void Trails::extend(Cell& cell, int robot, bool at_end) {
  const auto found = std::ranges::find(trails_, robot, &Trail::robot);
  if (found == trails_.end()) return;
  Trail& trail = *found;
  const Eigen::Vector3d now = cell.T_world_tool(robot).translation();
  const double far = (now - trail.last).norm();
  if (far < (at_end ? kShortestPiece : kPiece) || cell.drawings().size() >= Drawings::kMost) return;
  if (trail.pieces >= kMostPieces) cell.undraw(piece_name(cell, robot, trail.pieces - kMostPieces));
  cell.draw({.name = piece_name(cell, robot, trail.pieces++),
             .kind = DrawingKind::kLine,
             .size = {far, trail.width, 0.0},
             .color = trail.color,
             .T_on_drawing = frame_between(trail.last, now)});
  trail.last = now;
}

}  // namespace armlet
