#include "vm/state/entries.hpp"

#include <algorithm>
#include <utility>

#include "hir/kept.hpp"
#include "vm/failures/failures.hpp"
#include "vm/state/state.hpp"
#include "vm/tasks/recordings.hpp"

namespace armlet::lang {

Before::Before(VmState& state)
    : state_(state),
      layouts_(state.records.layouts.size()),
      host_data_(state.main.host_data),
      random_(state.main.random),
      parallels_(state.main.parallels),
      steps_(state.steps.so_far()),
      work_(state.kernels.rest()),
      statements_(state.marks.begun),
      cancellations_(state.cancellations) {
  if (state.main.children.regions.empty()) return;
  for (const auto& watch : state.main.children.regions[0])
    watches_.push_back({watch->was_true, watch->has_failed, watch->next_ns});
}

Before::~Before() {
  release();
  if (own_ == nullptr) return;
  for (const hir::Variable* variable : own_->module.globals)
    state_.globals.is_kept[variable->index] = 0;
}

void Before::release() {
  for (const Variable& variable : variables_) {
    state_.globals.is_kept[variable.number] = 0;
    if (variable.info.is_reference()) state_.heap.release(variable.value.o);
  }
  for (const Column& made : columns_) state_.heap.release(made.table);
  variables_.clear();
  columns_.clear();
}

void Before::keep(std::uint32_t number) {
  const GlobalInfo& info = state_.globals.info[number];
  const Slot value = state_.globals.values[number];
  state_.globals.is_kept[number] = 1;
  variables_.push_back({number, info, state_.globals.is_set[number], value});
  if (info.is_reference()) retain_object(value.o);
}

void Before::note_column(RecordObj& table, std::uint16_t column) {
  retain_object(&table);
  columns_.push_back({&table, column});
}

void Before::pass_over(const CompiledProgram& entry) {
  own_ = &entry;
  for (const hir::Variable* variable : entry.module.globals)
    state_.globals.is_kept[variable->index] = 1;
}

void Before::restore() {
  for (Variable& variable : variables_) {
    std::swap(state_.globals.values[variable.number], variable.value);
    state_.globals.info[variable.number] = variable.info;
    state_.globals.is_set[variable.number] = variable.is_set;
  }
  for (const Column& made : columns_) {
    Slot& column = made.table->fields()[made.column];
    state_.heap.release(std::exchange(column.o, nullptr));
  }
  for (const Replaced& replaced : replaced_)
    state_.programs.callees[replaced.number] = replaced.callee;
  state_.tree.forget_watches(watches_.size());
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    Watch& watch = *state_.main.children.regions[0][i];
    watch.was_true = watches_[i].was_true;
    watch.has_failed = watches_[i].has_failed;
    watch.next_ns = watches_[i].next_ns;
  }
  release();  // before the layouts of the entry's records are removed
  state_.heap.drain();
  state_.records.layouts.resize(layouts_);
  state_.records.references.resize(layouts_);
  state_.main.host_data = host_data_;
  state_.main.random = random_;
  state_.main.parallels = parallels_;
  state_.steps.settle();
  state_.steps.total = steps_;
  state_.kernels.set_rest(work_);
  state_.marks.begun = statements_;
  state_.marks.paused = nullptr;
  state_.cancellations = std::move(cancellations_);
  state_.look_for_cancellation();
}

namespace {

void add_global(VmState& state, const hir::Variable& variable) {
  const std::uint32_t number = variable.index;
  if (number >= state.globals.values.size()) {
    state.globals.values.resize(number + 1, Slot{.i = 0});
    state.globals.is_set.resize(number + 1, 0);
    state.globals.is_kept.resize(number + 1, 0);
    state.globals.info.resize(number + 1);
  }
  if (state.globals.info[number].is_reference()) state.heap.release(state.globals.values[number].o);
  state.globals.values[number].i = 0;
  state.globals.is_set[number] = 0;
  state.globals.info[number].variable = &variable;
}

}  // namespace

Callee callee_of(const CompiledProgram& program, const FunctionCode& f, const Slot* texts) {
  const auto references = static_cast<std::uint16_t>(f.references_end - f.references_begin);
  return {
      f.code.data(), &f,          f.constants.data(), texts,      program.natives.data(), &program,
      nullptr,       f.registers, f.references_begin, references, f.may_give_unset};
}

void load(VmState& state, const CompiledProgram& program, Before* before) {
  auto unit = std::make_unique<LoadedCode>(LoadedCode{&program, {}, {}});
  unit->texts.reserve(program.texts.size());
  unit->callees.reserve(program.functions.size());
  for (const FunctionCode& f : program.functions) {
    Callee& callee = unit->callees.emplace_back(callee_of(program, f, unit->texts.data()));
    callee.own = &callee;
    const std::uint32_t number = f.function->index;
    if (number >= state.programs.callees.size())
      state.programs.callees.resize(number + 1, Callee{});
    if (before != nullptr) before->note(number, state.programs.callees[number]);
    state.programs.callees[number] = callee;
  }
  for (const hir::Variable* variable : program.module.globals) add_global(state, *variable);
  if (before != nullptr) before->pass_over(program);
  state.programs.newest = &program;
  state.host.require_values();
  state.programs.units.push_back(std::move(unit));
}

bool make_texts(VmState& state) {
  LoadedCode& unit = *state.programs.units.back();
  for (const std::string& text : unit.program->texts) {
    Obj* object = state.heap.new_text(text);
    if (object == nullptr) return raise_out_of_memory(state);
    unit.texts.push_back(slot_of(object));
  }
  return true;
}

namespace {

void drop_newest(VmState& state) {
  LoadedCode& unit = *state.programs.units.back();
  for (const Callee& callee : unit.callees) {
    Callee& known = state.programs.callees[callee.function->function->index];
    if (known.own == &callee) known = Callee{};  // the first entry has replaced no function
  }
  for (const Slot text : unit.texts) state.heap.release(text.o);
  state.heap.drain();
  state.programs.units.pop_back();
}

}  // namespace

// An entry that failed is removed completely. Of an entry without functions only its variables
// stay, so that the session does not grow.
void finish_entry(VmState& state, bool done) {
  state.main.stack.rest();
  state.host.require_values();
  state.recordings.reset();
  state.shared.large_copies.clear();
  if (!done) {
    for (const hir::Variable* variable : state.programs.newest->module.globals) {
      GlobalInfo& info = state.globals.info[variable->index];
      if (info.is_reference()) state.heap.release(state.globals.values[variable->index].o);
      state.globals.values[variable->index].i = 0;
      info.variable = nullptr;
    }
    state.programs.before->restore();
  }
  state.programs.before.reset();
  if (!done || state.programs.units.back()->callees.size() <= 1) drop_newest(state);
  state.heap.rest();
}

}  // namespace armlet::lang
