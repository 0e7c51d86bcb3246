#include "armlet/interpreter/reference.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "armlet/stdlib/session.hpp"
#include "library.hpp"

namespace armlet {
namespace {

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

TEST_CASE("a page shows every way to call a function, what it does and an example") {
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

TEST_CASE("the examples of what is part of the language run") {
  constexpr std::string_view kMark = "  Example   ";
  for (const std::string_view name : {"print", "error", "assert", "assertThrows", "int", "double",
                                      "push", "pop", "insert", "removeAt", "length", "last"}) {
    const std::string page = help_page(library_engine(), name);
    const std::size_t at = page.find(kMark);
    REQUIRE(at != std::string::npos);
    std::string text = page.substr(at + kMark.size());
    if (!contains(text, "(") || text.starts_with("int") || text.starts_with("double"))
      text = "print(" + text.substr(0, text.size() - 1) + ")\n";
    CAPTURE(text);
    Session session(library_engine(), SessionOptions{});
    REQUIRE(session.compile(text, "example.rbt"));
    CHECK(session.run().status == RunStatus::kDone);
  }
}

}  // namespace
}  // namespace armlet
