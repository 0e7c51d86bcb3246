// Compiles maps: literals, entries, has, keys, values and remove.

#include "lower/places.hpp"
#include "lower/values.hpp"

namespace armlet::lang {

using namespace hir;

void make_map(Lowering& in, const MapExpr& e, Reg to) {
  const Reg map = in.code.reference();  // the entries may use the value that `to` has
  in.code.at(e.span, &e);
  in.code.push(OpCode::NEWMAP, map.bits, in.code.type(e.type), 0);
  for (std::size_t i = 0; i < e.keys.size(); ++i) {
    const Emitter::Mark mark = in.code.mark();
    const Expr& written = *e.values[i];
    const Reg at = key(in, *e.keys[i], hold_over(in, written));
    const Reg from =
        written.type->is_reference() ? borrow(in, written, Hold::kNow) : value(in, written);
    in.code.at(e.keys[i]->span, e.keys[i]);
    in.code.emit(OpCode::MAPADD, map, at, from);
    in.code.word(in.code.type(e.type));
    in.code.release(mark);
  }
  in.code.emit(OpCode::TAKE, to, map);
}

// The register of a key that stays valid as long as `hold` demands.
Reg key(Lowering& in, const Expr& e, Hold hold) {
  return e.type->is_reference() ? borrow(in, e, hold) : value(in, e);
}

// Loads m[k]; a reference is borrowed.
void load_entry(Lowering& in, const EntryExpr& e, Reg to, Hold hold) {
  const Reg map = borrow(in, *e.object, stronger(hold, hold_over(in, *e.key)));
  const Reg at = key(in, *e.key, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::MAPLD, to, map, at);
  in.code.word(in.code.type(e.object->type));
}

// m.get(k, otherwise): `otherwise` is evaluated in any case. `to` owns one count of the result.
void own_entry_or(Lowering& in, const EntryExpr& e, Reg to) {
  const Hold later = hold_over(in, *e.otherwise);
  const Reg map = borrow(in, *e.object, stronger(hold_over(in, *e.key), later));
  const Reg at = key(in, *e.key, later);
  const bool reference = e.type->is_reference();
  const Reg otherwise = reference ? borrow(in, *e.otherwise, Hold::kNow) : value(in, *e.otherwise);
  const Reg found = reference ? in.code.number() : to;
  in.code.at(e.span, &e);
  in.code.emit(OpCode::MAPGET, found, map, at);
  in.code.emit(OpCode::WITH, otherwise);
  if (reference) in.code.emit(OpCode::MOVEREF, to, found);
}

void has_key_into(Lowering& in, const MapQueryExpr& e, Reg to) {
  const Reg map = borrow(in, *e.object, hold_over(in, *e.key));
  const Reg at = key(in, *e.key, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::MAPHAS, to, map, at);
}

void make_map_list(Lowering& in, const MapQueryExpr& e, Reg to) {
  const Reg map = borrow(in, *e.object, Hold::kNow);
  in.code.at(e.span, &e);
  in.code.emit(e.question == MapQuestion::kKeys ? OpCode::MAPKEYS : OpCode::MAPVALUES, to, map);
}

// Computes the address of an entry from the address of its map.
void step_to_entry(Lowering& in, const Step& step, Reg to, Reg key, bool makes) {
  in.code.emit(makes ? OpCode::ENTRYMAKE : OpCode::ENTRYADDR, to, to, key);
  if (!makes) in.code.word(in.code.type(step.map));
}

bool has_key(const Place& place) {
  for (const Step& step : place.steps) {
    if (step.map != nullptr) return true;
  }
  return false;
}

// Returns the register of the removed value. A reference there is owned and has to be moved to its
// destination before the next call.
Reg remove_key(Lowering& in, const MutateExpr& e) {
  const Reg result = in.code.number();
  in.code.at(e.span, &e);
  check_set(in, *e.place.variable);
  const Indices indices = index_values(in, e.place);
  const Reg at = key(in, *e.index, Hold::kNow);
  const Reg map = address(in, e.place, indices);
  in.code.at(e.span, &e);
  in.code.emit(OpCode::MAPPOP, result, map, at);
  in.code.word(in.code.type(e.place.type));
  return result;
}

}  // namespace armlet::lang
