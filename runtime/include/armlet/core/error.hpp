#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace armlet {

// A violated precondition: what() is a full sentence with the given and the expected value.
class ArgumentError : public std::invalid_argument {
 public:
  explicit ArgumentError(const std::string& message) : std::invalid_argument(message) {}
};

// Throws an ArgumentError. Headers that call this instead of `throw` can be used by hosts compiled
// without exceptions.
[[noreturn]] void refuse_argument(const std::string& message);

// Why there is no answer.
//
// code     short name that programs can compare, for example "unreachable".
// message  full sentence for people, with numbers and units.
struct Error {
  std::string code;
  std::string message;
};

// A value, or the reason why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Error error) : content_(std::move(error)) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  // The value. Throws ArgumentError with the error's message if there is none.
  const T& value() const& {
    require_value();
    return std::get<0>(content_);
  }
  T&& value() && {
    require_value();
    return std::get<0>(std::move(content_));
  }
  const T& operator*() const& { return value(); }
  const T* operator->() const { return &value(); }

  // The reason. Throws ArgumentError if there is a value.
  const Error& error() const {
    if (ok()) refuse_argument("This result holds a value; it has no error to read.");
    return std::get<1>(content_);
  }

 private:
  void require_value() const {
    if (!ok()) refuse_argument(std::get<1>(content_).message);
  }
  std::variant<T, Error> content_;
};

// Throws ArgumentError "`q` has 5 elements; expected 6." unless given == expected.
void check_size(std::string_view name, std::ptrdiff_t given, std::ptrdiff_t expected);

// Throws ArgumentError naming the value that is not a number or infinite.
void check_finite(std::string_view name, double value);

// Throws ArgumentError unless value is a finite number above zero.
void check_positive(std::string_view name, double value);

}  // namespace armlet
