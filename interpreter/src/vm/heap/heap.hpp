#pragma once
// The heap of one Vm, with reference counts. Every block counts for one exact limit, in units of 16
// bytes. The memory that the heap takes from the system stays within 1 % and one chunk of that
// limit, even if free blocks of one size cannot be used for another.
//
// Small blocks come from free lists, one per size; large ones from the system or from the host.
// Destroying an object is not recursive: dead objects wait in a list that is linked through their
// headers. Of many dead objects only some are freed at once, the others when more objects die or
// memory is needed.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string_view>
#include <vector>

#include "armlet/interpreter/host/memory.hpp"
#include "armlet/interpreter/object.hpp"
#include "base/utf8.hpp"

namespace armlet::lang {

class Heap {
 public:
  explicit Heap(std::uint64_t limit, const Memory& memory = {})
      : memory_(memory), limit_(limit), gate_(limit) {}
  ~Heap();
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  // A block of zeros. For a large block the time does not depend on its size.
  [[nodiscard]] void* take_zeros(std::size_t bytes);
  // A block aligned to 16 bytes, or null if it would exceed the limit.
  [[nodiscard]] void* take(std::size_t bytes) {
    const std::size_t units = units_of(bytes);
    if (units < kClasses) [[likely]] {
      FreeBlock* block = free_[units];
      if (block != nullptr && used_ + units * kUnit <= gate_) [[likely]] {
        free_[units] = block->next;
        used_ += units * kUnit;
        return block;
      }
    }
    return take_slowly(units);
  }
  // bytes: the size with which the block was taken.
  void give_back(void* block, std::size_t bytes) {
    const std::size_t units = units_of(bytes);
    used_ -= units * kUnit;
    if (units < kClasses) [[likely]] {
      auto* free = static_cast<FreeBlock*>(block);
      free->next = free_[units];
      free_[units] = free;
    } else {
      free_large(block, units);
    }
  }
  // Changes the size of a block and keeps its first bytes; the block may move. Returns null, with
  // the old block unchanged, if there is no room.
  [[nodiscard]] void* resize(void* block, std::size_t old_bytes, std::size_t new_bytes);

  // Counts memory outside of the heap for its limit; returns false if it would exceed the limit.
  [[nodiscard]] bool charge(std::uint64_t bytes);
  void discharge(std::uint64_t bytes) {
    used_ -= bytes;
    reserved_ -= bytes;
  }

  void release(Obj* object) {
    if (object != nullptr && --object->refs == 0) destroy(object);
  }

  // New objects with a count of one; null if they would exceed the limit.
  [[nodiscard]] TextObj* new_text(std::string_view text);
  [[nodiscard]] TextObj* new_text_buffer(std::size_t size);                     // bytes not set
  [[nodiscard]] ListObj* new_list(std::uint64_t size, bool references);         // elements zero
  [[nodiscard]] ListObj* new_list_unset(std::uint64_t size, bool references);   // elements not set
  [[nodiscard]] MapObj* new_map(std::uint8_t flags, std::uint32_t capacity);    // empty
  [[nodiscard]] RecordObj* new_record(const RecordLayout& layout);              // fields not set
  [[nodiscard]] MatrixObj* new_matrix(std::uint32_t rows, std::uint32_t cols);  // elements not set
  [[nodiscard]] MatrixObj* new_zero_matrix(std::uint32_t rows, std::uint32_t cols);
  [[nodiscard]] ClosureObj* new_closure(
      std::uint32_t function, std::uint16_t captures,
      const std::vector<std::uint16_t>* references);      // captures not set
  [[nodiscard]] BoxObj* new_box(bool reference);          // holds zero
  [[nodiscard]] HostObj* new_host(const HostType& type);  // payload not constructed

  // The table of a text with the byte offsets of every kMarked-th character, `count` of them; null
  // if there is none.
  static constexpr std::uint32_t kMarked = 64;
  [[nodiscard]] const std::uint32_t* marks_of(const TextObj& text) const {
    return text.marks == 0 ? nullptr : marks_[text.marks - 1].offsets;
  }
  // Makes that table, with undefined contents; null if it would exceed the limit.
  [[nodiscard]] std::uint32_t* make_marks(TextObj& text, std::uint32_t count);
  // Removes the character count and the table of a text whose characters change.
  void forget_characters(TextObj& text) {
    text.characters = TextObj::kUncounted;
    if (text.marks != 0) drop_marks(text);
  }

  // Frees all dead objects that are still waiting.
  void drain();
  // If no object is left, returns all memory to the system, since the heap may stay empty for long.
  void rest();

  [[nodiscard]] std::uint64_t used() const { return used_; }
  [[nodiscard]] std::uint64_t limit() const { return limit_; }

  // While a Reserve exists, the limit is a little higher, so that the message of a full heap can be
  // made.
  class Reserve {
   public:
    explicit Reserve(Heap& heap) : heap_(heap) {
      heap_.limit_ += kReserve;
      heap_.close_gate();
    }
    ~Reserve() {
      heap_.limit_ -= kReserve;
      heap_.close_gate();
    }
    Reserve(const Reserve&) = delete;
    Reserve& operator=(const Reserve&) = delete;

   private:
    Heap& heap_;
  };

  // The bytes that the heap has taken from the system.
  [[nodiscard]] std::uint64_t reserved() const { return reserved_; }
  // Whether the last allocation that failed was refused by the host, and did not exceed the limit.
  [[nodiscard]] bool was_refused() const { return was_refused_; }

  // For tests: `count` allocations from the n-th one on (1: the next) are refused. 0: none.
  void refuse_from(std::uint64_t allocation, std::uint64_t count = UINT64_MAX) {
    refuse_from_ = allocation;
    refused_ = count;
    attempts_ = 0;
    close_gate();
  }
  // The count of allocations since then.
  [[nodiscard]] std::uint64_t attempts() const { return attempts_; }

