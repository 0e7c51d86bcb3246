#include "armlet/interpreter/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/words.hpp"
#include "driver/vocabulary.hpp"
#include "vocabulary/language_words.hpp"
#include "vocabulary/written_call.hpp"

namespace armlet {
namespace {

// All functions with one name.
struct Page {
  std::string name;
  std::vector<std::string> calls;
  std::vector<std::string_view> help;
  std::vector<std::string_view> examples;
};
struct Section {
  std::string_view title;
  std::vector<Page> pages;
};

// The heading of an entry: "motor NAME { ... }" is found under motor, an operator under its sign.
std::string heading(std::string_view name) {
  if (!name.starts_with("operator") && name.ends_with('=')) name.remove_suffix(1);
  if (name.ends_with("[]") || name.ends_with("[:]")) return std::string(lang::indexed(name));
  if (name.starts_with("operator")) return std::string(name.substr(8));
  if (name.ends_with("{}")) return std::string(name.substr(0, name.size() - 2));
  if (const std::string_view word = lang::block_of(name); !word.empty())
    return fmt::format("{} ({}:)", word, name.substr(word.size() + 1));
  return std::string(name);
}

template <class T, class U>
void add_once(std::vector<T>& items, U item) {
  if (!item.empty() && std::ranges::find(items, item) == items.end()) items.push_back(T(item));
}

void add_function(const lang::Registry& registry, Section& section,
                  const NativeFunction& function) {
  std::string call = lang::written_call(registry, function);
  if (call.empty() || function.help.empty()) return;
  const std::string name = heading(function.name);
  auto page = std::ranges::find(section.pages, name, &Page::name);
  if (page == section.pages.end()) page = section.pages.insert(page, Page{name, {}, {}, {}});
  add_once(page->calls, std::move(call));
  add_once(page->help, function.help);
  add_once(page->examples, function.example);
}

std::vector<Section> sections(const Engine& engine) {
  const lang::Registry& registry = engine.registry();
  std::vector<Section> all;
  const auto section = [&all](std::string_view title) -> Section& {
    const auto found = std::ranges::find(all, title, &Section::title);
    return found != all.end() ? *found : all.emplace_back(Section{title, {}});
  };
  for (const NativeFunction& word : lang::language_words())
    add_function(registry, section("Part of the language"), word);
  for (const lang::Chapter& chapter : registry.chapters()) {
    Section& here = section(chapter.title);
    for (const NativeFunction& function : chapter.functions) add_function(registry, here, function);
    for (const NativeConstant& constant : chapter.constants) {
      here.pages.push_back({std::string(constant.name),
                            {fmt::format("{} = {}", constant.name, constant.value)},
                            {constant.help},
                            {}});
    }
  }
  std::erase_if(all, [](const Section& s) { return s.pages.empty(); });
  return all;
}

// A long call, broken into several lines after commas.
std::string wrapped(std::string_view call) {
  constexpr std::size_t kWidth = 100;
  std::string text;
  while (call.size() > kWidth) {
    const std::size_t comma = call.rfind(", ", kWidth - 1);
    if (comma == std::string_view::npos) break;
    text += std::string(call.substr(0, comma + 1)) + "\n    ";
    call.remove_prefix(comma + 2);
  }
  return text + std::string(call) + "\n";
}

std::string plain_page(const Page& page) {
  std::string text;
  for (const std::string& call : page.calls) text += wrapped(call);
  for (const std::string_view help : page.help) text += fmt::format("  {}\n", help);
  for (const std::string_view example : page.examples)
    text += fmt::format("  Example   {}\n", example);
  return text;
}

std::string lower(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

}  // namespace

std::vector<LanguageWord> reserved_and_soft_words() {
  std::vector<LanguageWord> words;
  for (const lang::Word& word : lang::kWordRows)
    words.push_back({word.text, !lang::is_reserved(word)});
  return words;
}

std::vector<std::string> help_names(const Engine& engine) {
  std::vector<std::string> names;
  for (const Section& section : sections(engine)) {
    for (const Page& page : section.pages) add_once(names, std::string_view(page.name));
  }
  return names;
}

std::string help_page(const Engine& engine, std::string_view name) {
  std::string text;
  for (const Section& section : sections(engine)) {
    for (const Page& page : section.pages) {
      if (page.name == name) text += plain_page(page);
    }
  }
  return text;
}

std::vector<std::string> help_search(const Engine& engine, std::string_view word) {
  const std::string wanted = lower(word);
  std::vector<std::string> names;
  for (const Section& section : sections(engine)) {
    for (const Page& page : section.pages) {
      if (lower(page.name + plain_page(page)).find(wanted) != std::string::npos)
        add_once(names, std::string_view(page.name));
    }
  }
  return names;
}

std::string reference_markdown(const Engine& engine) {
  std::string text;
  for (const Section& section : sections(engine)) {
    text += fmt::format("\n## {}\n", section.title);
    for (const Page& page : section.pages) {
      text += fmt::format("\n### `{}`\n\n```text\n", page.name);
      for (const std::string& call : page.calls) text += wrapped(call);
      text += "```\n\n";
      for (const std::string_view help : page.help) text += fmt::format("{}\n", help);
      if (!page.examples.empty())
        text += page.examples.size() == 1 ? "\nExample:\n\n" : "\nExamples:\n\n";
      for (const std::string_view example : page.examples) text += fmt::format("    {}\n", example);
    }
  }
  return text;
}

}  // namespace armlet
