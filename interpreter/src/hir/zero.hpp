#pragma once
// Which elements `new T[n]` gives a value.

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// new T[n] holds values: 0, false, "", the first value of an enum, empty lists. Otherwise its
// elements are not set yet.
[[nodiscard]] inline bool has_zero(const Type& element) {
  return !element.is_reference() || element.is(Kind::kText) || element.is(Kind::kList);
}

}  // namespace armlet::lang
