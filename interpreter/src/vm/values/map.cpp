#include "vm/values/map.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "armlet/core/similar.hpp"
#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"

namespace armlet::lang {
namespace {

constexpr std::uint64_t kFewest = 8;                 // entries in the first block of a map
constexpr std::uint64_t kMostEntries = 1ULL << 30U;  // entries
constexpr std::uint32_t kFreeProbes = 16;            // probes beyond this count are counted as work

// Mixes the bits of a number (Steele, Lea and Flood, Fast splittable pseudorandom number
// generators, 2014).
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ bits >> 30U) * 0xBF58'476D'1CE4'E5B9ULL;
  bits = (bits ^ bits >> 27U) * 0x94D0'49BB'1331'11EBULL;
  return bits ^ bits >> 31U;
}

// The first `count` bytes, at most 8, as a number.
std::uint64_t word_of(const char* bytes, std::size_t count) {
  std::uint64_t word = 0;
  if (count >= 4) {  // two halves, which overlap for fewer than 8 bytes
    std::uint32_t begin = 0, end = 0;
    std::memcpy(&begin, bytes, sizeof begin);
    std::memcpy(&end, bytes + count - sizeof end, sizeof end);
    word = std::uint64_t{end} << 32U | begin;
  } else {
    for (std::size_t i = 0; i < count; ++i)
      word = word << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return word;
}

std::uint32_t hash_of(std::string_view text) {
  std::uint64_t hash = text.size() * 0x9E37'79B9'7F4A'7C15ULL;
  constexpr std::size_t kWord = 8;
  while (text.size() > kWord) {
    hash = mixed(hash ^ word_of(text.data(), kWord));
    text.remove_prefix(kWord);
  }
  return static_cast<std::uint32_t>(mixed(hash ^ word_of(text.data(), text.size())));
}

std::uint32_t* index_of(const MapObj& map) {
  return reinterpret_cast<std::uint32_t*>(map.entries + map.capacity);
}

bool is_text_of(const MapEntry& entry, const TextObj* key, std::uint32_t hash) {
  if (entry.hash != hash || entry.is_removed) return false;
  const auto* text = static_cast<const TextObj*>(entry.key.o);
  return text == key || text->view() == key->view();
}

// Computes the hash of a text key; numbers need none.
[[nodiscard]] bool hash_key(VmState& state, const MapObj& map, Slot key, std::uint32_t& hash) {
  hash = 0;
  if (!map.has_text_keys()) return true;
  const std::string_view text = static_cast<TextObj*>(key.o)->view();
  hash = hash_of(text);
  return charge_work(state.vm, text.size() / 4);
}

// The sequence of index slots where a key may be (open addressing with double hashing). Numbers
// begin near their own value, so that keys that are consecutive numbers never collide; keys with
// the same first slot continue with steps of different lengths (D. E. Knuth, The Art of Computer
// Programming 3, 1998, 6.4, algorithm D).
template <bool is_text>
class Places {
 public:
  Places(const MapObj& map, Slot key, std::uint32_t hash)
      : mask_(2 * map.capacity - 1), key_(static_cast<std::uint64_t>(key.i)), hash_(hash) {
    at_ = (is_text ? hash : static_cast<std::uint32_t>(key_ ^ key_ >> 16U)) & mask_;
  }

  [[nodiscard]] std::uint32_t at() const { return at_; }
  void next() {
    if (step_ == 0) step_ = (is_text ? hash_ : static_cast<std::uint32_t>(mixed(key_))) >> 16U | 1U;
    at_ = (at_ + step_) & mask_;
  }

 private:
  std::uint32_t mask_;
  std::uint64_t key_;
  std::uint32_t hash_;
  std::uint32_t at_;
  std::uint32_t step_ = 0;
};

template <bool is_text>
MapEntry* look_up(const MapObj& map, Slot key, std::uint32_t hash, std::uint32_t& probes) {
  const std::uint32_t* const index = index_of(map);
  for (Places<is_text> places(map, key, hash); index[places.at()] != 0; places.next()) {
    MapEntry& found = map.entries[index[places.at()] - 1];
    ++probes;
    if constexpr (is_text) {
      if (is_text_of(found, static_cast<TextObj*>(key.o), hash)) return &found;
    } else {
      if (found.key.i == key.i && !found.is_removed) return &found;
    }
  }
  return nullptr;
}

template <bool is_text>
void enter_as(const MapObj& map, std::uint32_t number) {
  const MapEntry& entry = map.entries[number];
  std::uint32_t* const index = index_of(map);
  Places<is_text> places(map, entry.key, entry.hash);
  while (index[places.at()] != 0) places.next();
  index[places.at()] = number + 1;
}

// Adds the entry with this number, counted from 0, to the index.
void enter(const MapObj& map, std::uint32_t number) {
  map.has_text_keys() ? enter_as<true>(map, number) : enter_as<false>(map, number);
}

// Moves the entries that are not removed to a block with room for `capacity` entries.
bool move_entries(VmState& state, MapObj& map, std::uint64_t capacity) {
  if (capacity > kMostEntries) return raise_out_of_memory(state);
  MapObj* fresh = state.heap.new_map(map.flags, static_cast<std::uint32_t>(capacity));
  if (fresh == nullptr) return raise_out_of_memory(state);
  const auto move = [&](std::size_t begin, std::size_t end) {
    for (const MapEntry& entry : map.all().subspan(begin, end - begin)) {
      if (entry.is_removed) continue;
      fresh->entries[fresh->used] = entry;
      enter(*fresh, fresh->used++);
    }
  };
  const bool moved = in_blocks(state.vm, map.used, 8, move);
  if (moved) {
    std::swap(map.entries, fresh->entries);
    std::swap(map.capacity, fresh->capacity);
    map.used = fresh->used;
  }
  fresh->used = 0;  // the old block owns no entries any more
  state.heap.release(fresh);
  return moved;
}

bool make_room(VmState& state, MapObj& map) {
  if (map.used < map.capacity) return true;
  // At least a third of the new block is free, so that the average cost of moving is small.
  const std::uint64_t wanted = std::uint64_t{map.size} + map.size / 2 + 1;
  return move_entries(state, map, std::max(kFewest, std::bit_ceil(wanted)));
}

}  // namespace

