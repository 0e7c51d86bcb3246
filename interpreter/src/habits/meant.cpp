#include "habits/meant.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <span>

#include "habits/formats.hpp"
#include "habits/meant_numbers.hpp"
#include "habits/pieces.hpp"

namespace armlet::lang {
namespace {

using Answer = std::optional<std::string>;

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Whether the first piece is a bracket that the last piece closes.
bool is_in_parentheses(const Line& line) {
  if (line.pieces.empty() || line.piece(0) != "(") return false;
  int depth = 0;
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    if (line.piece(i) == "(") ++depth;
    if (line.piece(i) == ")" && --depth == 0) return i + 1 == line.pieces.size();
  }
  return false;
}

Answer operand(const std::string& part) { return as_factor(part); }

Answer test(const std::string& part) {
  const Line line(part);
  std::string out;
  std::size_t end = 0;
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    out += part.substr(end, line.pieces[i].begin - end);
    out += line.piece(i) == "=" ? "==" : line.piece(i);
    end = line.pieces[i].end;
  }
  if (!is_in_parentheses(line)) return out;
  return out.substr(1, out.size() - 2);
}

Answer truth(const std::string& part) {
  const std::string word = lower_case(part);
  if (word == "1" || word == "true" || word == "on" || word == "high") return "true";
  if (word == "0" || word == "false" || word == "off" || word == "low") return "false";
  return is_plain_number(part) ? std::nullopt : Answer(part);
}

struct Word {
  std::string_view there;
  std::string_view here;
};

constexpr auto kTypes = std::to_array<Word>({
    {"num", "double"},    {"dnum", "double"},        {"real", "double"},    {"float", "double"},
    {"double", "double"}, {"number", "double"},      {"int", "int"},        {"integer", "int"},
    {"long", "int"},      {"short", "int"},          {"byte", "int"},       {"size_t", "int"},
    {"bool", "bool"},     {"boolean", "bool"},       {"str", "string"},     {"string", "string"},
    {"char", "string"},   {"std::string", "string"}, {"robtarget", "posC"}, {"jointtarget", "posJ"},
    {"pos", "posC"},      {"frame", "posC"},         {"e6pos", "posC"},     {"e6axis", "posJ"},
    {"axis", "posJ"},     {"pose", "posC"},
});

Answer type(const std::string& part) {
  const auto found = std::ranges::find(kTypes, lower_case(part), &Word::there);
  return found == kTypes.end() ? std::nullopt : Answer(found->here);
}

// Parameters: num x, x:IN, int n, x = 2
Answer parameters(const std::string& part) {
  std::string out;
  for (const std::string& value : values_of(part)) {
    const Line line(value);
    const std::size_t count = line.pieces.size();
    std::string one = value;
    if (value == "void") continue;
    if (count == 3 && line.piece(1) == ":" && lower_case(std::string(line.piece(2))) == "in") {
      one = line.piece(0);
    } else if (count == 2 || (count == 3 && lower_case(std::string(line.piece(0))) == "inout")) {
      const Answer known = type(std::string(line.piece(count - 2)));
      if (!known) return std::nullopt;
      one = std::string(line.piece(count - 1)) + ": " + *known;
    } else if (count == 3 && line.piece(1) == ":") {
      const Answer known = type(std::string(line.piece(2)));
      if (!known) return std::nullopt;
      one = std::string(line.piece(0)) + ": " + *known;
    }
    out += (out.empty() ? "" : ", ") + one;
  }
  return out;
}

// A speed of RAPID: v100, vmax
Answer speed(const std::string& part) {
  if (part.size() < 2 || (part[0] != 'v' && part[0] != 'V')) return std::nullopt;
  const std::string digits = part.substr(1);
  if (lower_case(digits) == "max") return "";
  const bool is_known = digits.find_first_not_of("0123456789") == std::string::npos;
  return is_known ? Answer(", speed: " + digits + "mm/s") : std::nullopt;
}

struct Setting {
  std::string_view there;
  std::string_view here;  // empty: it has no counterpart
  std::string_view unit;
};

constexpr auto kMoveJ = std::to_array<Setting>({{"t", "time", "s"}, {"r", "", ""}});
constexpr auto kMoveL = std::to_array<Setting>(
    {{"a", "accel", "m/s^2"}, {"v", "speed", "m/s"}, {"t", "time", "s"}, {"r", "", ""}});

