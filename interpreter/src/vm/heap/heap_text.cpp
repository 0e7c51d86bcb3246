// Texts on the heap: appending, and counting characters.

#include <cstring>

#include "vm/heap/heap.hpp"

namespace armlet::lang {

std::uint32_t* Heap::make_marks(TextObj& text, std::uint32_t count) {
  auto* offsets = static_cast<std::uint32_t*>(take(std::size_t{count} * sizeof(std::uint32_t)));
  if (offsets == nullptr) return nullptr;
  if (free_marks_.empty()) {
    marks_.push_back({});
    free_marks_.push_back(static_cast<std::uint32_t>(marks_.size()));
  }
  text.marks = free_marks_.back();
  free_marks_.pop_back();
  marks_[text.marks - 1] = {offsets, count};
  return offsets;
}

void Heap::drop_marks(TextObj& text) {
  const Marks& marks = marks_[text.marks - 1];
  give_back(marks.offsets, std::size_t{marks.count} * sizeof(std::uint32_t));
  free_marks_.push_back(text.marks);
  text.marks = 0;
}

bool append_text(Heap& heap, Slot& place, const TextObj& tail) {
  auto* text = static_cast<TextObj*>(place.o);
  const std::uint64_t size = std::uint64_t{text->size} + tail.size;
  if (size > kMaxCount) return false;
  const bool shared = text->refs != 1;
  const bool doubles = &tail == text;
  if (shared || size > text->capacity) {
    std::uint64_t capacity = size + size / 2;
    if (capacity > kMaxCount) capacity = size;
    TextObj* grown = shared ? heap.new_text_buffer(capacity)
                            : static_cast<TextObj*>(heap.resize(text, text_bytes(text->capacity),
                                                                text_bytes(capacity)));
    if (grown == nullptr) return false;
    if (shared) {
      std::memcpy(grown->data(), text->data(), text->size);
      grown->size = text->size;
      --text->refs;
    }
    grown->capacity = static_cast<std::uint32_t>(capacity);
    text = grown;
    place.o = grown;
  }
  const char* from = doubles ? text->data() : tail.data();
  std::memmove(text->data() + text->size, from, size - text->size);
  text->size = static_cast<std::uint32_t>(size);
  heap.forget_characters(*text);
  return true;
}

TextObj* append_bytes(Heap& heap, TextObj* text, std::string_view piece) {
  if (text == nullptr) return heap.new_text(piece);
  const std::uint64_t size = std::uint64_t{text->size} + piece.size();
  if (size > text->capacity) {
    std::uint64_t capacity = size + size / 2;
    if (capacity > kMaxCount) capacity = size;
    void* grown = size > kMaxCount
                      ? nullptr
                      : heap.resize(text, text_bytes(text->capacity), text_bytes(capacity));
    // If the heap has no room for the growth reserve, it may still have room for the text alone.
    if (grown == nullptr && size <= kMaxCount) {
      capacity = size;
      grown = heap.resize(text, text_bytes(text->capacity), text_bytes(capacity));
    }
    if (grown == nullptr) {
      heap.release(text);
      return nullptr;
    }
    text = static_cast<TextObj*>(grown);
    text->capacity = static_cast<std::uint32_t>(capacity);
  }
  if (!piece.empty()) std::memcpy(text->data() + text->size, piece.data(), piece.size());
  text->size = static_cast<std::uint32_t>(size);
  heap.forget_characters(*text);
  return text;
}

std::uint32_t characters_in(std::string_view piece) {
  std::uint32_t count = 0;
  for (const char byte : piece) count += starts_character(byte) ? 1 : 0;
  return count;
}

std::uint32_t offset_in(std::string_view piece, std::uint32_t index) {
  std::uint32_t seen = 0;
  std::uint32_t at = 0;
  for (; at < piece.size(); ++at) {
    if (starts_character(piece[at]) && seen++ == index) break;
  }
  return at;
}

std::uint32_t character_count(TextObj& text) {
  if (text.characters == TextObj::kUncounted) text.characters = characters_in(text.view());
  return text.characters;
}

}  // namespace armlet::lang
