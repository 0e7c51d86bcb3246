#pragma once
// What a program's messages look like when one of its tokens is missing.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/source.hpp"

namespace armlet::test {

// The tokens of a text: names, numbers with their units, texts and marks; no comments, no blanks.
[[nodiscard]] std::vector<Span> tokens_of(std::string_view text);

// The messages of a text, each as "E0201: there is nothing called `x`", errors and advice, in the
// order in which the command shows them. Empty also for a text that is right.
[[nodiscard]] std::vector<std::string> messages_of(const std::string& text);

// Whether the command would run the text.
[[nodiscard]] bool compiles(const std::string& text);

struct Trial {
  Span deleted{};
  std::vector<std::string> messages{};  // without the advice that the whole program gets as well
};

// Deletes token number `first`, then every `step`-th, one at a time.
[[nodiscard]] std::vector<Trial> delete_tokens(const std::string& text, std::size_t first = 0,
                                               std::size_t step = 1);

// How many trials gave how many messages.
struct Distribution {
  std::map<std::size_t, std::size_t> trials{};

  void add(const std::vector<Trial>& more);
  [[nodiscard]] std::size_t all() const;
  // The part of the trials with more than `most` messages.
  [[nodiscard]] double above(std::size_t most) const;
  [[nodiscard]] std::string text() const;
};

// All programs below `folder` that compile, by path, in order.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> programs_below(
    const std::string& folder);

}  // namespace armlet::test
