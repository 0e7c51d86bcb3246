#include "syntax/tokens/line_ends.hpp"

#include <algorithm>

#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

enum class Bracket : std::uint8_t { kNone, kRound, kSquare, kListBrace, kBlockBrace };

// The state inside one pair of brackets, or outside of all.
struct Level {
  Bracket bracket = Bracket::kNone;
  bool is_header = false;       // the parentheses of if (...), while (...) and similar words
  bool is_do_block = false;     // the braces of do { ... }
  bool has_assignment = false;  // the current statement has `=` or `=>` outside of brackets
  std::size_t statement = 0;    // the index of the current statement's first token
};

// Whether a line that begins with the token continues the statement of the line above.
bool continues_statement(std::uint16_t type) {
  return word_of(type).goes_on || mark_of(type).goes_on;
}

class Filter {
 public:
  explicit Filter(const Tokens& in) : in_(in) { out_.reserve(in.size() + in.size() / 4); }

  Tokens run() {
    for (std::size_t i = 0; i < in_.size(); ++i) {
      if (i > 0 && ends_between(i - 1, i)) {
        insert_end(in_[i - 1]);
        start_statement(i);
      }
      out_.push_back(in_[i]);
      follow(i);
    }
    return std::move(out_);
  }

  // Whether a statement ends before the token, outside of all brackets.
  bool ends_before(std::size_t index) {
    for (std::size_t i = 0; i < index; ++i) {
      if (i > 0 && ends_between(i - 1, i)) start_statement(i);
      follow(i);
    }
    const Token& last = in_[index - 1];
    if (last.type == RbtLexer::SEMI) return true;
    const bool is_end = index + 1 == in_.size();
    if (is_end && (after_do_block_ || awaits_brace(last))) return false;
    return ends_between(index - 1, index);
  }

 private:
  // fn f(x: int) -> int, struct Part, double mean(double[] a): the brace with the body may be on
  // the next line.
  bool awaits_brace(const Token& last) {
    const std::size_t first = top().statement;
    if (top().has_assignment || last.type == RbtLexer::RBRACE || first + 1 >= in_.size())
      return false;
    return word_of(in_[first].type).takes_brace ||
           (last.type == RbtLexer::RPAREN && starts_with_type_and_name(first));
  }

  Level& top() { return levels_.back(); }

  void insert_end(const Token& after) {
    out_.push_back(
        {.begin = after.end, .end = after.end, .type = RbtLexer::SEMI, .inserted = true});
  }

  void start_statement(std::size_t index) {
    top().statement = index;
    top().has_assignment = false;
  }

  bool ends_between(std::size_t a, std::size_t b) {
    const Token& A = in_[a];
    const Token& B = in_[b];
    const Bracket inside = top().bracket;
    if (inside != Bracket::kNone && inside != Bracket::kBlockBrace) return false;
    if (!can_end_statement(A.type) || after_header_ ||
        (after_do_block_ && B.type == RbtLexer::WHILE)) {
      return false;
    }
    if (B.type == RbtLexer::RBRACE || B.type == kEndOfText) return true;
    if (B.type == RbtLexer::ELSE) return A.type != RbtLexer::RBRACE;
    if (!B.line_break_before || continues_statement(B.type)) return false;
    return B.type != RbtLexer::LBRACE || !brace_belongs(a);
  }

  // Whether a `{` on the line after token `a` belongs to the statement with `a`.
  bool brace_belongs(std::size_t a) {
    // new int[]
    const bool is_pair =
        a > 1 && in_[a].type == RbtLexer::RBRACK && in_[a - 1].type == RbtLexer::LBRACK;
    if (is_pair && (is_name(in_[a - 2].type) || is_primitive_type(in_[a - 2].type) ||
                    in_[a - 2].type == RbtLexer::RBRACK))
      return true;
    if (top().has_assignment) return false;
    const std::size_t first = top().statement;
    return word_of(in_[first].type).takes_brace || starts_with_type_and_name(first);
  }

  bool starts_with_type_and_name(std::size_t i) const {
    if (in_[i].type == RbtLexer::FINAL) ++i;
    if (is_primitive_type(in_[i].type)) {
      ++i;
    } else {
      if (!is_name(in_[i].type)) return false;
      ++i;
      while (in_[i].type == RbtLexer::DOT && is_name(in_[i + 1].type)) i += 2;
    }
    while (in_[i].type == RbtLexer::LBRACK) {
      const std::size_t close = close_of_pair(i);
      if (close == i) break;
      i = close + 1;
    }
    return is_name(in_[i].type);
  }

