#include "vm/instructions/slow_ops.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "armlet/interpreter/work.hpp"
#include "armlet/math/det_math.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/instructions/unset.hpp"
#include "vm/values/equality.hpp"

namespace armlet::lang {

namespace {

ListObj& list_in(Slot s) { return *static_cast<ListObj*>(s.o); }
TextObj& text_in(Slot s) { return *static_cast<TextObj*>(s.o); }
Slot& place_in(Slot s) { return *reinterpret_cast<Slot*>(s.o); }

void set_reference(VmState& state, Slot& place, Obj* object) {
  Obj* old = place.o;
  place.o = object;
  state.heap.release(old);
}

// Stores a new object. Returns false, with the failure set, if the heap had no room for it.
bool put_new(VmState& state, Slot& place, Obj* object) {
  if (object == nullptr) return raise_out_of_memory(state);
  set_reference(state, place, object);
  return true;
}

// Stores a new object whose elements are all set. filled: false if filling it failed; the object is
// then released.
bool put_filled(VmState& state, Slot& place, Obj* object, bool filled) {
  if (filled) {
    set_reference(state, place, object);
  } else {
    state.heap.release(object);
  }
  return filled;
}

Slot taken(Slot& from) {
  const Slot value = from;
  from.o = nullptr;
  return value;
}

}  // namespace

// ---- numbers --------------------------------------------------------------------------------

bool op_powi(VmState& state, Slot* base, const Instr* pc) {
  std::int64_t factor = base[pc->b].i;
  std::int64_t exponent = base[pc->c].i;
  if (exponent < 0) {
    return raise(
        state, "R0609",
        {"a power", std::to_string(exponent), "whole numbers need an exponent of 0 or more"});
  }
  std::int64_t power = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0 && __builtin_mul_overflow(power, factor, &power))
      return raise_overflow(state);
    if (exponent > 1 && __builtin_mul_overflow(factor, factor, &factor))
      return raise_overflow(state);
  }
  base[pc->a].i = power;
  return true;
}

bool op_powr(VmState& state, Slot* base, const Instr* pc) {
  const double x = base[pc->b].d;
  const double y = base[pc->c].d;
  const double power = det::pow(x, y);
  if (std::isnan(power) && !std::isnan(x) && !std::isnan(y)) {
    return raise(state, "R0609",
                 {"a power with exponent " + number_text(y), number_text(x),
                  "a negative number has only whole powers"});
  }
  base[pc->a].d = power;
  return true;
}

bool op_rtoi(VmState& state, Slot* base, const Instr* pc) {
  const double value = base[pc->b].d;
  constexpr double kTwo63 = 9223372036854775808.0;
  if (!std::isfinite(value)) return raise(state, "R0612", {"the value", number_text(value)});
  if (value >= kTwo63 || value < -kTwo63) return raise_overflow(state);
  base[pc->a].i = static_cast<std::int64_t>(value);
  return true;
}

bool op_eqdeep(VmState& state, Slot* base, const Instr* pc) {
  const Type* type = state.running->stack.top->callee->function->types[pc[1].b];
  bool equal = false;
  if (!compare_values(state, base[pc->b], base[pc->c], *type, equal)) return false;
  base[pc->a].i = equal ? 1 : 0;
  return true;
}

Obj* missing_row(VmState& state, const Instr* pc, std::int64_t index, std::uint64_t size) {
  MissingRow& row = state.shared.missing_rows[pc[1].c];
  row.refs = 1;
  row.kind = ObjKind::kList;
  row.index = index;
  row.rows = size;
  row.at = pc;
  return &row;
}

bool raise_element(VmState& state, const ListObj& list, std::int64_t index) {
  for (const MissingRow& row : state.shared.missing_rows) {
    if (&row != &list) continue;
    state.running->stack.top->pc = row.at + 1;
    return raise_index(state, row.index, row.rows);
  }
  return raise_index(state, index, list.size);
}

bool op_calld_again(VmState& state, Slot* base, const Instr* pc) {
  const NativeFunction& native = *state.code().natives[pc->c];
  Slot* scratch = base + state.running->stack.top->callee->registers;
  scratch[0] = base[pc->b];
  if (pc->op == OpCode::CALLD2 || pc->op == OpCode::CALLD3) scratch[1] = base[pc[1].a];
  if (pc->op == OpCode::CALLD3) scratch[2] = base[pc[1].b];
  if (!native.thunk) {
    scratch[0].d = std::nan("");
  } else if (native.thunk(state.vm, scratch) != Signal::kDone) {
    return require_failure(state);
  }
  base[pc->a] = scratch[0];
  return true;
}

