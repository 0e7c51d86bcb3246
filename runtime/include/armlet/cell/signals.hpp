#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace armlet {

// A named line between the program and its surroundings: a switch or a number.
using SignalValue = std::variant<bool, double>;

// Signals in the order in which they were first set.
class Signals {
 public:
  void set(std::string_view name, SignalValue value) {
    const auto found =
        std::ranges::find(signals_, name, &std::pair<std::string, SignalValue>::first);
    if (found != signals_.end()) {
      found->second = value;
    } else {
      signals_.emplace_back(std::string(name), value);
    }
  }

  // Nothing if it was never set.
  [[nodiscard]] std::optional<SignalValue> get(std::string_view name) const {
    const auto found =
        std::ranges::find(signals_, name, &std::pair<std::string, SignalValue>::first);
    return found == signals_.end() ? std::nullopt : std::optional<SignalValue>(found->second);
  }

  [[nodiscard]] const std::vector<std::pair<std::string, SignalValue>>& all() const {
    return signals_;
  }

 private:
  std::vector<std::pair<std::string, SignalValue>> signals_;
};

}  // namespace armlet
