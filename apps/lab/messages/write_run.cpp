// Messages about runs, and rows of numbers as binary messages.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "armlet/interpreter/unit.hpp"
#include "base85.hpp"
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

OrderedJson run_json(const RunRecord& run) {
  return {
      {"run", run.number},  {"state", state_word(run.state)}, {"t_end", run.t_end},
      {"label", run.label}, {"parent", json_of(run.parent)},  {"parts_at", json_of(run.parts_at)}};
}

OrderedJson piece(std::string_view type, const RunRecord& run, std::size_t first) {
  return {{"type", type}, {"run", run.number}, {"first", first}, {"items", OrderedJson::array()}};
}

// The unit of all numbers of a value, or, if they differ, the units of its parts.
OrderedJson units_json(const Value& value) {
  OrderedJson parts;
  if (const auto* number = value.get_if<Value::Number>()) return si_unit(number->dim);
  if (const auto* list = value.get_if<Value::List>()) {
    for (const Value& each : *list) parts.push_back(units_json(each));
  } else if (const auto* record = value.get_if<Value::Record>()) {
    for (const auto& [name, field] : record->fields) parts[name] = units_json(field);
  }
  if (parts.empty()) return "";
  const OrderedJson& first = *parts.begin();
  const bool is_same =
      first.is_string() &&
      std::ranges::all_of(parts, [&](const OrderedJson& each) { return each == first; });
  return is_same ? first : parts;
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
  out["pictures"] = run.cameras.taken;
  out["error"] = run.error ? json_of(*run.error) : OrderedJson();
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

Message write_ways(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("ways", run, first);
  for (std::size_t i = first; i < first + count; ++i) {
    const RecordedWay& way = run.ways[i];
    OrderedJson path = OrderedJson::array(), arms = OrderedJson::array();
    for (const Eigen::Vector3d& p : way.path) path.push_back({p.x(), p.y(), p.z()});
    for (const Eigen::VectorXd& q : way.arms)
      arms.push_back(std::vector<double>(q.begin(), q.end()));
    out["items"].push_back({{"robot", way.robot},
                            {"t", way.t},
                            {"duration", way.duration},
                            {"path", std::move(path)},
                            {"arms", std::move(arms)}});
  }
  return message_of(out);
}

Message write_stretches(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("stretches", run, first);
  for (std::size_t i = first; i < first + count; ++i) {
    const RecordedStretch& each = run.stretches[i];
    const bool is_task = each.kind == RecordedStretch::Kind::kTask;
    OrderedJson item = {{"kind", is_task ? "task" : "signal"},
                        {"name", each.name},
                        {"t0", each.t0},
                        {"t1", each.t1}};
    if (is_task) item["span"] = json_of(each.span);
    if (each.value)
      item["value"] = std::visit([](auto held) { return OrderedJson(held); }, *each.value);
    out["items"].push_back(std::move(item));
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

Message write_drawings(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("drawings", run, first);
  for (std::size_t i = first; i < first + count; ++i) {
    const RecordedDrawing& each = run.drawings.list()[i];
    out["items"].push_back({{"t", each.t},
                            {"name", each.info.name},
                            {"kind", each.info.kind},
                            {"text", each.info.text},
                            {"color", each.info.color},
                            {"robot", robot_number(each.info.robot)},
                            {"link", each.info.link},
                            {"object", each.info.object},
                            {"span", json_of(each.span)}});
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
    if (!note.element.empty()) out["items"].back()["element"] = note.element;
  }
  return message_of(out);
}

Message write_advice(const RunRecord& run, std::size_t first, std::size_t count) {
  OrderedJson out = piece("advice", run, first);
  for (std::size_t i = first; i < first + count; ++i)
    out["items"].push_back(json_of(run.advice[i]));
  return message_of(out);
}

namespace {

OrderedJson axis_json(const Axis& axis) {
  return {{"label", axis.label}, {"unit", axis.unit}, {"log", axis.log}};
}

OrderedJson panel_json(const Figure& panel) {
  OrderedJson series = OrderedJson::array();
  for (const Series& each : panel.series) {
    series.push_back({{"kind", to_text(each.kind)},
                      {"label", each.label},
                      {"right", each.right},
                      {"x", each.x},
                      {"y", each.y}});
  }
  return {{"title", panel.title},
          {"x", axis_json(panel.x)},
          {"y", axis_json(panel.y)},
          {"right", axis_json(panel.right)},
          {"series", std::move(series)}};
}

}  // namespace

Message write_figure(const RunRecord& run, const RecordedFigure& figure) {
  OrderedJson out = {{"type", "figures"},
                     {"run", run.number},
                     {"index", figure.index},
                     {"title", figure.title},
                     {"svg", figure.svg}};
  if (figure.plot) {
    const Figure& plot = *figure.plot;
    out["panels"] = OrderedJson::array();
    for (const Figure& panel : plot.panels) out["panels"].push_back(panel_json(panel));
    if (plot.panels.empty()) out["panels"].push_back(panel_json(plot));
  }
  return message_of(out);
}

OrderedJson values_json(const std::vector<ElementValue>& values) {
  OrderedJson out = OrderedJson::object();
  for (const ElementValue& each : values) {
    out[each.name] = each.fault.empty() ? OrderedJson{{"value", value_json(each.value)},
                                                      {"units", units_json(each.value)}}
                                        : OrderedJson{{"error", each.fault}};
  }
  return out;
}

Message write_elements(Seq to, int run, double t, const std::vector<ElementValue>& values) {
  OrderedJson out = answer("elements", to);
  out["run"] = run;
  out["t"] = t;
  out["values"] = values_json(values);
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

Message write_file(std::uint32_t to, std::string_view bytes) {
  const std::uint32_t head[6] = {
      kFileMessage, to, 0, 0, static_cast<std::uint32_t>(bytes.size()), 0};
  Message out{std::string(sizeof head, '\0'), true};
  std::memcpy(out.bytes.data(), head, sizeof head);
  out.bytes += bytes;
  return out;
}

Message write_kept(Seq to, const KeptFile& kept) {
  OrderedJson out = answer("kept", to);
  out["name"] = kept.name;
  out["size"] = kept.size;
  return message_of(out);
}

// The replies in the logs are left out: `files` contains them.
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
  for (const auto& [path, bytes] : exported.files)
    laboratory["files"][path] =
        is_text(bytes) ? OrderedJson(bytes) : OrderedJson{{"base85", to_base85(bytes)}};
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
