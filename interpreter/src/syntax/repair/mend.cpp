#include "syntax/repair/mend.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <utility>
#include <vector>

#include "syntax/mistakes/recovery.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

// The limit of inner statements that are repaired in one statement, and of insertions into each.
constexpr int kMostMistakes = 8;
constexpr int kMostInsertions = 6;

// The token sequences that may be missing, the most likely first. kName stands for a name, a value
// or a type.
constexpr std::uint16_t kName = RbtLexer::ID;
constexpr std::size_t kLongest = 6;
using MissingTokens = std::array<std::uint16_t, kLongest>;  // zeros fill the end
constexpr MissingTokens kMissing[] = {
    {kName},
    {RbtLexer::SEMI},
    {kName, RbtLexer::SEMI},
    {RbtLexer::LBRACE, RbtLexer::RBRACE},
    {RbtLexer::COLON, kName},
    {RbtLexer::COLON, kName, RbtLexer::SEMI},
    {kName, RbtLexer::COLON, kName},
    {kName, RbtLexer::COLON, kName, RbtLexer::SEMI},
    {RbtLexer::COLON},
    {kName, RbtLexer::COLON},
    {RbtLexer::ASSIGN, kName, RbtLexer::SEMI},
    {kName, RbtLexer::ASSIGN, kName, RbtLexer::SEMI},
    {RbtLexer::IN, kName},
    {kName, RbtLexer::IN, kName},
    {RbtLexer::LPAREN, kName, RbtLexer::RPAREN},
    {RbtLexer::LPAREN, kName, RbtLexer::RPAREN, RbtLexer::LBRACE, RbtLexer::RBRACE},
    {RbtLexer::LPAREN, RbtLexer::RPAREN, RbtLexer::LBRACE, RbtLexer::RBRACE},
    {kName, RbtLexer::LPAREN, RbtLexer::RPAREN, RbtLexer::LBRACE, RbtLexer::RBRACE},
    {kName, RbtLexer::LBRACE, RbtLexer::RBRACE},
    {RbtLexer::LPAREN, RbtLexer::RPAREN, RbtLexer::SEMI},
    {kName, RbtLexer::LPAREN, RbtLexer::RPAREN, RbtLexer::SEMI},
    {RbtLexer::LBRACE, kName, RbtLexer::RBRACE},
    {kName, RbtLexer::LBRACE, kName, RbtLexer::RBRACE},
    {RbtLexer::FATARROW, kName},
    {RbtLexer::FATARROW, kName, RbtLexer::SEMI},
    {RbtLexer::ARROW, kName},
    {RbtLexer::WHILE, RbtLexer::LPAREN, kName, RbtLexer::RPAREN, RbtLexer::SEMI},
    {RbtLexer::LBRACE, RbtLexer::RBRACE, RbtLexer::WHILE, RbtLexer::LPAREN, kName,
     RbtLexer::RPAREN},
    {RbtLexer::SEMI, RbtLexer::SEMI},
    {kName, RbtLexer::SEMI, kName, RbtLexer::SEMI},
    {RbtLexer::EVERY, RbtLexer::LPAREN, kName, RbtLexer::RPAREN, RbtLexer::LBRACE,
     RbtLexer::RBRACE},
};

std::ptrdiff_t signed_index(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

Tokens with_insertion(const Tokens& tokens, std::size_t at, const MissingTokens& kinds) {
  Tokens out;
  out.reserve(tokens.size() + kLongest);
  out.insert(out.end(), tokens.begin(), tokens.begin() + signed_index(at));
  const std::uint32_t place = at > 0 ? tokens[at - 1].end : tokens[at].begin;
  for (const std::uint16_t kind : kinds) {
    if (kind != 0) out.push_back({.begin = place, .end = place, .type = kind, .inserted = true});
  }
  out.insert(out.end(), tokens.begin() + signed_index(at), tokens.end());
  return out;
}

// Repairs a list of statements where the parser stops; empty if the repair fails.
std::optional<Tokens> with_what_is_missing(Tokens tokens, const TryToRead& read) {
  for (int i = 0; i < kMostInsertions; ++i) {
    const std::optional<ParseFailure> failure = read(tokens);
    if (!failure) return tokens;
    std::optional<Tokens> best;
    std::size_t furthest = failure->at;
    for (const MissingTokens& kinds : kMissing) {
      Tokens trial = with_insertion(tokens, failure->at, kinds);
      const std::optional<ParseFailure> next = read(trial);
      if (!next) return trial;
      const std::size_t inserted = trial.size() - tokens.size();
      if (next->at <= furthest + inserted) continue;
      furthest = next->at - inserted;
      best = std::move(trial);
    }
    if (!best) return std::nullopt;
    tokens = *std::move(best);
  }
  return std::nullopt;
}

Tokens part_of(const Tokens& tokens, std::size_t first, std::size_t last) {
  Tokens out(tokens.begin() + signed_index(first), tokens.begin() + signed_index(last));
  const std::uint32_t end = last > first ? tokens[last - 1].end : tokens[first].begin;
  out.push_back({.begin = end, .end = end, .type = kEndOfText, .line_break_before = true});
  return out;
}

}  // namespace

std::optional<Tokens> mended(Tokens tokens, const TryToRead& read) {
  for (int i = 0; i < kMostMistakes; ++i) {
    const std::optional<ParseFailure> failure = read(tokens);
    if (!failure) return tokens;
    const std::size_t first = failure->statement;
    const std::size_t last = next_statement(tokens, first, failure->at);
    std::optional<Tokens> whole = with_what_is_missing(part_of(tokens, first, last), read);
    if (!whole && (last <= first || (first == 0 && last + 1 >= tokens.size()))) return std::nullopt;
    if (whole) {
      whole->pop_back();
    } else {
      const std::uint32_t place = tokens[first].begin;
      whole = Tokens{{.begin = place, .end = place, .type = RbtLexer::SEMI, .inserted = true}};
    }
    whole->insert(whole->begin(), tokens.begin(), tokens.begin() + signed_index(first));
    whole->insert(whole->end(), tokens.begin() + signed_index(last), tokens.end());
    tokens = *std::move(whole);
  }
  return read(tokens) ? std::nullopt : std::optional(std::move(tokens));
}

}  // namespace armlet::lang
