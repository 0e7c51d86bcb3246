#pragma once
// Proposals for mistyped names: "Did you mean ...?" (language reference, section 20.2, rule 6).

#include <optional>
#include <span>
#include <string_view>

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// A name that may have been meant. Its type is null if it is not known; fitting types are
// preferred.
struct Candidate {
  std::string_view name;
  const Type* type = nullptr;
};

// The candidate most similar to a mistyped name (core/similar.hpp defines the limit). A type other
// than `wanted` counts as one and a half further edits; among equal ones the first is taken.
[[nodiscard]] std::optional<Candidate> suggest(std::string_view name,
                                               std::span<const Candidate> candidates,
                                               const Type* wanted = nullptr);
[[nodiscard]] std::optional<std::string_view> suggest(std::string_view name,
                                                      std::span<const std::string_view> candidates);

}  // namespace armlet::lang
