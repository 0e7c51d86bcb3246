// Explains marks and layouts of other languages: ** and <>, commas in the header of a loop, a colon
// and an indented block.

#include <algorithm>
#include <array>

#include "base/foreign_words.hpp"
#include "syntax/mistakes/failure_site.hpp"
#include "syntax/mistakes/syntax_errors.hpp"

namespace armlet::lang {
namespace {

using Answer = std::optional<Diagnostic>;

Answer written_as(Span mark, const std::string& found, const std::string& meant,
                  std::vector<Edit> edits) {
  Diagnostic out = make_diagnostic("E0130", mark, {found, meant});
  out.fix = Fix{"write " + meant, std::move(edits), Confidence::kSure};
  return out;
}

struct Sign {
  std::uint16_t first;
  std::uint16_t second;
  std::string_view meant;
};

constexpr auto kSigns = std::to_array<Sign>({
    {RbtLexer::STAR, RbtLexer::STAR, "^"},
    {RbtLexer::LT, RbtLexer::GT, "!="},
    {RbtLexer::EQ, RbtLexer::ASSIGN, "=="},
    {RbtLexer::NE, RbtLexer::ASSIGN, "!="},
    {RbtLexer::ASSIGN, RbtLexer::LT, "<="},
});

// Explains the mistake: x ** 2, a <> b, a === b, a =< b. The parser stops at the first or at the
// second of two marks without a blank between them.
Answer doubled_sign(const FailureSite& site) {
  for (const std::size_t first : {site.at, site.at - 1}) {
    if (first > site.at || first <= site.statement || !site.touch(first, first + 1)) continue;
    for (const Sign& sign : kSigns) {
      if (site.type(first) != sign.first || site.type(first + 1) != sign.second) continue;
      const Span mark = site.span(first, first + 1);
      return written_as(mark, site.text(first, first + 1), std::string(sign.meant),
                        {{mark, std::string(sign.meant)}});
    }
  }
  return std::nullopt;
}

// Explains the mistake: x << 3, which is a multiplication by 8.
Answer shifted_bits(const FailureSite& site) {
  for (const std::size_t first : {site.at, site.at - 1}) {
    if (first > site.at || first <= site.statement || !site.touch(first, first + 1)) continue;
    const std::uint16_t mark = site.type(first);
    if ((mark != RbtLexer::LT && mark != RbtLexer::GT) || site.type(first + 1) != mark) continue;
    const Span both = site.span(first, first + 1);
    Diagnostic out = make_diagnostic("E0133", both, {site.text(first, first + 1)});
    const std::string power = "2^" + site.text(first + 2);
    const std::string sign = mark == RbtLexer::LT ? "* " : "/ ";
    if (!site.inserted(first + 2) && FailureSite::starts_value(site.type(first + 2))) {
      const Span place = site.span(first, first + 2);
      out.fix = Fix{"write " + sign + power, {{place, sign + power}}, Confidence::kMaybe};
    }
    return out;
  }
  return std::nullopt;
}

// Explains the mistake: if (a => b)
Answer arrow_compares(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  const bool in_header = open && *open > 0 && is_header_word(site.type(*open - 1));
  if (site.type(site.at) != RbtLexer::FATARROW || !in_header) return std::nullopt;
  return written_as(site.span(site.at), "=>", ">=", {{site.span(site.at), ">="}});
}

bool may_precede_lambda(std::uint16_t type) {
  return type == RbtLexer::LPAREN || type == RbtLexer::COMMA || type == RbtLexer::ASSIGN ||
         type == RbtLexer::COLON;
}

// The parameters x or (x, y), from token `first` to token `last`, as parameters of a function. They
// have types after `let f =`, where no call determines the types.
std::string parameters_of_lambda(const FailureSite& site, std::size_t first, std::size_t last) {
  const bool declares = site.type(first - 1) == RbtLexer::ASSIGN;
  std::string out;
  for (std::size_t i = first; i <= last; ++i) {
    if (!is_name(site.type(i))) continue;
    out += (out.empty() ? "" : ", ") + site.text(i) + (declares ? ": double" : "");
  }
  return "fn(" + out + ')';
}

// Explains the mistake: x => x + 1 and (x, y) => x + y
Answer lambda_without_fn(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  std::size_t first = site.at;
  std::size_t last = site.at;
  if (site.type(site.at) == RbtLexer::COMMA && open && site.type(*open) == RbtLexer::LPAREN) {
    first = *open;
    last = site.closer(*open);
    if (site.type(last + 1) != RbtLexer::FATARROW) return std::nullopt;
  } else if (site.type(site.at) == RbtLexer::FATARROW && site.at > site.statement + 1) {
    last = site.at - 1;
    first = site.type(last) == RbtLexer::RPAREN ? site.opener_of(last) : last;
    if (first == last && !is_name(site.type(last))) return std::nullopt;
  } else {
    return std::nullopt;
  }
  if (first <= site.statement || !may_precede_lambda(site.type(first - 1))) return std::nullopt;
  const std::string found = site.text(first, last);
  const std::string meant = parameters_of_lambda(site, first, last);
  const Span mark = site.span(first, last);
  return written_as(mark, found + " =>", meant + " =>", {{mark, meant}});
}

// Explains the mistake: for (int i = 0, i < 3, i++)
Answer commas_in_loop(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (!open || *open == 0 || site.type(*open - 1) != RbtLexer::FOR) return std::nullopt;
  std::vector<Edit> edits;
  std::size_t first = 0;
  const std::size_t close = site.closer(*open);
  for (std::size_t i = *open + 1; i < close; ++i) {
    if (is_opener(site.type(i))) {
      i = site.closer(i);
    } else if (site.type(i) == RbtLexer::SEMI) {
      return std::nullopt;
    } else if (site.type(i) == RbtLexer::COMMA) {
      if (edits.empty()) first = i;
      edits.push_back({site.span(i), ";"});
    }
  }
  if (edits.size() != 2) return std::nullopt;
  Answer out = written_as(site.span(first), ",", ";", std::move(edits));
  out->why = "the three parts of the header are separated by semicolons";
  out->fix->text = "write `;` between the three parts";
  return out;
}

// Explains the mistake: fn f(x: int): int { ... }
Answer result_behind_colon(const FailureSite& site) {
  const bool is_function = site.type(site.statement) == RbtLexer::FN;
  if (!is_function || site.type(site.at) != RbtLexer::COLON || site.before() != RbtLexer::RPAREN ||
      site.starts_line(site.at + 1)) {
    return std::nullopt;
  }
  return written_as(site.span(site.at), ":", "->", {{site.span(site.at), " ->"}});
}

// Explains the mistake: double[] q = double[4]
Answer array_without_new(const FailureSite& site) {
  if (site.at <= site.statement + 1 || site.type(site.at) != RbtLexer::LBRACK ||
      !is_primitive_type(site.before())) {
    return std::nullopt;
  }
  const Span place{site.span(site.at - 1).begin, site.span(site.at - 1).begin,
                   site.span(site.at).source};
  Diagnostic out = make_diagnostic("E0129", place, {"`new`"});
  const std::string made = site.text(site.at - 1, site.closer(site.at));
  out.fix = Fix{"write new " + made, {{place, "new "}}, Confidence::kSure};
  return out;
}

// Explains the mistake: for (i in 0..5), where the second point is part of the number .5
Answer range_with_points(const FailureSite& site) {
  if (site.at <= site.statement || site.type(site.at) != RbtLexer::FLOAT) return std::nullopt;
  const std::string last = site.text(site.at);
  if (!last.starts_with('.') || !site.touch(site.at - 1, site.at)) return std::nullopt;
  std::string first = site.text(site.at - 1);
  if (site.before() != RbtLexer::FLOAT || !first.ends_with('.')) return std::nullopt;
  first.pop_back();
  const Span mark = site.span(site.at - 1, site.at);
  const std::string meant = "range(" + first + ", " + last.substr(1) + ')';
  return written_as(mark, site.text(site.at - 1, site.at), meant, {{mark, meant}});
}

// Explains the mistake: int a[3];
Answer array_as_in_c(const FailureSite& site) {
  const std::size_t first = site.statement;
  if (site.at != first + 3 || !is_primitive_type(site.type(first)) ||
      site.type(first + 2) != RbtLexer::LBRACK || site.closer(first + 2) != site.at + 1) {
    return std::nullopt;
  }
  const std::string type = site.text(first);
  const std::string meant =
      type + "[] " + site.text(first + 1) + " = new " + type + site.text(first + 2, site.at + 1);
  const Span mark = site.span(first, site.at + 1);
  return written_as(mark, site.text(first, site.at + 1), meant, {{mark, meant}});
}

// Explains the mistake: if (n > 2) then { ... }
Answer needless_then(const FailureSite& site) {
  for (const std::size_t word : {site.at, site.at - 1}) {
    if (word > site.at || word <= site.statement || site.text(word) != "then") continue;
    if (site.type(word - 1) != RbtLexer::RPAREN) continue;
    Diagnostic out = make_diagnostic("E0116", site.span(word), {"then"});
    out.fix = Fix{"delete then", {{site.span(word), ""}}, Confidence::kSure};
    return out;
  }
  return std::nullopt;
}

// ---- a colon and an indented block

std::size_t indent_of(const FailureSite& site, std::size_t token) { return site.column(token); }

// The last token of the lines after `colon` that are indented deeper than the statement.
std::size_t end_of_indented(const FailureSite& site, std::size_t colon) {
  std::size_t last = colon;
  for (std::size_t i = colon + 1; site.type(i) != kEndOfText; ++i) {
    if (site.inserted(i)) continue;
    if (site.starts_line(i) && indent_of(site, i) <= site.line_indent(site.statement)) break;
    last = i;
  }
  return last;
}

// The word of this language for `def` or `elif` at the start of the statement; empty if it starts
// with another word.
std::string_view foreign_opening(const FailureSite& site) {
  const std::string_view meant = meant_by(site.text(site.statement), &ForeignWord::at_start);
  return meant == "fn" || meant == "else if" ? meant : std::string_view();
}

bool is_python_function(const FailureSite& site) {
  return site.type(site.statement) == RbtLexer::FN || foreign_opening(site) == "fn";
}

bool opens_python_block(const FailureSite& site) {
  const std::uint16_t type = site.type(site.statement);
  return is_header_word(type) || type == RbtLexer::FN || type == RbtLexer::ELSE ||
         type == RbtLexer::TRY || type == RbtLexer::FINALLY || !foreign_opening(site).empty();
}

// The colon at the end of a line, or before a `return`; empty if the statement has no such colon.
std::optional<std::size_t> python_colon(const FailureSite& site) {
  if (!opens_python_block(site)) return std::nullopt;
  std::size_t colon = site.statement + 1;
  while (site.type(colon) != RbtLexer::COLON) {
    if (site.type(colon) == kEndOfText || site.starts_line(colon) ||
        site.type(colon) == RbtLexer::LBRACE)
      return std::nullopt;
    colon = is_opener(site.type(colon)) ? site.closer(colon) + 1 : colon + 1;
  }
  if (site.at > colon + 1) return std::nullopt;
  const bool returns = site.type(colon + 1) == RbtLexer::RETURN && is_python_function(site);
  const bool has_block = site.starts_line(colon + 1) && end_of_indented(site, colon) > colon;
  return has_block || returns ? std::optional(colon) : std::nullopt;
}

// Explains the mistake of a colon before an indented block:
//     while x < 3:
//         x = x + 1
Answer python_block(const FailureSite& site) {
  const std::optional<std::size_t> found = python_colon(site);
  if (!found) return std::nullopt;
  const std::size_t colon = *found;
  const bool on_line = !site.starts_line(colon + 1);
  std::vector<Edit> edits;
  const std::string_view meant = foreign_opening(site);
  if (!meant.empty()) edits.push_back({site.span(site.statement), std::string(meant)});
  const bool bare = (is_header_word(site.type(site.statement)) || meant == "else if") &&
                    site.type(site.statement + 1) != RbtLexer::LPAREN;
  if (bare) {
    const std::uint32_t begin = site.span(site.statement + 1).begin;
    edits.push_back({{begin, begin, site.span(colon).source}, "("});
  }
  Diagnostic out = make_diagnostic("E0130", site.span(colon), {":", on_line ? "=>" : "{ ... }"});
  if (on_line) {
    edits.push_back({site.span(colon, colon + 1), " =>"});
    out.fix = Fix{"write " + site.text(site.statement + 1, colon - 1) + " => ...", std::move(edits),
                  Confidence::kSure};
    return out;
  }
  edits.push_back({site.span(colon), bare ? ") {" : " {"});
  const std::size_t last = end_of_indented(site, colon);
  edits.push_back(
      {site.after(last), '\n' + std::string(site.line_indent(site.statement), ' ') + '}'});
  out.why = "what belongs together stands in braces; indentation alone says nothing";
  out.fix = Fix{"write { here and } behind the last line that belongs to it", std::move(edits),
                Confidence::kMaybe};
  return out;
}

}  // namespace

std::size_t end_of_python_function(const Source& source, const Tokens& tokens,
                                   std::size_t statement, std::size_t at) {
  const FailureSite site(source, tokens, statement, at);
  const std::optional<std::size_t> colon = python_colon(site);
  if (!colon || !is_python_function(site) || !site.starts_line(*colon + 1)) return 0;
  std::size_t behind = end_of_indented(site, *colon) + 1;
  while (site.type(behind) == RbtLexer::SEMI) ++behind;
  return behind;
}

std::optional<Diagnostic> explain_sign(const FailureSite& site) {
  for (const auto explain :
       {doubled_sign, shifted_bits, arrow_compares, lambda_without_fn, python_block, commas_in_loop,
        result_behind_colon, array_without_new, array_as_in_c, range_with_points, needless_then}) {
    if (Answer out = explain(site)) return out;
  }
  return std::nullopt;
}

}  // namespace armlet::lang
