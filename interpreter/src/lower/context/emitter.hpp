#pragma once
// The emitter makes the bytecode of one function: registers, labels, constants, and the spans of
// the text that instructions belong to.
//
// While code is made, registers are virtual: each has a class, and each class has its own numbers.
// `finish` lays the classes out one after the other: parameters, references, pinned numbers,
// numbers. Numbers come last, so that the window of a call, which consists of the topmost numbers,
// lies above all live registers.

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "lower/optimise/flow.hpp"
#include "program/wide.hpp"

namespace armlet::lang {

struct Label {
  std::uint32_t id;
};

// Thrown for a program that is too large for the bytecode; `lower` catches it and reports it.
struct TooLarge {
  Span span;
  const char* what;  // "variables and temporaries in one function"
  std::uint32_t limit;
};

class Emitter {
 public:
  explicit Emitter(Span span);

  // ---- registers ----
  struct Mark {
    std::uint32_t references;
    std::uint32_t numbers;
  };
  Reg parameter(std::uint32_t number) const { return Reg::make(RegClass::kParameter, number); }
  Reg number();     // a new topmost number
  Reg reference();  // null, or owned by this frame
  Reg pinned();     // a number for the rest of the function, outside of windows
  // A register with a constant that is loaded once, at the start of the function. Returns false if
  // there are too many of them.
  bool pinned_constant(Slot value, Reg& out);
  [[nodiscard]] Mark mark() const { return {references_, numbers_}; }
  [[nodiscard]] bool is_top(Reg reg) const;
  // Frees the registers above the mark. Code is emitted that releases the references which they may
  // own.
  void release(Mark mark);
  // Frees the numbers above the mark only.
  void release_numbers(Mark mark) { numbers_ = mark.numbers; }
  // Marks whether a register owns a reference. One that no longer does is not released.
  void set_owned(Reg reference, bool owned);
  void set_parameters(std::uint32_t count) { parameters_ = count; }

