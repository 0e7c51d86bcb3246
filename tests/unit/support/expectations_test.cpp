#include "expectations.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace armlet::test;

namespace {

const char* const kScript = R"(// run: run --steps 100
print(1 + 1)            // expect: 2
print(here())           // expect about: [0.35, -1e-3] within 1e-6
moveJ('Sin', p, 2)      // expect error E0312: did you mean 'Syn'
let unused = 3
// expect advice W0701 at 5: never used
// expect:
// expect exit: 65
// expect shown:
// | error E0312: wrong
// |  --> a.rbt:4:7
)";

const Outcome kOutcome{
    {"2", "[0.3500001, -0.001]", ""},
    {{"W0701", "'unused' is never used", 5, 5}, {"E0312", "wrong; did you mean 'Syn'?", 4, 7}},
    {"error E0312: wrong", " --> a.rbt:4:7"},
    65};

}  // namespace

TEST_CASE("every form of an expectation is read") {
  const Expectations read = parse_expectations(kScript);
  CHECK(read.command == "run --steps 100");
  REQUIRE(read.output.size() == 3);
  CHECK(read.output[0].text == "2");
  CHECK(read.output[1].within == 1e-6);
  CHECK(read.output[2].text.empty());
  REQUIRE(read.messages.size() == 2);
  CHECK(read.messages[0].line == 4);
  CHECK(read.messages[1].line == 5);
  CHECK(read.messages[1].column == 5);
  CHECK(read.shown.size() == 2);
  CHECK(read.exit == 65);
}

TEST_CASE("a mistyped expectation is refused, not ignored") {
  CHECK_THROWS_AS(parse_expectations("print(1) // expect 1\n"), std::invalid_argument);
  CHECK_THROWS_AS(parse_expectations("print(1) // expect eror E0101: x\n"), std::invalid_argument);
}

TEST_CASE("an outcome as expected has no differences") {
  CHECK(differences(parse_expectations(kScript), kOutcome).empty());
}

TEST_CASE("each kind of difference is reported") {
  const Expectations expected = parse_expectations(kScript);
  const auto count = [&](auto change) {
    Outcome outcome = kOutcome;
    change(outcome);
    return differences(expected, outcome).size();
  };
  CHECK(count([](Outcome& o) { o.output[0] = "3"; }) == 1);
  CHECK(count([](Outcome& o) { o.output[1] = "[0.350002, -0.001]"; }) == 1);
  CHECK(count([](Outcome& o) { o.output.push_back("more"); }) == 1);
  CHECK(count([](Outcome& o) { o.output.clear(); }) == 3);
  CHECK(count([](Outcome& o) { o.messages.pop_back(); }) == 1);
  CHECK(count([](Outcome& o) { o.messages[0].line = 6; }) == 2);
  CHECK(count([](Outcome& o) { o.shown[1] = " --> a.rbt:4:8"; }) == 1);
  CHECK(count([](Outcome& o) { o.exit = 0; }) == 1);
}

TEST_CASE("the exit status follows from the messages unless it is stated") {
  CHECK(expected_exit(parse_expectations("print(1)  // expect: 1\n")) == 0);
  CHECK(expected_exit(parse_expectations("x = 1  // expect error E0201\n")) == 65);
  CHECK(expected_exit(parse_expectations("x = 1  // expect error R0611\n")) == 70);
  CHECK(expected_exit(parse_expectations("x = 1  // expect advice W0701\n")) == 0);
}

TEST_CASE("numbers are compared within the tolerance and the rest as text") {
  CHECK(about_equal("[1, 2.5] mm", "[1.0000001, 2.5] mm", 1e-6));
  CHECK_FALSE(about_equal("[1, 2.5] mm", "[1.1, 2.5] mm", 1e-6));
  CHECK_FALSE(about_equal("[1, 2.5] mm", "[1, 2.5] cm", 1));
  CHECK_FALSE(about_equal("1", "nan", 1));
}

TEST_CASE("an updated script expects what happened") {
  Outcome changed = kOutcome;
  changed.output[0] = "4";
  changed.messages.pop_back();
  const std::string updated = update_expectations(kScript, changed);
  CHECK(differences(parse_expectations(updated), changed).empty());
  CHECK(updated.find("print(1 + 1)  // expect: 4\n") != std::string::npos);
  changed.output.push_back("more");
  CHECK(differences(parse_expectations(update_expectations(updated, changed)), changed).empty());
}
