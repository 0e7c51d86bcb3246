#pragma once
// The layout of programs: which tokens stand together, where lines may be broken, what is indented.

#include <algorithm>
#include <atomic>

#include "format/doc.hpp"
#include "format/gaps.hpp"

namespace armlet::lang {

// What stands in front of a token unless comments ask for more.
enum class Lead : std::uint8_t {
  kDone,  // nothing: it has been put out already, with the comments
  kTight,
  kSpace,
  kSoft,       // nothing, or a line break
  kLine,       // a blank, or a line break
  kFill,       // the same, chosen for this place alone
  kBreak,      // a line break, with the empty line above that the author left
  kFirstBreak  // a line break
};

class Layout {
 public:
  // `begin` is the offset where the program begins.
  Layout(const Source& source, const Shape& shape, std::uint32_t begin,
         const std::atomic<bool>* cancelled)
      : source_(source),
        shape_(shape),
        cancelled_(cancelled),
        gaps_(read_gaps(source, shape, begin)) {}

  Doc program();

 private:
  // Where the lines of braces with statements come from.
  enum class Braces : std::uint8_t {
    kAsWritten,  // one line if the author wrote one, and if it fits
    kOpen,       // a line for each statement
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

  // Columns more for the lines of a broken chain; twice in a header, so that its lines and its
  // body differ.
  [[nodiscard]] int chain_indent() const { return in_header_ ? 2 * kIndentWidth : kIndentWidth; }

  // layout_values.cpp
  Doc expression(const ShapeNode& node, Lead lead);
  Doc chain(const ShapeNode& node, Lead lead);
  [[nodiscard]] Doc behind_lead(const ShapeNode& node, Lead lead, Doc inner) const;
  Doc choice(const ShapeNode& node, Lead lead);
  Doc brackets(const ShapeNode& node, std::size_t open, Lead lead, bool is_value);
  // [:] and the [string] of a type, which are never broken.
  [[nodiscard]] bool is_one_word(const ShapeNode& node) const;
  [[nodiscard]] bool is_short(const ShapeNode& node) const;

  const Source& source_;
  const Shape& shape_;
  const std::atomic<bool>* cancelled_;
  std::vector<Gap> gaps_;
  bool in_header_ = false;  // in parentheses behind `if`, `for` ..., but not in brackets in those
};

}  // namespace armlet::lang
