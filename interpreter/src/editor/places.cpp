#include "editor/places.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <set>
#include <utility>

#include "armlet/interpreter/unit.hpp"
#include "base/quotes.hpp"
#include "syntax/tokens/signs.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

// Products of units that are in common use.
constexpr std::string_view kCombined[] = {"mm/s",   "m/s",    "cm/s",    "mm/s^2",  "m/s^2",
                                          "deg/s",  "rad/s",  "deg/s^2", "rad/s^2", "N/m",
                                          "Nm/rad", "kg*m^2", "kg/m^3"};

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
}

class PlaceItems {
 public:
  PlaceItems(const Facts& facts, const Cursor& cursor)
      : facts_(facts), tokens_(facts.tokens), cursor_(cursor) {}

  std::optional<std::vector<Completion>> items() {
    if (cursor_.number) return add_units(), std::move(items_);
    if (cursor_.format) return add_format(), std::move(items_);
    if (cursor_.quoted || cursor_.point || cursor_.in_braces) return std::nullopt;
    if (is_type_place(facts_, cursor_.before)) return add_types(), std::move(items_);
    if (const auto word = case_word()) {
      add_cases(*word);
      if (!items_.empty()) return std::move(items_);
    }
    return std::nullopt;
  }

  std::vector<Completion> texts() {
    const std::size_t at = cursor_.before;
    if (at == 0) return {};
    if (text(at - 1) == "import") add_files();
    if (text(at - 1) == "[" && at > 1 && is_name(tokens_[at - 2].type)) add_keys(text(at - 2));
    const bool asks_kind = cursor_.call && cursor_.call->setting == "kind";
    if (asks_kind || is_kind_place(facts_, at)) add_kinds();
    return std::move(items_);
  }

 private:
  void add(std::string_view item, NameKind kind, std::string detail = {}) {
    if (!item.empty() && met_.insert(std::string(item)).second)
      items_.push_back({std::string(item), kind, std::move(detail)});
  }
  [[nodiscard]] std::string_view text(std::size_t token) const {
    return token < tokens_.size() ? facts_.text_of(tokens_[token]) : std::string_view();
  }

  // ---- units
  void add_units() {
    const std::string_view number = facts_.text_of(*cursor_.number);
    const std::size_t begin = unit_begin(number);
    const std::size_t at = cursor_.at - cursor_.number->begin;
    if (number.starts_with("0x") || number.starts_with("0X") || at < begin) return;
    const std::size_t word = cursor_.word.begin - cursor_.number->begin;
    if (number.substr(word, at - word).find('^') != std::string_view::npos) return;
    for (const std::string_view unit : units_of(std::nullopt)) {
      if (word == begin || unit.find_first_of("*/^") == std::string_view::npos)
        add(unit, NameKind::kWord, dimension_name(parse_unit(unit)->dim));
    }
  }

  // f"{x:.1f |}": adds only units with the dimension of the value.
  void add_format() {
    const std::string_view whole = facts_.main().text();
    const std::string_view before =
        whole.substr(cursor_.format->end + 1, cursor_.word.begin - cursor_.format->end - 1);
    const std::size_t last = before.find_last_not_of(" \t");
    const bool begins = last == std::string_view::npos || last + 1 < before.size();
    const std::size_t blank = before.find_last_of(" \t");
    const std::string_view written = before.substr(blank == std::string_view::npos ? 0 : blank + 1);
    const bool goes_on = !written.empty() && (written.back() == '/' || written.back() == '*');
    const std::string_view word = whole.substr(cursor_.word.begin, cursor_.at - cursor_.word.begin);
    if ((!begins && !goes_on) || (!word.empty() && is_digit(word.front()))) return;
    std::optional<Dim> dim = dim_of(*cursor_.format);
    for (const std::string_view unit : units_of(dim)) {
      if (!goes_on) add(unit, NameKind::kWord, dimension_name(parse_unit(unit)->dim));
      if (goes_on && unit.starts_with(written))
        add(unit.substr(written.size()), NameKind::kWord, std::string(unit));
    }
  }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  // The dimension of the numbers of a value in the text; empty if the type is not known.
  [[nodiscard]] std::optional<Dim> dim_of(Span value) const {
    const Type* type = type_of(value);
    while (type != nullptr && (type->is(Kind::kList) || type->is(Kind::kMap))) type = type->element;
    if (type == nullptr || !type->is_number()) return std::nullopt;
    return type->dim;
  }

