// Lines of other languages: the program after the fixes gives what the line gives in its language,
// or no fix is offered. And what rows of the habits say exists.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <regex>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/stdlib/session.hpp"
#include "habits/pattern.hpp"
#include "habits/rows.hpp"
#include "library.hpp"
#include "messages/foreign_names.hpp"
#include "messages/library_messages.hpp"

using namespace armlet;

namespace {

// "lines before | line | value => output", or "... | line | value => no fix".
struct Meaning {
  std::string text;
  std::string output;
  int number = 0;
};

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

// Parts between bars are lines of the program.
std::vector<Meaning> meanings() {
  std::ifstream file(std::string(ARMLET_ROOT) + "/tests/mistakes/meanings.txt");
  std::vector<Meaning> out;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    const std::size_t arrow = line.rfind(" ==> ");
    if (line.starts_with("##") || arrow == std::string::npos) continue;
    Meaning& meaning = out.emplace_back();
    meaning.number = number;
    meaning.output = trimmed(line.substr(arrow + 5));
    std::string rest = line.substr(0, arrow);
    for (std::size_t bar = rest.find(" | "); bar != std::string::npos; bar = rest.find(" | ")) {
      meaning.text += rest.substr(0, bar) + '\n';
      rest.erase(0, bar + 3);
    }
    meaning.text += rest + '\n';
  }
  return out;
}

std::string with_edits(std::string text, std::vector<Edit> edits) {
  std::ranges::stable_sort(edits, std::greater<>(), [](const Edit& e) { return e.span.begin; });
  for (const Edit& edit : edits)
    text.replace(edit.span.begin, edit.span.end - edit.span.begin, edit.text);
  return text;
}

// What a program prints, without the last line break; lines are joined with a bar.
std::string output_of(const std::string& text) {
  std::string out;
  SessionOptions options = at_the_table();
  options.output = [&](std::string_view part) { out += part; };
  Session session(library_engine(), std::move(options));
  if (!session.compile(text, "cell.rbt")) return "does not compile:\n" + text;
  const RunResult result = session.run();
  if (result.status != Progress::kDone && out.empty()) return "no output";
  while (out.ends_with('\n')) out.pop_back();
  for (std::size_t at = out.find('\n'); at != std::string::npos; at = out.find('\n', at))
    out.replace(at, 1, " | ");
  return out;
}

// Applies fix upon fix until no error is left; nothing if an error has no fix with edits.
std::optional<std::string> repaired(std::string text) {
  constexpr int kMostFixes = 8;
  for (int i = 0; i < kMostFixes; ++i) {
    Session session(library_engine(), at_the_table());
    if (session.compile(text, "cell.rbt")) return text;
    const auto first = std::ranges::find_if(session.problems(), [](const Problem& problem) {
      return problem.diagnostic.severity == Severity::kError;
    });
    if (first == session.problems().end() || !first->diagnostic.fix ||
        first->diagnostic.fix->edits.empty())
      return std::nullopt;
    text = with_edits(text, first->diagnostic.fix->edits);
  }
  return std::nullopt;
}

// Calls of a library in a text: the names in front of an opening bracket.
std::vector<std::string> calls_in(std::string_view text) {
  static const std::regex call(R"(([A-Za-z_][A-Za-z_0-9.]*)\()");
  const std::string all(text);
  std::vector<std::string> out;
  for (std::sregex_iterator at(all.begin(), all.end(), call), end; at != end; ++at)
    out.push_back((*at)[1]);
  return out;
}

// Words and methods that are no functions of the library, and names that stand for the reader's
// own.
const std::set<std::string> kNoFunctions = {
    "if",     "while",  "for",      "switch", "catch",  "fn",    "with",   "every",
    "until",  "wait",   "push",     "has",    "remove", "keys",  "q",      "qd",
    "qdd",    "pick",   "path",     "error",  "print",  "euler", "assert", "int",
    "double", "string", "revolute", "tell",   "get",    "put",   "range",  "System.out.print"};

bool exists(const std::string& name) {
  const std::string method = name.substr(name.rfind('.') + 1);
  if (kNoFunctions.contains(name) || kNoFunctions.contains(method)) return true;
  const auto is_known = [](const std::string& called) {
    Session session(library_engine(), at_the_table());
    static_cast<void>(session.compile(called + "()\n", "cell.rbt"));
    Session value(library_engine(), at_the_table());  // PI
    if (value.compile("print(" + called + ")\n", "cell.rbt")) return true;
    return std::ranges::none_of(session.problems(), [](const Problem& problem) {
      return problem.diagnostic.code == "E0201";
    });
  };
  return is_known(name) || is_known(method);
}

void check_calls(std::string_view shape, std::string_view text) {
  CAPTURE(shape);
  for (const std::string& name : calls_in(text)) {
    CAPTURE(name);
    CHECK(exists(name));
  }
}

