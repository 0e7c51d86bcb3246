// Text (language reference, section 19). Positions count characters, not bytes.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "armlet/interpreter/output.hpp"
#include "armlet/interpreter/work.hpp"
#include "values/bind.hpp"
#include "values/blocks.hpp"
#include "values/letters.hpp"

namespace armlet::bind {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 13U;  // bytes

Answer<std::int64_t> count_characters(Vm& vm, std::string_view s) {
  std::int64_t count = 0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    count += characters(s.substr(begin, end - begin));
  };
  if (!in_blocks(vm, s.size(), 1, add)) return Failed{};
  return count;
}

template <bool kUpper>
Answer<Obj*> change_case(Vm& vm, std::string_view s) {
  TextMaker out(vm);
  for (std::size_t begin = 0; begin < s.size();) {
    const std::string_view piece = whole_characters(s.substr(begin), kPiece);
    if (!charge_work(vm, kFunctionCost * piece.size()) || !out.add(with_case(piece, kUpper)))
      return Failed{};
    begin += piece.size();
  }
  return out.take();
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

// A text without leading and trailing blanks.
Answer<std::string_view> trimmed(Vm& vm, std::string_view s) {
  std::size_t front = 0;
  std::size_t back = 0;
  const auto count_front = [&](std::size_t begin, std::size_t end) {
    while (begin < end && is_blank(s[begin])) ++begin;
    front = begin;
    return begin == end;
  };
  if (!in_blocks(vm, s.size(), 2, count_front) && (front == s.size() || is_blank(s[front])))
    return Failed{};
  s.remove_prefix(front);
  const auto count_back = [&](std::size_t begin, std::size_t end) {
    while (begin < end && is_blank(s[s.size() - 1 - begin])) ++begin;
    back = begin;
    return begin == end;
  };
  if (!in_blocks(vm, s.size(), 2, count_back) && is_blank(s[s.size() - 1 - back])) return Failed{};
  s.remove_suffix(back);
  return s;
}

Obj* trim(Vm& vm, std::string_view s) {
  const Answer<std::string_view> text = trimmed(vm, s);
  TextMaker out(vm);
  return text && out.add(*text) ? out.take() : nullptr;
}

Answer<Obj*> split(Vm& vm, std::string_view s, std::string_view separator) {
  if (separator.empty())
    return failure(vm, "R0609", "split needs a text to split at, and this one is empty", at("t"));
  ListMaker parts(vm);
  std::size_t begin = 0;
  for (std::size_t at = 0; at != std::string_view::npos; begin = at + separator.size()) {
    if (!find_text(vm, s, separator, begin, at)) return Failed{};
    TextMaker part(vm);
    if (!part.add(s.substr(begin, at - begin)) || !parts.push(part.take())) return Failed{};
    if (at == std::string_view::npos) break;
  }
  return parts.take();
}

Answer<Obj*> replace(Vm& vm, std::string_view s, std::string_view from, std::string_view to) {
  if (from.empty())
    return failure(vm, "R0609", "replace needs a text to look for, and this one is empty", at("a"));
  TextMaker out(vm);
  std::size_t begin = 0;
  while (true) {
    std::size_t at = 0;
    if (!find_text(vm, s, from, begin, at) || !out.add(s.substr(begin, at - begin)))
      return Failed{};
    if (at == std::string_view::npos) return out.take();
    if (!out.add(to)) return Failed{};
    begin = at + from.size();
  }
}

// Whether two texts of the same length are equal.
Answer<bool> same(Vm& vm, std::string_view a, std::string_view b) {
  bool is_same = true;
  const auto compare = [&](std::size_t begin, std::size_t end) {
    is_same = a.substr(begin, end - begin) == b.substr(begin, end - begin);
    return is_same;
  };
  if (!in_blocks(vm, a.size(), 1, compare) && is_same) return Failed{};
  return is_same;
}
Answer<bool> starts_with(Vm& vm, std::string_view s, std::string_view t) {
  if (t.size() > s.size()) return false;
  return same(vm, s.substr(0, t.size()), t);
}
Answer<bool> ends_with(Vm& vm, std::string_view s, std::string_view t) {
  if (t.size() > s.size()) return false;
  return same(vm, s.substr(s.size() - t.size()), t);
}
Answer<std::int64_t> index_of_text(Vm& vm, std::string_view s, std::string_view t) {
  std::size_t at = 0;
  if (!find_text(vm, s, t, 0, at)) return Failed{};
  if (at == std::string_view::npos) return -1;
  return count_characters(vm, s.substr(0, at));
}
Answer<bool> contains_text(Vm& vm, std::string_view s, std::string_view t) {
  std::size_t at = 0;
  if (!find_text(vm, s, t, 0, at)) return Failed{};
  return at != std::string_view::npos;
}
Answer<bool> equals(Vm& vm, std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  return same(vm, a, b);
}

Answer<Obj*> repeat(Vm& vm, std::string_view s, std::int64_t times) {
  if (times < 0)
    return failure(vm, "R0609", fmt::format("a text cannot be repeated {} times", times), at("n"));
  // Short texts are joined first, so that the work is proportional to the result.
  std::string piece(s);
  std::int64_t each = 1;
  for (; !s.empty() && piece.size() < kPiece && each < times; ++each) piece += s;
  TextMaker out(vm);
  for (std::int64_t left = s.empty() ? 0 : times; left > 0; left -= each) {
    const std::int64_t now = std::min(left, each);
    const auto bytes = static_cast<std::size_t>(now) * s.size();
    if (!out.add(std::string_view(piece).substr(0, bytes))) return Failed{};
  }
  return out.take();
}

Answer<Obj*> substring(Vm& vm, Slot text, std::int64_t a, std::optional<std::int64_t> last) {
  std::int64_t count = 0;
  if (!text_length(vm, text, count)) return Failed{};
  const std::int64_t b = last.value_or(count);
  if (a >= 0 && a <= count && b < a) {
    return failure(vm, "R0606", fmt::format("the characters from {} to {} run backwards", a, b));
  }
  if (a < 0 || a > count || b > count) {
    return failure(
        vm, "R0606",
        fmt::format("characters {} to {} are outside a text of {} characters", a, b, count));
  }
  return new_text_part(vm, text, a, b);
}

Answer<Obj*> join(Vm& vm, std::span<const Slot> parts, std::string_view separator) {
  TextMaker out(vm);
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if ((i > 0 && !out.add(separator)) || !out.add(text_value(parts[i]))) return false;
    }
    return true;
  };
  if (!(in_blocks(vm, parts.size(), 16, add))) return Failed{};
  return out.take();
}

