#pragma once
// A value of a program, owned by the host, independent of the program and its
// memory. It is copied like any C++ value.
//
//     Value speed = vm.global("speed");
//     speed.in("mm/s")                          // 200.0; its unit is checked
//     vm.set("speed", Value(0.2, "m/s"));
//     vm.set("names", {"left", "right"});

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/unit.hpp"

namespace armlet {

class Value {
 public:
  // A double, or a quantity in SI units.
  struct Number {
    double si = 0.0;
    Dim dim{};
    bool operator==(const Number&) const = default;
  };
  using List = std::vector<Value>;  // also a table: its rows are records
  struct Matrix {
    std::uint32_t rows = 0;
    std::uint32_t cols = 0;
    std::vector<double> elements{};  // row by row
    bool operator==(const Matrix&) const = default;
  };
  struct Record {
    std::string type;
    std::vector<std::pair<std::string, Value>> fields;
    bool operator==(const Record&) const;
  };
  struct Enum {
    std::string type;
    std::string value;
    bool operator==(const Enum&) const = default;
  };
  using Map = std::vector<std::pair<Value, Value>>;  // in the order of insertion
  // A value of a host type.
  struct Host {
    const HostType* type = nullptr;
    std::shared_ptr<const void> value{};
    bool operator==(const Host&) const;
  };
  using Content = std::variant<std::monostate, bool, std::int64_t, Number, std::string, List,
                               Matrix, Record, Enum, Map, Host>;

  Value() = default;  // no value
  Value(const Value&) = default;
  Value(Value&&) noexcept = default;
  Value& operator=(const Value&) = default;
  Value& operator=(Value&&) noexcept = default;
  ~Value() {
    if (content_.index() > kLastFlat) dismantle();
  }
  Value(bool truth) : content_(truth) {}
  // throws  ArgumentError for a number above the largest int, 2^63 - 1.
  template <std::integral T>
  Value(T number) : content_(static_cast<std::int64_t>(number)) {
    if constexpr (std::unsigned_integral<T> && sizeof(T) == sizeof(std::int64_t)) {
      if (std::get<std::int64_t>(content_) < 0) refuse_large(number);
    }
  }
  Value(double number) : content_(Number{number}) {}
  // throws  ArgumentError if there is no such unit.
  Value(double number, std::string_view unit);
  Value(std::string text) : content_(std::move(text)) {}
  Value(std::string_view text) : content_(std::string(text)) {}
  Value(const char* text) : content_(std::string(text)) {}
  Value(const std::vector<double>& numbers);
  Value(std::initializer_list<Value> items) : content_(List(items)) {}
  template <class T>
  requires(std::same_as<T, Number> || std::same_as<T, List> || std::same_as<T, Matrix> ||
           std::same_as<T, Record> || std::same_as<T, Enum> || std::same_as<T, Map> ||
           std::same_as<T, Host>) Value(T content)
      : content_(std::in_place_type<T>, std::move(content)) {}

  [[nodiscard]] const Content& content() const { return content_; }
  // The value as a C++ type, get_if<Value::List>(); null if it is of another kind.
  template <class T>
  [[nodiscard]] const T* get_if() const {
    return std::get_if<T>(&content_);
  }
  // throws  ArgumentError if the value is of another kind.
  template <class T>
  [[nodiscard]] const T& get() const {
    if (const T* content = get_if<T>()) return *content;
    refuse("what is asked for");
  }
  // The number in a unit; without a unit, a double or an int.
  //
  // throws  ArgumentError if it is not a number, or has another dimension.
  [[nodiscard]] double in(std::string_view unit = {}) const;
  // A field of a record.
  //
  // throws  ArgumentError if it is no record with this field.
  [[nodiscard]] const Value& operator[](std::string_view field) const;
  // The kind of the value, for messages: "a length", "a list", "a record Pallet".
  [[nodiscard]] std::string kind() const;

  bool operator==(const Value& other) const;

 private:
  // The last alternative without values inside.
  static constexpr std::size_t kLastFlat = 4;
  static_assert(std::is_same_v<std::variant_alternative_t<kLastFlat + 1, Content>, List>);
  // Destroys the values inside without recursion, so that any depth is possible.
  void dismantle() noexcept;
  [[noreturn]] void refuse(const std::string& wanted) const;
  [[noreturn]] static void refuse_large(std::uint64_t number);

  Content content_{};
};

}  // namespace armlet
