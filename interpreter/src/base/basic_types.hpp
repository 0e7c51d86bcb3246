#pragma once
// The basic types of the language with their names, one row each.

#include <string_view>

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

struct BasicType {
  std::string_view name;
  std::string_view other_name;  // a second name of the type
  const Type* (TypePool::*type)() const;
};

inline constexpr BasicType kBasicTypes[] = {
    {"int", "long", &TypePool::integer},     {"double", "float", &TypePool::real},
    {"bool", "boolean", &TypePool::boolean}, {"string", "String", &TypePool::text},
    {"matrix", "Matrix", &TypePool::matrix},
};

// The basic type with a name; null if there is none.
[[nodiscard]] inline const Type* basic_type(const TypePool& types, std::string_view name) {
  for (const BasicType& row : kBasicTypes) {
    if (name == row.name || name == row.other_name) return (types.*row.type)();
  }
  return nullptr;
}

}  // namespace armlet::lang
