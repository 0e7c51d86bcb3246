#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "habits/habits.hpp"
#include "habits/meant.hpp"
#include "habits/pattern.hpp"
#include "habits/rows.hpp"

namespace armlet::lang {
namespace {

using ForeignBlock = ForeignBlocks::Block;

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// The words that may end a block.
std::vector<std::string> end_words(const BlockHabit& row) {
  if (row.end == ":") return {"end"};
  const std::size_t bar = row.end.find('|');
  if (bar == std::string_view::npos) return {lower_case(row.end)};
  return {lower_case(row.end.substr(0, bar)), lower_case(row.end.substr(bar + 1))};
}

// A line with its number; `last` is the index after its last piece, without a `;` at its end.
struct Numbered {
  int number;
  Line line;
  std::size_t last;

  [[nodiscard]] std::size_t indent() const { return line.pieces[0].begin; }
};

std::optional<Numbered> numbered(const Source& source, int number) {
  Numbered out{number, Line(source.line(number)), 0};
  out.last = out.line.pieces.size();
  while (out.last > 0 && out.line.piece(out.last - 1) == ";") --out.last;
  return out.last > 0 ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<std::string> written_here(const Numbered& line, std::span<const Habit> rows) {
  Patience patience = kPatience;
  for (const Habit& row : rows) {
    const auto found = match_all(line.line, 0, line.last, row.shape, patience);
    if (!found) continue;
    if (auto here = filled(row.here, found->parts)) return with_values_here(*std::move(here));
  }
  return std::nullopt;
}

// A block whose end has not been found yet.
struct Open {
  const BlockHabit* row;
  std::size_t indent;
  std::vector<std::string> parts;
  ForeignBlock block;
};

bool is_indented(const Open& open) { return open.row->end == ":"; }

// The open blocks, the innermost last.
class OpenBlocks {
 public:
  [[nodiscard]] bool empty() const { return open_.empty(); }
  // The innermost block whose end is shown by indentation; null if there is none.
  [[nodiscard]] Open* innermost_indented() {
    const auto found = std::find_if(open_.rbegin(), open_.rend(), is_indented);
    return found != open_.rend() ? &*found : nullptr;
  }
  [[nodiscard]] Open& innermost() { return open_.back(); }

  void push(Open open) {
    for (const std::string& word : end_words(*open.row)) {
      // A brace, and the `end` of an indented block, are in the column of the block's first letter.
      if (word != "}" && !is_indented(open)) by_word_[word].push_back(open_.size());
      alike_[{word, open.indent}].push_back(open_.size());
    }
    open_.push_back(std::move(open));
  }

  void pop() {
    const Open& open = open_.back();
    for (const std::string& word : end_words(*open.row)) {
      if (word != "}" && !is_indented(open)) by_word_[word].pop_back();
      alike_[{word, open.indent}].pop_back();
    }
    open_.pop_back();
  }

  // Removes the blocks inside of the nearest one that a word ends, preferring one with the same
  // indentation as the word; returns false if there is none.
  bool drop_to(std::string_view word, std::size_t indent) {
    const std::string name = lower_case(word);
    const auto alike = alike_.find({name, indent});
    const auto any = by_word_.find(name);
    std::size_t found = 0;
    if (alike != alike_.end() && !alike->second.empty()) {
      found = alike->second.back();
    } else if (any != by_word_.end() && !any->second.empty()) {
      found = any->second.back();
    } else {
      return false;
    }
    while (open_.size() > found + 1) pop();
    return true;
  }

 private:
  std::vector<Open> open_;
  std::map<std::string, std::vector<std::size_t>> by_word_;
  std::map<std::pair<std::string, std::size_t>, std::vector<std::size_t>> alike_;
};

class Reader {
 public:
  explicit Reader(const Source& source) : source_(source) {}

  std::vector<ForeignBlock> run() {
    for (int number = 1; number <= source_.line_count(); ++number) {
      const std::optional<Numbered> line = numbered(source_, number);
      if (!line) continue;
      end_by_indentation(*line);
      if (!ends(*line) && !is_between(*line)) begin(*line);
      last_ = number;
    }
    while (!open_.empty()) {
      if (is_indented(open_.innermost())) end_behind(open_.innermost());
      open_.pop();
    }
    return std::move(blocks_);
  }

 private:
  // Replaces the statement of a line, or deletes it.
  void change(ForeignBlock& block, const Numbered& line, const std::string& here) {
    const std::uint32_t base = source_.line_start(line.number);
    if (here.empty()) {
      const auto end = static_cast<std::uint32_t>(base + line.line.text.size());
      block.edits.push_back({{base, end, source_.id()}, ""});
      return;
    }
    const std::uint32_t begin = line.line.pieces[0].begin;
    const std::uint32_t end = line.line.pieces.back().end;
    for (const LineEdit& edit : line_edits(line.line.text.substr(begin, end - begin), here))
      block.edits.push_back(
          {{base + begin + edit.begin, base + begin + edit.end, source_.id()}, edit.text});
  }

  void begin(const Numbered& line) {
    Patience patience = kPatience;
    for (const BlockHabit& row : block_habits()) {
      const bool has_brace = line.line.piece(line.last - 1) == "{";
      const auto found = match_all(line.line, 0, line.last, row.shape, patience);
      if (!found || (has_brace != row.shape.ends_with('{'))) continue;
      auto here = filled(row.here, found->parts);
      if (!here) continue;
      Open open{&row, line.indent(), found->parts, {}};
      open.block.first = line.number;
      open.block.found = line.line.text_of(0, line.last);
      open.block.here = with_values_here(*std::move(here));
      open.block.by_indentation = is_indented(open);
      change(open.block, line, open.block.here);
      open_.push(std::move(open));
      return;
    }
  }

  // Whether a line such as else: belongs to the innermost block. If that ends by indentation, the
  // line must have the block's indentation.
  bool is_between(const Numbered& line) {
    if (open_.empty()) return false;
    Open& open = open_.innermost();
    if (open.row->gives_first && line.last > 1 && line.line.piece(1) == "=" &&
        line.line.piece(0) == open.parts[0])
      first_value(open, line);
    if (is_indented(open) && line.indent() != open.indent) return false;
    if (open.row->end == "}") {
      const bool leaves = open.row->shape.starts_with("int") && line.line.piece(0) == "return";
      if (leaves) change(open.block, line, "");
      return leaves;
    }
    const auto here = written_here(line, middle_habits());
    if (!here || open.row->here.empty()) return false;
    change(open.block, line, *here);
    return true;
  }

  // The result variable of a function is declared at its first assignment.
  void first_value(Open& open, const Numbered& line) {
    const std::string& name = open.parts[0];
    if (name.empty()) return;
    const std::uint32_t at = source_.line_start(line.number) + line.line.pieces[0].begin;
    open.block.edits.push_back({{at, at, source_.id()}, "var "});
    result_ = name;
    open.parts[0].clear();
  }

  void end_by_indentation(const Numbered& line) {
    while (Open* const indented = open_.innermost_indented()) {
      Open& open = *indented;
      if (line.indent() > open.indent) return;
      // Blocks inside whose end words are missing were no blocks.
      while (&open_.innermost() != &open) open_.pop();
      const bool is_end =
          line.indent() == open.indent && line.last == 1 && lower_case(line.line.piece(0)) == "end";
      const bool goes_on =
          line.indent() == open.indent && written_here(line, middle_habits()).has_value();
      if (is_end || goes_on) return;
      end_behind(open);
      open_.pop();
    }
  }

  // Ends a block after the last line that was read.
  void end_behind(Open& open) {
    if (!open.block.here.empty()) {
      const auto end =
          static_cast<std::uint32_t>(source_.line_start(last_) + source_.line(last_).size());
      open.block.edits.push_back(
          {{end, end, source_.id()}, '\n' + std::string(open.indent, ' ') + '}'});
    }
    close(open, last_);
  }

  void close(Open& open, int last) {
    open.block.last = last;
    blocks_.push_back(std::move(open.block));
  }

  bool ends(const Numbered& line) {
    if (!open_.drop_to(line.line.piece(0), line.indent())) return false;
    Open& open = open_.innermost();
    std::string here = written_here(line, end_habits()).value_or("");
    if (here.empty()) return false;
    if (open.block.here.empty()) here.clear();
    if (open.row->gives_first && !result_.empty())
      here = "    return " + result_ + '\n' + std::string(open.indent, ' ') + '}';
    result_.clear();
    change(open.block, line, here);
    close(open, line.number);
    open_.pop();
    return true;
  }

  const Source& source_;
  OpenBlocks open_;
  std::vector<ForeignBlock> blocks_;
  std::string result_;
  int last_ = 0;
};

// Sorts edits in the order of the text; insertions at the same position are joined.
std::vector<Edit> joined(std::vector<Edit> edits) {
  std::ranges::stable_sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
  std::vector<Edit> out;
  for (Edit& edit : edits) {
    const bool same = !out.empty() && out.back().span == edit.span && edit.span.empty();
    if (same) {
      out.back().text += edit.text;
    } else {
      out.push_back(std::move(edit));
    }
  }
  return out;
}

}  // namespace

ForeignBlocks::ForeignBlocks(const Source& source)
    : source_(source), blocks_(Reader(source).run()) {}

Diagnostic ForeignBlocks::explanation(const ForeignBlock& outer) const {
  const std::uint32_t begin =
      source_.line_start(outer.first) +
      static_cast<std::uint32_t>(source_.line(outer.first).find_first_not_of(" \t"));
  const Span mark{begin, begin + static_cast<std::uint32_t>(outer.found.size()), source_.id()};
  const bool needless = outer.here.empty();
  Diagnostic out =
      needless ? make_diagnostic("E0116", mark, {shortened(outer.found)})
               : make_diagnostic("E0130", mark, {shortened(outer.found), shortened(outer.here)});
  out.why = needless ? "a .rbt file runs from its first line; there are no classes and no main"
            : outer.by_indentation
                ? "what belongs together stands in braces; indentation alone says nothing"
                : "what belongs together stands in braces";
  std::vector<Edit> edits;
  for (const ForeignBlock& block : blocks_) {
    if (block.first < outer.first || block.last > outer.last) continue;
    std::ranges::copy(block.edits, std::back_inserter(edits));
  }
  out.fix = Fix{needless ? "delete this line and the one that ends its block"
                         : "write " + outer.here + " ... }",
                joined(std::move(edits)), Confidence::kMaybe};
  return out;
}

std::vector<Explanation> ForeignBlocks::around(int line) const {
  const ForeignBlock* outer = nullptr;
  const ForeignBlock* inner = nullptr;
  for (const ForeignBlock& block : blocks_) {
    if (line < block.first || line > block.last) continue;
    if (outer == nullptr || block.first <= outer->first) outer = &block;
    if (inner == nullptr || block.first >= inner->first) inner = &block;
  }
  std::vector<Explanation> out;
  if (outer != nullptr) out.push_back({explanation(*outer)});
  if (inner != outer) out.push_back({explanation(*inner)});
  return out;
}

}  // namespace armlet::lang
