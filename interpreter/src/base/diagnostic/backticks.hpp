#pragma once
// Quotes pieces of a program in messages.

#include <string>
#include <string_view>

namespace armlet::lang {

inline std::string in_backticks(std::string_view text) { return '`' + std::string(text) + '`'; }

}  // namespace armlet::lang
