// Services for native functions: new objects, failures, pauses.

#include <algorithm>

#include "armlet/interpreter/resource.hpp"
#include "vm/failures/failures.hpp"

namespace armlet {

namespace {

// Returns a new object. If it is null, the failure of a full heap is set first.
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
  return checked(vm, vm.state().heap.new_zero_matrix(rows, cols));
}

MatrixObj* new_matrix_unset(Vm& vm, std::uint32_t rows, std::uint32_t cols) {
  return checked(vm, vm.state().heap.new_matrix(rows, cols));
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

bool is_guarded(Vm& vm) {
  const lang::VmState& state = vm.state();
  if (state.running == nullptr) return false;
  const lang::Frame& frame = *state.running->stack.top;
  if (frame.is_host() || frame.at() == 0) return false;
  return frame.callee->code[frame.at() - 1].op == lang::OpCode::GUARD;
}

CallPlace place_of_call(Vm& vm) { return CallPlace(lang::code_span(vm.state())); }

Failed fail(Vm& vm, Failure failure) {
  lang::raise(vm.state(), failure);
  return {};
}

Answer<void> require_free(Vm& vm, const Resource& resource) {
  const lang::VmState& state = vm.state();
  const auto commands = [&](const lang::Task& task) {
    if (&task == state.running || task.has_ended || task.waiting == nullptr) return false;
    const Resource other = task.waiting->resource();
    return other.type == resource.type && other.name == resource.name;
  };
  const bool is_commanded =
      commands(state.main) ||
      std::ranges::any_of(state.tree.all(), [&](const auto& task) { return commands(*task); });
  if (!is_commanded) return {};
  return fail(vm,
              {.headline = {"R0617", {resource.name, std::string(resource.type->resource->busy)}},
               .mark = CallPart::callee(),
               .resource = resource});
}

Signal pause(Vm& vm, std::unique_ptr<Waiting> waiting) {
  vm.state().pending = std::move(waiting);
  return Signal::kPause;
}

}  // namespace armlet
