#include "vm/state/state.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/host/frames.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/tasks/recordings.hpp"
#include "vm/tasks/tasks.hpp"

namespace armlet::lang {

// ---- steps ----------------------------------------------------------------------------------

bool StepMeter::refill() {
  settle();
  std::uint64_t most = std::min(kChunk, limit - std::min(limit, since_pause));
  // An operation that cannot be paused continues beyond the end of the slice.
  if (total < slice_end) most = std::min(most, slice_end - total);
  if (total < look_at) most = std::min(most, look_at - total);
  chunk = left = static_cast<std::int64_t>(most);
  return chunk > 0;
}

bool KernelWork::go_on(std::uint64_t operations) {
  rest_ += operations;
  const std::uint64_t steps = rest_ / kWorkPerStep;
  rest_ %= kWorkPerStep;
  return steps == 0 || charge_steps(vm_, steps);
}

// ---- making and clearing --------------------------------------------------------------------

VmState::VmState(Vm& owner, const CompiledProgram& compiled, const VmOptions& vm_options)
    : vm(owner),
      options(vm_options),
      programs{.newest = &compiled},
      heap(vm_options.limits.heap_bytes, vm_options.memory),
      kernels(owner),
      main(vm_options.limits.call_depth, ample_slots(vm_options.limits.call_depth)) {
  host.output_left = options.limits.output_bytes;
  steps.limit = host.aside.limit = options.limits.steps;
  running = &main;
  load(*this, compiled, nullptr);
  make_error_layout();
}

VmState::~VmState() {
  clear();
  assert(heap.used() == 0 && "every object was released");
}

void VmState::make_error_layout() {
  const Type* type = programs.newest->types->library_record("error");
  if (type == nullptr) return;
  auto layout = std::make_unique<RecordLayout>();
  auto references = std::make_unique<std::vector<std::uint16_t>>();
  const auto& fields = type->record->fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].type->is_reference()) references->push_back(static_cast<std::uint16_t>(i));
  }
  references->push_back(static_cast<std::uint16_t>(fields.size()));  // the hidden fault
  *layout = {type, static_cast<std::uint16_t>(fields.size() + 1), *references};
  records.error = layout.get();
  records.layouts.push_back(std::move(layout));
  records.references.push_back(std::move(references));
}

void VmState::reopen() {
  is_leaving = host.has_asked_to_stop = false;
  count_pause();
  steps.limit = options.limits.steps;
}

// The result of a call is at the start of its arguments.
void VmState::finish_call(bool done) {
  const Callee& callee = *programs.callees[host.call->function].own;
  if (done && callee.function->function->result->is_reference())
    heap.release(window_above(*main.stack.frames)->o);
  for (Obj* object : host.call->kept) heap.release(object);
  host.call.reset();
  heap.drain();
}

void VmState::clear() {
  main.waiting.reset();  // may own values of the program
  tree.clear();
  recordings.reset();
  for (Task* task : {&main, condition_task.get(), host.task.get()}) {
    while (task != nullptr && task->stack.top > task->stack.frames) leave_frame(*this, *task);
    if (task != nullptr) task->stack.shrink(heap);
  }
  pending.reset();
  fault.reset();
  if (host.call) finish_call(false);
  programs.before.reset();
  for (std::size_t i = 0; i < globals.values.size(); ++i) {
    if (globals.info[i].is_reference()) heap.release(globals.values[i].o);
    globals.values[i].o = nullptr;
  }
  for (const std::unique_ptr<LoadedCode>& unit : programs.units) {
    for (const Slot text : unit->texts) heap.release(text.o);
    unit->texts.clear();
  }
  for (Obj* text : *shared.ascii) heap.release(text);
  shared.ascii = &SharedObjects::kNoAscii;
  shared.made_ascii.reset();
  heap.drain();
}

const RecordLayout& VmState::layout_of(const Type* record) {
  if (records.error != nullptr && record == records.error->type) return *records.error;
  for (const RecordLayout& layout : programs.newest->layouts) {
    if (layout.type == record) return layout;
  }
  for (const auto& layout : records.layouts) {
    if (layout->type == record) return *layout;
  }
  auto references = std::make_unique<std::vector<std::uint16_t>>();
  const auto& fields = record->record->fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].type->is_reference()) references->push_back(static_cast<std::uint16_t>(i));
  }
  auto size = static_cast<std::uint16_t>(fields.size());
  if (record->is_table()) references->push_back(size++);  // the rows; columns are made from them
  records.layouts.push_back(
      std::make_unique<RecordLayout>(RecordLayout{record, size, *references}));
  records.references.push_back(std::move(references));
  return *records.layouts.back();
}

Obj* VmState::character(unsigned char code) {
  if (shared.made_ascii == nullptr) {
    shared.made_ascii = std::make_unique<SharedObjects::Ascii>();
    shared.ascii = shared.made_ascii.get();
  }
  Obj*& text = (*shared.made_ascii)[code];
  if (text == nullptr) {
    const char byte = static_cast<char>(code);
    text = heap.new_text(std::string_view(&byte, 1));
  }
  return text;
}

bool VmState::take_cancellation() {
  if (host.on_look) host.on_look();
  std::vector<Cancellation>& due = cancellations.due;
  const bool is_asked = vm.take_cancellation();
  if (host.counts_apart) return is_asked;
  if (!is_asked && due.empty()) [[likely]]
    return false;
  const Instant here = instant();
  const bool is_due = !due.empty() && here.has_reached(due.back().at) &&
                      cancellations.refusals >= due.back().refusals;
  if (is_due) {
    due.pop_back();
    look_for_cancellation();
  } else if (is_asked) {  // this run differs from the recorded one from here on
    arm_cancellations({});
  }
  if (is_asked || is_due) cancellations.noticed.push_back({here, cancellations.refusals});
  return is_asked || is_due;
}

void VmState::arm_cancellations(std::vector<Cancellation> wishes) {
  std::ranges::reverse(wishes);
  cancellations.due = std::move(wishes);
  look_for_cancellation();
}

void VmState::look_for_cancellation() {
  const std::vector<Cancellation>& due = cancellations.due;
  steps.look_at = due.empty() ? StepMeter::kEndless : due.back().at.steps;
}

void VmState::forget_cancellations() {
  arm_cancellations({});
  cancellations = {};
}

Instant VmState::instant() const {
  return {vm.timeline().now_ns(), host.counts_apart ? host.aside.steps : steps.so_far()};
}

}  // namespace armlet::lang
