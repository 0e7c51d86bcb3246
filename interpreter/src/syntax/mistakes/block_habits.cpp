// Explains blocks and headers of other languages, or with a missing part: for (var i in xs), test
// addition { ... }, catch e { ... }, do { ... } until (c), repeat 3 { ... }, lab { ... }.

#include <algorithm>
#include <array>

#include "syntax/mistakes/failure_site.hpp"
#include "syntax/mistakes/syntax_errors.hpp"

namespace armlet::lang {
namespace {

using Answer = std::optional<Diagnostic>;

Diagnostic misfit(const FailureSite& site, std::size_t i, std::string why) {
  Diagnostic out = make_diagnostic("E0128", site.span(i), {site.text(i)});
  out.why = std::move(why);
  return out;
}

// The opening bracket of the `for` header that contains token `i`.
std::optional<std::size_t> for_header(const FailureSite& site, std::size_t i) {
  const std::optional<std::size_t> open = site.opener(i);
  const bool is_header = open && *open > 0 && site.type(*open) == RbtLexer::LPAREN &&
                         site.type(*open - 1) == RbtLexer::FOR;
  return is_header ? open : std::nullopt;
}

// Explains the mistake: for (var i in range(3))
Answer declared_loop_name(const FailureSite& site) {
  if (site.type(site.at) != RbtLexer::IN) return std::nullopt;
  const std::optional<std::size_t> open = for_header(site, site.at);
  if (!open || site.at < *open + 3 || !is_name(site.before())) return std::nullopt;
  for (std::size_t i = *open + 1; i + 1 < site.at; ++i) {
    const std::uint16_t type = site.type(i);
    const bool is_word = type == RbtLexer::LET || type == RbtLexer::VAR ||
                         type == RbtLexer::FINAL || is_primitive_type(type) || is_name(type);
    if (!is_word) return std::nullopt;
  }
  Diagnostic out =
      misfit(site, *open + 1, "a loop declares its variable by itself, without var or let");
  const Span words{site.span(*open + 1).begin, site.span(site.at - 1).begin,
                   site.span(site.at).source};
  const std::size_t close = site.closer(*open);
  out.fix = Fix{"write for (" + site.text(site.at - 1, close), {{words, ""}}, Confidence::kSure};
  return out;
}

// Explains the mistake: for (i = 1:10), for (i in 1:10), where the last value belongs to the range.
Answer range_with_colon(const FailureSite& site) {
  if (site.type(site.at) != RbtLexer::COLON) return std::nullopt;
  const std::optional<std::size_t> open = for_header(site, site.at);
  if (!open || !is_name(site.type(*open + 1))) return std::nullopt;
  const std::uint16_t sign = site.type(*open + 2);
  const std::size_t close = site.closer(*open);
  if ((sign != RbtLexer::ASSIGN && sign != RbtLexer::IN) || site.at < *open + 4 ||
      site.at + 1 >= close)
    return std::nullopt;
  Diagnostic out =
      misfit(site, site.at, "range(a, b) gives the numbers of a loop, without b itself");
  for (std::size_t i = site.at + 1; i < close; ++i) {
    if (site.type(i) == RbtLexer::COLON) return out;
  }
  const std::string meant = site.text(*open + 1) + " in range(" +
                            site.text(*open + 3, site.at - 1) + ", " +
                            site.text(site.at + 1, close - 1) + " + 1)";
  out.fix = Fix{
      "write for (" + meant + ")", {{site.span(*open + 1, close - 1), meant}}, Confidence::kMaybe};
  return out;
}

// Explains the mistake: test addition { ... }
Answer test_without_quotes(const FailureSite& site) {
  const std::size_t name = site.statement + 1;
  if (site.type(site.statement) != RbtLexer::TEST || !is_name(site.type(name)) ||
      site.type(name + 1) != RbtLexer::LBRACE || site.at < name)
    return std::nullopt;
  Diagnostic out = misfit(site, name, "the name of a test stands in quotes");
  const std::string meant = '"' + site.text(name) + '"';
  out.fix = Fix{"write test " + meant, {{site.span(name), meant}}, Confidence::kSure};
  return out;
}

// Explains the mistake: assert(n = 1)
Answer assert_with_one_equals(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::ASSIGN || !open || *open == 0 ||
      site.text(*open - 1) != "assert")
    return std::nullopt;
  for (std::size_t i = *open + 1; i < site.at; ++i) {
    if (site.type(i) == RbtLexer::COMMA && site.opener(i) == open) return std::nullopt;
  }
  Diagnostic out = make_diagnostic("E0113", site.span(site.at));
  out.fix = Fix{"to compare, write ==", {{site.span(site.at), "=="}}, Confidence::kSure};
  return out;
}

// Explains the mistake: catch e { ... }
Answer catch_without_parentheses(const FailureSite& site) {
  const bool is_bare = site.at > 0 && site.before() == RbtLexer::CATCH &&
                       is_name(site.type(site.at)) && site.type(site.at + 1) == RbtLexer::LBRACE;
  if (!is_bare) return std::nullopt;
  Diagnostic out = misfit(site, site.at, "the name of the error stands in parentheses");
  const std::string meant = '(' + site.text(site.at) + ')';
  out.fix = Fix{"write catch " + meant, {{site.span(site.at), meant}}, Confidence::kSure};
  return out;
}

// The last token of a condition that begins at token `first`.
std::size_t condition_end(const FailureSite& site, std::size_t first) {
  std::size_t last = first;
  for (std::size_t i = first; site.type(i) != RbtLexer::SEMI && site.type(i) != kEndOfText &&
                              site.type(i) != RbtLexer::RBRACE;
       i = last + 1) {
    last = is_opener(site.type(i)) ? site.closer(i) : i;
  }
  return last;
}

// The edits that replace `until c` at token `until` by `while (!(c))`.
std::vector<Edit> while_of(const FailureSite& site, std::size_t until) {
  const std::size_t last = condition_end(site, until + 1);
  const bool has_brackets =
      site.type(until + 1) == RbtLexer::LPAREN && site.closer(until + 1) == last;
  const Span word{site.span(until).begin, site.span(until + 1).begin, site.span(until).source};
  return {{word, has_brackets ? "while (!" : "while (!("},
          {site.after(last), has_brackets ? ")" : "))"}};
}

// Explains the mistake: do { ... } until (c)
Answer do_until(const FailureSite& site) {
  const bool ends_loop = site.at > 0 && site.type(site.at) == RbtLexer::UNTIL &&
                         site.before() == RbtLexer::RBRACE &&
                         site.type(site.statement) == RbtLexer::DO;
  if (!ends_loop) return std::nullopt;
  Diagnostic out =
      misfit(site, site.at, "a loop that runs at least once is do { ... } while (...)");
  if (site.type(site.at + 1) == RbtLexer::SEMI || site.type(site.at + 1) == kEndOfText) return out;
  out.fix = Fix{"write while (!(...))", while_of(site, site.at), Confidence::kMaybe};
  return out;
}

// Explains the mistake: repeat { ... } until (c), repeat 3 { ... }, loop { ... }
Answer foreign_loop(const FailureSite& site) {
  const std::size_t word = site.statement;
  const std::string text = site.text(word);
  if (site.type(word) != RbtLexer::ID || (text != "repeat" && text != "loop" && text != "forever"))
    return std::nullopt;
  std::size_t brace = word + 1;
  while (site.type(brace) != RbtLexer::LBRACE && site.type(brace) != RbtLexer::SEMI &&
         site.type(brace) != kEndOfText) {
    brace = is_opener(site.type(brace)) ? site.closer(brace) + 1 : brace + 1;
  }
  if (site.type(brace) != RbtLexer::LBRACE || site.at > brace) return std::nullopt;
  Diagnostic out =
      misfit(site, word, "loops are while (...), for (... in ...) and do { ... } while (...)");
  const std::size_t until = site.closer(brace) + 1;
  if (brace > word + 1) {
    std::string count = site.text(word + 1, brace - 1);
    const bool has_brackets =
        site.type(word + 1) == RbtLexer::LPAREN && site.closer(word + 1) + 1 == brace;
    if (has_brackets) count = count.substr(1, count.size() - 2);
    const std::string meant = "for (i in range(" + count + "))";
    out.fix = Fix{"write " + meant, {{site.span(word, brace - 1), meant}}, Confidence::kMaybe};
  } else if (site.type(until) == RbtLexer::UNTIL) {
    std::vector<Edit> edits = while_of(site, until);
    edits.insert(edits.begin(), {site.span(word), "do"});
    out.fix = Fix{"write do { ... } while (!(...))", std::move(edits), Confidence::kMaybe};
  } else if (text != "repeat") {
    out.fix = Fix{"write while (true)", {{site.span(word), "while (true)"}}, Confidence::kSure};
  }
  return out;
}

// Explains the mistake: lab { ... }
Answer block_without_name(const FailureSite& site) {
  const std::size_t word = site.statement;
  if (site.at != word + 1 || site.type(word) != RbtLexer::ID ||
      site.type(site.at) != RbtLexer::LBRACE)
    return std::nullopt;
  const std::string text = site.text(word);
  Diagnostic out = misfit(site, site.at, "such a block has a name");
  out.fix = Fix{"write " + text + " NAME { ... }", {}, Confidence::kMaybe};
  return out;
}

// Explains the mistake: go(p, until: c > 8N)
Answer until_as_argument(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::UNTIL || !open || !site.is_call(*open) ||
      site.type(site.at + 1) != RbtLexer::COLON || site.before() != RbtLexer::COMMA)
    return std::nullopt;
  Diagnostic out = misfit(site, site.at, "a condition that ends a move stands behind its call");
  const std::size_t close = site.closer(*open);
  for (std::size_t i = site.at; i < close; ++i) {
    if (site.type(i) == RbtLexer::COMMA && site.opener(i) == open) return out;
  }
  if (close < site.at + 3) return out;
  const std::string condition = site.text(site.at + 2, close - 1);
  out.fix =
      Fix{"write " + site.text(*open - 1) + "(...) until " + condition,
          {{site.span(site.at - 1, close - 1), ""}, {site.after(close), " until " + condition}},
          Confidence::kSure};
  return out;
}

}  // namespace

std::optional<Diagnostic> explain_block(const FailureSite& site) {
  for (const auto explain :
       {declared_loop_name, range_with_colon, test_without_quotes, assert_with_one_equals,
        catch_without_parentheses, do_until, foreign_loop, block_without_name, until_as_argument}) {
    if (Answer out = explain(site)) return out;
  }
  return std::nullopt;
}

std::size_t end_of_foreign_loop(const Source& source, const Tokens& tokens, std::size_t statement,
                                std::size_t at) {
  const FailureSite site(source, tokens, statement, at);
  if (!foreign_loop(site)) return 0;
  std::size_t brace = statement + 1;
  while (site.type(brace) != RbtLexer::LBRACE) {
    brace = is_opener(site.type(brace)) ? site.closer(brace) + 1 : brace + 1;
  }
  std::size_t behind = site.closer(brace) + 1;
  if (site.type(behind) == RbtLexer::UNTIL) behind = condition_end(site, behind + 1) + 1;
  while (site.type(behind) == RbtLexer::SEMI) ++behind;
  return behind;
}

}  // namespace armlet::lang
