#include "vm/heap/heap.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace armlet::lang {

namespace {

template <class T>
T* begin_object(void* block, ObjKind kind) {
  if (block == nullptr) return nullptr;
  T* object = static_cast<T*>(block);
  object->refs = 1;
  object->kind = kind;
  object->flags = 0;
  object->extra = 0;
  return object;
}

// Storage of a list: the count of elements that have room behind the header, and the address of the
// elements.
std::size_t room_of(const ListObj& list) { return list.flags >> 1U; }
Slot* own_room(ListObj& list) { return reinterpret_cast<Slot*>(&list + 1); }

std::size_t host_bytes(const HostType& type) { return HostObj::kPayloadOffset + type.size; }
std::size_t matrix_bytes(const MatrixObj& m) {
  return sizeof(MatrixObj) + sizeof(double) * m.rows * m.cols;
}

// Dead objects form a list: the fields for the count and `extra` have the address of the next dead
// object. With pointers of eight bytes, blocks are aligned to 16 bytes, so the 48 bits are enough
// for addresses of 52 bits.
constexpr unsigned kUnusedBits = sizeof(void*) == 8 ? 4 : 0;
void link_dead(Obj* object, Obj* next) {
  const auto bits = std::uint64_t{reinterpret_cast<std::uintptr_t>(next)} >> kUnusedBits;
  object->refs = static_cast<std::uint32_t>(bits);
  object->extra = static_cast<std::uint16_t>(bits >> 32U);
}
Obj* linked_dead(const Obj* object) {
  const auto bits = (std::uint64_t{object->extra} << 32U) | object->refs;
  return reinterpret_cast<Obj*>(static_cast<std::uintptr_t>(bits << kUnusedBits));
}

}  // namespace

// A pointer before a closure leads to the list of its captures that are references.
struct ClosureReferences {
  const std::vector<std::uint16_t>* captured;
};
static const ClosureReferences& references_of(const ClosureObj& closure, std::uint16_t captures) {
  return *reinterpret_cast<const ClosureReferences*>(closure.captures() + captures);
}

Heap::~Heap() {
  for (std::size_t i = 0; i < chunks_.size(); ++i) return_block(chunks_[i], size_of_chunk(i));
}

void* Heap::take_slowly(std::size_t units) {
  const std::uint64_t bytes = static_cast<std::uint64_t>(units) * kUnit;
  if (is_refused()) return nullptr;
  make_way(bytes);
  if (bytes > limit_ || used_ > limit_ - bytes) return nullptr;
  void* block = nullptr;
  if (units < kClasses && free_[units] != nullptr) {
    block = free_[units];
    free_[units] = free_[units]->next;
  } else {
    block = units < kClasses ? carve(units) : reserve(bytes);
  }
  if (block != nullptr) used_ += bytes;
  return block;
}

// Frees dead objects until there is room for `bytes`. A few are freed each time before the heap
// grows.
void Heap::make_way(std::uint64_t bytes) {
  was_refused_ = false;
  if (dead_ != nullptr) reclaim(kReclaimed);
  while (dead_ != nullptr && (bytes > limit_ - std::min(limit_, used_) || !has_room(bytes)))
    reclaim(kReclaimed);
}

// Pages that come from the system are zeros already.
void* Heap::take_zeros(std::size_t bytes) {
  const std::size_t units = units_of(bytes);
  const std::uint64_t size = std::uint64_t{units} * kUnit;
  if (size < kChunk) {
    void* block = take(bytes);
    if (block != nullptr) std::memset(block, 0, bytes);
    return block;
  }
  if (is_refused()) return nullptr;
  make_way(size);
  if (size > limit_ || used_ > limit_ - size || !has_room(size)) return nullptr;
  void* block = obtain(size, true);
  if (block == nullptr) return nullptr;
  used_ += size;
  reserved_ += size;
  return block;
}

bool Heap::charge(std::uint64_t bytes) {
  if (is_refused()) return false;
  make_way(bytes);
  if (bytes > limit_ || used_ > limit_ - bytes || !has_room(bytes)) return false;
  used_ += bytes;
  reserved_ += bytes;
  return true;
}

