#pragma once
// Parameters of functions that `def` makes (define.hpp), as types of C++.
//
//   of the signature       of C++
//   double, a quantity     double
//   int, an enum           std::int64_t
//   bool, string           bool, std::string_view
//   double[], time[] ...   std::span<const double>
//   any other list         std::span<const Slot>, const ListObj&; of a host's type: HostList<T>
//   matrix                 const MatrixObj&
//   a type of the host     const T&, for which kHostType<T> or `type<T>` names it
//   a struct, a table      const RecordObj&
//   fn(...) -> ...         const ScriptFunction<...>&, or FunctionValue to pass it on
//   T and all others       Slot
//   name: type?            std::optional of the above, const T* for a type of the host

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/script_function.hpp"

namespace armlet {

// The type of the language whose values are T in C++. Specialise it next to the HostType.
template <class T>
inline constexpr const HostType* kHostType = nullptr;

// The HostType for values of type T: their size, and functions that destroy, compare (if T has ==)
// and print them (if T has `std::string text() const`).
template <class T>
constexpr HostType host_type(std::string_view name, std::string_view help) {
  HostType type{.name = name, .size = sizeof(T), .help = help};
  if constexpr (!std::is_trivially_destructible_v<T>)
    type.destroy = [](void* value) { static_cast<T*>(value)->~T(); };
  if constexpr (std::is_copy_constructible_v<T>)
    type.copy = [](const void* from, void* to) { new (to) T(*static_cast<const T*>(from)); };
  if constexpr (requires(const T& a) { bool{a == a}; })
    type.equal = [](const void* a, const void* b) {
      return *static_cast<const T*>(a) == *static_cast<const T*>(b);
    };
  if constexpr (requires(const T& a) { std::string(a.text()); })
    type.text = [](const void* value, std::string& out) {
      out += static_cast<const T*>(value)->text();
    };
  return type;
}

namespace typed {

// The name of T in C++, without namespaces.
template <class T>
constexpr std::string_view name_in_cpp() {
  std::string_view name = __PRETTY_FUNCTION__;  // "... [with T = armlet::Pear; ..."
  name.remove_prefix(name.find("T = ") + 4);
  name = name.substr(0, name.find_first_of(";]"));
  const std::size_t scope = name.rfind("::");
  return scope == std::string_view::npos ? name : name.substr(scope + 2);
}

// The HostType of values of T for which only `type<T>` names a type (define_type.hpp).
template <class T>
inline constexpr HostType kTypeInCpp = host_type<T>(name_in_cpp<T>(), {});

// The HostType of values of T.
template <class T>
constexpr const HostType* carried_type() {
  if constexpr (kHostType<T> != nullptr) {
    return kHostType<T>;
  } else {
    return &kTypeInCpp<T>;
  }
}

}  // namespace typed

template <class T>
concept HostValue = kHostType<std::remove_cvref_t<T>>
!= nullptr;

// A function value to be passed on, borrowed from the argument.
struct FunctionValue {
  Obj* object;
};

// A list of values of a host type, borrowed from the argument.
template <class T>
class HostList {
 public:
  explicit HostList(std::span<const Slot> items) : items_(items) {}
  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return host_value<T>(items_[i]); }

 private:
  std::span<const Slot> items_;
};

// Reads a parameter of type T from its slot: `kKind`, and read(vm, slot). Specialise it for your
// own types.
template <class T>
struct Argument;

template <>
struct Argument<Slot> {
  static constexpr ValueKind kKind{};
  static Slot read(Vm&, Slot slot) { return slot; }
};
template <>
struct Argument<double> {
  static constexpr ValueKind kKind{ValueKind::Form::kReal};
  static double read(Vm&, Slot slot) { return slot.d; }
};
template <>
struct Argument<std::int64_t> {
  static constexpr ValueKind kKind{ValueKind::Form::kInt};
  static std::int64_t read(Vm&, Slot slot) { return slot.i; }
};
template <>
struct Argument<bool> {
  static constexpr ValueKind kKind{ValueKind::Form::kBool};
  static bool read(Vm&, Slot slot) { return slot.i != 0; }
};
template <>
struct Argument<std::string_view> {
  static constexpr ValueKind kKind{ValueKind::Form::kText};
  static std::string_view read(Vm&, Slot slot) { return text_value(slot); }
};
template <>
struct Argument<std::span<const double>> {
  static constexpr ValueKind kKind{ValueKind::Form::kReals};
  static std::span<const double> read(Vm&, Slot slot) { return reals_value(slot); }
};
template <>
struct Argument<std::span<const Slot>> {
  static constexpr ValueKind kKind{ValueKind::Form::kItems};
  static std::span<const Slot> read(Vm&, Slot slot) { return items_value(slot); }
};
template <>
struct Argument<const ListObj&> {
  static constexpr ValueKind kKind{ValueKind::Form::kItems};
  static const ListObj& read(Vm&, Slot slot) { return *static_cast<const ListObj*>(slot.o); }
};
template <>
struct Argument<const MatrixObj&> {
  static constexpr ValueKind kKind{ValueKind::Form::kMatrix};
  static const MatrixObj& read(Vm&, Slot slot) { return matrix_value(slot); }
};
template <>
struct Argument<const RecordObj&> {
  static constexpr ValueKind kKind{ValueKind::Form::kRecord};
  static const RecordObj& read(Vm&, Slot slot) { return *static_cast<const RecordObj*>(slot.o); }
};
template <>
struct Argument<FunctionValue> {
  static constexpr ValueKind kKind{ValueKind::Form::kFunction};
  static FunctionValue read(Vm&, Slot slot) { return {slot.o}; }
};
template <class Function>
struct Argument<const ScriptFunction<Function>&> {
  static constexpr ValueKind kKind{ValueKind::Form::kFunction};
  static ScriptFunction<Function> read(Vm& vm, Slot slot) {
    return ScriptFunction<Function>(vm, slot);
  }
};
template <class T>
requires std::is_class_v<T>
struct Argument<const T&> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, false, typed::carried_type<T>()};
  static const T& read(Vm&, Slot slot) { return host_value<T>(slot); }
};
template <class T>
requires std::is_class_v<T>
struct Argument<const T*> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, true, typed::carried_type<T>()};
  static const T* read(Vm&, Slot slot) {
    return slot.o == nullptr ? nullptr : &host_value<T>(slot);
  }
};
template <class T>
struct Argument<HostList<T>> {
  static constexpr ValueKind kKind{ValueKind::Form::kHosts, false, typed::carried_type<T>()};
  static HostList<T> read(Vm&, Slot slot) { return HostList<T>(items_value(slot)); }
};
template <class T>
struct Argument<std::optional<T>> {
  static constexpr ValueKind kKind{Argument<T>::kKind.form, true, Argument<T>::kKind.host};
  static std::optional<T> read(Vm& vm, Slot slot) {
    constexpr ValueKind::Form kForm = Argument<T>::kKind.form;
    constexpr bool kIsScalar = kForm == ValueKind::Form::kReal || kForm == ValueKind::Form::kInt ||
                               kForm == ValueKind::Form::kBool;
    if (kIsScalar ? is_absent_scalar(slot) : slot.o == nullptr) return std::nullopt;
    return Argument<T>::read(vm, slot);
  }
};

// The rows of a table, as table_rows of native.hpp gives them.
[[nodiscard]] inline std::span<const Slot> table_rows(const RecordObj& table) {
  return items_value(table.fields()[table.layout->type->record->fields.size()]);
}

}  // namespace armlet
