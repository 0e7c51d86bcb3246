// Text (language reference, section 19). Positions count characters, not bytes.

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "bind.hpp"
#include "letters.hpp"

namespace armlet::bind {
namespace {

template <bool kUpper>
Signal change_case(Vm& vm, Slot* args) {
  return give(args, new_text(vm, with_case(text_value(args[0]), kUpper)));
}

constexpr std::string_view kBlanks = " \t\r\n";

// Without blanks at its ends; of nothing else nothing is left.
std::string_view trimmed(std::string_view s) {
  const std::size_t first = s.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return s.substr(first, s.find_last_not_of(kBlanks) - first + 1);
}

Signal trim(Vm& vm, Slot* args) { return give(args, new_text(vm, trimmed(text_value(args[0])))); }

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
Signal ends_with(Vm&, Slot* args) {
  return give(args, text_value(args[0]).ends_with(text_value(args[1])));
}
Signal index_of_text(Vm&, Slot* args) {
  const std::string_view s = text_value(args[0]);
  const std::size_t at = s.find(text_value(args[1]));
  return give(args, at == std::string_view::npos ? std::int64_t{-1} : characters(s.substr(0, at)));
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
  if (begin != std::string_view::npos && b < a) {
    return failure(vm, "R0606", fmt::format("the characters from {} to {} run backwards", a, b));
  }
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
    if (out.size() > vm.options().limits.heap_bytes) break;  // new_text reports the limit
  }
  return give(args, new_text(vm, out));
}

// "2.5x" is not a number, with the place where it stops being one. `end` points into `whole`.
Signal not_a_number(Vm& vm, std::string_view whole, const char* end, std::string_view what) {
  const std::string_view s = trimmed(whole);
  std::string why;
  const auto at = static_cast<std::size_t>(end - whole.data());
  if (s.empty()) {
    why = "there is nothing to read in it";
  } else if (end == s.data() + s.size()) {
    why = "it ends too early";
  } else {
    std::size_t behind = at;
    std::string character;
    append_character(character, next_character(whole, behind));
    why = fmt::format("`{}`, character {}, does not belong to {}", character,
                      characters(whole.substr(0, at)) + 1, what);
  }
  return failure(vm, "R0609", fmt::format("\"{}\" is not {}", whole, what), 0, std::move(why));
}

// The text without blanks and without a plus sign in front of a digit or point.
std::string_view number_in(std::string_view whole) {
  std::string_view s = trimmed(whole);
  if (s.size() > 1 && s[0] == '+' && s[1] != '-') s.remove_prefix(1);
  return s;
}

Signal parse_double(Vm& vm, Slot* args) {
  const std::string_view whole = text_value(args[0]);
  const std::string_view s = number_in(whole);
  double value = 0.0;
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), value);
  if (error == std::errc::result_out_of_range && end == s.data() + s.size())
    return failure(vm, "R0610", fmt::format("{} is too large or too small for a double", s), 0);
  // "inf" and "nan" are read by the C++ library, but are no numbers here.
  if (error == std::errc() && !std::isfinite(value))
    return not_a_number(vm, whole, s.data() + (s[0] == '-' ? 1 : 0), "a number");
  if (error != std::errc() || end != s.data() + s.size())
    return not_a_number(vm, whole, end, "a number");
  return give(args, value);
}
Signal parse_int(Vm& vm, Slot* args) {
  const std::string_view whole = text_value(args[0]);
  const std::string_view s = number_in(whole);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), value);
  if (error == std::errc::result_out_of_range && end == s.data() + s.size())
    return failure(vm, "R0610", fmt::format("{} is too large for an int", s), 0);
  if (error != std::errc() || end != s.data() + s.size())
    return not_a_number(vm, whole, end, "a whole number");
  return give(args, value);
}

Signal code_of(Vm& vm, Slot* args) {
  const std::string_view s = text_value(args[0]);
  if (characters(s) != 1)
    return failure(vm, "R0613",
                   fmt::format("codeOf needs one character, and this text has {}", characters(s)),
                   0);
  std::size_t at = 0;
  return give(args, static_cast<std::int64_t>(next_character(s, at)));
}
Signal char_of(Vm& vm, Slot* args) {
  const std::int64_t n = args[0].i;
  if (n < 0 || n > 0x10FFFF || (n >= 0xD800 && n <= 0xDFFF))
    return failure(vm, "R0609", fmt::format("there is no character number {}", n), 0);
  std::string out;
  append_character(out, static_cast<char32_t>(n));
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
    {"endsWith", "(s: string, t: string) -> bool", "Whether s ends with t.",
     "\"armlet\".endsWith(\"let\")", ends_with},
    {"indexOf", "(s: string, t: string) -> int",
     "At which character t begins for the first time; -1 if it does not.",
     "\"armlet\".indexOf(\"let\")", index_of_text},
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
