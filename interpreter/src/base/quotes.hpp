#pragma once
// The quotes around a text as it is written: "abc", 'abc', f"abc", """abc""", f"""abc""".

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace armlet::lang {

inline constexpr std::string_view kThreeQuotes = "\"\"\"";

// The numbers of bytes that open and close a text.
struct Quotes {
  std::size_t opening = 1;
  std::size_t closing = 1;
  bool spans_lines = false;
};

// The quotes of a text token, whose closing quotes may be missing.
[[nodiscard]] constexpr Quotes quotes_of(std::string_view written) {
  const std::size_t letters = written.starts_with('f') ? 1 : 0;
  if (written.substr(letters).starts_with(kThreeQuotes)) return {letters + 3, 3, true};
  return {letters + 1, 1, false};
}

// The characters between the quotes of a closed text.
[[nodiscard]] constexpr std::string_view inside_quotes(std::string_view written) {
  const Quotes quotes = quotes_of(written);
  if (written.size() < quotes.opening + quotes.closing) return {};
  return written.substr(quotes.opening, written.size() - quotes.opening - quotes.closing);
}

}  // namespace armlet::lang
