#include "syntax/tokens/lexical_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "armlet/interpreter/unit.hpp"
#include "base/diagnostic/backticks.hpp"
#include "base/quotes.hpp"

namespace armlet::lang {
namespace {

Fix fix(std::string text, std::vector<Edit> edits, Confidence confidence) {
  return {std::move(text), std::move(edits), confidence};
}

std::string trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

// The edit distance: the count of changes of one letter that make `b` from `a`.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, change});
    }
  }
  return row[b.size()];
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

struct Nickname {
  std::string_view said;
  std::string_view unit;
};

constexpr auto kNicknames = std::to_array<Nickname>({
    {"sec", "s"},          {"secs", "s"},        {"second", "s"},       {"seconds", "s"},
    {"msec", "ms"},        {"mins", "min"},      {"minute", "min"},     {"minutes", "min"},
    {"hr", "h"},           {"hour", "h"},        {"hours", "h"},        {"meter", "m"},
    {"meters", "m"},       {"metre", "m"},       {"metres", "m"},       {"millimeter", "mm"},
    {"millimeters", "mm"}, {"centimeter", "cm"}, {"centimeters", "cm"}, {"micron", "um"},
    {"in", "inch"},        {"inches", "inch"},   {"degree", "deg"},     {"degrees", "deg"},
    {"degs", "deg"},       {"radian", "rad"},    {"radians", "rad"},    {"turn", "rev"},
    {"turns", "rev"},      {"kilo", "kg"},       {"gram", "g"},         {"grams", "g"},
    {"newton", "N"},       {"hertz", "Hz"},
});

// Units that differ by one letter or by capitals. For a unit of one letter these would be too many,
// so a product of units is proposed.
std::vector<std::string> units_near(std::string_view word) {
  std::vector<std::string> near;
  const auto nickname = std::ranges::find(kNicknames, word, &Nickname::said);
  if (nickname != kNicknames.end()) return {std::string(nickname->unit)};
  for (const Unit& unit : all_units()) {
    const bool one_letter =
        word.size() >= 2 && word.size() < 6 && edit_distance(word, unit.name) == 1;
    if (one_letter || lower_case(word) == lower_case(unit.name)) near.emplace_back(unit.name);
  }
  std::ranges::sort(near);
  return near;
}

struct UnitFamily {
  std::string_view unit;
  std::string_view sentence;
};

// The units that a message proposes, by one member of each family.
constexpr auto kFamilies = std::to_array<UnitFamily>({
    {"m", "lengths can be in um, mm, cm, m, km or inch"},
    {"rad", "angles can be in deg, rad, mrad or rev"},
    {"s", "times can be in us, ms, s, min or h"},
    {"kg", "masses can be in g or kg"},
    {"N", "forces can be in mN, N or kN"},
    {"Hz", "frequencies can be in Hz or kHz"},
    {"Pa", "pressures can be in Pa, kPa, MPa or bar"},
});

std::string_view family_sentence(std::string_view unit_name) {
  const Unit* unit = unit_named(unit_name);
  for (const UnitFamily& family : kFamilies) {
    const Unit* member = unit_named(family.unit);
    if (unit != nullptr && member != nullptr && member->dim == unit->dim) return family.sentence;
  }
  return {};
}

struct Replacement {
  std::string_view found;
  std::string_view meant;
  std::string_view advice;
};

constexpr auto kReplacements = std::to_array<Replacement>({
    {"#", "//", "a comment starts with //"},
    {"\u00D7", "*", "write *"},
    {"\u00B7", "*", "write *"},
    {"\u00F7", "/", "write /"},
    {"\u2212", "-", "write -"},
    {"\u2013", "-", "write -"},
    {"\u2264", "<=", "write <="},
    {"\u2265", ">=", "write >="},
    {"\u2260", "!=", "write !="},
    {"\u00B2", "^2", "write ^2"},
    {"\u00B3", "^3", "write ^3"},
});

constexpr std::array<std::string_view, 8> kWordProcessorQuotes = {
    "\u201C", "\u201D", "\u201E", "\u00AB", "\u00BB", "\u2018", "\u2019", "\u201A"};

bool is_word_processor_quote(std::string_view text) {
  return std::ranges::find(kWordProcessorQuotes, text) != kWordProcessorQuotes.end();
}