// Settings of URScript: a=1.4, v=1.05. If a time is given, only that is used, because the others
// then have no effect.
Answer settings(const std::string& part, std::span<const Setting> known) {
  std::string out, time;
  bool is_known = true;
  for (const std::string& value : values_of(part)) {
    const Line line(value);
    if (line.pieces.size() < 3 || (line.piece(1) != "=" && line.piece(1) != ":"))
      return std::nullopt;
    const auto found = std::ranges::find(known, line.piece(0), &Setting::there);
    is_known = is_known && found != known.end();
    if (found == known.end() || found->here.empty()) continue;
    const std::string given(line.text_of(2, line.pieces.size()));
    const std::string setting =
        ", " + std::string(found->here) + ": " + with_unit(given, std::string(found->unit));
    (found->here == "time" ? time : out) += setting;
  }
  if (!time.empty()) return time;
  return is_known ? Answer(out) : std::nullopt;
}

// The number after a name in `A1 0, A2 -90`; empty if the name is missing.
Answer coordinate(const std::vector<std::string>& values, std::string_view name) {
  for (const std::string& value : values) {
    const Line line(value);
    if (line.pieces.size() < 2 ||
        lower_case(std::string(line.piece(0))) != lower_case(std::string(name)))
      continue;
    return std::string(line.text_of(1, line.pieces.size()));
  }
  return std::nullopt;
}

Answer axes(const std::string& part) {
  const std::vector<std::string> values = values_of(part);
  std::string out;
  for (std::size_t axis = 1; axis <= values.size(); ++axis) {
    const Answer value = coordinate(values, 'A' + std::to_string(axis));
    if (!value) return std::nullopt;
    out += (out.empty() ? "" : ", ") + with_unit(*value, "deg");
  }
  return out.empty() ? std::nullopt : Answer(out);
}

// Angles in degrees without units: 0, -90, 90
Answer degrees(const std::string& part) {
  std::string out;
  for (const std::string& value : values_of(part))
    out += (out.empty() ? "" : ", ") + with_unit(value, "deg");
  return out;
}

// KRL: A, B and C are rotations about z, y and x.
Answer frame(const std::string& part) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kTurns = {
      {{"A", "yaw"}, {"B", "pitch"}, {"C", "roll"}}};
  const std::vector<std::string> values = values_of(part);
  std::string place, turn;
  for (const std::string_view name : {"X", "Y", "Z"}) {
    const Answer value = coordinate(values, name);
    if (!value) return std::nullopt;
    place += (place.empty() ? "" : ", ") + with_unit(*value, "mm");
  }
  bool turns = false;
  for (const auto& [name, setting] : kTurns) {
    const Answer given = coordinate(values, name);
    if (!given) return std::nullopt;  // the tool keeps its orientation
    const std::string& value = *given;
    turns = turns || value.find_first_not_of("0.-") != std::string::npos;
    turn += ", " + std::string(setting) + ": " + with_unit(value, "deg");
  }
  return (turns ? "pose(" : "xyz(") + place + (turns ? turn : "") + ')';
}

// KRL: X 0, Z 50 is a translation; coordinates that are absent are 0.
Answer shift(const std::string& part) {
  const std::vector<std::string> values = values_of(part);
  std::string out;
  for (const std::string_view name : {"X", "Y", "Z"})
    out += (out.empty() ? "" : ", ") + with_unit(coordinate(values, name).value_or("0"), "mm");
  for (const std::string_view name : {"A", "B", "C"}) {
    if (coordinate(values, name).value_or("0") != "0") return std::nullopt;
  }
  return "xyz(" + out + ')';
}

// URScript's rotation vector, such as 0, 3.14, 0: its direction is the axis, its length the angle.
Answer turn(const std::string& part) {
  const std::vector<std::string> values = values_of(part);
  const bool is_zero = std::ranges::all_of(values, [](const std::string& value) {
    return value.find_first_not_of("0.") == std::string::npos;
  });
  if (values.size() != 3) return std::nullopt;
  return is_zero ? "" : " * expPose([0.0, 0.0, 0.0, " + part + "])";
}

// 0.5, 0.1, 0.2 is in metres; 500, 100, 200 in millimetres, since no arm reaches 10 m.
Answer place(const std::string& part) {
  constexpr double kFarthest = 10.0;
  const std::vector<std::string> values = values_of(part);
  const bool is_near = std::ranges::all_of(values, [](const std::string& value) {
    return !is_plain_number(value) || std::abs(std::strtod(value.c_str(), nullptr)) < kFarthest;
  });
  std::string out;
  for (const std::string& value : values)
    out += (out.empty() ? "" : ", ") + with_unit(value, is_near ? "m" : "mm");
  return out;
}

