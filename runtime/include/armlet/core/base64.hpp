#pragma once

#include <string>
#include <string_view>

namespace armlet {

// Bytes as text: four digits for three bytes, filled up with =.
//
// source  RFC 4648, 2006, section 4.
std::string to_base64(std::string_view bytes);

}  // namespace armlet