void* Heap::carve(std::size_t units) {
  const std::size_t bytes = units * kUnit;
  if (static_cast<std::size_t>(chunk_end_ - chunk_at_) < bytes) {
    // Reserving first: if it throws, no memory is lost.
    if (chunks_.size() == chunks_.capacity()) chunks_.reserve(2 * chunks_.size() + 1);
    const std::size_t size = size_of_chunk(chunks_.size());
    auto* chunk = static_cast<std::byte*>(reserve(size));
    if (chunk == nullptr) return nullptr;
    chunks_.push_back(chunk);
    chunk_at_ = chunk;
    chunk_end_ = chunk + size;
  }
  void* block = chunk_at_;
  chunk_at_ += bytes;
  return block;
}

// Whether `bytes` more from the system stay within the limit and its tolerance.
bool Heap::has_room(std::size_t bytes) const {
  const std::uint64_t most = limit_ + limit_ / 100 + kChunk;
  return reserved_ <= most && bytes <= most - reserved_;
}

void* Heap::reserve(std::size_t bytes) {
  if (!has_room(bytes)) return nullptr;
  void* block = obtain(bytes, false);
  if (block != nullptr) reserved_ += bytes;
  return block;
}

// Gets memory from the host's allocator, or from the system.
void* Heap::obtain(std::size_t bytes, bool zero) {
  void* block = nullptr;
  if (memory_.take != nullptr) {
    block = memory_.take(memory_.context, bytes);
    if (zero && block != nullptr) std::memset(block, 0, bytes);
  } else {
    block = zero ? std::calloc(bytes, 1) : std::malloc(bytes);
  }
  was_refused_ = block == nullptr;
  return block;
}

void Heap::return_block(void* block, std::size_t bytes) {
  if (memory_.take != nullptr) return memory_.give_back(memory_.context, block, bytes);
  std::free(block);
}

void Heap::free_large(void* block, std::size_t units) {
  reserved_ -= units * kUnit;
  return_block(block, units * kUnit);
}

void* Heap::resize(void* block, std::size_t old_bytes, std::size_t new_bytes) {
  const std::size_t old_units = units_of(old_bytes);
  const std::size_t new_units = units_of(new_bytes);
  if (block != nullptr && old_units == new_units) return block;
  const bool may_move = refuse_from_ == 0 && memory_.take == nullptr;
  if (block != nullptr && old_units >= kClasses && new_units >= kClasses && may_move) {
    if (new_units > old_units) make_way((new_units - old_units) * kUnit);
    const std::uint64_t others = used_ - old_units * kUnit;
    if (new_units * kUnit > limit_ || others > limit_ - new_units * kUnit) return nullptr;
    if (new_units > old_units && !has_room((new_units - old_units) * kUnit)) return nullptr;
    void* moved = std::realloc(block, new_units * kUnit);
    was_refused_ = moved == nullptr;
    if (was_refused_) return nullptr;
    used_ = others + new_units * kUnit;
    reserved_ += (new_units - old_units) * kUnit;
    return moved;
  }
  void* fresh = take(new_bytes);
  if (fresh == nullptr || block == nullptr) return fresh;
  std::memcpy(fresh, block, old_bytes < new_bytes ? old_bytes : new_bytes);
  give_back(block, old_bytes);
  return fresh;
}

TextObj* Heap::new_text_buffer(std::size_t size) {
  if (size > kMaxCount) return nullptr;
  auto* text = begin_object<TextObj>(take(sizeof(TextObj) + size), ObjKind::kText);
  if (text == nullptr) return nullptr;
  text->size = static_cast<std::uint32_t>(size);
  text->capacity = text->size;
  text->characters = TextObj::kUncounted;
  text->marks = 0;
  return text;
}

TextObj* Heap::new_text(std::string_view characters) {
  TextObj* text = new_text_buffer(characters.size());
  if (text != nullptr && !characters.empty())
    std::memcpy(text->data(), characters.data(), characters.size());
  return text;
}

ListObj* Heap::new_list(std::uint64_t size, bool references) {
  return make_list(size, references, true);
}

