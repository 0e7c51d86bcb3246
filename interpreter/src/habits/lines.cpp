#include <algorithm>
#include <optional>

#include "habits/habits.hpp"
#include "habits/meant.hpp"
#include "habits/pattern.hpp"
#include "habits/rows.hpp"

namespace armlet::lang {
namespace {

constexpr int kMostRewritings = 20;
constexpr std::size_t kMostOfOneLine = 3;  // explanations of one kind that are tried

// A row that matches, its position in the text, and the replacement.
struct Fitting {
  const Habit* habit = nullptr;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::string here;
  bool is_sample = false;  // kOnlyShown
};

bool takes_rest(const Habit& habit) { return habit.shape.ends_with("..."); }

std::optional<Fitting> fitting(const Line& line, const Habit& habit, const Found& found) {
  Fitting out{.habit = &habit,
              .begin = line.pieces[found.first].begin,
              .end = line.pieces[found.last - 1].end,
              .here = {}};
  if (takes_rest(habit)) out.end = static_cast<std::uint32_t>(line.text.size());
  if (habit.here == kNoSuchThing) return out;
  out.is_sample = habit.here.starts_with(kOnlyShown);
  std::optional<std::string> here = filled(habit.here.substr(out.is_sample ? 1 : 0), found.parts);
  if (!here) return std::nullopt;
  out.here = *std::move(here);
  return out;
}

// Whether the value is beside an operator that would apply to a part of its replacement: 2 * mod(a,
// b), pose_add(a, b).x
bool is_in_a_term(const Line& line, const Found& found) {
  constexpr std::string_view kApart = "( [ { ) ] } , ; : = := => -> ? <<";
  const auto joins = [&](std::size_t at) {
    const std::string_view piece = line.piece(at);
    return line.pieces[at].kind == Piece::Kind::kMark && kApart.find(piece) == kApart.npos;
  };
  const bool is_indexed = found.last < line.pieces.size() && line.piece(found.last) == "[";
  return (found.first > 0 && joins(found.first - 1)) || is_indexed ||
         (found.last < line.pieces.size() && joins(found.last));
}

// The first rows that match the whole statement.
std::vector<Fitting> whole_statement(const Line& line, std::size_t first, std::size_t last) {
  std::vector<Fitting> out;
  Patience patience = kPatience;
  for (const Habit& habit : statement_habits()) {
    if (out.size() == kMostOfOneLine) break;
    const bool takes_end = habit.shape.ends_with(" ;");
    const std::size_t end = takes_rest(habit) ? line.pieces.size()
                            : takes_end       ? std::min(last + 1, line.pieces.size())
                                              : last;
    const std::optional<Found> found = match_all(line, first, end, habit.shape, patience);
    if (!found) continue;
    if (std::optional<Fitting> fits = fitting(line, habit, *found)) out.push_back(*fits);
  }
  return out;
}

// The first match of a value in the line, from row `row` on; `row` is then the next one. Rows of
// toolboxes come after those of languages.
std::optional<Fitting> first_value(const Line& line, Patience& patience, std::size_t& row) {
  const std::size_t languages = value_habits().size();
  const std::size_t all = languages + toolbox_habits().size();
  while (row < all) {
    const Habit& habit = row < languages ? value_habits()[row] : toolbox_habits()[row - languages];
    ++row;
    const std::optional<Found> found =
        match_inside(line, 0, line.pieces.size(), habit.shape, patience);
    if (!found) continue;
    std::optional<Fitting> out = fitting(line, habit, *found);
    if (out && is_in_a_term(line, *found)) out->here = in_a_term(out->here);
    if (out && out->here != line.text.substr(out->begin, out->end - out->begin)) return out;
  }
  return std::nullopt;
}

// A statement of a line: the pieces between braces and semicolons outside of other brackets.
struct Segment {
  std::size_t first;
  std::size_t last;
};

std::vector<Segment> segments_of(const Line& line) {
  std::vector<Segment> out;
  int depth = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= line.pieces.size(); ++i) {
    const std::string_view piece = i < line.pieces.size() ? line.piece(i) : ";";
    depth += piece == "(" || piece == "[" ? 1 : piece == ")" || piece == "]" ? -1 : 0;
    const bool ends = piece == ";" || piece == "{" || piece == "}";
    if (!ends || (depth > 0 && i < line.pieces.size())) continue;
    if (i > first) out.push_back({first, i});
    first = i + 1;
  }
  return out;
}

// Whether a word is an element of a shape.
bool shape_has_word(std::string_view shape, std::string_view word) {
  while (!shape.empty()) {
    const std::size_t blank = std::min(shape.find(' '), shape.size());
    std::string_view element = shape.substr(0, blank);
    while (element.size() > 1 && std::string_view("~^").find(element[0]) != std::string_view::npos)
      element.remove_prefix(1);
    if (element == word) return true;
    shape.remove_prefix(std::min(blank + 1, shape.size()));
  }
  return false;
}

// Makes an explanation from a match in a line that begins at byte `base` of a source.
class Explainer {
 public:
  Explainer(const Source& source, int number)
      : source_(source), base_(source.line_start(number)), line_(source.line(number)) {}

