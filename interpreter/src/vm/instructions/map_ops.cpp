// Instructions for maps.

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/instructions/slow_ops.hpp"
#include "vm/values/map.hpp"

namespace armlet::lang {
namespace {

Slot& place_in(Slot s) { return *reinterpret_cast<Slot*>(s.o); }

void set_reference(VmState& state, Slot& place, Obj* object) {
  Obj* old = place.o;
  place.o = object;
  state.heap.release(old);
}

// The type of the map, whose index is in the next word.
const Type& type_of(const VmState& state, const Instr* pc) {
  return *state.running->stack.top->callee->function->types[pc[1].b];
}

// The entry with a key, which must exist; otherwise null, with the failure set.
MapEntry* present_entry(VmState& state, const MapObj& map, Slot key, const Instr* pc) {
  MapEntry* entry = nullptr;
  if (!find_entry(state, map, key, entry)) return nullptr;
  if (entry == nullptr) raise_no_key(state, map, key, *type_of(state, pc).key);
  return entry;
}

// Makes a list of the keys or of the values of a map.
bool put_list(VmState& state, Slot& to, const MapObj& map, Slot MapEntry::*part, bool references) {
  ListObj* list = state.heap.new_list(map.size, references);
  if (list == nullptr) return raise_out_of_memory(state);
  std::uint32_t next = 0;
  const auto copy = [&](std::size_t begin, std::size_t end) {
    for (const MapEntry& entry : map.all().subspan(begin, end - begin)) {
      if (entry.is_removed) continue;
      list->data[next++] = entry.*part;
      if (references) retain_object((entry.*part).o);
    }
  };
  if (!in_blocks(state.vm, map.used, 4, copy)) {
    state.heap.release(list);
    return false;
  }
  set_reference(state, to, list);
  return true;
}

}  // namespace

bool op_newmap(VmState& state, Slot* base, const Instr* pc) {
  const Type& type = *state.running->stack.top->callee->function->types[pc->b];
  MapObj* map = state.heap.new_map(map_flags(type), 0);
  if (map == nullptr) return raise_out_of_memory(state);
  set_reference(state, base[pc->a], map);
  return true;
}

bool op_mapadd(VmState& state, Slot* base, const Instr* pc) {
  MapObj& map = map_in(base[pc->a]);
  const std::uint32_t before = map.size;
  MapEntry* entry = nullptr;
  if (!find_or_add(state, map, base[pc->b], entry)) return false;
  if (map.size == before) return raise_key_twice(state, base[pc->b], *type_of(state, pc).key);
  entry->value = base[pc->c];
  if (map.holds_references()) retain_object(entry->value.o);
  return true;
}

bool op_mapld(VmState& state, Slot* base, const Instr* pc) {
  const MapEntry* entry = present_entry(state, map_in(base[pc->b]), base[pc->c], pc);
  if (entry == nullptr) return false;
  base[pc->a] = entry->value;
  return true;
}

bool op_mapget(VmState& state, Slot* base, const Instr* pc) {
  MapEntry* entry = nullptr;
  if (!find_entry(state, map_in(base[pc->b]), base[pc->c], entry)) return false;
  base[pc->a] = entry != nullptr ? entry->value : base[pc[1].a];
  return true;
}

bool op_maphas(VmState& state, Slot* base, const Instr* pc) {
  MapEntry* entry = nullptr;
  if (!find_entry(state, map_in(base[pc->b]), base[pc->c], entry)) return false;
  base[pc->a].i = entry != nullptr ? 1 : 0;
  return true;
}

bool op_maplen(VmState& /*state*/, Slot* base, const Instr* pc) {
  base[pc->a].i = map_in(base[pc->b]).size;
  return true;
}

bool op_mapkeys(VmState& state, Slot* base, const Instr* pc) {
  const MapObj& map = map_in(base[pc->b]);
  return put_list(state, base[pc->a], map, &MapEntry::key, map.has_text_keys());
}

bool op_mapvalues(VmState& state, Slot* base, const Instr* pc) {
  const MapObj& map = map_in(base[pc->b]);
  return put_list(state, base[pc->a], map, &MapEntry::value, map.holds_references());
}

bool op_entryaddr(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = place_in(base[pc->b]);
  if (!own(state, place)) return false;
  MapEntry* entry = present_entry(state, map_in(place), base[pc->c], pc);
  if (entry == nullptr) return false;
  base[pc->a].o = reinterpret_cast<Obj*>(&entry->value);
  return true;
}

bool op_entrymake(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = place_in(base[pc->b]);
  MapEntry* entry = nullptr;
  if (!own(state, place) || !find_or_add(state, map_in(place), base[pc->c], entry)) return false;
  base[pc->a].o = reinterpret_cast<Obj*>(&entry->value);
  return true;
}

bool op_mappop(VmState& state, Slot* base, const Instr* pc) {
  Slot& place = place_in(base[pc->b]);
  if (!own(state, place)) return false;
  MapObj& map = map_in(place);
  MapEntry* entry = present_entry(state, map, base[pc->c], pc);
  if (entry == nullptr) return false;
  base[pc->a] = remove_entry(state, map, *entry);
  return true;
}

}  // namespace armlet::lang
