#pragma once
// Statements that are being typed: what is missing is put in, so that the rest can be read.
//
// A greedy form of the repair by trial of Burke and Fisher, "A practical method for LR and LL
// syntactic error diagnosis and recovery", TOPLAS 9, 1987: at the first token that cannot follow,
// the insertion is chosen with which reading comes furthest. What is put in for a name is an
// identifier without text, which stands at the end of the token before it.

#include <functional>
#include <optional>

#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// Where reading a list of statements stops for the first time.
struct ParseFailure {
  std::size_t statement;  // the first token of the innermost statement
  std::size_t at;         // the token that cannot follow
};
// Reads tokens that end with kEndOfText; empty if they are statements.
using TryToRead = std::function<std::optional<ParseFailure>(const Tokens&)>;

// The statement with what is missing; an innermost statement that cannot be mended is left out.
// Empty if nothing of it can be read. The number of trials is bounded.
//
// tokens  of one statement at the top level, with kEndOfText behind them; brackets match.
[[nodiscard]] std::optional<Tokens> mended(Tokens tokens, const TryToRead& read);

}  // namespace armlet::lang