// ---- making objects -------------------------------------------------------------------------

bool op_box(VmState& state, Slot* base, const Instr* pc) {
  return put_new(state, base[pc->a], state.heap.new_box(pc->c != 0));
}

bool op_closure(VmState& state, Slot* base, const Instr* pc) {
  const FunctionCode& function = *state.programs.callees[pc->c].function;
  ClosureObj* closure =
      state.heap.new_closure(pc->c, function.captures, &function.capture_references);
  if (closure == nullptr) return raise_out_of_memory(state);
  const Slot* from = base + pc->b;
  for (std::uint16_t i = 0; i < function.captures; ++i) closure->captures()[i] = from[i];
  for (const std::uint16_t reference : function.capture_references)
    retain_object(from[reference].o);
  set_reference(state, base[pc->a], closure);
  return true;
}

static ListObj* new_list_of(VmState& state, std::int64_t size, bool references) {
  if (size < 0) {
    raise(state, "R0613", {"a list cannot have " + std::to_string(size) + " values"});
    return nullptr;
  }
  ListObj* list = state.heap.new_list(static_cast<std::uint64_t>(size), references);
  if (list == nullptr) raise_out_of_memory(state);
  return list;
}

bool op_newlist(VmState& state, Slot* base, const Instr* pc) {
  ListObj* list = new_list_of(state, base[pc->b].i, pc->c != 0);
  if (list == nullptr) return false;
  set_reference(state, base[pc->a], list);
  return true;
}

bool op_makelist(VmState& state, Slot* base, const Instr* pc) {
  const bool references = pc[1].b != 0;
  ListObj* list = state.heap.new_list_unset(pc->c, references);
  if (list == nullptr) return raise_out_of_memory(state);
  Slot* from = base + pc->b;
  for (std::uint32_t i = 0; i < list->size; ++i)
    list->data[i] = references ? taken(from[i]) : from[i];
  set_reference(state, base[pc->a], list);
  return true;
}

// Lists of lists are made from the innermost on: the inner lists share their storage until one of
// them is changed. Elements of types without a zero value begin as null references.
bool op_newarray(VmState& state, Slot* base, const Instr* pc) {
  const Type* type = state.running->stack.top->callee->function->types[pc[1].b];
  const int count = pc->c;
  for (int i = 0; i < count - 1; ++i) type = type->element;
  const bool texts = type->element->is(Kind::kText);
  const bool references = type->element->is_reference();
  Slot inner{.o = nullptr};
  const bool unset = !has_zero(*type->element);
  if (references && !unset) {
    inner.o = texts ? static_cast<Obj*>(state.heap.new_text({}))
                    : state.heap.new_list(0, type->element->element->is_reference());
    if (inner.o == nullptr) return raise_out_of_memory(state);
  }
  bool inner_references = references;
  bool fills = references && !unset;
  for (int level = count - 1; level >= 0; --level) {
    ListObj* list = new_list_of(state, base[pc->b + level].i, inner_references);
    if (list == nullptr) {
      if (fills) state.heap.release(inner.o);
      return false;
    }
    const auto fill = [&](std::size_t begin, std::size_t end) {
      std::fill(list->data + begin, list->data + end, inner);
      inner.o->refs += static_cast<std::uint32_t>(end - begin);
    };
    const bool filled = !fills || in_blocks(state.vm, list->size, 4, fill);
    if (fills) state.heap.release(inner.o);
    if (!filled) {
      state.heap.release(list);
      return false;
    }
    inner.o = list;
    inner_references = fills = true;
  }
  set_reference(state, base[pc->a], inner.o);
  return true;
}

bool op_makerec(VmState& state, Slot* base, const Instr* pc) {
  const RecordLayout& layout = state.code().layouts[pc->c];
  RecordObj* record = state.heap.new_record(layout);
  if (record == nullptr) return raise_out_of_memory(state);
  const Slot* from = base + pc->b;
  for (std::uint16_t i = 0; i < layout.size; ++i) record->fields()[i] = from[i];
  for (const std::uint16_t reference : layout.references) retain_object(from[reference].o);
  set_reference(state, base[pc->a], record);
  return true;
}

bool op_listtoreal(VmState& state, Slot* base, const Instr* pc) {
  const ListObj& from = list_in(base[pc->b]);
  ListObj* list = state.heap.new_list_unset(from.size, false);
  if (list == nullptr) return raise_out_of_memory(state);
  const auto convert = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) list->data[i].d = static_cast<double>(from.data[i].i);
  };
  return put_filled(state, base[pc->a], list, in_blocks(state.vm, list->size, 4, convert));
}

