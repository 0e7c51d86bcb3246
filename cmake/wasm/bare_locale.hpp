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

// UTF-8 and UTF-32.
template <class Wide>
class wstring_convert<codecvt_utf8<Wide>, Wide> {
 public:
  basic_string<Wide> from_bytes(const char* first, const char* last) {
    basic_string<Wide> wide;
    try {
      utf8::utf8to32(first, last, back_inserter(wide));
    } catch (const utf8::exception&) {
      throw range_error("not UTF-8");
    }
    return wide;
  }
  string to_bytes(const basic_string<Wide>& wide) {
    string text;
    try {
      utf8::utf32to8(wide.begin(), wide.end(), back_inserter(text));
    } catch (const utf8::exception&) {
      throw range_error("not UTF-32");
    }
    return text;
  }
};

// UTF-8 and UTF-16.
template <class Wide>
class wstring_convert<codecvt_utf8_utf16<Wide>, Wide> {
 public:
  basic_string<Wide> from_bytes(const string& text) {
    basic_string<Wide> wide;
    try {
      utf8::utf8to16(text.begin(), text.end(), back_inserter(wide));
    } catch (const utf8::exception&) {
      throw range_error("not UTF-8");
    }
    return wide;
  }
  string to_bytes(const basic_string<Wide>& wide) {
    string text;
    try {
      utf8::utf16to8(wide.begin(), wide.end(), back_inserter(text));
    } catch (const utf8::exception&) {
      throw range_error("not UTF-16");
    }
    return text;
  }
};

}  // namespace bare
}  // namespace std
