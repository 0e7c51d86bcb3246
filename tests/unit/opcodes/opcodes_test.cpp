// Every instruction of the machine is executed by a program of the tests.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "armlet/stdlib/session.hpp"
#include "driver/pipeline.hpp"
#include "driver/vocabulary.hpp"
#include "executed.hpp"
#include "library.hpp"
#include "program/properties.hpp"
#include "random/program.hpp"

namespace fs = std::filesystem;
using namespace armlet;

namespace {

std::string name_of(lang::OpCode op) { return std::string(lang::properties_of(op).name); }

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// As the command does it.
void run_script(const fs::path& path) {
  SessionOptions options = at_the_table();
  options.limits.heap_bytes = 1U << 26U;
  options.limits.steps = 1'000'000;
  Session session(library_engine(), options);
  if (!session.compile(read(path), path.string())) return;
  (void)session.run();
  for (std::size_t i = 0; i < session.program()->test_names().size(); ++i)
    (void)session.run_test(i);
}

// As a debugger does it.
void run_marked(const std::string& text) {
  SessionOptions options;
  options.markers = true;
  Session session(library_engine(), options);
  REQUIRE(session.compile(text, "marked.rbt"));
  (void)session.run();
}

void run_random(std::uint64_t number, bool optimise) {
  const std::string text = oracle::RandomProgram(number).text();
  const Compilation compilation = lang::compile_text(library_engine().registry(), text,
                                                     "random.rbt", {}, {.optimise = optimise});
  // Some have lists whose sizes do not fit, where the text happens to show them.
  if (compilation.program == nullptr) return;
  VmOptions options;
  options.limits.call_depth = 100;
  Vm vm(compilation.program, std::move(options));
  (void)vm.run();
}

// Instructions that only the last passes of the compiler make, as random programs contain them.
std::set<lang::OpCode> chosen_late() {
  std::set<lang::OpCode> found;
  for (std::uint64_t number = 1; number <= 300; ++number) {
    const std::string text = oracle::RandomProgram(number).text();
    const Compilation compilation =
        lang::compile_text(library_engine().registry(), text, "random.rbt", {}, {});
    if (compilation.program == nullptr) continue;
    const std::string listing = compilation.program->disassemble();
    for (std::size_t i = 0; i < lang::kOpCodes; ++i) {
      const auto op = static_cast<lang::OpCode>(i);
      if (listing.find("  " + name_of(op) + " ") != std::string::npos) found.insert(op);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("random programs, which fuzzing runs too, contain what only the last passes make") {
  const std::set<lang::OpCode> found = chosen_late();
  using lang::OpCode;
  for (const OpCode op :
       {OpCode::SCALE,   OpCode::WITHK,   OpCode::RETHERE, OpCode::SUMP,    OpCode::DIFFP,
        OpCode::MADDTWO, OpCode::MADDROW, OpCode::OWNED,   OpCode::SETF,    OpCode::MADDF,
        OpCode::ADDF_W,  OpCode::SUBF,    OpCode::MULF_W,  OpCode::LAST,    OpCode::MADD_A,
        OpCode::SUBR_C,  OpCode::SWAPEL,  OpCode::COPYEL,  OpCode::COUNTEL, OpCode::MSUBEL,
        OpCode::LDO,     OpCode::STO,     OpCode::SCALEI,  OpCode::FORGE,   OpCode::MOVELTI,
        OpCode::COUNTLTR}) {
    CHECK_MESSAGE(found.contains(op), name_of(op) << " is missing");
  }
}

TEST_CASE("every instruction is executed by a script, an example or a random program") {
  for (const char* folder : {"tests/scripts", "examples"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ARMLET_ROOT) / folder)) {
      if (entry.path().extension() == ".rbt") run_script(entry.path());
    }
  }
  for (std::uint64_t number = 1; number <= 300; ++number) run_random(number, number % 2 == 0);
  run_marked("print(1)");
  const std::set<lang::OpCode>& executed = lang::executed_opcodes();
  for (std::size_t i = 0; i < lang::kOpCodes; ++i) {
    const auto op = static_cast<lang::OpCode>(i);
    if (lang::is_operand_word(op)) continue;
    CHECK_MESSAGE(executed.contains(op), name_of(op) << " is never executed");
  }
}
