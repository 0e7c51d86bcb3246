#pragma once
// The result of a native function: a value, or none because it failed.

#include <optional>
#include <utility>

#include "armlet/interpreter/native.hpp"

namespace armlet {

// A value, or none. Without a value the failure is stored in the Vm, by `fail` or by a call that
// failed.
template <class T>
class [[nodiscard]] Answer {
 public:
  Answer(T value) : value_(std::move(value)) {}
  Answer(Failed) {}

  [[nodiscard]] explicit operator bool() const { return value_.has_value(); }
  // Undefined if there is no value.
  [[nodiscard]] const T& operator*() const& { return *value_; }
  [[nodiscard]] T& operator*() & { return *value_; }
  [[nodiscard]] T&& operator*() && { return *std::move(value_); }
  [[nodiscard]] const T* operator->() const { return &*value_; }
  [[nodiscard]] T* operator->() { return &*value_; }

 private:
  std::optional<T> value_{};
};

template <>
class [[nodiscard]] Answer<void> {
 public:
  Answer() = default;
  Answer(Failed) : done_(false) {}
  [[nodiscard]] explicit operator bool() const { return done_; }

 private:
  bool done_ = true;
};

}  // namespace armlet
