// The messages of the language reference, section 20.3, that the checker gives: provoked, and
// compared word for word.

#include <doctest/doctest.h>

#include <map>

#include "check_vocabulary.hpp"
#include "reference_message.hpp"

namespace armlet::lang {
namespace {

struct Provoked {
  std::string code;
  std::map<int, std::string>
      lines;  // what stands on the lines of the program; the others are empty
};

const std::vector<Provoked> kProvoked = {
    {"E0201",
     {{1, "let time = 2.0"},
      {11, "let pAbove = posJ([1, 2])"},
      {21, "moveJ('Syn', pAbov, time);"}}},
    {"E0204",
     {{1, "fn poseOf(c: int) => xyz()\nlet cube = 1"},
      {3, "let p = poseOf(cube)"},
      {5, "fn here() => xyz()"},
      {8, "if (cube > 0) {"},
      {9, "    let p = here()"},
      {10, "}"}}},
    {"E0205",
     {{1, "let left = robots.two()"},
      {2, "let right = robots.two()"},
      {3, "let home = posJ(1, 2)"},
      {12, "moveJ(home, time: 2s)"}}},
    {"E0206", {{4, "let home = posJ(0deg, 0deg, 0mm, 0deg)"}, {9, "home = joints()"}}},
    {"E0301", {{1, "double[] q = {1, 2};"}, {15, "moveJ(\"Syn\", q, 2.0);"}}},
    {"E0303", {{1, "int i = 3;"}, {6, "int row = i / 3.0;"}}},
    {"E0304", {{1, "let v = [1.0]"}, {2, "let u = [2.0]"}, {5, "let w = v * u"}}},
    {"E0306",
     {{1, "struct Pallet { corner: posC }"},
      {2, "fn slot(p: Pallet, i: int) -> posC {"},
      {3, "    if (i >= 0) return p.corner"},
      {4, "}"}}},
    {"E0307",
     {{1, "enum State { Idle, Reject }"},
      {2, "var state = State.Idle"},
      {20, "switch (state) {"},
      {21, "case State.Idle: print(1)"},
      {22, "}"}}},
    {"E0308", {{3, "void fill(double[] a) { a[0] = 1.0; }"}}},
    {"E0402", {{5, "let x = 20mm + 3s"}}},
    {"E0403", {{1, "let p = xyz()"}, {9, "moveL(p, speed: 100mm)"}}},
    {"E0405",
     {{1, "fn poseOf(c: int) => xyz()"}, {2, "let cube = 1"}, {4, "double h = poseOf(cube).z;"}}},
    {"E0406",
     {{1, "let p = xyz()"},
      {2, "let s = 0.5"},
      {6, "let v = 10mm / s"},
      {7, "moveL(p, speed: v)"}}},
    {"E0407", {{8, "let w: angularSpeed = 2Hz"}}},
    {"W0701", {{3, "double half = 1 / 2;"}}},
    {"W0703", {{5, "int mask = 2 ^ 3;"}}},
};

std::string program_of(const Provoked& provoked) {
  std::string out;
  int line = 1;
  for (const auto& [number, text] : provoked.lines) {
    for (; line < number; ++line) out += '\n';
    out += text;
    line += static_cast<int>(std::ranges::count(text, '\n'));
  }
  return out + '\n';
}

TEST_CASE("the checker's messages of section 20.3 are produced word for word") {
  for (const Provoked& provoked : kProvoked) {
    CAPTURE(provoked.code);
    CHECK(check_text(program_of(provoked))->text() == reference_message(provoked.code));
  }
}

}  // namespace
}  // namespace armlet::lang
