#pragma once
// The types that have a name of their own, one row each.

#include <string_view>

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

struct BasicType {
  std::string_view name;
  std::string_view other_name;  // that it may be written by as well
  const Type* (TypePool::*type)() const;
};

inline constexpr BasicType kBasicTypes[] = {
    {"int", "long", &TypePool::integer},     {"double", "float", &TypePool::real},
    {"bool", "boolean", &TypePool::boolean}, {"string", "String", &TypePool::text},
    {"matrix", "Matrix", &TypePool::matrix},
};

// Null if the name is none of these.
[[nodiscard]] inline const Type* basic_type(const TypePool& types, std::string_view name) {
  for (const BasicType& row : kBasicTypes) {
    if (name == row.name || name == row.other_name) return (types.*row.type)();
  }
  return nullptr;
}

}  // namespace armlet::lang
