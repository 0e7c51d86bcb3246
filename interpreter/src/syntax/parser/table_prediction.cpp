#include "syntax/parser/table_prediction.hpp"

#include <RbtParser.h>
#include <RbtTables.h>

#include <algorithm>
#include <iterator>
#include <span>

#include "armlet/core/fork_lock.hpp"

namespace armlet::lang {
namespace {

using namespace rbt_tables;

constexpr std::size_t kUnknown = 0;

std::span<const DecisionEdge> edges_of(std::size_t state) {
  const std::span<const DecisionEdge> all = kDecisionEdges;
  return all.subspan(kFirstEdge[state], kFirstEdge[state + 1] - kFirstEdge[state]);
}

std::size_t next(std::size_t state, std::size_t token) {
  const std::size_t kind = token == antlr4::Token::EOF ? kEnd : token;
  const auto edges = edges_of(state);
  const auto edge = std::ranges::lower_bound(edges, kind, {}, &DecisionEdge::last);
  return edge == edges.end() || kind < edge->first ? kUnknown : edge->to;
}

std::size_t start_of(std::size_t decision, int precedence) {
  if (decision != kPrecedenceDecision) return kDecisionStart[decision];
  const auto level = static_cast<std::size_t>(precedence);
  return level < std::size(kPrecedenceStart) ? kPrecedenceStart[level] : kUnknown;
}

}  // namespace

std::size_t TablePrediction::adaptivePredict(antlr4::TokenStream* input, std::size_t decision,
                                             antlr4::ParserRuleContext* outer) {
  const std::size_t alternative = from_tables(*input, decision);
  if (alternative != kUnknown) return alternative;
  // All parsers share ANTLR's automaton of the grammar, which grows during predictions.
  const auto lock = lock_over_forks();
  RbtParser::prepare();
  return ParserATNSimulator::adaptivePredict(input, decision, outer);
}

std::size_t TablePrediction::from_tables(antlr4::TokenStream& input, std::size_t decision) const {
  const int precedence = parser->getPrecedence();
  std::size_t state = start_of(decision, precedence);
  for (ssize_t ahead = 1; state != kUnknown; ++ahead) {
    state = next(state, input.LA(ahead));
    if (state < kAccepts) continue;
    const std::size_t least = state / 256 % 128;
    return least == 0 || precedence <= static_cast<int>(least) ? state % 256 : kUnknown;
  }
  return kUnknown;
}

bool may_stand_in_block(std::size_t kind) {
  return std::ranges::find(kStartsInBlock, kind) != std::end(kStartsInBlock);
}

}  // namespace armlet::lang