  [[nodiscard]] const Type* type_of(Span value) const {
    const std::string_view whole = facts_.main().text();
    while (value.begin < value.end && whole[value.begin] == ' ') ++value.begin;
    while (value.end > value.begin && whole[value.end - 1] == ' ') --value.end;
    for (const TypedSpan& each : facts_.values.spans) {
      if (each.span.begin == value.begin && each.span.end == value.end && each.type != nullptr &&
          !each.type->is(Kind::kAny))
        return each.type;
    }
    const Symbol* symbol =
        facts_.visible_at(cursor_.at, whole.substr(value.begin, value.end - value.begin));
    return symbol != nullptr ? symbol->type : nullptr;
  }

  // ---- types
  void add_types() {
    const bool is_result = cursor_.before > 0 && text(cursor_.before - 1) == "->";
    for (const Word& word : kWordRows) {
      if (word.kind == WordKind::kType || (is_result && word.text == "void"))
        add(word.text, NameKind::kType);
    }
    for (const Symbol* symbol : facts_.visible_at(cursor_.at)) {
      if (symbol->kind == NameKind::kStruct || symbol->kind == NameKind::kEnum ||
          symbol->kind == NameKind::kModule)
        add(symbol->name, symbol->kind, std::string(symbol->header));
    }
    for (const std::string_view name : dimension_names())
      if (name.find('/') == std::string_view::npos) add(name, NameKind::kType);
    for (const char* name : {"string", "matrix"}) add(name, NameKind::kType);
    for (const auto& [name, type] : facts_.registry->types()) add(name, NameKind::kType);
    for (const auto& [name, fields] : facts_.registry->records())
      add(name, NameKind::kType, fields);
    const std::string_view before = cursor_.before > 0 ? text(cursor_.before - 1) : "";
    if (before == ":" || before == "->") add("fn", NameKind::kWord);
  }

  // ---- cases
  // The token `case` whose list of values contains the position.
  [[nodiscard]] std::optional<std::size_t> case_word() const {
    std::size_t depth = 0;
    for (std::size_t i = cursor_.before; i-- > 0;) {
      if (is_closer(tokens_[i].type)) ++depth;
      if (is_opener(tokens_[i].type) && depth-- == 0) return std::nullopt;
      if (depth > 0) continue;
      const std::string_view word = text(i);
      if (word == "case") {
        const bool begins = i + 1 == cursor_.before || text(cursor_.before - 1) == ",";
        return begins ? std::optional(i) : std::nullopt;
      }
      if (word == ":" || word == ";" || tokens_[i].line_break_before) return std::nullopt;
    }
    return std::nullopt;
  }