  // The `]` of [] or [string] at `open`; `open` if it is neither.
  std::size_t close_of_pair(std::size_t open) const {
    std::size_t i = open + 1;
    if (is_primitive_type(in_[i].type) || is_name(in_[i].type)) ++i;
    while (i > open + 1 && in_[i].type == RbtLexer::DOT && is_name(in_[i + 1].type)) i += 2;
    return in_[i].type == RbtLexer::RBRACK ? i : open;
  }

  // Whether a `{` begins a list: after `=`, after `new T[]`, or inside a list after `,`, `:` or
  // `{`.
  bool is_list_brace(std::size_t i) {
    if (i == 0) return false;
    const std::uint16_t before = in_[i - 1].type;
    if (before == RbtLexer::ASSIGN) return true;
    if (before == RbtLexer::COMMA || before == RbtLexer::LBRACE || before == RbtLexer::COLON) {
      return top().bracket == Bracket::kListBrace;
    }
    return before == RbtLexer::RBRACK && closes_new_array(i - 1);
  }

  bool closes_new_array(std::size_t i) const {
    while (i >= 2 && in_[i].type == RbtLexer::RBRACK && in_[i - 1].type == RbtLexer::LBRACK) i -= 2;
    if (in_[i].type == RbtLexer::RBRACK) return false;
    if (i >= 1 && is_primitive_type(in_[i].type)) return in_[i - 1].type == RbtLexer::NEW;
    while (i >= 2 && is_name(in_[i].type) && in_[i - 1].type == RbtLexer::DOT) i -= 2;
    return i >= 1 && is_name(in_[i].type) && in_[i - 1].type == RbtLexer::NEW;
  }

  // Updates the state with token `i`, which was just written.
  void follow(std::size_t i) {
    const std::uint16_t type = in_[i].type;
    const bool was_after_do_block = after_do_block_;
    after_header_ = false;
    after_do_block_ = false;
    if (is_opener(type)) {
      open(i);
    } else if (is_closer(type)) {
      close(i);
    } else if (type == RbtLexer::SEMI || type == RbtLexer::ELSE) {
      start_statement(i + 1);
    } else if (type == RbtLexer::COLON && is_case(in_[top().statement].type)) {
      start_statement(i + 1);
    } else if (type == RbtLexer::ASSIGN || type == RbtLexer::FATARROW) {
      top().has_assignment = true;
    }
    // The parentheses after the `while` of a do loop are not a header.
    do_while_ = was_after_do_block && type == RbtLexer::WHILE;
  }

  static bool is_case(std::uint16_t type) {
    return type == RbtLexer::CASE || type == RbtLexer::DEFAULT;
  }

  void open(std::size_t i) {
    const std::uint16_t before = i == 0 ? kEndOfText : in_[i - 1].type;
    Level level{.statement = i + 1};
    if (in_[i].type == RbtLexer::LPAREN) {
      level.bracket = Bracket::kRound;
      level.is_header = is_header_word(before) && !do_while_;
    } else if (in_[i].type == RbtLexer::LBRACK) {
      level.bracket = Bracket::kSquare;
    } else if (is_list_brace(i)) {
      level.bracket = Bracket::kListBrace;
    } else {
      level.bracket = Bracket::kBlockBrace;
      level.is_do_block = before == RbtLexer::DO;
    }
    levels_.push_back(level);
  }

  void close(std::size_t i) {
    if (levels_.size() == 1) return;  // the bracket check has reported it
    const Level closed = top();
    levels_.pop_back();
    after_header_ = closed.is_header;
    after_do_block_ = closed.is_do_block;
    if (closed.is_header || closed.bracket == Bracket::kBlockBrace) start_statement(i + 1);
  }

  const Tokens& in_;
  Tokens out_;
  std::vector<Level> levels_{Level{}};
  bool after_header_ = false;
  bool after_do_block_ = false;
  bool do_while_ = false;
};

}  // namespace

Tokens insert_line_ends(const Tokens& tokens) { return Filter(tokens).run(); }

bool could_end_here(const Tokens& tokens) {
  std::ptrdiff_t depth = 0;
  for (const Token& token : tokens) {
    depth += is_opener(token.type) ? 1 : is_closer(token.type) ? -1 : 0;
  }
  if (depth != 0 || tokens.size() < 2) return depth <= 0;
  return Filter(tokens).ends_before(tokens.size() - 1);
}

bool ends_before(const Tokens& tokens, std::uint32_t byte) {
  const auto behind = std::ranges::lower_bound(tokens, byte, {}, &Token::begin);
  const auto index = static_cast<std::size_t>(behind - tokens.begin());
  return index == 0 || index >= tokens.size() || Filter(tokens).ends_before(index);
}

}  // namespace armlet::lang
