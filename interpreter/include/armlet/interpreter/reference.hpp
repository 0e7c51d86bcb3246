#pragma once
// The vocabulary of an engine as documentation, made from the tables of the checker.

#include <span>
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
// A subject with the names of the pages about it, for help_about.
//
// words  in small letters, separated by commas: how textbooks and other toolboxes name it.
// pages  separated by spaces, the most important one first.
struct HelpTopic {
  std::string_view words;
  std::string_view pages;
};

// A page in one line: its name and the first sentence of its description.
struct HelpLine {
  std::string name;
  std::string sentence;
};

// What is known about a word or several.
//
// pages        the most relevant ones first: with that name, of that topic, with a similar name, with
//              these words in their text; without those of `settings`.
// is_setting   whether functions have a parameter of that name; `settings` are their names.
struct HelpFound {
  std::vector<HelpLine> pages;
  bool is_setting = false;
  std::vector<std::string> settings;
};
[[nodiscard]] HelpFound help_about(const Engine& engine, std::string_view words,
                                   std::span<const HelpTopic> topics = {});

// The start of a long page: its first forms, sentences and examples.
//
// left_out  the number of forms that are not shown; 0: the page is whole.
struct ShortPage {
  std::string text;
  std::size_t left_out = 0;
};
[[nodiscard]] ShortPage short_help_page(const Engine& engine, std::string_view name);

// All pages by chapter, as Markdown.
[[nodiscard]] std::string reference_markdown(const Engine& engine);

}  // namespace armlet
