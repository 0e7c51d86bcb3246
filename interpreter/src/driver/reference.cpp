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

constexpr std::size_t kLongPage = 5;  // forms; a page with more is shortened
constexpr std::size_t kShownForms = 2;
constexpr std::size_t kShownSentences = 2;
constexpr std::size_t kShownExamples = 2;

Page shortened(const Page& page) {
  Page shown = page;
  shown.calls.resize(std::min(shown.calls.size(), kShownForms));
  shown.help.resize(std::min(shown.help.size(), kShownSentences));
  shown.examples.resize(std::min(shown.examples.size(), kShownExamples));
  return shown;
}

std::string first_sentence(std::string_view text) {
  for (std::size_t stop = text.find(". "); stop != text.npos; stop = text.find(". ", stop + 1)) {
    const bool is_short_form = stop > 2 && text[stop - 2] == '.';  // "e.g. "
    if (!is_short_form) return std::string(text.substr(0, stop + 1));
  }
  return std::string(text);
}

bool has_setting(const Page& page, std::string_view name) {
  const std::string written = std::string(name) + ": ";
  const auto in_call = [&](std::string_view call) {
    for (std::size_t at = call.find(written); at != call.npos; at = call.find(written, at + 1))
      if (at > 0 && (call[at - 1] == ' ' || call[at - 1] == '(')) return true;
    return false;
  };
  return std::ranges::any_of(page.calls, in_call);
}

// The parts of a text between separators, without spaces around them.
std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (part.starts_with(' ')) part.remove_prefix(1);
    while (part.ends_with(' ')) part.remove_suffix(1);
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

std::string lower(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

// The names in a topic; "with (frame:)" contains a space.
std::vector<std::string> pages_of(const HelpTopic& topic) {
  std::vector<std::string> names;
  for (const std::string_view part : parts_of(topic.pages, ' ')) {
    if (part.starts_with('(')) {
      names.back() += ' ' + std::string(part);
    } else {
      names.emplace_back(part);
    }
  }
  return names;
}

// The pages in the order of their relevance, each once.
HelpFound rank_pages(const Engine& engine, std::string_view wanted,
                     const std::vector<std::string_view>& words,
                     const std::vector<std::string>& of_topics) {
  constexpr std::size_t kGroups = 4;  // that name, topic, similar name, words in the text
  std::vector<HelpLine> groups[kGroups];
  groups[1].resize(of_topics.size());
  HelpFound found;
  for (const Section& section : sections(engine)) {
    for (const Page& page : section.pages) {
      const HelpLine line{page.name, page.help.empty() ? "" : first_sentence(page.help.front())};
      const std::string name = lower(page.name), text = lower(page.name + plain_page(page));
      const auto topic = std::ranges::find(of_topics, page.name);
      const auto in_text = [&](std::string_view word) { return text.find(word) != text.npos; };
      if (name == wanted) {
        groups[0].push_back(line);
      } else if (has_setting(page, wanted)) {
        add_once(found.settings, std::string_view(page.name));
      } else if (topic != of_topics.end()) {
        HelpLine& here = groups[1][static_cast<std::size_t>(topic - of_topics.begin())];
        if (here.name.empty()) here = line;
      } else if (wanted.size() > 2 && name.find(wanted) != name.npos) {
        groups[2].push_back(line);
      } else if (std::ranges::all_of(words, in_text)) {
        groups[3].push_back(line);
      }
      found.is_setting = found.is_setting || has_setting(page, wanted);
    }
  }
  for (std::vector<HelpLine>& group : groups) {
    for (HelpLine& line : group) {
      const bool is_shown =
          line.name.empty() ||
          std::ranges::find(found.settings, line.name) != found.settings.end() ||
          std::ranges::find(found.pages, line.name, &HelpLine::name) != found.pages.end();
      if (!is_shown) found.pages.push_back(std::move(line));
    }
  }
  return found;
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

ShortPage short_help_page(const Engine& engine, std::string_view name) {
  ShortPage out;
  for (const Section& section : sections(engine)) {
    for (const Page& page : section.pages) {
      if (page.name != name) continue;
      const bool is_long = page.calls.size() > kLongPage;
      out.text += plain_page(is_long ? shortened(page) : page);
      if (is_long) out.left_out += page.calls.size() - kShownForms;
    }
  }
  return out;
}

HelpFound help_about(const Engine& engine, std::string_view words,
                     std::span<const HelpTopic> topics) {
  const std::string wanted = lower(words);
  const std::vector<std::string_view> parts = parts_of(wanted, ' ');
  if (parts.empty()) return {};
  std::vector<std::string> of_topics;
  for (const ForeignKind kind : {ForeignKind::kName, ForeignKind::kSetting}) {
    const ForeignName* row = engine.registry().foreign(parts.size() == 1 ? words : wanted, kind);
    if (row != nullptr) add_once(of_topics, row->here);
  }
  for (const bool exact : {true, false}) {
    for (const HelpTopic& topic : topics) {
      const auto meant = [&](std::string_view word) {
        return exact ? word == wanted : wanted.size() > 2 && word.find(wanted) != word.npos;
      };
      if (!std::ranges::any_of(parts_of(topic.words, ','), meant)) continue;
      for (const std::string_view name : pages_of(topic)) add_once(of_topics, name);
    }
  }
  return rank_pages(engine, wanted, parts, of_topics);
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
