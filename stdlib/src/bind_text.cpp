// Text (language reference, 19.2). Positions count characters, not bytes.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "armlet/interpreter/unit.hpp"
#include "bind.hpp"

namespace armlet::bind {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

// Byte offset of character `index`, or npos when the text is shorter.
std::size_t offset_of(std::string_view text, std::int64_t index) {
  std::int64_t seen = -1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_continuation(text[i]) && ++seen == index) return i;
  }
  return seen + 1 == index ? text.size() : std::string_view::npos;
}
std::int64_t characters(std::string_view text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return !is_continuation(c); });
}

// Upper or lower case of the letters that identifiers may have: ASCII, Latin-1 and Greek.
template <bool kUpper>
Signal change_case(Vm& vm, Slot* args) {
  std::string out(text_value(args[0]));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto c = static_cast<unsigned char>(out[i]);
    if (kUpper ? (c >= 'a' && c <= 'z') : (c >= 'A' && c <= 'Z'))
      out[i] = static_cast<char>(c ^ 0x20U);
    if (c == 0xC3U &&
        i + 1 < out.size()) {  // U+00C0 .. U+00FF; the division and multiplication signs stay
      const auto d = static_cast<unsigned char>(out[i + 1]);
      const bool lower = d >= 0xA0U && d <= 0xBEU && d != 0xB7U;
      const bool upper = d >= 0x80U && d <= 0x9EU && d != 0x97U;
      if (kUpper ? lower : upper) out[i + 1] = static_cast<char>(d ^ 0x20U);
    }
  }
  return give(args, new_text(vm, out));
}

Signal trim(Vm& vm, Slot* args) {
  std::string_view s = text_value(args[0]);
  const std::string_view blanks = " \t\r\n";
  const std::size_t first = s.find_first_not_of(blanks);
  s = first == std::string_view::npos ? std::string_view()
                                      : s.substr(first, s.find_last_not_of(blanks) - first + 1);
  return give(args, new_text(vm, s));
}

Signal split(Vm& vm, Slot* args) {
  const std::string_view s = text_value(args[0]);
  const std::string_view separator = text_value(args[1]);
  if (separator.empty())
    return failure(vm, "R0609", "split needs a text to split at, and this one is empty", 1);
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t at = s.find(separator); at != std::string_view::npos;
       at = s.find(separator, begin)) {
    parts.push_back(s.substr(begin, at - begin));
    begin = at + separator.size();
  }
  parts.push_back(s.substr(begin));
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(parts.size()), true);
  if (list == nullptr) return Signal::kFail;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    list->data[i].o = new_text(vm, parts[i]);
    if (list->data[i].o == nullptr) {
      release(vm, list);
      return Signal::kFail;
    }
  }
  return give(args, list);
}

Signal replace(Vm& vm, Slot* args) {
  const std::string_view s = text_value(args[0]);
  const std::string_view from = text_value(args[1]);
  const std::string_view to = text_value(args[2]);
  if (from.empty())
    return failure(vm, "R0609", "replace needs a text to look for, and this one is empty", 1);
  std::string out;
  std::size_t begin = 0;
  for (std::size_t at = s.find(from); at != std::string_view::npos; at = s.find(from, begin)) {
    out.append(s.substr(begin, at - begin)).append(to);
    begin = at + from.size();
    if (out.size() > vm.options().limits.heap_bytes) break;  // new_text reports the limit
  }
  out.append(s.substr(begin));
  return give(args, new_text(vm, out));
}

Signal starts_with(Vm&, Slot* args) {
  return give(args, text_value(args[0]).starts_with(text_value(args[1])));
}
Signal contains_text(Vm&, Slot* args) {
  return give(args, text_value(args[0]).find(text_value(args[1])) != std::string_view::npos);
}
Signal equals(Vm&, Slot* args) { return give(args, text_value(args[0]) == text_value(args[1])); }

Signal substring(Vm& vm, Slot* args) {
  const std::string_view s = text_value(args[0]);
  const std::int64_t a = args[1].i;
  const std::int64_t b = is_absent(args[2]) ? characters(s) : args[2].i;
  const std::size_t begin = a < 0 ? std::string_view::npos : offset_of(s, a);
  const std::size_t end = b < a ? std::string_view::npos : offset_of(s, b);
  if (begin == std::string_view::npos || end == std::string_view::npos) {
    return failure(vm, "R0606",
                   fmt::format("characters {} to {} are outside a text of {} characters", a, b,
                               characters(s)));
  }
  return give(args, new_text(vm, s.substr(begin, end - begin)));
}

Signal join(Vm& vm, Slot* args) {
  std::string out;
  const std::string_view separator = text_value(args[1]);
  bool first = true;
  for (const Slot part : items_value(args[0])) {
    if (!first) out.append(separator);
    out.append(text_value(part));
    first = false;
  }
  return give(args, new_text(vm, out));
}

