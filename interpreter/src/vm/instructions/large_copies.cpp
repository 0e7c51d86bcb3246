// Copies of large objects, made in blocks between which a stop request takes effect.

#include <cstring>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/values/map.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kLarge = 1U << 14U;  // elements

std::size_t elements_of(const Obj& object) {
  if (object.kind == ObjKind::kList) return static_cast<const ListObj&>(object).size;
  if (object.kind == ObjKind::kMap) return static_cast<const MapObj&>(object).size;
  if (object.kind != ObjKind::kMatrix) return 0;
  const auto& matrix = static_cast<const MatrixObj&>(object);
  return std::size_t{matrix.rows} * matrix.cols;
}

// Only the references that are copied already are counted; the others are null.
ListObj* copy_of(VmState& state, const ListObj& old) {
  ListObj* list = state.heap.new_list(old.size, old.holds_references());
  if (list == nullptr) {
    raise_out_of_memory(state);
    return nullptr;
  }
  const auto copy = [&](std::size_t begin, std::size_t end) {
    copy_slots(list->data + begin, old.data + begin, end - begin, old.holds_references());
  };
  if (in_blocks(state.vm, old.size, 4, copy)) return list;
  state.heap.release(list);
  return nullptr;
}

MatrixObj* copy_of(VmState& state, const MatrixObj& old) {
  MatrixObj* matrix = state.heap.new_matrix(old.rows, old.cols);
  if (matrix == nullptr) {
    raise_out_of_memory(state);
    return nullptr;
  }
  const auto copy = [&](std::size_t begin, std::size_t end) {
    std::memcpy(matrix->data() + begin, old.data() + begin, (end - begin) * sizeof(double));
  };
  if (in_blocks(state.vm, elements_of(old), 4, copy)) return matrix;
  state.heap.release(matrix);
  return nullptr;
}

constexpr std::size_t kTold = 1000;  // elements; larger copies are reported
constexpr std::uint32_t kTooOften = 3;

// Reports a large copy as advice, once for each instruction. The running frames must have been
// saved.
void note_large_copy(VmState& state, std::size_t count) {
  if (!state.options.advice) return;
  const Frame& frame = *state.running->stack.top;
  if (++state.shared.large_copies[frame.pc] != kTooOften) return;
  const CodeSpan* at = code_span(state);
  if (at == nullptr) return;
  Diagnostic advice = make_diagnostic("W0715", at->span, {std::to_string(count)});
  advice.why = "another variable, field or element still holds the list as it was";
  if (&frame > state.running->stack.frames && !frame.is_host() && !(&frame)[-1].is_host()) {
    const CodeSpan* call = code_span((&frame)[-1]);
    if (call != nullptr) advice.related.push_back({call->span, "called here"});
  }
  state.options.advice(advice);
}

}  // namespace

bool copy_to_own(VmState& state, Slot& place) {
  Obj* old = place.o;
  const std::size_t count = elements_of(*old);
  if (count > kTold) note_large_copy(state, count);
  if (count < kLarge && old->kind != ObjKind::kMap) {
    return (charge_work(state.vm, count)) &&
           (copy_shared(state.heap, place) || raise_out_of_memory(state));
  }
  Obj* copy = nullptr;
  if (old->kind == ObjKind::kMap) copy = copy_map(state, *static_cast<MapObj*>(old));
  if (old->kind == ObjKind::kList) copy = copy_of(state, *static_cast<ListObj*>(old));
  if (old->kind == ObjKind::kMatrix) copy = copy_of(state, *static_cast<MatrixObj*>(old));
  if (copy == nullptr) return false;
  --old->refs;  // it is shared, so it has other owners
  place.o = copy;
  return true;
}

}  // namespace armlet::lang
