// Compiles whole functions and the whole program to bytecode.

#include "lower/lower.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "base/cancelled.hpp"
#include "lower/context/lowering.hpp"
#include "lower/inlining.hpp"
#include "lower/optimise/hand_over.hpp"
#include "lower/statements.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

namespace {

// A running function keeps its closure alive, and the closure its captured values, so the function
// borrows them. A shared variable is captured as its box.
void load_captures(Lowering& in, FunctionCode& into) {
  const Seq<Capture> captures = in.function.captures;
  into.captures = static_cast<std::uint16_t>(captures.size());
  for (std::uint16_t i = 0; i < captures.size(); ++i) {
    const Variable& inner = *captures[i].inner;
    const bool boxed = inner.storage == Storage::kBoxed;
    if (boxed || inner.type->is_reference()) into.capture_references.push_back(i);
    in.homes.give(inner, in.code.number());
    in.code.push(OpCode::CAPTURE, in.homes.of(inner).bits, i, 0);
  }
}

void start(Lowering& in, FunctionCode& into) {
  const Function& function = in.function;
  into.name = function.name;
  into.span = function.span;
  into.function = &function;
  into.has_markers = in.options.markers;
  into.may_give_unset = function.result != nullptr && may_hold_unset(in, *function.result);
  in.code.set_parameters(static_cast<std::uint32_t>(function.parameters.size()));
  for (std::uint32_t i = 0; i < function.parameters.size(); ++i) {
    const Variable& parameter = *function.parameters[i];
    const Reg reg = in.code.parameter(i);
    if (in.options.optimise && parameter.adopted) {
      in.homes.give(parameter, in.code.reference());
      in.code.emit(OpCode::ADOPT, in.homes.of(parameter), reg);
    } else if (parameter.storage == Storage::kLocal) {
      in.homes.give(parameter, reg);
    } else {
      init_from(in, parameter, reg);
    }
  }
  load_captures(in, into);
}

void finish(Lowering& in, FunctionCode& into) {
  const Function& function = in.function;
  in.code.at(function.span);
  if (in.code.reachable()) {
    const bool has_result = function.result != nullptr && !function.result->is(Kind::kVoid);
    if (has_result && !in.is_program()) {
      throw std::logic_error("a function can end without a result");
    }
    in.code.emit(in.is_program() ? OpCode::HALT : OpCode::RETVOID);
  }
  if (in.options.optimise) in.code.improve();
  if (in.options.markers) {
    in.homes.close({0, 0}, function.span, in.code.position());
    for (const Homes::Given& each : in.homes.given()) {
      if (!each.variable->name.empty())
        in.code.seen(*each.variable, each.reg, each.scope, {each.begin, each.end});
    }
  }
  in.code.finish(into, in.tables.program());
}

constexpr std::uint32_t kMostInAll = 1U << 22U;

// Selects faster call instructions for functions without reference registers: their frames need not
// be cleared nor released.
void choose_plain_calls(CompiledProgram& program) {
  const auto is_plain = [](const FunctionCode& f) {
    return f.references_begin == f.references_end;
  };
  for (FunctionCode& function : program.functions) {
    for (Instr& instr : function.code) {
      // A later entry of the session may replace the function by one that needs an ordinary call.
      if (instr.op == OpCode::CALL && !program.entry.is_one &&
          is_plain(program.functions[instr.b])) {
        instr.op = OpCode::CALLPLAIN;
      }
      const bool just_computed = instr.op == OpCode::RET_A;
      if ((instr.op == OpCode::RET || just_computed) && is_plain(function)) {
        instr.op = instr.a != 0 || function.parameters == 0 ? OpCode::RETPLAIN
                   : just_computed                          ? OpCode::RETHERE_A
                                                            : OpCode::RETHERE;
      }
    }
  }
}

void lower_all(CompiledProgram& program, LowerOptions options) {
  const Module& module = program.module;
  const auto too_many = [](const auto* item) { return item->index >= UINT16_MAX; };
  if (std::ranges::any_of(module.functions, too_many)) {
    throw TooLarge{module.main->span, "functions", UINT16_MAX - 1};
  }
  if (std::ranges::any_of(module.globals, too_many)) {
    throw TooLarge{module.main->span, "variables of the program", UINT16_MAX};
  }
  program.unset = program.entry.is_one ? UnsetElements::anything() : UnsetElements(module.unset);
  Tables tables(program);
  // Later entries may replace functions of an entry, so calls of them are not inlined.
  if (options.optimise && !program.entry.is_one) tables.inline_calls(inlined_functions(module));
  if (options.optimise) mark_adopted_parameters(module);
  std::size_t instructions = 0;
  program.functions.reserve(module.functions.size());
  for (const Function* function : module.functions) {
    stop_if(options.cancelled);
    FunctionCode& code = program.functions.emplace_back();
    Lowering lowering(tables, *function, options);
    start(lowering, code);
    block(lowering, *function->body);
    finish(lowering, code);
    instructions += code.code.size();
    if (instructions > kMostInAll) {
      throw TooLarge{module.main->span, "instructions", kMostInAll};
    }
  }
  if (options.optimise) choose_plain_calls(program);
  tables.finish();
}

}  // namespace

Lowered lower(CheckedProgram checked, LowerOptions options, std::shared_ptr<const Program> after) {
  Lowered out;
  out.program = std::make_unique<Program::Code>(std::move(checked), std::move(after));
  try {
    lower_all(*out.program, options);
  } catch (const TooLarge& limit) {
    const std::string most = std::to_string(limit.limit);
    out.too_large = make_diagnostic("E0124", limit.span, {"more than " + most + " " + limit.what});
  }
  return out;
}

}  // namespace armlet::lang
