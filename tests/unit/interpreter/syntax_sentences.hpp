#pragma once
// Random sentences of grammar/RbtParser.g4, and texts made ugly without changing what they say.

#include <memory>
#include <string>

#include "syntax/tokens/token.hpp"

namespace armlet::lang {

class SentenceWriter {
 public:
  explicit SentenceWriter(unsigned seed);
  ~SentenceWriter();
  SentenceWriter(const SentenceWriter&) = delete;
  SentenceWriter& operator=(const SentenceWriter&) = delete;

  // A program of a few statements, as kinds of tokens.
  [[nodiscard]] Tokens program();
  // Words and signs of those kinds.
  [[nodiscard]] std::string text(const Tokens& tokens);
  // The count of the rules of the grammar.
  [[nodiscard]] std::size_t rules() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// The same tokens with other blanks, line breaks where they mean nothing, and comments between
// them instead of its own. The text must consist of tokens.
[[nodiscard]] std::string roughened(const std::string& text, unsigned seed);

}  // namespace armlet::lang