std::uint8_t map_flags(const Type& type) {
  return static_cast<std::uint8_t>((type.element->is_reference() ? MapObj::kReferences : 0U) |
                                   (type.key->is(Kind::kText) ? MapObj::kTextKeys : 0U));
}

bool find_entry(VmState& state, const MapObj& map, Slot key, std::uint32_t hash, MapEntry*& entry) {
  entry = nullptr;
  if (map.size == 0) return true;
  std::uint32_t probes = 0;
  if (!map.has_text_keys()) {
    entry = look_up<false>(map, key, hash, probes);
    return probes <= kFreeProbes || charge_work(state.vm, probes * 2);
  }
  entry = look_up<true>(map, key, hash, probes);
  const std::uint64_t bytes = static_cast<TextObj*>(key.o)->size / 8;
  if (entry != nullptr && probes <= kFreeProbes && 2 * bytes < kWorkPerStep)
    state.shared.last_entry = {map.entries, static_cast<std::uint32_t>(entry - map.entries)};
  return probes <= kFreeProbes || charge_work(state.vm, probes * (2 + bytes));
}

// Programs often look the same text up several times in a row, as in `if (m.has(k)) m[k] += 1`, so
// the last entry that was found is tried first. Texts count as equal here only if they are the same
// object. Only entries that were found without counted work are stored, so that lookups by a host
// do not change the steps of the program.
static MapEntry* find_again(const VmState& state, const MapObj& map, Slot key) {
  const LastEntry& last = state.shared.last_entry;
  if (!map.has_text_keys() || last.entries != map.entries || last.number >= map.used)
    return nullptr;
  MapEntry& found = map.entries[last.number];
  return found.key.o == key.o && !found.is_removed ? &found : nullptr;
}

bool find_entry(VmState& state, const MapObj& map, Slot key, MapEntry*& entry) {
  entry = find_again(state, map, key);
  if (entry != nullptr) return true;
  std::uint32_t hash = 0;
  return hash_key(state, map, key, hash) && find_entry(state, map, key, hash, entry);
}

bool find_or_add(VmState& state, MapObj& map, Slot key, MapEntry*& entry) {
  entry = find_again(state, map, key);
  if (entry != nullptr) return true;
  std::uint32_t hash = 0;
  if (!hash_key(state, map, key, hash) || !find_entry(state, map, key, hash, entry)) return false;
  if (entry != nullptr) return true;
  if (!make_room(state, map)) return false;
  entry = &map.entries[map.used];
  *entry = {.key = key, .value = Slot{.i = 0}, .hash = hash, .is_removed = false};
  if (map.has_text_keys()) retain_object(key.o);
  enter(map, map.used++);
  ++map.size;
  return true;
}

