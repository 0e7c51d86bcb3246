#pragma once
// A compiled program: bytecode, tables, and what messages need to find their way back to the text.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/source.hpp"
#include "armlet/interpreter/type.hpp"
#include "check/tree/hir.hpp"
#include "compile/code/opcode.hpp"
#include "compile/lower/unset.hpp"
#include "syntax/tree/arena.hpp"
#include "types/text_style.hpp"

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

// The code of a finally block, or of the end of a watched block after a failure, behind its HOLD.
// While it runs the register holds the failure that goes on behind it.
struct FinallyCode {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint16_t held;
};

// A loop whose passes can be counted: the hidden counter is in register `counter`.
struct LoopInfo {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint16_t counter;
  std::int64_t first = 0;  // pass = (counter - first) / step + 1
  std::int64_t step = 1;   // 0: the pass cannot be told
  std::uint32_t line = 0;
};

// A call whose function's body stands in its place.
struct ExpandedCall {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t function;
  Span call;
};

// What an instruction belongs to in the text.
struct CodeSpan {
  std::uint32_t pc;  // from here on
  Span span;
  const hir::Expr* expr = nullptr;  // the element, call ... being computed, for labels and marks
};

// A variable and its register, while pc is in [begin, end) for what begins inside of `scope`. That
// of a variable that closures share holds its box.
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
  std::uint16_t references_begin =
      0;  // reference registers [begin, end): null at entry, released at the end.
  std::uint16_t references_end = 0;  // Parameters are borrowed and lie before them.
  std::vector<Handler> handlers;
  std::vector<FinallyCode> finals;
  std::vector<LoopInfo> loops;
  std::vector<ExpandedCall> expanded;  // inner ones first
  std::vector<CodeSpan> spans;         // sorted by pc
  std::vector<ScopedVariable> scopes;  // with markers: outer ones first
  std::vector<const Type*> types;      // for EQDEEP, NEWARRAY, CHECKSET
  // Captures of a closure: which are references (for release).
  std::vector<std::uint16_t> capture_references;
  std::uint16_t captures = 0;
  const hir::Function* function = nullptr;
  bool may_give_unset = false;  // its result may hold elements that are not set
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
  std::vector<std::uint16_t> registers;  // of the shown parts
};

// Statements that instructions refer to by number.
struct NotedStatements {
  std::vector<AssertInfo> asserts{};
  std::vector<const hir::AssertThrowsStmt*> expects{};
  std::vector<const hir::WaitUntilStmt*> waits{};
};

// The last statement of an entry, if it has a value to be shown.
struct ShownValue {
  const hir::Variable* variable = nullptr;  // which has the value; null: there is none
  bool is_declared = false;                 // the statement declares it; otherwise it is `ans`
  bool is_hidden = false;                   // a semicolon follows
};

// Names in the text that the host asks for.
struct UsedNames {
  std::vector<std::string> functions;                                     // of the library, sorted
  std::map<std::string, std::vector<std::string>, std::less<>> declared;  // by type
  bool of_world = false;  // one of the world that is not among the declared
};

struct KeptNames;

// What an entry of a session has besides.
struct EntryParts {
  bool is_one = false;
  mutable std::shared_ptr<const Program> after;  // the entry before; null: there is none
  std::unique_ptr<Arena> syntax;  // of functions and structs, which later calls check
  bool keeps_syntax = false;
  std::unique_ptr<const KeptNames> kept;
  ShownValue shown;
};

struct CompiledProgram {
  CompiledProgram() : CompiledProgram(CompileOptions{}) {}
  // Of a text that is compiled so: an entry of a session goes on from the one before it.
  explicit CompiledProgram(const CompileOptions& options);

  std::shared_ptr<SourceSet> sources;
  std::unique_ptr<Arena> arena;                   // hir
  std::shared_ptr<const TypePool> library_types;  // null: `types` are behind those of entry.after
  std::shared_ptr<TypePool> types;  // those of the entry before it, if this one makes none
  std::vector<std::shared_ptr<const Fact>> facts;
  std::vector<std::unique_ptr<Constant>> constants;
  hir::Module module;

  std::vector<FunctionCode> functions;  // [0] is the program itself
  std::vector<const NativeFunction*> natives;
  std::vector<std::string>
      texts;  // literals; each Vm makes its own objects of them, so that Vms share nothing
  std::vector<RecordLayout> layouts;
  std::vector<std::vector<std::uint16_t>> layout_references;
  std::vector<Format> formats;
  std::unique_ptr<NotedStatements> noted;  // null: there are none
  UnsetElements unset;
  UsedNames names;
  std::string what_takes_time;              // in the words of the host: "wait or move"
  const MessageTables* messages = nullptr;  // of the engine, which outlives the program
  EntryParts entry;

  CompiledProgram(const CompiledProgram&) = delete;
  CompiledProgram& operator=(const CompiledProgram&) = delete;
  ~CompiledProgram();
};

[[nodiscard]] std::string disassemble(const CompiledProgram& program);

}  // namespace armlet::lang

struct armlet::Program::Code final : lang::CompiledProgram {
  using CompiledProgram::CompiledProgram;
};
