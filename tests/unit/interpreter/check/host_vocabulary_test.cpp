// Messages that depend on what a host adds to the language; the library gives no cause for them.

#include <doctest/doctest.h>

#include <string>

#include "armlet/interpreter/engine.hpp"

namespace armlet {
namespace {

Signal do_nothing(Vm&, Slot*) { return Signal::kDone; }

constexpr NativeFunction kWords[] = {
    {.name = "mix", .signature = "(a: int, b: double) -> double", .thunk = do_nothing},
    {.name = "mix", .signature = "(a: double, b: int) -> double", .thunk = do_nothing},
    {.name = "joints", .signature = "(r: robot) -> double[]", .thunk = do_nothing},
    {.name = "turn", .signature = "(by: angle) -> length", .later = true},
};
constexpr std::string_view kPlanned[] = {"sway", "robots.tall", "camera"};
const HostType kRobot = {.name = "robot", .size = 8, .is_handle = true, .is_ambient = true};

// The codes of the messages about a program, in the order of the text.
std::string codes(const std::string& text) {
  Engine engine;
  engine.add_functions(kWords).add_type(kRobot).add_planned(kPlanned);
  std::string out;
  for (const Diagnostic& message : engine.compile(text, "cell.rbt").diagnostics)
    out += (out.empty() ? "" : " ") + message.code;
  return out;
}

}  // namespace

TEST_CASE("functions that fit equally well are a tie that the program has to break") {
  CHECK(codes("print(mix(1, 2))") == "E0319");
  CHECK(codes("print(mix(1, 2.5))").empty());
}

TEST_CASE("a call that needs a robot is refused where nobody supplies one") {
  CHECK(codes("print(joints())") == "E0220");
}

TEST_CASE("a planned name is said to be missing, once") {
  CHECK(codes("sway(1, 2)\nlet t: camera = 3\nfn f(c: camera) { print(c) }") == "E0199 E0199");
  CHECK(codes("fn sway(n: int) => n\nprint(sway(1))").empty());
}

TEST_CASE("a call of what is not there yet is checked like any other, then refused once") {
  CHECK(codes("print(turn(90deg) + 1mm)\nprint(turn(1deg))") == "E0199");
  CHECK(codes("let t: time = turn(90deg)\nturn(3mm)") == "E0410 E0199 E0403");
  CHECK(codes("path (blend: 3mm) { print(turn(1deg)) }") == "E0199 E0199");
  CHECK(codes("path (blend: 3s) { print(nothing) }") == "E0199 E0201");
}

}  // namespace armlet
