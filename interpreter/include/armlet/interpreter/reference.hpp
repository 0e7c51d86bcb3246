#pragma once
// The vocabulary of an engine as a reader sees it. Everything comes from the tables that the
// checker works with.

#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"

namespace armlet {

// A word of the language. Soft words are names everywhere except where the grammar expects them.
struct LanguageWord {
  std::string_view text;
  bool soft = false;
};
// In the order of the grammar.
[[nodiscard]] std::vector<LanguageWord> reserved_and_soft_words();

// The names that have a page, in the order of the chapters.
[[nodiscard]] std::vector<std::string> help_names(const Engine& engine);
// The page of a name: how it is called, what it does, an example. Empty if there is no such name.
[[nodiscard]] std::string help_page(const Engine& engine, std::string_view name);
// The names whose page mentions a word, in the order of the chapters.
[[nodiscard]] std::vector<std::string> help_search(const Engine& engine, std::string_view word);
// All pages by chapter, as Markdown.
[[nodiscard]] std::string reference_markdown(const Engine& engine);

}  // namespace armlet
