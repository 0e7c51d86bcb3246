// Questions at the prompt: pages of the library and names of the session.

#include "prompt/questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/stdlib/install.hpp"
#include "commands.hpp"
#include "console/console.hpp"
#include "prompt/prompt.hpp"

namespace armlet::cli {

void say(std::string_view text) {
  print_out(text);
  if (!text.ends_with('\n')) print_out("\n");
  static_cast<void>(finish_output());
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

namespace {

bool is_name(std::string_view text) {
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text.front())) != 0) return false;
  return std::ranges::all_of(
      text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; });
}

// The lines with `///` above a declaration.
std::string doc_above(std::string_view text, std::size_t at) {
  std::string doc;
  std::size_t line = text.rfind('\n', at) + 1;
  while (line > 0) {
    const std::size_t above = line < 2 ? 0 : text.rfind('\n', line - 2) + 1;
    const std::string_view words = trimmed(text.substr(above, line - 1 - above));
    if (!words.starts_with("///")) break;
    doc.insert(0, fmt::format("  {}\n", trimmed(words.substr(3))));
    line = above;
  }
  return doc;
}

// The words of a question without a last word `all`, and whether it was there.
HelpQuestion question_about(std::string_view words) {
  HelpQuestion question{.at_prompt = true};
  if (words.ends_with(" all")) {
    question.whole = true;
    words = trimmed(words.substr(0, words.size() - 4));
  }
  question.name = std::string(words);
  return question;
}

}  // namespace

bool show_page(Prompt& prompt, std::string_view name) {
  const auto analysis = prompt.session().analyse(std::string(name), "line");
  const auto place = analysis->definition(0);
  const auto what = place ? analysis->hover(0) : std::nullopt;
  if (!what) return help(question_about(name)) == kDone;
  say(what->text);
  const std::string doc = doc_above(analysis->sources()[place->source].text(), place->begin);
  if (!doc.empty()) say(doc);
  return true;
}

bool search_pages(std::string_view words) {
  HelpQuestion question = question_about(words);
  question.is_search = true;
  if (question.name.empty()) {
    progress("write ?? with words, such as ??inverse kinematics");
    return false;
  }
  return help(question) == kDone;
}

std::optional<std::string_view> page_question(std::string_view line) {
  constexpr std::string_view kWords[] = {"help", "man", "doc"};
  line = trimmed(line);
  const std::size_t end = std::min(line.find_first_of(" (;"), line.size());
  std::string_view rest = trimmed(line.substr(end));
  if (rest.ends_with(';')) rest = trimmed(rest.substr(0, rest.size() - 1));
  if (std::ranges::find(kWords, line.substr(0, end)) != std::end(kWords)) {
    if (rest.starts_with('(') && rest.ends_with(')'))
      rest = trimmed(rest.substr(1, rest.size() - 2));
    if (rest.size() > 1 && rest.front() == '"' && rest.back() == '"')
      rest = rest.substr(1, rest.size() - 2);
    if (rest.empty() || is_name(rest)) return rest;
  }
  if (!is_name(line)) return std::nullopt;
  const std::string page = short_help_page(library_engine(), line).text;
  if (!page.starts_with(std::string(line) + '(')) return std::nullopt;
  return line;
}

bool is_declared(Prompt& prompt, std::string_view line) {
  return prompt.session().analyse(std::string(line), "line")->definition(0).has_value();
}

bool show_asked_page(Prompt& prompt, std::string_view line, std::string_view name) {
  if (name == line) say(fmt::format("{0} is a function; it is called as {0}(...):", name));
  return show_page(prompt, name);
}

}  // namespace armlet::cli
