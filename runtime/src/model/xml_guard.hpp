#pragma once

#include <string>
#include <string_view>

namespace armlet {

// Why a text should not be given to an XML parser that recurses and trusts its input: it is empty,
// larger than 16 MB, holds a zero byte, declares entities or is nested more than 100 deep. Empty if
// it may; whether it is XML, the parser says.
std::string xml_fault(std::string_view text);

// Where a piece of XML that begins at `at` ends, after its last letters; at the end of the text if
// it does not.
std::size_t after_xml(std::string_view text, std::size_t at, std::string_view last);
// Where the tag that begins at `at` ends, after its >; quoted text may hold one too.
std::size_t after_xml_tag(std::string_view text, std::size_t at);

}  // namespace armlet
