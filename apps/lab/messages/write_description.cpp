// Descriptions of robots, objects and elements of a run, for pages.

#include <cmath>

#include "armlet/collision/arm_solids.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "json_parts.hpp"

namespace armlet::lab {
namespace {

OrderedJson tool_json(const ToolInfo& tool) {
  return {{"kind", tool.kind},
          {"stroke", tool.stroke},
          {"radius", tool.radius},
          {"length", tool.length},
          {"T_flange_tool", matrix_json(tool.T_flange_tool)}};
}

OrderedJson shapes_json(const std::vector<LinkShape>& shapes) {
  OrderedJson out = OrderedJson::array();
  for (const LinkShape& shape : shapes) {
    OrderedJson each = {{"link", shape.link},
                        {"kind", to_text(shape.kind)},
                        {"role", to_text(shape.role)},
                        {"T", matrix_json(shape.T_link_shape)}};
    if (shape.given) each["given"] = true;
    if (shape.kind == LinkShapeKind::kBox) {
      each["size"] = {shape.size.x(), shape.size.y(), shape.size.z()};
    } else {
      each["radius"] = shape.radius;
      each["length"] = shape.length;
      if (shape.kind == LinkShapeKind::kRing) each["thickness"] = shape.thickness;
    }
    out.push_back(std::move(each));
  }
  return out;
}

std::vector<LinkShape> shapes_of(const std::shared_ptr<const Robot>& model) {
  return model == nullptr ? std::vector<LinkShape>() : link_shapes(*model);
}

// The simplified shapes for collision checks, in the frames of the links; shapes that are meshes
// are drawn as meshes.
OrderedJson solids_json(const std::shared_ptr<const Robot>& model, const RobotInfo& info) {
  OrderedJson out = OrderedJson::array();
  if (model == nullptr || model->spec().role != RobotRole::kArm) return out;
  for (const ArmSolid& each : model->derived<ArmSolids>().solids()) {
    const Solid& solid = each.solid;
    const auto joint = static_cast<std::size_t>(each.frame) - 1;
    if (solid.is_empty() || (each.frame > 0 && joint >= info.link_count())) continue;
    const Eigen::Isometry3d T = each.frame > 0 ? info.link(joint).T_joint_link * solid.T : solid.T;
    OrderedJson body = {
        {"link", each.frame}, {"kind", ""}, {"role", to_text(each.role)}, {"T", matrix_json(T)}};
    const Eigen::Vector3d half = solid.half + Eigen::Vector3d::Constant(solid.margin);
    switch (solid.core) {
      case Solid::Core::kPoint:
      case Solid::Core::kSegment:
        body["kind"] = "capsule";
        body["radius"] = solid.margin;
        body["length"] = 2.0 * solid.half.z();
        break;
      case Solid::Core::kBox:
        body["kind"] = "box";
        body["size"] = {2.0 * half.x(), 2.0 * half.y(), 2.0 * half.z()};
        break;
      case Solid::Core::kCylinder:
        body["kind"] = "cylinder";
        body["radius"] = half.x();
        body["length"] = 2.0 * half.z();
        break;
      default:
        continue;
    }
    out.push_back(std::move(body));
  }
  return out;
}

// The largest force of the motor of a joint; null: unknown.
OrderedJson max_force_json(const std::shared_ptr<const Robot>& model, int joint) {
  if (model == nullptr || !std::isfinite(model->joint(joint).max_effort)) return {};
  return model->joint(joint).max_effort;
}

OrderedJson pictures_json(const RecordedRobot& robot) {
  OrderedJson out = OrderedJson::array();
  for (std::size_t i = 0; i < robot.pictures.size(); ++i) {
    const LinkPicture& picture = robot.info.pictures[i];
    out.push_back(
        {{"link", picture.link}, {"file", robot.pictures[i]}, {"T", affine_json(picture.T_glb)}});
    if (!picture.is_drawn) out.back()["use"] = "collision";
    if (!picture.collides) out.back()["use"] = "picture";
  }
  return out;
}

OrderedJson robot_json(const RecordedRobot& robot) {
  OrderedJson joints = OrderedJson::array();
  for (const JointInfo& joint : robot.info.joints) {
    const int i = static_cast<int>(joints.size());
    joints.push_back({{"unit", joint.unit == JointUnit::kRadian ? "rad" : "m"},
                      {"lower", joint.lower},
                      {"upper", joint.upper},
                      {"max_speed", joint.max_speed},
                      {"max_force", max_force_json(robot.model, i)},
                      {"T_before_joint", matrix_json(joint.T_before_joint)},
                      {"T_joint_link", matrix_json(joint.T_joint_link)},
                      {"mesh", joint.mesh}});
  }
  OrderedJson rows = OrderedJson::array();
  for (const RowInfo& row : robot.info.rows) {
    rows.push_back({{"unit", row.moves.unit == JointUnit::kRadian ? "rad" : "m"},
                    {"T_before_joint", matrix_json(row.moves.T_before_joint)},
                    {"T_joint_link", matrix_json(row.moves.T_joint_link)},
                    {"joint", row.joint},
                    {"ratio", row.ratio},
                    {"offset", row.offset}});
  }
  OrderedJson changes = OrderedJson::array();
  for (const RobotChange& change : robot.changes) {
    changes.push_back({{"t", change.t},
                       {"tool", tool_json(change.robot.tool)},
                       {"T_world_base", matrix_json(change.robot.T_world_base)},
                       {"shapes", shapes_json(shapes_of(change.model))},
                       {"solids", solids_json(change.model, change.robot)}});
  }
  OrderedJson out = {{"name", robot.info.name},
                     {"home", robot.info.home},
                     {"tool", tool_json(robot.info.tool)},
                     {"on", robot.info.on},
                     {"T_world_base", matrix_json(robot.info.T_world_base)},
                     {"joints", std::move(joints)},
                     {"shapes", shapes_json(shapes_of(robot.model))},
                     {"solids", solids_json(robot.model, robot.info)},
                     {"pictures", pictures_json(robot)},
                     {"changes", std::move(changes)}};
  if (!rows.empty()) out["rows"] = std::move(rows);
  return out;
}

std::string_view type_word(LabFieldType type) {
  constexpr std::string_view kWords[] = {"number", "int", "bool", "text"};
  return kWords[static_cast<std::size_t>(type)];
}

OrderedJson element_json(const LabElements& lab, std::size_t i) {
  const LabRow& row = lab.rows.rows[i];
  OrderedJson out = {{"kind", word_of(row.kind)},
                     {"name", row.name},
                     {"label", row.label},
                     {"robot", row.robot},
                     {"is_read", row.is_read},
                     {"span", i < lab.places.size() ? json_of(lab.places[i]) : OrderedJson()}};
  if (!row.axes.empty()) {
    out["axes"] = OrderedJson::array();
    for (std::size_t k = 0; k < row.axes.size(); ++k) {
      const bool is_length = row.axes[k] <= HandAxis::kZ;
      OrderedJson axis = {{"name", word_of(row.axes[k])}, {"unit", is_length ? "m" : "rad"}};
      if (k < lab.ranges[i].size()) {
        axis["lower"] = lab.ranges[i][k][0];
        axis["upper"] = lab.ranges[i][k][1];
      }
      out["axes"].push_back(std::move(axis));
    }
  }
  if (row.kind == LabRowKind::kField) {
    const auto unit = parse_unit(row.unit);
    out["type"] = type_word(row.type);
    out["value"] = value_json(row.value);
    out["range"] = row.range ? OrderedJson(*row.range) : OrderedJson();
    out["unit"] = row.unit;
    out["factor"] = unit ? unit->factor : 1.0;
  }
  if (row.kind == LabRowKind::kPlot && i < lab.units.size()) out["units"] = lab.units[i];
  if (row.kind == LabRowKind::kTable) out["header"] = row.header;
  if (i < lab.pictures.size() && !lab.pictures[i].empty()) out["file"] = lab.pictures[i];
  if (row.kind == LabRowKind::kText) out["text"] = value_json(row.value);
  if (row.kind == LabRowKind::kView) {
    constexpr std::string_view kWords[] = {"", "corners", "truth", "wanted"};
    out["camera"] = row.camera;
    out["overlay"] = kWords[static_cast<std::size_t>(row.overlay)];
    out["wanted"] = row.wanted;
  }
  return out;
}

OrderedJson camera_json(const RecordedCamera& camera) {
  const Intrinsics& lens = camera.lens;
  return {{"name", camera.name},
          {"size", {lens.width, lens.height}},
          {"focal", {lens.fx, lens.fy}},
          {"centre", {lens.cx, lens.cy}},
          {"robot", camera.robot < 0 ? OrderedJson() : OrderedJson(camera.robot)},
          {"link", camera.link},
          {"object", camera.object},
          {"T", matrix_json(camera.T_on_camera)}};
}

}  // namespace

OrderedJson value_json(const Value& value) {
  return std::visit(Overload{[](std::monostate) { return OrderedJson(); },
                             [](bool truth) { return OrderedJson(truth); },
                             [](std::int64_t whole) { return OrderedJson(whole); },
                             [](const Value::Number& number) { return OrderedJson(number.si); },
                             [](const std::string& text) { return OrderedJson(text); },
                             [](const Value::List& list) {
                               OrderedJson out = OrderedJson::array();
                               for (const Value& each : list) out.push_back(value_json(each));
                               return out;
                             },
                             [](const Value::Matrix& matrix) {
                               OrderedJson out = OrderedJson::array();
                               for (std::uint32_t i = 0; i < matrix.rows; ++i) {
                                 OrderedJson row = OrderedJson::array();
                                 for (std::uint32_t j = 0; j < matrix.cols; ++j)
                                   row.push_back(matrix.elements[i * matrix.cols + j]);
                                 out.push_back(std::move(row));
                               }
                               return out;
                             },
                             [](const Value::Record& record) {
                               OrderedJson out = OrderedJson::object();
                               for (const auto& [name, field] : record.fields)
                                 out[name] = value_json(field);
                               return out;
                             },
                             [](const Value::Enum& word) { return OrderedJson(word.value); },
                             [](const Value::Map& map) {
                               OrderedJson out = OrderedJson::array();
                               for (const auto& [key, held] : map)
                                 out.push_back({value_json(key), value_json(held)});
                               return out;
                             },
                             [](const Value::Host&) { return OrderedJson(); }},
                    value.content());
}

Message write_description(const RunRecord& run) {
  OrderedJson out = {{"type", "description"},
                     {"run", run.number},
                     {"text_version", run.text_version},
                     {"world", run.world.empty() ? OrderedJson() : OrderedJson(run.world)},
                     {"robots", OrderedJson::array()},
                     {"objects", OrderedJson::array()}};
  for (const RecordedRobot& robot : run.robots) out["robots"].push_back(robot_json(robot));
  for (std::size_t i = 0; i < run.objects.size(); ++i) {
    const ObjectInfo& object = run.objects[i];
    out["objects"].push_back({{"name", object.name},
                              {"shape", object.shape},
                              {"size", object.size},
                              {"mass", object.mass},
                              {"color", object.color},
                              {"pose", pose_json(object.T_world_obj)},
                              {"span", json_of(run.object_places[i])}});
    const ObjectFiles& files = run.object_files[i];
    if (!files.glb.empty()) {
      out["objects"].back()["file"] = files.glb;
      out["objects"].back()["T"] = affine_json(object.T_obj_glb);
    }
    if (!files.texture.empty()) out["objects"].back()["texture"] = files.texture;
  }
  out["cameras"] = OrderedJson::array();
  for (const RecordedCamera& camera : run.cameras.list)
    out["cameras"].push_back(camera_json(camera));
  out["lab"] = run.lab && run.lab->has_block ? OrderedJson(run.lab->rows.name) : OrderedJson();
  out["title"] = run.lab ? run.lab->rows.title : std::string();
  out["layout"] = run.lab && run.lab->rows.layout == LabLayout::kStack ? "stack" : "columns";
  out["elements"] = OrderedJson::array();
  for (std::size_t i = 0; run.lab && i < run.lab->rows.rows.size(); ++i)
    out["elements"].push_back(element_json(*run.lab, i));
  return message_of(out);
}

}  // namespace armlet::lab
