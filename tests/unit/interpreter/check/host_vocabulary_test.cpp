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
};
const HostType kRobot = {.name = "robot", .size = 8, .is_handle = true, .is_ambient = true};

// The codes of the messages about a program, in the order of the text.
std::string codes(const std::string& text) {
  Engine engine;
  engine.add_functions(kWords).add_type(kRobot);
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

TEST_CASE("a path is unknown where nobody makes one, and what is in it is checked") {
  CHECK(codes("path (blend: 3mm) { print(1) }") == "E0201");
  CHECK(codes("path { print(nothing) }") == "E0201 E0201");
}

}  // namespace armlet
