// Error records: the values of `catch` that describe a failure, and the failures of records that
// are thrown again.

#include <algorithm>
#include <new>
#include <optional>

#include "armlet/interpreter/host/taken_failure.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/virtual_time.hpp"
#include "vm/failures/failures.hpp"

namespace armlet::lang {

namespace {

using FaultLink = std::shared_ptr<Fault>;

// The object that links an error record, or a finally block, with its failure. Programs cannot see
// it.
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
  return error.fields()[state.records.error->type->record->index_of(name)];
}
Slot field(const VmState& state, const RecordObj& error, const char* name) {
  return error.fields()[state.records.error->type->record->index_of(name)];
}
// The slot behind the fields of the type.
Slot& link_of(const VmState& state, RecordObj& error) {
  return error.fields()[state.records.error->size - 1];
}
Slot link_of(const VmState& state, const RecordObj& error) {
  return error.fields()[state.records.error->size - 1];
}

RecordObj* new_error(VmState& state) {
  RecordObj* error = state.heap.new_record(*state.records.error);
  for (std::uint16_t i = 0; error != nullptr && i < state.records.error->size; ++i)
    error->fields()[i].i = 0;
  return error;
}

// Completes the record with its texts; returns null, and releases it, if that fails. The other
// texts of the record are names of resources, by type; all are empty except the one of the failure.
RecordObj* complete(VmState& state, RecordObj* error, const std::optional<When>& when) {
  const std::vector<RecordField>& fields = state.records.error->type->record->fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!fields[i].type->is(Kind::kText)) continue;
    Slot& text = error->fields()[i];
    const bool is_given = fields[i].name == "message" || fields[i].name == "kind";
    const bool is_concerned = when && when->resource_type == fields[i].name;
    if (!is_given) text.o = state.heap.new_text(is_concerned ? when->resource : "");
    if (text.o == nullptr) {
      state.heap.release(error);
      return nullptr;
    }
  }
  return error;
}

}  // namespace

const MessageTables& messages_of(const VmState& state) {
  static const MessageTables kOfLanguage;
  const MessageTables* tables = state.vm.program().compiled().messages;
  return tables != nullptr ? *tables : kOfLanguage;
}

RecordObj* catch_error(VmState& state) {
  const Heap::Reserve reserve(state.heap);
  const FaultLink fault = std::move(state.fault);
  RecordObj* error = new_error(state);
  if (error == nullptr) return nullptr;
  const Diagnostic& diagnostic = fault->diagnostic;
  field(state, *error, "message").o = state.heap.new_text(diagnostic.message);
  field(state, *error, "kind").o = state.heap.new_text(fault->kind);
  field(state, *error, "line").i =
      diagnostic.mark.span.empty() ? 0 : line_of(state, diagnostic.mark.span);
  field(state, *error, "time").d = diagnostic.when ? seconds_of(diagnostic.when->time_ns) : 0.0;
  link_of(state, *error).o = new_link(state, fault);
  return complete(state, error, diagnostic.when);
}

RecordObj* make_error(VmState& state, TextObj* message, TextObj* kind) {
  RecordObj* error = new_error(state);
  if (error == nullptr) return nullptr;
  const CodeSpan* at = code_span(state);
  retain_object(message);
  retain_object(kind);
  field(state, *error, "message").o = message;
  field(state, *error, "kind").o = kind != nullptr ? kind : state.heap.new_text({});
  field(state, *error, "line").i = at == nullptr ? 0 : line_of(state, at->span);
  field(state, *error, "time").d = seconds_of(state.vm.timeline().now_ns());
  return complete(state, error, {});
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
  const CatalogEntry* row = messages_of(state).of_kind(kind);
  Diagnostic failure = start_failure(state, "R0627", {text("message")});
  if (row != nullptr) failure.code = row->code;
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

namespace armlet {

std::optional<TakenFailure> take_failure(Vm& vm, std::span<const std::string_view> kinds) {
  lang::FaultPtr& fault = vm.state().fault;
  if (fault == nullptr || fault->reach != lang::Reach::kHandlers ||
      std::ranges::find(kinds, fault->kind) == kinds.end())
    return {};
  TakenFailure taken{std::move(fault->diagnostic.message), std::move(fault->detail)};
  fault.reset();
  return taken;
}

}  // namespace armlet
