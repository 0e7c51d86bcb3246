#include "armlet/interpreter/reference.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/help_topics.hpp"
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

// The place of a page among those that are found, from 0; 99 if it is not among them.
std::size_t place_of(std::string_view page, std::string_view words) {
  const HelpFound found = help_about(library_engine(), words, help_topics());
  const auto at = std::ranges::find(found.pages, page, &HelpLine::name);
  return at == found.pages.end() ? 99 : static_cast<std::size_t>(at - found.pages.begin());
}

TEST_CASE("a search finds pages by words of their text, in one sentence each") {
  const HelpFound found = help_about(library_engine(), "STRAIGHT LINE");
  const auto line = std::ranges::find(found.pages, "moveL", &HelpLine::name);
  REQUIRE(line != found.pages.end());
  CHECK(line->sentence.ends_with('.'));
  CHECK_FALSE(contains(line->sentence, ". "));
  CHECK(help_about(library_engine(), "no page says this").pages.empty());
  CHECK(help_about(library_engine(), " ", help_topics()).pages.empty());
}

TEST_CASE("the words of textbooks and of other toolboxes lead to the functions") {
  constexpr std::pair<std::string_view, std::string_view> kAsked[] = {
      {"inverse kinematics", "ikine"},
      {"Inverse Kinematics", "ikine"},
      {"forward kinematics", "fkine"},
      {"direct kinematics", "fkine"},
      {"fkine", "fkine"},
      {"jacob0", "jacobian"},
      {"ikine_LM", "ikine"},
      {"ctraj", "moveL"},
      {"jtraj", "trajectory"},
      {"trplot", "draw.arrow"},
      {"SE3", "posC"},
      {"transform", "posC"},
      {"DH", "dh"},
      {"denavit-hartenberg", "robot"},
      {"rne", "invDyn"},
      {"PTP", "moveJ"},
      {"maniplty", "manipulability"},
      {"ode45", "ode"},
      {"imshow", "show"},
      {"quaternion", "quat"}};
  for (const auto& [words, page] : kAsked) {
    CAPTURE(words);
    CHECK(place_of(page, words) < 2);
  }
}

TEST_CASE("every topic names pages that there are, and each word leads to its first page") {
  for (const HelpTopic& topic : help_topics()) {
    CAPTURE(topic.words);
    const std::string_view word = topic.words.substr(0, topic.words.find(','));
    std::string first(topic.pages.substr(0, topic.pages.find(' ')));
    if (topic.pages.starts_with(first + " ("))
      first = topic.pages.substr(0, topic.pages.find(')') + 1);
    CHECK(place_of(first, word) < 8);
    CHECK(std::ranges::none_of(topic.words, [](char c) { return c >= 'A' && c <= 'Z'; }));
    std::string_view rest = topic.pages;
    while (!rest.empty()) {
      std::size_t end = std::min(rest.find(' '), rest.size());
      if (rest.substr(end).starts_with(" (")) end = rest.find(')') + 1;
      CAPTURE(rest.substr(0, end));
      CHECK_FALSE(help_page(library_engine(), rest.substr(0, end)).empty());
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
}

TEST_CASE("a setting names the functions that take it instead of showing their pages") {
  const HelpFound found = help_about(library_engine(), "speed", help_topics());
  CHECK(found.is_setting);
  CHECK(std::ranges::find(found.settings, "moveL") != found.settings.end());
  CHECK(std::ranges::find(found.pages, "moveL", &HelpLine::name) == found.pages.end());
  CHECK(std::ranges::find(found.settings, "with (speed:)") != found.settings.end());
  CHECK_FALSE(help_about(library_engine(), "sin", help_topics()).is_setting);
}

TEST_CASE("a page with many forms is short, and says how many more there are") {
  const ShortPage object = short_help_page(library_engine(), "object");
  const std::string whole = help_page(library_engine(), "object");
  CHECK(object.left_out > 0);
  CHECK(std::ranges::count(object.text, '\n') < 16);
  CHECK(std::ranges::count(object.text, '\n') * 2 < std::ranges::count(whole, '\n') + 2);
  CHECK(contains(object.text, "  Example   "));
  CHECK(short_help_page(library_engine(), "moveL").left_out == 0);
  CHECK(short_help_page(library_engine(), "moveL").text == help_page(library_engine(), "moveL"));
  CHECK(short_help_page(library_engine(), "nothing").text.empty());
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