// The beginning of a text in quotes, for messages.
std::string in_quotes(std::string_view text) {
  constexpr std::size_t kShown = 60;
  const std::string_view shown = whole_characters(text, kShown);
  return fmt::format("\"{}{}\"", shown, shown.size() < text.size() ? "..." : "");
}

// "2.5x" is not a number: the failure marks where the number ends. `end` points into `whole`; `s`
// is the text without blanks.
Failed not_a_number(Vm& vm, std::string_view whole, std::string_view s, const char* end,
                    std::string_view what) {
  std::string why;
  const auto offset = static_cast<std::size_t>(end - whole.data());
  if (s.empty()) {
    why = "there is nothing to read in it";
  } else if (end == s.data() + s.size()) {
    why = "it ends too early";
  } else {
    std::size_t behind = offset;
    const Answer<std::int64_t> before = count_characters(vm, whole.substr(0, offset));
    if (!before) return Failed{};
    std::string character;
    append_character(character, next_character(whole, behind));
    why = fmt::format("`{}`, character {}, does not belong to {}", character, *before + 1, what);
  }
  return failure(vm, "R0609", fmt::format("{} is not {}", in_quotes(whole), what), at("s"),
                 std::move(why));
}

// The number in a text, after blanks and an optional plus sign before a digit or point.
template <class Number>
Answer<Number> parse_number(Vm& vm, std::string_view whole, std::string_view what,
                            std::string_view limits) {
  constexpr std::size_t kLongest = 10'000;  // reading longer texts would take too long
  const Answer<std::string_view> text = trimmed(vm, whole);
  if (!text) return Failed{};
  std::string_view s = *text;
  if (s.size() > kLongest) {
    return failure(vm, "R0609", fmt::format("{} is not {}", in_quotes(s), what), at("s"),
                   fmt::format("{} bytes are too many for a number", s.size()));
  }
  if (s.size() > 1 && s[0] == '+' && s[1] != '-') s.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), value);
  if (error == std::errc::result_out_of_range && end == s.data() + s.size())
    return failure(vm, "R0610", fmt::format("{} is {}", s, limits), at("s"));
  // The C++ library reads "inf" and "nan", which are not numbers here.
  if (error == std::errc() && !std::isfinite(static_cast<double>(value)))
    return not_a_number(vm, whole, *text, s.data() + (s[0] == '-' ? 1 : 0), what);
  if (error != std::errc() || end != s.data() + s.size())
    return not_a_number(vm, whole, *text, end, what);
  return value;
}
Answer<double> parse_double(Vm& vm, std::string_view s) {
  return parse_number<double>(vm, s, "a number", "too large or too small for a double");
}
Answer<std::int64_t> parse_int(Vm& vm, std::string_view s) {
  return parse_number<std::int64_t>(vm, s, "a whole number", "too large for an int");
}

