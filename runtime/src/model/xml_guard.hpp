#pragma once

#include <string>
#include <string_view>

namespace armlet {

// Why a text should not be given to an XML parser that recurses and trusts its input: it is empty,
// larger than 16 MB, holds a zero byte, declares entities or is nested more than 100 deep. Empty if
// it may; whether it is XML, the parser says.
std::string xml_fault(std::string_view text);

}  // namespace armlet
