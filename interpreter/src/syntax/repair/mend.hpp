#pragma once
// Repairs incomplete statements by inserting missing tokens, so that the rest can be parsed.
//
// A greedy form of the repair by trial of Burke and Fisher, "A practical method for LR and LL
// syntactic error diagnosis and recovery", TOPLAS 9, 1987: at the first token that cannot follow,
// the insertion is selected with which the parser reaches the furthest token. An inserted name is
// an identifier without text at the end of the token before it.

#include <functional>
#include <optional>

#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The first position where the parser cannot continue in a list of statements.
struct ParseFailure {
  std::size_t statement;  // the first token of the innermost statement
  std::size_t at;         // the token that cannot follow
};
// Parses tokens that end with kEndOfText; empty if they are valid statements.
using TryToRead = std::function<std::optional<ParseFailure>(const Tokens&)>;

// The statement with its missing tokens inserted. An inner statement that cannot be repaired is
// omitted. Empty if no part of the statement can be parsed. The number of trials is limited.
//
// tokens  of one statement at the top level, followed by kEndOfText; brackets match.
[[nodiscard]] std::optional<Tokens> mended(Tokens tokens, const TryToRead& read);

}  // namespace armlet::lang
