#pragma once
// Converts formats of C, Java and Python to formatted texts: "n = %d", n is f"n = {n}".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// The values of a list with commas. Commas in brackets and quotes do not separate.
[[nodiscard]] std::vector<std::string> values_of(std::string_view text);

// values     the quoted format, then its arguments.
// is_line    the text is printed as a line: it must end with a line break, which is omitted.
// returns    empty if a conversion has no counterpart, or a value is missing.
[[nodiscard]] std::optional<std::string> formatted_text(const std::vector<std::string>& values,
                                                        bool is_line);

// Python's "{} {:.2f}" with its arguments in order; empty if they are numbered or named.
[[nodiscard]] std::optional<std::string> text_with_braces(const std::vector<std::string>& values);

// The output of C++ streams: "n = " << n << std::endl.
//
// is_line    it must end with a line break, which is omitted.
[[nodiscard]] std::optional<std::string> streamed_text(const std::string& written, bool is_line);

// Values, the last of which is the text between them.
[[nodiscard]] std::optional<std::string> separated_text(const std::vector<std::string>& values);

// MATLAB's strcat of two texts, which removes blanks at their ends; empty if it would remove some.
[[nodiscard]] std::optional<std::string> joined_texts(const std::vector<std::string>& texts);

}  // namespace armlet::lang
