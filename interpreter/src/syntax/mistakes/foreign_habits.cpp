// Explains habits from other languages: the class around a Java program, words of Python, decimal
// commas.

#include <algorithm>
#include <array>
#include <cctype>

#include "armlet/interpreter/unit.hpp"
#include "base/foreign_words.hpp"
#include "syntax/mistakes/failure_site.hpp"

namespace armlet::lang {
namespace {

constexpr std::array<std::string_view, 9> kModifiers = {"public",  "private",   "protected",
                                                        "static",  "abstract",  "class",
                                                        "package", "interface", "synchronized"};

using Answer = std::optional<Diagnostic>;

bool is_modifier(const FailureSite& site, std::size_t i) {
  return site.type(i) == RbtLexer::ID &&
         std::ranges::find(kModifiers, site.text(i)) != kModifiers.end();
}

// A class or a main function that begins at a token, with modifiers before it.
struct ProgramFrame {
  std::size_t modifier;  // the last modifier
  std::size_t brace;     // the brace after the header
  bool is_frame;         // whether it contains a whole program
};

std::optional<ProgramFrame> frame_at(const FailureSite& site, std::size_t first) {
  if (!is_modifier(site, first)) return std::nullopt;
  ProgramFrame out{first, 0, false};
  while (is_modifier(site, out.modifier + 1)) ++out.modifier;
  bool has_main = false;
  out.brace = out.modifier + 1;
  while (site.type(out.brace) != RbtLexer::LBRACE && site.type(out.brace) != RbtLexer::SEMI &&
         site.type(out.brace) != kEndOfText) {
    has_main = has_main || site.text(out.brace) == "main";
    ++out.brace;
  }
  const std::string word = site.text(out.modifier);
  out.is_frame = site.type(out.brace) == RbtLexer::LBRACE &&
                 (has_main || word == "class" || word == "interface");
  return out;
}

// Whether a modifier is that of `static int calls = 0;` in a function, a variable that keeps its
// value between calls.
bool is_kept_between_calls(const FailureSite& site, std::size_t modifier) {
  if (site.text(modifier) != "static") return false;
  std::size_t depth = 0;
  for (std::size_t i = modifier; i-- > 0;) {
    if (is_closer(site.type(i))) ++depth;
    if (!is_opener(site.type(i)) || depth-- > 0) continue;
    const bool is_class =
        i >= 2 && (site.text(i - 2) == "class" || site.text(i - 2) == "interface");
    return !is_class;
  }
  return false;
}

// Explains the mistake: public static void main(String[] args) {, and modifiers directly inside of
// such a class.
Answer java_frame(const FailureSite& site) {
  std::optional<ProgramFrame> frame = frame_at(site, site.statement);
  if (!frame) return std::nullopt;
  const std::size_t last = frame->is_frame ? frame->brace - 1 : frame->modifier;
  Diagnostic out =
      make_diagnostic("E0116", site.span(site.statement, last), {site.text(site.statement)});
  out.why = "a .rbt file runs from its first line; there are no classes and no main";
  if (!frame->is_frame && is_kept_between_calls(site, frame->modifier)) {
    out.why = "a variable of a function begins anew in each call; one of the file keeps its value";
    return out;
  }
  if (!frame->is_frame) {
    out.fix =
        Fix{"delete " + site.text(site.statement, last), {{out.mark.span, ""}}, Confidence::kSure};
    return out;
  }
  out.fix = Fix{"delete this line and its closing brace", {}, Confidence::kMaybe};
  constexpr std::size_t kMostEdits = 6;
  for (std::size_t first = site.statement;
       frame && frame->is_frame && out.fix->edits.size() < kMostEdits;) {
    out.fix->edits.push_back({site.span(first, frame->brace), ""});
    out.fix->edits.push_back({site.span(site.closer(frame->brace)), ""});
    first = frame->brace + 1;
    frame = frame_at(site, first);
  }
  return out;
}

Answer written_as(const FailureSite& site, std::size_t i, std::string_view meant,
                  Confidence confidence) {
  Diagnostic out = make_diagnostic("E0130", site.span(i), {site.text(i), std::string(meant)});
  out.fix = Fix{"write " + std::string(meant), {{site.span(i), std::string(meant)}}, confidence};
  return out;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Explains the mistake: and, or, not, def, and keywords with capital letters.
Answer foreign_word(const FailureSite& site) {
  const auto known = [&](std::size_t i) -> Answer {
    if (i > site.at || site.type(i) != RbtLexer::ID) return std::nullopt;
    const std::string word = site.text(i);
    if (i == site.statement) {
      const std::string_view meant = meant_by(word, &ForeignWord::at_start);
      const bool typed = is_primitive_type(site.type(i + 1)) ||
                         (is_name(site.type(i + 1)) && is_name(site.type(i + 2)));
      if (word == "const" && typed) return written_as(site, i, "final", Confidence::kSure);
      if (!meant.empty()) return written_as(site, i, meant, Confidence::kMaybe);
    }
    const std::string_view meant = meant_by(word, &ForeignWord::inside);
    if (!meant.empty()) return written_as(site, i, meant, Confidence::kSure);
    const std::string lower = lower_case(word);
    const Word* ours = lower != word ? find_word(lower) : nullptr;
    return ours != nullptr && ours->kind != WordKind::kType
               ? written_as(site, i, lower, Confidence::kSure)
               : std::nullopt;
  };
  if (Answer out = known(site.at)) return out;
  if (site.at > site.statement) {
    if (Answer out = known(site.at - 1)) return out;
  }
  return known(site.statement);
}

// Explains the mistake: 0,5
Answer decimal_comma(const FailureSite& site) {
  const std::size_t comma = site.type(site.at) == RbtLexer::COMMA ? site.at : site.at - 1;
  if (comma == 0 || comma <= site.statement || site.type(comma) != RbtLexer::COMMA)
    return std::nullopt;
  if (site.type(comma - 1) != RbtLexer::INT || !is_number(site.type(comma + 1)))
    return std::nullopt;
  if (!site.touch(comma - 1, comma) || !site.touch(comma, comma + 1) || site.opener(comma))
    return std::nullopt;
  Diagnostic out = make_diagnostic("E0108", site.span(comma - 1, comma + 1));
  const std::string number = site.text(comma - 1) + '.' + site.text(comma + 1);
  out.fix = Fix{"write " + number, {{site.span(comma), "."}}, Confidence::kSure};
  return out;
}

// Explains the mistake: 2 s
Answer unit_apart(const FailureSite& site) {
  if (site.at <= site.statement || !is_name(site.type(site.at))) return std::nullopt;
  const std::uint16_t number = site.before();
  if ((number != RbtLexer::INT && number != RbtLexer::FLOAT) ||
      !site.on_one_line(site.at - 1, site.at)) {
    return std::nullopt;
  }
  if (unit_named(site.text(site.at)) == nullptr) return std::nullopt;
  std::size_t last = site.at;
  while ((site.type(last + 1) == RbtLexer::SLASH || site.type(last + 1) == RbtLexer::STAR) &&
         is_name(site.type(last + 2)) && site.touch(last, last + 1) &&
         unit_named(site.text(last + 2)) != nullptr) {
    last += 2;
  }
  Diagnostic out = make_diagnostic("E0102", site.span(site.at - 1, last));
  out.why = "with a space, `" + site.text(site.at) + "` is read as a separate name";
  const std::string together = site.text(site.at - 1) + site.text(site.at, last);
  out.fix = Fix{"write " + together, {{out.mark.span, together}}, Confidence::kSure};
  return out;
}

// Explains the mistake: x := 3
Answer colon_equals(const FailureSite& site) {
  const std::size_t colon = site.type(site.at) == RbtLexer::COLON ? site.at : site.at - 1;
  if (site.at == 0 || site.type(colon) != RbtLexer::COLON ||
      site.type(colon + 1) != RbtLexer::ASSIGN || !site.touch(colon, colon + 1)) {
    return std::nullopt;
  }
  Diagnostic out = make_diagnostic("E0119", site.span(colon, colon + 1));
  out.fix = Fix{"write =", {{out.mark.span, "="}}, Confidence::kSure};
  // A name that does not occur before is declared here.
  const bool alone = colon == site.statement + 1 && is_name(site.type(site.statement));
  if (!alone || site.occurs_before(site.statement)) return out;
  const std::uint32_t begin = site.span(site.statement).begin;
  out.fix->text = "write var " + site.text(site.statement) + " = ...";
  out.fix->edits.insert(out.fix->edits.begin(), {{begin, begin, out.mark.span.source}, "var "});
  return out;
}

// Explains the mistake: double[] q = (0.0, 0.5)
Answer round_list(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::COMMA || !open || site.type(*open) != RbtLexer::LPAREN ||
      *open == 0) {
    return std::nullopt;
  }
  if (site.is_call(*open) || is_header_word(site.type(*open - 1))) return std::nullopt;
  const std::size_t close = site.closer(*open);
  Diagnostic out = make_diagnostic("E0117", site.span(*open, close));
  const std::string inner = site.text(*open + 1, close - 1);
  const bool declares = site.type(*open - 1) == RbtLexer::ASSIGN;
  out.fix = Fix{(declares ? "write {" + inner + "} or [" : "write [") + inner + ']',
                {{site.span(*open), "["}, {site.span(close), "]"}},
                Confidence::kSure};
  return out;
}

// Explains the mistake: point({0.0, 0.5})
Answer braces_as_value(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::LBRACE || !open || site.type(*open) == RbtLexer::LBRACE) {
    return std::nullopt;
  }
  const std::uint16_t before = site.before();
  if (before != RbtLexer::LPAREN && before != RbtLexer::LBRACK && before != RbtLexer::COMMA &&
      before != RbtLexer::COLON) {
    return std::nullopt;
  }
  const std::size_t close = site.closer(site.at);
  Diagnostic out = make_diagnostic("E0128", site.span(site.at), {"{"});
  out.why = "braces make a list or a map only behind `=` and `new T[]`";
  if (site.at + 1 < close) {
    out.fix = Fix{"write [" + site.text(site.at + 1, close - 1) + ']',
                  {{site.span(site.at), "["}, {site.span(close), "]"}},
                  Confidence::kSure};
  }
  return out;
}

// Explains the mistake: run(p, time = 2s)
Answer setting_with_equals(const FailureSite& site) {
  const std::optional<std::size_t> open = site.opener(site.at);
  if (site.type(site.at) != RbtLexer::ASSIGN || !open || site.type(*open) != RbtLexer::LPAREN ||
      !site.is_call(*open) || !is_name(site.before())) {
    return std::nullopt;
  }
  Answer out = written_as(site, site.at, ":", Confidence::kSure);
  out->why = "the name of a setting is followed by a colon";
  out->fix->text = "write " + site.text(site.at - 1) + ": " + site.text(site.at + 1);
  out->fix->edits = {
      {{site.after(site.at - 1).begin, site.span(site.at).end, site.span(site.at).source}, ":"}};
  return out;
}

// Explains the mistake: print "hello"
Answer call_without_parentheses(const FailureSite& site) {
  if (site.at != site.statement + 1 || !is_name(site.type(site.statement)) ||
      !is_literal(site.type(site.at)) || !site.on_one_line(site.statement, site.at)) {
    return std::nullopt;
  }
  Diagnostic out = make_diagnostic("E0129", site.span(site.at), {"a pair of parentheses"});
  const std::string call = site.text(site.statement) + '(' + site.text(site.at) + ')';
  out.fix = Fix{"write " + call, {{site.span(site.statement, site.at), call}}, Confidence::kMaybe};
  return out;
}

// Explains the mistake: lambda x, y: x + y
Answer python_lambda(const FailureSite& site) {
  const std::size_t word = site.at - 1;
  if (site.at <= site.statement + 1 || site.text(word) != "lambda" || !is_name(site.type(site.at)))
    return std::nullopt;
  const bool declares = site.type(word - 1) == RbtLexer::ASSIGN;
  std::string meant = "fn(";
  std::size_t i = site.at;
  while (is_name(site.type(i))) {
    meant += (i > site.at ? ", " : "") + site.text(i) + (declares ? ": double" : "");
    i += site.type(i + 1) == RbtLexer::COMMA ? 2 : 1;
  }
  if (site.type(i) != RbtLexer::COLON) return std::nullopt;
  meant += ") =>";
  const Span mark = site.span(word, i);
  Diagnostic out = make_diagnostic("E0130", mark, {site.text(word, i), meant});
  out.fix = Fix{"write " + meant, {{mark, meant}}, Confidence::kSure};
  return out;
}

// Explains the mistake: f'{x}' and f"{"x"}"
Answer quotes_of_a_format(const FailureSite& site) {
  if (site.at <= site.statement || !site.touch(site.at - 1, site.at)) return std::nullopt;
  const Span here = site.span(site.at);
  if (site.text(site.at - 1) == "f" && site.type(site.at) == RbtLexer::STRING) {
    const std::string inner = site.text(site.at);
    const std::string meant = "f\"" + inner.substr(1, inner.size() - 2) + '"';
    const Span mark = site.span(site.at - 1, site.at);
    Diagnostic out = make_diagnostic("E0130", mark, {site.text(site.at - 1, site.at), meant});
    out.why = "a text with values in it stands between double quotes";
    out.fix = Fix{"write " + meant, {{mark, meant}}, Confidence::kSure};
    return out;
  }
  if (site.before() != RbtLexer::FSTRING || !is_name(site.type(site.at))) return std::nullopt;
  const std::size_t next = site.at + 1;
  const bool goes_on = site.type(next) == RbtLexer::STRING && site.touch(site.at, next);
  if (!goes_on || !site.text(next).starts_with('"')) return std::nullopt;
  const std::uint32_t open = here.begin - 1;
  Diagnostic out =
      make_diagnostic("E0130", {open, here.end + 1, here.source},
                      {'"' + site.text(site.at) + '"', '\'' + site.text(site.at) + '\''});
  out.why = "a double quote ends the text that begins with f\"";
  out.fix =
      Fix{"write '" + site.text(site.at) + '\'',
          {{{open, here.begin, here.source}, "'"}, {{here.end, here.end + 1, here.source}, "'"}},
          Confidence::kSure};
  return out;
}

// Explains the mistake: sin x
Answer function_without_parentheses(const FailureSite& site) {
  constexpr std::array<std::string_view, 13> kFunctions = {"sin",   "cos",  "tan",  "asin", "acos",
                                                           "atan",  "sqrt", "abs",  "exp",  "log",
                                                           "floor", "ceil", "round"};
  if (site.at <= site.statement || !site.on_one_line(site.at - 1, site.at)) return std::nullopt;
  const std::string function = site.text(site.at - 1);
  const bool is_value = is_name(site.type(site.at)) || is_number(site.type(site.at));
  if (!is_value || std::ranges::find(kFunctions, function) == kFunctions.end()) return std::nullopt;
  Diagnostic out = make_diagnostic("E0129", site.span(site.at), {"a pair of parentheses"});
  const std::string call = function + '(' + site.text(site.at) + ')';
  out.fix = Fix{"write " + call, {{site.span(site.at - 1, site.at), call}}, Confidence::kMaybe};
  return out;
}

// Explains the mistake: 1.5.5
Answer two_decimal_points(const FailureSite& site) {
  if (site.at <= site.statement || !site.touch(site.at - 1, site.at)) return std::nullopt;
  if (!is_number(site.before()) || !is_number(site.type(site.at)) ||
      !site.text(site.at).starts_with('.'))
    return std::nullopt;
  const Span mark = site.span(site.at - 1, site.at);
  Diagnostic out = make_diagnostic("E0103", mark, {site.text(site.at - 1, site.at)});
  out.why = "a number has one decimal point";
  return out;
}

}  // namespace

std::optional<Diagnostic> explain_habit(const FailureSite& site) {
  for (const auto explain :
       {java_frame, colon_equals, unit_apart, decimal_comma, python_lambda, quotes_of_a_format,
        two_decimal_points, function_without_parentheses, foreign_word, round_list, braces_as_value,
        setting_with_equals, call_without_parentheses}) {
    if (Answer out = explain(site)) return out;
  }
  return std::nullopt;
}

}  // namespace armlet::lang
