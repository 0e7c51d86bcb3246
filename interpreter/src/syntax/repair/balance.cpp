#include "syntax/repair/balance.hpp"

#include <algorithm>
#include <utility>

#include "syntax/mistakes/brackets.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

class Balance {
 public:
  Balance(const Source& source, const Tokens& tokens) : source_(source), tokens_(tokens) {}

  Tokens run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Token& token = tokens_[i];
      if (i == 0 || token.line_break_before) begin_line(i);
      place_ = token.begin;
      if (is_closer(token.type)) {
        if (std::ranges::find(open_, token.type, &Open::closer) == open_.end()) continue;
        while (open_.back().closer != token.type) close();
        open_.pop_back();
      }
      if (is_opener(token.type)) open_.push_back({closer_of(token.type), indent_});
      if (token.type == kEndOfText) close_all();
      out_.push_back(token);
    }
    return std::move(out_);
  }

 private:
  struct Open {
    std::uint16_t closer;
    std::size_t indent;  // of the line with the bracket
  };

  void begin_line(std::size_t i) {
    const Token& token = tokens_[i];
    if (token.type == kEndOfText) return;
    const std::string_view line = source_.line(source_.position(token.begin).line);
    indent_ = std::min(line.find_first_not_of(" \t"), line.size());
    const bool goes_on = is_closer(token.type) || is_opener(token.type) ||
                         token.type == RbtLexer::CASE || token.type == RbtLexer::DEFAULT;
    if (goes_on) return;
    place_ = source_.line_start(source_.position(token.begin).line);
    while (!open_.empty() && indent_ <= open_.back().indent) close();
  }

  void close_all() {
    while (!open_.empty()) close();
  }

  void close() {
    out_.push_back({.begin = place_, .end = place_, .type = open_.back().closer, .inserted = true});
    open_.pop_back();
  }

  const Source& source_;
  const Tokens& tokens_;
  Tokens out_{};
  std::vector<Open> open_{};
  std::size_t indent_ = 0;
  std::uint32_t place_ = 0;  // the position for an inserted bracket
};

}  // namespace

Tokens balanced(const Source& source, const Tokens& tokens) {
  return check_brackets(source, tokens) ? Balance(source, tokens).run() : tokens;
}

}  // namespace armlet::lang