// The first value of a variable of a type, before any assignment.
Answer zero(const std::string& part) {
  const Answer known = type(part);
  if (!known || (*known != "int" && *known != "double" && *known != "bool" && *known != "string"))
    return std::nullopt;
  return *known == "int" ? "0" : *known == "double" ? "0.0" : *known == "bool" ? "false" : "\"\"";
}

// The kind of an error in this language.
Answer kind(const std::string& part) {
  if (part == "KeyError") return "IndexError";
  return part == "ZeroDivisionError" ? "DivideByZero" : part;
}

Answer printed(const std::string& part) { return formatted_text(values_of(part), true); }
Answer as_text(const std::string& part) { return formatted_text(values_of(part), false); }

Answer braces(const std::string& part) { return text_with_braces(values_of(part)); }
Answer inner(const std::string& part) { return part.substr(1, part.size() - 2); }

struct PartConversion {
  std::string_view name;
  Answer (*apply)(const std::string&);
};

constexpr auto kConversions = std::to_array<PartConversion>({
    {"operand", operand},
    {"test", test},
    {"truth", truth},
    {"type", type},
    {"parameters", parameters},
    {"print", printed},
    {"text", as_text},
    {"braces", braces},
    {"inner", inner},
    {"stream", [](const std::string& part) { return streamed_text(part, true); }},
    {"streamed", [](const std::string& part) { return streamed_text(part, false); }},
    {"separated", [](const std::string& part) { return separated_text(values_of(part)); }},
    {"strcat", [](const std::string& part) { return joined_texts(values_of(part)); }},
    {"index", index_from_zero},
    {"counted", counted_range},
    {"stepped", stepped_range},
    {"angle", angle_with_word},
    {"turned", small_angle},
    {"share", share_of_speed},
    {"shift", shift},
    {"zero", zero},
    {"kind", kind},
    {"speed", speed},
    {"axes", axes},
    {"frame", frame},
    {"turn", turn},
    {"degrees", degrees},
    {"place", place},
    {"lower", [](const std::string& part) { return Answer(lower_case(part)); }},
    {"movej", [](const std::string& part) { return settings(part, kMoveJ); }},
    {"movel", [](const std::string& part) { return settings(part, kMoveL); }},
});

Answer converted(const std::string& part, std::string_view conversion) {
  if (conversion.empty()) return part;
  const auto found = std::ranges::find(kConversions, conversion, &PartConversion::name);
  return found == kConversions.end() ? with_unit(part, std::string(conversion))
                                     : found->apply(part);
}

}  // namespace

std::string as_factor(const std::string& part) {
  const Line line(part);
  int depth = 0;
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    const std::string_view piece = line.piece(i);
    if (piece == "(" || piece == "[") ++depth;
    if (piece == ")" || piece == "]") --depth;
    const bool joins = line.pieces[i].kind == Piece::Kind::kMark && piece != "." && piece != ")" &&
                       piece != "]" && depth == 0;
    if (joins) return '(' + part + ')';
  }
  return part;
}

std::string in_a_term(const std::string& value) {
  const Line line(value);
  if (line.pieces.empty()) return value;
  const auto is_operator = [&](std::size_t at) {
    constexpr std::string_view kBrackets = "()[]";
    const std::string_view piece = line.piece(at);
    return line.pieces[at].kind == Piece::Kind::kMark && kBrackets.find(piece) == kBrackets.npos;
  };
  return is_operator(0) || is_operator(line.pieces.size() - 1) ? value : as_factor(value);
}

std::optional<std::string> filled(std::string_view here, const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t at = 0; at < here.size(); ++at) {
    const std::size_t digits = here.find_first_not_of("123456789", at + 1);
    const bool is_place = here[at] == '{' && digits != std::string_view::npos && digits > at + 1 &&
                          (here[digits] == '}' || here[digits] == ':');
    if (!is_place) {
      out += here[at];
      continue;
    }
    std::string part;
    for (std::size_t i = at + 1; i < digits; ++i) {
      const auto number = static_cast<std::size_t>(here[i] - '1');
      if (number >= parts.size()) return std::nullopt;
      part += (i > at + 1 ? ", " : "") + parts[number];
    }
    const std::size_t close = here.find('}', digits);
    const bool converts = here[digits] == ':';
    const Answer meant = converted(
        part, converts ? here.substr(digits + 1, close - digits - 1) : std::string_view());
    if (!meant) return std::nullopt;
    out += *meant;
    at = close;
  }
  return out;
}

}  // namespace armlet::lang
