// Instructions for texts: comparing, cutting, joining, and converting values to text.

#include <algorithm>
#include <cstring>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/instructions/slow_ops.hpp"

namespace armlet::lang {

namespace {

TextObj& text_in(Slot s) { return *static_cast<TextObj*>(s.o); }

void set_reference(VmState& state, Slot& place, Obj* object) {
  Obj* old = place.o;
  place.o = object;
  state.heap.release(old);
}

}  // namespace

bool compare_texts(VmState& state, const TextObj& one, const TextObj& other, int& order) {
  const std::string_view a = one.view();
  const std::string_view b = other.view();
  const std::size_t common = std::min(a.size(), b.size());
  order = 0;
  const auto compare = [&](std::size_t begin, std::size_t end) {
    order = a.substr(begin, end - begin).compare(b.substr(begin, end - begin));
    return order == 0;
  };
  if (!in_blocks(state.vm, common, 1, compare) && order == 0) return false;
  if (order == 0) order = (a.size() > b.size() ? 1 : 0) - (a.size() < b.size() ? 1 : 0);
  order = (order > 0 ? 1 : 0) - (order < 0 ? 1 : 0);
  return true;
}

bool op_cmptext(VmState& state, Slot* base, const Instr* pc) {
  int order = 0;
  if (!compare_texts(state, text_in(base[pc->b]), text_in(base[pc->c]), order)) return false;
  base[pc->a].i = order;
  return true;
}

bool count_characters(VmState& state, TextObj& text) {
  if (text.characters != TextObj::kUncounted) return true;
  std::uint32_t count = 0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    count += characters_in(text.view().substr(begin, end - begin));
  };
  if (!in_blocks(state.vm, text.size, 1, add)) return false;
  text.characters = count;
  return true;
}

// Stores the byte offset of every kMarked-th character of a counted text. Returns false, with the
// failure set, if a stop is due. If the heap is full the text stays without these marks, which is
// no failure.
static bool mark_characters(VmState& state, TextObj& text) {
  if (text.marks != 0) return true;
  const std::uint32_t count = text.characters / Heap::kMarked + 1;
  std::uint32_t* marks = state.heap.make_marks(text, count);
  if (marks == nullptr) return true;
  std::uint32_t seen = 0;
  const auto mark = [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; ++at) {
      if (!starts_character(text.data()[at])) continue;
      if (seen % Heap::kMarked == 0) marks[seen / Heap::kMarked] = static_cast<std::uint32_t>(at);
      ++seen;
    }
  };
  if (in_blocks(state.vm, text.size, 1, mark)) return true;
  state.heap.forget_characters(text);
  return false;
}

// Finds the byte offset of character `index`, which is at most the count of characters.
static bool find_character(VmState& state, TextObj& text, std::uint32_t index,
                           std::uint32_t& offset) {
  // Bytes; texts up to this length are searched from the start.
  constexpr std::uint32_t kShort = 256;
  if (text.characters == text.size || index == text.characters) {
    offset = text.characters == text.size ? index : text.size;
    return true;
  }
  if (text.size > kShort && !mark_characters(state, text)) return false;
  const std::uint32_t* marks = state.heap.marks_of(text);
  const std::uint32_t from = marks == nullptr ? 0 : marks[index / Heap::kMarked];
  const std::uint32_t left = marks == nullptr ? index : index % Heap::kMarked;
  if (marks == nullptr && text.size > kShort && !charge_work(state.vm, text.size)) return false;
  offset = from + offset_in(text.view().substr(from), left);
  return true;
}

// A part of a text whose characters have been counted; null, with the failure set, if it cannot be
// made.
static Obj* part_of_text(VmState& state, TextObj& text, std::uint32_t first, std::uint32_t last) {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  if (!find_character(state, text, first, begin)) return nullptr;
  if (last == first + 1 && begin < text.size) {
    end = begin + 1;
    while (end < text.size && !starts_character(text.data()[end])) ++end;
  } else if (!find_character(state, text, last, end)) {
    return nullptr;
  }
  const auto byte = begin < text.size ? static_cast<unsigned char>(text.data()[begin]) : 0U;
  if (end - begin == 1 && byte < 128) {
    Obj* shared = state.character(static_cast<unsigned char>(byte));
    retain_object(shared);
    if (shared == nullptr) raise_out_of_memory(state);
    return shared;
  }
  TextMaker piece(state.vm);
  return piece.add(text.view().substr(begin, end - begin)) ? piece.take() : nullptr;
}

static bool put_part(VmState& state, Slot& place, Obj* part) {
  if (part == nullptr) return false;
  set_reference(state, place, part);
  return true;
}

bool op_slicetext(VmState& state, Slot* base, const Instr* pc) {
  TextObj& text = text_in(base[pc->b]);
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  if (!count_characters(state, text)) return false;
  if (!slice_ends(state, base + pc->c, character_count(text), "text", first, last)) return false;
  return put_part(state, base[pc->a], part_of_text(state, text, first, last));
}

