#include "deletions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>

#include "armlet/stdlib/session.hpp"
#include "library.hpp"

namespace fs = std::filesystem;

namespace armlet::test {
namespace {

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80U;
}
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The end of the text that starts with the quote at `at`.
std::size_t end_of_text(std::string_view text, std::size_t at) {
  const char quote = text[at++];
  while (at < text.size() && text[at] != quote && text[at] != '\n')
    at += text[at] == '\\' ? std::size_t{2} : std::size_t{1};
  return std::min(at + 1, text.size());
}

// 0.5, 1e-3, 100mm/s, 9.81m/s^2: a unit goes on behind / and * with letters, behind ^ with digits.
std::size_t end_of_number(std::string_view text, std::size_t at) {
  const auto is = [&](std::size_t i, auto&& test) { return i < text.size() && test(text[i]); };
  while (is(at, is_digit) || (is(at, [](char c) { return c == '.'; }) && is(at + 1, is_digit)))
    ++at;
  const bool has_exponent = is(at, [](char c) { return c == 'e' || c == 'E'; }) &&
                            !is(at + 1, [](char c) { return is_word(c) && !is_digit(c); });
  if (has_exponent) at += 2;
  bool unit = is(at, is_word) && !is(at, is_digit);
  while (is(at, is_word)) ++at;
  while (unit && at < text.size()) {
    const char mark = text[at];
    const bool more = (mark == '/' || mark == '*') && is(at + 1, is_word) && !is(at + 1, is_digit);
    const bool power = mark == '^' && is(at + 1, is_digit);
    if (!more && !power) break;
    ++at;
    while (is(at, is_word)) ++at;
  }
  return at;
}

std::size_t end_of_mark(std::string_view text, std::size_t at) {
  constexpr auto kLong = std::to_array<std::string_view>({"==", "!=", "<=", ">=", "&&", "||",
                                                          "+=", "-=", "*=", "/=", "++", "--", "->",
                                                          "=>", ".*", "./", ".^"});
  const std::string_view two = text.substr(at, 2);
  return at + (std::ranges::find(kLong, two) != kLong.end() ? 2 : 1);
}

SessionOptions options() {
  SessionOptions made = at_the_table();
  return made;
}

}  // namespace

std::vector<Span> tokens_of(std::string_view text) {
  std::vector<Span> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const std::size_t begin = at;
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
      ++at;
      continue;
    }
    if (text.substr(at).starts_with("//")) {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (text.substr(at).starts_with("/*")) {
      at = std::min(text.find("*/", at), text.size() - 2) + 2;
      continue;
    }
    const bool formatted = c == 'f' && at + 1 < text.size() && text[at + 1] == '"';
    if (c == '"' || c == '\'' || formatted) {
      at = end_of_text(text, at + (formatted ? 1 : 0));
    } else if (is_digit(c)) {
      at = end_of_number(text, at);
    } else if (is_word(c)) {
      while (at < text.size() && is_word(text[at])) ++at;
    } else {
      at = end_of_mark(text, at);
    }
    tokens.push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at), 0});
  }
  return tokens;
}

std::vector<std::string> messages_of(const std::string& text) {
  Session session(library_engine(), options());
  (void)session.compile(text, "program.rbt");
  std::vector<std::string> out;
  for (const Problem& problem : session.problems())
    out.push_back(problem.diagnostic.code + ": " + problem.diagnostic.message);
  return out;
}

bool compiles(const std::string& text) {
  Session session(library_engine(), options());
  return session.compile(text, "program.rbt");
}

std::vector<Trial> delete_tokens(const std::string& text, std::size_t first, std::size_t step) {
  const std::vector<std::string> always = messages_of(text);
  const std::vector<Span> tokens = tokens_of(text);
  std::vector<Trial> trials;
  for (std::size_t i = first; i < tokens.size(); i += step) {
    std::string shorter = text;
    shorter.erase(tokens[i].begin, tokens[i].end - tokens[i].begin);
    Trial trial{tokens[i], messages_of(shorter)};
    std::erase_if(trial.messages, [&](const std::string& message) {
      return std::ranges::find(always, message) != always.end();
    });
    trials.push_back(std::move(trial));
  }
  return trials;
}

void Distribution::add(const std::vector<Trial>& more) {
  for (const Trial& trial : more) ++trials[trial.messages.size()];
}

std::size_t Distribution::all() const {
  return std::accumulate(trials.begin(), trials.end(), std::size_t{0},
                         [](std::size_t sum, const auto& row) { return sum + row.second; });
}

double Distribution::above(std::size_t most) const {
  std::size_t count = 0;
  for (const auto& [messages, number] : trials) count += messages > most ? number : 0;
  return all() == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(all());
}

std::string Distribution::text() const {
  std::string out;
  for (const auto& [messages, number] : trials) {
    out += fmt::format("{:>3} message{}: {:>6} trials, {:5.1f} %\n", messages,
                       messages == 1 ? " " : "s", number,
                       100.0 * static_cast<double>(number) / static_cast<double>(all()));
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> programs_below(const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> programs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".rbt") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (compiles(text)) programs.emplace_back(entry.path().string(), std::move(text));
  }
  std::ranges::sort(programs);
  return programs;
}

}  // namespace armlet::test
