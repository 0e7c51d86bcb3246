#include "bridge.hpp"

#include <stdexcept>

#include "vm/failures/failures.hpp"
#include "vm/state/state.hpp"

namespace armlet::oracle {

namespace {

VmOptions options_for(void* host) {
  VmOptions options;
  options.host = host;
  return options;
}

}  // namespace

Signal Bridge::run(const NativeFunction& function, Slot* window) {
  if (function.thunk) return function.thunk(vm_, window);
  const double x = window[0].d;
  if (function.real1 != nullptr) window[0].d = function.real1(x);
  if (function.real2 != nullptr) window[0].d = function.real2(x, window[1].d);
  if (function.real3 != nullptr) window[0].d = function.real3(x, window[1].d, window[2].d);
  return Signal::kDone;
}

Bridge::Bridge(std::shared_ptr<const Program> program, void* host)
    : vm_(std::move(program), options_for(host)) {
  lang::VmState& state = vm_.state();
  code_.code.resize(1);
  callee_.code = code_.code.data();
  callee_.function = &code_;
  state.running = &state.main;
  lang::Frame& frame = *++state.main.stack.top;
  frame = state.main.stack.frames[0];
  frame.pc = callee_.code + 1;
  frame.callee = &callee_;
}

Bridge::~Bridge() {
  --vm_.state().main.stack.top;
  vm_.state().clear();
}

void Bridge::pretend_to_run(const lang::hir::CallNativeExpr& call) {
  code_.spans.assign(1, {0, call.span, &call});
}

Value Bridge::call(const lang::hir::CallNativeExpr& call, const std::vector<Value>& arguments) {
  pretend_to_run(call);
  std::vector<Slot> slots;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    slots.push_back(to_slot(arguments[i], *call.arguments[i]->type));
  }
  std::vector<Slot> window = slots;
  window.resize(slots.size() + 1);
  const Signal signal = run(*call.function, window.data());
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (call.arguments[i]->type->is_reference()) release(vm_, slots[i].o);
  }
  if (signal == Signal::kPause) throw std::logic_error("the oracle does not wait for the library");
  if (signal == Signal::kFail) {
    const lang::Fault& fault = *vm_.state().fault;
    throw Failure{fault.diagnostic.code, fault.diagnostic.message, fault.kind,
                  fault.diagnostic.mark.span};
  }
  if (call.type->is(Kind::kVoid)) return {};
  Value result = from_slot(window[0], *call.type);
  if (call.type->is_reference()) release(vm_, window[0].o);
  return result;
}

Slot Bridge::to_slot(const Value& value, const Type& type) {
  if (value.absent()) return type.is_reference() ? Slot{.o = nullptr} : Slot{.i = kAbsentBits};
  switch (type.kind) {
    case Kind::kBool:
      return slot_of(value.truth());
    case Kind::kReal:
      return slot_of(value.real());
    case Kind::kInt:
    case Kind::kEnum:
      return slot_of(value.integer());
    case Kind::kText:
      return slot_of(new_text(vm_, value.text()));
    case Kind::kList: {
      const std::vector<Value>& items = value.list().items;
      ListObj* list =
          new_list(vm_, static_cast<std::uint32_t>(items.size()), type.element->is_reference());
      for (std::size_t i = 0; i < items.size(); ++i)
        list->data[i] = to_slot(items[i], *type.element);
      return slot_of(static_cast<Obj*>(list));
    }
    case Kind::kRecord: {
      RecordObj* record = new_record(vm_, &type);
      for (std::size_t i = 0; i < type.record->fields.size(); ++i) {
        record->fields()[i] = to_slot(value.record().fields[i], *type.record->fields[i].type);
      }
      return slot_of(static_cast<Obj*>(record));
    }
    case Kind::kMatrix: {
      const Matrix& from = value.matrix();
      MatrixObj* matrix = new_matrix(vm_, static_cast<std::uint32_t>(from.rows),
                                     static_cast<std::uint32_t>(from.cols));
      for (std::size_t i = 0; i < from.numbers.size(); ++i)
        matrix->data()[i] = from.numbers[i].real();
      return slot_of(static_cast<Obj*>(matrix));
    }
    default:
      throw std::logic_error("the oracle cannot hand over a " + type_name(&type));
  }
}

Value Bridge::from_slot(Slot slot, const Type& type) const {
  switch (type.kind) {
    case Kind::kBool:
      return {slot.i != 0};
    case Kind::kReal:
      return {slot.d};
    case Kind::kInt:
    case Kind::kEnum:
      return {slot.i};
    case Kind::kText:
      return {std::string(text_value(slot))};
    case Kind::kList: {
      List list;
      for (const Slot item : items_value(slot))
        list.items.push_back(from_slot(item, *type.element));
      return {std::move(list)};
    }
    case Kind::kRecord: {
      Record record;
      const auto* from = static_cast<const RecordObj*>(slot.o);
      for (std::size_t i = 0; i < type.record->fields.size(); ++i) {
        record.fields.push_back(from_slot(from->fields()[i], *type.record->fields[i].type));
      }
      return {std::move(record)};
    }
    case Kind::kMatrix: {
      const auto* from = static_cast<const MatrixObj*>(slot.o);
      Matrix matrix{from->rows, from->cols, {}};
      for (std::size_t i = 0; i < matrix.rows * matrix.cols; ++i)
        matrix.numbers.push_back({from->data()[i]});
      return {std::move(matrix)};
    }
    default:
      throw std::logic_error("the oracle cannot take a " + type_name(&type));
  }
}

}  // namespace armlet::oracle
