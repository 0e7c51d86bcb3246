#pragma once
// Maps while a program runs: entries in the order of their insertion, found by hashes that are the
// same in every run. Whoever chooses keys whose hashes are equal pays for it: probing counts as
// work.

#include "vm/state/state.hpp"

namespace armlet::lang {

[[nodiscard]] inline MapObj& map_in(Slot s) { return *static_cast<MapObj*>(s.o); }

// The flags of maps of a type.
[[nodiscard]] std::uint8_t map_flags(const Type& type);

// The entry with a key; null if there is none. False: the program has to stop and the failure is
// set.
[[nodiscard]] bool find_entry(VmState& state, const MapObj& map, Slot key, MapEntry*& entry);
// The same for a key with a known hash.
[[nodiscard]] bool find_entry(VmState& state, const MapObj& map, Slot key, std::uint32_t hash,
                              MapEntry*& entry);
// The entry with a key; a new one, which has the key and a value of zero bits, if there is none.
// The map must have one owner. False: the failure is set.
[[nodiscard]] bool find_or_add(VmState& state, MapObj& map, Slot key, MapEntry*& entry);
// Takes an entry out of a map with one owner; the count of its value goes to the caller.
[[nodiscard]] Slot remove_entry(VmState& state, MapObj& map, MapEntry& entry);

// A copy; null if there was a failure, which is set.
[[nodiscard]] MapObj* copy_map(VmState& state, const MapObj& old);

// There is no such key: the message names those that are most like it.
bool raise_no_key(VmState& state, const MapObj& map, Slot key, const Type& key_type);
bool raise_key_twice(VmState& state, Slot key, const Type& key_type);

}  // namespace armlet::lang
