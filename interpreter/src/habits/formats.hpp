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
// is_line    the text is printed: a line break at its end goes without saying.
// returns    nothing if a conversion has no counterpart, or a value is missing.
[[nodiscard]] std::optional<std::string> formatted_text(const std::vector<std::string>& values,
                                                        bool is_line);

// Python's "{} {:.2f}" and its values in their order; nothing if they are numbered or named.
[[nodiscard]] std::optional<std::string> text_with_braces(const std::vector<std::string>& values);

}  // namespace armlet::lang
