#include "syntax/mistakes/syntax_errors.hpp"

#include <vector>

#include "syntax/mistakes/failure_site.hpp"

namespace armlet::lang {
namespace {

using Answer = std::optional<Diagnostic>;

std::string quoted(const std::string& text) { return '`' + text + '`'; }

// "an `if`", "a `for`".
std::string with_article(const std::string& word) {
  return (std::string_view("aeiou").find(word.front()) == std::string_view::npos ? "a " : "an ") +
         quoted(word);
}

// Explains the mistake: if d > 0.45 { ... }   and   if (a) && (b) { ... }
Answer bare_condition(const FailureSite& site) {
  std::size_t word = site.at - 1;
  if (site.at > site.statement && site.before() == RbtLexer::RPAREN &&
      is_between_values(mark_of(site.type(site.at)))) {
    const std::size_t open = site.opener_of(site.at - 1);
    if (open == site.statement) return std::nullopt;
    word = open - 1;
  } else if (site.at <= site.statement || site.type(site.at) == RbtLexer::LPAREN) {
    return std::nullopt;
  }
  if (!is_header_word(site.type(word)) || site.type(word) == RbtLexer::CATCH) return std::nullopt;
  std::size_t end = word + 1;
  while (site.type(end) != RbtLexer::LBRACE && site.type(end) != RbtLexer::SEMI &&
         site.type(end) != RbtLexer::RBRACE && site.type(end) != kEndOfText) {
    end = is_opener(site.type(end)) ? site.closer(end) + 1 : end + 1;
  }
  if (end == word + 1) return std::nullopt;
  if (site.text(end - 1) == "then" && end > word + 2) --end;
  const Span condition = site.span(word + 1, end - 1);
  const bool has_then = site.text(end) == "then";
  const bool has_block = site.type(has_then ? end + 1 : end) == RbtLexer::LBRACE;
  Diagnostic out = make_diagnostic("E0112", condition, {with_article(site.text(word))});
  if (has_block) {
    out.fix = Fix{
        "write " + site.text(word) + " (" + site.text(word + 1, end - 1) + ") { ... }",
        {{{condition.begin, condition.begin, condition.source}, "("}, {site.after(end - 1), ")"}},
        Confidence::kSure};
    if (has_then) out.fix->edits.push_back({site.span(end), ""});
  } else {
    out.fix = Fix{"write " + site.text(word) + " (...) { ... }", {}, Confidence::kMaybe};
  }
  return out;
}

// Explains the mistake: if (state = State.Done)
Answer assignment_as_test(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::ASSIGN || !open || *open == site.statement)
    return std::nullopt;
  if (!word_of(site.type(*open - 1)).has_condition) return std::nullopt;
  Diagnostic out = make_diagnostic("E0113", site.span(site.at));
  out.fix = Fix{"to compare, write ==", {{site.span(site.at), "=="}}, Confidence::kSure};
  return out;
}

// The last token of a body that begins at token `i` and is not an `if` or a loop.
std::size_t body_end(const FailureSite& site, std::size_t i) {
  if (site.type(i) == RbtLexer::LBRACE) return site.closer(i);
  std::size_t last = i;
  while (site.type(i) != RbtLexer::SEMI && site.type(i) != RbtLexer::RBRACE &&
         site.type(i) != kEndOfText) {
    last = is_opener(site.type(i)) ? site.closer(i) : i;
    i = last + 1;
  }
  return last;
}

// The last token of the `if`, `while` or `for` at token `word`, with its body. The bodies may be
// such statements too, to any depth.
std::size_t statement_end(const FailureSite& site, std::size_t word) {
  std::vector<std::size_t> outer;  // the statements whose bodies are not complete yet
  while (true) {
    std::size_t i = word + 1;
    if (site.type(i) == RbtLexer::LPAREN) i = site.closer(i) + 1;
    outer.push_back(word);
    word = i;
    if (is_header_word(site.type(i))) continue;
    const std::size_t last = body_end(site, i);
    const std::size_t otherwise = site.type(last + 1) == RbtLexer::SEMI ? last + 2 : last + 1;
    bool goes_on = false;
    while (!outer.empty() && !goes_on) {
      goes_on = site.type(outer.back()) == RbtLexer::IF && site.type(otherwise) == RbtLexer::ELSE;
      outer.pop_back();
    }
    if (!goes_on) return last;
    word = otherwise;
  }
}

// Explains the mistake: if (a) if (b) ...
Answer unbraced_body(const FailureSite& site) {
  if (site.at <= site.statement || !word_of(site.type(site.at)).has_parts) return std::nullopt;
  std::string outer = "else";
  if (site.before() == RbtLexer::RPAREN) {
    const std::size_t open = site.opener_of(site.at - 1);
    if (open == site.statement || site.type(open - 1) != RbtLexer::IF) return std::nullopt;
    outer = "if";
  } else if (site.before() != RbtLexer::ELSE) {
    return std::nullopt;
  }
  const std::string word = site.text(site.at);
  const bool has_header = site.type(site.at + 1) == RbtLexer::LPAREN;
  const Span mark = site.span(site.at, has_header ? site.closer(site.at + 1) : site.at);
  Diagnostic out = make_diagnostic("E0114", mark, {with_article(word), outer});
  out.why = site.type(site.at) == RbtLexer::IF
                ? "the reader could not tell which `if` the `else` belongs to"
                : "a body without braces is one simple statement";
  out.fix = Fix{"put braces around the inner " + quoted(word), {}, Confidence::kMaybe};
  if (is_header_word(site.type(site.at))) {
    const Span here = site.span(site.at);
    out.fix->edits = {{{here.begin, here.begin, here.source}, "{ "},
                      {site.after(statement_end(site, site.at)), " }"}};
  }
  return out;
}

// The edits that move an increment before or after the statement, and leave its variable there.
// Headers of loops and similar statements run more than once or end elsewhere, so they have no such
// edits.
std::vector<Edit> moved_out(const FailureSite& site, std::size_t first, std::size_t last,
                            const std::string& variable, const std::string& step, bool behind) {
  const std::uint16_t first_word = site.type(site.statement);
  const bool declares = first_word == RbtLexer::LET || first_word == RbtLexer::VAR;
  if (word_of(first_word).has_parts && !declares) return {};
  const std::string indent(site.line_indent(site.statement), ' ');
  std::size_t end = last + 1;
  while (site.type(end) != RbtLexer::SEMI && site.type(end) != kEndOfText) ++end;
  const std::uint32_t begin = site.span(site.statement).begin;
  const Edit use{site.span(first, last), variable};
  if (!behind) return {{{begin, begin, use.span.source}, step + '\n' + indent}, use};
  if (site.type(end) == kEndOfText) --end;
  return {use, {site.after(end), '\n' + indent + step}};
}

// Explains the mistake: run(p[i++], time: 1s)
Answer step_as_value(const FailureSite& site) {
  if (site.type(site.at) != RbtLexer::INC && site.type(site.at) != RbtLexer::DEC)
    return std::nullopt;
  std::size_t first = site.at;
  std::size_t last = site.at;
  const bool behind = site.at > site.statement && FailureSite::ends_value(site.before());
  if (behind) {
    first = site.value_start(site.at - 1);
  } else if (is_name(site.type(site.at + 1))) {
    last = site.at + 1;
  }
  const std::string step = site.text(first, last);
  const std::string variable = behind ? site.text(first, site.at - 1) : site.text(last);
  Diagnostic out = make_diagnostic("E0115", site.span(first, last), {step});
  std::string use = variable;
  const std::optional<std::size_t> open = site.opener(first);
  const bool is_index = open && site.type(*open) == RbtLexer::LBRACK && *open + 1 == first &&
                        site.type(last + 1) == RbtLexer::RBRACK && *open > site.statement;
  if (is_index) use = site.text(site.value_start(*open - 1), *open) + variable + ']';
  out.fix = behind ? Fix{"use " + use + " here and write " + step + " on the next line",
                         moved_out(site, first, last, variable, step, true), Confidence::kMaybe}
                   : Fix{"write " + step + " on the line before and use " + use + " here",
                         moved_out(site, first, last, variable, step, false), Confidence::kMaybe};
  return out;
}

// Explains the mistake: (a = 2) + 1
Answer assignment_as_value(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::ASSIGN || !open || site.type(*open) != RbtLexer::LPAREN)
    return std::nullopt;
  if (!FailureSite::ends_value(site.before())) return std::nullopt;
  const std::size_t first = site.value_start(site.at - 1);
  const std::size_t last = site.closer(*open) - 1;
  if (last <= site.at) return std::nullopt;
  const std::string stored = site.text(first, last);
  Diagnostic out = make_diagnostic("E0115", site.span(first, last), {stored});
  out.fix = Fix{
      "write " + stored + " on the line before and use " + site.text(first, site.at - 1) + " here",
      {},
      Confidence::kMaybe};
  return out;
}

