#pragma once

#include <string>
#include <string_view>

namespace armlet {

// A text with its XML escapes, for use between tags or in an attribute, so that reading it gives
// the same tabs and line breaks. Other control characters, which XML cannot contain, become blanks.
std::string xml_escaped(std::string_view text);

}  // namespace armlet
