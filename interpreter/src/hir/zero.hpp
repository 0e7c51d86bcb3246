#pragma once
// Types whose elements `new T[n]` initialises.

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// Whether `new T[n]` gives its elements a first value: 0, false, "", the first value of an enum, an
// empty list. Elements of other types have no value until they are assigned.
[[nodiscard]] inline bool has_zero(const Type& element) {
  return !element.is_reference() || element.is(Kind::kText) || element.is(Kind::kList);
}

}  // namespace armlet::lang
