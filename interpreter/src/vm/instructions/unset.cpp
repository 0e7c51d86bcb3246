#include "vm/instructions/unset.hpp"

#include <string>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/values/counted.hpp"

namespace armlet::lang {

namespace {

constexpr std::size_t kLongName = 60;  // characters; messages do not repeat longer texts

std::string bracketed(std::int64_t index) { return '[' + std::to_string(index) + ']'; }

// The text of an expression in the program, if it is short; otherwise "the list" or another noun.
std::string name_of(const VmState& state, Span span) {
  std::string text = source_text(state, span);
  const bool is_short = !text.empty() && text.size() <= kLongName;
  return is_short && text.find('\n') == std::string::npos ? text : "...";
}

bool raise_unset_value(VmState& state, const std::string& name) {
  Diagnostic failure = start_failure(state, "R0623", {name});
  failure.why = "`new` made the list with elements that have no value yet";
  failure.fix = Fix{.text = "store a value into it first: " + name + " = ..."};
  return raise(state, std::move(failure));
}

// The text of an element without its last index: `rows[i]` for `rows[i][j + 1]`.
std::string without_index(std::string text) {
  int open = 0;
  for (std::size_t at = text.size(); at-- > 0;) {
    open += text[at] == ']' ? 1 : text[at] == '[' ? -1 : 0;
    if (open == 0) return text.substr(0, at);
  }
  return text;
}

// In an assignment target the variable has the span of the whole target.
bool has_span_of_place(const VmState& state, const hir::Expr& object) {
  if (object.kind != hir::ExprKind::kVariable) return false;
  const std::string_view name = object.as<hir::VariableExpr>().variable->name;
  const std::string text = source_text(state, object.span);
  return !name.empty() && text.size() > name.size() && text.starts_with(name);
}

// The objects that the search has visited, because several objects may own them.
class Seen {
 public:
  explicit Seen(VmState& state) : places_(state) {}

  // Returns false, with the failure set, if the heap is full.
  [[nodiscard]] bool add(const Obj* object, bool& is_new) {
    if (2 * (used_ + 1) > places_.items.size() && !grow()) return false;
    const Obj*& place = place_of(object);
    is_new = place == nullptr;
    if (is_new) ++used_;
    place = object;
    return true;
  }

 private:
  const Obj*& place_of(const Obj* object) {
    const std::size_t mask = places_.items.size() - 1;
    auto at = (reinterpret_cast<std::uintptr_t>(object) >> 4U) * 0x9E3779B97F4A7C15ULL >> 20U;
    while (places_.items[at & mask] != nullptr && places_.items[at & mask] != object) ++at;
    return places_.items[at & mask];
  }
  bool grow() {
    const std::vector<const Obj*> old = std::move(places_.items);
    places_.items.clear();
    if (!places_.resize(old.empty() ? 64 : 2 * old.size(), nullptr)) return false;
    for (const Obj* object : old) {
      if (object != nullptr) place_of(object) = object;
    }
    return true;
  }

  Counted<const Obj*> places_;
  std::size_t used_ = 0;
};

// Searches an element without a value, in the order in which print writes values.
class Search {
 public:
  // unset  the types that may be without a value, from the program with the check.
  Search(VmState& state, const UnsetElements& unset)
      : state_(state), unset_(unset), open_(state), seen_(state) {}

  // Sets the path to the first element without a value, such as "[1].points[0]", or an empty path
  // if there is none. deep: searches the elements of a list too. Returns false, with the failure
  // set, if a stop is due.
  [[nodiscard]] bool run(Slot value, const Type& type, bool deep, std::string& path) {
    deep_ = deep;
    if (!enter(value, type)) return false;
    while (!open_.items.empty() && !found_) {
      if (!step()) return false;
    }
    if (!found_) return true;
    for (const Open& open : open_.items) path += step_text(open);
    return true;
  }

 private:
  struct Open {
    const Obj* object;
    const Type* type;
    std::uint32_t next;  // the next part to visit; the one before it is being visited
  };

