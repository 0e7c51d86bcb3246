#pragma once
// Text with the places where its lines may be broken, and the printer that chooses among them
// (after P. Wadler, "A prettier printer", 2003).

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

inline constexpr int kLineWidth = 100;
inline constexpr int kIndentWidth = 4;

enum class DocKind : std::uint8_t {
  kText,
  kLine,      // `text` if its group is flat, otherwise a line break
  kFillLine,  // `text` if what follows up to the next such place fits, otherwise a line break
  kBreak,     // always a line break
  kContinue,  // always a line break, and the new line is indented once more
  kConcat,
  kGroup,   // its lines are all flat or all broken
  kIndent,  // `number` columns more for the lines that start inside
  kBody,    // lines inside are broken even if the group around is flat
  kRemark,  // `text` is a comment at the end of the line; it stood in column `number`
  kColumn   // here begins what may be aligned; it stood in column `number`; `wide`: behind blanks
};

struct Doc {
  DocKind kind = DocKind::kConcat;
  std::string_view text = {};
  int number = 0;
  bool blank = false;   // kBreak: an empty line comes first
  bool wide = false;    // kColumn
  bool forced = false;  // a comment inside breaks the line, so groups around it are broken
  bool body = false;    // contains statements, in braces that may get lines of their own
  bool hugs = false;    // kGroup: its lines are flat, whatever the groups inside decide
  std::vector<Doc> parts = {};

  void add(Doc part);
};

[[nodiscard]] Doc text(std::string_view text);
[[nodiscard]] Doc line(std::string_view flat);
[[nodiscard]] Doc hard_break(bool blank = false);
[[nodiscard]] Doc indent(Doc inner, int columns = kIndentWidth);
// A group with statements inside is flat: their braces are enough lines.
[[nodiscard]] Doc group(Doc inner);
// Statements in braces: on one line if they fit (and `may_be_flat`), otherwise a line each.
[[nodiscard]] Doc body(Doc inner, bool may_be_flat);

// One line of the result.
struct OutLine {
  int indent = 0;
  std::string text;
  std::string remark;     // the comment at its end
  int remark_column = 0;  // where the comment stood
  int column = 0;         // where what follows `split` stood; 0: nothing to align
  std::size_t split = 0;  // bytes of `text` before what may be aligned
  bool wide = false;
};

// Throws Cancelled soon after `cancelled` has become true.
[[nodiscard]] std::vector<OutLine> print(const Doc& doc,
                                         const std::atomic<bool>* cancelled = nullptr);

// Columns that a text takes on a screen; of several lines, the last.
[[nodiscard]] int text_width(std::string_view text);

}  // namespace armlet::lang
