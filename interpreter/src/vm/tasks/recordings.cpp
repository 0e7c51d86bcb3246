#include "vm/tasks/recordings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/interpreter/virtual_time.hpp"
#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/values/durations.hpp"

namespace armlet::lang {

namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
RecordObj& table_in(Slot s) { return *static_cast<RecordObj*>(s.o); }

std::uint16_t column_count(const RecordObj& table) {
  return static_cast<std::uint16_t>(table.layout->size - 1);
}

// The slot of the rows. It follows those of the columns, which are made from the rows at their
// first use.
Slot& rows_of(RecordObj& table) { return table.fields()[column_count(table)]; }

bool append(VmState& state, RecordObj& table, Slot row) {
  Heap& heap = state.heap;
  Slot& rows = rows_of(table);
  if (!own(state, rows)) return false;
  auto& list = *static_cast<ListObj*>(rows.o);
  if (!reserve_list(heap, list, std::uint64_t{list.size} + 1)) return raise_out_of_memory(state);
  list.data[list.size++] = row;
  for (std::uint16_t i = 0; i < column_count(table); ++i) {
    heap.release(table.fields()[i].o);
    table.fields()[i].o = nullptr;
  }
  return true;
}

// ---- functions of the language ---------------------------------------------------------------

Signal start_recording(Vm& vm, Slot* args) {
  VmState& state = vm.state();
  const double period = args[1].d;
  std::int64_t period_ns = 1;
  const bool is_time = period * 1e9 >= 0.5;
  if (!(period <= 0.0 || (std::isfinite(period) && !is_time)) &&
      !check_time(state, {.what = "a period", .time = "the period", .part = CallPart::operand(1)},
                  period, period_ns))
    return Signal::kFail;
  if (!is_time) {
    Failure failure;
    failure.headline = Headline::own("R0609", "samples cannot be taken every " +
                                                  quantity_text(period, dims::kTime) +
                                                  ": the period must be at least 1 ns");
    failure.mark = CallPart::operand(1);
    raise(state, failure);
    return Signal::kFail;
  }
  if (state.recordings == nullptr) state.recordings = std::make_unique<Recordings>(state);
  return give(args, state.recordings->start(static_cast<ClosureObj*>(args[0].o), period_ns));
}

Signal end_recording(Vm& vm, Slot* args) {
  const bool ended = vm.state().recordings->end(&table_in(args[0]));
  return ended ? Signal::kDone : Signal::kFail;
}

// Makes a column of matrices. Returns null if it failed.
Obj* make_matrix(VmState& state, RecordObj& table, std::uint16_t column) {
  const auto& rows = *static_cast<ListObj*>(rows_of(table).o);
  const RecordField& field = table.layout->type->record->row->record->fields[column];
  const auto list_in = [&](std::size_t row) {
    return items_value(table_in(rows.data[row]).fields()[column]);
  };
  const std::size_t cols = list_in(0).size();  // the first sample always exists
  std::size_t other = rows.size;               // a row with another number of values
  const auto find_other = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (list_in(i).size() != cols) {
        other = i;
        return false;
      }
    }
    return true;
  };
  if (!in_blocks(state.vm, rows.size, 16, find_other)) {
    if (other == rows.size) return nullptr;
    const std::size_t i = other;
    Failure failure;
    failure.headline = Headline::own("R0613", "the column `" + field.name + "` has " +
                                                  std::to_string(list_in(i).size()) +
                                                  " values in row " + std::to_string(i) + " and " +
                                                  std::to_string(cols) + " in row 0");
    failure.why = "a column of lists is a matrix, whose rows are equally long";
    raise(state, failure);
    return nullptr;
  }
  MatrixObj* matrix = state.heap.new_matrix(rows.size, static_cast<std::uint32_t>(cols));
  if (matrix == nullptr) {
    raise_out_of_memory(state);
    return nullptr;
  }
  double* out = matrix->data();
  const bool is_int = field.type->element->is(Kind::kInt);
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const Slot item : list_in(i)) *out++ = is_int ? static_cast<double>(item.i) : item.d;
    }
  };
  const auto cost = static_cast<unsigned>(16 + 2 * std::min<std::size_t>(cols, 100'000'000));
  if (in_blocks(state.vm, rows.size, cost, fill)) return matrix;
  state.heap.release(matrix);
  return nullptr;
}

