#pragma once
// Bytes as text: four bytes are five digits to the base 85, the characters from ( to ; and from >
// to ~. A remainder of n bytes at the end becomes n + 1 digits. A page reads the same code
// (page/src/alone/packed.ts).

#include <optional>
#include <string>
#include <string_view>

namespace armlet::lab {

[[nodiscard]] std::string to_base85(std::string_view bytes);
// Nullopt: the text is not valid.
[[nodiscard]] std::optional<std::string> from_base85(std::string_view text);

// Whether bytes are UTF-8 without zeros, so that a message can contain them unchanged.
[[nodiscard]] bool is_text(std::string_view bytes);

}  // namespace armlet::lab
