// A value on the heap with a single owner.
#pragma once

#include <memory>
#include <utility>

namespace armlet {

// Copies copy the value. The value keeps its address when the Owned is moved, and a const Owned
// gives const access. Empty only after it was moved from.
template <class T>
class Owned {
 public:
  explicit Owned(T value) : value_(std::make_unique<T>(std::move(value))) {}
  Owned(const Owned& other) : value_(std::make_unique<T>(*other)) {}
  Owned& operator=(const Owned& other) {
    if (this != &other) value_ = std::make_unique<T>(*other);
    return *this;
  }
  Owned(Owned&&) noexcept = default;
  Owned& operator=(Owned&&) noexcept = default;
  ~Owned() = default;

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace armlet
