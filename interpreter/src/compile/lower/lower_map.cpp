// Maps: literals, entries, questions.

#include "compile/lower/lowering.hpp"

namespace armlet::lang {

using namespace hir;

void Lowering::make_map(const MapExpr& e, Reg to) {
  const Reg map = code_.reference();  // an entry may mention what `to` holds
  code_.at(e.span, &e);
  code_.push(OpCode::NEWMAP, map.bits, code_.type(e.type), 0);
  for (std::size_t i = 0; i < e.keys.size(); ++i) {
    const Emitter::Mark mark = code_.mark();
    const Expr& written = *e.values[i];
    const Reg at = key(*e.keys[i], hold_over(written));
    const Reg from = written.type->is_reference() ? borrow(written, Hold::kNow) : value(written);
    code_.at(e.keys[i]->span, e.keys[i]);
    code_.emit(OpCode::MAPADD, map, at, from);
    code_.word(code_.type(e.type));
    code_.release(mark);
  }
  code_.emit(OpCode::TAKE, to, map);
}

// A key that stays good over what its hold says.
Reg Lowering::key(const Expr& e, Hold hold) {
  return e.type->is_reference() ? borrow(e, hold) : value(e);
}

// m[k], borrowed if it is a reference.
void Lowering::load_entry(const EntryExpr& e, Reg to, Hold hold) {
  const Reg map = borrow(*e.object, stronger(hold, hold_over(*e.key)));
  const Reg at = key(*e.key, Hold::kNow);
  code_.at(e.span, &e);
  code_.emit(OpCode::MAPLD, to, map, at);
  code_.word(code_.type(e.object->type));
}

// m.get(k, otherwise); the other value is computed in any case. One count of a reference goes to
// `to`.
void Lowering::own_entry_or(const EntryExpr& e, Reg to) {
  const Hold later = hold_over(*e.otherwise);
  const Reg map = borrow(*e.object, stronger(hold_over(*e.key), later));
  const Reg at = key(*e.key, later);
  const bool reference = e.type->is_reference();
  const Reg otherwise = reference ? borrow(*e.otherwise, Hold::kNow) : value(*e.otherwise);
  const Reg found = reference ? code_.number() : to;
  code_.at(e.span, &e);
  code_.emit(OpCode::MAPGET, found, map, at);
  code_.emit(OpCode::WITH, otherwise);
  if (reference) code_.emit(OpCode::MOVEREF, to, found);
}

void Lowering::has_key_into(const MapQueryExpr& e, Reg to) {
  const Reg map = borrow(*e.object, hold_over(*e.key));
  const Reg at = key(*e.key, Hold::kNow);
  code_.at(e.span, &e);
  code_.emit(OpCode::MAPHAS, to, map, at);
}

void Lowering::make_map_list(const MapQueryExpr& e, Reg to) {
  const Reg map = borrow(*e.object, Hold::kNow);
  code_.at(e.span, &e);
  code_.emit(e.question == MapQuestion::kKeys ? OpCode::MAPKEYS : OpCode::MAPVALUES, to, map);
}

// From the address of a map to that of an entry.
void Lowering::step_to_entry(const Step& step, Reg to, Reg key, bool makes) {
  code_.emit(makes ? OpCode::ENTRYMAKE : OpCode::ENTRYADDR, to, to, key);
  if (!makes) code_.word(code_.type(step.map));
}

bool Lowering::has_key(const Place& place) {
  for (const Step& step : place.steps) {
    if (step.map != nullptr) return true;
  }
  return false;
}

// Returns the register of the removed value; a reference there is owned and has to be taken at
// once.
Reg Lowering::remove_key(const MutateExpr& e) {
  const Reg result = code_.number();
  code_.at(e.span, &e);
  check_set(*e.place.variable);
  const Indices indices = index_values(e.place);
  const Reg at = key(*e.index, Hold::kNow);
  const Reg map = address(e.place, indices);
  code_.at(e.span, &e);
  code_.emit(OpCode::MAPPOP, result, map, at);
  code_.word(code_.type(e.place.type));
  return result;
}

}  // namespace armlet::lang