  [[nodiscard]] bool enter(Slot value, const Type& type) {
    if (value.o == nullptr || !unset_.is_known_in(&type)) return true;
    bool is_new = true;
    if (value.o->refs > 1 && !seen_.add(value.o, is_new)) return false;
    return !is_new || open_.push({value.o, &type, 0});
  }

  bool step() {
    Open& open = open_.items.back();
    Slot part{};
    const Type* type = nullptr;
    if (!take_part(open, part, type)) {
      open_.items.pop_back();
      return true;
    }
    if (!charge_work(state_.vm, 4)) return false;
    const bool is_element = open.type->is(Kind::kList) && unset_.is_element(type);
    found_ = is_element && part.o == nullptr;
    return found_ || !deep_ || enter(part, *type);
  }

  // Returns false if there are no more parts.
  static bool take_part(Open& open, Slot& part, const Type*& type) {
    const std::uint32_t at = open.next++;
    if (open.type->is(Kind::kList)) {
      const auto& list = *static_cast<const ListObj*>(open.object);
      if (at >= list.size) return false;
      part = list.data[at];
      type = open.type->element;
    } else if (open.type->is(Kind::kMap)) {
      const auto& map = *static_cast<const MapObj*>(open.object);
      if (at >= map.used) return false;
      part = map.entries[at].is_removed ? Slot{.o = nullptr} : map.entries[at].value;
      type = open.type->element;
    } else {
      const auto& fields = open.type->record->fields;
      if (at >= fields.size()) return false;
      part = static_cast<const RecordObj*>(open.object)->fields()[at];
      type = fields[at].type;
    }
    return true;
  }

  static std::string step_text(const Open& open) {
    const std::uint32_t at = open.next - 1;
    if (open.type->is(Kind::kList)) return bracketed(at);
    if (open.type->is(Kind::kRecord)) return '.' + open.type->record->fields[at].name;
    const Slot key = static_cast<const MapObj*>(open.object)->entries[at].key;
    const std::string text = value_text(key, *open.type->key, kLongName);
    return open.type->key->is(Kind::kText) ? "[\"" + text + "\"]" : '[' + text + ']';
  }

  VmState& state_;
  const UnsetElements& unset_;
  Counted<Open> open_;
  Seen seen_;
  bool deep_ = true;
  bool found_ = false;
};

bool check_value(VmState& state, const UnsetElements& unset, Slot value, const Type& type,
                 bool deep) {
  std::string path;
  if (!Search(state, unset).run(value, type, deep, path)) return false;
  if (path.empty()) return true;
  const CodeSpan* at = code_span(state);
  return raise_unset_value(state, (at == nullptr ? "..." : name_of(state, at->span)) + path);
}

}  // namespace

bool raise_unset_element(VmState& state, std::int64_t index) {
  const CodeSpan* at = code_span(state);
  if (at == nullptr) return raise_unset_value(state, "..." + bracketed(index));
  const Frame& frame = *state.running->stack.top;
  if (frame.callee->code[frame.at()].op == OpCode::PLACESET)
    return raise_unset_value(state, without_index(name_of(state, at->span)) + bracketed(index));
  Span list = at->span;
  if (at->expr != nullptr) {
    if (at->expr->kind == hir::ExprKind::kElement) {
      const hir::Expr& object = *at->expr->as<hir::ElementExpr>().object;
      list = object.span;
      if (has_span_of_place(state, object))
        return raise_unset_value(state, without_index(name_of(state, at->span)) + bracketed(index));
    }
    if (at->expr->kind == hir::ExprKind::kSlice) list = at->expr->as<hir::SliceExpr>().object->span;
    if (at->expr->kind == hir::ExprKind::kMutate) list = at->expr->as<hir::MutateExpr>().place.span;
  }
  return raise_unset_value(state, name_of(state, list) + bracketed(index));
}

bool op_checkset(VmState& state, Slot* base, const Instr* pc) {
  const Type* type = state.running->stack.top->callee->function->types[pc->b];
  return check_value(state, state.code().unset, base[pc->a], *type, pc->c == 0);
}

bool check_result(VmState& state, const UnsetElements& unset, Slot result, const Type& type) {
  return check_value(state, unset, result, type, true);
}

}  // namespace armlet::lang
