// Messages about runs, and rows of numbers as binary messages.

#include <bit>
#include <cmath>
#include <cstring>

#include "armlet/interpreter/unit.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "json_parts.hpp"

namespace armlet::lab {
namespace {

std::string_view state_word(RunState state) {
  switch (state) {
    case RunState::kRunning:
      return "running";
    case RunState::kDone:
      return "done";
    case RunState::kFailed:
      return "failed";
    case RunState::kStopped:
      return "stopped";
  }
  return "";
}

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

// What the motor of a joint gives at most; null: nobody knows.
OrderedJson max_force_json(const std::shared_ptr<const Robot>& model, int joint) {
  if (model == nullptr || !std::isfinite(model->joint(joint).max_effort)) return {};
  return model->joint(joint).max_effort;
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
  OrderedJson changes = OrderedJson::array();
  for (const RobotChange& change : robot.changes) {
    changes.push_back({{"t", change.t},
                       {"tool", tool_json(change.robot.tool)},
                       {"T_world_base", matrix_json(change.robot.T_world_base)},
                       {"shapes", shapes_json(shapes_of(change.model))}});
  }
  return {{"name", robot.info.name},
          {"home", robot.info.home},
          {"tool", tool_json(robot.info.tool)},
          {"on", robot.info.on},
          {"T_world_base", matrix_json(robot.info.T_world_base)},
          {"joints", std::move(joints)},
          {"shapes", shapes_json(shapes_of(robot.model))},
          {"changes", std::move(changes)}};
}

OrderedJson input_json(const RunInput& input) {
  OrderedJson out = {{"t", input.t}};
  std::visit(Overload{[&](const SetField& each) {
                        out["set"] = each.name;
                        out["value"] =
                            std::visit([](const auto& v) { return OrderedJson(v); }, each.value);
                      },
                      [&](const PressButton& each) { out["press"] = each.name; },
                      [&](const SetJoints& each) {
                        out["joints"] = each.robot;
                        out["values"] = each.q;
                      },
                      [&](const SetHand& each) {
                        out["hand"] = each.sliders;
                        out["values"] = each.values;
                      }},
             input.what);
  return out;
}

// Numbers in SI; what has a name of its own as a text.
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
  if (row.kind == LabRowKind::kPlot && i < lab.units.size()) out["quantity_unit"] = lab.units[i];
  if (row.kind == LabRowKind::kTable) out["header"] = row.header;
  if (row.kind == LabRowKind::kText) out["text"] = value_json(row.value);
  return out;
}

OrderedJson run_json(const RunRecord& run) {
  return {
      {"run", run.number},  {"state", state_word(run.state)}, {"t_end", run.t_end},
      {"label", run.label}, {"parent", json_of(run.parent)},  {"parts_at", json_of(run.parts_at)}};
}

OrderedJson piece(std::string_view type, const RunRecord& run, std::size_t first) {
  return {{"type", type}, {"run", run.number}, {"first", first}, {"items", OrderedJson::array()}};
}

OrderedJson robot_number(int robot) { return robot < 0 ? OrderedJson() : OrderedJson(robot); }

}  // namespace

Message write_runs(const RunList& runs) {
  OrderedJson list = OrderedJson::array();
  for (const auto& run : runs) list.push_back(run_json(*run));
  return message_of({{"type", "runs"}, {"list", std::move(list)}});
}

Message write_shown(int run) { return message_of({{"type", "shown"}, {"run", run}}); }

Message write_run(const RunRecord& run) {
  OrderedJson out = {{"type", "run"}};
  out.update(run_json(run));
  out["text_version"] = run.text_version;
  out["inputs"] = OrderedJson::array();
  for (const RunInput& input : run.inputs) out["inputs"].push_back(input_json(input));
  out["hash"] = run.hash;
  out["error"] = run.error ? json_of(*run.error) : OrderedJson();
  return message_of(out);
}

Message write_description(const RunRecord& run) {
  OrderedJson out = {{"type", "description"},
                     {"run", run.number},
                     {"text_version", run.text_version},
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
  }
  out["lab"] = run.lab && run.lab->has_block ? OrderedJson(run.lab->rows.name) : OrderedJson();
  out["title"] = run.lab ? run.lab->rows.title : std::string();
  out["layout"] = run.lab && run.lab->rows.layout == LabLayout::kStack ? "stack" : "columns";
  out["elements"] = OrderedJson::array();
  for (std::size_t i = 0; run.lab && i < run.lab->rows.rows.size(); ++i)
    out["elements"].push_back(element_json(*run.lab, i));
  return message_of(out);
}

