#include <fmt/format.h>

#include "missing_cxx20.hpp"

#ifdef ARMLET_MISSING_CHARCONV

namespace std {

// fmt's digits are the fewest that distinguish a number from its neighbours, and of these the
// nearest to it, as the standard wants them.
to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  const auto decimal = fmt::detail::dragonbox::to_decimal(value);
  const string digits = to_string(decimal.significand);
  const int exponent = decimal.exponent + static_cast<int>(digits.size()) - 1;
  const string text = fmt::format("{}{}{}e{}{:02}", digits[0], digits.size() > 1 ? "." : "",
                                  digits.substr(1), exponent < 0 ? '-' : '+', abs(exponent));
  if (static_cast<ptrdiff_t>(text.size()) > last - first) return {last, errc::value_too_large};
  memcpy(first, text.data(), text.size());
  return {first + text.size(), errc()};
}

}  // namespace std

#endif
