#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

void set_window(Effects& effects, std::uint32_t first, std::uint32_t reads) {
  effects.has_window = true;
  effects.window = Reg{first};
  effects.window_reads = reads;
}

void find_window(Effects& effects, WindowKind window, const WideInstr& instr) {
  switch (window) {
    case WindowKind::kNone:
      break;
    case WindowKind::kArguments:
      set_window(effects, instr.a, instr.c == 0 ? Effects::kAll : instr.c - 1);
      break;
    case WindowKind::kCounted:
      set_window(effects, instr.b, instr.c);
      break;
    case WindowKind::kOpen:
      set_window(effects, instr.b, Effects::kAll);
      break;
    case WindowKind::kPair:
      set_window(effects, instr.c, 2);
      break;
  }
}

}  // namespace

Effects effects_of(const std::vector<WideInstr>& code, std::uint32_t at) {
  const WideInstr& instr = code[at];
  const Properties& properties = properties_of(instr.op);
  Effects effects;
  effects.effect = properties.effect;
  effects.defines = properties.defines;
  effects.reads_first = properties.reads_first;
  effects.empties = properties.empties;
  if (properties.flow == ControlFlow::kTest) ++effects.words;
  if (instr.op == OpCode::SWITCH) effects.words += instr.c + 1;
  while (at + effects.words < code.size() && is_operand_word(code[at + effects.words].op)) {
    ++effects.words;
  }
  find_window(effects, properties.window, instr);
  // The instruction clears a row of reference registers.
  if (properties.window == WindowKind::kCounted && effects.window.is_reference()) {
    effects.effect = Effect::kUnknown;
    effects.has_window = false;
  }
  effects.has_fixed = properties.has_fixed;
  if (effects.has_fixed) effects.fixed = Reg{instr.b};
  return effects;
}

bool reads_register(const std::vector<WideInstr>& code, std::uint32_t at, const Effects& effects,
                    std::uint32_t bits) {
  bool reads = effects.effect == Effect::kUnknown || effects.reads_in_window(bits) ||
               (effects.has_fixed && effects.fixed.bits == bits) ||
               (effects.effect == Effect::kUpdate && code[at].a == bits);
  for_each_read(code, at, effects, [&](std::uint32_t read) { reads = reads || read == bits; });
  return reads;
}

}  // namespace armlet::lang