// Explains the mistake: fn(x) => n += x
Answer assignment_as_result(const FailureSite& site) {
  if (!mark_of(site.type(site.at)).assigns || site.at == 0 ||
      !FailureSite::ends_value(site.before()))
    return std::nullopt;
  const std::size_t first = site.value_start(site.at - 1);
  if (first <= site.statement || site.type(first - 1) != RbtLexer::FATARROW) return std::nullopt;
  const std::optional<std::size_t> open = site.opener(first);
  const std::size_t last = open ? std::max(site.closer(*open) - 1, site.at) : site.at;
  Diagnostic out = make_diagnostic("E0115", site.span(first, last), {site.text(first, last)});
  out.why = "a lambda gives a value, and cannot change a variable outside";
  out.fix = Fix{"use a for loop, or fold to gather one value from a list", {}, Confidence::kMaybe};
  return out;
}

// Explains the mistake: fn(x) => { ... }
Answer block_after_arrow(const FailureSite& site) {
  if (site.at == 0 || site.type(site.at) != RbtLexer::LBRACE || site.before() != RbtLexer::FATARROW)
    return std::nullopt;
  Diagnostic out = make_diagnostic("E0118", site.span(site.at - 1));
  out.fix = Fix{"delete the =>", {{site.span(site.at - 1), ""}}, Confidence::kSure};
  return out;
}

