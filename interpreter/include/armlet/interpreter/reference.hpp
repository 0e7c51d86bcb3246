#pragma once
// The vocabulary of an engine as documentation, made from the tables of the checker.

#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"

namespace armlet {

// A keyword of the language. Soft keywords can be names wherever the grammar does not expect the
// keyword.
struct LanguageWord {
  std::string_view text;
  bool soft = false;
};
// The keywords in the order of the grammar.
[[nodiscard]] std::vector<LanguageWord> reserved_and_soft_words();

// The names that have a page, in the order of the chapters.
[[nodiscard]] std::vector<std::string> help_names(const Engine& engine);
// The page of a name: its calls, a description, an example. Empty if there is no such name.
[[nodiscard]] std::string help_page(const Engine& engine, std::string_view name);
// The names whose page contains a word, in the order of the chapters.
[[nodiscard]] std::vector<std::string> help_search(const Engine& engine, std::string_view word);
// All pages by chapter, as Markdown.
[[nodiscard]] std::string reference_markdown(const Engine& engine);

}  // namespace armlet
