#include "vm/values/equality.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/values/counted.hpp"
#include "vm/values/map.hpp"

namespace armlet::lang {

namespace {

// Pairs of shared objects that are equal unless the comparison finds a difference later. They form
// disjoint sets, since equality is symmetric and transitive. After at most as many unions as there
// are objects, all other pairs are known (R. Tarjan, 1975). An object alone in its set may still
// contain a NaN, which is not equal to itself.
class Known {
 public:
  explicit Known(VmState& state) : entries_(state) {}

  // Looks up whether the pair needs no second comparison. Returns false, with the failure set, if
  // the heap is full.
  [[nodiscard]] bool look_up(const Obj* a, const Obj* b, bool& known) {
    if (2 * (used_ + 2) > entries_.items.size() && !rehash()) return false;
    const std::size_t i = root(place_of(a));
    const std::size_t j = root(place_of(b));
    known = i == j && entries_.items[i].compared;
    entries_.items[i].compared = entries_.items[j].compared = true;
    if (i != j) entries_.items[j].parent = entries_.items[i].object;
    return true;
  }

 private:
  struct Entry {
    const Obj* object = nullptr;
    const Obj* parent = nullptr;
    bool compared = false;
  };

  [[nodiscard]] std::size_t slot_of(const Obj* object) const {
    const std::size_t mask = entries_.items.size() - 1;
    auto at = (reinterpret_cast<std::uintptr_t>(object) >> 4U) * 0x9E3779B97F4A7C15ULL >> 20U;
    while (entries_.items[at & mask].object != nullptr &&
           entries_.items[at & mask].object != object) {
      ++at;
    }
    return at & mask;
  }
  std::size_t place_of(const Obj* object) {
    const std::size_t at = slot_of(object);
    Entry& entry = entries_.items[at];
    if (entry.object == nullptr) {
      entry = {object, object, false};
      ++used_;
    }
    return at;
  }
  std::size_t root(std::size_t at) {
    while (true) {
      Entry& entry = entries_.items[at];
      if (entry.parent == entry.object) return at;
      const std::size_t up = slot_of(entry.parent);
      entry.parent = entries_.items[up].parent;  // path halving
      at = up;
    }
  }
  bool rehash() {
    std::vector<Entry> old = entries_.items;
    if (!entries_.resize(old.empty() ? 64 : 4 * old.size(), Entry{})) return false;
    for (const Entry& entry : old) {
      if (entry.object != nullptr) entries_.items[slot_of(entry.object)] = entry;
    }
    return true;
  }

  Counted<Entry> entries_;
  std::size_t used_ = 0;
};

bool equal_hosts(const HostObj& a, const HostObj& b) {
  return &a == &b || (a.type->equal != nullptr && a.type->equal(a.payload(), b.payload()));
}

class Comparison {
 public:
  explicit Comparison(VmState& state) : state_(state), open_(state), known_(state) {}

  // Returns false, with the failure set, if the comparison was stopped.
  bool run(Slot a, Slot b, const Type& type, bool& equal) {
    equal_ = true;
    bool goes_on = compare(a, b, type);
    while (goes_on && equal_ && !open_.items.empty()) goes_on = next_part();
    equal = equal_;
    return goes_on && charge_work(state_.vm, work_);
  }

 private:
  // Two objects whose parts before `next` have been compared.
  struct Open {
    const Obj* a;
    const Obj* b;
    const Type* type;
    std::uint32_t next;
  };

  // Compares numbers and texts at once. Objects with parts are pushed, so that their parts are
  // compared next.
  bool compare(Slot a, Slot b, const Type& type) {
    if (type.is(Kind::kReal)) return settle(a.d == b.d);
    if (!type.is_reference()) return settle(a.i == b.i);
    if (a.o == nullptr || b.o == nullptr) return settle(a.o == b.o);
    switch (type.kind) {
      case Kind::kText:
        return compare_texts(*static_cast<TextObj*>(a.o), *static_cast<TextObj*>(b.o));
      case Kind::kMatrix:
        return compare_matrices(*static_cast<MatrixObj*>(a.o), *static_cast<MatrixObj*>(b.o));
      case Kind::kHost:
        return settle(equal_hosts(*static_cast<HostObj*>(a.o), *static_cast<HostObj*>(b.o)));
      case Kind::kList:
        return compare_lists(*static_cast<ListObj*>(a.o), *static_cast<ListObj*>(b.o), type);
      case Kind::kMap:
        return compare_maps(map_in(a), map_in(b), type);
      case Kind::kRecord:
        if (type.is_table()) return settle(a.o == b.o);  // a table is equal only to itself
        return open(a.o, b.o, type);
      case Kind::kFunction:
      case Kind::kAny:  // no objects
      case Kind::kVoid:
      case Kind::kBool:
      case Kind::kInt:
      case Kind::kReal:
      case Kind::kEnum:
        break;
    }
    return settle(a.o == b.o);
  }

