#include "armlet/interpreter/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "armlet/interpreter/virtual_time.hpp"
#include "base/diagnostic/display_width.hpp"

namespace armlet {
namespace {

using lang::display_line;
using lang::DisplayLine;
using lang::printable;

// Lines longer than this are shown as a part around their first mark.
constexpr std::size_t kLongLine = 160;
constexpr std::size_t kShownPart = 120;
constexpr std::size_t kShownBefore = 40;
constexpr std::string_view kCut = "...";
// The largest width of a headline; a longer one is cut, and its full text follows below the program
// text.
constexpr std::size_t kLongHeadline = 120;

// A mark on one line; offsets are bytes within the line.
struct LineMark {
  int line = 1;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool main = false;
  bool drawn = true;
  std::string label;
};

LineMark line_mark(const Source& source, const Mark& mark, bool main) {
  LineMark out;
  out.line = source.position(mark.span.begin).line;
  const std::size_t start = source.line_start(out.line);
  const std::size_t size = source.line(out.line).size();
  out.begin = std::min<std::size_t>(mark.span.begin - start, size);
  out.end = std::clamp<std::size_t>(mark.span.end - start, out.begin, size);
  out.main = main;
  out.drawn = main || !mark.span.empty() || !mark.label.empty();
  out.label = printable(mark.label);
  const int last = mark.span.empty() ? out.line : source.position(mark.span.end - 1).line;
  if (last > out.line) {
    out.label += fmt::format("{}(to line {})", out.label.empty() ? "" : " ", last);
  }
  return out;
}

// The part of a line that is shown.
struct Window {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Window window_around(std::string_view line, std::size_t mark) {
  if (line.size() <= kLongLine) return {0, line.size()};
  const std::size_t wanted = mark > kShownBefore ? mark - kShownBefore : 0;
  const std::size_t begin = std::min(wanted, line.size() - kShownPart);
  return {lang::character_start(line, begin), lang::character_start(line, begin + kShownPart)};
}

// The beginning of a text, of at most `width` columns, up to the end of a word; the whole text if
// no word ends there.
std::string cut_at_a_word(const std::string& text, std::size_t width) {
  const DisplayLine line = display_line(text);
  if (line.columns.back() <= static_cast<int>(width)) return text;
  const int most = static_cast<int>(width - kCut.size() - 1);
  for (std::size_t end = text.size() - 1; end > 0; --end) {
    if (text[end] == ' ' && text[end - 1] != ' ' && line.columns[end] <= most)
      return text.substr(0, end);
  }
  return text;
}

class TextRenderer {
 public:
  TextRenderer(const Diagnostic& diagnostic, const SourceSet& sources, RenderOptions options)
      : diagnostic_(diagnostic), sources_(sources), options_(options) {}

  std::string render() {
    headline();
    const bool has_text = diagnostic_.mark.span.source < sources_.size();
    if (has_text) text_blocks();
    notes(has_text);
    return std::move(out_);
  }

 private:
  static constexpr std::string_view kRed = "\033[1;31m";
  static constexpr std::string_view kYellow = "\033[1;33m";
  static constexpr std::string_view kBlue = "\033[1;34m";
  static constexpr std::string_view kBold = "\033[1m";
  static constexpr std::string_view kPlain = "\033[0m";

  std::string painted(std::string_view color, std::string_view text) const {
    if (!options_.color) return std::string(text);
    return fmt::format("{}{}{}", color, text, kPlain);
  }

  std::string_view main_color() const {
    return diagnostic_.severity == Severity::kError ? kRed : kYellow;
  }

  // Ends a line without trailing spaces.
  void end_line() {
    while (out_.ends_with(' ')) out_.pop_back();
    out_ += '\n';
  }

  void headline() {
    const std::string_view severity = diagnostic_.severity == Severity::kError ? "error" : "advice";
    const std::string start = fmt::format("{} {}", severity, diagnostic_.code);
    const std::string whole = printable(diagnostic_.message);
    const std::string shown = cut_at_a_word(whole, kLongHeadline - start.size() - 2);
    is_cut_ = shown.size() < whole.size();
    out_ += painted(main_color(), start);
    out_ += painted(kBold, ": " + (is_cut_ ? shown + ' ' + std::string(kCut) : shown));
    end_line();
  }

  // "   | " without a number, or "12 | ".
  void gutter(std::string_view number) {
    out_ += painted(kBlue, fmt::format("{:>{}} |", number, width_));
    out_ += ' ';
  }

  void text_blocks() {
    // Groups marks by source; the source of the main mark comes first.
    std::vector<std::uint32_t> order = {diagnostic_.mark.span.source};
    for (const Mark& mark : diagnostic_.related) {
      const std::uint32_t source = mark.span.source;
      if (source < sources_.size() && std::ranges::find(order, source) == order.end()) {
        order.push_back(source);
      }
    }
    std::vector<std::vector<LineMark>> blocks;
    int last = 1;
    for (const std::uint32_t source : order) {
      blocks.push_back(marks_in(source));
      last = std::max(last, blocks.back().back().line);
    }
    width_ = std::to_string(last).size();
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool main = i == 0;
      place(main ? diagnostic_.mark.span : first_in(order[i]), main ? "-->" : ":::");
      block(sources_[order[i]], blocks[i]);
    }
  }

  std::vector<LineMark> marks_in(std::uint32_t source) const {
    std::vector<LineMark> marks;
    const auto add = [&](const Mark& mark, bool main) {
      if (mark.span.source == source) marks.push_back(line_mark(sources_[source], mark, main));
    };
    add(diagnostic_.mark, true);
    for (const Mark& mark : diagnostic_.related) add(mark, false);
    std::ranges::stable_sort(marks, [](const LineMark& a, const LineMark& b) {
      return a.line != b.line ? a.line < b.line : a.begin < b.begin;
    });
    return marks;
  }

