#include "lower/optimise/accumulator.hpp"

#include <doctest/doctest.h>

#include <string>

#include "script_support.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

const Reg kX = Reg::make(RegClass::kParameter, 0);
const Reg kY = Reg::make(RegClass::kParameter, 1);
const Reg kI = Reg::make(RegClass::kPinned, 0);
const Reg kA = Reg::make(RegClass::kNumber, 0);
const Reg kB = Reg::make(RegClass::kNumber, 1);

WideInstr instr(OpCode op, Reg a, Reg b = {}, Reg c = {},
                std::uint32_t label = WideInstr::kNoLabel) {
  return {op, a.bits, b.bits, c.bits, label, nullptr, {}};
}

struct Chosen {
  std::vector<WideInstr> code;
  std::vector<Insertion> insertions;
};

// labels: the positions they are at.
Chosen choose(std::vector<WideInstr> code, std::vector<std::uint32_t> labels = {}) {
  CodeShape shape;
  shape.labels = std::move(labels);
  shape.numbers = 2;
  Edits edits = use_accumulator(code, shape);
  return {std::move(code), std::move(edits.insertions)};
}

void prints(const std::string& program, const std::string& expected) {
  INFO(program);
  CHECK(run_script(program, false) == expected);
  CHECK(run_script(program, true) == expected);
}

}  // namespace

TEST_CASE("an operand that was just computed is taken from the processor") {
  const auto [code, insertions] = choose({
      instr(OpCode::MULR, kA, kX, kY),
      instr(OpCode::SUBR, kB, kA, kX),
      instr(OpCode::SUBR, kB, kX, kB),
      instr(OpCode::ADDR, kA, kY, kB),  // the sides are swapped
      instr(OpCode::MADD, kA, kX, kY),
      instr(OpCode::MULADD, kB, kX, kY),
      instr(OpCode::WITH, kA),
  });
  CHECK(code[0].op == OpCode::MULR);
  CHECK(code[1].op == OpCode::SUBR_B);
  CHECK(code[2].op == OpCode::SUBR_C);
  CHECK(code[3].op == OpCode::ADDR_B);
  CHECK(Reg{code[3].b} == kB);
  CHECK(Reg{code[3].c} == kY);
  CHECK(code[4].op == OpCode::MADD_A);
  CHECK(code[5].op == OpCode::MULADD_W);
  CHECK(insertions.empty());
}

TEST_CASE(
    "instructions that compute no double leave it where it is, unless they write its register") {
  const WideInstr product = instr(OpCode::MULR, kA, kX, kY);
  const WideInstr sum = instr(OpCode::ADDR, kB, kA, kX);
  CHECK(choose({product, instr(OpCode::ADDI, kI, kI, kI), sum}).code[2].op == OpCode::ADDR_B);
  CHECK(choose({product, instr(OpCode::MOVE, kA, kX), sum}).code[2].op == OpCode::ADDR);
  CHECK(choose({product, instr(OpCode::CALL, kB), sum}).code[2].op == OpCode::ADDR);
  CHECK(choose({product, instr(OpCode::NEGR, kB, kX), sum}).code[2].op == OpCode::ADDR);
  CHECK(choose({product, sum}, {1}).code[1].op == OpCode::ADDR);  // jumped to
}

TEST_CASE("a sum stays in the processor from pass to pass") {
  const std::vector<WideInstr> loop = {
      instr(OpCode::MADD, kA, kX, kY),
      instr(OpCode::FORI, kI, kI),
      instr(OpCode::LOOP, {}, {}, {}, 0),
  };
  const Chosen chosen = choose(loop, {0});
  CHECK(chosen.code[0].op == OpCode::MADD_A);
  REQUIRE(chosen.insertions.size() == 1);
  CHECK(chosen.insertions[0].at == 0);
  CHECK(chosen.insertions[0].instr.op == OpCode::LAST);
  CHECK(Reg{chosen.insertions[0].instr.a} == kA);

  std::vector<WideInstr> other_first = loop;
  other_first.insert(other_first.begin(), instr(OpCode::NEGR, kB, kX));
  CHECK(choose(other_first, {0}).code[1].op == OpCode::MADD);
  std::vector<WideInstr> forgets = loop;
  forgets.insert(forgets.begin() + 1, instr(OpCode::CALL, kB));
  CHECK(choose(forgets, {0}).insertions.empty());
}

TEST_CASE("sums in loops start from what the variable holds, in every pass of the loop around") {
  prints(
      "fn f(xs: double[]) -> double {\n  var s = 1.0\n  for (i in range(2)) {\n"
      "    for (x in xs) { s += x * x }\n    s = s - 0.5\n  }\n  return s\n}\n"
      "print(f([1.0, 2.0]), f([]))",
      "10.0 0.0\n");
  prints(
      "fn f(n: int) -> double {\n  var s = 0.0\n  var i = 0\n  do { s = s + 0.5\n    i++\n"
      "    if (i == 2) { s = 10.0\n      continue } } while (i < n)\n  return s\n}\nprint(f(1), "
      "f(4))",
      "0.5 11.0\n");
}

TEST_CASE("a failure between two operations is caught with the variables as they were") {
  prints(
      "fn f(xs: double[], k: int) -> double {\n  var s = 0.25\n  try {\n"
      "    for (i in range(k)) { s += xs[i] * 2.0 }\n  } catch (e) { s = s * 2.0 }\n"
      "  return s + 1.0\n}\nprint(f([1.0, 2.0], 2), f([1.0, 2.0], 3))",
      "7.25 13.5\n");
  prints("let x = 0.0 - 4.0\nvar y = 1.0\ntry { y = 2.0 + sqrt(x * 1.0) } catch { print(y) }",
         "1.0\n");
}
