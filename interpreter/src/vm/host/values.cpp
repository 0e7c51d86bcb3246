#include "vm/host/values.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/binding/map_values.hpp"
#include "vm/values/map.hpp"

namespace armlet::lang {

namespace {

constexpr int kMostLevels = 200;

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw ArgumentError(what + ' ' + why + '.');
}

// Counts the depth of nested values.
class Level {
 public:
  Level(int& level, const std::string& what) : level_(level) {
    if (++level_ > kMostLevels) {
      --level_;
      refuse(what, "is nested deeper than " + std::to_string(kMostLevels) + " levels");
    }
  }
  ~Level() { --level_; }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;

 private:
  int& level_;
};

std::shared_ptr<const void> copy_of(const HostType& type, const void* value) {
  constexpr std::align_val_t kAlignment{16};
  struct Delete {
    const HostType* type;
    void operator()(void* payload) const {
      if (type->destroy != nullptr) type->destroy(payload);
      ::operator delete(payload, kAlignment);
    }
  };
  void* payload = ::operator new(std::max<std::size_t>(type.size, 1), kAlignment);
  try {
    type.copy(value, payload);
  } catch (...) {
    ::operator delete(payload, kAlignment);
    throw;
  }
  return std::shared_ptr<const void>(payload, Delete{&type});
}

// ---- out of the program ---------------------------------------------------------------------

class Reader {
 public:
  explicit Reader(const std::string& what) : what_(what) {}

  Value read(Slot slot, const Type& type) {
    const Level level(level_, what_);
    if (type.is_reference()) {
      if (slot.o == nullptr) refuse(what_, "holds an element without a value");
      return read_object(*slot.o, type);
    }
    if (is_absent_scalar(slot)) refuse(what_, "holds an element without a value");
    if (type.is(Kind::kBool)) return slot.i != 0;
    if (type.is(Kind::kInt)) return slot.i;
    if (type.is(Kind::kEnum)) {
      const EnumInfo& info = *type.enumeration;
      return Value::Enum{info.name, info.values.at(static_cast<std::size_t>(slot.i))};
    }
    return Value::Number{slot.d, type.dim};
  }

 private:
  Value read_object(const Obj& object, const Type& type) {
    if (type.is(Kind::kText)) return static_cast<const TextObj&>(object).view();
    if (type.is(Kind::kList)) {
      const auto& list = static_cast<const ListObj&>(object);
      return read_items({list.data, list.size}, *type.element);
    }
    if (type.is(Kind::kMatrix)) {
      const auto& matrix = static_cast<const MatrixObj&>(object);
      const double* first = matrix.data();
      return Value::Matrix{
          matrix.rows, matrix.cols, {first, first + std::size_t{matrix.rows} * matrix.cols}};
    }
    if (type.is(Kind::kMap)) return read_map(static_cast<const MapObj&>(object), type);
    if (type.is_table())
      return read_items(table_rows(slot_of(&unlocked(object))), *type.record->row);
    if (type.is(Kind::kRecord)) return read_record(static_cast<const RecordObj&>(object), type);
    if (type.is(Kind::kHost)) return read_host(static_cast<const HostObj&>(object));
    refuse(what_, "holds " + type_phrase(&type) + ", which only the program can hold");
  }

  // An object of the program without const, for a slot that is only read.
  static Obj& unlocked(const Obj& object) { return const_cast<Obj&>(object); }

  Value read_items(std::span<const Slot> items, const Type& element) {
    Value::List list;
    list.reserve(items.size());
    for (const Slot item : items) list.push_back(read(item, element));
    return list;
  }

  Value read_map(const MapObj& map, const Type& type) {
    Value::Map out;
    for (const MapEntry& entry : map.all()) {
      if (!entry.is_removed)
        out.emplace_back(read(entry.key, *type.key), read(entry.value, *type.element));
    }
    return out;
  }

  Value read_record(const RecordObj& record, const Type& type) {
    Value::Record out{type.record->name, {}};
    for (std::size_t i = 0; i < type.record->fields.size(); ++i) {
      const RecordField& field = type.record->fields[i];
      out.fields.emplace_back(field.name, read(record.fields()[i], *field.type));
    }
    return out;
  }

  Value read_host(const HostObj& object) {
    if (object.type->copy == nullptr)
      refuse(what_, "holds a " + std::string(object.type->name) + ", which cannot be copied");
    return Value::Host{object.type, copy_of(*object.type, object.payload())};
  }

  const std::string& what_;
  int level_ = 0;
};

// ---- into the program -----------------------------------------------------------------------

// Owns a count of an object until a value is complete; the program then owns it.
class Owned {
 public:
  Owned(Heap& heap, Slot slot, bool is_reference)
      : heap_(heap), slot_(slot), is_reference_(is_reference) {}
  ~Owned() {
    if (is_reference_) heap_.release(slot_.o);
  }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  [[nodiscard]] Slot give() {
    is_reference_ = false;
    return slot_;
  }
  [[nodiscard]] Slot get() const { return slot_; }