  Span first_in(std::uint32_t source) const {
    return std::ranges::find_if(diagnostic_.related,
                                [source](const Mark& m) { return m.span.source == source; })
        ->span;
  }

  void place(Span span, std::string_view arrow) {
    const Position position = sources_.position(span);
    out_.append(width_, ' ');
    out_ += painted(kBlue, arrow);
    out_ += fmt::format(" {}:{}:{}", printable(sources_[span.source].name()), position.line,
                        position.column);
    end_line();
    gutter("");
    end_line();
  }

  void block(const Source& source, const std::vector<LineMark>& marks) {
    for (std::size_t i = 0; i < marks.size();) {
      const int line = marks[i].line;
      if (i > 0) gap(source, marks[i - 1].line, line);
      std::size_t end = i;
      while (end < marks.size() && marks[end].line == line) ++end;
      marked_line(source.line(line), std::span(marks).subspan(i, end - i));
      i = end;
    }
  }

  // Between two marks one unmarked line is shown; more are replaced by dots.
  void gap(const Source& source, int before, int line) {
    if (line - before == 2) {
      const std::string_view text = source.line(before + 1);
      source_line(before + 1, text, window_around(text, 0));
    } else if (line - before > 2) {
      out_.append(width_ + 1, ' ');
      out_ += painted(kBlue, kCut);
      end_line();
    }
  }

  // Writes a line of the source. Returns the columns of the bytes that are shown.
  std::vector<int> source_line(int number, std::string_view line, Window window) {
    DisplayLine shown = display_line(line.substr(window.begin, window.end - window.begin));
    gutter(std::to_string(number));
    const bool cut_before = window.begin > 0;
    if (cut_before) out_ += kCut;
    out_ += shown.text;
    if (window.end < line.size()) out_ += kCut;
    end_line();
    if (cut_before) {
      for (int& column : shown.columns) column += static_cast<int>(kCut.size());
    }
    return std::move(shown.columns);
  }

  void marked_line(std::string_view line, std::span<const LineMark> marks) {
    const auto main = std::ranges::find(marks, true, &LineMark::main);
    const LineMark& centre = main == marks.end() ? marks.front() : *main;
    const Window window = window_around(line, centre.begin);
    const std::vector<int> columns = source_line(marks.front().line, line, window);
    const auto column = [&](std::size_t byte) {
      return columns[std::clamp(byte, window.begin, window.end) - window.begin];
    };
    for (const LineMark& mark : marks) {
      if (!mark.drawn) continue;
      const int begin = column(mark.begin);
      const int size = std::max(1, column(mark.end) - begin);
      gutter("");
      out_.append(static_cast<std::size_t>(begin), ' ');
      std::string text(static_cast<std::size_t>(size), mark.main ? '^' : '-');
      if (!mark.label.empty()) text += ' ' + mark.label;
      out_ += painted(mark.main ? main_color() : kBlue, text);
      end_line();
    }
  }

  void note(std::string_view name, std::string_view text) {
    const std::string start = fmt::format("{:>{}}= {:<6}", "", width_ + 1, name);
    out_ += options_.color ? painted(kBlue, start) : start;
    // Further lines of a label are below its first line.
    const std::string indent = '\n' + std::string(start.size(), ' ');
    for (const char c : printable(text, true)) {
      if (c == '\n') {
        out_ += indent;
      } else {
        out_ += c;
      }
    }
    end_line();
  }

  void notes(bool has_text) {
    const bool any =
        is_cut_ || tells_something(diagnostic_.when) || !diagnostic_.why.empty() || diagnostic_.fix;
    if (!any) return;
    if (has_text) {
      gutter("");
      end_line();
    }
    if (is_cut_) note("all:", diagnostic_.message);
    if (tells_something(diagnostic_.when)) note("when:", when_text(*diagnostic_.when));
    if (!diagnostic_.why.empty()) note("why:", diagnostic_.why);
    if (diagnostic_.fix) note("fix:", diagnostic_.fix->text);
  }

  const Diagnostic& diagnostic_;
  const SourceSet& sources_;
  RenderOptions options_;
  std::string out_;
  std::size_t width_ = 1;
  bool is_cut_ = false;  // the headline is cut, so its full text follows below
};

}  // namespace

bool tells_something(const std::optional<When>& when) {
  return when && (when->time_ns != 0 || !when->resource.empty() || !when->task.empty() ||
                  when->moved || !when->note.empty() || !when->calls.empty());
}

std::string when_text(const When& when) {
  // Endless recursion has thousands of calls; the innermost ones are sufficient.
  constexpr std::size_t kShownCalls = 4;
  std::string out = fmt::format("at t = {:.2f} s", seconds_of(when.time_ns));
  if (!when.resource.empty()) out += ", " + when.resource_type + ' ' + when.resource;
  if (!when.task.empty()) out += ", " + when.task;
  if (!when.note.empty()) out += ", " + when.note;
  for (std::size_t i = 0; i < std::min(when.calls.size(), kShownCalls); ++i) {
    out += ", in " + when.calls[i];
  }
  if (when.calls.size() > kShownCalls) {
    out += ", and further out";
  }
  if (when.moved && !when.moved_text.empty()) out += ", " + when.moved_text;
  return out;
}

std::string render_text(const Diagnostic& diagnostic, const SourceSet& sources,
                        RenderOptions options) {
  return TextRenderer(diagnostic, sources, options).render();
}

}  // namespace armlet
