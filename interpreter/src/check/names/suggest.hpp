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

// What a word of another language is called here.
struct ForeignName {
  std::string_view foreign;
  std::string_view here;  // text that can stand in its place; empty if there is no such thing
  std::string_view note;  // one sentence, may be empty
};

// null if the word is not known.
[[nodiscard]] const ForeignName* foreign_name(std::string_view word);
[[nodiscard]] std::span<const ForeignName> foreign_names();

// The setting that other languages call `word`: velocity is speed, zone is blend. Empty if not
// known.
[[nodiscard]] std::string_view foreign_setting(std::string_view word);

}  // namespace armlet::lang
