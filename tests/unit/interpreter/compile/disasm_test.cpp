#include <doctest/doctest.h>

#include "program/program.hpp"
#include "vm_fixture.hpp"

using namespace armlet;
using namespace armlet::lang;

TEST_CASE("the listing names functions, instructions and lines") {
  const auto program = compiled("fn twice(x: int) -> int {\n  return x + x\n}\nprint(twice(3))");
  const std::string listing = program->disassemble();
  CHECK(listing.find("(program)") != std::string::npos);
  CHECK(listing.find("twice: 1 parameters") != std::string::npos);
  CHECK(listing.find("line 2: return x + x") != std::string::npos);
  CHECK(listing.find("ADDI") != std::string::npos);
  CHECK(listing.find("; twice") != std::string::npos);
  CHECK(listing.find("; print") != std::string::npos);
}

TEST_CASE("jumps are shown with their targets") {
  CompiledProgram program;
  program.sources = std::make_shared<SourceSet>();
  program.sources->add("a.rbt", "while (true) { }");
  FunctionCode main;
  main.code = {
      {OpCode::INT, 0, 5, 0}, {OpCode::LOOP, 0, 0xFFFF, 0xFFFF}, {OpCode::IFLTIK, 0, 0xFFFE, 0}};
  main.spans = {{0, {0, 5, 0}, nullptr}};
  program.functions.push_back(main);
  const std::string listing = disassemble(program);
  CHECK(listing.find("1  LOOP      -> 1") != std::string::npos);
  CHECK(listing.find("2  IFLTIK    r0, -2") != std::string::npos);
}