Message write_moves(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("moves", run, first);
  for (std::size_t i = first; i < first + count; ++i) {
    const RecordedMove& move = run.moves[i];
    out["items"].push_back({{"robot", move.robot},
                            {"motion", move.motion},
                            {"span", json_of(move.span)},
                            {"t0", move.t0},
                            {"t1", move.t1},
                            {"text", move.text},
                            {"stopped", move.stopped},
                            {"end", {move.p_end.x(), move.p_end.y(), move.p_end.z()}}});
  }
  return message_of(out);
}

Message write_lines(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("statements", run, first);
  for (std::size_t i = first; i < first + count; ++i)
    out["items"].push_back({run.lines[i].t, run.lines[i].line});
  return message_of(out);
}

Message write_events(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("objects", run, first);
  for (std::size_t i = first; i < first + count; ++i) {
    const RecordedChange& event = run.events[i];
    out["items"].push_back({{"t", event.t},
                            {"what", event.what},
                            {"object", event.object},
                            {"robot", robot_number(event.robot)}});
  }
  return message_of(out);
}

Message write_notes(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("notes", run, first);
  for (std::size_t i = first; i < first + count; ++i) {
    const RecordedText& note = run.texts[i];
    out["items"].push_back({{"t", note.t},
                            {"kind", to_text(note.kind)},
                            {"text", note.text},
                            {"span", json_of(note.span)}});
  }
  return message_of(out);
}

Message write_figure(const RunRecord& run, const RecordedFigure& figure) {
  return message_of({{"type", "figures"},
                     {"run", run.number},
                     {"index", figure.index},
                     {"title", figure.title},
                     {"svg", figure.svg}});
}

Message write_elements(Seq to, int run, double t, const std::vector<ElementValue>& values) {
  OrderedJson out = answer("elements", to);
  out["run"] = run;
  out["t"] = t;
  out["values"] = OrderedJson::object();
  for (const ElementValue& each : values) {
    out["values"][each.name] = each.fault.empty() ? OrderedJson{{"value", value_json(each.value)},
                                                                {"unit", si_unit_of(each.value)}}
                                                  : OrderedJson{{"error", each.fault}};
  }
  return message_of(out);
}

Message write_taken(Seq to, int run) {
  OrderedJson out = answer("taken", to);
  out["run"] = run;
  return message_of(out);
}

Message write_rows(std::uint32_t kind, int run, std::size_t index, const Rows& rows,
                   std::size_t first, std::size_t count) {
  static_assert(std::endian::native == std::endian::little);
  const std::uint32_t head[6] = {kind,
                                 static_cast<std::uint32_t>(run),
                                 static_cast<std::uint32_t>(index),
                                 static_cast<std::uint32_t>(rows.columns()),
                                 static_cast<std::uint32_t>(count),
                                 static_cast<std::uint32_t>(first)};
  const std::span<const double> values = rows.rows(first, count);
  Message out{std::string(sizeof head + values.size_bytes(), '\0'), true};
  std::memcpy(out.bytes.data(), head, sizeof head);
  std::memcpy(out.bytes.data() + sizeof head, values.data(), values.size_bytes());
  return out;
}

// The lists of what was asked of the outside are not in it: `files` are its answers.
Message write_exported(Seq to, const Exported& exported) {
  OrderedJson out = answer("exported", to);
  OrderedJson laboratory = {{"format", 1},
                            {"version", exported.version},
                            {"robot", exported.robot},
                            {"world", nullptr},
                            {"file", exported.file},
                            {"text", exported.text},
                            {"demo", exported.is_demo},
                            {"files", OrderedJson::object()},
                            {"runs", OrderedJson::array()},
                            {"shown", exported.shown}};
  if (exported.world != nullptr)
    laboratory["world"] = {{"name", exported.world->name}, {"text", exported.world->text}};
  for (const auto& [path, text] : exported.files) laboratory["files"][path] = text;
  for (const auto& run : exported.runs) {
    if (run->log.entries.empty()) continue;
    OrderedJson inputs = OrderedJson::array();
    for (const RunInput& each : run->inputs) inputs.push_back(input_json(each));
    laboratory["runs"].push_back({{"run", run->number},
                                  {"label", run->label},
                                  {"text", run->log.entries.front().text},
                                  {"inputs", std::move(inputs)},
                                  {"state", state_word(run->state)},
                                  {"hash", run->hash}});
  }
  out["laboratory"] = std::move(laboratory);
  return message_of(out);
}

}  // namespace armlet::lab
