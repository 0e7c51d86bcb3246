#pragma once
// What is wrong with the functions and types that a host or the library defines.

#include <string>
#include <vector>

#include "vocabulary/registry.hpp"

namespace armlet {
class TypeDefinition;
}

namespace armlet::lang {

// Why a function cannot be defined, as clauses: its signature cannot be read, differs from the
// function in C++, or has what cannot be a name.
[[nodiscard]] std::vector<std::string> faults_of(const Registry& registry,
                                                 const NativeFunction& function);
// The same of all functions and records of a registry.
[[nodiscard]] std::vector<std::string> check_signatures(const Registry& registry);
// Adds a type and its functions, and keeps them as long as the registry.
//
// returns  every mistake, as clauses; then nothing is added.
std::vector<std::string> add_type(Registry& registry, const TypeDefinition& definition);

}  // namespace armlet::lang