  [[nodiscard]] std::vector<Explanation> all(Span mark) const {
    std::vector<Explanation> out;
    std::size_t last = line_.pieces.size();
    while (last > 0 && line_.piece(last - 1) == ";") --last;
    if (last == 0) return out;
    for (const Fitting& found : whole_statement(line_, 0, last)) add(out, found, found, true);
    const std::uint32_t column = mark.begin - base_;
    for (const Segment segment : segments_of(line_)) {
      const std::uint32_t begin = line_.pieces[segment.first].begin;
      const std::uint32_t end = line_.pieces[segment.last - 1].end;
      if (column > end || mark.end - base_ < begin) continue;
      if (segment.first > 0 || segment.last < last) {
        for (const Fitting& found : whole_statement(line_, segment.first, segment.last))
          add(out, found, found, true);
      }
    }
    values(out, last);
    const std::string_view marked = source_.slice(mark);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i].names_it = shape_has_word(habits_of_[i]->shape, marked);
    return out;
  }

 private:
  [[nodiscard]] Span span(std::uint32_t begin, std::uint32_t end) const {
    return {base_ + begin, base_ + end, source_.id()};
  }

  // A message shows the first value that matches; its edits change all that match.
  void values(std::vector<Explanation>& out, std::size_t last) const {
    const std::uint32_t end = line_.pieces[last - 1].end;
    const Line line(line_.text.substr(0, end));
    Patience patience = kPatience;
    std::size_t row = 0;
    for (std::size_t tried = 0; tried < kMostOfOneLine; ++tried) {
      const std::optional<Fitting> found = first_value(line, patience, row);
      if (!found) return;
      std::string here(line.text);
      here.replace(found->begin, found->end - found->begin, found->here);
      const Fitting changed{found->habit, 0, end, std::move(here), found->is_sample};
      add(out, *found, changed, true);
      // p->x is p.x, but p is not a position that has to be converted.
      const bool goes_on = with_values_here(changed.here) != changed.here;
      if (goes_on && !changed.is_sample && found->habit->here != kNoSuchThing)
        add(out, *found, changed, false);
    }
  }

  // shown    the match that the message is about.
  // changed  the match that the edits replace; with `all`, its `here` is converted until no row
  //          matches.
  void add(std::vector<Explanation>& out, const Fitting& shown, const Fitting& changed,
           bool all) const {
    const Habit& habit = *shown.habit;
    habits_of_.push_back(&habit);
    const bool is_statement = &shown == &changed;
    const Span mark = span(shown.begin, shown.end);
    const std::string found(line_.text.substr(shown.begin, shown.end - shown.begin));
    if (habit.here == kNoSuchThing) {
      Diagnostic message = make_diagnostic("E0223", mark, {shortened(found)});
      message.why = habit.why;
      out.push_back({std::move(message), !is_statement});
      return;
    }
    const std::string here = is_statement ? with_values_here(shown.here) : shown.here;
    if (shown.is_sample) {
      Diagnostic message = make_diagnostic("E0130", mark, {shortened(found), shortened(here)});
      message.why = habit.why;
      out.push_back({std::move(message), !is_statement});
      return;
    }
    Diagnostic message = here.empty()
                             ? make_diagnostic("E0116", mark, {shortened(found)})
                             : make_diagnostic("E0130", mark, {shortened(found), shortened(here)});
    message.why = habit.why;
    const std::string text(line_.text.substr(changed.begin, changed.end - changed.begin));
    message.fix = Fix{here.empty() ? "delete " + shortened(found) : "write " + here,
                      edits(changed, text,
                            is_statement ? here
                            : all        ? with_values_here(changed.here)
                                         : changed.here),
                      Confidence::kMaybe};
    out.push_back({std::move(message), !is_statement});
  }

  [[nodiscard]] std::vector<Edit> edits(const Fitting& changed, const std::string& from,
                                        const std::string& to) const {
    if (to.empty()) return {{deleted(changed), ""}};
    std::vector<Edit> out;
    for (const LineEdit& edit : line_edits(from, to))
      out.push_back({span(changed.begin + edit.begin, changed.begin + edit.end), edit.text});
    return out;
  }

  // The span of a deleted statement, with the `;` after it if the rest of the line is empty. The
  // line itself stays, because an error in the next line is independent of it.
  [[nodiscard]] Span deleted(const Fitting& changed) const {
    const std::string_view before = line_.text.substr(0, changed.begin);
    const std::string_view behind = line_.text.substr(changed.end);
    const bool alone = before.find_first_not_of(" \t") == std::string_view::npos &&
                       behind.find_first_not_of(" \t\r;") == std::string_view::npos;
    return alone ? span(0, static_cast<std::uint32_t>(line_.text.size()))
                 : span(changed.begin, changed.end);
  }

  const Source& source_;
  std::uint32_t base_;
  Line line_;
  mutable std::vector<const Habit*> habits_of_;  // the habits of the explanations
};

}  // namespace

std::string with_values_here(std::string text) {
  Patience patience = kPatience;
  for (int i = 0; i < kMostRewritings; ++i) {
    const Line line(text);
    std::size_t row = 0;
    std::optional<Fitting> found = first_value(line, patience, row);
    while (found && (found->habit->here == kNoSuchThing || found->is_sample))
      found = first_value(line, patience, row);
    if (!found) break;
    text.replace(found->begin, found->end - found->begin, found->here);
  }
  return text;
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMostShown = 70;
  if (text.size() <= kMostShown) return text;
  std::size_t end = kMostShown - 4;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + " ...";
}

std::vector<Explanation> explain_line(const Source& source, Span mark) {
  return Explainer(source, source.position(mark.begin).line).all(mark);
}

}  // namespace armlet::lang
