#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace armlet {

// The value of a named input or output of the program: a switch or a number.
using SignalValue = std::variant<bool, double>;

// Signals in the order in which they were first set.
class Signals {
 public:
  void set(std::string_view name, SignalValue value) {
    const auto found = index_.find(name);
    if (found != index_.end()) {
      signals_[found->second].second = value;
    } else {
      index_.emplace(name, signals_.size());
      signals_.emplace_back(std::string(name), value);
    }
  }

  // Nothing if it was never set.
  [[nodiscard]] std::optional<SignalValue> get(std::string_view name) const {
    const auto found = index_.find(name);
    return found == index_.end() ? std::nullopt
                                 : std::optional<SignalValue>(signals_[found->second].second);
  }

  [[nodiscard]] const std::vector<std::pair<std::string, SignalValue>>& all() const {
    return signals_;
  }

 private:
  struct NameHash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  std::vector<std::pair<std::string, SignalValue>> signals_;
  std::unordered_map<std::string, std::size_t, NameHash, std::equal_to<>> index_;
};

}  // namespace armlet