 private:
  struct Marks {
    std::uint32_t* offsets;
    std::uint32_t count;
  };
  struct FreeBlock {
    FreeBlock* next;
  };
  static constexpr std::size_t kUnit = 16;
  static constexpr std::size_t kClasses = 33;  // blocks up to 512 bytes
  static constexpr std::size_t kChunk = 64 * 1024;
  static constexpr std::uint64_t kShortList =
      16;  // longer lists have a second block for their elements
  static constexpr std::uint64_t kReserve = 64 * 1024;
  static constexpr std::size_t kReclaimed = 1024;  // dead objects that are freed at once

  // The size of chunk number i, from 1 kB on: small programs need little memory.
  static std::size_t size_of_chunk(std::size_t i) { return i < 6 ? kChunk >> (6 - i) : kChunk; }
  static std::size_t units_of(std::size_t bytes) { return (bytes + kUnit - 1) / kUnit; }
  // In tests that count allocations the fast path is closed.
  void close_gate() { gate_ = refuse_from_ != 0 ? 0 : limit_; }
  bool is_refused() {
    return refuse_from_ != 0 && ++attempts_ >= refuse_from_ && attempts_ - refuse_from_ < refused_;
  }
  ListObj* make_list(std::uint64_t size, bool references, bool zero);
  MatrixObj* make_matrix(std::uint32_t rows, std::uint32_t cols, bool zero);
  void* take_slowly(std::size_t units);
  void* carve(std::size_t units);
  void free_large(void* block, std::size_t units);
  [[nodiscard]] bool has_room(std::size_t bytes) const;
  [[nodiscard]] void* reserve(std::size_t bytes);
  [[nodiscard]] void* obtain(std::size_t bytes, bool zero);
  void return_block(void* block, std::size_t bytes);
  void destroy(Obj* object);
  void reclaim(std::size_t most);
  void make_way(std::uint64_t bytes);
  Obj* bury_elements(ListObj& list, std::size_t most, Obj* waiting);
  Obj* bury_entries(MapObj& map, std::size_t most, Obj* waiting);
  Obj* bury(Obj* object, Obj* waiting);
  Obj* bury_children(const Slot* slots, std::uint32_t count, Obj* waiting);
  void free_object(Obj* object);
  void drop_marks(TextObj& text);

  Memory memory_;
  bool was_refused_ = false;
  FreeBlock* free_[kClasses] = {};
  Obj* dead_ = nullptr;  // waiting to be freed
  std::uint64_t used_ = 0;
  std::uint64_t limit_;
  std::uint64_t gate_;
  std::byte* chunk_at_ = nullptr;
  std::byte* chunk_end_ = nullptr;
  std::vector<std::byte*> chunks_;
  std::uint64_t reserved_ = 0;
  std::uint64_t refuse_from_ = 0;
  std::uint64_t refused_ = 0;
  std::uint64_t attempts_ = 0;
  std::vector<Marks> marks_;
  std::vector<std::uint32_t> free_marks_;  // free indices of tables
};

inline void Heap::rest() {
  drain();
  if (used_ != 0) return;
  for (std::size_t i = 0; i < chunks_.size(); ++i) free_large(chunks_[i], size_of_chunk(i) / kUnit);
  chunks_ = {};
  chunk_at_ = chunk_end_ = nullptr;
  std::fill(std::begin(free_), std::end(free_), nullptr);
}

// The largest count of elements or bytes in an object. With 32-bit addresses it is so small that
// the size of a block, with at most 32 bytes for each element, fits 32 bits.
inline constexpr std::uint64_t kMaxCount = sizeof(void*) == 8 ? 0xFFFF'FFFEULL : 0x03FF'FFFEULL;
[[nodiscard]] constexpr std::size_t text_bytes(std::uint64_t capacity) {
  return sizeof(TextObj) + capacity;
}

// The size of the block with the entries of a map and their index.
[[nodiscard]] constexpr std::size_t map_bytes(std::uint64_t capacity) {
  return capacity * (sizeof(MapEntry) + 2 * sizeof(std::uint32_t));
}

inline void retain_object(Obj* object) {
  if (object != nullptr) ++object->refs;
}

// Makes the object in `place` the only owner of its contents, by a copy if it is shared. Returns
// false if the heap is full.
[[nodiscard]] bool copy_shared(Heap& heap, Slot& place);

// Makes room for at least `capacity` elements. Returns false if the heap is full.
[[nodiscard]] bool reserve_list(Heap& heap, ListObj& list, std::uint64_t capacity);

// Appends `tail` to the text in `place`, without a copy if the text is not shared. Returns false if
// the heap is full.
[[nodiscard]] bool append_text(Heap& heap, Slot& place, const TextObj& tail);
// Appends a piece to an unshared text; null starts a new one. Returns null, and releases the text,
// if the heap is full.
[[nodiscard]] TextObj* append_bytes(Heap& heap, TextObj* text, std::string_view piece);

// The count of code points in a text, which is stored at the first call.
[[nodiscard]] std::uint32_t character_count(TextObj& text);
// The count of code points that begin in a piece of a text.
[[nodiscard]] std::uint32_t characters_in(std::string_view piece);
[[nodiscard]] std::uint32_t offset_in(std::string_view piece, std::uint32_t index);

// Copies elements, and increases the counts of those that are references.
inline void copy_slots(Slot* to, const Slot* from, std::size_t count, bool references) {
  if (count > 0) std::memcpy(static_cast<void*>(to), from, count * sizeof(Slot));
  for (std::size_t i = 0; references && i < count; ++i) retain_object(to[i].o);
}

}  // namespace armlet::lang
