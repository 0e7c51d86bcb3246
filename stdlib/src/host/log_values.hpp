#pragma once
// Values of programs as text in logs: one character for the kind, then the content; docs/logs.md.

#include <string>
#include <string_view>

#include "armlet/interpreter/host/value.hpp"

namespace armlet::log {

// throws  ArgumentError for a value of a type of the host, and for lists nested 100 deep.
void append_value(std::string& out, const Value& value);

// Reads from the front of a text, and removes what it has read.
class ValueReader {
 public:
  explicit ValueReader(std::string_view text) : text_(text) {}

  // throws  ArgumentError if the text does not begin with a value.
  Value read(int depth = 0);
  [[nodiscard]] bool is_at_end() const { return text_.empty(); }

 private:
  char take();
  std::int64_t integer();
  std::size_t count();
  double real();
  std::string text();
  Value matrix();
  Value record(int depth);
  std::string_view bytes(std::size_t size);

  std::string_view text_;
};

}  // namespace armlet::log
