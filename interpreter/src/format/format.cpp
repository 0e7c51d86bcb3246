#include "armlet/interpreter/format.hpp"

#include <algorithm>

#include "armlet/core/ample_stack.hpp"
#include "base/cancelled.hpp"
#include "format/columns.hpp"
#include "format/lay_out.hpp"
#include "format/layout.hpp"
#include "syntax/parse.hpp"
#include "syntax/tokens/lex.hpp"

namespace armlet {
namespace lang {
namespace {

struct Reading {
  Shape shape;
  bool ok = false;
};

Reading read(const Source& source, DiagnosticSink& sink, const std::atomic<bool>* cancelled) {
  Reading out;
  Arena arena;
  out.ok = parse(source, arena, sink, {}, &out.shape, cancelled).ok;
  return out;
}

// The line ends of the output are those of the first line.
std::string_view line_end_of(std::string_view text) {
  const std::size_t at = text.find_first_of("\r\n");
  return at != std::string_view::npos && text.substr(at).starts_with("\r\n") ? "\r\n" : "\n";
}

// The text of a comment without its line ends, for comparisons.
std::string bare_comment(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    out += text[i] == '\r' ? '\n' : text[i];
  }
  return out.substr(0, out.find_last_not_of(" \t\f\v\n") + 1);
}

std::string lay_out_once(const Source& source, const Shape& shape,
                         const std::atomic<bool>* cancelled) {
  const std::uint32_t begin = program_range(source).begin;
  const std::string_view line_end = line_end_of(source.text());
  const Doc doc = Layout(source, shape, begin, cancelled).program();
  std::vector<OutLine> lines = print(doc, cancelled);
  const auto is_empty = [](const OutLine& line) {
    return line.text.empty() && line.remark.empty();
  };
  // The layout begins after a line with #!, or at the start.
  std::string out(source.text().substr(0, begin));
  while (out.ends_with('\r')) out.pop_back();
  if (out.find("#!") != std::string::npos) {
    out += line_end;
    lines.erase(lines.begin());
  } else {
    while (!lines.empty() && is_empty(lines.front())) lines.erase(lines.begin());
  }
  while (!lines.empty() && is_empty(lines.back())) lines.pop_back();
  return out + aligned(std::move(lines), line_end);
}

constexpr int kMostPasses = 8;

}  // namespace

// Repeats the layout until it does not change: a comment between tokens may move again once the
// rest has its layout.
std::string lay_out(const Source& source, const Shape& shape, const std::atomic<bool>* cancelled) {
  std::string text = lay_out_once(source, shape, cancelled);
  for (int pass = 1; pass < kMostPasses; ++pass) {
    const Source again(source.name(), text);
    DiagnosticSink none;
    const Reading reading = read(again, none, cancelled);
    // Also for a program with mistakes, unless the mistakes are in its syntax.
    const bool is_read = same_shape(shape, source, reading.shape, again);
    std::string next = is_read ? lay_out_once(again, reading.shape, cancelled) : text;
    if (next == text) break;
    text = std::move(next);
  }
  return text;
}

bool same_comments(const Shape& a, const Source& a_text, const Shape& b, const Source& b_text) {
  return std::ranges::equal(a.comments, b.comments, [&](Span one, Span other) {
    return bare_comment(a_text.slice(one)) == bare_comment(b_text.slice(other));
  });
}

namespace {

Formatted formatted(const Source& source, const std::atomic<bool>* cancelled) {
  DiagnosticSink sink(ParseLimits{}.errors);
  const Reading before = read(source, sink, cancelled);
  if (!before.ok) return {.problems = sink.take_sorted()};
  const Source result(source.name(), lay_out(source, before.shape, cancelled));
  DiagnosticSink none;
  const Reading after = read(result, none, cancelled);
  const bool same = after.ok && same_shape(before.shape, source, after.shape, result) &&
                    same_comments(before.shape, source, after.shape, result);
  if (!same) return {.text = std::string(source.text()), .changed_meaning = true};
  return {.text = std::string(result.text())};
}

}  // namespace
}  // namespace lang

Formatted format_program(const Source& source, const std::atomic<bool>* cancelled) {
  Formatted out;
  try {
    on_ample_stack([&] { out = lang::formatted(source, cancelled); });
  } catch (const lang::Cancelled&) {
    out.problems.push_back(make_diagnostic("R0629", {}));
  }
  return out;
}

}  // namespace armlet