// ---- lists ----------------------------------------------------------------------------------

// Whether all elements in a part of a list have values. If not, returns false with the failure set.
static bool check_part(VmState& state, const ListObj& list, std::uint32_t first,
                       std::uint32_t last) {
  if (!list.holds_references()) return true;
  for (std::uint32_t i = first; i < last; ++i) {
    if (list.data[i].o == nullptr) return raise_unset_element(state, i);
  }
  return true;
}

bool slice_ends(VmState& state, const Slot* ends, std::uint64_t size, std::string_view what,
                std::uint32_t& first, std::uint32_t& last) {
  const std::int64_t a = is_absent_scalar(ends[0]) ? 0 : ends[0].i;
  const std::int64_t b = is_absent_scalar(ends[1]) ? static_cast<std::int64_t>(size) : ends[1].i;
  if (b < 0 || static_cast<std::uint64_t>(b) > size) return raise_end(state, b, size, size, what);
  if (a > b) return raise_backwards(state, a, b);
  if (a < 0) return raise_end(state, a, static_cast<std::uint64_t>(b), size, what);
  first = static_cast<std::uint32_t>(a);
  last = static_cast<std::uint32_t>(b);
  return true;
}

bool op_slice(VmState& state, Slot* base, const Instr* pc) {
  const ListObj& from = list_in(base[pc->b]);
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  if (!slice_ends(state, base + pc->c, from.size, "list", first, last)) return false;
  if (!check_part(state, from, first, last)) return false;
  ListObj* list = state.heap.new_list(last - first, from.holds_references());
  if (list == nullptr) return raise_out_of_memory(state);
  const auto copy = [&](std::size_t begin, std::size_t end) {
    copy_slots(list->data + begin, from.data + first + begin, end - begin, from.holds_references());
  };
  return put_filled(state, base[pc->a], list, in_blocks(state.vm, list->size, 4, copy));
}

// The counts of the new elements increase before the old ones are released, because both may be the
// same objects.
bool op_putslice(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = place_in(base[pc->a]);
  if (!own(state, place)) return false;
  ListObj& list = list_in(place);
  const ListObj& from = list_in(base[pc->c]);
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  if (!slice_ends(state, base + pc->b, list.size, "list", first, last)) return false;
  const std::uint32_t count = last - first;
  if (from.size != count) {
    return raise(state, "R0613",
                 {"a part of " + std::to_string(count) + " is given " + std::to_string(from.size) +
                  (from.size == 1 ? " value" : " values")});
  }
  Slot* to = list.data + first;
  return in_blocks(state.vm, count, 4, [&](std::size_t begin, std::size_t end) {
    if (!list.holds_references()) {
      std::memmove(static_cast<void*>(to + begin), from.data + begin, (end - begin) * sizeof(Slot));
      return;
    }
    for (std::size_t i = begin; i < end; ++i) {
      Obj* object = from.data[i].o;
      retain_object(object);
      set_reference(state, to[i], object);
    }
  });
}

static bool insert_at(VmState& state, Slot& place, std::int64_t index, Slot value) {
  if (!own(state, place)) return false;
  ListObj& list = list_in(place);
  if (static_cast<std::uint64_t>(index) > list.size) {
    return raise_end(state, index, list.size, list.size);
  }
  if (!reserve_list(state.heap, list, std::uint64_t{list.size} + 1))
    return raise_out_of_memory(state);
  if (!charge_work(state.vm, list.size - static_cast<std::uint64_t>(index))) return false;
  std::memmove(static_cast<void*>(list.data + index + 1), list.data + index,
               (list.size - index) * sizeof(Slot));
  list.data[index] = value;
  ++list.size;
  return true;
}

// The count of the object increases first, so that a list that is inserted into itself counts as
// shared.
static bool insert_reference(VmState& state, Slot& place, std::int64_t index, Obj* object) {
  retain_object(object);
  if (insert_at(state, place, index, slot_of(object))) return true;
  state.heap.release(object);
  return false;
}

bool op_pushref(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = place_in(base[pc->a]);
  return insert_reference(state, place, list_in(place).size, base[pc->b].o);
}

bool op_insert(VmState& state, Slot* base, const Instr* pc) {
  return insert_at(state, place_in(base[pc->a]), base[pc->b].i, base[pc->c]);
}

bool op_insertref(VmState& state, Slot* base, const Instr* pc) {
  return insert_reference(state, place_in(base[pc->a]), base[pc->b].i, base[pc->c].o);
}