ListObj* Heap::new_list_unset(std::uint64_t size, bool references) {
  return make_list(size, references, false);
}

ListObj* Heap::make_list(std::uint64_t size, bool references, bool zero) {
  if (size > kMaxCount) return nullptr;
  const bool is_short = size <= kShortList;
  auto* list = begin_object<ListObj>(take(sizeof(ListObj) + (is_short ? size * sizeof(Slot) : 0)),
                                     ObjKind::kList);
  if (list == nullptr) return nullptr;
  list->size = static_cast<std::uint32_t>(size);
  list->capacity = list->size;
  list->flags = static_cast<std::uint8_t>((is_short ? size << 1U : 0U) |
                                          (references ? ListObj::kReferences : 0U));
  if (is_short) {
    list->data = own_room(*list);
    if (zero && size > 0) std::memset(static_cast<void*>(list->data), 0, size * sizeof(Slot));
    return list;
  }
  const std::uint64_t bytes = size * sizeof(Slot);
  list->data = static_cast<Slot*>(zero ? take_zeros(bytes) : take(bytes));
  if (list->data != nullptr) return list;
  give_back(list, sizeof(ListObj));
  return nullptr;
}

MapObj* Heap::new_map(std::uint8_t flags, std::uint32_t capacity) {
  if (capacity > kMaxCount) return nullptr;
  auto* map = begin_object<MapObj>(take(sizeof(MapObj)), ObjKind::kMap);
  if (map == nullptr) return nullptr;
  map->flags = flags;
  map->size = map->used = 0;
  map->capacity = capacity;
  map->entries = nullptr;
  if (capacity == 0) return map;
  map->entries = static_cast<MapEntry*>(take(map_bytes(capacity)));
  if (map->entries != nullptr) {
    std::memset(static_cast<void*>(map->entries + capacity), 0,
                map_bytes(capacity) - capacity * sizeof(MapEntry));
    return map;
  }
  give_back(map, sizeof(MapObj));
  return nullptr;
}

RecordObj* Heap::new_record(const RecordLayout& layout) {
  auto* record = begin_object<RecordObj>(take(sizeof(RecordObj) + sizeof(Slot) * layout.size),
                                         ObjKind::kRecord);
  if (record != nullptr) record->layout = &layout;
  return record;
}

MatrixObj* Heap::new_matrix(std::uint32_t rows, std::uint32_t cols) {
  return make_matrix(rows, cols, false);
}

MatrixObj* Heap::new_zero_matrix(std::uint32_t rows, std::uint32_t cols) {
  return make_matrix(rows, cols, true);
}

MatrixObj* Heap::make_matrix(std::uint32_t rows, std::uint32_t cols, bool zero) {
  const std::uint64_t count = static_cast<std::uint64_t>(rows) * cols;
  if (count > kMaxCount) return nullptr;
  const std::uint64_t bytes = sizeof(MatrixObj) + sizeof(double) * count;
  auto* matrix = begin_object<MatrixObj>(zero ? take_zeros(bytes) : take(bytes), ObjKind::kMatrix);
  if (matrix == nullptr) return nullptr;
  matrix->rows = rows;
  matrix->cols = cols;
  return matrix;
}

ClosureObj* Heap::new_closure(std::uint32_t function, std::uint16_t captures,
                              const std::vector<std::uint16_t>* references) {
  const std::size_t bytes = sizeof(Slot) * captures + sizeof(ClosureReferences);
  auto* closure = begin_object<ClosureObj>(take(sizeof(ClosureObj) + bytes), ObjKind::kClosure);
  if (closure == nullptr) return nullptr;
  closure->extra = captures;
  closure->function = function;
  closure->reserved = captures;  // `extra` is overwritten when the object dies
  reinterpret_cast<ClosureReferences*>(closure->captures() + captures)->captured = references;
  return closure;
}

BoxObj* Heap::new_box(bool reference) {
  auto* box = begin_object<BoxObj>(take(sizeof(BoxObj)), ObjKind::kBox);
  if (box == nullptr) return nullptr;
  box->flags = reference ? 1 : 0;
  box->value.i = 0;
  return box;
}

