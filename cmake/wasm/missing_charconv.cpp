#include <fmt/format.h>

#include "missing_cxx20.hpp"

#ifdef ARMLET_MISSING_CHARCONV

namespace std {

// fmt's digits are the fewest that distinguish a number from its neighbours, and of these the
// nearest to it, as the standard wants them. It writes 12.5, 0.001 or 1e-05.
to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  const string shortest = fmt::format("{}", value);
  const size_t end = min(shortest.find('e'), shortest.size());
  const size_t point = min(shortest.find('.'), end);
  const size_t behind = min(point + 1, end);
  string digits = shortest.substr(0, point) + shortest.substr(behind, end - behind);
  int exponent = static_cast<int>(point) - 1;
  if (end < shortest.size()) exponent += atoi(shortest.c_str() + end + 1);
  const size_t zeros = digits.find_first_not_of('0');
  exponent -= static_cast<int>(zeros);
  digits = digits.substr(zeros, digits.find_last_not_of('0') + 1 - zeros);
  const string text = fmt::format("{}{}{}e{}{:02}", digits[0], digits.size() > 1 ? "." : "",
                                  digits.substr(1), exponent < 0 ? '-' : '+', abs(exponent));
  if (static_cast<ptrdiff_t>(text.size()) > last - first) return {last, errc::value_too_large};
  memcpy(first, text.data(), text.size());
  return {first + text.size(), errc()};
}

}  // namespace std

#endif