// A quote of a word processor; the span contains the text up to a second such quote, if one follows
// on the line.
Diagnostic word_processor_quote(const Source& source, Span opening) {
  const std::string_view text = source.text();
  std::size_t end = text.find('\n', opening.begin);
  if (end == std::string_view::npos) end = text.size();
  Span inner{opening.end, opening.end, opening.source};
  std::size_t close = 0;
  for (std::size_t at = opening.end; at < end && close == 0; ++at) {
    for (const std::string_view quote : kWordProcessorQuotes) {
      if (text.substr(at).starts_with(quote)) {
        inner.end = static_cast<std::uint32_t>(at);
        close = at + quote.size();
      }
    }
  }
  Diagnostic out = make_diagnostic("E0104", opening, {std::string(source.slice(opening))});
  out.why = "texts stand between plain quotes, \" or '";
  if (close != 0) {
    out.mark.span.end = static_cast<std::uint32_t>(close);
    const std::string plain = '"' + std::string(source.slice(inner)) + '"';
    out.fix = fix("write " + plain, {{out.mark.span, plain}}, Confidence::kSure);
  }
  return out;
}

// Whether the text ends with a value: a name, a number or a closing bracket.
bool ends_value(std::string_view before) {
  if (before.empty()) return false;
  const char last = before.back();
  return last == ')' || last == ']' || last == '_' ||
         std::isalnum(static_cast<unsigned char>(last)) != 0;
}

// The form in this language for numbers such as 4.sqrt() and 0xFFL; empty for other words.
std::string other_number(std::string_view digits, std::string_view word, std::string_view behind) {
  const std::size_t last = word.find_last_not_of("lLuU");
  const bool is_hexadecimal =
      digits == "0" && word.size() > 2 && (word[0] == 'x' || word[0] == 'X') && last > 0 &&
      word.substr(1, last).find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  if (is_hexadecimal) return std::string(digits) + std::string(word.substr(0, last + 1));
  if (!digits.ends_with('.') || !behind.starts_with("()")) return {};
  return std::string(word) + '(' + std::string(digits.substr(0, digits.size() - 1)) + ')';
}

}  // namespace

namespace {

constexpr std::string_view kLinesBetween =
    "a text over several lines stands between \"\"\" and \"\"\"";

// """ without another """: the text contains the rest of the program.
Diagnostic unclosed_lines(const Source& source, Span text) {
  const std::string_view body = source.slice(text);
  const auto opening = static_cast<std::uint32_t>(quotes_of(body).opening);
  Diagnostic out = make_diagnostic("E0101", {text.begin, text.begin + opening, text.source});
  out.mark.label = "the text opens here";
  out.why = kLinesBetween;
  const std::string_view line = body.substr(0, body.find_first_of("\r\n"));
  std::size_t keep = line.find_last_not_of(" \t);,]\"");
  keep = keep == std::string_view::npos || keep < opening ? line.size() : keep + 1;
  if (keep <= opening) {
    out.fix = Fix{"end it with \"\"\" behind its last line", {}, {}};
    return out;
  }
  std::size_t behind = keep;  // one or two quotes at its end were meant as the closing ones
  while (behind < line.size() && line[behind] == '"') ++behind;
  const Span written{text.begin + static_cast<std::uint32_t>(keep),
                     text.begin + static_cast<std::uint32_t>(behind), text.source};
  out.fix =
      fix(fmt::format("if it ends on this line, write {}{}", line.substr(0, keep), kThreeQuotes),
          {{written, std::string(kThreeQuotes)}}, Confidence::kMaybe);
  return out;
}

// Whether the text begins at the last of three single quotes.
bool is_third_quote(const Source& source, Span text) {
  return source.text().substr(0, text.begin).ends_with("''");
}

}  // namespace

