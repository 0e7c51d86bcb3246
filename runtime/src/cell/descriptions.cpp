#include "cell/descriptions.hpp"

#include "armlet/model/joint_coupling.hpp"

namespace armlet {
namespace {

struct ShapeSize {
  std::vector<double> operator()(const Box& box) const {
    return {box.size.x(), box.size.y(), box.size.z()};
  }
  std::vector<double> operator()(const Mesh& mesh) const {
    const Eigen::Vector3d size = mesh.triangles->high() - mesh.triangles->low();
    return {size.x(), size.y(), size.z()};
  }
  std::vector<double> operator()(const Sphere& sphere) const { return {sphere.radius}; }
  std::vector<double> operator()(const Plane& plane) const {
    return {plane.size.x(), plane.size.y()};
  }
  // For cylinders and cones.
  std::vector<double> operator()(const auto& round) const { return {round.radius, round.height}; }
};

// In the standard convention the row of a joint comes after the frame in which its link moves.
Eigen::Isometry3d T_moved_link(const Robot& robot, int link) {
  const bool is_standard = robot.spec().convention == DhConvention::kStandard;
  return is_standard && link > 0 ? dh_pose(DhConvention::kStandard, robot.row(link - 1).dh)
                                 : Eigen::Isometry3d::Identity();
}

std::vector<LinkPicture> pictures_of(const Robot& robot) {
  std::vector<LinkPicture> pictures;
  for (int i = 0; i <= robot.rows(); ++i) {
    for (const LinkMesh& each : robot.body(i).bodies) {
      const MeshSource& source = each.source();
      if (source.bytes == nullptr) continue;
      pictures.push_back({.link = i,
                          .glb = source.bytes,
                          .T_glb = T_moved_link(robot, i) * each.T_link_mesh * source.T_mesh_file,
                          .is_drawn = each.use != LinkSolidUse::kCollision,
                          .collides = each.use != LinkSolidUse::kPicture});
    }
  }
  return pictures;
}

std::string tool_word(ToolKind kind) {
  switch (kind) {
    case ToolKind::kNone:
      return "none";
    case ToolKind::kParallelGripper:
      return "gripper";
    case ToolKind::kSuctionCup:
      return "suction cup";
    case ToolKind::kPoint:
      return "point";
    case ToolKind::kFingers:
      return "fingers";
  }
  return "";
}

// The constants of row i; the joint moves before them (standard convention) or after them
// (modified): rotations about z and translations along z commute.
JointInfo joint_info(const Robot& robot, int i) {
  const Joint& row = robot.row(i);
  JointInfo info{.unit = row.is_revolute() ? JointUnit::kRadian : JointUnit::kMetre,
                 .lower = row.lower,
                 .upper = row.upper,
                 .max_speed = row.max_speed};
  const DhConvention convention = robot.spec().convention;
  const Eigen::Isometry3d T_row = dh_pose(convention, row.dh);
  (convention == DhConvention::kStandard ? info.T_joint_link : info.T_before_joint) = T_row;
  if (i == 0) info.T_before_joint = robot.spec().T_base_first * info.T_before_joint;
  if (!robot.spec().links.empty()) info.mesh = robot.link(i).mesh;
  return info;
}

}  // namespace

ObjectInfo object_info(const Object& object) {
  ObjectInfo info{.name = object.name,
                  .shape = shape_name(object.shape),
                  .size = std::visit(ShapeSize{}, object.shape),
                  .mass = object.mass,
                  .color = object.color,
                  .T_world_obj = object.T_world_obj,
                  .texture = object.texture};
  if (const Mesh* mesh = std::get_if<Mesh>(&object.shape)) {
    info.glb = mesh->triangles->source().bytes;
    info.T_obj_glb = mesh->triangles->source().T_mesh_file;
  }
  return info;
}

DrawingInfo drawing_info(const Drawing& drawing) {
  DrawingInfo info{.name = drawing.name,
                   .kind = std::string(to_text(drawing.kind)),
                   .size = {drawing.size[0], drawing.size[1], drawing.size[2]},
                   .text = drawing.text,
                   .color = drawing.color,
                   .T_on_drawing = drawing.T_on_drawing};
  if (drawing.on.base == FrameBase::kObject) info.object = drawing.on.on;
  if (drawing.on.base == FrameBase::kCarrier) {
    info.robot = drawing.on.carrier;
    info.link = drawing.on.frame == kTipFrame ? kDrawingTip : drawing.on.frame;
  }
  return info;
}

CameraInfo camera_info(const Camera& camera) {
  const Intrinsics& lens = camera.lens.intrinsics();
  CameraInfo info{.name = camera.name,
                  .width = lens.width,
                  .height = lens.height,
                  .fx = lens.fx,
                  .fy = lens.fy,
                  .cx = lens.cx,
                  .cy = lens.cy,
                  .distortion = lens.distortion,
                  .near = lens.near,
                  .far = lens.far,
                  .rate = camera.rate,
                  .T_on_camera = camera.T_on_camera};
  if (camera.on.base == FrameBase::kObject) info.object = camera.on.on;
  if (camera.on.base == FrameBase::kFrame) info.frame = camera.on.on;
  if (camera.on.base == FrameBase::kCarrier) {
    info.robot = camera.on.carrier;
    info.link = camera.on.frame == kFlange ? kCameraFlange : camera.on.frame;
  }
  return info;
}

RobotInfo robot_info(const CellRobot& robot) {
  const Robot& model = *robot.model;
  const Tool& tool = model.tool();
  RobotInfo info{.name = robot.name,
                 .home = {model.home().begin(), model.home().end()},
                 .T_world_base = model.T_world_base(),
                 .on = robot.on,
                 .tool = {.kind = tool_word(tool.kind),
                          .stroke = tool.stroke,
                          .radius = tool.radius,
                          .length = tool.length,
                          .T_flange_tool = model.T_flange_tool()},
                 .pictures = pictures_of(model)};
  for (int i = 0; i < model.n(); ++i) info.joints.push_back(joint_info(model, model.row_of(i)));
  for (int k = 0; model.coupling() != nullptr && k < model.rows(); ++k) {
    const auto [joint, ratio] = motion_of_row(model, k);
    info.rows.push_back({.moves = joint_info(model, k),
                         .joint = joint,
                         .ratio = ratio,
                         .offset = model.coupling()->offset[k]});
  }
  return info;
}

}  // namespace armlet