bool offers_a_fix(std::string_view here) {
  return here != lang::kNoSuchThing && !here.starts_with(lang::kOnlyShown);
}

// Where statements of a line begin or end: at its ends, and beside semicolons and braces.
std::vector<std::size_t> ends_of_statements(const lang::Line& line) {
  std::vector<std::size_t> out = {0};
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    const std::string_view piece = line.piece(i);
    if (piece != ";" && piece != "{" && piece != "}") continue;
    out.push_back(i);
    out.push_back(i + 1);
  }
  out.push_back(line.pieces.size());
  return out;
}

bool is_statement(const lang::Line& line, std::string_view shape) {
  const std::vector<std::size_t> ends = ends_of_statements(line);
  for (const std::size_t first : ends) {
    for (const std::size_t last : ends) {
      lang::Patience patience = lang::kPatience;
      if (first < last && lang::match_all(line, first, last, shape, patience)) return true;
    }
  }
  return false;
}

bool is_value(const lang::Line& line, std::string_view shape) {
  lang::Patience patience = lang::kPatience;
  return lang::match_inside(line, 0, line.pieces.size(), shape, patience).has_value();
}

// The shapes among `rows` that offer a fix and that no line has.
template <class Rows, class HasShape>
std::string shapes_without_a_line(const Rows& rows, const std::vector<std::string>& lines,
                                  HasShape has_shape) {
  std::string out;
  for (const auto& row : rows) {
    if (!offers_a_fix(row.here)) continue;
    const bool is_there = std::ranges::any_of(
        lines, [&](const std::string& line) { return has_shape(lang::Line(line), row.shape); });
    if (!is_there) out += '\n' + std::string(row.shape);
  }
  return out;
}

std::vector<std::string> lines_of(const std::vector<Meaning>& all) {
  std::vector<std::string> out;
  for (const Meaning& meaning : all) {
    std::istringstream text(meaning.text);
    for (std::string line; std::getline(text, line);) out.push_back(line);
  }
  return out;
}

}  // namespace

TEST_CASE("every habit of another language that has a fix has a line that says what it means") {
  const std::vector<std::string> lines = lines_of(meanings());
  CHECK(shapes_without_a_line(lang::statement_habits(), lines, is_statement) == "");
  CHECK(shapes_without_a_line(lang::value_habits(), lines, is_value) == "");
  const auto is_either = [](const lang::Line& line, std::string_view shape) {
    return is_value(line, shape) || is_statement(line, shape);
  };
  CHECK(shapes_without_a_line(lang::toolbox_habits(), lines, is_either) == "");
  CHECK(shapes_without_a_line(lang::block_habits(), lines, is_statement) == "");
  CHECK(shapes_without_a_line(lang::middle_habits(), lines, is_statement) == "");
  CHECK(shapes_without_a_line(lang::end_habits(), lines, is_statement) == "");
}

TEST_CASE("a line of another language gives after its fixes what it gives there, or has no fix") {
  const std::vector<Meaning> all = meanings();
  CHECK(all.size() > 100);
  for (const Meaning& meaning : all) {
    CAPTURE(meaning.number);
    CAPTURE(meaning.text);
    const std::optional<std::string> after = repaired(meaning.text);
    if (meaning.output == "no fix") {
      CAPTURE(after.value_or(""));
      CHECK_FALSE(after.has_value());
      continue;
    }
    REQUIRE(after.has_value());
    CAPTURE(*after);
    CHECK(output_of(*after) == meaning.output);
  }
}

TEST_CASE("what the pages of messages name in their sentences exists") {
  MessageTables tables;
  tables.add(bind::kLibraryMessages);
  for (const CatalogEntry* row : tables.all()) {
    const std::size_t programs = std::min(row->page.find("\nWrong:"), row->page.find("\nRight:"));
    check_calls(row->code, row->headline);
    check_calls(row->code, row->page.substr(0, programs));
  }
}

TEST_CASE("what the rows of foreign habits name exists") {
  for (const auto rows : {lang::statement_habits(), lang::value_habits(), lang::toolbox_habits()}) {
    for (const lang::Habit& row : rows) {
      check_calls(row.shape, row.here);
      check_calls(row.shape, row.why);
    }
  }
  for (const lang::BlockHabit& row : lang::block_habits()) check_calls(row.shape, row.here);
  for (const auto rows : {lang::middle_habits(), lang::end_habits()}) {
    for (const lang::Habit& row : rows) check_calls(row.shape, row.here);
  }
  for (const ForeignName& row : bind::kForeignNames) {
    check_calls(row.foreign, row.note);
    const bool is_function = !row.here.empty() && row.kind == ForeignKind::kName;
    if (is_function) check_calls(row.foreign, std::string(row.here) + "(");
  }
  CHECK_FALSE(exists("loadTheTable"));
}
