#include "value.hpp"

#include <stdexcept>

namespace armlet::oracle {

namespace {

bool equal_all(const std::vector<Value>& a, const std::vector<Value>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!equal(a[i], b[i])) return false;
  }
  return true;
}

// In any order.
bool equal_maps(const Map& a, const Map& b) {
  if (a.keys.size() != b.keys.size()) return false;
  for (std::size_t i = 0; i < a.keys.size(); ++i) {
    const std::size_t at = b.find(a.keys[i]);
    if (at == b.keys.size() || !equal(a.values[i], b.values[at])) return false;
  }
  return true;
}

}  // namespace

bool equal(const Value& a, const Value& b) {
  if (a.is.index() != b.is.index()) throw std::logic_error("values of two types are compared");
  if (std::holds_alternative<bool>(a.is)) return a.truth() == b.truth();
  if (std::holds_alternative<std::int64_t>(a.is)) return a.integer() == b.integer();
  if (std::holds_alternative<double>(a.is)) return a.real() == b.real();
  if (std::holds_alternative<std::string>(a.is)) return a.text() == b.text();
  if (std::holds_alternative<List>(a.is)) return equal_all(a.list().items, b.list().items);
  if (std::holds_alternative<Record>(a.is)) return equal_all(a.record().fields, b.record().fields);
  if (std::holds_alternative<Matrix>(a.is)) {
    return a.matrix().rows == b.matrix().rows && a.matrix().cols == b.matrix().cols &&
           equal_all(a.matrix().numbers, b.matrix().numbers);
  }
  if (std::holds_alternative<Map>(a.is)) return equal_maps(a.map(), b.map());
  throw std::logic_error("these values cannot be compared");
}

std::vector<std::string> characters(const std::string& text) {
  std::vector<std::string> out;
  for (const char byte : text) {
    const bool goes_on = (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
    if (goes_on && !out.empty()) {
      out.back() += byte;
    } else {
      out.emplace_back(1, byte);
    }
  }
  return out;
}

}  // namespace armlet::oracle
