// Error records: what programs see of a failure, and how it comes back to life when they throw it
// again.

#include <new>

#include "armlet/interpreter/catalog.hpp"
#include "vm/failures/failures.hpp"

namespace armlet::lang {

namespace {

using FaultLink = std::shared_ptr<Fault>;

// The link from an error record, or a finally block, to the failure it stands for. Programs never
// see it.
const HostType kFaultType = [] {
  HostType type{};
  type.name = "failure";
  type.size = sizeof(FaultLink);
  type.destroy = [](void* value) { static_cast<FaultLink*>(value)->~FaultLink(); };
  return type;
}();

HostObj* new_link(VmState& state, FaultLink fault) {
  HostObj* link = state.heap.new_host(kFaultType);
  if (link != nullptr) new (link->payload()) FaultLink(std::move(fault));
  return link;
}

Slot& field(const VmState& state, RecordObj& error, const char* name) {
  return error.fields()[state.error_layout->type->record->index_of(name)];
}
Slot field(const VmState& state, const RecordObj& error, const char* name) {
  return error.fields()[state.error_layout->type->record->index_of(name)];
}
// Behind the fields that the type tells of.
Slot& link_of(const VmState& state, RecordObj& error) {
  return error.fields()[state.error_layout->size - 1];
}
Slot link_of(const VmState& state, const RecordObj& error) {
  return error.fields()[state.error_layout->size - 1];
}

RecordObj* new_error(VmState& state) {
  RecordObj* error = state.heap.new_record(*state.error_layout);
  for (std::uint16_t i = 0; error != nullptr && i < state.error_layout->size; ++i)
    error->fields()[i].i = 0;
  return error;
}

// The record with these texts, or null after releasing it.
RecordObj* complete(VmState& state, RecordObj* error) {
  for (const char* name : {"message", "kind", "robot"}) {
    if (field(state, *error, name).o == nullptr) {
      state.heap.release(error);
      return nullptr;
    }
  }
  return error;
}

}  // namespace

RecordObj* catch_error(VmState& state) {
  const Heap::Reserve reserve(state.heap);
  const FaultLink fault = std::move(state.fault);
  RecordObj* error = new_error(state);
  if (error == nullptr) return nullptr;
  const Diagnostic& diagnostic = fault->diagnostic;
  field(state, *error, "message").o = state.heap.new_text(diagnostic.message);
  field(state, *error, "kind").o = state.heap.new_text(fault->kind);
  field(state, *error, "robot").o =
      state.heap.new_text(diagnostic.when ? diagnostic.when->robot : "");
  field(state, *error, "line").i =
      diagnostic.mark.span.empty() ? 0 : line_of(state, diagnostic.mark.span);
  field(state, *error, "time").d =
      diagnostic.when ? static_cast<double>(diagnostic.when->time_ns) * 1e-9 : 0.0;
  link_of(state, *error).o = new_link(state, fault);
  return complete(state, error);
}

RecordObj* make_error(VmState& state, TextObj* message, TextObj* kind) {
  RecordObj* error = new_error(state);
  if (error == nullptr) return nullptr;
  const CodeSpan* at = code_span(state);
  retain_object(message);
  retain_object(kind);
  field(state, *error, "message").o = message;
  field(state, *error, "kind").o = kind != nullptr ? kind : state.heap.new_text({});
  field(state, *error, "robot").o = state.heap.new_text({});
  field(state, *error, "line").i = at == nullptr ? 0 : line_of(state, at->span);
  field(state, *error, "time").d = static_cast<double>(state.vm.timeline().now_ns()) * 1e-9;
  return complete(state, error);
}

bool throw_error(VmState& state, const RecordObj& error) {
  const auto text = [&](const char* name) {
    return std::string(static_cast<const TextObj*>(field(state, error, name).o)->view());
  };
  if (const auto* link = static_cast<HostObj*>(link_of(state, error).o)) {
    state.fault = *static_cast<const FaultLink*>(link->payload());
    return false;
  }
  const std::string kind = text("kind");
  const std::string_view code = code_of_kind(kind);
  Diagnostic failure = start_failure(state, "R0627", {text("message")});
  if (!code.empty()) failure.code = code;
  raise(state, std::move(failure));
  state.fault->kind = kind;
  return false;
}

Obj* hold_fault(VmState& state) {
  const Heap::Reserve reserve(state.heap);
  return new_link(state, std::move(state.fault));
}

FaultPtr& held_fault(Obj* held) {
  return *static_cast<FaultLink*>(static_cast<HostObj*>(held)->payload());
}

bool rethrow(VmState& state, Obj* held) {
  state.fault = held_fault(held);
  return false;
}

}  // namespace armlet::lang
