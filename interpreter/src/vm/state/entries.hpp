#pragma once
// A virtual machine runs the entries of a session one after the other. Each entry has code and
// tables of its own, which its functions refer to; all entries share the numbers of functions and
// global variables.

#include <cstdint>
#include <memory>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "vm/state/task.hpp"

namespace armlet::lang {

struct VmState;

// The code of one program, loaded into a virtual machine.
struct LoadedCode {
  const CompiledProgram* program;
  std::vector<Callee> callees;  // of its functions, in their order; frames refer to these
  std::vector<Slot> texts;      // literals
};

// The stop requests of a run: when each took effect, and for a replay the instants at which each
// has to take effect.
struct Cancellations {
  std::vector<Cancellation> noticed;
  std::vector<Cancellation> due;  // in reverse order: the next one is last
  std::uint32_t refusals = 0;     // how often the host refused to let time pass
};

struct GlobalInfo {
  const hir::Variable* variable = nullptr;  // the last declared with this number; null: none
  [[nodiscard]] bool is_reference() const {
    return variable != nullptr && variable->type->is_reference();
  }
};

// The state before the entry of a session that is running, so that an entry that fails can be
// undone.
class Before {
 public:
  explicit Before(VmState& state);
  ~Before();
  Before(const Before&) = delete;
  Before& operator=(const Before&) = delete;

  // Keeps the value of a variable of an earlier entry before its first change.
  void keep(std::uint32_t number);
  // Variables of the entry itself need not be kept, because they are removed with it.
  void pass_over(const CompiledProgram& entry);
  // Notes that the entry has made a column of a table. The column stays, so that computing it again
  // counts no steps.
  void note_column(RecordObj& table, std::uint16_t column);
  // Notes the function whose number a function of this entry takes.
  void note(std::uint32_t number, const Callee& replaced) {
    replaced_.push_back({number, replaced});
  }
  // The count of steps before the entry.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  // Restores the state before the entry.
  void restore();

 private:
  void release();

  struct Variable {
    std::uint32_t number;
    GlobalInfo info;
    std::uint8_t is_set;
    Slot value;  // its count is increased, if it is a reference
  };
  struct Replaced {
    std::uint32_t number;
    Callee callee;
  };

  // The state of a watch: its last condition, and its next beat.
  struct WatchMemory {
    bool was_true;
    bool has_failed;
    std::int64_t next_ns;
  };
  struct Column {
    RecordObj* table;  // its count is increased
    std::uint16_t column;
  };

  VmState& state_;
  std::vector<Variable> variables_;
  std::vector<Column> columns_;
  const CompiledProgram* own_ = nullptr;  // the program of the entry
  std::vector<Replaced> replaced_;
  std::vector<WatchMemory> watches_;  // of the watches of earlier entries, in their order
  std::size_t layouts_;
  std::shared_ptr<const void> host_data_;
  Random random_;
  std::uint64_t parallels_;
  std::uint64_t steps_;
  std::uint64_t work_;  // of kernels, less than one step
  std::uint64_t statements_;
  Cancellations cancellations_;
};

// A function of a program, with the objects of its texts; the caller sets `own`.
[[nodiscard]] Callee callee_of(const CompiledProgram& program, const FunctionCode& function,
                               const Slot* texts);
// Loads the code of a program, without the objects of its texts (make_texts). before: null if the
// program is not an entry.
void load(VmState& state, const CompiledProgram& program, Before* before);
// Makes the text objects of the newest program. Returns false, with the failure set, if the heap is
// full.
[[nodiscard]] bool make_texts(VmState& state);
// Ends the newest entry. done: false if it failed.
void finish_entry(VmState& state, bool done);

}  // namespace armlet::lang