HostObj* Heap::new_host(const HostType& type) {
  auto* host = begin_object<HostObj>(take(host_bytes(type)), ObjKind::kHost);
  if (host == nullptr) return nullptr;
  host->reserved = 0;
  host->type = &type;
  return host;
}

// ---- destruction ----------------------------------------------------------------------------

Obj* Heap::bury(Obj* object, Obj* waiting) {
  if (object == nullptr || --object->refs != 0) return waiting;
  link_dead(object, waiting);
  return object;
}

Obj* Heap::bury_children(const Slot* slots, std::uint32_t count, Obj* waiting) {
  for (std::uint32_t i = 0; i < count; ++i) waiting = bury(slots[i].o, waiting);
  return waiting;
}

// Inlined in `destroy`, which takes half of the time for short-lived objects.
[[gnu::always_inline]] inline void Heap::free_object(Obj* object) {
  switch (object->kind) {
    case ObjKind::kText:
      if (static_cast<TextObj*>(object)->marks != 0) [[unlikely]]
        drop_marks(*static_cast<TextObj*>(object));
      return give_back(object, text_bytes(static_cast<TextObj*>(object)->capacity));
    case ObjKind::kList: {
      auto* list = static_cast<ListObj*>(object);
      if (list->data != own_room(*list)) give_back(list->data, list->capacity * sizeof(Slot));
      return give_back(object, sizeof(ListObj) + room_of(*list) * sizeof(Slot));
    }
    case ObjKind::kMap: {
      auto* map = static_cast<MapObj*>(object);
      if (map->capacity > 0) give_back(map->entries, map_bytes(map->capacity));
      return give_back(object, sizeof(MapObj));
    }
    case ObjKind::kRecord:
      return give_back(
          object, sizeof(RecordObj) + sizeof(Slot) * static_cast<RecordObj*>(object)->layout->size);
    case ObjKind::kMatrix:
      return give_back(object, matrix_bytes(*static_cast<MatrixObj*>(object)));
    case ObjKind::kClosure:
      return give_back(object, sizeof(ClosureObj) + sizeof(ClosureReferences) +
                                   sizeof(Slot) * static_cast<ClosureObj*>(object)->reserved);
    case ObjKind::kBox:
      return give_back(object, sizeof(BoxObj));
    case ObjKind::kHost: {
      auto* host = static_cast<HostObj*>(object);
      const HostType& type = *host->type;
      if (type.destroy != nullptr) type.destroy(host->payload());
      return give_back(object, host_bytes(type));
    }
  }
}

void Heap::destroy(Obj* object) {
  link_dead(object, dead_);
  dead_ = object;
  reclaim(kReclaimed);
}

void Heap::drain() {
  while (dead_ != nullptr) reclaim(kReclaimed);
}

// Releases up to `most` elements from the end of a long list. The rest of the list waits with the
// other dead objects.
Obj* Heap::bury_elements(ListObj& list, std::size_t most, Obj* waiting) {
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(list.size, most));
  list.size -= count;
  if (list.size > 0) {
    link_dead(&list, waiting);
    waiting = &list;
  }
  return bury_children(list.data + list.size, count, waiting);
}

Obj* Heap::bury_entries(MapObj& map, std::size_t most, Obj* waiting) {
  const auto count = static_cast<std::uint32_t>(std::min<std::size_t>(map.used, most));
  map.used -= count;
  if (map.used > 0) {
    link_dead(&map, waiting);
    waiting = &map;
  }
  for (const MapEntry& entry : std::span(map.entries + map.used, count)) {
    if (map.has_text_keys()) waiting = bury(entry.key.o, waiting);
    if (map.holds_references()) waiting = bury(entry.value.o, waiting);
  }
  return waiting;
}

