// Functions as a whole, and the program.

#include "compile/lower/lower.hpp"

#include <stdexcept>
#include <string>

#include "compile/cancelled.hpp"
#include "compile/lower/hand_over.hpp"
#include "compile/lower/lowering.hpp"
#include "compile/optimise/inlining.hpp"

namespace armlet::lang {

using namespace hir;

Lowering::Lowering(Tables& tables, const Function& function, LowerOptions options)
    : tables_(tables),
      function_(function),
      options_(options),
      code_(function.span),
      is_program_(&function == tables.program().module.main) {}

void Lowering::function(FunctionCode& into) {
  start(into);
  block(*function_.body);
  finish(into);
}

void Lowering::start(FunctionCode& into) {
  into.name = function_.name;
  into.span = function_.span;
  into.function = &function_;
  into.may_give_unset = function_.result != nullptr && may_hold_unset(*function_.result);
  code_.set_parameters(static_cast<std::uint32_t>(function_.parameters.size()));
  for (std::uint32_t i = 0; i < function_.parameters.size(); ++i) {
    Variable& parameter = *function_.parameters[i];
    const Reg reg = code_.parameter(i);
    if (tables_.adopts(parameter)) {
      parameter.index = code_.reference().bits;
      code_.emit(OpCode::ADOPT, reg_of(parameter), reg);
    } else if (parameter.storage == Storage::kLocal) {
      parameter.index = reg.bits;
    } else {
      init_from(parameter, reg);
    }
  }
  load_captures(into);
}

// The closure keeps what it captured alive while its function runs, so borrowing is enough. A
// variable that is shared is captured as its box.
void Lowering::load_captures(FunctionCode& into) {
  into.captures = static_cast<std::uint16_t>(function_.captures.size());
  for (std::uint16_t i = 0; i < function_.captures.size(); ++i) {
    Variable& inner = *function_.captures[i].inner;
    const bool boxed = inner.storage == Storage::kBoxed;
    if (boxed || inner.type->is_reference()) into.capture_references.push_back(i);
    inner.index = code_.number().bits;
    code_.push(OpCode::CAPTURE, inner.index, i, 0);
  }
}

void Lowering::finish(FunctionCode& into) {
  code_.at(function_.span);
  if (code_.reachable()) {
    const bool has_result = function_.result != nullptr && !function_.result->is(Kind::kVoid);
    if (has_result && !is_program_) throw std::logic_error("a function can end without a result");
    code_.emit(is_program_ ? OpCode::HALT : OpCode::RETVOID);
  }
  if (options_.optimise) code_.improve();
  code_.finish(into, tables_.program());
}

namespace {

constexpr std::uint32_t kMostInstructions = 1U << 22U;

// Frames without reference registers need no clearing and no releasing.
void choose_plain_calls(CompiledProgram& program) {
  const auto is_plain = [](const FunctionCode& f) {
    return f.references_begin == f.references_end;
  };
  for (FunctionCode& function : program.functions) {
    for (Instr& instr : function.code) {
      if (instr.op == OpCode::CALL && is_plain(program.functions[instr.b])) {
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
  if (module.functions.size() >= UINT16_MAX) {
    throw TooLarge{module.main->span, "functions", UINT16_MAX - 1};
  }
  if (module.global_count > UINT16_MAX) {
    throw TooLarge{module.main->span, "variables of the program", UINT16_MAX};
  }
  program.unset = UnsetElements(module.unset);
  Tables tables(program);
  if (options.optimise) {
    mark_inlined_functions(module);
    tables.adopt(adopted_parameters(module));
  }
  std::size_t instructions = 0;
  program.functions.resize(module.functions.size());
  for (const Function* function : module.functions) {
    stop_if(options.cancelled);
    FunctionCode& code = program.functions[function->index];
    Lowering(tables, *function, options).function(code);
    instructions += code.code.size();
    if (instructions > kMostInstructions) {
      throw TooLarge{module.main->span, "instructions", kMostInstructions};
    }
  }
  if (options.optimise) choose_plain_calls(program);
  for (const Variable* global : module.globals) {
    program.global_is_reference.push_back(global->type->is_reference());
  }
  tables.finish();
}

}  // namespace

std::optional<Diagnostic> lower(CompiledProgram& program, LowerOptions options) {
  try {
    lower_all(program, options);
    return std::nullopt;
  } catch (const TooLarge& limit) {
    const std::string most = std::to_string(limit.limit);
    return make_diagnostic("E0124", limit.span, {"more than " + most + " " + limit.what});
  }
}

}  // namespace armlet::lang