Answer<std::int64_t> code_of(Vm& vm, std::string_view s) {
  const Answer<std::int64_t> count = count_characters(vm, s);
  if (!count) return Failed{};
  if (*count != 1)
    return failure(vm, "R0613",
                   fmt::format("codeOf needs one character, and this text has {}", *count),
                   at("s"));
  std::size_t at = 0;
  return static_cast<std::int64_t>(next_character(s, at));
}
Answer<std::string> char_of(Vm& vm, std::int64_t n) {
  if (n < 0 || n > 0x10FFFF || (n >= 0xD800 && n <= 0xDFFF))
    return failure(vm, "R0609", fmt::format("there is no character number {}", n), at("n"));
  std::string out;
  append_character(out, static_cast<char32_t>(n));
  return out;
}

constexpr NativeFunction kTextFunctions[] = {
    def<change_case<true>>("upper(s: string) -> string", "The text in capital letters.",
                           "\"arm\".upper()"),
    def<change_case<false>>("lower(s: string) -> string", "The text in small letters.",
                            "\"ARM\".lower()"),
    def<trim>("trim(s: string) -> string", "The text without blanks at its ends.",
              "\" arm \".trim()"),
    def<split>("split(s: string, t: string) -> string[]",
               "The parts of s between the places where t stands.", "\"a,b\".split(\",\")"),
    def<replace>("replace(s: string, a: string, b: string) -> string",
                 "The text with every a replaced by b.", "\"a-b\".replace(\"-\", \"+\")"),
    def<starts_with>("startsWith(s: string, t: string) -> bool", "Whether s begins with t.",
                     "\"armlet\".startsWith(\"arm\")"),
    def<ends_with>("endsWith(s: string, t: string) -> bool", "Whether s ends with t.",
                   "\"armlet\".endsWith(\"let\")"),
    def<index_of_text>("indexOf(s: string, t: string) -> int",
                       "At which character t begins for the first time; -1 if it does not.",
                       "\"armlet\".indexOf(\"let\")"),
    def<contains_text>("contains(s: string, t: string) -> bool", "Whether t stands somewhere in s.",
                       "\"armlet\".contains(\"let\")"),
    def<equals>("equals(s: string, t: string) -> bool",
                "Whether two texts are the same; Java's spelling of ==.", "\"a\".equals(\"a\")"),
    def<substring>("substring(s: string, a: int, b: int?) -> string",
                   "The characters from a up to but excluding b.", "\"armlet\".substring(0, 3)"),
    def<repeat>("repeat(s: string, n: int) -> string", "The text n times, one behind the other.",
                "\"ab\".repeat(3)"),
    def<join>("join(xs: string[], t: string) -> string", "The texts of a list with t between them.",
              "join([\"a\", \"b\"], \", \")"),
    def<parse_double>("parseDouble(s: string) -> double", "The number that a text says.",
                      "parseDouble(\"2.5\")"),
    def<parse_int>("parseInt(s: string) -> int", "The whole number that a text says.",
                   "parseInt(\"42\")"),
    def<code_of>("codeOf(s: string) -> int", "The number (code point) of a character.",
                 "codeOf(\"A\")"),
    def<char_of>("charOf(n: int) -> string", "The character with a number (code point).",
                 "charOf(65)"),
};

}  // namespace

std::span<const NativeFunction> text_functions() { return kTextFunctions; }

}  // namespace armlet::bind
