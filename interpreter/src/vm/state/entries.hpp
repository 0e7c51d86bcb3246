#pragma once
// One machine runs the entries of a session one after the other. Each brings code and tables of its
// own, found through its functions; what all share are the numbers of functions and variables.

#include <cstdint>
#include <memory>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "vm/state/task.hpp"

namespace armlet::lang {

struct VmState;

// The code of one program in one machine.
struct LoadedCode {
  const CompiledProgram* program;
  std::vector<Callee> callees;  // of its functions, in their order; frames refer to them
  std::vector<Slot> texts;      // literals
};

// Wishes to stop: where they were noticed, and where a run that is repeated has to notice them.
struct Cancellations {
  std::vector<Cancellation> noticed;
  std::vector<Cancellation> due;  // the next one last
  std::uint32_t refusals = 0;     // of the host to let time pass
};

struct GlobalInfo {
  const hir::Variable* variable = nullptr;  // declared last with this number; null: none was
  [[nodiscard]] bool is_reference() const {
    return variable != nullptr && variable->type->is_reference();
  }
};

// What an entry changes, as it was when it began.
class Before {
 public:
  explicit Before(VmState& state);
  ~Before();
  Before(const Before&) = delete;
  Before& operator=(const Before&) = delete;

  // A variable of an earlier entry, which is about to change for the first time.
  void keep(std::uint32_t number);
  // The variables of the entry itself are not kept: they go with it.
  void pass_over(const CompiledProgram& entry);
  // A column that the entry has made of a table: it takes no work the next time.
  void note_column(RecordObj& table, std::uint16_t column);
  // The function that had a number which the entry takes.
  void note(std::uint32_t number, const Callee& replaced) {
    replaced_.push_back({number, replaced});
  }
  // All that had been counted.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  // Gives everything back.
  void restore();

 private:
  void release();

  struct Variable {
    std::uint32_t number;
    GlobalInfo info;
    std::uint8_t is_set;
    Slot value;  // counted, if it is a reference
  };
  struct Replaced {
    std::uint32_t number;
    Callee callee;
  };

  // What a watch remembers of its condition and its beats.
  struct WatchMemory {
    bool was_true;
    bool has_failed;
    std::int64_t next_ns;
  };
  struct Column {
    RecordObj* table;  // counted
    std::uint16_t column;
  };

  VmState& state_;
  std::vector<Variable> variables_;
  std::vector<Column> columns_;
  const CompiledProgram* own_ = nullptr;  // the entry
  std::vector<Replaced> replaced_;
  std::vector<WatchMemory> watches_;  // of earlier entries, in their order
  std::size_t layouts_;
  std::shared_ptr<const void> host_data_;
  Random random_;
  std::uint64_t parallels_;
  std::uint64_t steps_;
  std::uint64_t work_;  // that has not made a whole step
  std::uint64_t statements_;
  Cancellations cancellations_;
};

// A function of a program, with the objects of its texts; `own` is still to be set.
[[nodiscard]] Callee callee_of(const CompiledProgram& program, const FunctionCode& function,
                               const Slot* texts);
// Adds the code of a program; its texts are made by make_texts. before: null if it is no entry.
void load(VmState& state, const CompiledProgram& program, Before* before);
// Makes the objects of the literals of the newest unit. False: the heap is full, which is raised.
[[nodiscard]] bool make_texts(VmState& state);
// The newest entry is over.
void finish_entry(VmState& state, bool done);

}  // namespace armlet::lang
