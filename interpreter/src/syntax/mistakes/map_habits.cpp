// Explains map operations of other languages: `k in m`, `del m[k]`, Map<String, Integer>.

#include <algorithm>
#include <array>

#include "base/foreign_words.hpp"
#include "syntax/mistakes/failure_site.hpp"

namespace armlet::lang {
namespace {

using Answer = std::optional<Diagnostic>;

Diagnostic written_as(Span mark, const std::string& found, const std::string& meant) {
  Diagnostic out = make_diagnostic("E0130", mark, {found, meant});
  out.fix = Fix{"write " + meant, {{mark, meant}}, Confidence::kSure};
  return out;
}

// The last token of a value such as m, m[k] or p.maps that begins at token `first`.
std::size_t value_end(const FailureSite& site, std::size_t first) {
  std::size_t last = is_opener(site.type(first)) ? site.closer(first) : first;
  while (true) {
    const std::uint16_t next = site.type(last + 1);
    if (next == RbtLexer::DOT && is_name(site.type(last + 2))) {
      last += 2;
    } else if (next == RbtLexer::LBRACK || next == RbtLexer::LPAREN) {
      last = site.closer(last + 1);
    } else {
      return last;
    }
  }
}

// Whether the text declares the name as a map: `name = ["a": ...`, `name = [:]`, `name: T[K]`,
// `T[K] name`.
bool is_declared_as_map(const FailureSite& site, std::size_t name) {
  const std::string wanted = site.text(name);
  for (std::size_t i = 1; i < site.statement; ++i) {
    if (!is_name(site.type(i)) || site.text(i) != wanted) continue;
    const bool is_typed =
        site.type(i + 1) == RbtLexer::COLON && site.type(i + 3) == RbtLexer::LBRACK;
    if (is_typed && site.type(i + 4) != RbtLexer::RBRACK) return true;
    if (site.type(i - 1) == RbtLexer::RBRACK && i > 2 && site.type(i - 2) != RbtLexer::LBRACK)
      return true;
    if (site.type(i + 1) != RbtLexer::ASSIGN) continue;
    const bool opens = site.type(i + 2) == RbtLexer::LBRACK || site.type(i + 2) == RbtLexer::LBRACE;
    if (opens && site.type(i + 3) == RbtLexer::COLON) return true;
    if (opens && site.type(value_end(site, i + 3) + 1) == RbtLexer::COLON) return true;
  }
  return false;
}

// Explains the mistake: if ("bolt" in stock), if ("bolt" not in stock)
Answer key_in_map(const FailureSite& site) {
  const bool negated = site.text(site.at) == "not" && site.type(site.at + 1) == RbtLexer::IN;
  const std::size_t in = negated ? site.at + 1 : site.at;
  if (site.type(in) != RbtLexer::IN || site.at <= site.statement + 1) return std::nullopt;
  if (!FailureSite::ends_value(site.before()) || !is_name(site.type(in + 1))) return std::nullopt;
  const std::size_t first = site.value_start(site.at - 1);
  if (first <= site.statement || site.type(first - 1) == RbtLexer::FOR) return std::nullopt;
  std::size_t last = value_end(site, in + 1);
  std::string object = site.text(in + 1, last);
  const bool of_keys = object.ends_with(".keys()");
  if (of_keys) object.resize(object.size() - 7);
  const bool is_map = of_keys || is_declared_as_map(site, in + 1);
  const std::string meant = (negated ? "!" : "") + object + (is_map ? ".has(" : ".contains(") +
                            site.text(first, site.at - 1) + ')';
  Diagnostic out =
      make_diagnostic("E0130", site.span(site.at, in), {site.text(first, last), meant});
  out.why = is_map ? "" : "lists have contains, maps have has";
  const Span whole = site.span(first, last);
  out.fix =
      Fix{"write " + meant, {{whole, meant}}, is_map ? Confidence::kSure : Confidence::kMaybe};
  return out;
}

// Explains the mistake: del stock["bolt"]
Answer deleted_entry(const FailureSite& site) {
  const std::string word = site.text(site.statement);
  const std::size_t first = site.statement + 1;
  if (site.at < first || (word != "del" && word != "delete")) return std::nullopt;
  if (!is_name(site.type(first))) return std::nullopt;
  const std::size_t last = value_end(site, first);
  if (site.type(last) != RbtLexer::RBRACK) return std::nullopt;
  const std::size_t open = site.opener_of(last);
  const std::string meant =
      site.text(first, open - 1) + ".remove(" + site.text(open + 1, last - 1) + ')';
  return written_as(site.span(site.statement, last), site.text(site.statement, last), meant);
}

constexpr std::array<std::string_view, 9> kMapTypes = {
    "Map",  "HashMap", "TreeMap",       "LinkedHashMap",   "Dictionary",
    "Dict", "map",     "unordered_map", "SortedDictionary"};

std::string type_here(const std::string& name) {
  const std::string_view meant = name == "String" ? "string" : type_meant_by(name);
  return meant.empty() ? name : std::string(meant);
}

bool is_type_word(std::uint16_t type) { return is_name(type) || is_primitive_type(type); }

// A type such as HashMap<String, Integer> from token `first` on, with the type of this language for
// it.
struct Generic {
  std::size_t last;
  std::string meant;  // empty: HashMap<>
};
std::optional<Generic> generic_map(const FailureSite& site, std::size_t first) {
  if (std::ranges::find(kMapTypes, site.text(first)) == kMapTypes.end()) return std::nullopt;
  if (site.type(first + 1) != RbtLexer::LT) return std::nullopt;
  if (site.type(first + 2) == RbtLexer::GT) return Generic{first + 2, ""};
  const bool has_types = is_type_word(site.type(first + 2)) &&
                         site.type(first + 3) == RbtLexer::COMMA &&
                         is_type_word(site.type(first + 4)) && site.type(first + 5) == RbtLexer::GT;
  if (!has_types) return std::nullopt;
  return Generic{first + 5,
                 type_here(site.text(first + 4)) + '[' + type_here(site.text(first + 2)) + ']'};
}

// The last token of new HashMap<String, Integer>() or new HashMap(), which begins at token `first`.
std::optional<std::size_t> made_map(const FailureSite& site, std::size_t first) {
  if (site.type(first) != RbtLexer::NEW) return std::nullopt;
  const std::optional<Generic> generic = generic_map(site, first + 1);
  const std::size_t open = (generic ? generic->last : first + 1) + 1;
  if (site.type(open) != RbtLexer::LPAREN || site.type(open + 1) != RbtLexer::RPAREN)
    return std::nullopt;
  return open + 1;
}

// Explains the mistake: HashMap<String, Integer> stock = new HashMap<>();
Answer map_with_types(const FailureSite& site) {
  const std::size_t first = site.statement;
  if (const std::optional<Generic> type = generic_map(site, first);
      type && !type->meant.empty() && is_name(site.type(type->last + 1))) {
    Diagnostic out =
        written_as(site.span(first, type->last), site.text(first, type->last), type->meant);
    const std::size_t value = type->last + 3;
    if (site.type(type->last + 2) != RbtLexer::ASSIGN) return out;
    if (const std::optional<std::size_t> last = made_map(site, value)) {
      out.fix->text = "write " + type->meant + ' ' + site.text(type->last + 1) + " = [:]";
      out.fix->edits.push_back({site.span(value, *last), "[:]"});
    }
    return out;
  }
  // var stock = new HashMap<String, Integer>()
  const bool declares = site.type(first) == RbtLexer::LET || site.type(first) == RbtLexer::VAR;
  if (!declares || site.type(first + 2) != RbtLexer::ASSIGN) return std::nullopt;
  const std::optional<std::size_t> last = made_map(site, first + 3);
  const std::optional<Generic> type = generic_map(site, first + 4);
  if (!last || !type || type->meant.empty()) return std::nullopt;
  Diagnostic out = written_as(site.span(first + 3, *last), site.text(first + 3, *last), "[:]");
  out.fix->text = "write " + site.text(first, first + 1) + ": " + type->meant + " = [:]";
  out.fix->edits.insert(out.fix->edits.begin(), {site.after(first + 1), ": " + type->meant});
  return out;
}

}  // namespace

std::optional<Diagnostic> explain_map_habit(const FailureSite& site) {
  for (const auto explain : {key_in_map, deleted_entry, map_with_types}) {
    if (Answer out = explain(site)) return out;
  }
  return std::nullopt;
}

}  // namespace armlet::lang
