#include "lower/context/emitter.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "lower/optimise/effects.hpp"

namespace armlet::lang {

namespace {

constexpr std::uint32_t kMostIndices = 0xFFFF;
constexpr std::uint32_t kMostInstructions = 1U << 20U;
constexpr std::size_t kMostPinnedConstants = 200;

}  // namespace

Emitter::Emitter(Span span) : whole_(span), span_(span) {}

// ---- registers

Reg Emitter::number() {
  const Reg reg = Reg::make(RegClass::kNumber, numbers_++);
  most_numbers_ = std::max(most_numbers_, numbers_);
  check_limits();
  return reg;
}

Reg Emitter::reference() {
  const Reg reg = Reg::make(RegClass::kReference, references_++);
  most_references_ = std::max(most_references_, references_);
  if (owned_.size() < references_) owned_.push_back(false);
  owned_[reg.number()] = true;
  check_limits();
  return reg;
}

Reg Emitter::pinned() {
  check_limits();
  return Reg::make(RegClass::kPinned, pinned_++);
}

bool Emitter::pinned_constant(Slot value, Reg& out) {
  const auto known = pinned_constants_.find(value.i);
  if (known != pinned_constants_.end()) {
    out = Reg::make(RegClass::kPinned, known->second);
    return true;
  }
  if (pinned_constants_.size() >= kMostPinnedConstants) return false;
  out = pinned();
  pinned_constants_.emplace(value.i, out.number());
  return true;
}

bool Emitter::is_top(Reg reg) const {
  return reg.reg_class() == RegClass::kNumber && reg.number() + 1 == numbers_;
}

void Emitter::release(Mark mark) {
  for (std::uint32_t i = references_; i-- > mark.references;) {
    if (owned_[i]) emit(OpCode::DROP, Reg::make(RegClass::kReference, i));
  }
  references_ = mark.references;
  numbers_ = mark.numbers;
}

void Emitter::set_owned(Reg reference, bool owned) { owned_[reference.number()] = owned; }

void Emitter::check_limits() const {
  if (parameters_ + references_ + pinned_ + numbers_ >= kMostIndices) {
    throw TooLarge{span_, "variables and temporaries in one function", kMostIndices};
  }
}

// ---- code

void Emitter::push(OpCode op, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (!reachable_) return;
  if (code_.size() >= kMostInstructions) {
    throw TooLarge{whole_, "instructions in one function", kMostInstructions};
  }
  const bool guarded = !code_.empty() && is_compare_and_branch(code_.back().op);
  code_.push_back({op, a, b, c, kUnbound, expr_, span_});
  if (ends_flow(op) && !guarded) reachable_ = false;
}

bool Emitter::just_counted(Reg reg) const {
  if (!reachable_ || code_.empty() || last_target_ == position()) return false;
  const WideInstr& last = code_.back();
  return last.op == OpCode::ADDIK && last.a == reg.bits && last.b == reg.bits && last.c == 1;
}

void Emitter::count_and_compare(bool less, Reg a, Reg b) {
  if (!just_counted(a)) {
    emit(less ? OpCode::IFLTI : OpCode::IFGEI, a, b);
    return;
  }
  WideInstr& last = code_.back();
  last.op = less ? OpCode::FORI : OpCode::FORX;
  last.b = b.bits;
  last.c = 0;
}

bool Emitter::scale_and_offset(Reg reg, Slot offset) {
  if (!reachable_ || code_.empty() || last_target_ == position()) return false;
  WideInstr& last = code_.back();
  if (last.op != OpCode::MULRK || last.a != reg.bits) return false;
  last.op = OpCode::SCALE;
  push(OpCode::WITHK, index_of(offset), 0, 0);
  return true;
}

Reg Emitter::moved_to_first(Reg result) {
  if (!reachable_ || code_.empty() || last_target_ == position()) return result;
  if (parameters_ == 0 || result.reg_class() != RegClass::kNumber) return result;
  const bool has_word = code_.size() > 1 && effects_of(code_, position() - 2).words == 2;
  const std::uint32_t at = position() - (has_word ? 2 : 1);
  const OpCode op = code_[at].op;
  // Calls of library functions of doubles write their result before they can fail.
  const bool asks_host = op >= OpCode::CALLD1 && op <= OpCode::CALLD3;
  const Effects effects = effects_of(code_, at);
  if (effects.effect != Effect::kPure || asks_host || code_[at].a != result.bits) return result;
  const Reg first = Reg::make(RegClass::kParameter, 0);
  code_[at].a = first.bits;
  return first;
}

void Emitter::constant(Reg to, Slot value) {
  if (value.i >= INT16_MIN && value.i <= INT16_MAX) {
    push(OpCode::INT, to.bits, static_cast<std::uint16_t>(value.i), 0);
    return;
  }
  push(OpCode::CONST, to.bits, index_of(value), 0);
}

std::uint32_t Emitter::index_of(Slot constant) {
  const auto [known, is_new] =
      constant_index_.emplace(constant.i, static_cast<std::uint32_t>(constants_.size()));
  if (is_new) {
    if (constants_.size() >= kMostIndices) {
      throw TooLarge{span_, "different numbers in one function", kMostIndices};
    }
    constants_.push_back(constant);
  }
  return known->second;
}

// ---- labels

Label Emitter::label() {
  labels_.emplace_back();
  return {static_cast<std::uint32_t>(labels_.size() - 1)};
}

void Emitter::bind(Label label) {
  LabelInfo& info = labels_[label.id];
  info.position = position();
  if (!info.used) return;
  reachable_ = true;
  last_target_ = position();
}

void Emitter::bind_loop(Label label, bool reachable) {
  labels_[label.id].position = position();
  reachable_ = reachable;
  last_target_ = position();
}

void Emitter::jump(Label to) { branch(is_bound(to) ? OpCode::LOOP : OpCode::JUMP, 0, to); }

void Emitter::jump_if(OpCode op, Reg a, Label to) { branch(op, a.bits, to); }

void Emitter::drop_jump(Label to) {
  if (reachable_ || code_.empty() || last_target_ == position()) return;
  const WideInstr& last = code_.back();
  const bool guarded = code_.size() > 1 && is_compare_and_branch(code_[code_.size() - 2].op);
  if (last.op != OpCode::JUMP || last.label != to.id || guarded) return;
  code_.pop_back();
  reachable_ = true;
}

void Emitter::switch_on(Reg value, std::int64_t lowest, const std::vector<Label>& targets,
                        Label otherwise) {
  if (!reachable_) return;
  push(OpCode::SWITCH, value.bits, static_cast<std::uint16_t>(lowest),
       static_cast<std::uint32_t>(targets.size()));
  const auto jump_word = [this](Label to) {
    labels_[to.id].used = true;
    code_.push_back({OpCode::JUMP, 0, 0, 0, to.id, expr_, span_});
  };
  jump_word(otherwise);
  for (const Label target : targets) jump_word(target);
}

void Emitter::branch(OpCode op, std::uint32_t a, Label to) {
  if (!reachable_) return;
  labels_[to.id].used = true;
  push(op, a, 0, 0);
  code_.back().label = to.id;
}

// ---- tables

void Emitter::begin_handler(const std::vector<Range>& ranges, bool is_finally) {
  for (const Range& range : ranges) {
    if (range.begin == range.end) continue;
    handlers_.push_back({range.begin, range.end, position(), is_finally});
    reachable_ = true;
    last_target_ = position();
  }
}

void Emitter::loop(Range range, Reg counter, std::int64_t first, std::int64_t step,
                   std::uint32_t line) {
  loops_.push_back({range, counter, first, step, line});
}

std::uint32_t Emitter::type(const Type* type) {
  const auto [known, is_new] = type_index_.emplace(type, static_cast<std::uint32_t>(types_.size()));
  if (!is_new) return known->second;
  if (types_.size() >= kMostIndices) throw TooLarge{span_, "types in one function", kMostIndices};
  types_.push_back(type);
  return known->second;
}

void Emitter::shown(std::uint32_t assert_index, std::vector<Reg> registers) {
  shown_.push_back({assert_index, std::move(registers)});
}

// ---- the end

std::uint16_t Emitter::place(Reg reg) const {
  std::uint32_t at = reg.number();
  switch (reg.reg_class()) {
    case RegClass::kNumber:
      at += pinned_;
      [[fallthrough]];
    case RegClass::kPinned:
      at += most_references_;
      [[fallthrough]];
    case RegClass::kReference:
      at += parameters_;
      [[fallthrough]];
    case RegClass::kParameter:
      break;
  }
  return static_cast<std::uint16_t>(at);
}

Instr Emitter::narrow(const WideInstr& wide, std::uint32_t pc) const {
  const auto operand = [&](std::size_t i, std::uint32_t value) {
    if (operand_of(wide.op, i) == '-') return std::uint16_t{0};
    return is_register(operand_of(wide.op, i)) ? place(Reg{value})
                                               : static_cast<std::uint16_t>(value);
  };
  Instr instr{wide.op, operand(0, wide.a), operand(1, wide.b), operand(2, wide.c)};
  if (wide.label != kUnbound) {
    const std::uint32_t target =
        labels_[wide.label].position + static_cast<std::uint32_t>(prologue_.size());
    const std::uint32_t offset = target - (pc + 1);
    instr.b = static_cast<std::uint16_t>(offset);
    instr.c = static_cast<std::uint16_t>(offset >> 16U);
  }
  return instr;
}

// Constants of the whole function are loaded before its first instruction.
void Emitter::add_prologue() {
  std::vector<WideInstr> body;
  std::swap(body, code_);
  reachable_ = true;
  at(whole_);
  for (const auto& [value, number] : pinned_constants_) {
    constant(Reg::make(RegClass::kPinned, number), Slot{.i = value});
  }
  std::swap(prologue_, code_);
  std::swap(body, code_);
}

void Emitter::fill_tables(FunctionCode& into, std::uint32_t shift) const {
  into.parameters = static_cast<std::uint16_t>(parameters_);
  into.references_begin = into.parameters;
  into.references_end = static_cast<std::uint16_t>(parameters_ + most_references_);
  into.registers =
      static_cast<std::uint16_t>(parameters_ + most_references_ + pinned_ + most_numbers_);
  into.constants = constants_;
  into.types = types_;
  for (const Handler& h : handlers_) {
    into.handlers.push_back({h.begin + shift, h.end + shift, h.handler + shift, h.is_finally});
  }
  for (const ExpandedCall& call : expanded_) {
    into.expanded.push_back({call.begin + shift, call.end + shift, call.function, call.call});
  }
  for (const WideFinally& f : finals_) {
    into.finals.push_back({f.begin + shift, f.end + shift, place(f.held)});
  }
  for (const WideSeen& s : seen_) {
    into.scopes.push_back(
        {s.variable, place(s.reg), s.scope, s.range.begin + shift, s.range.end + shift});
  }
  for (const WideLoop& l : loops_) {
    into.loops.push_back(
        {l.range.begin + shift, l.range.end + shift, place(l.counter), l.first, l.step, l.line});
  }
}

// Branches that jump backward count a step each, and need other instructions than forward branches.
// The directions are known once all labels are bound.
static void tell_loops_apart(std::vector<Instr>& code) {
  for (std::size_t i = 0; i + 1 < code.size(); ++i) {
    OpCode& op = code[i].op;
    if (is_compare_and_branch(op) && code[i + 1].op == OpCode::LOOP) {
      op = variant_of(Variant::kBeforeLoop, op);
    }
  }
}

// Finds loops whose body is one instruction followed by the instruction that counts up and jumps
// back.
static void find_loops_of_one(std::vector<Instr>& code) {
  for (std::size_t i = 0; i + 3 < code.size(); ++i) {
    const OpCode variant = variant_of(Variant::kEach, code[i].op);
    if (variant == kNoVariant) continue;
    // The accumulated sum is named in the next word.
    if (operand_of(variant, 0) == 'd' && code[i].a != code[i + 1].a) continue;
    std::size_t words = 1;
    while (is_operand_word(code[i + words].op)) ++words;
    if (i + words + 1 >= code.size()) continue;
    const Instr& loop = code[i + words];
    const bool by_one = loop.op == OpCode::FORLE_LOOP || loop.op == OpCode::FORLEK_LOOP;
    const bool counts_up = loop.op == OpCode::FORI_LOOP || loop.op == OpCode::FORBYLT_LOOP ||
                           loop.op == OpCode::FORBYLTK_LOOP || (by_one && loop.c == 1);
    const Instr& back = code[i + words + 1];
    const auto offset = static_cast<std::int32_t>(std::uint32_t{back.c} << 16U | back.b);
    if (counts_up && offset == -static_cast<std::int32_t>(words + 2)) code[i].op = variant;
  }
}

void Emitter::finish(FunctionCode& into, CompiledProgram& program) {
  if (parameters_ + most_references_ + pinned_ + most_numbers_ >= kMostIndices) {
    throw TooLarge{whole_, "variables and temporaries in one function", kMostIndices};
  }
  add_prologue();
  const auto shift = static_cast<std::uint32_t>(prologue_.size());
  into.code.reserve(prologue_.size() + code_.size());
  for (const std::vector<WideInstr>* part : {&std::as_const(prologue_), &std::as_const(code_)}) {
    for (const WideInstr& wide : *part) {
      const auto pc = static_cast<std::uint32_t>(into.code.size());
      into.code.push_back(narrow(wide, pc));
      if (into.spans.empty() || into.spans.back().span != wide.span ||
          into.spans.back().expr != wide.expr) {
        into.spans.push_back({pc, wide.span, wide.expr});
      }
    }
  }
  tell_loops_apart(into.code);
  find_loops_of_one(into.code);
  fill_tables(into, shift);
  for (const Shown& shown : shown_) {
    for (const Reg reg : shown.registers) {
      program.noted->asserts[shown.assert_index].registers.push_back(place(reg));
    }
  }
}

}  // namespace armlet::lang
