#include "syntax/mistakes/brackets.hpp"

#include <algorithm>

#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

// Whether a token is the first of its line, where indentation is measured.
bool starts_line(const Tokens& tokens, std::size_t i) {
  return i == 0 || tokens[i].line_break_before;
}

class BracketCheck {
 public:
  BracketCheck(const Source& source, const Tokens& tokens) : source_(source), tokens_(tokens) {}

  std::optional<Diagnostic> run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (is_opener(tokens_[i].type)) open_.push_back(i);
      if (!is_closer(tokens_[i].type)) continue;
      if (open_.empty()) return surplus(i);
      if (closer_of(tokens_[open_.back()].type) != tokens_[i].type) return mismatch(i);
      open_.pop_back();
    }
    if (open_.empty()) return std::nullopt;
    return unclosed(open_.back(), tokens_.size() - 1);
  }

 private:
  Span span(std::size_t i) const { return {tokens_[i].begin, tokens_[i].end, source_.id()}; }
  Span after(std::size_t i) const { return {tokens_[i].end, tokens_[i].end, source_.id()}; }
  std::string text(std::size_t i) const { return std::string(source_.slice(span(i))); }
  int line(std::size_t i) const { return source_.position(tokens_[i].begin).line; }

  // The count of blanks before the first character of the line with token `i`.
  std::size_t indent(std::size_t i) const {
    const std::string_view content = source_.line(line(i));
    return std::min(content.find_first_not_of(" \t"), content.size());
  }

  std::string closing_text(std::size_t opener) const {
    return tokens_[opener].type == RbtLexer::LPAREN   ? ")"
           : tokens_[opener].type == RbtLexer::LBRACK ? "]"
                                                      : "}";
  }

  // The message for a closing bracket `i` that does not match the innermost open bracket.
  Diagnostic mismatch(std::size_t i) {
    const std::size_t inner = open_.back();
    const bool closes_outer = std::ranges::any_of(
        open_, [&](std::size_t o) { return closer_of(tokens_[o].type) == tokens_[i].type; });
    if (closes_outer) return unclosed(inner, i);
    if (tokens_[inner].type == RbtLexer::LBRACE || line(inner) != line(i)) return surplus(i);
    Diagnostic out = make_diagnostic("E0131", span(i), {text(i)});
    out.related.push_back({span(inner), "opened here"});
    out.fix = Fix{"write `" + closing_text(inner) + '`',
                  {{span(i), closing_text(inner)}},
                  Confidence::kMaybe};
    return out;
  }

  Diagnostic unclosed(std::size_t opener, std::size_t limit) {
    if (tokens_[opener].type != RbtLexer::LBRACE) return unclosed_bracket(opener, limit);
    // A bracket that an earlier block left open may have been closed by a brace of another block:
    // the indentation decides.
    if (const std::optional<std::size_t> block = first_outgrown_block())
      return unclosed_block(*block);
    return unclosed_block(opener);
  }

  Diagnostic unclosed_bracket(std::size_t opener, std::size_t limit) {
    Diagnostic out = make_diagnostic("E0110", span(opener), {text(opener)});
    out.mark.label = "opened here";
    const std::size_t end = end_of_bracket(opener, limit);
    const std::string mark = '`' + closing_text(opener) + '`';
    if (const std::optional<Span> slashes = swallowed_by_comment(opener, end)) {
      out.why = "// begins a comment, which goes to the end of the line";
      out.fix = Fix{"to divide, write /", {{*slashes, "/"}}, Confidence::kMaybe};
      return out;
    }
    if (tokens_[end].type == RbtLexer::SEMI) {
      out.fix = Fix{"add " + mark + " before the `;`", {}, Confidence::kMaybe};
    } else if (tokens_[end].type != kEndOfText && line(end) == line(end - 1)) {
      out.fix = Fix{"add " + mark + " before the `" + text(end) + '`', {}, Confidence::kMaybe};
    } else {
      if (tokens_[end].type != kEndOfText && !is_closer(tokens_[end].type)) {
        out.related.push_back({span(end), "the next statement starts here"});
      }
      out.fix = Fix{"add " + mark + " at the end of line " + std::to_string(line(end - 1)),
                    {},
                    Confidence::kMaybe};
    }
    out.fix->edits.push_back({after(end - 1), closing_text(opener)});
    return out;
  }

  // The `//` after the last token of the bracket, if the comment contains the closing bracket:
  // print(3 // 2)
  std::optional<Span> swallowed_by_comment(std::size_t opener, std::size_t end) const {
    const std::uint32_t from = tokens_[end - 1].end;
    const std::string_view text = source_.text();
    const std::size_t slashes = text.find_first_not_of(" \t", from);
    if (slashes == std::string_view::npos || !text.substr(slashes).starts_with("//"))
      return std::nullopt;
    const std::string_view comment = text.substr(slashes, text.find('\n', slashes) - slashes);
    if (comment.find(closing_text(opener)) == std::string_view::npos) return std::nullopt;
    const auto begin = static_cast<std::uint32_t>(slashes);
    return Span{begin, begin + 2, source_.id()};
  }

  // The token before which the bracket `opener` must have ended: a `;`, a closing bracket of an
  // outer one, a line that is indented no deeper than that of the bracket, or the end of the text.
  std::size_t end_of_bracket(std::size_t opener, std::size_t limit) const {
    std::size_t depth = 0;
    const bool in_for = opener > 0 && tokens_[opener - 1].type == RbtLexer::FOR;
    for (std::size_t i = opener + 1; i < limit; ++i) {
      if (is_opener(tokens_[i].type)) ++depth;
      const bool outside = depth == 0;
      if (is_closer(tokens_[i].type) && depth > 0) --depth;
      if (!outside) continue;
      if (tokens_[i].type == RbtLexer::SEMI && !in_for && tokens_[opener].type == RbtLexer::LPAREN)
        return i;
      // Rows of a matrix may end with `;`; the lines below are then indented.
      if (tokens_[i].type == RbtLexer::SEMI && tokens_[opener].type == RbtLexer::LBRACK &&
          starts_line(tokens_, i + 1) && indent(i + 1) <= indent(opener) &&
          !is_closer(tokens_[i + 1].type))
        return i;
      if (starts_line(tokens_, i) && indent(i) <= indent(opener) &&
          can_end_statement(tokens_[i - 1].type) && !is_closer(tokens_[i].type)) {
        return i;
      }
    }
    return limit;
  }

  // The first block that is followed by a line which is indented no deeper than the block's first
  // line, although no brace has closed it.
  std::optional<std::size_t> first_outgrown_block() {
    std::vector<std::size_t> blocks;
    for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
      if (tokens_[i].type == RbtLexer::RBRACE && !blocks.empty()) {
        if (starts_line(tokens_, i) && indent(i) < indent(blocks.back()))
          return outgrown(blocks.back(), i);
        blocks.pop_back();
      } else if (starts_line(tokens_, i) && !blocks.empty() &&
                 tokens_[i].type != RbtLexer::LBRACE && indent(i) <= indent(blocks.back()) &&
                 line(i) != line(blocks.back())) {
        return outgrown(blocks.back(), i);
      }
      if (tokens_[i].type == RbtLexer::LBRACE) blocks.push_back(i);
    }
    return std::nullopt;
  }

  std::size_t outgrown(std::size_t block, std::size_t next) {
    next_after_block_ = next;
    return block;
  }

  Diagnostic unclosed_block(std::size_t opener) {
    Diagnostic out = make_diagnostic("E0111", span(opener));
    out.mark.label = "opened here";
    if (next_after_block_ == 0) {
      out.fix = Fix{"add `}` at the end of the program",
                    {{span(tokens_.size() - 1), "}\n"}},
                    Confidence::kMaybe};
      return out;
    }
    const int next_line = line(next_after_block_);
    out.related.push_back(
        {span(next_after_block_), "the indentation suggests that the block ends before this line"});
    const std::uint32_t place = source_.line_start(next_line);
    out.fix = Fix{"add `}` before line " + std::to_string(next_line),
                  {{{place, place, source_.id()}, std::string(indent(opener), ' ') + "}\n"}},
                  Confidence::kMaybe};
    return out;
  }

  // A closing bracket without an opening one. If an earlier `}` is on a line with another
  // indentation than its block, that brace is reported.
  Diagnostic surplus(std::size_t i) {
    std::size_t at = i;
    if (tokens_[i].type == RbtLexer::RBRACE) {
      std::vector<std::size_t> blocks;
      for (std::size_t k = 0; k < i && at == i; ++k) {
        if (tokens_[k].type == RbtLexer::LBRACE) blocks.push_back(k);
        if (tokens_[k].type != RbtLexer::RBRACE || blocks.empty()) continue;
        if (starts_line(tokens_, k) && indent(k) > indent(blocks.back())) at = k;
        blocks.pop_back();
      }
    }
    Diagnostic out = make_diagnostic("E0131", span(at), {text(at)});
    out.fix = Fix{"delete it", {{span(at), ""}}, Confidence::kMaybe};
    return out;
  }

  const Source& source_;
  const Tokens& tokens_;
  std::vector<std::size_t> open_;
  std::size_t next_after_block_ = 0;
};

}  // namespace

std::optional<Diagnostic> check_brackets(const Source& source, const Tokens& tokens) {
  return BracketCheck(source, tokens).run();
}

}  // namespace armlet::lang
