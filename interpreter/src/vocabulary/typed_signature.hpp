#pragma once
// Compares the parameters and the result of a C++ function with its signature (define.hpp).

#include <string>
#include <vector>

#include "vocabulary/signature.hpp"

namespace armlet::lang {

// The differences, as one clause each: "parameter 2, `tol: length`, is a std::string_view in C++".
// Empty for functions that were not made by `def`.
[[nodiscard]] std::vector<std::string> typed_faults(const NativeFunction& function,
                                                    const Signature& signature);

// Whether values of the type have this kind in C++.
[[nodiscard]] bool stands_for(const Type& type, const ValueKind& kind);
// The C++ type that stores a value of this kind: "std::string", "double".
[[nodiscard]] std::string stored_name(const ValueKind& kind);

}  // namespace armlet::lang
