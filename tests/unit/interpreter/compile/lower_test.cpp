#include "lower/lower.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "armlet/interpreter/engine.hpp"
#include "hir_builder.hpp"

using namespace armlet;
using namespace armlet::lang;
using hir::Op;

namespace {

Signal show(Vm& vm, Slot* args) {
  return vm.print(std::to_string(args[0].i) + "\n") ? give_nothing() : Signal::kFail;
}
const NativeFunction kShow = {.name = "show",
                              .signature = "(x: int) -> void",
                              .help = "Prints an int.",
                              .example = "show(1)",
                              .thunk = &show};

hir::Stmt* print_int(HirBuilder& b, hir::Expr* value) {
  return b.run(b.call(kShow, b.types().void_type(), {value}));
}

std::unique_ptr<Program::Code> lowered(CheckedProgram checked, LowerOptions options = {}) {
  Lowered out = lower(std::move(checked), options);
  REQUIRE_FALSE(out.too_large.has_value());
  return std::move(out.program);
}

// What the program prints, after a clean end.
std::string output_of(std::unique_ptr<Program::Code> compiled) {
  std::string out;
  VmOptions options;
  options.output = [&](std::string_view text) { out += text; };
  Vm vm(std::make_shared<const Program>(std::move(compiled)), std::move(options));
  const RunResult result = vm.run();
  if (result.error.has_value()) out += result.error->code;
  return out;
}

long count(const FunctionCode& code, OpCode op) {
  return std::count_if(code.code.begin(), code.code.end(),
                       [&](const Instr& i) { return i.op == op; });
}

}  // namespace

TEST_CASE("a function of two cases calls itself with its arguments in place") {
  HirBuilder b;
  const Type* integer = b.types().integer();
  hir::Variable* n = b.variable("n", integer);
  hir::Function* fib = b.function("fib", {n}, integer);
  const auto call_with = [&](std::int64_t less) {
    return b.call(fib, {b.binary(Op::kSubI, b.read(n), b.integer(less))});
  };
  fib->body = b.block({b.when(b.binary(Op::kLtI, b.read(n), b.integer(2)), b.give(b.read(n))),
                       b.give(b.binary(Op::kAddI, call_with(1), call_with(2)))});
  auto program = lowered(b.finish({print_int(b, b.call(fib, {b.integer(20)}))}));
  const FunctionCode& code = program->functions[1];
  CHECK(code.parameters == 1);
  CHECK(code.code.size() == 9);
  CHECK(count(code, OpCode::MOVE) == 0);
  CHECK(output_of(std::move(program)) == "6765\n");
}

