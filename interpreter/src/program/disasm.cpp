// Writes bytecode as text: one line per instruction, with the meaning of its operands and its line
// in the program.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "program/program.hpp"
#include "program/properties.hpp"

namespace armlet::lang {

namespace {

std::int32_t offset_of(const Instr& jump) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(jump.c) << 16U) | jump.b);
}

std::string operand_text(char letter, std::uint16_t value) {
  if (is_register(letter)) return fmt::format("r{}", value);
  if (letter == 'i') return std::to_string(static_cast<std::int16_t>(value));
  return fmt::format("#{}", value);
}

std::string operands_text(const Instr& instr, std::size_t pc) {
  const std::uint16_t values[] = {instr.a, instr.b, instr.c};
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const char letter = operand_of(instr.op, i);
    if (letter == '-') continue;
    if (!text.empty()) text += ", ";
    text += letter == 'j'
                ? fmt::format("-> {}", static_cast<std::int64_t>(pc) + 1 + offset_of(instr))
                : operand_text(letter, values[i]);
  }
  return text;
}

// Functions of other entries of the session have no name here.
std::string function_name(const CompiledProgram& program, std::uint32_t number) {
  if (!program.entry.is_one) return program.functions[number].name;
  const auto found = std::ranges::find_if(
      program.functions, [&](const FunctionCode& code) { return code.function->index == number; });
  return found == program.functions.end() ? std::string() : found->name;
}

// The entry of a table that an operand refers to, as text. `letter` is the kind of the operand in
// bytecode.def.
std::string meaning(const CompiledProgram& program, const FunctionCode& function, char letter,
                    std::uint16_t index) {
  if (letter == 'f') return function_name(program, index);
  if (letter == 'n') return std::string(program.natives[index]->name);
  if (letter == 'c') return fmt::format("{}", function.constants[index].d);
  if (letter == 't') return fmt::format("\"{}\"", program.texts[index]);
  if (letter != 'C') return {};
  return fmt::format("{} or {}", function.constants[index].d, function.constants[index].i);
}

std::string meaning(const CompiledProgram& program, const FunctionCode& function,
                    const Instr& instr) {
  const std::uint16_t values[] = {instr.a, instr.b, instr.c};
  std::string text;
  for (std::size_t i = 0; i < 3 && text.empty(); ++i) {
    text = meaning(program, function, operand_of(instr.op, i), values[i]);
  }
  return text;
}

std::string line_text(const CompiledProgram& program, Span span) {
  const Source& source = (*program.sources)[span.source];
  const int line = source.position(span.begin).line;
  const std::string_view text = source.line(line);
  const std::size_t first = text.find_first_not_of(" \t");
  const bool imported = span.source != program.sources->first();
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
    out += fmt::format("{:6}  {:<10}{}{}{}\n", pc, properties_of(instr.op).name, operands,
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
