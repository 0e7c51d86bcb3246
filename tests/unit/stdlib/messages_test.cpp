#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "syntax/parse.hpp"

namespace armlet {
namespace {

// The words of section 20.2, rule 1.
const std::regex kForbidden(
    R"(\b(tokens?|pars(e|er|ing)|syntax|unexpected|expected one of|illegal|invalid|operands?|lvalues?|expressions?|identifiers?|mismatch)\b)",
    std::regex::icase);

int count_lines(const std::string& text) {
  return static_cast<int>(std::ranges::count(text, '\n'));
}

// The table of docs/diagnostics.md.
std::string table() {
  std::string out = "| code | kind | message |\n|---|---|---|\n";
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    std::string headline(entry.headline);
    for (std::size_t at = headline.find("{}"); at != std::string::npos; at = headline.find("{}")) {
      headline.replace(at, 2, "...");
    }
    for (std::size_t at = headline.find("||"); at != std::string::npos; at = headline.find("||")) {
      headline.replace(at, 2, "&#124;&#124;");
    }
    out += fmt::format("| {} | {} | {} |\n", entry.code, entry.kind, headline);
  }
  return out;
}

// The programs of a page below a line that starts with `title`, without their indentation.
std::string program_below(std::string_view page, std::string_view title) {
  std::istringstream lines{std::string(page)};
  std::string program;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (inside && line.starts_with("    ")) program += line.substr(4) + '\n';
    if (!line.starts_with("    ")) inside = line.starts_with(title);
  }
  return program;
}

std::vector<Diagnostic> messages_of(const std::string& program) {
  const Source source("page.rbt", program);
  lang::Arena arena;
  DiagnosticSink sink;
  static_cast<void>(lang::parse(source, arena, sink));
  return sink.take_sorted();
}

std::string read(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("a code is a letter and four digits, and each stands once") {
  const std::regex shape("[ERW]0[1-7]\\d\\d");
  std::string last;
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    CAPTURE(entry.code);
    CHECK(std::regex_match(std::string(entry.code), shape));
    CHECK(last < entry.code);
    last = entry.code;
    CHECK(library_engine().messages().find(entry.code) == &entry);
  }
  CHECK(library_engine().messages().find("E9999") == nullptr);
  CHECK(library_engine().messages().find("") == nullptr);
}

TEST_CASE("headlines are plain sentences without words of the trade") {
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    const std::string headline(entry.headline);
    CAPTURE(headline);
    CHECK_FALSE(headline.empty());
    CHECK_FALSE(headline.ends_with("."));
    CHECK_FALSE(std::regex_search(headline, kForbidden));
    CHECK(headline.find('!') == std::string::npos);
  }
}

TEST_CASE("every page fits on a screen and says something") {
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    CAPTURE(entry.code);
    const std::string page = explain_page(entry);
    CHECK(page.starts_with(std::string(entry.code) + ": "));
    CHECK(page.ends_with("\n"));
    CHECK(count_lines(page) <= 20);
    CHECK(count_lines(page) >= 4);
    CHECK_FALSE(std::regex_search(page, kForbidden));
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  }
}

TEST_CASE("a wrong program comes with a right one") {
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    CAPTURE(entry.code);
    const bool wrong = entry.page.find("\nWrong") != std::string_view::npos;
    const bool right = entry.page.find("\nRight") != std::string_view::npos;
    CHECK((!wrong || right));
  }
}

TEST_CASE("the right program of every page reads without a message") {
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    const std::string program = program_below(entry.page, "Right");
    if (program.empty()) continue;
    CAPTURE(entry.code);
    CAPTURE(program);
    const std::vector<Diagnostic> messages = messages_of(program);
    const std::string first = messages.empty() ? "" : messages.front().message;
    CHECK(first == "");
  }
}

TEST_CASE("the wrong program of a page about reading gives the message of the page") {
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    const std::string program = program_below(entry.page, "Wrong");
    if (program.empty()) continue;
    CAPTURE(entry.code);
    CAPTURE(program);
    const std::vector<Diagnostic> messages = messages_of(program);
    if (entry.code.starts_with("E01")) {
      REQUIRE(messages.size() == 1);
      CHECK(messages.front().code == entry.code);
    } else {
      // Mistakes of other kinds are found by the checker, or while running.
      CHECK((messages.empty() || messages.front().code == entry.code));
    }
  }
}

TEST_CASE(
    "a kind names one code, except Unreachable (of lines too), IndexError (of maps), Singular (of "
    "points) and BadImage (of cameras)") {
  std::map<std::string_view, int> uses;
  for (const CatalogEntry* row : library_engine().messages().all()) {
    const CatalogEntry& entry = *row;
    if (entry.kind.empty()) continue;
    CHECK(entry.code.starts_with('R'));
    ++uses[entry.kind];
    CHECK(library_engine().messages().kind_of(entry.code) == entry.kind);
  }
  for (const auto& [kind, count] : uses) {
    const auto& shown = kind;  // clang 14 captures no binding
    CAPTURE(shown);
    const bool has_two =
        kind == "Unreachable" || kind == "IndexError" || kind == "Singular" || kind == "BadImage";
    CHECK(count == (has_two ? 2 : 1));
  }
}

TEST_CASE("kinds and codes are those of the language reference, section 11") {
  const std::pair<const char*, const char*> kinds[] = {
      {"Unreachable", "R0601"}, {"JointLimit", "R0602"},
      {"TooFast", "R0604"},     {"NothingToGrasp", "R0605"},
      {"IndexError", "R0606"},  {"Timeout", "R0607"},
      {"Assert", "R0608"},      {"MathDomain", "R0609"},
      {"Overflow", "R0610"},    {"DivideByZero", "R0611"},
      {"NotFinite", "R0612"},   {"SizeMismatch", "R0613"},
      {"Collision", "R0614"},   {"Singular", "R0616"},
      {"Busy", "R0617"},        {"Halted", "R0618"},
      {"NotHolding", "R0619"},  {"UnknownObject", "R0625"},
      {"Host", "R0626"}};
  const MessageTables& rows = library_engine().messages();
  for (const auto& [kind, code] : kinds) {
    const auto& shown = kind;  // clang 14 captures no binding
    CAPTURE(shown);
    REQUIRE(rows.of_kind(kind) != nullptr);
    CHECK(rows.of_kind(kind)->code == code);
    CHECK(rows.kind_of(code) == kind);
  }
  CHECK(rows.kind_of("R0603") == "Unreachable");
  CHECK(rows.kind_of("R0627").empty());
  CHECK(rows.of_kind("Empty") == nullptr);
  CHECK(rows.of_kind("") == nullptr);
}

TEST_CASE("the table in docs/diagnostics.md is the catalogue") {
  // Set ARMLET_UPDATE_DOCS to write the table instead of comparing it.
  const std::string path = std::string(ARMLET_ROOT) + "/docs/diagnostics.md";
  const std::string begin = "<!-- catalogue: begin -->\n";
  const std::string end = "<!-- catalogue: end -->\n";
  const std::string text = read(path);
  const std::size_t first = text.find(begin);
  const std::size_t last = text.find(end);
  REQUIRE(first != std::string::npos);
  REQUIRE(last != std::string::npos);
  const std::size_t start = first + begin.size();
  if (std::getenv("ARMLET_UPDATE_DOCS") != nullptr) {
    std::ofstream(path) << text.substr(0, start) << table() << text.substr(last);
    return;
  }
  CHECK(text.substr(start, last - start) == table());
}

}  // namespace armlet
