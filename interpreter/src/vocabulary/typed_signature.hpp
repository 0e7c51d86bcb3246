#pragma once
// Whether a function in C++ has the parameters and the result that its signature says (define.hpp).

#include <string>
#include <vector>

#include "vocabulary/signature.hpp"

namespace armlet::lang {

// Every difference, as a clause each: "parameter 2, `tol: length`, is a std::string_view in C++".
// Empty for functions that `def` did not make.
[[nodiscard]] std::vector<std::string> typed_faults(const NativeFunction& function,
                                                    const Signature& signature);

// Whether values of the type are of this kind in C++.
[[nodiscard]] bool stands_for(const Type& type, const ValueKind& kind);
// What stores a value of this kind in C++: "std::string", "double".
[[nodiscard]] std::string stored_name(const ValueKind& kind);

}  // namespace armlet::lang
