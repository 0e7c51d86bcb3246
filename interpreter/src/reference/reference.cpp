#include "armlet/interpreter/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "reference/language_words.hpp"
#include "reference/written_call.hpp"
#include "registry.hpp"
#include "syntax/tokens/words.hpp"

namespace armlet {
namespace {

// The word of a block whose setting this is: "with" of "with.speed"; empty for other names.
std::string_view block_of(std::string_view name) {
  for (const std::string_view word : {"with", "path"}) {
    if (name.starts_with(word) && name.substr(word.size()).starts_with('.')) return word;
  }
  return {};
}

// Everything called by one name.
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

// "(a: point, b: point)" -> {"a: point", "b: point"}
std::vector<std::string_view> parameters_in(std::string_view signature) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t start = 1;
  const auto add = [&](std::size_t end) {
    const std::string_view part = signature.substr(start, end - start);
    if (!part.empty()) parts.push_back(part);
  };
  for (std::size_t i = 0; i < signature.size(); ++i) {
    const char c = signature[i];
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ',' && depth == 1) {
      add(i);
      start = i + 2;
    }
    if ((c == ')' || c == ']' || c == '}') && --depth == 0) {
      add(i);
      break;
    }
  }
  return parts;
}

std::vector<std::string_view> parameter_types(std::string_view signature) {
  std::vector<std::string_view> types = parameters_in(signature);
  for (std::string_view& part : types) {
    if (const std::size_t colon = part.find(": "); colon != std::string_view::npos)
      part.remove_prefix(colon + 2);
  }
  return types;
}

std::vector<std::string_view> parameter_names(std::string_view signature) {
  std::vector<std::string_view> names = parameters_in(signature);
  for (std::string_view& part : names) part = part.substr(0, part.find(": "));
  return names;
}

// The type that "image[]", "image.grey[]" and "image[:]" are about.
std::string_view indexed(std::string_view name) { return name.substr(0, name.find_first_of(".[")); }

std::string_view result_of(std::string_view signature) {
  const std::size_t arrow = signature.rfind(") -> ");
  return arrow == std::string_view::npos ? std::string_view{} : signature.substr(arrow + 1);
}

std::string_view parameters_of(std::string_view signature) {
  const std::size_t arrow = signature.rfind(") -> ");
  return signature.substr(1, (arrow == std::string_view::npos ? signature.size() - 1 : arrow) - 1);
}

std::string operator_call(std::string_view sign, std::string_view signature) {
  const auto types = parameter_types(signature);
  if (types.size() == 1) return fmt::format("{}{}{}", sign, types[0], result_of(signature));
  if (types.size() != 2) return fmt::format("{}{}", sign, signature);
  return fmt::format("{} {} {}{}", types[0], sign, types[1], result_of(signature));
}

// The heading of an entry: "motor NAME { ... }" is found under motor, operators under their sign.
std::string heading(std::string_view name) {
  if (!name.starts_with("operator") && name.ends_with('=')) name.remove_suffix(1);
  if (name.ends_with("[]") || name.ends_with("[:]")) return std::string(indexed(name));
  if (name.starts_with("operator")) return std::string(name.substr(8));
  if (name.ends_with("{}")) return std::string(name.substr(0, name.size() - 2));
  if (const std::string_view word = block_of(name); !word.empty())
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

// A long call on several lines, broken after commas.
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

namespace lang {

std::string written_call(const Registry& registry, const NativeFunction& function) {
  const std::string_view name = function.name;
  const std::string_view signature = function.signature;
  if (name.ends_with("()")) return {};
  if (name.starts_with("operator")) return operator_call(name.substr(8), signature);
  if (name.ends_with('=')) {  // p.x = length, q[i] = angle
    std::string place(name.substr(0, name.size() - 1));
    if (place.ends_with("[]")) {
      const auto indexes = parameter_names(signature);
      place = fmt::format("{}[{}]", indexed(place),
                          fmt::join(std::span(indexes).subspan(1, indexes.size() - 2), ", "));
    }
    return fmt::format("{} = {}", place, parameter_types(signature).back());
  }
  if (name.ends_with("[]")) {
    const auto indexes = parameter_names(signature);
    return fmt::format("{}[{}]{}", indexed(name), fmt::join(std::span(indexes).subspan(1), ", "),
                       result_of(signature));
  }
  if (name.ends_with("[:]")) {
    const auto ends = parameter_names(signature);
    std::string ranges;
    for (std::size_t i = 1; i + 1 < ends.size(); i += 2)
      ranges += fmt::format("{}{}:{}", i == 1 ? "" : ", ", ends[i], ends[i + 1]);
    return fmt::format("{}[{}]{}", indexed(name), ranges, result_of(signature));
  }
  if (name.ends_with("{}"))
    return fmt::format("{} NAME {{ {} }}", name.substr(0, name.size() - 2),
                       parameters_of(signature));
  if (const std::string_view word = block_of(name); !word.empty())
    return fmt::format("{} {} {{ ... }}", word, signature);
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos || registry.type(name.substr(0, dot)) == nullptr)
    return fmt::format("{}{}", name, signature);
  const std::string_view rest = name.substr(dot + 1);
  if (const std::size_t row = rest.find('.'); row != std::string_view::npos) {
    std::string_view written = parameters_of(signature);
    // The word behind the row is its name.
    if (name.ends_with(kNamedRow) && written.ends_with("name: string"))
      written = written.substr(0, written.rfind(written == "name: string" ? "name" : ", name"));
    return fmt::format("{} {}({})", rest.substr(0, row), rest.substr(row + 1), written);
  }
  const std::string_view parameters = parameters_of(signature);
  const std::size_t second = parameters.find(", ");
  if (second == std::string_view::npos) return fmt::format("{}{}", name, result_of(signature));
  return fmt::format("{}({}){}", name, parameters.substr(second + 2), result_of(signature));
}

}  // namespace lang

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