TEST_CASE("a sum of products is accumulated in place, a counted loop ends in one instruction") {
  HirBuilder b;
  const Type* real = b.types().real();
  hir::Variable* s = b.variable("s", real);
  hir::Variable* i = b.variable("i", b.types().integer());
  auto program = lowered(b.finish(
      {b.init(s, b.real(0.0)), b.init(i, b.integer(0)),
       b.loop(
           b.binary(Op::kLtI, b.read(i), b.integer(100'000)),
           b.change(s, Op::kAddR, b.binary(Op::kMulR, b.to_real(b.read(i)), b.to_real(b.read(i)))),
           b.change(i, Op::kAddI, b.integer(1))),
       b.when(b.binary(Op::kEqR, b.read(s), b.real(333328333350000.0)), print_int(b, b.read(i)))}));
  const FunctionCode& code = program->functions[0];
  CHECK(count(code, OpCode::MADD_B) == 1);
  CHECK(count(code, OpCode::FORI_LOOP) == 1);
  CHECK(count(code, OpCode::ADDIK) == 0);
  REQUIRE(code.loops.size() == 1);
  CHECK(code.loops[0].first == 0);
  CHECK(code.loops[0].step == 1);
  CHECK(output_of(std::move(program)) == "100000\n");
}

TEST_CASE("without optimisation the same program has other instructions and the same result") {
  for (const bool optimise : {false, true}) {
    HirBuilder b;
    const Type* real = b.types().real();
    hir::Variable* x = b.variable("x", real);
    auto program =
        lowered(b.finish({b.init(x, b.real(0.1)),
                          b.change(x, Op::kAddR, b.binary(Op::kMulR, b.real(0.7), b.real(0.7))),
                          b.when(b.binary(Op::kEqR, b.read(x), b.real(0.1 + 0.7 * 0.7)),
                                 print_int(b, b.integer(1)))}),
                {.optimise = optimise});
    CHECK(count(program->functions[0], OpCode::MADD) == (optimise ? 1 : 0));
    CHECK(output_of(std::move(program)) == "1\n");
  }
}

TEST_CASE("registers are parameters, then references, then numbers") {
  HirBuilder b;
  const Type* reals = b.types().list(b.types().real());
  hir::Variable* xs = b.variable("xs", reals);
  hir::Function* f = b.function("f", {xs}, b.types().integer());
  hir::Variable* copy = b.variable("copy", reals);
  f->body = b.block({b.init(copy, b.read(xs)), b.give(b.length(b.read(copy)))});
  auto program = lowered(
      b.finish({print_int(b, b.call(f, {b.list(reals, {b.real(1), b.real(2), b.real(3)})}))}));
  const FunctionCode& code = program->functions[1];
  CHECK(code.references_begin == 1);
  CHECK(code.references_end == 2);
  CHECK(code.registers == 3);
  CHECK(output_of(std::move(program)) == "3\n");
}

TEST_CASE("a chain of 200,000 additions needs no deep stack") {
  HirBuilder b;
  hir::Variable* x = b.variable("x", b.types().integer());
  hir::Expr* sum = b.read(x);
  for (int i = 0; i < 200'000; ++i) sum = b.binary(Op::kAddI, sum, b.read(x));
  auto program = lowered(b.finish({b.init(x, b.integer(1)), print_int(b, sum)}));
  CHECK(output_of(std::move(program)) == "200001\n");
}

TEST_CASE("what is too large for the machine is refused with the limit") {
  HirBuilder b;
  std::vector<hir::Expr*> items(70'000, b.real(1.5));
  const Type* reals = b.types().list(b.types().real());
  hir::Variable* xs = b.variable("xs", reals);
  auto program = b.finish({b.init(xs, b.list(reals, items))});
  const auto message = lower(std::move(program)).too_large;
  REQUIRE(message.has_value());
  CHECK(message->code == "E0124");
  CHECK(message->message.find("65535") != std::string::npos);
}

TEST_CASE("code that cannot be reached is left out") {
  HirBuilder b;
  hir::Function* f = b.function("f", {}, b.types().integer());
  f->body = b.block({b.give(b.integer(1)), print_int(b, b.integer(2)), b.give(b.integer(3))});
  auto program = lowered(b.finish({print_int(b, b.call(f, {}))}));
  CHECK(program->functions[1].code.size() == 2);
  CHECK(output_of(std::move(program)) == "1\n");
}

TEST_CASE("every instruction that can fail leads back to what was written") {
  HirBuilder b;
  hir::Variable* x = b.variable("x", b.types().integer());
  hir::Expr* quotient = b.binary(Op::kDivI, b.read(x), b.read(x));
  auto program = lowered(b.finish({b.init(x, b.integer(0)), print_int(b, quotient)}));
  const FunctionCode& code = program->functions[0];
  const auto division = std::find_if(code.code.begin(), code.code.end(),
                                     [](const Instr& i) { return i.op == OpCode::DIVI; });
  REQUIRE(division != code.code.end());
  const auto pc = static_cast<std::uint32_t>(division - code.code.begin());
  const auto after = std::find_if(code.spans.begin(), code.spans.end(),
                                  [&](const CodeSpan& s) { return s.pc > pc; });
  CHECK(std::prev(after)->expr == quotient);
  CHECK(output_of(std::move(program)) == "R0611");
}