// print(1) print(2)
Diagnostic statement_on_same_line(const FailureSite& site) {
  Diagnostic out = make_diagnostic("E0122", site.span(site.at));
  out.mark.label = "a new statement starts here";
  out.fix = Fix{"write a `;` before it, or start a new line",
                {{site.after(site.at - 1), ";"}},
                Confidence::kMaybe};
  return out;
}

// Explains the mistake: else, catch, case ... without the statement they belong to
Answer orphan(const FailureSite& site) {
  const std::string_view owner = word_of(site.type(site.at)).belongs_to;
  if (owner.empty()) return std::nullopt;
  const bool is_case =
      site.type(site.at) == RbtLexer::CASE || site.type(site.at) == RbtLexer::DEFAULT;
  if (is_case && site.at > site.statement && !site.starts_line(site.at) &&
      can_end_statement(site.before()))
    return statement_on_same_line(site);
  Diagnostic out = make_diagnostic("E0128", site.span(site.at), {site.text(site.at)});
  out.why = owner;
  if (site.type(site.at) == RbtLexer::ELSE && site.type(site.at + 1) == RbtLexer::COLON)
    out.fix = Fix{"write default", {{site.span(site.at), "default"}}, Confidence::kSure};
  return out;
}

// Explains the mistake: let in = 3
Answer word_as_name(const FailureSite& site) {
  const Word& word = word_of(site.type(site.at));
  const bool is_word = !word.text.empty() && is_reserved(word);
  if (!is_word || site.at <= site.statement || site.starts_line(site.at)) return std::nullopt;
  const std::uint16_t before = site.before();
  const bool wants_name =
      word_of(before).wants == "a name" || before == RbtLexer::DOT || is_primitive_type(before);
  if (!wants_name) return std::nullopt;
  Diagnostic out = make_diagnostic("E0128", site.span(site.at), {site.text(site.at)});
  out.why = quoted(site.text(site.at)) + " is a word of the language and cannot be a name";
  out.fix = Fix{"choose another name", {}, Confidence::kMaybe};
  return out;
}