 private:
  Heap& heap_;
  Slot slot_;
  bool is_reference_;
};

class Writer {
 public:
  Writer(VmState& state, const std::string& what, Undefined undefined)
      : state_(state), what_(what), undefined_(undefined) {}

  Slot write(const Value& value, const Type& type) {
    const Level level(level_, what_);
    switch (type.kind) {
      case Kind::kBool:
        return slot_of(need<bool>(value, type));
      case Kind::kInt:
        return slot_of(need<std::int64_t>(value, type));
      case Kind::kReal:
        return write_number(value, type);
      case Kind::kEnum:
        return write_enum(value, type);
      case Kind::kText:
        return write_text(need<std::string>(value, type));
      case Kind::kList:
        return write_list(value, type);
      case Kind::kMatrix:
        return write_matrix(value, type);
      case Kind::kMap:
        return write_map(value, type);
      case Kind::kRecord:
        return write_record(value, type);
      case Kind::kHost:
        return write_host(value, type);
      case Kind::kAny:
      case Kind::kVoid:
      case Kind::kFunction:
        break;
    }
    refuse("is " + type_phrase(&type) + ", which only the program can make");
  }

 private:
  // A part of a value while it is converted, for messages.
  struct Part {
    const std::string* field;  // null: an element of a list, or an entry of a map
    std::size_t index;
  };
  Slot write_part(Part part, const Value& value, const Type& type) {
    parts_.push_back(part);
    const Slot slot = write(value, type);
    parts_.pop_back();
    return slot;
  }
  // "Element 2 of the field `at` of `stations`".
  [[nodiscard]] std::string place() const {
    std::string out;
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
      out += part->field != nullptr ? "the field `" + *part->field + "` of "
                                    : "element " + std::to_string(part->index) + " of ";
    }
    out += what_;
    if (what_.starts_with('`') && !parts_.empty()) out.front() = out.front() == 't' ? 'T' : 'E';
    return out;
  }
  [[noreturn]] void refuse(const std::string& why) const { lang::refuse(place(), why); }
  void require_number(double number, const Type& type) const {
    if (std::isnan(number) && undefined_ == Undefined::kRefused)
      refuse("takes " + type_phrase(&type) + kUndefinedNumber);
  }
  [[noreturn]] void misfit(const Value& value, const Type& type) const {
    const auto* number = value.get_if<Value::Number>();
    const bool lacks_unit = type.is_quantity() && (value.get_if<std::int64_t>() != nullptr ||
                                                   (number != nullptr && number->dim.is_none()));
    refuse(
        "takes " + type_phrase(&type) + ", and was given " + value.kind() +
        (lacks_unit ? "; give its unit, such as \"" + display_unit(type.dim, 1.0).name + '"' : ""));
  }
  template <class T>
  const T& need(const Value& value, const Type& type) const {
    const T* content = value.get_if<T>();
    if (content == nullptr) misfit(value, type);
    return *content;
  }
  template <class T>
  Slot held(T* object) const {
    if (object == nullptr && state_.heap.was_refused())
      refuse("finds no memory: the host of the program gives none");
    if (object == nullptr)
      refuse("does not fit into the memory of the program, " + std::to_string(state_.heap.limit()) +
             " bytes at most");
    return slot_of(static_cast<Obj*>(object));
  }

  Slot write_text(const std::string& text) const {
    if (const auto at = broken_byte(text)) refuse(broken_text(*at));
    return held(state_.heap.new_text(text));
  }

  Slot write_number(const Value& value, const Type& type) const {
    if (const auto* whole = value.get_if<std::int64_t>(); whole != nullptr && type.is_double())
      return slot_of(static_cast<double>(*whole));
    const auto& number = need<Value::Number>(value, type);
    if (number.dim != type.dim) misfit(value, type);
    require_number(number.si, type);
    return slot_of(number.si);
  }

  Slot write_enum(const Value& value, const Type& type) const {
    const auto& given = need<Value::Enum>(value, type);
    if (given.type != type.enumeration->name) misfit(value, type);
    const int index = type.enumeration->index_of(given.value);
    if (index >= 0) return slot_of(std::int64_t{index});
    refuse("takes a value of " + given.type + ", which has no `" + given.value + '`');
  }

  Slot write_list(const Value& value, const Type& type) {
    const auto& items = need<Value::List>(value, type);
    const bool references = type.element->is_reference();
    Owned list(state_.heap, held(state_.heap.new_list(items.size(), references)), true);
    Slot* place = static_cast<ListObj*>(list.get().o)->data;
    for (std::size_t i = 0; i < items.size(); ++i)
      place[i] = write_part({nullptr, i}, items[i], *type.element);
    return list.give();
  }

