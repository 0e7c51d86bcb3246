#pragma once
// A compiled program: bytecode, its tables, and the data that lead messages from instructions back
// to the text.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "armlet/interpreter/host/compile_options.hpp"
#include "armlet/interpreter/host/program.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"
#include "base/text_style.hpp"
#include "hir/checked_program.hpp"
#include "hir/hir.hpp"
#include "program/opcode.hpp"
#include "program/unset.hpp"

namespace armlet::lang {

struct Instr {
  OpCode op;
  std::uint16_t a;
  std::uint16_t b;
  std::uint16_t c;
};
static_assert(sizeof(Instr) == 8);

// While pc is in [begin, end) a failure continues at `handler`. Inner handlers come first.
struct Handler {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t handler;
  bool is_finally;  // also entered when the task is cancelled
};

// The code of a finally block, or of the end of a watched block after a failure, from its HOLD on.
// While it runs the register `held` has the failure that is raised again at its end.
struct FinallyCode {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint16_t held;
};

// A loop whose iterations messages can number: the hidden counter is in register `counter`.
struct LoopInfo {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint16_t counter;
  std::int64_t first = 0;  // iteration = (counter - first) / step + 1
  std::int64_t step = 1;   // 0: the number of the iteration is unknown
  std::uint32_t line = 0;
};

// The code of a call that is inlined.
struct ExpandedCall {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t function;
  Span call;
};

// The span and the expression that an instruction belongs to.
struct CodeSpan {
  std::uint32_t pc;  // from this instruction on
  Span span;
  const hir::Expr* expr = nullptr;  // the element, call ... that it computes, for labels and marks
};

// A variable and its register, valid while pc is in [begin, end) and the statement begins inside of
// `scope`. For a variable that closures share the register has its box.
struct ScopedVariable {
  const hir::Variable* variable;
  std::uint16_t reg;
  Span scope;
  std::uint32_t begin;
  std::uint32_t end;
};

struct FunctionCode {
  std::string name;
  Span span;
  std::vector<Instr> code;
  std::vector<Slot> constants;  // numbers
  std::uint16_t parameters = 0;
  std::uint16_t registers = 0;  // all, arguments of calls included
  // The reference registers [begin, end) are null at the start of a call and released at its end.
  // Parameters come before them and are borrowed.
  std::uint16_t references_begin = 0;
  std::uint16_t references_end = 0;
  std::vector<Handler> handlers;
  std::vector<FinallyCode> finals;
  std::vector<LoopInfo> loops;
  std::vector<ExpandedCall> expanded;  // the innermost first
  std::vector<CodeSpan> spans;         // sorted by pc
  std::vector<ScopedVariable> scopes;  // with markers: the outermost first
  std::vector<const Type*> types;      // for EQDEEP, NEWARRAY, CHECKSET
  // For closures: the captured values that are references, which are released with the closure.
  std::vector<std::uint16_t> capture_references;
  std::uint16_t captures = 0;
  const hir::Function* function = nullptr;
  bool may_give_unset = false;  // a result may have elements without a value
  bool has_markers = false;     // a MARK before each statement
};

struct Format {
  const Type* type;
  TextStyle style;
  std::string unit;
  double factor;
};

struct AssertInfo {
  const hir::AssertStmt* statement;
  std::vector<std::uint16_t> registers;  // of the parts that a failure shows
};

// Statements that instructions refer to by number.
struct NotedStatements {
  std::vector<AssertInfo> asserts{};
  std::vector<const hir::AssertThrowsStmt*> expects{};
  std::vector<const hir::WaitUntilStmt*> waits{};
};

struct CompiledProgram : CheckedProgram {
  CompiledProgram() = default;
  // earlier  the entry of the session before the checked one; null for the first one and for
  // programs.
  explicit CompiledProgram(CheckedProgram checked, std::shared_ptr<const Program> earlier = nullptr)
      : CheckedProgram(std::move(checked)), after(std::move(earlier)) {}

  std::vector<FunctionCode> functions;  // [0] is the program itself
  std::vector<const NativeFunction*> natives;
  std::vector<std::string>
      texts;  // literals; each Vm makes its own objects of them, so that Vms share nothing
  std::vector<RecordLayout> layouts;
  std::vector<std::vector<std::uint16_t>> layout_references;
  std::vector<Format> formats;
  std::unique_ptr<NotedStatements> noted;  // null: there are none
  UnsetElements unset;
  mutable std::shared_ptr<const Program> after;  // the entry before; null: none

  CompiledProgram(const CompiledProgram&) = delete;
  CompiledProgram& operator=(const CompiledProgram&) = delete;
  ~CompiledProgram();
};

// The program that the check of a text fills. An entry of a session continues from the entry before
// it.
[[nodiscard]] CheckedProgram new_program(const CompileOptions& options);

[[nodiscard]] std::string disassemble(const CompiledProgram& program);

}  // namespace armlet::lang

struct armlet::Program::Code final : lang::CompiledProgram {
  using CompiledProgram::CompiledProgram;
};