bool op_charat(VmState& state, Slot* base, const Instr* pc) {
  TextObj& text = text_in(base[pc->b]);
  const std::int64_t index = base[pc->c].i;
  if (!count_characters(state, text)) return false;
  if (static_cast<std::uint64_t>(index) >= character_count(text)) {
    return raise_index(state, index, character_count(text), "text");
  }
  const auto at = static_cast<std::uint32_t>(index);
  return put_part(state, base[pc->a], part_of_text(state, text, at, at + 1));
}

bool op_codeat(VmState& state, Slot* base, const Instr* pc) {
  TextObj& text = text_in(base[pc->b]);
  const std::int64_t index = base[pc->c].i;
  if (!count_characters(state, text)) return false;
  if (static_cast<std::uint64_t>(index) >= character_count(text)) {
    return raise_index(state, index, character_count(text), "text");
  }
  std::uint32_t at = 0;
  if (!find_character(state, text, static_cast<std::uint32_t>(index), at)) return false;
  const auto lead = static_cast<unsigned char>(text.data()[at++]);
  std::int64_t code = lead < 0x80U ? lead
                                   : lead & (lead < 0xE0U   ? 0x1FU
                                             : lead < 0xF0U ? 0x0FU
                                                            : 7U);
  for (; at < text.size && !starts_character(text.data()[at]); ++at) {
    code = code << 6U | (static_cast<unsigned char>(text.data()[at]) & 0x3FU);
  }
  base[pc->a].i = code;
  return true;
}

bool op_totext(VmState& state, Slot* base, const Instr* pc) {
  TextMaker text(state.vm);
  if (!write_value(state.vm, text, base[pc->b], state.code().formats[pc->c])) return false;
  set_reference(state, base[pc->a], text.take());
  return true;
}

bool op_concat(VmState& state, Slot* base, const Instr* pc) {
  const Slot* parts = base + pc->b;
  std::size_t size = 0;
  for (int i = 0; i < pc->c; ++i) size += text_in(parts[i]).size;
  TextObj* whole = state.heap.new_text_buffer(size);
  if (whole == nullptr) return raise_out_of_memory(state);
  char* to = whole->data();
  for (int i = 0; i < pc->c; ++i) {
    const TextObj& part = text_in(parts[i]);
    const auto copy = [&](std::size_t begin, std::size_t end) {
      std::memcpy(to + begin, part.data() + begin, end - begin);
    };
    if (!in_blocks(state.vm, part.size, 1, copy)) {
      state.heap.release(whole);
      return false;
    }
    to += part.size;
  }
  set_reference(state, base[pc->a], whole);
  return true;
}

// Appends the tail in blocks. The text must have room for all of it.
static bool append_in_blocks(VmState& state, TextObj& text, const TextObj& tail) {
  const std::uint32_t before = text.size;
  const std::uint32_t more = tail.size;
  state.heap.forget_characters(text);
  return in_blocks(state.vm, more, 1, [&](std::size_t begin, std::size_t end) {
    std::memcpy(text.data() + before + begin, tail.data() + begin, end - begin);
    text.size = before + static_cast<std::uint32_t>(end);
  });
}

// The tail may be released only if appending all of it was not refused.
bool append_slowly(VmState& state, Slot& place, const TextObj& tail) {
  Heap& heap = state.heap;
  const std::uint64_t size = std::uint64_t{text_in(place).size} + tail.size;
  const bool doubles = &tail == place.o;
  if (place.o->refs != 1 || size > text_in(place).capacity) {
    TextObj* whole = heap.new_text_buffer(size + size / 2);
    if (whole == nullptr) whole = heap.new_text_buffer(size);
    if (whole == nullptr) return raise_out_of_memory(state);
    const TextObj& old = text_in(place);
    whole->size = old.size;
    const auto copy = [&](std::size_t begin, std::size_t end) {
      std::memcpy(whole->data() + begin, old.data() + begin, end - begin);
    };
    if (!in_blocks(state.vm, old.size, 1, copy)) {
      heap.release(whole);
      return false;
    }
    // The old text may be the same object as the tail, which is still needed.
    if (doubles) retain_object(place.o);
    Obj* kept = doubles ? place.o : nullptr;
    set_reference(state, place, whole);
    const bool done =
        append_in_blocks(state, *whole, kept != nullptr ? text_in({.o = kept}) : tail);
    heap.release(kept);
    return done;
  }
  return append_in_blocks(state, text_in(place), tail);
}

}  // namespace armlet::lang

namespace armlet {

bool text_length(Vm& vm, Slot text, std::int64_t& characters) {
  auto& counted = *static_cast<TextObj*>(text.o);
  if (!lang::count_characters(vm.state(), counted)) return false;
  characters = counted.characters;
  return true;
}

Obj* new_text_part(Vm& vm, Slot text, std::int64_t first, std::int64_t last) {
  auto& counted = *static_cast<TextObj*>(text.o);
  if (!lang::count_characters(vm.state(), counted)) return nullptr;
  return lang::part_of_text(vm.state(), counted, static_cast<std::uint32_t>(first),
                            static_cast<std::uint32_t>(last));
}

}  // namespace armlet