void Heap::reclaim(std::size_t most) {
  Obj* waiting = dead_;
  for (; waiting != nullptr && most > 0; --most) {
    Obj* dead = waiting;
    waiting = linked_dead(dead);
    switch (dead->kind) {
      case ObjKind::kList:
        if (auto* list = static_cast<ListObj*>(dead); list->holds_references()) {
          waiting = bury_elements(*list, kReclaimed, waiting);
          if (list->size > 0) continue;
        }
        break;
      case ObjKind::kMap:
        if (auto* map = static_cast<MapObj*>(dead); map->flags != 0) {
          waiting = bury_entries(*map, kReclaimed, waiting);
          if (map->used > 0) continue;
        }
        break;
      case ObjKind::kRecord: {
        const auto* record = static_cast<RecordObj*>(dead);
        for (const std::uint16_t field : record->layout->references) {
          waiting = bury(record->fields()[field].o, waiting);
        }
        break;
      }
      case ObjKind::kClosure: {
        const auto* closure = static_cast<ClosureObj*>(dead);
        const auto captures = static_cast<std::uint16_t>(closure->reserved);
        const auto* references = references_of(*closure, captures).captured;
        if (references == nullptr) break;
        for (const std::uint16_t capture : *references) {
          waiting = bury(closure->captures()[capture].o, waiting);
        }
        break;
      }
      case ObjKind::kBox:
        if (dead->flags != 0) waiting = bury(static_cast<BoxObj*>(dead)->value.o, waiting);
        break;
      case ObjKind::kText:
      case ObjKind::kMatrix:
      case ObjKind::kHost:
        break;
    }
    free_object(dead);
  }
  dead_ = waiting;
}

// ---- copy on write --------------------------------------------------------------------------

static ListObj* copy_list(Heap& heap, const ListObj& old) {
  ListObj* list = heap.new_list_unset(old.size, old.holds_references());
  if (list == nullptr) return nullptr;
  if (old.size > 0) std::memcpy(static_cast<void*>(list->data), old.data, old.size * sizeof(Slot));
  if (old.holds_references()) {
    for (std::uint32_t i = 0; i < old.size; ++i) retain_object(list->data[i].o);
  }
  return list;
}

static RecordObj* copy_record(Heap& heap, const RecordObj& old) {
  RecordObj* record = heap.new_record(*old.layout);
  if (record == nullptr) return nullptr;
  std::memcpy(static_cast<void*>(record->fields()), old.fields(), old.layout->size * sizeof(Slot));
  for (const std::uint16_t field : old.layout->references) retain_object(record->fields()[field].o);
  return record;
}

static MatrixObj* copy_matrix(Heap& heap, const MatrixObj& old) {
  MatrixObj* matrix = heap.new_matrix(old.rows, old.cols);
  if (matrix != nullptr)
    std::memcpy(matrix->data(), old.data(), sizeof(double) * old.rows * old.cols);
  return matrix;
}

bool copy_shared(Heap& heap, Slot& place) {
  Obj* old = place.o;
  Obj* copy = nullptr;
  if (old->kind == ObjKind::kList) copy = copy_list(heap, *static_cast<ListObj*>(old));
  if (old->kind == ObjKind::kRecord) copy = copy_record(heap, *static_cast<RecordObj*>(old));
  if (old->kind == ObjKind::kMatrix) copy = copy_matrix(heap, *static_cast<MatrixObj*>(old));
  if (copy == nullptr) return false;
  --old->refs;  // it is shared, so it has other owners
  place.o = copy;
  return true;
}

bool reserve_list(Heap& heap, ListObj& list, std::uint64_t capacity) {
  if (capacity <= list.capacity) return true;
  std::uint64_t wanted = std::uint64_t{list.capacity} + list.capacity / 2;
  if (wanted < capacity) wanted = capacity;
  if (wanted < 4) wanted = 4;
  if (wanted > kMaxCount) return false;
  const bool moves_out = list.data == own_room(list);
  void* data = heap.resize(moves_out ? nullptr : list.data, list.capacity * sizeof(Slot),
                           wanted * sizeof(Slot));
  if (data == nullptr) return false;
  if (moves_out && list.size > 0)
    std::memcpy(data, static_cast<const void*>(list.data), list.size * sizeof(Slot));
  list.data = static_cast<Slot*>(data);
  list.capacity = static_cast<std::uint32_t>(wanted);
  return true;
}

}  // namespace armlet::lang