std::string_view trimmed(std::string_view s) {
  const std::size_t first = s.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos
             ? std::string_view()
             : s.substr(first, s.find_last_not_of(" \t\r\n") - first + 1);
}
Signal parse_double(Vm& vm, Slot* args) {
  const std::string_view s = trimmed(text_value(args[0]));
  double value = 0.0;
  const char* begin = s.data() + (s.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, s.data() + s.size(), value);
  if (error != std::errc() || end != s.data() + s.size() || !std::isfinite(value)) {
    return failure(vm, "R0609", fmt::format("\"{}\" is not a number", s), 0);
  }
  return give(args, value);
}
Signal parse_int(Vm& vm, Slot* args) {
  const std::string_view s = trimmed(text_value(args[0]));
  std::int64_t value = 0;
  const char* begin = s.data() + (s.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, s.data() + s.size(), value);
  if (error == std::errc::result_out_of_range)
    return failure(vm, "R0610", fmt::format("{} is too large for an int", s), 0);
  if (error != std::errc() || end != s.data() + s.size())
    return failure(vm, "R0609", fmt::format("\"{}\" is not a whole number", s), 0);
  return give(args, value);
}

Signal code_of(Vm& vm, Slot* args) {
  const std::string_view s = text_value(args[0]);
  if (characters(s) != 1)
    return failure(vm, "R0613",
                   fmt::format("codeOf needs one character, and this text has {}", characters(s)),
                   0);
  const auto lead = static_cast<unsigned char>(s[0]);
  std::int64_t code = lead < 0x80U   ? lead
                      : lead < 0xE0U ? lead & 0x1FU
                      : lead < 0xF0U ? lead & 0x0FU
                                     : lead & 0x07U;
  for (const char c : s.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3FU);
  return give(args, code);
}
Signal char_of(Vm& vm, Slot* args) {
  const std::int64_t n = args[0].i;
  if (n < 0 || n > 0x10FFFF || (n >= 0xD800 && n <= 0xDFFF))
    return failure(vm, "R0609", fmt::format("there is no character number {}", n), 0);
  std::string out;
  const auto part = [&](int shift) { return static_cast<char>(0x80 | (n >> shift & 0x3F)); };
  if (n < 0x80) {
    out = {static_cast<char>(n)};
  } else if (n < 0x800) {
    out = {static_cast<char>(0xC0 | n >> 6), part(0)};
  } else if (n < 0x10000) {
    out = {static_cast<char>(0xE0 | n >> 12), part(6), part(0)};
  } else {
    out = {static_cast<char>(0xF0 | n >> 18), part(12), part(6), part(0)};
  }
  return give(args, new_text(vm, out));
}

constexpr NativeFunction kFunctions[] = {
    {"upper", "(s: string) -> string", "The text in capital letters.", "\"arm\".upper()",
     change_case<true>},
    {"lower", "(s: string) -> string", "The text in small letters.", "\"ARM\".lower()",
     change_case<false>},
    {"trim", "(s: string) -> string", "The text without blanks at its ends.", "\" arm \".trim()",
     trim},
    {"split", "(s: string, t: string) -> string[]",
     "The parts of s between the places where t stands.", "\"a,b\".split(\",\")", split},
    {"replace", "(s: string, a: string, b: string) -> string",
     "The text with every a replaced by b.", "\"a-b\".replace(\"-\", \"+\")", replace},
    {"startsWith", "(s: string, t: string) -> bool", "Whether s begins with t.",
     "\"armlet\".startsWith(\"arm\")", starts_with},
    {"contains", "(s: string, t: string) -> bool", "Whether t stands somewhere in s.",
     "\"armlet\".contains(\"let\")", contains_text},
    {"equals", "(s: string, t: string) -> bool",
     "Whether two texts are the same; Java's spelling of ==.", "\"a\".equals(\"a\")", equals},
    {"substring", "(s: string, a: int, b: int?) -> string",
     "The characters from a up to but excluding b.", "\"armlet\".substring(0, 3)", substring},
    {"join", "(xs: string[], t: string) -> string", "The texts of a list with t between them.",
     "join([\"a\", \"b\"], \", \")", join},
    {"parseDouble", "(s: string) -> double", "The number that a text says.", "parseDouble(\"2.5\")",
     parse_double},
    {"parseInt", "(s: string) -> int", "The whole number that a text says.", "parseInt(\"42\")",
     parse_int},
    {"codeOf", "(s: string) -> int", "The number (code point) of a character.", "codeOf(\"A\")",
     code_of},
    {"charOf", "(n: int) -> string", "The character with a number (code point).", "charOf(65)",
     char_of},
};

}  // namespace

std::span<const NativeFunction> text_functions() { return kFunctions; }

}  // namespace armlet::bind
