#include <nlohmann/json.hpp>

#include "armlet/interpreter/render.hpp"
#include "armlet/interpreter/virtual_time.hpp"

namespace armlet {
namespace {

// JSON objects whose keys keep their order.
using Json = nlohmann::ordered_json;

void add_range(Json& out, Span span, const SourceSet& sources) {
  const Source& source = sources[span.source];
  const Position begin = source.position(span.begin);
  const Position end = source.position(span.end);
  out["line"] = begin.line;
  out["column"] = begin.column;
  out["endLine"] = end.line;
  out["endColumn"] = end.column;
}

void add_text(Json& out, std::string_view key, const std::string& text) {
  if (!text.empty()) out[std::string(key)] = text;
}

void add_mark(Json& out, const Mark& mark, const SourceSet& sources) {
  out["file"] = sources[mark.span.source].name();
  add_range(out, mark.span, sources);
  const std::string_view text = sources.slice(mark.span);
  out["text"] = std::string(text.substr(0, text.find_first_of("\r\n")));
  add_text(out, "label", mark.label);
}

// `main`: the file with the main mark of the message.
Json fix_json(const Fix& fix, std::uint32_t main, const SourceSet& sources) {
  Json out;
  out["text"] = fix.text;
  out["edits"] = Json::array();
  for (const Edit& edit : fix.edits) {
    Json item;
    if (edit.span.source != main) item["file"] = sources[edit.span.source].name();
    add_range(item, edit.span, sources);
    item["text"] = edit.text;
    out["edits"].push_back(std::move(item));
  }
  out["confidence"] = fix.confidence == Confidence::kSure ? "sure" : "maybe";
  return out;
}

Json when_json(const When& when) {
  Json out;
  out["time"] = seconds_of(when.time_ns);
  if (!when.resource.empty()) add_text(out, when.resource_type, when.resource);
  add_text(out, "task", when.task);
  add_text(out, "note", when.note);
  if (when.moved) out["moved"] = *when.moved;
  if (!when.calls.empty()) out["calls"] = when.calls;
  return out;
}

}  // namespace

std::string render_json(const Diagnostic& diagnostic, const SourceSet& sources) {
  const auto has_text = [&](const Mark& mark) { return mark.span.source < sources.size(); };
  Json out;
  out["code"] = diagnostic.code;
  out["severity"] = diagnostic.severity == Severity::kError ? "error" : "advice";
  out["message"] = diagnostic.message;
  if (has_text(diagnostic.mark)) add_mark(out, diagnostic.mark, sources);
  Json related = Json::array();
  for (const Mark& mark : diagnostic.related) {
    const bool only_context = mark.span.empty() && mark.label.empty();
    if (only_context || !has_text(mark)) continue;
    add_mark(related.emplace_back(Json::object()), mark, sources);
  }
  if (!related.empty()) out["related"] = std::move(related);
  add_text(out, "why", diagnostic.why);
  if (diagnostic.fix) out["fix"] = fix_json(*diagnostic.fix, diagnostic.mark.span.source, sources);
  if (tells_something(diagnostic.when)) out["when"] = when_json(*diagnostic.when);
  // Invalid UTF-8 becomes U+FFFD, because a message must not fail on the text that it quotes.
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace armlet
