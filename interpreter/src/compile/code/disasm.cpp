// The text form of bytecode: one line per instruction, with what its operands mean and where it
// comes from.

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "compile/code/program.hpp"

namespace armlet::lang {

namespace {

struct OpInfo {
  std::string_view name;
  std::string_view operands;
};

constexpr OpInfo kOps[] = {
#define OP(name, operands, text) {#name, operands},
#include "compile/code/bytecode.def"
#undef OP
};

const OpInfo& info(OpCode op) { return kOps[static_cast<std::size_t>(op)]; }

std::int32_t offset_of(const Instr& jump) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(jump.c) << 16U) | jump.b);
}

std::string operands_text(const Instr& instr, std::size_t pc) {
  const std::uint16_t values[] = {instr.a, instr.b, instr.c};
  const std::string_view letters = info(instr.op).operands;
  std::string text;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (letters[i] == '-') continue;
    if (!text.empty()) text += ", ";
    switch (letters[i]) {
      case 'j':
        text += fmt::format("-> {}", static_cast<std::int64_t>(pc) + 1 + offset_of(instr));
        break;
      case 'i':
        text += std::to_string(static_cast<std::int16_t>(values[i]));
        break;
      case 'k':
      case 'K':
        text += fmt::format("#{}", values[i]);
        break;
      default:
        text += fmt::format("r{}", values[i]);
    }
  }
  return text;
}

// What a table index stands for.
std::string meaning(const CompiledProgram& program, const FunctionCode& function,
                    const Instr& instr) {
  switch (instr.op) {
    case OpCode::CALL:
    case OpCode::CALLPLAIN:
    case OpCode::EXPANDED:
      return program.functions[instr.b].name;
    case OpCode::CLOSURE:
      return program.functions[instr.c].name;
    case OpCode::CALLN:
      return std::string(program.natives[instr.b]->name);
    case OpCode::CALLD1:
    case OpCode::CALLD2:
    case OpCode::CALLD3:
      return std::string(program.natives[instr.c]->name);
    case OpCode::ADDRK:
    case OpCode::MULRK:
    case OpCode::SCALE:
      return fmt::format("{}", function.constants[instr.c].d);
    case OpCode::WITHK:
      return fmt::format("{}", function.constants[instr.a].d);
    case OpCode::TEXT:
    case OpCode::TEXTREF:
    case OpCode::IFEQTK:
    case OpCode::IFNETK:
    case OpCode::IFEQTK_LOOP:
    case OpCode::IFNETK_LOOP:
      return fmt::format("\"{}\"", program.texts[instr.b]);
    case OpCode::CONST:
      return fmt::format("{} or {}", function.constants[instr.b].d, function.constants[instr.b].i);
    default:
      return {};
  }
}

std::string line_text(const CompiledProgram& program, Span span) {
  const Source& source = (*program.sources)[span.source];
  const int line = source.position(span.begin).line;
  const std::string_view text = source.line(line);
  const std::size_t first = text.find_first_not_of(" \t");
  const bool imported = span.source != 0;
  return fmt::format("  {}{}line {}: {}\n", imported ? source.name() : "", imported ? " " : "",
                     line, first == std::string_view::npos ? "" : text.substr(first));
}

void append_function(const CompiledProgram& program, std::size_t index, std::string& out) {
  const FunctionCode& f = program.functions[index];
  out += fmt::format("function {} {}: {} parameters, {} registers, references r{} to r{}\n", index,
                     f.name.empty() ? "(program)" : f.name, f.parameters, f.registers,
                     f.references_begin, f.references_end);
  auto next_span = f.spans.begin();
  std::pair<std::uint32_t, int> shown_line;
  for (std::size_t pc = 0; pc < f.code.size(); ++pc) {
    for (; next_span != f.spans.end() && next_span->pc <= pc; ++next_span) {
      const std::pair line(next_span->span.source, program.sources->position(next_span->span).line);
      if (line != shown_line) out += line_text(program, next_span->span);
      shown_line = line;
    }
    const Instr& instr = f.code[pc];
    const std::string note = meaning(program, f, instr);
    const std::string operands = operands_text(instr, pc);
    out += fmt::format("{:6}  {:<10}{}{}{}\n", pc, info(instr.op).name, operands,
                       note.empty() ? "" : "   ; ", note);
  }
  for (const Handler& h : f.handlers) {
    out += fmt::format("        failures in {} to {} go on at {}{}\n", h.begin, h.end, h.handler,
                       h.is_finally ? " (finally)" : "");
  }
}

}  // namespace

std::string disassemble(const CompiledProgram& program) {
  std::string out;
  for (std::size_t i = 0; i < program.functions.size(); ++i) append_function(program, i, out);
  return out;
}

}  // namespace armlet::lang
