#pragma once

#include <string>
#include <string_view>

namespace armlet {

// Why a text should not be passed to an XML parser that is recursive, trusts its input and takes
// quadratic time in the attributes of an element. Empty if it may be; whether its tags match is
// checked by the parser.
//
// Refused are texts that are empty or contain a control character, declare entities, have tags,
// comments or entities that XML does not know, or exceed a limit: 16 MB; 100,000 elements, nested
// 100 deep, of 100 attributes; names of 200 bytes and values of 10,000; 10,000 comments,
// instructions and sections of plain text; 100,000 entities; text of 1,000,000 bytes. The message
// has the limit, the count, and the line. Takes time in proportion to the text.
std::string xml_fault(std::string_view text);

// The end of a piece of XML that begins at `at` and ends with `last`; the end of the text if it is
// not complete.
std::size_t after_xml(std::string_view text, std::size_t at, std::string_view last);
// The end of the tag that begins at `at`, after its >; quoted text may contain a > too.
std::size_t after_xml_tag(std::string_view text, std::size_t at);

}  // namespace armlet
