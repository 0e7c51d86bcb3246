#pragma once
#pragma GCC system_header
// <locale> and <codecvt> of the WebAssembly build: what ANTLR's runtime wants of them.

#include <utf8.h>

#include <iterator>
#include <stdexcept>
#include <string>

namespace std {
inline namespace bare {

// The locale "C".
class locale {};

inline bool isupper(char letter, const locale&) { return letter >= 'A' && letter <= 'Z'; }

template <class Wide>
struct codecvt_utf8;
template <class Wide>
struct codecvt_utf8_utf16;

template <class Form, class Wide = wchar_t>
class wstring_convert;

template <class Text, class Convert>
Text converted(const char* fault, Convert convert) {
  Text text;
  try {
    convert(back_inserter(text));
  } catch (const utf8::exception&) {
    throw range_error(fault);
  }
  return text;
}

// UTF-8 and UTF-32.
template <class Wide>
class wstring_convert<codecvt_utf8<Wide>, Wide> {
 public:
  basic_string<Wide> from_bytes(const char* first, const char* last) {
    return converted<basic_string<Wide>>("not UTF-8",
                                         [=](auto out) { utf8::utf8to32(first, last, out); });
  }
  string to_bytes(const basic_string<Wide>& wide) {
    return converted<string>("not UTF-32",
                             [&](auto out) { utf8::utf32to8(wide.begin(), wide.end(), out); });
  }
};

// UTF-8 and UTF-16.
template <class Wide>
class wstring_convert<codecvt_utf8_utf16<Wide>, Wide> {
 public:
  basic_string<Wide> from_bytes(const string& text) {
    return converted<basic_string<Wide>>(
        "not UTF-8", [&](auto out) { utf8::utf8to16(text.begin(), text.end(), out); });
  }
  string to_bytes(const basic_string<Wide>& wide) {
    return converted<string>("not UTF-16",
                             [&](auto out) { utf8::utf16to8(wide.begin(), wide.end(), out); });
  }
};

}  // namespace bare
}  // namespace std
