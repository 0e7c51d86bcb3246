#pragma once
// Maps in the arguments and results of functions of a host, whose signatures name them as programs
// do: "(stock: int[string]) -> double[int]".

#include "armlet/interpreter/native.hpp"

namespace armlet {

// Its entries in the order of their insertion; those that were removed are marked. Texts, lists and
// so on in them are borrowed.
[[nodiscard]] inline const MapObj& map_value(Slot s) { return *static_cast<const MapObj*>(s.o); }

// The value of a key, which is borrowed; null if there is no such key. False: the failure is set.
[[nodiscard]] bool find_in_map(Vm& vm, const MapObj& map, Slot key, const Slot*& value);

// An empty map. text_keys: keys are texts, otherwise ints. references: values are texts, lists,
// records ..., otherwise numbers. Null: the heap limit was reached and the failure is set.
[[nodiscard]] MapObj* new_map(Vm& vm, bool text_keys, bool references);

// Inserts an entry or replaces the value of one.
//
// map    made by new_map, and owned by the caller alone.
// key    borrowed: the map counts it for itself.
// value  its count goes to the map, also when this fails.
// returns  false: the failure is set.
[[nodiscard]] bool put_into_map(Vm& vm, MapObj& map, Slot key, Slot value);

}  // namespace armlet