  // The first and the last token of the value of a `switch`, found from the token of one of its
  // cases.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> subject(std::size_t word) const {
    std::size_t depth = 0;
    std::size_t i = word;
    while (i > 0 && (depth > 0 || tokens_[i - 1].type != sign::kOpenBrace)) {
      --i;
      if (is_closer(tokens_[i].type)) ++depth;
      if (is_opener(tokens_[i].type) && depth > 0) --depth;
    }
    if (i < 2 || text(i - 2) != ")") return std::nullopt;
    const std::size_t last = i - 2;
    for (depth = 0, i = last; i-- > 0;) {
      if (is_closer(tokens_[i].type)) ++depth;
      if (!is_opener(tokens_[i].type) || depth-- > 0) continue;
      if (i == 0 || text(i - 1) != "switch" || i + 1 == last) return std::nullopt;
      return std::pair(i + 1, last);
    }
    return std::nullopt;
  }

  void add_cases(std::size_t word) {
    const auto about = subject(word);
    if (!about) return;
    const auto [first, end] = *about;
    if (end - first >= 3 && text(end - 1) == "kind" && text(end - 2) == ".") {
      for (const std::string& kind : kinds())
        add('"' + kind + '"', NameKind::kText, "an error of this kind");
      return;
    }
    const Type* type = type_of({tokens_[first].begin, tokens_[end - 1].end, facts_.main_source()});
    if (type == nullptr) return;
    if (type->is(Kind::kEnum)) {
      for (const std::string& value : type->enumeration->values)
        add(type_name(type) + '.' + value, NameKind::kEnumValue, type_name(type));
    }
    for (const Symbol* symbol : facts_.visible_at(cursor_.at)) {
      const bool is_constant = facts_.learnt.constant_at(symbol->declared) != nullptr;
      if (is_constant && symbol->type == type) add(symbol->name, symbol->kind, type_name(type));
    }
  }

  // ---- texts
  // The kinds of errors of the language and the library, and those that the program raises.
  [[nodiscard]] std::vector<std::string> kinds() const {
    std::vector<std::string> out;
    std::set<std::string, std::less<>> met;
    const auto put = [&](std::string_view kind) {
      if (!kind.empty() && met.emplace(kind).second) out.emplace_back(kind);
    };
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
      const bool is_one = text(i) == "kind" && text(i + 1) == ":" &&
                          tokens_[i + 2].type == sign::kText && &tokens_[i + 2] != quoted_token();
      if (is_one) put(inside(i + 2));
    }
    std::set<std::string_view> own;
    for (const CatalogEntry* entry : facts_.registry->messages().all())
      if (entry->code.starts_with('R')) own.insert(entry->kind);
    for (const std::string_view kind : own) put(kind);
    return out;
  }
  void add_kinds() {
    for (const std::string& kind : kinds()) add(kind, NameKind::kText, "an error of this kind");
  }
  [[nodiscard]] const Token* quoted_token() const {
    return cursor_.quoted && cursor_.before < tokens_.size() ? &tokens_[cursor_.before] : nullptr;
  }
  // The text of a literal without its quotes.
  [[nodiscard]] std::string_view inside(std::size_t token) const {
    return inside_quotes(text(token));
  }

  // Adds the keys that the program uses with the map of that name.
  void add_keys(std::string_view map) {
    for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
      if (text(i) != map || !is_name(tokens_[i].type)) continue;
      const bool is_asked = &tokens_[i + 2] == quoted_token();
      if (text(i + 1) == "[" && tokens_[i + 2].type == sign::kText && !is_asked)
        add(inside(i + 2), NameKind::kText, "a key of " + std::string(map));
      for (std::size_t k = i + 1; k < std::min(i + 6, tokens_.size()); ++k) {
        if (text(k) == "=") add_keys_of_literal(k + 1, map);
        if (text(k) == "=" || tokens_[k].line_break_before) break;
      }
    }
  }
  void add_keys_of_literal(std::size_t opener, std::string_view map) {
    if (opener >= tokens_.size() || tokens_[opener].type != sign::kOpenBrace) return;
    std::size_t depth = 0;
    for (std::size_t i = opener; i + 1 < tokens_.size(); ++i) {
      if (is_opener(tokens_[i].type)) ++depth;
      if (is_closer(tokens_[i].type) && --depth == 0) return;
      if (depth == 1 && tokens_[i].type == sign::kText && text(i + 1) == ":")
        add(inside(i), NameKind::kText, "a key of " + std::string(map));
    }
  }

  // Adds files that can be imported: the host lists them for a file that does not exist.
  void add_files() {
    if (!facts_.options.load) return;
    const std::string_view written =
        facts_.main().text().substr(cursor_.word.begin, cursor_.at - cursor_.word.begin);
    const std::string folder(written.substr(0, written.find_last_of('/') + 1));
    try {
      for (const std::string& other :
           facts_.options.load(folder + ".rbt", facts_.main().name()).others)
        if (other != facts_.main().name()) add(other, NameKind::kText, "a program");
    } catch (const std::exception&) {
      return;  // the host has no list of files
    }
  }

  const Facts& facts_;
  const Tokens& tokens_;
  const Cursor& cursor_;
  std::vector<Completion> items_;
  std::set<std::string, std::less<>> met_;
};

// Whether a name before a colon, token `name`, is in a header or a struct, where the colon begins a
// type.
bool is_declared_in(const Facts& facts, std::size_t name) {
  const Tokens& tokens = facts.tokens;
  std::size_t depth = 0;
  for (std::size_t i = name; i-- > 0;) {
    if (is_closer(tokens[i].type)) ++depth;
    if (!is_opener(tokens[i].type)) continue;
    if (depth > 0) {
      --depth;
      continue;
    }
    const auto word = [&](std::size_t back) {
      return i >= back ? facts.text_of(tokens[i - back]) : std::string_view();
    };
    if (tokens[i].type == sign::kOpenParenthesis) return word(1) == "fn" || word(2) == "fn";
    return tokens[i].type == sign::kOpenBrace && word(2) == "struct";
  }
  return false;
}

}  // namespace

