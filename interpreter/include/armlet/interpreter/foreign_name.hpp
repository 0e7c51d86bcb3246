#pragma once
// Names of other languages for functions of a library.

#include <cstdint>
#include <string_view>

namespace armlet {

enum class ForeignKind : std::uint8_t { kName, kType, kSetting };

// A row of Engine::add_foreign_names: messages about an unknown name propose the name in this
// language.
struct ForeignName {
  std::string_view foreign;
  std::string_view here;    // text that can replace it; empty if it has no counterpart
  std::string_view note{};  // one sentence about a name, may be empty
  ForeignKind kind = ForeignKind::kName;
};

}  // namespace armlet
