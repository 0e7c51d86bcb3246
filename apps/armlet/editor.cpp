// armlet complete and armlet hover: information about a position of a file, for editors.

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/stdlib/install.hpp"
#include "console/console.hpp"
#include "console/setup.hpp"

namespace armlet::cli {
namespace {

using Json = nlohmann::ordered_json;

// The position "12:5"; nullopt if the text is none.
std::optional<Position> position_of(const std::string& text) {
  Position out;
  const char* const end = text.data() + text.size();
  const auto line = std::from_chars(text.data(), end, out.line);
  if (line.ec != std::errc() || line.ptr == end || *line.ptr != ':') return std::nullopt;
  const auto column = std::from_chars(line.ptr + 1, end, out.column);
  if (column.ec != std::errc() || column.ptr != end || out.line < 1 || out.column < 1)
    return std::nullopt;
  return out;
}

// The byte offset of a position; columns count characters and end at the end of the line.
std::uint32_t byte_at(const Source& source, Position position) {
  if (position.line > source.line_count()) return static_cast<std::uint32_t>(source.text().size());
  const std::string_view line = source.line(position.line);
  std::size_t at = 0;
  for (int column = 1; column < position.column && at < line.size(); ++column) {
    ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U) ++at;
  }
  return source.line_start(position.line) + static_cast<std::uint32_t>(at);
}

Json position_json(const Source& source, std::uint32_t byte) {
  const Position at = source.position(byte);
  return {{"line", at.line}, {"column", at.column}};
}

Json span_json(const Source& source, Span span) {
  return {{"start", position_json(source, span.begin)}, {"end", position_json(source, span.end)}};
}

struct Asked {
  std::shared_ptr<const Analysis> analysis;
  std::uint32_t at = 0;
  int exit = kDone;
};

Asked analyse(const EditorOptions& options) {
  const std::optional<Position> position = position_of(options.position);
  if (!position) {
    progress(fmt::format("armlet: a position is LINE:COLUMN, such as 12:5, not \"{}\"",
                         options.position));
    return {.exit = kUsage};
  }
  auto text = read_file(options.file, options.program.json);
  if (!text) return {.exit = kNoFile};
  Setup setup = make_setup(options.program, options.file);
  if (setup.exit != kDone) return {.exit = setup.exit};
  Session session(library_engine(), std::move(setup.session));
  Asked out{.analysis = session.analyse(*std::move(text), options.file)};
  out.at = byte_at(out.analysis->sources()[0], *position);
  return out;
}

}  // namespace

int complete(const EditorOptions& options) {
  const Asked asked = analyse(options);
  if (asked.exit != kDone) return asked.exit;
  const Source& source = asked.analysis->sources()[0];
  const Completions found = asked.analysis->completion(asked.at);
  const std::string_view begun =
      source.slice({found.replaced.begin, std::max(asked.at, found.replaced.begin), 0});
  Json items = Json::array();
  for (const Completion& item : found.items) {
    if (!item.text.starts_with(begun)) continue;
    if (options.program.json) {
      items.push_back(
          {{"text", item.text}, {"kind", name_kind_text(item.kind)}, {"detail", item.detail}});
    } else {
      print_out(
          fmt::format("{:<24} {:<17} {}\n", item.text, name_kind_text(item.kind), item.detail));
    }
  }
  if (options.program.json) {
    const Json out = {{"replaced", span_json(source, found.replaced)}, {"items", std::move(items)}};
    print_out(out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
  }
  return finish_output() ? kDone : kFailed;
}

int hover(const EditorOptions& options) {
  const Asked asked = analyse(options);
  if (asked.exit != kDone) return asked.exit;
  const Source& source = asked.analysis->sources()[0];
  const std::optional<Hover> found = asked.analysis->hover(asked.at);
  if (options.program.json) {
    Json out = Json::object();
    if (found) {
      out = {{"span", span_json(source, found->span)},
             {"text", found->text},
             {"help", found->help},
             {"value", found->value},
             {"messages", found->messages}};
    }
    print_out(out.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
  } else if (found) {
    for (const std::string* part : {&found->text, &found->help}) {
      if (!part->empty()) print_out(*part + '\n');
    }
    if (!found->value.empty()) print_out("value " + found->value + '\n');
    for (const std::string& message : found->messages) print_out(message + '\n');
  }
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