// Makes a column of the table. Returns null if it failed.
Obj* make_column(VmState& state, RecordObj& table, std::uint16_t column) {
  if (table.layout->type->record->fields[column].type->is(Kind::kMatrix))
    return make_matrix(state, table, column);
  const auto& rows = *static_cast<ListObj*>(rows_of(table).o);
  const Type* type = table.layout->type->record->row->record->fields[column].type;
  ListObj* list = state.heap.new_list(rows.size, type->is_reference());
  if (list == nullptr) {
    raise_out_of_memory(state);
    return nullptr;
  }
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      list->data[i] = table_in(rows.data[i]).fields()[column];
      if (type->is_reference()) retain_object(list->data[i].o);
    }
  };
  if (in_blocks(state.vm, rows.size, 16, copy)) return list;
  state.heap.release(list);
  return nullptr;
}

Signal table_column(Vm& vm, Slot* args) {
  RecordObj& table = table_in(args[0]);
  const auto column = static_cast<std::uint16_t>(args[1].i);
  Obj*& made = table.fields()[column].o;
  if (made == nullptr) {
    lang::VmState& state = vm.state();
    made = make_column(state, table, column);
    if (made == nullptr) return Signal::kFail;
    if (state.programs.before != nullptr) state.programs.before->note_column(table, column);
  }
  retain_object(made);
  return give(args, made);
}

Signal table_rows_of(Vm&, Slot* args) {
  Obj* rows = rows_of(table_in(args[0])).o;
  retain_object(rows);
  return give(args, rows);
}

Signal table_length(Vm&, Slot* args) {
  return give(args, static_cast<std::int64_t>(table_rows(args[0]).size()));
}

}  // namespace

const NativeFunction kStartRecording{.name = "record", .thunk = start_recording};
const NativeFunction kEndRecording{.name = "end of record", .thunk = end_recording};
const NativeFunction kTableColumn{.name = "column", .thunk = table_column};
const NativeFunction kTableRows{.name = "rows", .thunk = table_rows_of};
const NativeFunction kTableLength{.name = "length", .thunk = table_length};

Recordings::~Recordings() {
  for (const Recording& recording : recordings_) release(recording);
}

void Recordings::release(const Recording& recording) {
  state_.heap.release(recording.sample);
  state_.heap.release(recording.table);
}

bool Recordings::take(Recording& recording) {
  const std::int64_t now = state_.vm.timeline().now_ns();
  Slot row{.i = 0};
  const bool done = state_.evaluate(*recording.task, recording.sample, row);
  state_.count_pause();
  if (!done) return false;
  table_in(row).fields()[0].d = seconds_of(now);
  recording.last_ns = now;
  if (append(state_, *recording.table, row)) return true;
  state_.heap.release(row.o);
  return false;
}

RecordObj* Recordings::start(ClosureObj* sample, std::int64_t period_ns) {
  const Type* row = state_.programs.callees[sample->function].function->function->result;
  const RecordLayout& layout = state_.layout_of(row->record->table);
  RecordObj* table = state_.heap.new_record(layout);
  if (table == nullptr) {
    raise_out_of_memory(state_);
    return nullptr;
  }
  for (std::uint16_t i = 0; i < layout.size; ++i) table->fields()[i].o = nullptr;
  rows_of(*table).o = state_.heap.new_list(0, true);
  const std::int64_t now = state_.vm.timeline().now_ns();
  // A recording that a condition starts belongs to the task with the condition.
  const bool in_condition = state_.running == state_.condition_task.get();
  Task* owner = in_condition ? state_.running->origin.parent : state_.running;
  Recording recording{sample, table, owner, period_ns, now + period_ns, now, false};
  if (rows_of(*table).o == nullptr) raise_out_of_memory(state_);
  if (rows_of(*table).o == nullptr || !take(recording)) {
    state_.heap.release(table);
    return nullptr;
  }
  retain_object(sample);
  retain_object(table);
  recordings_.push_back(recording);
  return table;
}

bool Recordings::end(const RecordObj* table) {
  const auto found = std::ranges::find(recordings_, table, &Recording::table);
  if (found == recordings_.end()) return true;
  Recording recording = *found;
  recordings_.erase(found);
  const bool is_new = state_.vm.timeline().now_ns() > recording.last_ns && !recording.failed;
  const bool taken = !is_new || take(recording);
  release(recording);
  return taken;
}

std::int64_t Recordings::next_ns() const {
  std::int64_t next = kNever;
  if (state_.is_leaving) return next;  // nothing is recorded while the program stops
  for (const Recording& recording : recordings_) {
    if (!recording.failed) next = std::min(next, recording.next_ns);
  }
  return next;
}

void Recordings::take_due(const std::function<void(Task&)>& failed) {
  if (state_.is_leaving) return;  // tasks that began a recording may be gone
  const std::int64_t now = state_.vm.timeline().now_ns();
  for (Recording& recording : recordings_) {
    if (recording.failed || recording.next_ns > now) continue;
    recording.next_ns += recording.period_ns;
    if (take(recording)) continue;
    recording.failed = true;
    failed(*recording.task);
  }
}

}  // namespace armlet::lang