std::size_t unit_begin(std::string_view number) {
  const auto is_digit = [&](std::size_t i) {
    return i < number.size() && ((number[i] >= '0' && number[i] <= '9') || number[i] == '_');
  };
  std::size_t at = 0;
  while (is_digit(at) || (at < number.size() && number[at] == '.')) ++at;
  if (at >= number.size() || (number[at] != 'e' && number[at] != 'E')) return at;
  std::size_t exponent = at + 1;
  if (exponent < number.size() && (number[exponent] == '+' || number[exponent] == '-')) ++exponent;
  if (!is_digit(exponent)) return at;
  while (is_digit(exponent)) ++exponent;
  return exponent;
}

std::vector<std::string_view> units_of(std::optional<Dim> dim) {
  std::vector<std::string_view> out;
  const auto fits = [&](Dim of) {
    return !dim || of == *dim || (!dim->is_none() && of.without_angle() == *dim);
  };
  for (const Unit& unit : all_units())
    if (fits(unit.dim) && is_ascii(unit.name)) out.push_back(unit.name);
  for (const std::string_view name : kCombined) {
    const auto unit = parse_unit(name);
    if (unit && fits(unit->dim)) out.push_back(name);
  }
  return out;
}

bool is_type_place(const Facts& facts, std::size_t token) {
  const Tokens& tokens = facts.tokens;
  const auto text = [&](std::size_t i) { return facts.text_of(tokens[i]); };
  // A product of units or dimensions: force/|
  while (token >= 2 && (text(token - 1) == "/" || text(token - 1) == "*") &&
         is_name(tokens[token - 2].type))
    token -= 2;
  if (token == 0 || token > tokens.size()) return false;
  const std::string_view before = text(token - 1);
  if (before == "->" || before == "new" || before == "final") return true;
  if (before != ":" || token < 3 || !is_name(tokens[token - 2].type)) return false;
  const std::string_view word = text(token - 3);
  if (word == "let" || word == "var") return true;
  const bool begins = word == "(" || word == "," || word == "{" || word == ";" ||
                      tokens[token - 2].line_break_before;
  return begins && is_declared_in(facts, token - 2);
}

bool is_value_place(const Facts& facts, const Cursor& cursor) {
  if (cursor.in_braces) return true;
  if (cursor.before == 0 || cursor.before > facts.tokens.size()) return false;
  const Token& before = facts.tokens[cursor.before - 1];
  const std::string_view sign = facts.text_of(before);
  if (cursor.call && cursor.call->kind != OpenCall::Kind::kPath &&
      cursor.call->kind != OpenCall::Kind::kBlock && (sign == "(" || sign == ","))
    return true;
  constexpr std::string_view kSigns[] = {"=",  "+",  "-",  "*",  "/",  "%",      "^",     "<",
                                         ">",  "<=", ">=", "==", "!=", "&&",     "||",    "!",
                                         "+=", "-=", "*=", "/=", "=>", "return", "throw", "in"};
  return std::ranges::find(kSigns, sign) != std::end(kSigns) ||
         (sign == ":" && cursor.call && !cursor.call->setting.empty());
}

bool is_kind_place(const Facts& facts, std::size_t token) {
  const Tokens& tokens = facts.tokens;
  const auto text = [&](std::size_t i) { return facts.text_of(tokens[i]); };
  if (token < 1 || token > tokens.size()) return false;
  const std::string_view before = text(token - 1);
  if (before == "==" || before == "!=")
    return token >= 4 && text(token - 2) == "kind" && text(token - 3) == ".";
  if (before != "case" && before != ",") return false;
  // A case of a switch: switch (e.kind) { case |
  std::size_t depth = 0;
  for (std::size_t i = token; i-- > 0;) {
    if (is_closer(tokens[i].type)) ++depth;
    if (is_opener(tokens[i].type) && depth-- == 0) {
      return tokens[i].type == sign::kOpenBrace && i >= 5 && text(i - 1) == ")" &&
             text(i - 2) == "kind" && text(i - 3) == ".";
    }
  }
  return false;
}

std::optional<std::vector<Completion>> items_of_place(const Facts& facts, const Cursor& cursor) {
  return PlaceItems(facts, cursor).items();
}

std::vector<Completion> texts_of_place(const Facts& facts, const Cursor& cursor) {
  return PlaceItems(facts, cursor).texts();
}

}  // namespace armlet::lang
