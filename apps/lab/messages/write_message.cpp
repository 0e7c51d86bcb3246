#include "write_message.hpp"

#include <algorithm>

#include "armlet/interpreter/diagnostic.hpp"
#include "json_parts.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostCompletions = 400;

OrderedJson marked_json(const MarkedPlace& place) {
  return {{"span", json_of(place.span)}, {"file", place.file}, {"label", place.label}};
}

void add_unreached(OrderedJson& out, const UnreachedGoal& goal) {
  out["robot"] = goal.robot;
  out["goal"] = pose_json(goal.T_world_tool);
  out["nearest"] = nullptr;
  if (goal.q_nearest.size() == 0) return;
  out["nearest"] = {{"q", std::vector<double>(goal.q_nearest.begin(), goal.q_nearest.end())},
                    {"pose", pose_json(goal.T_world_nearest)},
                    {"distance", goal.distance},
                    {"angle", goal.angle}};
}

OrderedJson point_json(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

OrderedJson body_json(int robot, const std::string& object, int link, const std::string& text,
                      const Eigen::Vector3d& p) {
  return {{"robot", robot < 0 ? OrderedJson() : OrderedJson(robot)},
          {"object", object},
          {"link", link},
          {"text", text},
          {"at", point_json(p)}};
}

void add_things(OrderedJson& out, const SeenThings& things) {
  out["frames"] = OrderedJson::array();
  for (const SeenFrame& each : things.frames)
    out["frames"].push_back(
        {{"name", each.name}, {"object", each.object}, {"pose", pose_json(each.T)}});
  out["clearances"] = OrderedJson::array();
  for (const SeenClearance& each : things.clearances) {
    out["clearances"].push_back(
        {{"distance", each.distance},
         {"at_least", each.is_at_least},
         {"felt", each.is_felt},
         {"body", body_json(each.robot, each.object, each.link, each.body, each.p_body)},
         {"other", body_json(each.other_robot, each.other_object, each.other_link, each.other,
                             each.p_other)}});
  }
  out["presses"] = OrderedJson::array();
  for (const SeenPress& each : things.presses) {
    out["presses"].push_back({{"robot", each.robot},
                              {"object", each.object},
                              {"at", {each.p.x(), each.p.y(), each.p.z()}},
                              {"force", {each.force.x(), each.force.y(), each.force.z()}}});
  }
}

}  // namespace

OrderedJson json_of(const TextMessage& message) {
  OrderedJson out = {{"severity", message.is_error ? "error" : "advice"},
                     {"code", message.code},
                     {"message", message.message},
                     {"span", json_of(message.place.span)},
                     {"file", message.place.file},
                     {"label", message.place.label},
                     {"related", OrderedJson::array()},
                     {"why", message.why},
                     {"fix", nullptr}};
  for (const MarkedPlace& each : message.related) out["related"].push_back(marked_json(each));
  if (message.fix) {
    OrderedJson edits = OrderedJson::array();
    for (const TextFix::Replacement& each : message.fix->edits)
      edits.push_back({{"span", json_of(each.span)}, {"text", each.text}});
    out["fix"] = {
        {"text", message.fix->text}, {"sure", message.fix->is_sure}, {"edits", std::move(edits)}};
  }
  if (message.t) out["t"] = *message.t;
  if (!message.when.empty()) out["when"] = message.when;
  if (message.unreached) add_unreached(out, *message.unreached);
  return out;
}

Message write_welcome(const Welcome& welcome, Seq to) {
  OrderedJson out = answer("welcome", to);
  out["protocol"] = 1;
  out["page"] = welcome.page;
  out["key"] = welcome.key;
  out["version"] = welcome.version;
  out["file"] = welcome.file;
  out["text"] = welcome.text;
  out["text_version"] = welcome.text_version;
  out["demo"] = welcome.is_demo;
  out["words"] = welcome.words;
  return message_of(out);
}

Message write_document(const Document& document) {
  return message_of({{"type", "document"},
                     {"text", document.text},
                     {"exists", document.exists},
                     {"changed", document.is_changed}});
}

Message write_saved(Seq to) { return message_of(answer("saved", to)); }

Message write_control(const ControlState& control) {
  OrderedJson names = OrderedJson::object();
  for (const auto& [page, name] : control.names) names[std::to_string(page)] = name;
  return message_of({{"type", "control"},
                     {"holder", json_of(control.holder)},
                     {"pages", control.pages},
                     {"wishes", control.wishes},
                     {"names", std::move(names)}});
}

Message write_text(const std::string& text, std::int64_t version, int from) {
  return message_of({{"type", "text"}, {"text", text}, {"text_version", version}, {"from", from}});
}

Message write_diagnostics(std::int64_t text_version, bool runs,
                          const std::vector<TextMessage>& items) {
  OrderedJson out = {{"type", "diagnostics"},
                     {"text_version", text_version},
                     {"runs", runs},
                     {"items", OrderedJson::array()}};
  for (const TextMessage& each : items) out["items"].push_back(json_of(each));
  return message_of(out);
}

Message write_error(Seq to, std::string_view reason, std::string_view message,
                    const UnreachedGoal* unreached) {
  OrderedJson out = answer("error", to);
  out["reason"] = reason;
  out["message"] = message;
  if (unreached != nullptr) add_unreached(out, *unreached);
  return message_of(out);
}

// ---- answers about the text -----------------------------------------------------------------

