#pragma once
// Bytes as text: four of them as five digits to the base 85, the signs from ( to ; and from > to ~.
// Of fewer bytes at the end as many digits and one are written. A page reads the same
// (page/src/alone/packed.ts).

#include <optional>
#include <string>
#include <string_view>

namespace armlet::lab {

[[nodiscard]] std::string to_base85(std::string_view bytes);
// Nothing: it is no such text.
[[nodiscard]] std::optional<std::string> from_base85(std::string_view text);

// Whether bytes are UTF-8 without zeros, so that a message can carry them as they are.
[[nodiscard]] bool is_text(std::string_view bytes);

}  // namespace armlet::lab
