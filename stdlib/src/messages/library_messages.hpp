#pragma once
// The messages about robots, worlds and linear algebra.

#include <array>
#include <string_view>

#include "armlet/interpreter/messages/message_code.hpp"

namespace armlet::bind {

#define ARMLET_MESSAGE(code, kind, headline, page) CatalogEntry{#code, kind, headline, page},
inline constexpr auto kLibraryMessages = std::to_array<CatalogEntry>({
// clang-format off
#include "messages/checks.def"
#include "messages/failures.def"
#include "messages/advice.def"
    // clang-format on
});
#undef ARMLET_MESSAGE

// The row of the catalogue with a code, for make_diagnostic and Headline.
consteval const CatalogEntry& row(std::string_view code) {
  for (const CatalogEntry& entry : kLibraryMessages)
    if (entry.code == code) return entry;
  throw "the library has no message with this code";
}

}  // namespace armlet::bind