  bool settle(bool equal) {
    equal_ = equal_ && equal;
    return true;
  }

  bool compare_texts(const TextObj& a, const TextObj& b) {
    if (a.size != b.size || &a == &b) return settle(a.size == b.size);
    return in_blocks(state_.vm, a.size, 1,
                     [&](std::size_t begin, std::size_t end) {
                       equal_ = std::memcmp(a.data() + begin, b.data() + begin, end - begin) == 0;
                       return equal_;
                     }) ||
           !equal_;
  }

  bool compare_numbers(const double* a, const double* b, std::size_t count) {
    return in_blocks(state_.vm, count, 1,
                     [&](std::size_t begin, std::size_t end) {
                       equal_ = std::equal(a + begin, a + end, b + begin);
                       return equal_;
                     }) ||
           !equal_;
  }

  bool compare_matrices(const MatrixObj& a, const MatrixObj& b) {
    if (a.rows != b.rows || a.cols != b.cols) return settle(false);
    return compare_numbers(a.data(), b.data(), std::size_t{a.rows} * a.cols);
  }

  bool compare_lists(const ListObj& a, const ListObj& b, const Type& type) {
    if (a.size != b.size) return settle(false);
    if (a.size == 0) return true;
    if (type.element->is(Kind::kReal)) {
      return compare_numbers(a.reals().data(), b.reals().data(), a.size);
    }
    return open(&a, &b, type);
  }

  bool compare_maps(const MapObj& a, const MapObj& b, const Type& type) {
    if (a.size != b.size) return settle(false);
    return a.size == 0 || open(&a, &b, type);
  }

  // Compares the value of entry i of one map with the value of the same key in the other map.
  bool compare_entries(const MapObj& a, const MapObj& b, std::uint32_t i, const Type& element) {
    const MapEntry& entry = a.entries[i];
    if (entry.is_removed) return true;
    MapEntry* other = nullptr;
    if (!find_entry(state_, b, entry.key, entry.hash, other)) return false;
    return other != nullptr ? compare(entry.value, other->value, element) : settle(false);
  }

  // An object with one owner is reached only through that owner, so it need not be looked up.
  bool open(const Obj* a, const Obj* b, const Type& type) {
    if (a->refs > 1 || b->refs > 1) {
      bool known = false;
      if (!known_.look_up(a, b, known)) return false;
      if (known) return true;
    }
    return open_.push({a, b, &type, 0});
  }

  bool next_part() {
    constexpr std::uint64_t kCost = 8;  // of a part
    if ((work_ += kCost) >= kBlockWork) {
      if (!charge_work(state_.vm, work_)) return false;
      work_ = 0;
    }
    Open& at = open_.items.back();
    const std::uint32_t i = at.next++;
    if (at.type->is(Kind::kRecord)) {
      const auto& fields = at.type->record->fields;
      if (i == fields.size()) return close();
      return compare(static_cast<const RecordObj*>(at.a)->fields()[i],
                     static_cast<const RecordObj*>(at.b)->fields()[i], *fields[i].type);
    }
    if (at.type->is(Kind::kMap)) {
      const auto& map = *static_cast<const MapObj*>(at.a);
      if (i == map.used) return close();
      return compare_entries(map, *static_cast<const MapObj*>(at.b), i, *at.type->element);
    }
    const auto& a = *static_cast<const ListObj*>(at.a);
    if (i == a.size) return close();
    return compare(a.data[i], static_cast<const ListObj*>(at.b)->data[i], *at.type->element);
  }

  bool close() {
    open_.items.pop_back();
    return true;
  }

  VmState& state_;
  Counted<Open> open_;
  Known known_;
  std::uint64_t work_ = 0;
  bool equal_ = true;
};

}  // namespace

bool compare_values(VmState& state, Slot a, Slot b, const Type& type, bool& equal) {
  return Comparison(state).run(a, b, type, equal);
}

}  // namespace armlet::lang
