// Explains statements inside blocks that contain rows: record run every (10ms) { print(1) }
#include <fmt/format.h>

#include "syntax/mistakes/failure_site.hpp"

namespace armlet::lang {
namespace {

// The word that declares the block which token `brace` opens, "record" for a recording; empty if
// the block contains statements or values.
std::string word_of_rows(const FailureSite& site, std::size_t brace) {
  if (site.type(brace) != RbtLexer::LBRACE || brace < site.statement + 2) return {};
  if (site.type(brace - 1) == RbtLexer::RPAREN) {
    const std::size_t open = site.opener_of(brace - 1);
    const bool is_record = open >= site.statement + 3 && site.type(open - 1) == RbtLexer::EVERY &&
                           site.type(open - 3) == RbtLexer::RECORD;
    return is_record ? "record" : "";
  }
  return is_name(site.type(brace - 1)) && is_name(site.type(brace - 2)) ? site.text(brace - 2) : "";
}

// The first token of the row with token `i`.
std::size_t row_start(const FailureSite& site, std::size_t brace, std::size_t i) {
  while (i > brace + 1) {
    const std::uint16_t before = site.type(i - 1);
    if (before == RbtLexer::SEMI || before == RbtLexer::COMMA) return i;
    i = is_closer(before) ? site.opener_of(i - 1) : i - 1;
  }
  return i;
}

}  // namespace

std::optional<Diagnostic> explain_row(const FailureSite& site) {
  const std::optional<std::size_t> brace = site.opener(site.at);
  if (!brace) return std::nullopt;
  const std::string word = word_of_rows(site, *brace);
  if (word.empty()) return std::nullopt;
  const std::size_t first = row_start(site, *brace, site.at);
  const std::uint16_t second = site.type(first + 1);
  const bool is_value =
      first < site.at && is_name(site.type(first)) && !is_name(second) && second != RbtLexer::COLON;
  if (!is_value && !word_of(site.type(first)).starts) return std::nullopt;
  const bool is_record = word == "record";
  const bool lacks_name =
      !is_record && is_name(site.type(first)) &&
      (second == RbtLexer::LPAREN || second == RbtLexer::LBRACE || second == RbtLexer::ASSIGN);
  Diagnostic out = make_diagnostic("E0128", site.span(first), {site.text(first)});
  out.mark.label = "a row begins here";
  out.why = "a block of `" + word + "` holds rows, `name: value`" +
            (is_record ? "; it goes on recording until the block around it ends" : "");
  if (lacks_name) {
    out.why += fmt::format(", or `{} NAME(...)` with a word and a name", site.text(first));
    out.fix = Fix{
        "give the row a name, or put what is to be done behind the block", {}, Confidence::kMaybe};
    return out;
  }
  out.fix = Fix{is_record && is_value
                    ? "write `name: ` before a value; put what is to be done behind the block"
                    : "put what is to be done behind the block",
                {},
                Confidence::kMaybe};
  return out;
}

}  // namespace armlet::lang
