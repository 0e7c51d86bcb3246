#include "armlet/interpreter/host/value.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/interpreter/type.hpp"
#include "vm/heap/format_value.hpp"

namespace armlet {

namespace {

CombinedUnit require_unit(std::string_view unit) {
  if (const auto known = parse_unit(unit)) return *known;
  throw ArgumentError("There is no unit `" + std::string(unit) +
                      "`; units are written as in programs: mm, deg/s, kg*m^2.");
}

// The number that a program gets from a literal with this unit, rounded once.
Value::Number quantity(double number, std::string_view unit) {
  const CombinedUnit known = require_unit(unit);
  const std::string literal = lang::bare_number_text(std::abs(number)) + std::string(unit);
  const std::optional<Quantity> read = parse_quantity(literal);
  const bool is_exact = read && read->number == std::abs(number);
  return {is_exact ? std::copysign(read->si, number) : number * known.factor, known.dim};
}

struct KindText {
  std::string operator()(std::monostate) const { return "nothing"; }
  std::string operator()(bool) const { return "a bool"; }
  std::string operator()(std::int64_t) const { return "an int"; }
  std::string operator()(const Value::Number& number) const {
    return number.dim.is_none() ? "a double" : dimension_phrase(number.dim);
  }
  std::string operator()(const std::string&) const { return "a string"; }
  std::string operator()(const Value::List&) const { return "a list"; }
  std::string operator()(const Value::Matrix&) const { return "a matrix"; }
  std::string operator()(const Value::Record& record) const { return named(record.type); }
  std::string operator()(const Value::Enum& value) const { return named(value.type); }
  std::string operator()(const Value::Map&) const { return "a map"; }
  std::string operator()(const Value::Host& host) const {
    return host.type == nullptr ? "nothing" : named(host.type->name);
  }

 private:
  static std::string named(std::string_view type) {
    return std::string(article(type)) + ' ' + std::string(type);
  }
};

}  // namespace

namespace {

// Moves the parts of a value into a list.
struct TakeParts {
  Value::List& parts;

  void operator()(Value::List& list) const {
    for (Value& each : list) parts.push_back(std::move(each));
    list.clear();
  }
  void operator()(Value::Record& record) const {
    for (auto& field : record.fields) parts.push_back(std::move(field.second));
    record.fields.clear();
  }
  void operator()(Value::Map& map) const {
    for (auto& [key, value] : map) {
      parts.push_back(std::move(key));
      parts.push_back(std::move(value));
    }
    map.clear();
  }
  template <class Flat>
  void operator()(Flat&) const {}
};

}  // namespace

void Value::dismantle() noexcept {
  // A list of values without parts needs no second list for its parts. Most lists are of this kind.
  const auto is_flat = [](const Value& each) { return each.content_.index() <= kLastFlat; };
  if (const auto* list = std::get_if<List>(&content_);
      list != nullptr && std::ranges::all_of(*list, is_flat))
    return;
  List parts;
  std::visit(TakeParts{parts}, content_);
  while (!parts.empty()) {
    Value last = std::move(parts.back());
    parts.pop_back();
    std::visit(TakeParts{parts}, last.content_);
  }
}

// Both operators are written in full, because clang 14 rejects a defaulted comparison that is
// recursive.
bool Value::Record::operator==(const Record& other) const {
  return type == other.type && fields == other.fields;
}

bool Value::operator==(const Value& other) const { return content_ == other.content_; }

bool Value::Host::operator==(const Host& other) const {
  if (value == other.value) return true;
  if (!is_same_in_cpp(type, other.type) || type == nullptr || type->equal == nullptr) return false;
  return value != nullptr && other.value != nullptr && type->equal(value.get(), other.value.get());
}

Value::Value(double number, std::string_view unit) : content_(quantity(number, unit)) {}

Value::Value(const std::vector<double>& numbers) : content_(List(numbers.begin(), numbers.end())) {}

std::string Value::kind() const { return std::visit(KindText{}, content_); }

void Value::refuse_large(std::uint64_t number) {
  throw ArgumentError(std::to_string(number) +
                      " is beyond the largest int of a program, 9223372036854775807.");
}

void Value::refuse(const std::string& wanted) const {
  throw ArgumentError("This value is " + kind() + ", not " + wanted + ".");
}

double Value::in(std::string_view unit) const {
  if (const auto* whole = get_if<std::int64_t>(); whole != nullptr && unit.empty())
    return static_cast<double>(*whole);
  const auto* number = get_if<Number>();
  if (unit.empty()) {
    if (number == nullptr || !number->dim.is_none()) refuse("a number without a unit");
    return number->si;
  }
  const CombinedUnit known = require_unit(unit);
  if (number == nullptr || number->dim != known.dim) refuse(dimension_phrase(known.dim));
  return number->si / known.factor;
}

const Value& Value::operator[](std::string_view field) const {
  const auto* record = get_if<Record>();
  if (record == nullptr) refuse("a record");
  for (const auto& [name, value] : record->fields) {
    if (name == field) return value;
  }
  refuse("one with a field `" + std::string(field) + '`');
}

}  // namespace armlet