  // ---- code ----
  // Sets the span and the expression that the next instructions belong to.
  void at(Span span, const hir::Expr* expr = nullptr) {
    span_ = span;
    expr_ = expr;
  }
  // Whether the last instruction is `reg = reg + 1` and no jump leads to the next one.
  [[nodiscard]] bool just_counted(Reg reg) const;
  // Emits a comparison of ints and a branch, a < b or a >= b. An increment just before becomes part
  // of the same instruction.
  void count_and_compare(bool less, Reg a, Reg b);
  void emit(OpCode op, Reg a, Reg b, Reg c) { push(op, a.bits, b.bits, c.bits); }
  void emit(OpCode op, Reg a, Reg b) { push(op, a.bits, b.bits, 0); }
  void emit(OpCode op, Reg a) { push(op, a.bits, 0, 0); }
  void emit(OpCode op) { push(op, 0, 0, 0); }
  // Emits an instruction whose operands are given as numbers: indices, small constants, or the bits
  // of registers.
  void push(OpCode op, std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void word(std::uint32_t b) { push(OpCode::TYPE, 0, b, 0); }
  void constant(Reg to, Slot value);
  // Emits ADDRK or MULRK, with a constant as the right operand.
  void with_constant(OpCode op, Reg to, Reg left, Slot right) {
    push(op, to.bits, left.bits, index_of(right));
  }

  // Changes the last instruction from `reg = x * k` to `reg = x * k + offset`; returns false if it
  // is another one.
  [[nodiscard]] bool scale_and_offset(Reg reg, Slot offset);
  // Lets the last instruction, if it computes `result`, write to the first parameter, where the
  // result of a function belongs. Returns the register that then has the result.
  [[nodiscard]] Reg moved_to_first(Reg result);

  // ---- labels ----
  Label label();
  void bind(Label label);
  // Binds a label at the top of a loop, which later code jumps to; `reachable`: the loop can be
  // entered.
  void bind_loop(Label label, bool reachable);
  void jump(Label to);                       // LOOP if the label is already bound
  void jump_if(OpCode op, Reg a, Label to);  // JT, JF; forward only
  // Jumps to targets[value - lowest], or to `otherwise` outside of the table.
  void switch_on(Reg value, std::int64_t lowest, const std::vector<Label>& targets,
                 Label otherwise);
  // Removes the last instruction if it jumps to the label, which is bound here next.
  void drop_jump(Label to);
  [[nodiscard]] bool is_bound(Label label) const { return labels_[label.id].position != kUnbound; }
  [[nodiscard]] bool reachable() const { return reachable_; }
  [[nodiscard]] std::uint32_t position() const { return static_cast<std::uint32_t>(code_.size()); }

  // ---- tables ----
  // begin_handler: failures in [begin, end) continue at the current position, where a handler
  // starts.
  struct Range {
    std::uint32_t begin;
    std::uint32_t end;
  };
  void begin_handler(const std::vector<Range>& ranges, bool is_finally);
  // The code from `begin` to the current position runs while a failure, kept in `held`, leaves the
  // block.
  void finally_code(std::uint32_t begin, Reg held) { finals_.push_back({begin, position(), held}); }
  void loop(Range range, Reg counter, std::int64_t first, std::int64_t step, std::uint32_t line);
  // The code of an inlined function.
  void expanded(Range range, std::uint32_t function, Span call) {
    expanded_.push_back({range.begin, range.end, function, call});
  }
  // A variable that debuggers can show.
  void seen(const hir::Variable& variable, Reg reg, Span scope, Range range) {
    seen_.push_back({&variable, reg, scope, range});
  }
  std::uint32_t type(const Type* type);
  void shown(std::uint32_t assert_index, std::vector<Reg> registers);

  // Runs the passes of optimise/, once all instructions are emitted.
  void improve();
  // Replaces registers by their final numbers and labels by offsets, also in the tables of asserts.
  void finish(FunctionCode& into, CompiledProgram& program);

 private:
  static constexpr std::uint32_t kUnbound = WideInstr::kNoLabel;
  struct LabelInfo {
    std::uint32_t position = kUnbound;
    bool used = false;
  };
  struct Shown {
    std::uint32_t assert_index;
    std::vector<Reg> registers;
  };
  struct WideFinally {
    std::uint32_t begin;
    std::uint32_t end;
    Reg held;
  };
  struct WideSeen {
    const hir::Variable* variable;
    Reg reg;
    Span scope;
    Range range;
  };
  struct WideLoop {
    Range range;
    Reg counter;
    std::int64_t first;
    std::int64_t step;
    std::uint32_t line;
  };

  void branch(OpCode op, std::uint32_t a, Label to);
  std::uint32_t index_of(Slot constant);
  [[nodiscard]] std::uint16_t place(Reg reg) const;
  [[nodiscard]] Instr narrow(const WideInstr& wide, std::uint32_t pc) const;
  [[nodiscard]] CodeShape shape() const;
  void edit(const Edits& edits);
  void relocate(const std::vector<std::uint32_t>& moved,
                const std::vector<std::uint32_t>& moved_loops);
  void add_prologue();
  void fill_tables(FunctionCode& into, std::uint32_t shift) const;
  void check_limits() const;

  std::vector<WideInstr> code_;
  std::vector<WideInstr> prologue_;
  std::vector<LabelInfo> labels_;
  std::vector<bool> owned_;  // by reference register: may own a count now
  std::map<std::int64_t, std::uint32_t> pinned_constants_;
  std::vector<Handler> handlers_;
  std::vector<WideFinally> finals_;
  std::vector<WideLoop> loops_;
  std::vector<ExpandedCall> expanded_;
  std::vector<WideSeen> seen_;
  std::vector<const Type*> types_;
  std::unordered_map<const Type*, std::uint32_t> type_index_;
  std::vector<Slot> constants_;
  std::map<std::int64_t, std::uint32_t> constant_index_;
  std::vector<Shown> shown_;
  Span whole_;
  Span span_;
  const hir::Expr* expr_ = nullptr;
  std::uint32_t parameters_ = 0;
  std::uint32_t references_ = 0;
  std::uint32_t most_references_ = 0;
  std::uint32_t pinned_ = 0;
  std::uint32_t last_target_ = 0;  // the last position that a jump leads to
  std::uint32_t numbers_ = 0;
  std::uint32_t most_numbers_ = 0;
  bool reachable_ = true;
};

}  // namespace armlet::lang
