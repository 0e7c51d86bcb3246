#pragma once
// What users of other languages write for a name of the library.

#include <cstdint>
#include <string_view>

namespace armlet {

enum class ForeignKind : std::uint8_t { kName, kType, kSetting };

// A row of Engine::add_foreign_names: messages about an unknown name say what it is called here.
struct ForeignName {
  std::string_view foreign;
  std::string_view here;    // text that can stand in its place; empty if there is no such thing
  std::string_view note{};  // one sentence about a name, may be empty
  ForeignKind kind = ForeignKind::kName;
};

}  // namespace armlet