bool op_pop(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = place_in(base[pc->b]);
  if (!own(state, place)) return false;
  ListObj& list = list_in(place);
  const Slot wanted = base[pc->c];
  const std::int64_t index = is_absent_scalar(wanted) ? std::int64_t{list.size} - 1 : wanted.i;
  if (static_cast<std::uint64_t>(index) >= list.size) return raise_index(state, index, list.size);
  if (list.holds_references() && list.data[index].o == nullptr)
    return raise_unset_element(state, index);
  if (!charge_work(state.vm, list.size - static_cast<std::uint64_t>(index))) return false;
  base[pc->a] = list.data[index];
  --list.size;
  std::memmove(static_cast<void*>(list.data + index), list.data + index + 1,
               (list.size - index) * sizeof(Slot));
  return true;
}

// ---- failures -------------------------------------------------------------------------------

bool op_makeerr(VmState& state, Slot* base, const Instr* pc) {
  auto* kind = static_cast<TextObj*>(base[pc->c].o);
  return put_new(state, base[pc->a], make_error(state, &text_in(base[pc->b]), kind));
}

bool op_throw(VmState& state, Slot* base, const Instr* pc) {
  return throw_error(state, *static_cast<RecordObj*>(base[pc->a].o));
}

bool op_rethrow(VmState& state, Slot* base, const Instr* pc) {
  return rethrow(state, base[pc->a].o);
}

bool op_catch(VmState& state, Slot* base, const Instr* pc) {
  return put_new(state, base[pc->a], catch_error(state));
}

bool op_hold(VmState& state, Slot* base, const Instr* pc) {
  return put_new(state, base[pc->a], hold_fault(state));
}

bool op_retry(VmState& state, Slot* base, const Instr* pc) {
  constexpr std::int64_t kMostRetries = 1000;
  Slot& count = base[pc->a];
  Slot& instant = base[pc->b];
  const std::int64_t now = state.vm.timeline().now_ns();
  if (count.i == 0 || instant.i != now) count.i = 0;
  instant.i = now;
  if (++count.i > kMostRetries) return raise(state, "R0615", {std::to_string(kMostRetries)});
  return true;
}

bool op_assertfail(VmState& state, Slot* base, const Instr* pc) {
  return raise_assertion(state, state.code().noted->asserts[pc->a],
                         static_cast<TextObj*>(base[pc->b].o), static_cast<TextObj*>(base[pc->c].o),
                         base);
}

bool op_expecterr(VmState& state, Slot* base, const Instr* pc) {
  const auto* thrown = static_cast<RecordObj*>(base[pc->b].o);
  const auto* kind = static_cast<TextObj*>(base[pc->c].o);
  return raise_expectation(state, *state.code().noted->expects[pc->a], thrown, kind);
}

bool may_pause(VmState& state) {
  state.steps.left = 0;  // counted again below
  return state.host.calls == 0 && state.steps.slice_is_over();
}

// The frame has been saved after the MARK, which is executed again when the run continues.
bool stops_at_mark(VmState& state) {
  Marks& marks = state.marks;
  if (state.host.calls != 0) {  // a pause of the run stays as it is while the host calls functions
    ++marks.begun;
    return false;
  }
  const bool was_at_breakpoint = std::exchange(marks.is_at_breakpoint, false);
  if (!was_at_breakpoint && !marks.breakpoints.empty()) {
    const CodeSpan* at = code_span(state);
    const SourceLine here{at->span.source, line_of(state, at->span)};
    marks.is_at_breakpoint = std::ranges::binary_search(marks.breakpoints, here);
  }
  const bool stops = marks.is_at_breakpoint || marks.begun >= marks.pause_at;
  marks.paused = stops ? state.running : nullptr;
  if (!stops) ++marks.begun;
  return stops;
}

void stop_at_next_step(VmState& state) {
  state.vm.cancel();
  state.steps.settle();
}

bool count_slowly(VmState& state) {
  state.steps.left = 0;  // counted again below
  if (state.take_cancellation()) return raise_cancelled(state);
  if (!state.steps.refill()) return raise_out_of_steps(state);
  --state.steps.left;
  return true;
}

bool raise_unset(VmState& state, std::uint32_t global) {
  const hir::Variable& variable = *state.globals.info[global].variable;
  Diagnostic failure = start_failure(state, "R0623", {std::string(variable.name)});
  failure.related.push_back({variable.declared, "it is declared here"});
  return raise(state, std::move(failure));
}

}  // namespace armlet::lang
