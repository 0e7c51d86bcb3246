#pragma once
#pragma GCC system_header
// std::from_chars and std::to_chars of doubles for a C++ library without them. strtod and snprintf
// of emscripten's C library round exactly, and its locale never changes.

#define ARMLET_MISSING_CHARCONV 1

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace std {

// The decimal notation alone, as strtod reads it but for blanks, a plus sign and hexadecimal
// digits.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const char* at = first != last && *first == '-' ? first + 1 : first;
  const auto is_digit = [&](const char* c) { return c < last && *c >= '0' && *c <= '9'; };
  const auto is_letter = [&](const char* c) { return c < last && (*c | 0x20) >= 'a'; };
  if (!is_digit(at) && !is_letter(at) && !(at < last && *at == '.' && is_digit(at + 1)))
    return {first, errc::invalid_argument};
  const char* end = last;
  // strtod would go on behind 0x.
  if (last - at > 1 && *at == '0' && (at[1] | 0x20) == 'x') end = at + 1;
  const string text(first, end);
  char* stop = nullptr;
  errno = 0;
  const double read = strtod(text.c_str(), &stop);
  if (stop == text.c_str()) return {first, errc::invalid_argument};
  const char* behind = first + (stop - text.c_str());
  const bool is_word = is_letter(at);
  if (errno == ERANGE && !is_word && (read == 0.0 || read - read != 0.0))
    return {behind, errc::result_out_of_range};
  value = read;
  return {behind, errc()};
}

// In a given number of digits.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format format,
                                int places) {
  const char* pattern = format == chars_format::scientific ? "%.*e"
                        : format == chars_format::fixed    ? "%.*f"
                                                           : "%.*g";
  char text[1200];
  const int size = snprintf(text, sizeof text, pattern, places, value);
  if (size < 0 || size >= static_cast<int>(sizeof text) || size > last - first)
    return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(size));
  return {first + size, errc()};
}

// With as few digits as identify the number, finite and above zero, from its neighbours; in the
// scientific format, whichever is asked for.
to_chars_result to_chars(char* first, char* last, double value, chars_format format);

}  // namespace std
