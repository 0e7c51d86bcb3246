#pragma once
// Maps at run time: entries in the order of their insertion, found by hashes that are the same in
// every run. Keys may be chosen so that many hashes are equal; the additional probes are then
// counted as work.

#include "vm/state/state.hpp"

namespace armlet::lang {

[[nodiscard]] inline MapObj& map_in(Slot s) { return *static_cast<MapObj*>(s.o); }

// The flags of the map objects of a type.
[[nodiscard]] std::uint8_t map_flags(const Type& type);

// Finds the entry with a key; null if there is none. Returns false, with the failure set, if the
// program has to stop.
[[nodiscard]] bool find_entry(VmState& state, const MapObj& map, Slot key, MapEntry*& entry);
// Finds the entry with a key whose hash is known.
[[nodiscard]] bool find_entry(VmState& state, const MapObj& map, Slot key, std::uint32_t hash,
                              MapEntry*& entry);
// Finds the entry with a key, or adds one with a value of zero bits. The map must have one owner.
// Returns false, with the failure set, if that fails.
[[nodiscard]] bool find_or_add(VmState& state, MapObj& map, Slot key, MapEntry*& entry);
// Removes an entry from a map with one owner, and returns its value; the caller owns the value's
// count.
[[nodiscard]] Slot remove_entry(VmState& state, MapObj& map, MapEntry& entry);

// A copy of a map; null, with the failure set, if it cannot be made.
[[nodiscard]] MapObj* copy_map(VmState& state, const MapObj& old);

// Raises the failure of a missing key. The message names the most similar keys.
bool raise_no_key(VmState& state, const MapObj& map, Slot key, const Type& key_type);
bool raise_key_twice(VmState& state, Slot key, const Type& key_type);

}  // namespace armlet::lang