Diagnostic unclosed_text(const Source& source, Span text) {
  if (quotes_of(source.slice(text)).spans_lines) return unclosed_lines(source, text);
  Diagnostic out = make_diagnostic("E0101", text);
  out.mark.label = "the quote opens here";
  const std::string_view body = source.slice(text);
  const char quote = body.find('"') <= 1 ? '"' : '\'';
  if (quote == '\'' && is_third_quote(source, text)) {
    const Span mark{text.begin - 2, text.begin + 1, text.source};
    out.why = kLinesBetween;
    out.fix =
        fix("write \"\"\" for \'\'\'", {{mark, std::string(kThreeQuotes)}}, Confidence::kMaybe);
    return out;
  }
  if (quote == '\'' && ends_value(source.text().substr(0, text.begin))) {
    const Span mark{text.begin, text.begin + 1, text.source};
    out.why = "a quote opens a text; it does not transpose a matrix";
    out.fix = fix("write .T for the transpose", {{mark, ".T"}}, Confidence::kMaybe);
    return out;
  }
  std::size_t keep = body.find_last_not_of(" \t\r);,]");
  keep = keep == std::string_view::npos || keep == 0 ? body.size() : keep + 1;
  const Position at = source.position(text.begin);
  const std::uint32_t place = text.begin + static_cast<std::uint32_t>(keep);
  const std::uint32_t start = source.line_start(at.line);
  const std::string before(source.slice({start, place, text.source}));
  const std::string after(body.substr(keep));
  out.fix = fix("add a closing quote: " + trimmed(before + quote + after),
                {{{place, place, text.source}, std::string(1, quote)}}, Confidence::kMaybe);
  return out;
}

Diagnostic unclosed_comment(const Source& source, Span opening) {
  Diagnostic out = make_diagnostic("E0106", opening);
  out.mark.label = "opened here";
  const Span slash_and_star{opening.begin, opening.begin + 2, opening.source};
  out.fix = Fix{"end it with */, or write // for a comment that ends with its line", {}, {}};
  if (source.slice(slash_and_star) == "/*") out.fix->edits.push_back({slash_and_star, "//"});
  return out;
}

Diagnostic bad_number(const Source& source, Span number) {
  const std::string text(source.slice(number));
  Diagnostic out = make_diagnostic("E0103", number, {text});
  std::size_t letters = text.find_first_not_of("0123456789._");
  // 1e5x: the exponent is part of the number.
  if (letters != std::string::npos && letters + 1 < text.size() &&
      std::tolower(static_cast<unsigned char>(text[letters])) == 'e' &&
      std::isdigit(static_cast<unsigned char>(text[letters + 1])) != 0) {
    letters = text.find_first_not_of("0123456789", letters + 1);
  }
  const std::string digits = text.substr(0, letters);
  const std::string word = letters == std::string::npos ? "" : text.substr(letters);
  if (word.empty()) {
    std::string bare = digits;
    std::erase(bare, '_');
    out.why = "`_` stands between two digits";
    out.fix = fix("write " + bare, {{number, bare}}, Confidence::kSure);
    return out;
  }
  const std::string_view behind = source.text().substr(number.end);
  if (const std::string better = other_number(digits, word, behind); !better.empty()) {
    const std::uint32_t call = better.ends_with(')') ? 2 : 0;
    const Span all{number.begin, number.end + call, number.source};
    out.fix = fix("write " + better, {{all, better}}, Confidence::kSure);
    return out;
  }
  const std::vector<std::string> near = units_near(word);
  out.why = in_backticks(word) + " is not a unit";
  if (near.empty()) {
    const std::string product = digits + " * " + word;
    out.fix = fix("to multiply, write " + product, {{number, product}}, Confidence::kMaybe);
    return out;
  }
  if (const std::string_view family = family_sentence(near.front()); !family.empty()) {
    out.why += "; " + std::string(family);
  }
  std::string question = "did you mean ";
  for (std::size_t i = 0; i < near.size(); ++i) {
    question += (i == 0 ? "" : i + 1 == near.size() ? " or " : ", ") + digits + near[i];
  }
  out.fix = fix(question + '?', {{number, digits + near.front()}}, Confidence::kMaybe);
  return out;
}

Diagnostic bad_character(const Source& source, Span character) {
  const std::string_view text = source.slice(character);
  if (is_word_processor_quote(text)) return word_processor_quote(source, character);
  if (text == "&" || text == "|") {
    Diagnostic out = make_diagnostic("E0133", character, {std::string(text)});
    const std::string twice = std::string(text) + std::string(text);
    out.fix = fix("write " + twice + (text == "&" ? " for \"and\"" : " for \"or\""),
                  {{character, twice}}, Confidence::kMaybe);
    return out;
  }
  Diagnostic out = make_diagnostic("E0104", character, {std::string(text)});
  const auto found = std::ranges::find(kReplacements, text, &Replacement::found);
  if (found != kReplacements.end()) {
    out.fix = fix(std::string(found->advice), {{character, std::string(found->meant)}},
                  Confidence::kSure);
  }
  return out;
}

}  // namespace armlet::lang
