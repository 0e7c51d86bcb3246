#pragma once
// Mistakes in the functions and types that a host or the library defines.

#include <string>
#include <vector>

#include "vocabulary/registry.hpp"

namespace armlet {
class TypeDefinition;
}

namespace armlet::lang {

// The reasons why a function cannot be defined, as clauses: its signature is invalid or differs
// from the C++ function, or a name in it is not a valid name.
[[nodiscard]] std::vector<std::string> faults_of(const Registry& registry,
                                                 const NativeFunction& function);
// The reasons why functions and records of a registry are invalid, as clauses.
[[nodiscard]] std::vector<std::string> check_signatures(const Registry& registry);
// Adds a type and its functions, and keeps them as long as the registry.
//
// returns  every mistake, as clauses; then nothing is added.
std::vector<std::string> add_type(Registry& registry, const TypeDefinition& definition);

}  // namespace armlet::lang
