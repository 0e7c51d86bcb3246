#include "format/columns.hpp"

#include <algorithm>
#include <span>

namespace armlet::lang {
namespace {

// The count of blanks before a comment at the end of a line. A comment of the kind /* */ has one
// blank, as in the middle of a line.
int blanks_before(const OutLine& line) { return line.remark.starts_with("//") ? 2 : 1; }

int width(const OutLine& line) {
  const bool alone = line.text.find('\n') == std::string::npos;
  return (alone ? line.indent : 0) + text_width(line.text);
}

int width_before_split(const OutLine& line) {
  return line.indent + text_width(line.text.substr(0, line.split));
}

// Calls `act` for each run of neighbouring lines that `belong` together.
template <class Belong, class Act>
void for_each_run(std::vector<OutLine>& lines, Belong belong, Act act) {
  for (std::size_t first = 0; first < lines.size();) {
    std::size_t end = first + 1;
    while (end < lines.size() && belong(lines[end - 1], lines[end])) ++end;
    act(std::span(lines).subspan(first, end - first));
    first = end;
  }
}

void align_values(std::span<OutLine> run) {
  if (run.size() == 1 || std::ranges::none_of(run, &OutLine::wide)) return;
  int column = 0;
  for (const OutLine& line : run) column = std::max(column, width_before_split(line));
  for (const OutLine& line : run) {
    if (width(line) + column - width_before_split(line) > kLineWidth) return;
  }
  for (OutLine& line : run) {
    const auto blanks = static_cast<std::size_t>(column - width_before_split(line));
    line.text.insert(line.split, blanks, ' ');
  }
}

void align_remarks(std::span<OutLine> run) {
  int column = run[0].remark_column;
  for (const OutLine& line : run) column = std::max(column, width(line) + blanks_before(line));
  for (OutLine& line : run) {
    if (line.remark.empty()) continue;
    if (!line.text.empty()) line.text.append(static_cast<std::size_t>(column - width(line)), ' ');
    line.text += line.remark;
  }
}

// Appends the text with all its line breaks replaced by `line_end`.
void append_text(std::string& out, std::string_view text, std::string_view line_end) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    if (text[i] == '\r' || text[i] == '\n') {
      out += line_end;
    } else {
      out += text[i];
    }
  }
}

}  // namespace

std::string aligned(std::vector<OutLine> lines, std::string_view line_end) {
  const auto same_value = [](const OutLine& a, const OutLine& b) {
    return a.column != 0 && a.column == b.column && a.indent == b.indent;
  };
  const auto same_remark = [](const OutLine& a, const OutLine& b) {
    return a.remark.starts_with("//") && b.remark.starts_with("//") &&
           a.remark_column == b.remark_column;
  };
  for_each_run(lines, same_value, align_values);
  for_each_run(lines, same_remark, align_remarks);
  std::string out;
  for (const OutLine& line : lines) {
    if (!line.text.empty()) out.append(static_cast<std::size_t>(line.indent), ' ');
    append_text(out, line.text, line_end);
    out += line_end;
  }
  return out;
}

}  // namespace armlet::lang