// The edits that insert missing commas between the values in a bracket: [1 2 3].
std::vector<Edit> missing_commas(const FailureSite& site, std::size_t open) {
  std::vector<Edit> out;
  const std::size_t close = site.closer(open);
  for (std::size_t i = site.at; i < close; ++i) {
    const bool apart =
        FailureSite::ends_value(site.type(i - 1)) && FailureSite::starts_value(site.type(i));
    if (apart) out.push_back({site.after(i - 1), ","});
    if (is_opener(site.type(i))) i = site.closer(i);
  }
  return out;
}

// Explains the mistake: f(a b)   and   a = 1 b = 2
Answer missing_separator(const FailureSite& site) {
  const std::uint16_t type = site.type(site.at);
  if (site.at <= site.statement || !can_end_statement(site.before())) return std::nullopt;
  const std::optional<std::size_t> open = site.opener(site.at);
  const bool in_block =
      !open || (site.type(*open) == RbtLexer::LBRACE && site.type(*open - 1) != RbtLexer::ASSIGN);
  if (!in_block) {
    const bool is_list = site.type(*open) != RbtLexer::LPAREN || site.is_call(*open);
    if (!is_list || !FailureSite::starts_value(type) || !FailureSite::ends_value(site.before()))
      return std::nullopt;
    Diagnostic out = make_diagnostic("E0120", site.span(site.at));
    out.fix = Fix{"write " + site.text(site.at - 1) + ", " + site.text(site.at),
                  missing_commas(site, *open), Confidence::kMaybe};
    return out;
  }
  const bool starts =
      FailureSite::starts_value(type) || is_primitive_type(type) || word_of(type).starts;
  if (!starts || site.starts_line(site.at)) return std::nullopt;
  return statement_on_same_line(site);
}

// The part that must follow a token; empty if none must.
std::string_view wanted_after(std::uint16_t type) {
  const std::string_view wants = word_of(type).wants;
  return wants.empty() ? mark_of(type).wants : wants;
}

// Explains the mistake: let x =
Answer something_missing(const FailureSite& site) {
  if (site.at <= site.statement) return std::nullopt;
  const std::uint16_t type = site.type(site.at);
  const bool stops = type == RbtLexer::SEMI || type == kEndOfText || type == RbtLexer::COMMA ||
                     is_closer(type) || type == RbtLexer::ASSIGN || site.starts_line(site.at) ||
                     word_of(type).has_parts;
  if (!stops) return std::nullopt;
  std::string_view wanted = wanted_after(site.before());
  if (type == RbtLexer::RBRACE && site.before() == RbtLexer::LBRACE &&
      site.type(site.statement) == RbtLexer::ENUM)
    wanted = "the name of a value";
  if (type == RbtLexer::ASSIGN && site.before() == RbtLexer::COLON) wanted = "a type";
  if (wanted.empty()) {
    // A header or a declaration that ends before its block.
    if (type != RbtLexer::SEMI && type != kEndOfText) return std::nullopt;
    wanted = word_of(site.type(site.statement)).needs_block ? "a block in braces"
             : site.before() == RbtLexer::RPAREN            ? "a statement"
                                                            : "the rest of this statement";
  }
  return make_diagnostic("E0129", site.after(site.at - 1), {std::string(wanted)});
}

Diagnostic does_not_fit(const FailureSite& site) {
  if (site.type(site.at) == kEndOfText || site.inserted(site.at)) {
    const Span place = site.at == 0 ? site.span(0) : site.after(site.at - 1);
    return make_diagnostic("E0129", place, {"the rest of this statement"});
  }
  return make_diagnostic("E0128", site.span(site.at), {site.text(site.at)});
}

}  // namespace

Diagnostic explain_failure(const Source& source, const Tokens& tokens, std::size_t statement,
                           std::size_t at) {
  const FailureSite site(source, tokens, statement, at);
  for (const auto explain : {explain_sign, assignment_as_test, explain_block, explain_map_habit,
                             explain_habit, bare_condition, unbraced_body, step_as_value,
                             assignment_as_value, assignment_as_result, block_after_arrow, orphan,
                             word_as_name, explain_row, missing_separator, something_missing}) {
    if (Answer out = explain(site)) return *std::move(out);
  }
  return does_not_fit(site);
}

}  // namespace armlet::lang
