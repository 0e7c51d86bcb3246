#include "armlet/interpreter/source.hpp"

#include <doctest/doctest.h>

namespace armlet {

TEST_CASE("lines and columns count from one, columns in characters") {
  const Source source("a.rbt", "let \u00E4 = 1\nprint(\u00E4)\n");
  CHECK(source.position(0) == Position{1, 1});
  CHECK(source.position(4) == Position{1, 5});
  CHECK(source.position(6) == Position{1, 6});
  CHECK(source.position(source.line_start(2)) == Position{2, 1});
  CHECK(source.line_count() == 3);
}

TEST_CASE("a position behind the text is its end") {
  const Source source("a.rbt", "abc");
  CHECK(source.position(100) == Position{1, 4});
  CHECK(Source("empty.rbt", "").position(0) == Position{1, 1});
}

TEST_CASE("a line comes without its line break, whichever it is") {
  const Source source("a.rbt", "one\r\ntwo\nthree");
  CHECK(source.line(1) == "one");
  CHECK(source.line(2) == "two");
  CHECK(source.line(3) == "three");
  CHECK(source.line(0).empty());
  CHECK(source.line(4).empty());
}

TEST_CASE("a slice never reaches behind the text") {
  const Source source("a.rbt", "hello");
  CHECK(source.slice({1, 3}) == "el");
  CHECK(source.slice({3, 99}) == "lo");
  CHECK(source.slice({99, 100}).empty());
}

TEST_CASE("a set numbers its sources in the order in which they come") {
  SourceSet sources;
  sources.add("main.rbt", "a");
  sources.add("grip.rbt", "\nb");
  CHECK(sources.size() == 2);
  CHECK(sources[1].name() == "grip.rbt");
  CHECK(sources.slice({1, 2, 1}) == "b");
  CHECK(sources.position({1, 2, 1}) == Position{2, 1});
}

TEST_CASE("covering two spans reaches from the first to the last byte") {
  CHECK(cover({5, 9}, {2, 6}) == Span{2, 9});
}

}  // namespace armlet
