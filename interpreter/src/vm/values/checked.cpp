#include "vm/values/checked.hpp"

#include <array>

#include "armlet/core/error.hpp"
#include "vm/failures/failures.hpp"
#include "vm/values/map.hpp"

namespace armlet::lang {
namespace {

// A NaN that no arithmetic makes. It marks the slot of a result before the call.
constexpr std::int64_t kNothing = static_cast<std::int64_t>(0xFFF8'A851'7000'0002ULL);

// Whether the slot may be an address of an object: aligned, in the range of the processor's
// addresses, and not in the first page.
bool may_be_object(Slot slot) {
  const auto address = static_cast<std::uint64_t>(slot.i);
  return address % alignof(Obj) == 0 && address >= 4096 && address < (std::uint64_t{1} << 47U);
}

struct KindOfObject {
  ObjKind kind;
  const char* name;
};

KindOfObject object_of(Kind kind) {
  switch (kind) {
    case Kind::kText:
      return {ObjKind::kText, "a text"};
    case Kind::kList:
      return {ObjKind::kList, "a list"};
    case Kind::kMap:
      return {ObjKind::kMap, "a map"};
    case Kind::kMatrix:
      return {ObjKind::kMatrix, "a matrix"};
    case Kind::kFunction:
      return {ObjKind::kClosure, "a function"};
    case Kind::kHost:
      return {ObjKind::kHost, "a value of the host"};
    case Kind::kRecord:
    case Kind::kAny:  // no objects
    case Kind::kVoid:
    case Kind::kBool:
    case Kind::kInt:
    case Kind::kReal:
    case Kind::kEnum:
      break;
  }
  return {ObjKind::kRecord, "a record"};
}

std::string name_of(ObjKind kind) {
  for (const Kind each : {Kind::kText, Kind::kList, Kind::kMap, Kind::kMatrix, Kind::kFunction,
                          Kind::kHost, Kind::kRecord}) {
    if (object_of(each).kind == kind) return object_of(each).name;
  }
  return "an object of the machine";
}

std::string object_fault(const Obj& object, const Type& type) {
  const KindOfObject expected = object_of(type.kind);
  if (object.refs == 0) return "an object that nobody owns";
  if (object.kind != expected.kind)
    return name_of(object.kind) + " where " + expected.name + " is expected";
  if (type.is(Kind::kHost)) {
    const HostType& given = *static_cast<const HostObj&>(object).type;
    if (is_same_in_cpp(&given, type.host)) return {};
    return "a " + std::string(given.name) + " where a " + std::string(type.host->name) +
           " is expected";
  }
  if (type.is(Kind::kList)) {
    const auto& list = static_cast<const ListObj&>(object);
    const bool references = type.element->is_reference();
    const bool any = list.size == 0 || type.element->is(Kind::kAny);
    if (any || list.holds_references() == references) return {};
    return references ? "a list of numbers where one of references is expected"
                      : "a list of references where one of numbers is expected";
  }
  if (type.is(Kind::kMap)) {
    const auto& map = static_cast<const MapObj&>(object);
    const bool any = map.size == 0 || type.element->is(Kind::kAny);
    return any || map.flags == map_flags(type) ? "" : "a map of other keys or values";
  }
  if (type.is(Kind::kRecord) && !type.is_table()) {
    const Type* given = static_cast<const RecordObj&>(object).layout->type;
    if (given == &type) return {};
    return "a " + type_name(given) + " where a " + type_name(&type) + " is expected";
  }
  return {};
}

}  // namespace

std::string slot_fault(Slot slot, const Type& type) {
  if (type.is(Kind::kAny) || type.is(Kind::kVoid)) return {};
  if (type.is_reference()) {
    if (slot.o == nullptr) return "nothing where " + type_phrase(&type) + " is expected";
    if (!may_be_object(slot)) return "no object where " + type_phrase(&type) + " is expected";
    return object_fault(*slot.o, type);
  }
  if (type.is(Kind::kBool) && slot.i != 0 && slot.i != 1)
    return "a bool that is neither true nor false";
  if (type.is(Kind::kEnum)) {
    const auto count = static_cast<std::int64_t>(type.enumeration->values.size());
    if (slot.i < 0 || slot.i >= count)
      return "number " + std::to_string(slot.i) + " of " + type_name(&type) + ", which has " +
             std::to_string(count) + " values";
  }
  return {};
}

namespace {

// The fault in the result in args[0], where `before` was the value before the call; empty if there
// is none.
std::string result_fault(const hir::CallNativeExpr& call, const Slot* args, Slot before) {
  const Type& type = *call.type;
  if (type.is(Kind::kVoid) || type.is(Kind::kAny)) return {};
  const Slot result = args[0];
  const bool takes_nothing = call.arguments.size() == 0;
  const bool took_reference = !takes_nothing && call.arguments[0]->type->is_reference();
  const bool tells = takes_nothing ||
                     (took_reference && before.o != nullptr && !type.is_reference()) ||
                     (!took_reference && type.is_reference());
  if (result.i == before.i && tells) return "no result: what was there before is still there";
  if (std::string fault = slot_fault(result, type); !fault.empty()) return fault;
  if (!type.is_reference() || result.o->refs > 1) return {};
  // The owner of an argument still owns it, so the result needs a count of its own.
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Slot argument = i == 0 ? before : args[i];
    if (call.arguments[i]->type->is_reference() && argument.o == result.o)
      return "an argument that it has not retained";
  }
  return {};
}

// Whether the result is a new object of another type, which has no other owner.
bool is_own_object(const hir::CallNativeExpr& call, const Slot* args, Slot before) {
  if (!call.type->is_reference() || !may_be_object(args[0]) || args[0].i == before.i) return false;
  for (std::size_t i = 1; i < call.arguments.size(); ++i) {
    if (args[i].o == args[0].o) return false;
  }
  return true;
}

}  // namespace

Signal call_checked(VmState& state, const Frame& frame, const Thunk& thunk, Slot* args) {
  const CodeSpan* at = code_span(frame);
  const bool is_known =
      at != nullptr && at->expr != nullptr && at->expr->kind == hir::ExprKind::kCallNative;
  if (!is_known) return thunk(state.vm, args);
  const auto& call = at->expr->as<hir::CallNativeExpr>();
  if (call.function->thunk != thunk) return thunk(state.vm, args);
  if (call.arguments.size() == 0 && !call.type->is(Kind::kVoid)) args[0].i = kNothing;
  const Slot before = args[0];
  const Signal signal = thunk(state.vm, args);
  if (signal != Signal::kDone) return signal;
  const std::string fault = result_fault(call, args, before);
  if (fault.empty()) return signal;
  if (is_own_object(call, args, before)) state.heap.release(args[0].o);
  raise(state, "R0626", {'`' + std::string(call.function->name) + "` of the host left " + fault});
  return Signal::kFail;
}

void require_values(const hir::Function& function, std::span<const Slot> arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string fault = slot_fault(arguments[i], *function.parameters[i]->type);
    if (fault.empty()) continue;
    throw ArgumentError("Argument " + std::to_string(i + 1) + " of a call by the host is " + fault +
                        ".");
  }
}

}  // namespace armlet::lang
