#include "armlet/backend/run_hash.hpp"

#include <fmt/format.h>

namespace armlet {
namespace {

constexpr Ignore<FigureChanged, Undone> kNotHashed{};

void add(Fnv1a& hash, std::span<const double> values) {
  hash.add(static_cast<std::uint64_t>(values.size()));
  for (const double value : values) hash.add(value);
}

// The rotation and the translation, by columns.
void add(Fnv1a& hash, const Eigen::Isometry3d& pose) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) hash.add(pose.matrix()(row, column));
  }
}

void add(Fnv1a& hash, const JointInfo& joint) {
  hash.add(static_cast<int>(joint.unit));
  for (const double value : {joint.lower, joint.upper, joint.max_speed}) hash.add(value);
  add(hash, joint.T_before_joint);
  add(hash, joint.T_joint_link);
}

void add(Fnv1a& hash, const RobotInfo& robot) {
  hash.add(robot.name);
  hash.add(static_cast<std::uint64_t>(robot.joints.size()));
  for (const JointInfo& joint : robot.joints) add(hash, joint);
  for (const RowInfo& row : robot.rows) {
    add(hash, row.moves);
    hash.add(static_cast<std::uint64_t>(row.joint));
    hash.add(row.ratio);
    hash.add(row.offset);
  }
  add(hash, robot.home);
  add(hash, robot.T_world_base);
  if (robot.on >= 0) hash.add(static_cast<std::uint64_t>(robot.on));
  hash.add(robot.tool.kind);
  for (const double value : {robot.tool.stroke, robot.tool.radius, robot.tool.length})
    hash.add(value);
  add(hash, robot.tool.T_flange_tool);
}

void add(Fnv1a& hash, const ObjectInfo& object) {
  hash.add(object.name);
  hash.add(object.shape);
  add(hash, object.size);
  hash.add(object.mass);
  hash.add(object.color);
  add(hash, object.T_world_obj);
}

void add(Fnv1a& hash, const Axis& axis) {
  hash.add(axis.label);
  hash.add(axis.unit);
  hash.add(static_cast<int>(axis.log));
}

void add(Fnv1a& hash, const Figure& figure) {
  hash.add(figure.title);
  for (const Axis* axis : {&figure.x, &figure.y, &figure.z, &figure.right}) add(hash, *axis);
  hash.add(static_cast<std::uint64_t>(figure.series.size()));
  for (const Series& series : figure.series) {
    hash.add(static_cast<int>(series.kind));
    hash.add(series.label);
    for (const auto* values : {&series.x, &series.y, &series.z}) add(hash, *values);
    hash.add(static_cast<int>(series.right));
  }
  hash.add(static_cast<std::uint64_t>(figure.names.size()));
  for (const std::string& name : figure.names) hash.add(name);
  if (figure.picture != nullptr) {
    hash.add(figure.picture->width());
    hash.add(figure.picture->channels());
    hash.add(pixel_hash(figure.picture->bytes()));
    hash.add(figure.note);
  }
  hash.add(static_cast<std::uint64_t>(figure.panels.size()));
  for (const Figure& panel : figure.panels) add(hash, panel);
}

void add(Fnv1a& hash, const CameraInfo& camera) {
  hash.add(camera.name);
  for (const int number : {camera.width, camera.height, camera.robot, camera.link})
    hash.add(number);
  for (const double value :
       {camera.fx, camera.fy, camera.cx, camera.cy, camera.near, camera.far, camera.rate})
    hash.add(value);
  add(hash, camera.distortion);
  hash.add(camera.object);
  hash.add(camera.frame);
  add(hash, camera.T_on_camera);
}

void add(Fnv1a& hash, const BeginRun& begin) {
  hash.add(static_cast<std::uint64_t>(begin.run.robots.size()));
  for (const RobotInfo& robot : begin.run.robots) add(hash, robot);
  hash.add(static_cast<std::uint64_t>(begin.run.objects.size()));
  for (const ObjectInfo& object : begin.run.objects) add(hash, object);
  for (const CameraInfo& camera : begin.run.cameras) add(hash, camera);
}
void add(Fnv1a& hash, const RobotAdded& added) { add(hash, added.robot); }
void add(Fnv1a& hash, const RobotChanged& changed) {
  hash.add(changed.index);
  add(hash, changed.robot);
}
void add(Fnv1a& hash, const JointSample& sample) {
  hash.add(sample.robot);
  hash.add(sample.motion);
  for (const auto& values : {sample.q, sample.qd, sample.qdd}) add(hash, values);
  add(hash, sample.T_world_tool);
}
void add(Fnv1a& hash, const ObjectAdded& added) { add(hash, added.object); }
void add(Fnv1a& hash, const ObjectSample& sample) {
  hash.add(sample.name);
  add(hash, sample.T_world_obj);
}
void add(Fnv1a& hash, const ObjectEvent& event) {
  hash.add(static_cast<int>(event.change));
  hash.add(event.name);
  hash.add(event.robot);
}
void add(Fnv1a& hash, const Note& note) {
  hash.add(static_cast<int>(note.kind));
  hash.add(note.text);
}
void add(Fnv1a& hash, const FinalFigure& final_figure) {
  hash.add(final_figure.index);
  if (final_figure.figure != nullptr) add(hash, *final_figure.figure);
}
void add(Fnv1a&, const EndRun&) {}
void add(Fnv1a& hash, const DrawingChanged& changed) {
  const DrawingInfo& drawing = changed.drawing;
  for (const std::string* text :
       {&drawing.name, &drawing.kind, &drawing.text, &drawing.color, &drawing.object})
    hash.add(*text);
  for (const double size : drawing.size) hash.add(size);
  for (const int number : {drawing.robot, drawing.link, changed.removed ? 1 : 0}) hash.add(number);
  add(hash, drawing.T_on_drawing);
}
void add(Fnv1a& hash, const CameraAdded& added) { add(hash, added.camera); }
// The path of its file is left out.
void add(Fnv1a& hash, const ImageFrame& frame) {
  hash.add(frame.camera);
  hash.add(frame.frame);
  for (const int number : {frame.width, frame.height, frame.channels}) hash.add(number);
  hash.add(pixel_hash(frame));
  add(hash, frame.T_world_camera);
}

}  // namespace

void RunHash::on(const Event& event) {
  if (ignores().has(kind_of(event))) return;
  hash_.add(static_cast<std::uint64_t>(event.index()));
  hash_.add(time_of(event));
  std::visit(Overload{[this](const auto& each) { add(hash_, each); }, kNotHashed}, event);
}

EventKinds RunHash::ignores() const { return kNotHashed.kinds(); }

std::string RunHash::text() const { return fmt::format("{:016x}", value()); }

}  // namespace armlet
