#pragma once
// Maps in the arguments and results of functions of a host, whose signatures name them as programs
// do: "(stock: int[string]) -> double[int]".

#include "armlet/interpreter/native.hpp"

namespace armlet {

// The map in a slot. It has its entries in the order of their insertion; removed ones are marked.
// Texts, lists and other objects in them are borrowed.
[[nodiscard]] inline const MapObj& map_value(Slot s) { return *static_cast<const MapObj*>(s.o); }

// Sets `value` to the value of a key, which is borrowed, or to null if there is no such key.
// Returns false, with the failure set, if the program has to stop.
[[nodiscard]] bool find_in_map(Vm& vm, const MapObj& map, Slot key, const Slot*& value);

// An empty map. text_keys: whether keys are texts, otherwise ints. references: whether values are
// texts, lists, records ..., otherwise numbers. Null if the limit of the heap is reached; the
// failure is set.
[[nodiscard]] MapObj* new_map(Vm& vm, bool text_keys, bool references);

// Inserts an entry or replaces the value of one.
//
// map      made by new_map; the caller must be its only owner.
// key      borrowed: the map increases its count.
// value    the map takes over its count, also when this fails.
// returns  false if it failed; the failure is set.
[[nodiscard]] bool put_into_map(Vm& vm, MapObj& map, Slot key, Slot value);

}  // namespace armlet