Message write_completion(Seq to, const Analysis& analysis, std::uint32_t at) {
  const SourceSet& sources = analysis.sources();
  const Completions found = analysis.completion(at);
  const std::string_view begun =
      sources.slice({found.replaced.begin, std::max(at, found.replaced.begin), sources.first()});
  OrderedJson out = answer("completion", to);
  out["replaced"] = json_of(span_of(sources, found.replaced));
  OrderedJson items = OrderedJson::array();
  bool more = false;
  for (const Completion& each : found.items) {
    if (!each.text.starts_with(begun)) continue;
    more = items.size() >= kMostCompletions;
    if (more) break;
    items.push_back(
        {{"text", each.text}, {"kind", name_kind_text(each.kind)}, {"detail", each.detail}});
  }
  out["items"] = std::move(items);
  out["more"] = more;
  return message_of(out);
}

Message write_hover(Seq to, const Analysis& analysis, std::uint32_t at) {
  const std::optional<Hover> found = analysis.hover(at);
  OrderedJson out = answer("hover", to);
  const Hover hover = found.value_or(Hover{});
  out["span"] = found ? json_of(span_of(analysis.sources(), hover.span)) : OrderedJson();
  out["text"] = hover.text;
  out["help"] = hover.help;
  out["value"] = hover.value;
  out["messages"] = hover.messages;
  return message_of(out);
}

Message write_signature(Seq to, const Analysis& analysis, std::uint32_t at) {
  const SignatureHelp found = analysis.signature_help(at).value_or(SignatureHelp{});
  OrderedJson out = answer("signature", to);
  out["overloads"] = OrderedJson::array();
  for (const SignatureHelp::Overload& each : found.overloads) {
    OrderedJson parameters = OrderedJson::array();
    const std::string_view text = each.text;
    for (const auto& [begin, end] : each.parameters)
      parameters.push_back(
          {utf16_length(text.substr(0, begin)), utf16_length(text.substr(0, end))});
    out["overloads"].push_back(
        {{"text", each.text}, {"parameters", std::move(parameters)}, {"help", each.help}});
  }
  out["active"] = found.active;
  out["parameter"] = found.parameter;
  return message_of(out);
}

Message write_definition(Seq to, const Analysis& analysis, std::uint32_t at) {
  const std::optional<Span> found = analysis.definition(at);
  OrderedJson out = answer("definition", to);
  out["span"] = found ? json_of(span_of(analysis.sources(), *found)) : OrderedJson();
  out["file"] = found ? analysis.sources()[found->source].name() : std::string();
  return message_of(out);
}

Message write_formatted(Seq to, const std::optional<std::string>& text,
                        const std::vector<TextMessage>& problems) {
  OrderedJson out = answer("formatted", to);
  out["text"] = text ? OrderedJson(*text) : OrderedJson();
  out["problems"] = OrderedJson::array();
  for (const TextMessage& each : problems) out["problems"].push_back(json_of(each));
  return message_of(out);
}

// ---- answers about runs ---------------------------------------------------------------------

Message write_breakpoints(Seq to, const std::vector<int>& lines, const std::vector<int>& known) {
  OrderedJson out = answer("breakpoints", to);
  out["lines"] = lines;
  out["known"] = known;
  return message_of(out);
}

Message write_instant(Seq to, const SeenInstant& instant, bool is_cursor,
                      const std::vector<ElementValue>* values) {
  OrderedJson out = answer("instant", to);
  out["run"] = instant.run;
  out["t"] = instant.t;
  out["cursor"] = is_cursor;
  out["line"] = instant.line;
  out["span"] = json_of(instant.span);
  out["statements"] = instant.statements;
  out["at_breakpoint"] = instant.is_at_breakpoint;
  out["ended"] = instant.has_ended;
  out["variables"] = OrderedJson::array();
  for (const SeenInstant::Variable& each : instant.variables) {
    out["variables"].push_back({{"scope", each.scope},
                                {"name", each.name},
                                {"type", each.type},
                                {"value", each.value ? OrderedJson(*each.value) : OrderedJson()},
                                {"declared", json_of(each.declared)}});
  }
  out["tasks"] = OrderedJson::array();
  for (const SeenInstant::Task& each : instant.tasks) {
    out["tasks"].push_back({{"name", each.name},
                            {"waits", each.waits},
                            {"line", each.line},
                            {"span", json_of(each.span)},
                            {"calls", each.calls}});
  }
  out["signals"] = OrderedJson::array();
  for (const auto& [name, value] : instant.signals) {
    const OrderedJson held = std::visit([](auto each) { return OrderedJson(each); }, value);
    out["signals"].push_back({{"name", name}, {"value", held}});
  }
  add_things(out, instant.things);
  if (values != nullptr) out["values"] = values_json(*values);
  return message_of(out);
}

Message write_inverse(Seq to, const InverseAnswer& found) {
  OrderedJson out = answer("inverse", to);
  out["ok"] = found.is_ok;
  out["q"] = found.q;
  out["reason"] = found.reason;
  out["nearest"] = nullptr;
  if (found.nearest) {
    out["nearest"] = {{"q", found.nearest->q},
                      {"pose", pose_json(found.nearest->T_world_tool)},
                      {"distance", found.nearest->distance},
                      {"angle", found.nearest->angle}};
  }
  return message_of(out);
}

Message write_comparison(Seq to, const Comparison& comparison) {
  OrderedJson out = answer("comparison", to);
  out["run"] = comparison.run;
  out["with"] = comparison.with;
  out["same"] = comparison.is_same;
  out["same_until"] = comparison.same_until;
  out["parts_at"] = comparison.is_same ? OrderedJson() : OrderedJson(comparison.parts_at);
  out["line"] = comparison.line;
  out["line_with"] = comparison.line_with;
  return message_of(out);
}

}  // namespace armlet::lab