Slot remove_entry(VmState& state, MapObj& map, MapEntry& entry) {
  const Slot value = entry.value;
  if (map.has_text_keys()) state.heap.release(entry.key.o);
  entry = {.key = Slot{.i = 0}, .value = Slot{.i = 0}, .hash = entry.hash, .is_removed = true};
  --map.size;
  return value;
}

MapObj* copy_map(VmState& state, const MapObj& old) {
  MapObj* copy = state.heap.new_map(old.flags, old.capacity);
  if (copy == nullptr) {
    raise_out_of_memory(state);
    return nullptr;
  }
  copy->size = old.size;
  const auto copy_entries = [&](std::size_t begin, std::size_t end) {
    for (const MapEntry& entry : old.all().subspan(begin, end - begin)) {
      if (copy->has_text_keys()) retain_object(entry.key.o);
      if (copy->holds_references()) retain_object(entry.value.o);
      copy->entries[copy->used++] = entry;
    }
  };
  if (!in_blocks(state.vm, old.used, 8, copy_entries)) {
    state.heap.release(copy);
    return nullptr;
  }
  if (old.capacity > 0)
    std::memcpy(index_of(*copy), index_of(old), 2 * sizeof(std::uint32_t) * old.capacity);
  return copy;
}

// ---- failures -------------------------------------------------------------------------------

namespace {

constexpr std::size_t kNamed = 3;       // keys that a message names
constexpr std::size_t kCompared = 200;  // keys that are compared for it

std::string key_text(Slot key, const Type& type) {
  if (!type.is(Kind::kText)) return value_text(key, type);
  constexpr std::size_t kLongest = 40;
  const std::string_view text = static_cast<TextObj*>(key.o)->view();
  std::size_t end = std::min(text.size(), kLongest);
  while (end < text.size() && end > 0 && !starts_character(text[end])) --end;
  return '"' + std::string(text.substr(0, end)) + (end < text.size() ? "...\"" : "\"");
}

// The distance of a key from the missing one, for sorting proposals.
std::uint64_t distance(Slot a, Slot b, const Type& type) {
  if (type.is(Kind::kText))
    return edit_distance(static_cast<TextObj*>(a.o)->view(), static_cast<TextObj*>(b.o)->view());
  const auto from = static_cast<std::uint64_t>(std::min(a.i, b.i));
  return static_cast<std::uint64_t>(std::max(a.i, b.i)) - from;
}

// Text for a message: "the nearest keys are "bolt" and "belt"", or all keys if there are few.
std::string other_keys(const MapObj& map, Slot key, const Type& type) {
  if (map.size == 0) return "the map is empty";
  std::vector<std::pair<std::uint64_t, Slot>> found;
  for (const MapEntry& entry : map.all()) {
    if (entry.is_removed) continue;
    if (found.size() == kCompared) break;
    found.emplace_back(distance(entry.key, key, type), entry.key);
  }
  const bool all = found.size() <= kNamed;
  const auto nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
  if (!all && !type.is(Kind::kEnum)) std::ranges::stable_sort(found, nearer);
  found.resize(std::min(found.size(), kNamed));
  std::string out = all ? "its " : "the nearest ";
  out += found.size() == 1 ? "only key is " : "keys are ";
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i > 0) out += i + 1 < found.size() ? ", " : " and ";
    out += key_text(found[i].second, type);
  }
  return out;
}

}  // namespace

bool raise_no_key(VmState& state, const MapObj& map, Slot key, const Type& key_type) {
  constexpr std::uint64_t kCost = 1000;  // of the comparison of two keys
  if (!charge_work(state.vm, kCost * std::min<std::size_t>(map.used, kCompared))) return false;
  Diagnostic failure = start_failure(state, "R0638", {key_text(key, key_type)});
  failure.mark.label = other_keys(map, key, key_type);
  return raise(state, std::move(failure));
}

bool raise_key_twice(VmState& state, Slot key, const Type& key_type) {
  return raise(state, "R0639", {key_text(key, key_type)});
}

}  // namespace armlet::lang
