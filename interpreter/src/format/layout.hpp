#pragma once
// The rules of the layout: blanks between tokens, positions for line breaks, indentation.

#include <algorithm>
#include <atomic>

#include "format/doc.hpp"
#include "format/gaps.hpp"

namespace armlet::lang {

// The space before a token, unless comments need more.
enum class Lead : std::uint8_t {
  kDone,  // none: it was written with the comments
  kTight,
  kSpace,
  kSoft,       // nothing, or a line break
  kLine,       // a blank, or a line break
  kFill,       // a blank, or a line break for this position alone
  kBreak,      // a line break, and an empty line if the text has one
  kFirstBreak  // a line break
};

class Layout {
 public:
  // `begin` is the byte where the program begins.
  Layout(const Source& source, const Shape& shape, std::uint32_t begin,
         const std::atomic<bool>* cancelled)
      : source_(source),
        shape_(shape),
        cancelled_(cancelled),
        gaps_(read_gaps(source, shape, begin)) {}

  Doc program();

 private:
  // The lines of statements in braces.
  enum class Braces : std::uint8_t {
    kAsWritten,  // one line if it was one in the text and fits
    kOpen,       // one line for each statement
    kShared      // the lines belong to the body around
  };

  // layout.cpp: tokens and comments
  [[nodiscard]] std::string_view text_of(std::uint32_t token) const;
  [[nodiscard]] bool is(const ShapeNode& node, std::string_view text) const;
  [[nodiscard]] std::size_t closing_part(const ShapeNode& node, std::size_t open) const;
  [[nodiscard]] bool on_one_line(const ShapeNode& node) const;
  [[nodiscard]] bool on_one_line(std::uint32_t first, std::uint32_t last) const;
  [[nodiscard]] std::uint32_t last_token(const ShapeNode& node) const;
  [[nodiscard]] Doc lead_of(std::uint32_t token, Lead lead) const;
  [[nodiscard]] Doc comment_break(Lead lead, bool blank) const;
  [[nodiscard]] Doc token(std::uint32_t token, Lead lead) const;
  [[nodiscard]] Doc comments_at_end(std::uint32_t closer, bool with_blanks) const;
  [[nodiscard]] Doc token_without_comments(std::uint32_t closer, Lead lead) const;

  // layout.cpp: rules without a layout of their own
  Doc node(const ShapeNode& node, Lead lead, bool is_value = false);
  Doc sequence(const ShapeNode& node, Lead lead, bool is_value);
  [[nodiscard]] bool holds_value(const ShapeNode& node, std::size_t i) const;
  Doc column(std::uint32_t token) const;

  // spacing.cpp
  [[nodiscard]] Lead between(const ShapeNode& node, std::size_t part) const;
  [[nodiscard]] Lead between_operands(const ShapeNode& node, std::size_t part) const;

  // layout_statements.cpp
  Doc braces(const ShapeNode& node, std::size_t open, Lead lead, Braces style);
  bool move_comments_inside(std::uint32_t brace);
  Doc statements(const ShapeNode& node, std::size_t from, std::size_t to, Lead between);
  Doc header(const ShapeNode& node, std::size_t open, Lead lead);
  Doc for_header(const ShapeNode& node);
  Doc body_of(const ShapeNode& node, Braces style);
  Doc if_statement(const ShapeNode& node, Lead lead);
  [[nodiscard]] Lead behind_brace(std::uint32_t token) const;
  Doc if_parts(const ShapeNode& node, Braces style);
  Doc try_statement(const ShapeNode& node, Lead lead);
  Doc switch_case(const ShapeNode& node, Lead lead);

  // The indentation of the lines of a broken chain; twice as much in a header, so that its lines
  // differ from those of its body.
  [[nodiscard]] int chain_indent() const { return in_header_ ? 2 * kIndentWidth : kIndentWidth; }

  // layout_values.cpp
  Doc expression(const ShapeNode& node, Lead lead);
  Doc chain(const ShapeNode& node, Lead lead);
  [[nodiscard]] Doc behind_lead(const ShapeNode& node, Lead lead, Doc inner) const;
  Doc choice(const ShapeNode& node, Lead lead);
  Doc brackets(const ShapeNode& node, std::size_t open, Lead lead, bool is_value);
  // Whether the node is [:] or the [string] of a type, which are never broken.
  [[nodiscard]] bool is_one_word(const ShapeNode& node) const;
  [[nodiscard]] bool is_short(const ShapeNode& node) const;

  const Source& source_;
  const Shape& shape_;
  const std::atomic<bool>* cancelled_;
  std::vector<Gap> gaps_;
  // In parentheses after `if`, `for` ..., but not in brackets inside of those.
  bool in_header_ = false;
};

}  // namespace armlet::lang
