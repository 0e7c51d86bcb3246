#include "syntax/build/text_lines.hpp"

#include <algorithm>
#include <optional>

namespace armlet::lang {
namespace {

constexpr std::string_view kBlanks = " \t";

std::size_t end_of_line(std::string_view raw, std::size_t at) {
  return std::min(raw.find_first_of("\r\n", at), raw.size());
}

// The blanks that all lines so far begin with.
class Common {
 public:
  void add(std::string_view blanks) {
    if (!blanks_) {
      blanks_ = blanks;
      return;
    }
    std::size_t same = 0;
    while (same < std::min(blanks_->size(), blanks.size()) && (*blanks_)[same] == blanks[same])
      ++same;
    blanks_ = blanks_->substr(0, same);
  }
  [[nodiscard]] std::size_t size() const { return blanks_ ? blanks_->size() : 0; }

 private:
  std::optional<std::string_view> blanks_;
};

bool is_blank(std::string_view line) {
  return line.find_first_not_of(kBlanks) == std::string_view::npos;
}

std::string_view blanks_of(std::string_view line) {
  return line.substr(0, std::min(line.find_first_not_of(kBlanks), line.size()));
}

}  // namespace

std::size_t line_break_at(std::string_view raw, std::size_t at) {
  if (at >= raw.size()) return 0;
  if (raw.substr(at).starts_with("\r\n")) return 2;
  return raw[at] == '\n' || raw[at] == '\r' ? 1 : 0;
}

TextLines lines_of_text(std::string_view raw) {
  TextLines out{.begin = 0, .end = raw.size()};
  const std::size_t first_end = end_of_line(raw, 0);
  if (first_end == raw.size()) return out;
  if (is_blank(raw.substr(0, first_end))) out.begin = first_end + line_break_at(raw, first_end);
  Common common;
  for (std::size_t last_end = first_end; last_end < raw.size();) {
    const std::size_t start = last_end + line_break_at(raw, last_end);
    const std::size_t end = end_of_line(raw, start);
    const std::string_view line = raw.substr(start, end - start);
    const bool is_last = end == raw.size();
    if (is_last || !is_blank(line)) common.add(is_last && is_blank(line) ? line : blanks_of(line));
    if (is_last && is_blank(line)) out.end = std::max(out.begin, last_end);
    last_end = end;
  }
  out.indentation = common.size();
  if (out.begin > 0) out.begin = std::min(out.line_start(raw, out.begin), out.end);
  return out;
}

std::size_t TextLines::line_start(std::string_view raw, std::size_t at) const {
  std::size_t skipped = 0;
  while (skipped < indentation && at + skipped < raw.size() &&
         kBlanks.find(raw[at + skipped]) != std::string_view::npos)
    ++skipped;
  return at + skipped;
}

}  // namespace armlet::lang
