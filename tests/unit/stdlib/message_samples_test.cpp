// Every message of the language reference, section 20.3, made by hand and shown word for word.
// The program text of a sample is read from its block in tests/reference/messages; the rest stands
// here.

#include <doctest/doctest.h>

#include <filesystem>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/stdlib/install.hpp"
#include "reference_message.hpp"

namespace armlet {
namespace {

// A text on a line of the sample program: its first occurrence, or the one in `column` (from 1).
// An empty text stands for a line that is shown without a mark.
struct At {
  int line = 0;
  std::string text = {};
  std::string label = {};
  int column = 0;
};

struct MessageSample {
  std::string code;
  std::vector<std::string> arguments;
  At main;
  std::vector<At> related;
  std::string why;
  std::string fix;
  std::optional<When> when = {};
};

const std::vector<MessageSample> kMessageSamples = {
    {"E0101",
     {},
     {7, R"("cube);)", "the quote opens here"},
     {},
     "",
     R"(add a closing quote: insertObj("cube");)"},
    {"E0102", {}, {3, "2 s"}, {}, "with a space, `s` is read as a separate name", "write 2s"},
    {"E0103",
     {"5cmm"},
     {4, "5cmm"},
     {},
     "`cmm` is not a unit; lengths can be in um, mm, cm, m, km or inch",
     "did you mean 5cm or 5mm?"},
    {"E0110",
     {"("},
     {12, "(", "opened here"},
     {{13, "grasp", "the next statement starts here"}},
     "",
     "add `)` at the end of line 12"},
    {"E0111",
     {},
     {5, "{", "opened here"},
     {{7, "moveJ", "the indentation suggests that the block ends before this line"}},
     "",
     "add `}` before line 7"},
    {"E0112", {"an `if`"}, {9, "d > 0.45"}, {}, "", "write if (d > 0.45) { ... }"},
    {"E0113", {}, {14, "="}, {}, "", "to compare, write =="},
    {"E0114",
     {"an `if`", "if"},
     {8, "if (b)"},
     {},
     "the reader could not tell which `if` the `else` belongs to",
     "put braces around the inner `if`"},
    {"E0115", {"i++"}, {6, "i++"}, {}, "", "use p[i] here and write i++ on the next line"},
    {"E0116",
     {"public"},
     {1, "public static void main(String[] args)"},
     {},
     "a .rbt file runs from its first line; there are no classes and no main",
     "delete this line and its closing brace"},
    {"E0117", {}, {2, "(0.0, 0.5, 0.1)"}, {}, "", "write {0.0, 0.5, 0.1} or [0.0, 0.5, 0.1]"},
    {"E0201", {"pAbov"}, {21, "pAbov"}, {}, "", "did you mean `pAbove`, declared on line 11?"},
    {"E0202",
     {"Sync"},
     {21, R"("Sync")"},
     {},
     "the planners are Syn, Asyn, Lin and Cubic",
     R"(did you mean "Syn"?)"},
    {"E0203",
     {"cub"},
     {18, R"("cub")"},
     {},
     R"(the world `lab` contains "cube", "cylinder" and "table")",
     R"(did you mean "cube"?)"},
    {"E0204",
     {"p"},
     {9, "p", "declared again"},
     {{3, "p", "first declared here"}},
     "",
     "choose another name, or write p = here() if you want to change it (then declare it with "
     "var)"},
    {"E0205",
     {"two", "robots", "should move"},
     {12, "moveJ"},
     {},
     "`left` and `right` are both declared in this program",
     "write left.moveJ(...), or put the moves inside with (robot: left) { ... }"},
    {"E0206",
     {"home"},
     {9, "home = joints()"},
     {{4, "let", "declared with let"}},
     "",
     "declare it with var on line 4"},
    {"E0207",
     {"moveL", "velocity"},
     {8, "velocity"},
     {},
     "moveL accepts time, speed, accel, tool, frame and blend",
     "did you mean speed?"},
    {"E0301",
     {"second", "a position"},
     {15, "q", "this is a double[]"},
     {},
     "`moveJ` moves to a posJ, an object made from the numbers",
     R"(write moveJ("Syn", new posJ(q), 2.0);)"},
    {"E0302",
     {"5 joint values", "4 joints"},
     {10, "5deg", "one too many"},
     {},
     "`scara` has joints: turn, turn, slide, turn",
     "remove the fifth value"},
    {"E0303",
     {"a double"},
     {6, "i / 3.0"},
     {},
     "storing it in an int would lose the fraction",
     "write i / 3 (whole-number division) or int(i / 3.0)"},
    {"E0304",
     {"*"},
     {5, "v * u", "both are double[]"},
     {},
     "",
     "write dot(v, u) for the inner product or v .* u for element by element"},
    {"E0305",
     {"3x3 times 4"},
     {11, "b", "4 values"},
     {{11, "A", "3 rows, 3 columns"}},
     "",
     "the matrix needs as many columns as the list has values"},
    {"E0306",
     {"slot"},
     {4, "}", "the end can be reached without a return"},
     {{2}},
     "",
     "return a posC here, or throw an error"},
    {"E0307",
     {"State.Reject"},
     {20, "switch (state)"},
     {},
     "every value of an enum must be handled",
     "add case State.Reject: or default:"},
    {"E0308",
     {"a"},
     {3, "a[0] = 1.0"},
     {},
     "values are copied when they are passed to a function",
     "return the changed list: double[] fill(double[] a) { var r = a; r[0] = 1.0; return r; }"},
    {"E0401",
     {},
     {7, "90", "plain number"},
     {},
     "joint 1 of `scara` turns, so its value is an angle",
     "write 90deg (or 90rad, which is more than 14 turns)"},
    {"E0402",
     {"a length", "added to", "a time"},
     {5, "3s", "time"},
     {{5, "20mm", "length"}},
     "",
     "check which of the two was meant"},
    {"E0403", {"speed", "length per time", "a length"}, {9, "100mm"}, {}, "", "write 100mm/s"},
    {"E0404",
     {"3", "slides", "a length", "an angle"},
     {10, "30deg", "third value"},
     {},
     "`scara` has joints: turn, turn, slide, turn",
     "write a length such as 30mm"},
    {"E0405",
     {"a length"},
     {4, "poseOf(cube).z", "length"},
     {},
     "the program would not say whether the number counts metres or millimetres",
     "divide by the unit you want: poseOf(cube).z / 1mm"},
    {"E0406",
     {"s"},
     {6, "10mm / s", "a length divided by 0.5 is a length"},
     {{2, "s", "declared here"}, {7, "v", "a speed is needed", 17}},
     "",
     "write 10mm/s without spaces, or rename the variable"},
    {"E0407",
     {},
     {8, "2Hz", "frequency"},
     {},
     "",
     "write 2Hz * 1rev for two turns per second, or 2rad/s"},
    {"E0501",
     {"left"},
     {13, "left.grasp", "second branch"},
     {{12, "left.moveJ", "first branch"}, {11}},
     "each statement directly inside `parallel` runs at the same time as the others",
     "group steps that follow each other: parallel { { left.moveJ(...); left.grasp(cube) } ... }"},
    {"E0502",
     {},
     {7, "grasp(cube)"},
     {{6}},
     "the whole path is planned before it starts, so nothing can happen in the middle",
     "move this line out of the path"},
    {"E0503",
     {},
     {9, "moveC"},
     {},
     "other robot languages use MoveC for circles; here C stands for Cartesian",
     "write moveCirc(via, goal, time: 2s)"},
    {"E0504",
     {"move the robot"},
     {14, "moveJ(home, time: 1s)", "top level of grip.rbt, imported from cell.rbt:1"},
     {},
     "",
     "put this line inside a function and call it from cell.rbt"},
    {"R0601",
     {"no joint values bring the hand there"},
     {17, "xyz(900mm, 0mm, 100mm)"},
     {},
     "the point is 900 mm from the base; `scara` reaches 400 mm",
     "bring the target at least 500 mm closer",
     When{.time_ns = 4'000'000'000,
          .resource_type = "robot",
          .resource = "scara",
          .moved = false,
          .moved_text = "nothing has moved"}},
    {"R0602",
     {"2", "turn", "152 deg", "-145 deg", "145 deg"},
     {13, "pOver", "{-0.785, 2.653, 0.02, 0.45}"},
     {},
     "",
     "the value 2.653 was given on line 5",
     When{.time_ns = 6'000'000'000, .resource_type = "robot", .resource = "scara"}},
    {"R0603",
     {"62 %"},
     {20, "moveL"},
     {},
     "both ends can be reached, but in between the line passes 3 mm from the axis of joint 1, "
     "closer than the arm can fold",
     "use moveJ, or go round through a point in between",
     When{.time_ns = 9'310'000'000,
          .resource_type = "robot",
          .resource = "scara",
          .moved = false,
          .moved_text = "nothing has moved"}},
    {"R0604",
     {"2 s", "2.71 s"},
     {11, "time: 2s"},
     {},
     "joint 1 turns 163 deg and is limited to 90 deg/s",
     "use time: 2.8s, or leave time out to move as fast as the joints allow",
     When{.time_ns = 0, .resource_type = "robot", .resource = "arm"}},
    {"R0605",
     {},
     {14, "grasp(cube)"},
     {},
     R"(the centre of "cube" is 38 mm from the fingers; the gripper closes on things within 5 mm)",
     "move to poseOf(cube) first",
     When{.time_ns = 5'200'000'000, .resource_type = "robot", .resource = "scara"}},
    {"R0606",
     {"4", "0 to 3"},
     {8, "points[i]", "i is 4, the list has 4 values"},
     {},
     "",
     "the last index of a list of 4 is 3: for (i in range(4))",
     When{.time_ns = 8'000'000'000, .note = "in the 5th pass of the loop on line 7"}},
    {"R0607",
     {"10 s", "offered"},
     {19, "offered", "false since t = 0.00 s"},
     {},
     "the left arm is at line 12, still moving",
     "use a longer timeout, or catch the error",
     When{.time_ns = 13'000'000'000, .task = "branch 2 of parallel on line 9"}},
    {"R0608",
     {"near(poseOf(cube), target, tol: 1mm)"},
     {30, "near(poseOf(cube), target, tol: 1mm)", "the positions differ by 4.2 mm"},
     {},
     "poseOf(cube) = (180.0, -264.2, 20.0) mm\ntarget       = (180.0, -260.0, 20.0) mm",
     "",
     When{.time_ns = 11'500'000'000}},
    {"R0609",
     {"acos", "1.0000002", "the value must lie between -1 and 1"},
     {6, "c", "1.0000002", 17},
     {},
     "",
     "rounding can push a cosine just past 1: acos(clamp(c, -1, 1))"},
    {"W0701", {"1 / 2", "0"}, {3, "1 / 2"}, {}, "", "write 1.0 / 2"},
    {"W0702",
     {"45 rad", "7 turns"},
     {3, "q", "plain numbers count as radians and metres"},
     {{2, "45"}},
     "",
     "write {45deg, 30deg, 0.1, 0}"},
    {"W0703",
     {"2 ^ 3 is 8"},
     {5, "^"},
     {},
     "in Java `^` mixes bits",
     "ignore this if a power was meant"},
    {"W0704",
     {"cube"},
     {22, "pPick"},
     {},
     "this program never calls grasp or release, so objects named in insertObj are picked up "
     "and put down by contact",
     "call grasp and release to decide yourself"},
};

std::filesystem::path sample_folder() {
  return std::filesystem::path(ARMLET_REFERENCE_DIR) / "messages";
}

// The program that a block shows: its numbered lines, and empty ones between them.
std::string program_of(const std::string& block) {
  static const std::regex kNumbered(R"( *(\d+) \| (.*))");
  std::istringstream lines(block);
  std::string program;
  int next = 1;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, match, kNumbered)) continue;
    for (; next < std::stoi(match[1]); ++next) program += '\n';
    program += match[2];
  }
  return program + '\n';
}

Mark mark_at(const Source& source, const At& at) {
  const std::string_view line = source.line(at.line);
  const std::size_t first = at.column > 0 ? at.column - 1 : 0;
  const std::size_t found = line.find(at.text, first);
  REQUIRE_MESSAGE(found != std::string_view::npos, at.text << " is not on line " << at.line);
  const auto begin = static_cast<std::uint32_t>(source.line_start(at.line) + found);
  return {{begin, begin + static_cast<std::uint32_t>(at.text.size()), source.id()}, at.label};
}

Diagnostic diagnostic_of(const MessageSample& sample, const Source& source) {
  const Mark main = mark_at(source, sample.main);
  const CatalogEntry* row = library_engine().messages().find(sample.code);
  REQUIRE(row != nullptr);
  Diagnostic out = make_diagnostic(Headline::of(*row, sample.arguments), main.span);
  out.mark.label = main.label;
  for (const At& at : sample.related) out.related.push_back(mark_at(source, at));
  out.why = sample.why;
  if (!sample.fix.empty()) out.fix = Fix{sample.fix, {}, Confidence::kSure};
  out.when = sample.when;
  return out;
}

}  // namespace

TEST_CASE("every message of the reference is shown word for word") {
  for (const MessageSample& sample : kMessageSamples) {
    CAPTURE(sample.code);
    const std::string block = reference_message(sample.code);
    SourceSet sources;
    const Source& source = sources.add("cell.rbt", program_of(block));
    CHECK(render_text(diagnostic_of(sample, source), sources) == block);
  }
}

TEST_CASE("every block of the reference has its sample") {
  std::set<std::string> expected;
  for (const auto& entry : std::filesystem::directory_iterator(sample_folder())) {
    expected.insert(entry.path().stem().string());
  }
  std::set<std::string> made;
  for (const MessageSample& sample : kMessageSamples) made.insert(sample.code);
  CHECK(made == expected);
}

}  // namespace armlet
