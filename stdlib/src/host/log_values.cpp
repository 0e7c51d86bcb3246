#include "host/log_values.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <utility>

#include "armlet/backend/event.hpp"
#include "armlet/core/error.hpp"

namespace armlet::log {
namespace {

constexpr int kDeepest = 100;

[[noreturn]] void refuse_value() { throw ArgumentError("a value is not written as values are"); }

void append_bits(std::string& out, double value) {
  out += fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value));
}
void append_text(std::string& out, std::string_view text) {
  out += fmt::format("{}:{}", text.size(), text);
}

void append(std::string& out, const Value& value, int depth) {
  if (depth > kDeepest) throw ArgumentError("a value has lists in lists, more than 100 deep");
  const Overload each{
      [&](std::monostate) { out += 'n'; },
      [&](bool truth) { out += truth ? 't' : 'f'; },
      [&](std::int64_t number) { out += fmt::format("i{};", number); },
      [&](const Value::Number& number) {
        out += 'd';
        append_bits(out, number.si);
        const Dim& dim = number.dim;
        out += fmt::format("{};{};{};{};", dim.length, dim.mass, dim.time, dim.angle);
      },
      [&](const std::string& text) {
        out += 's';
        append_text(out, text);
      },
      [&](const Value::List& list) {
        out += fmt::format("l{};", list.size());
        for (const Value& item : list) append(out, item, depth + 1);
      },
      [&](const Value::Matrix& matrix) {
        out += fmt::format("m{};{};", matrix.rows, matrix.cols);
        for (const double element : matrix.elements) append_bits(out, element);
      },
      [&](const Value::Record& record) {
        out += 'r';
        append_text(out, record.type);
        out += fmt::format("{};", record.fields.size());
        for (const auto& [name, field] : record.fields) {
          append_text(out, name);
          append(out, field, depth + 1);
        }
      },
      [&](const Value::Enum& one) {
        out += 'e';
        append_text(out, one.type);
        append_text(out, one.value);
      },
      [&](const Value::Map& map) {
        out += fmt::format("p{};", map.size());
        for (const auto& [key, mapped] : map) {
          append(out, key, depth + 1);
          append(out, mapped, depth + 1);
        }
      },
      [&](const Value::Host&) {
        throw ArgumentError(value.kind() + " belongs to the host and cannot be written to a file");
      },
  };
  std::visit(each, value.content());
}

}  // namespace

void append_value(std::string& out, const Value& value) { append(out, value, 0); }

char ValueReader::take() { return bytes(1)[0]; }

std::string_view ValueReader::bytes(std::size_t size) {
  if (size > text_.size()) refuse_value();
  const std::string_view taken = text_.substr(0, size);
  text_.remove_prefix(size);
  return taken;
}

std::int64_t ValueReader::integer() {
  std::int64_t number = 0;
  const char* end = text_.data() + text_.size();
  const auto [stop, error] = std::from_chars(text_.data(), end, number);
  if (error != std::errc() || stop == end) refuse_value();
  text_.remove_prefix(static_cast<std::size_t>(stop - text_.data()) + 1);  // with its terminator
  return number;
}

// Reads a number of items. Each item takes at least one byte, so it cannot exceed the rest.
std::size_t ValueReader::count() {
  const std::int64_t number = integer();
  if (number < 0 || static_cast<std::uint64_t>(number) > text_.size()) refuse_value();
  return static_cast<std::size_t>(number);
}

double ValueReader::real() {
  const std::string_view digits = bytes(16);
  std::uint64_t bits = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + 16, bits, 16);
  if (error != std::errc() || stop != digits.data() + 16) refuse_value();
  return std::bit_cast<double>(bits);
}

std::string ValueReader::text() { return std::string(bytes(count())); }

Value ValueReader::matrix() {
  Value::Matrix out;
  const std::size_t rows = count();
  const std::size_t cols = count();
  if (cols != 0 && rows > text_.size() / 16 / cols) refuse_value();
  out.rows = static_cast<std::uint32_t>(rows);
  out.cols = static_cast<std::uint32_t>(cols);
  for (std::size_t i = 0; i < rows * cols; ++i) out.elements.push_back(real());
  return out;
}

Value ValueReader::record(int depth) {
  Value::Record out{text(), {}};
  for (std::size_t left = count(); left != 0; --left) {
    std::string name = text();
    out.fields.emplace_back(std::move(name), read(depth + 1));
  }
  return out;
}

Value ValueReader::read(int depth) {
  if (depth > kDeepest) refuse_value();
  const auto small = [this] {
    const std::int64_t number = integer();
    if (number < -128 || number > 127) refuse_value();
    return static_cast<std::int8_t>(number);
  };
  switch (take()) {
    case 'n':
      return {};
    case 't':
      return true;
    case 'f':
      return false;
    case 'i':
      return integer();
    case 's':
      return text();
    case 'd': {
      Value::Number number{.si = real()};
      for (std::int8_t* part :
           {&number.dim.length, &number.dim.mass, &number.dim.time, &number.dim.angle})
        *part = small();
      return number;
    }
    case 'l': {
      Value::List list;
      for (std::size_t left = count(); left != 0; --left) list.push_back(read(depth + 1));
      return list;
    }
    case 'm':
      return matrix();
    case 'r':
      return record(depth);
    case 'e': {
      std::string type = text();
      return Value::Enum{std::move(type), text()};
    }
    case 'p': {
      Value::Map map;
      const std::size_t pairs = count();
      for (std::size_t i = 0; i < pairs; ++i) {
        Value key = read(depth + 1);
        map.emplace_back(std::move(key), read(depth + 1));
      }
      return map;
    }
    default:
      refuse_value();
  }
}

}  // namespace armlet::log
