// Typical mistakes of students, and single missing tokens: what the messages are worth.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/render.hpp"
#include "armlet/stdlib/session.hpp"
#include "deletions.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

struct Mistake {
  std::string title;
  std::string code;  // "line 3" in the file of sixty
  int line = 0;
  std::string text;
};

// name: of a file below tests/mistakes.
std::vector<Mistake> mistakes(const std::string& name) {
  std::ifstream file(std::string(ARMLET_ROOT) + "/tests/mistakes/" + name);
  std::vector<Mistake> out;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("=== ")) {
      const std::size_t open = line.rfind('(');
      Mistake& mistake = out.emplace_back();
      mistake.title = line.substr(4, open - 5);
      mistake.code = line.substr(open + 1, line.size() - open - 2);
      if (mistake.code.starts_with("line ")) mistake.line = std::stoi(mistake.code.substr(5));
    } else if (!out.empty()) {
      out.back().text += line + '\n';
    }
  }
  return out;
}

// The messages of a text in the form that editors get.
std::vector<nlohmann::json> json_messages(const std::string& text) {
  SessionOptions options = at_the_table();
  Session session(library_engine(), std::move(options));
  (void)session.compile(text, "cell.rbt");
  std::vector<nlohmann::json> out;
  for (const Problem& problem : session.problems())
    out.push_back(nlohmann::json::parse(render_json(problem.diagnostic, *problem.sources)));
  return out;
}

// The byte at a line and a column in characters, both from 1.
std::size_t offset_of(const std::string& text, int line, int column) {
  std::size_t at = 0;
  for (; line > 1; --line) at = text.find('\n', at) + 1;
  for (; column > 1; --column) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) ++at;
  }
  return at;
}

// The text with the edits of a fix; nothing without edits.
std::string applied(std::string text, const nlohmann::json& message) {
  if (!message.contains("fix") || message["fix"]["edits"].empty()) return {};
  struct Change {
    std::size_t begin, end;
    std::string text;
  };
  std::vector<Change> changes;
  for (const auto& edit : message["fix"]["edits"]) {
    changes.push_back({offset_of(text, edit["line"], edit["column"]),
                       offset_of(text, edit["endLine"], edit["endColumn"]), edit["text"]});
  }
  std::ranges::stable_sort(changes, std::greater<>(), &Change::begin);
  for (const Change& change : changes)
    text.replace(change.begin, change.end - change.begin, change.text);
  return text;
}

bool works(const std::string& text, const nlohmann::json& repaired) {
  const auto left = json_messages(text);
  return !text.empty() && std::ranges::none_of(left, [&](const nlohmann::json& message) {
    return message["severity"] == "error" || message["code"] == repaired["code"];
  });
}

}  // namespace

TEST_CASE("the first message about a student's mistake marks its line, and its fix works") {
  const std::vector<Mistake> all = mistakes("mistakes.txt");
  REQUIRE(all.size() == 60);
  int right_line = 0, working = 0, single = 0;
  std::string missed;
  for (const Mistake& mistake : all) {
    const auto messages = json_messages(mistake.text);
    CAPTURE(mistake.title);
    CHECK_FALSE(messages.empty());
    if (messages.empty()) continue;
    const bool in_line = messages[0]["line"] == mistake.line;
    const bool fixed = works(applied(mistake.text, messages[0]), messages[0]);
    right_line += in_line;
    working += fixed;
    single += messages.size() == 1;
    if (!in_line) missed += "\n  line: " + mistake.title + ": " + messages[0].dump();
    if (!fixed) missed += "\n  fix: " + mistake.title + ": " + messages[0].dump();
    if (messages.size() > 1) missed += "\n  more: " + mistake.title + ": " + messages[1].dump();
  }
  CAPTURE(missed);
  // What is reached now; it must not become less.
  CHECK(right_line >= 60);
  CHECK(working >= 59);
  CHECK(single >= 60);
}

TEST_CASE("the edits of a fix make the program right") {
  const std::vector<Mistake> all = mistakes("fixes.txt");
  CHECK(all.size() >= 20);
  for (const Mistake& mistake : all) {
    CAPTURE(mistake.title);
    const auto messages = json_messages(mistake.text);
    REQUIRE_FALSE(messages.empty());
    CHECK(messages[0]["code"] == mistake.code);
    const std::string repaired = applied(mistake.text, messages[0]);
    CAPTURE(repaired);
    CAPTURE(messages[0].dump());
    CHECK(works(repaired, messages[0]));
  }
}

TEST_CASE("a missing token seldom gives more than two messages") {
  // A part of what the program token_deletions tries: every 7th token of the examples.
  test::Distribution result;
  for (const auto& [path, text] : test::programs_below(std::string(ARMLET_ROOT) + "/examples"))
    result.add(test::delete_tokens(text, 3, 7));
  CAPTURE(result.text());
  CHECK(result.all() > 100);
  CHECK(result.above(2) <= 0.10);
}

TEST_CASE("tokens are what a reader would cross out") {
  std::string joined;
  const std::string text = "x+=2.5mm/s*3 // no\nf(\"a b\", 'c')/* no */ .. 1e-3 9.81m/s^2 f\"{x}\"";
  for (const Span token : test::tokens_of(text))
    joined += text.substr(token.begin, token.end - token.begin) + '|';
  CHECK(joined == "x|+=|2.5mm/s|*|3|f|(|\"a b\"|,|'c'|)|.|.|1e-3|9.81m/s^2|f\"{x}\"|");
}
