// What native functions may ask of the machine: new objects, failing, pausing.

#include <algorithm>

#include "armlet/interpreter/native.hpp"
#include "vm/failures.hpp"
#include "vm/slow_ops.hpp"

namespace armlet {

namespace {

// A new object, after telling the Vm when there is none.
template <class T>
T* checked(Vm& vm, T* object) {
  if (object == nullptr) lang::raise_out_of_memory(vm.state());
  return object;
}

}  // namespace

Obj* new_text(Vm& vm, std::string_view text) { return checked(vm, vm.state().heap.new_text(text)); }

ListObj* new_list(Vm& vm, std::uint32_t size, bool references) {
  return checked(vm, vm.state().heap.new_list(size, references));
}

Obj* new_reals(Vm& vm, std::span<const double> values) {
  ListObj* list = checked(vm, vm.state().heap.new_list(values.size(), false));
  for (std::size_t i = 0; list != nullptr && i < values.size(); ++i) list->data[i].d = values[i];
  return list;
}

MatrixObj* new_matrix(Vm& vm, std::uint32_t rows, std::uint32_t cols) {
  MatrixObj* matrix = checked(vm, vm.state().heap.new_matrix(rows, cols));
  if (matrix != nullptr) std::fill_n(matrix->data(), std::size_t{rows} * cols, 0.0);
  return matrix;
}

MatrixObj* new_matrix_unset(Vm& vm, std::uint32_t rows, std::uint32_t cols) {
  return checked(vm, vm.state().heap.new_matrix(rows, cols));
}

bool charge_steps(Vm& vm, std::uint64_t steps) {
  lang::VmState& state = vm.state();
  const auto left = [&state] { return static_cast<std::uint64_t>(state.steps.left); };
  while (steps > left()) {
    steps -= left();
    if (!lang::count_slowly(state)) return false;
    --steps;  // the first step of a new chunk is counted there
  }
  state.steps.left -= static_cast<std::int64_t>(steps);
  return true;
}

Scratch::Scratch(Vm& vm, std::uint64_t bytes)
    : vm_(vm), bytes_(bytes), granted_(vm.state().heap.charge(bytes)) {
  if (!granted_) lang::raise_out_of_memory(vm.state());
}

Scratch::~Scratch() {
  if (granted_) vm_.state().heap.discharge(bytes_);
}

RecordObj* new_record(Vm& vm, const Type* record) {
  const RecordLayout& layout = vm.state().layout_of(record);
  RecordObj* object = checked(vm, vm.state().heap.new_record(layout));
  for (std::uint16_t i = 0; object != nullptr && i < layout.size; ++i) object->fields()[i].i = 0;
  return object;
}

HostObj* new_host_object(Vm& vm, const HostType& type) {
  return checked(vm, vm.state().heap.new_host(type));
}

void retain(Obj* object) { lang::retain_object(object); }

void release(Vm& vm, Obj* object) { vm.state().heap.release(object); }

CallPlace place_of_call(Vm& vm) { return CallPlace(lang::code_span(vm.state())); }

Signal fail(Vm& vm, Failure failure) {
  lang::raise(vm.state(), failure);
  return Signal::kFail;
}

Signal pause(Vm& vm, std::unique_ptr<Waiting> waiting) {
  vm.state().pending = std::move(waiting);
  return Signal::kPause;
}

}  // namespace armlet
