#pragma once

#include <string>
#include <string_view>

namespace armlet {

// A text as it stands in XML, between tags or in an attribute, and is read back with its tabs and
// line breaks. Other control characters, which XML has no way to write, become blanks.
std::string xml_escaped(std::string_view text);

}  // namespace armlet
