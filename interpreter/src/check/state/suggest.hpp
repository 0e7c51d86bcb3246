#pragma once
// "Did you mean ...?" (language reference, section 20.2, rule 6).

#include <optional>
#include <span>
#include <string_view>

#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// A name that could have been meant; its type, if known, to prefer what fits.
struct Candidate {
  std::string_view name;
  const Type* type = nullptr;
};

// The candidate most like a mistyped name (core/similar.hpp says how near it must be). A type other
// than `wanted` counts as one edit and a half further away; among equally close ones the first.
[[nodiscard]] std::optional<Candidate> suggest(std::string_view name,
                                               std::span<const Candidate> candidates,
                                               const Type* wanted = nullptr);
[[nodiscard]] std::optional<std::string_view> suggest(std::string_view name,
                                                      std::span<const std::string_view> candidates);

}  // namespace armlet::lang
