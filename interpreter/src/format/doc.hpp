#pragma once
// A document with the positions where its lines may be broken, and the printer that selects them
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
  kFillLine,  // `text` if the part up to the next kFillLine fits, otherwise a line break
  kBreak,     // always a line break
  kContinue,  // always a line break; the new line is indented once more
  kConcat,
  kGroup,   // its lines are all flat or all broken
  kIndent,  // the lines that start inside are indented by `number` more columns
  kBody,    // lines inside are broken even if the group around is flat
  kRemark,  // `text` is a comment at the end of the line; its old column is `number`
  kColumn   // a part that may be aligned; its old column is `number`; `wide`: after several blanks
};

struct Doc {
  DocKind kind = DocKind::kConcat;
  std::string_view text = {};
  int number = 0;
  bool blank = false;   // kBreak: an empty line comes first
  bool wide = false;    // kColumn
  bool forced = false;  // a comment inside breaks the line, so the groups around it are broken too
  bool body = false;    // has statements in braces that may get lines of their own
  bool hugs = false;    // kGroup: its lines are flat, even if inner groups are broken
  std::vector<Doc> parts = {};

  void add(Doc part);
};

[[nodiscard]] Doc text(std::string_view text);
[[nodiscard]] Doc line(std::string_view flat);
[[nodiscard]] Doc hard_break(bool blank = false);
[[nodiscard]] Doc indent(Doc inner, int columns = kIndentWidth);
// A group of lines, all flat or all broken. With statements inside it is flat, because the braces
// have lines of their own.
[[nodiscard]] Doc group(Doc inner);
// Statements in braces: on one line if they fit and `may_be_flat`, otherwise one line each.
[[nodiscard]] Doc body(Doc inner, bool may_be_flat);

// One line of the output.
struct OutLine {
  int indent = 0;
  std::string text;
  std::string remark;     // the comment at its end
  int remark_column = 0;  // the column of the comment in the old text
  int column = 0;         // the old column of the part after `split`; 0: nothing to align
  std::size_t split = 0;  // bytes of `text` before the part to align
  bool wide = false;
};

// The lines of the document. Throws Cancelled soon after `cancelled` has become true.
[[nodiscard]] std::vector<OutLine> print(const Doc& doc,
                                         const std::atomic<bool>* cancelled = nullptr);

// The width of a text on a screen, in columns; of several lines, that of the last one.
[[nodiscard]] int text_width(std::string_view text);

}  // namespace armlet::lang
