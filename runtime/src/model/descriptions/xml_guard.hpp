#pragma once

#include <string>
#include <string_view>

namespace armlet {

// Why a text should not be given to an XML parser that recurses, trusts its input and looks through
// all attributes of an element for each of them. Empty if it may; whether its tags match, the
// parser says.
//
// Refused are texts that are empty or hold a control character, declare entities, have tags,
// comments or entities that XML does not know, or exceed a limit: 16 MB; 100,000 elements, nested
// 100 deep, of 100 attributes; names of 200 bytes and values of 10,000; 10,000 comments,
// instructions and sections of plain text; 100,000 entities; text of 1,000,000 bytes. The message
// names the limit and what was given, and the line. Takes time in proportion to the text.
std::string xml_fault(std::string_view text);

// Where a piece of XML that begins at `at` ends, after its last letters; at the end of the text if
// it does not.
std::size_t after_xml(std::string_view text, std::size_t at, std::string_view last);
// Where the tag that begins at `at` ends, after its >; quoted text may hold one too.
std::size_t after_xml_tag(std::string_view text, std::size_t at);

}  // namespace armlet