  Slot write_matrix(const Value& value, const Type& type) const {
    const auto& given = need<Value::Matrix>(value, type);
    if (given.elements.size() != std::size_t{given.rows} * given.cols)
      refuse("is a matrix of " + std::to_string(given.rows) + " by " + std::to_string(given.cols) +
             ", and was given " + std::to_string(given.elements.size()) + " elements");
    for (const double element : given.elements) require_number(element, type);
    const Slot slot = held(state_.heap.new_matrix(given.rows, given.cols));
    std::ranges::copy(given.elements, static_cast<MatrixObj*>(slot.o)->data());
    return slot;
  }

  Slot write_map(const Value& value, const Type& type) {
    const auto& entries = need<Value::Map>(value, type);
    Owned map(state_.heap, held(state_.heap.new_map(map_flags(type), 0)), true);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const auto& [key, item] = entries[i];
      const Owned at(state_.heap, write_part({nullptr, i}, key, *type.key),
                     type.key->is_reference());
      const Slot content = write_part({nullptr, i}, item, *type.element);
      if (put_into_map(state_.vm, *static_cast<MapObj*>(map.get().o), at.get(), content)) continue;
      state_.fault.reset();
      held<Obj>(nullptr);
    }
    return map.give();
  }

  Slot write_record(const Value& value, const Type& type) {
    if (type.is_table()) refuse("is a table, which only the program can make");
    const auto& given = need<Value::Record>(value, type);
    const auto& fields = type.record->fields;
    if (given.type != type.record->name) misfit(value, type);
    const RecordLayout& layout = state_.layout_of(&type);
    Owned record(state_.heap, held(state_.heap.new_record(layout)), true);
    Slot* places = static_cast<RecordObj*>(record.get().o)->fields();
    std::fill_n(places, layout.size, Slot{.i = 0});
    for (std::size_t i = 0; i < fields.size(); ++i)
      places[i] =
          write_part({&fields[i].name, 0}, field_of(given, fields[i].name), *fields[i].type);
    if (given.fields.size() != fields.size())
      refuse("has " + std::to_string(fields.size()) + " fields, and was given " +
             std::to_string(given.fields.size()));
    return record.give();
  }

  const Value& field_of(const Value::Record& given, const std::string& name) const {
    for (const auto& [field, value] : given.fields) {
      if (field == name) return value;
    }
    refuse("needs the field `" + name + "` of " + given.type);
  }

  Slot write_host(const Value& value, const Type& type) const {
    const auto& given = need<Value::Host>(value, type);
    if (given.value == nullptr || !is_same_in_cpp(given.type, type.host)) misfit(value, type);
    const HostType& made = *given.type;
    const Slot slot = held(state_.heap.new_host(made));
    try {
      made.copy(given.value.get(), static_cast<HostObj*>(slot.o)->payload());
    } catch (...) {  // nothing was constructed, so nothing is destroyed
      state_.heap.give_back(slot.o, HostObj::kPayloadOffset + made.size);
      throw;
    }
    return slot;
  }

  VmState& state_;
  const std::string& what_;
  const Undefined undefined_;
  std::vector<Part> parts_{};
  int level_ = 0;
};

// ---- types ----------------------------------------------------------------------------------

class Comparison {
 public:
  bool same(const Type& a, const Type& b) {
    if (a.kind != b.kind || a.dim != b.dim) return false;
    if (!seen_.emplace(&a, &b).second) return true;  // a record inside itself
    if (a.is(Kind::kHost)) return is_same_in_cpp(a.host, b.host);
    if (a.is(Kind::kEnum))
      return a.enumeration->name == b.enumeration->name &&
             a.enumeration->values == b.enumeration->values;
    if (a.is(Kind::kRecord)) return same_fields(*a.record, *b.record);
    if (a.is(Kind::kFunction)) return false;
    return same_or_null(a.element, b.element) && same_or_null(a.key, b.key);
  }

 private:
  bool same_or_null(const Type* a, const Type* b) {
    return (a == nullptr) == (b == nullptr) && (a == nullptr || same(*a, *b));
  }
  bool same_fields(const RecordInfo& a, const RecordInfo& b) {
    return a.name == b.name && std::ranges::equal(a.fields, b.fields, [this](auto& x, auto& y) {
             return x.name == y.name && same(*x.type, *y.type);
           });
  }

  std::set<std::pair<const Type*, const Type*>> seen_;
};

}  // namespace

std::string broken_text(std::size_t byte) {
  return "takes a string, and was given bytes that are no text in UTF-8, from byte " +
         std::to_string(byte) + " on";
}

Value value_in(Slot slot, const Type& type, const std::string& what) {
  return Reader(what).read(slot, type);
}

Slot slot_of_value(VmState& state, const Value& value, const Type& type, const std::string& what,
                   Undefined undefined) {
  return Writer(state, what, undefined).write(value, type);
}

bool is_same_type(const Type& a, const Type& b) { return Comparison().same(a, b); }

}  // namespace armlet::lang
