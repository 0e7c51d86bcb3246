#include "armlet/interpreter/binding/map_values.hpp"

#include "vm/failures/failures.hpp"
#include "vm/values/map.hpp"

namespace armlet {

bool find_in_map(Vm& vm, const MapObj& map, Slot key, const Slot*& value) {
  MapEntry* entry = nullptr;
  value = nullptr;
  if (!lang::find_entry(vm.state(), map, key, entry)) return false;
  if (entry != nullptr) value = &entry->value;
  return true;
}

MapObj* new_map(Vm& vm, bool text_keys, bool references) {
  const auto flags = static_cast<std::uint8_t>((references ? MapObj::kReferences : 0U) |
                                               (text_keys ? MapObj::kTextKeys : 0U));
  MapObj* map = vm.state().heap.new_map(flags, 0);
  if (map == nullptr) lang::raise_out_of_memory(vm.state());
  return map;
}

bool put_into_map(Vm& vm, MapObj& map, Slot key, Slot value) {
  MapEntry* entry = nullptr;
  const bool found = lang::find_or_add(vm.state(), map, key, entry);
  Slot old = value;  // the old value, released at the end
  if (found) {
    old = entry->value;
    entry->value = value;
  }
  if (map.holds_references()) vm.state().heap.release(old.o);
  return found;
}

}  // namespace armlet
