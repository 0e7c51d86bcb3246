#include "armlet/interpreter/reference.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/session.hpp"
#include "armlet/trajectory/planner.hpp"
#include "library.hpp"
#include "vocabulary/language_words.hpp"

namespace armlet {
namespace {

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

TEST_CASE("a page shows every form of call of a function, what it does and an example") {
  const std::string page = help_page(library_engine(), "lerp");
  CHECK(contains(page, "lerp(a: D, b: D, s: double) -> D\n"));
  CHECK(contains(page, "lerp(a: posC, b: posC, s: double) -> posC\n"));
  CHECK(contains(page, "  Example   lerp(0mm, 10mm, 0.5)\n"));
}

TEST_CASE("a page shows fields, operators, blocks and rows as programs write them") {
  CHECK(contains(help_page(library_engine(), "posC.x"), "posC.x -> length\n"));
  CHECK(contains(help_page(library_engine(), "*"), "posC * posC -> posC\n"));
  CHECK(contains(help_page(library_engine(), "robot"), "robot NAME { "));
  CHECK(
      contains(help_page(library_engine(), "robot.joint.revolute"), "joint revolute(theta: angle"));
}

TEST_CASE("a name that does not exist has no page") {
  CHECK(help_page(library_engine(), "lerpp").empty());
  CHECK(help_page(library_engine(), "").empty());
}

TEST_CASE("a search finds names by a word of their help") {
  const std::vector<std::string> found = help_search(library_engine(), "STRAIGHT LINE");
  CHECK(std::ranges::find(found, "moveL") != found.end());
  CHECK(help_search(library_engine(), "no page says this").empty());
}

TEST_CASE("every name has a page and stands in the whole reference") {
  const std::string all = reference_markdown(library_engine());
  for (const std::string& name : help_names(library_engine())) {
    CAPTURE(name);
    CHECK_FALSE(help_page(library_engine(), name).empty());
    CHECK(contains(all, "\n### `" + name + "`\n"));
  }
}

TEST_CASE("the message about an unknown planner lists every planner, in the order of the table") {
  SessionOptions options;
  options.robot = make_robot("scara");
  Session session(library_engine(), options);
  REQUIRE_FALSE(session.compile("moveJ(home(), traj: \"Sync\")", "planner.rbt"));
  REQUIRE(session.problems().size() == 1);
  const Diagnostic& message = session.problems()[0].diagnostic;
  CHECK(message.code == "E0202");
  std::size_t at = 0;
  for (const PlannerRow& row : planner_rows()) {
    CAPTURE(row.name);
    const std::size_t found = message.why.find(row.name, at);
    REQUIRE(found != std::string::npos);
    at = found + row.name.size();
  }
}

TEST_CASE("the examples of what is part of the language run") {
  for (const NativeFunction& word : lang::language_words()) {
    std::string text(word.example);
    CHECK(contains(help_page(library_engine(), word.name), "  Example   " + text + "\n"));
    const bool is_value =
        std::ranges::any_of(std::array<std::string_view, 4>{"[", "int(", "double(", "string("},
                            [&](std::string_view begin) { return text.starts_with(begin); });
    if (is_value) text = "print(" + text + ")";
    CAPTURE(text);
    Session session(library_engine(), SessionOptions{});
    REQUIRE(session.compile(text, "example.rbt"));
    CHECK(session.run().status == Progress::kDone);
  }
}

}  // namespace
}  // namespace armlet
