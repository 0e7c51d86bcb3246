#pragma once
// Values of programs as C++ stores them: std::string for a text, std::vector<double> for a list of
// numbers, a type of the host as it is.

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "armlet/interpreter/binding/typed_parameters.hpp"

namespace armlet::typed {

// Converts a stored value of type V to the parameter of a `def` function for it.
template <class V>
struct Stored {
  using Type = const V&;
};
template <SlotNumber V>
struct Stored<V> {
  using Type = V;
};
template <>
struct Stored<std::string> {
  using Type = std::string_view;
};
template <>
struct Stored<std::vector<double>> {
  using Type = std::span<const double>;
};

template <class V, class Part>
V stored(const Part& part) {
  if constexpr (std::is_same_v<Part, std::span<const double>>) {
    return V(part.begin(), part.end());
  } else {
    return V(part);
  }
}

// The type of a stored value V in signatures, and a copy of the value in a slot.
template <class V>
inline constexpr ValueKind kStoredKind = Argument<typename Stored<V>::Type>::kKind;
template <class V>
V stored_in(Vm& vm, Slot slot) {
  return stored<V>(Argument<typename Stored<V>::Type>::read(vm, slot));
}

}  // namespace armlet::typed
