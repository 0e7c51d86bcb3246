#pragma once
// Values as the oracle has them: whole trees, copied whenever they are read. Nothing is shared, so
// nothing can be changed by accident.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "hir/hir.hpp"

namespace armlet::oracle {

struct Value;

struct Absent {};  // no value yet, or an optional argument left out
struct List {
  std::vector<Value> items;
};

// What ends a program, or is caught.
struct Failure {
  std::string code;
  std::string message;
  std::string kind;
  Span where;
  std::int64_t time_ns = -1;  // when it was seen first; -1: by nobody yet
};

struct Record {
  std::vector<Value> fields;
  std::shared_ptr<const Failure> failure;  // of a caught error; thrown again it is the old one
};
struct Map {
  std::vector<Value> keys;
  std::vector<Value> values;                               // as many
  [[nodiscard]] std::size_t find(const Value& key) const;  // the number of keys: it is not there
};
using Captures = std::vector<std::shared_ptr<Value>>;
struct Closure {
  const lang::hir::Function* function;
  Captures captures;
};
struct Matrix {
  std::size_t rows;
  std::size_t cols;
  std::vector<Value> numbers;  // row after row
};

struct Value {
  // Enum values are the ordinals.
  std::variant<Absent, bool, std::int64_t, double, std::string, List, Record, Closure, Matrix, Map>
      is;

  [[nodiscard]] bool absent() const { return std::holds_alternative<Absent>(is); }
  [[nodiscard]] bool truth() const { return std::get<bool>(is); }
  [[nodiscard]] std::int64_t integer() const { return std::get<std::int64_t>(is); }
  [[nodiscard]] double real() const { return std::get<double>(is); }
  [[nodiscard]] const std::string& text() const { return std::get<std::string>(is); }
  [[nodiscard]] List& list() { return std::get<List>(is); }
  [[nodiscard]] const List& list() const { return std::get<List>(is); }
  [[nodiscard]] Record& record() { return std::get<Record>(is); }
  [[nodiscard]] const Record& record() const { return std::get<Record>(is); }
  [[nodiscard]] const Closure& closure() const { return std::get<Closure>(is); }
  [[nodiscard]] Map& map() { return std::get<Map>(is); }
  [[nodiscard]] const Map& map() const { return std::get<Map>(is); }
  [[nodiscard]] Matrix& matrix() { return std::get<Matrix>(is); }
  [[nodiscard]] const Matrix& matrix() const { return std::get<Matrix>(is); }
};

// == of the language: by contents.
[[nodiscard]] bool equal(const Value& a, const Value& b);

// The characters (code points) of a text, each as a text of its own.
[[nodiscard]] std::vector<std::string> characters(const std::string& text);

}  // namespace armlet::oracle
