#include "armlet/interpreter/render.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "armlet/interpreter/messages/catalog.hpp"

namespace armlet {
namespace {

// A message about `text`, marked where `marked` stands in it.
Diagnostic about(const Source& source, std::string_view marked, std::string label = "") {
  const auto begin = static_cast<std::uint32_t>(source.text().find(marked));
  Diagnostic out = make_diagnostic(
      "E0401", {begin, begin + static_cast<std::uint32_t>(marked.size()), source.id()});
  out.mark.label = std::move(label);
  return out;
}

std::string shown(const std::string& text, std::string_view marked, std::string label = "") {
  SourceSet sources;
  const Source& source = sources.add("a.rbt", text);
  return render_text(about(source, marked, std::move(label)), sources);
}

}  // namespace

TEST_CASE("a message without notes ends with its marks") {
  CHECK(shown("wait(2)\n", "2", "plain number") ==
        "error E0401: this needs a unit\n"
        " --> a.rbt:1:6\n"
        "  |\n"
        "1 | wait(2)\n"
        "  |      ^ plain number\n");
}

namespace {

// The headline of a text, and the message that is below `all:`, on one line; empty if there is
// none.
struct FirstLine {
  std::string first;
  std::string whole;
};

FirstLine first_line_of(const std::string& message) {
  SourceSet sources;
  Diagnostic out = about(sources.add("a.rbt", "wait(2)\n"), "2");
  out.message = message;
  const std::string text = render_text(out, sources);
  const std::string note = "= all:  ";
  const std::size_t at = text.find(note);
  return {text.substr(0, text.find('\n')),
          at == std::string::npos
              ? ""
              : text.substr(at + note.size(), text.find('\n', at) - at - note.size())};
}

constexpr std::size_t kColumns = 120;

}  // namespace

TEST_CASE("a headline that is too long is cut behind a word, and stands below as a whole") {
  const std::string start = "error E0401: ";
  std::mt19937 random(4711);
  for (int round = 0; round < 200; ++round) {
    std::string message = "a";
    while (message.size() < 60 + random() % 200)
      message += ' ' + std::string(1 + random() % 12, static_cast<char>('a' + random() % 26));
    const FirstLine said = first_line_of(message);
    CAPTURE(message);
    CHECK(said.first.size() <= kColumns);
    const bool is_short = start.size() + message.size() <= kColumns;
    CHECK(said.whole == (is_short ? "" : message));
    if (is_short) {
      CHECK(said.first == start + message);
    } else {
      REQUIRE(said.first.ends_with(" ..."));
      const std::string kept =
          said.first.substr(start.size(), said.first.size() - start.size() - 4);
      CHECK(message.starts_with(kept + ' '));
    }
  }
  const std::string one_word(200, 'x');
  CHECK(first_line_of(one_word).first == start + one_word);
}

TEST_CASE("no headline of the catalogue is longer than a line, whatever stands in it") {
  const std::string part = "`a.long(call, of: something) + that`";
  for (const CatalogEntry& row : catalog()) {
    std::string message(row.headline);
    for (std::size_t at = message.find("{}"); at != std::string::npos; at = message.find("{}", at))
      message.replace(at, 2, part);
    CAPTURE(row.code);
    const FirstLine said = first_line_of(message);
    CHECK(said.first.size() <= kColumns);
    CHECK((said.whole == message) == said.first.ends_with(" ..."));
  }
}

TEST_CASE("tabs become spaces and the mark stays under its text") {
  CHECK(shown("\twait(\t2)\n", "2") ==
        "error E0401: this needs a unit\n"
        " --> a.rbt:1:8\n"
        "  |\n"
        "1 |     wait(   2)\n"
        "  |             ^\n");
}

TEST_CASE("wide and combining characters keep the mark under its text") {
  // Two wide characters, then e with a combining accent.
  CHECK(shown("\"\u65E5\u672C\" e\u0301 2\n", "2") ==
        "error E0401: this needs a unit\n"
        " --> a.rbt:1:9\n"
        "  |\n"
        "1 | \"\u65E5\u672C\" e\u0301 2\n"
        "  |          ^\n");
}

TEST_CASE("control characters and broken UTF-8 do not reach the terminal") {
  const std::string out = shown("\x1b[31m \xff\xc3 2\n", "2");
  CHECK(out.find('\x1b') == std::string::npos);
  CHECK(out.find("1 | \uFFFD[31m \uFFFD\uFFFD 2\n") != std::string::npos);
  CHECK(out.find("  |          ^\n") != std::string::npos);
}

TEST_CASE("a long line is cut around its mark") {
  const std::string text = std::string(5'000, 'a') + " 2 " + std::string(5'000'000, 'b');
  const std::string out = shown(text, "2", "here");
  CHECK(out.size() < 500);
  CHECK(out.find("..." + std::string(39, 'a') + " 2 b") != std::string::npos);
  CHECK(out.find("  | " + std::string(43, ' ') + "^ here\n") != std::string::npos);
  CHECK(out.find("bbb...\n") != std::string::npos);
}

TEST_CASE("a mark over several lines is drawn on the first and says where it ends") {
  CHECK(shown("{ a\n  b }\n", "{ a\n  b }", "block") ==
        "error E0401: this needs a unit\n"
        " --> a.rbt:1:1\n"
        "  |\n"
        "1 | { a\n"
        "  | ^^^ block (to line 2)\n");
}

TEST_CASE("an empty mark at the end of the text shows one caret") {
  SourceSet sources;
  sources.add("a.rbt", "let x =\n");
  const Diagnostic message = make_diagnostic("E0129", {8, 8}, {"a value"});
  CHECK(render_text(message, sources) ==
        "error E0129: a value is missing here\n"
        " --> a.rbt:2:1\n"
        "  |\n"
        "2 |\n"
        "  | ^\n");
}

TEST_CASE("one line between marks is shown, more are left out") {
  SourceSet sources;
  const Source& source = sources.add("a.rbt", "one\ntwo\nthree\n\n\nsix\n");
  Diagnostic message = about(source, "six");
  message.related = {about(source, "one").mark, about(source, "three").mark};
  CHECK(render_text(message, sources) ==
        "error E0401: this needs a unit\n"
        " --> a.rbt:6:1\n"
        "  |\n"
        "1 | one\n"
        "  | ---\n"
        "2 | two\n"
        "3 | three\n"
        "  | -----\n"
        "  ...\n"
        "6 | six\n"
        "  | ^^^\n");
}

TEST_CASE("marks in another file get a block of their own") {
  SourceSet sources;
  const Source& main = sources.add("a.rbt", "grip.pick(3)\n");
  const Source& other = sources.add("grip.rbt", "\nfn pick(h: length) { }\n");
  Diagnostic message = about(main, "3");
  message.related = {about(other, "length", "wanted here").mark};
  CHECK(render_text(message, sources) ==
        "error E0401: this needs a unit\n"
        " --> a.rbt:1:11\n"
        "  |\n"
        "1 | grip.pick(3)\n"
        "  |           ^\n"
        " ::: grip.rbt:2:12\n"
        "  |\n"
        "2 | fn pick(h: length) { }\n"
        "  |            ------ wanted here\n");
}

TEST_CASE("a message about a whole file has no marks") {
  Diagnostic message = make_diagnostic("E0126", kNoText, {"a.rbt", "there is no such file"});
  message.fix = Fix{"check the name", {}, Confidence::kMaybe};
  CHECK(render_text(message, SourceSet()) ==
        "error E0126: the file `a.rbt` cannot be read: there is no such file\n"
        "  = fix:  check the name\n");
}

TEST_CASE("a headline stays on one line") {
  SourceSet sources;
  sources.add("a.rbt", "x\n");
  const Diagnostic message = make_diagnostic("R0608", {0, 1}, {"a ==\n  b"});
  CHECK(
      render_text(message, sources).starts_with("error R0608: the assertion is false: a ==   b\n"));
}

TEST_CASE("colours only add escape sequences") {
  SourceSet sources;
  const Source& source = sources.add("a.rbt", "wait(2)\n");
  Diagnostic message = about(source, "2", "plain number");
  message.why = "a time is needed";
  std::string colored = render_text(message, sources, {.color = true});
  CHECK(colored.find("\033[1;31m") != std::string::npos);
  for (std::size_t at = colored.find('\033'); at != std::string::npos; at = colored.find('\033')) {
    colored.erase(at, colored.find('m', at) - at + 1);
  }
  CHECK(colored == render_text(message, sources));
}

TEST_CASE("the circumstances name robot, task, calls and whether anything moved") {
  When when{.time_ns = 1'250'000'000,
            .resource_type = "robot",
            .resource = "scara",
            .task = "branch 2",
            .moved = true,
            .moved_text = "the robot had started to move"};
  when.calls = {"slot, called on line 12"};
  CHECK(
      when_text(when) ==
      "at t = 1.25 s, robot scara, branch 2, in slot, called on line 12, the robot had started to "
      "move");
  CHECK(when_text({}) == "at t = 0.00 s");
}

TEST_CASE("endless recursion does not make an endless message") {
  When when;
  when.calls.assign(10'000, "f, called on line 1");
  CHECK(when_text(when).ends_with(", and further out"));
}

TEST_CASE("JSON holds every part of a message") {
  SourceSet sources;
  const Source& source = sources.add("a.rbt", "let \u00E4 = 1\nwait(\u00E4)\n");
  Diagnostic message = about(source, "\u00E4)", "a double");
  message.mark.span.end -= 1;
  message.mark.span = {source.line_start(2) + 5, source.line_start(2) + 7, 0};
  message.related = {about(source, "1", "given here").mark, {{0, 0, 0}, ""}};
  message.why = "a \"time\" is needed";
  message.fix = Fix{"write 1s", {{{11, 11, 0}, "s"}}, Confidence::kSure};
  message.when = When{.time_ns = 2'500'000'000,
                      .resource_type = "robot",
                      .resource = "arm",
                      .moved = false,
                      .moved_text = "nothing has moved"};
  message.when->calls = {"f, called on line 2"};
  const std::string text = render_json(message, sources);
  CHECK(text.find('\n') == std::string::npos);
  const nlohmann::json expected = nlohmann::json::parse(R"({
    "code": "E0401", "severity": "error", "message": "this needs a unit", "file": "a.rbt",
    "line": 2, "column": 6, "endLine": 2, "endColumn": 7, "text": "\u00e4", "label": "a double",
    "related": [{"file": "a.rbt", "line": 1, "column": 9, "endLine": 1, "endColumn": 10,
                 "text": "1", "label": "given here"}],
    "why": "a \"time\" is needed",
    "fix": {"text": "write 1s", "confidence": "sure",
            "edits": [{"line": 2, "column": 1, "endLine": 2, "endColumn": 1, "text": "s"}]},
    "when": {"time": 2.5, "robot": "arm", "moved": false, "calls": ["f, called on line 2"]}})");
  CHECK(nlohmann::json::parse(text) == expected);
}

TEST_CASE("parts that are absent are left out of JSON") {
  const nlohmann::json made =
      nlohmann::json::parse(render_json(make_diagnostic("E0123", kNoText), SourceSet()));
  const nlohmann::json expected = {
      {"code", "E0123"}, {"severity", "error"}, {"message", "this file is not text"}};
  CHECK(made == expected);
}

TEST_CASE("JSON survives text that is no UTF-8") {
  SourceSet sources;
  const Source& source = sources.add("a\xff.rbt", "\xff\xfe 2");
  CHECK(nlohmann::json::parse(render_json(about(source, "\xff\xfe"), sources)).is_object());
}

}  // namespace armlet
