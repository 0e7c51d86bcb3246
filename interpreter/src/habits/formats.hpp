#pragma once
// Formats of C, Java and Python as formatted texts: "n = %d", n is f"n = {n}".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// The values between the commas of a text, brackets and quotes in pairs.
[[nodiscard]] std::vector<std::string> values_of(std::string_view text);

// values     the quoted format, then what it shows.
// is_line    the text is printed as a line: it has to end with a line break, which is left out.
// returns    nothing if a conversion has no counterpart, or a value is missing.
[[nodiscard]] std::optional<std::string> formatted_text(const std::vector<std::string>& values,
                                                        bool is_line);

// Python's "{} {:.2f}" and its values in their order; nothing if they are numbered or named.
[[nodiscard]] std::optional<std::string> text_with_braces(const std::vector<std::string>& values);

// What C++ writes: "n = " << n << std::endl.
//
// is_line    it has to end with a line break, which is left out.
[[nodiscard]] std::optional<std::string> streamed_text(const std::string& written, bool is_line);

// Values and, as the last one, the text that stands between them.
[[nodiscard]] std::optional<std::string> separated_text(const std::vector<std::string>& values);

// MATLAB's strcat of two texts, which loses blanks at their ends; nothing where it would.
[[nodiscard]] std::optional<std::string> joined_texts(const std::vector<std::string>& texts);

}  // namespace armlet::lang
