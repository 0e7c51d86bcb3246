// grammar/table_reader.hpp against ANTLR's own reader, for both tables.

#include <doctest/doctest.h>

#undef WHEN  // of doctest; the parser has a function of that name
#include <RbtLexer.h>
#include <RbtParser.h>

#include <sstream>
#include <table_reader.hpp>

namespace {

using namespace antlr4;
using namespace antlr4::atn;

void describe(std::ostream& out, const ATNState* state) {
  if (state == nullptr) {
    out << " -";
  } else {
    out << ' ' << state->stateNumber;
  }
}

void describe(std::ostream& out, Transition& transition) {
  out << "\n  " << transition.getSerializationType() << ' ' << transition.label().toString();
  describe(out, transition.target);
  if (const auto* call = dynamic_cast<RuleTransition*>(&transition)) {
    out << " rule " << call->ruleIndex << ' ' << call->precedence;
    describe(out, call->followState);
  } else if (auto* empty = dynamic_cast<EpsilonTransition*>(&transition)) {
    out << " returns " << empty->outermostPrecedenceReturn();
  } else if (const auto* action = dynamic_cast<ActionTransition*>(&transition)) {
    out << " action " << action->ruleIndex << ' ' << action->actionIndex;
  } else if (const auto* guard = dynamic_cast<PrecedencePredicateTransition*>(&transition)) {
    out << " precedence " << guard->precedence;
  }
}

// Everything that depends on the class of a state.
void describe_own(std::ostream& out, ATNState* state) {
  if (const auto* end = dynamic_cast<LoopEndState*>(state)) describe(out, end->loopBackState);
  if (const auto* end = dynamic_cast<BlockEndState*>(state)) describe(out, end->startState);
  if (const auto* start = dynamic_cast<BlockStartState*>(state)) describe(out, start->endState);
  if (const auto* start = dynamic_cast<PlusBlockStartState*>(state)) {
    describe(out, start->loopBackState);
  }
  if (const auto* start = dynamic_cast<RuleStartState*>(state)) {
    describe(out, start->stopState);
    out << (start->isLeftRecursiveRule ? " left-recursive" : "");
  }
  if (const auto* entry = dynamic_cast<StarLoopEntryState*>(state)) {
    describe(out, entry->loopBackState);
    out << (entry->isPrecedenceDecision ? " precedence" : "");
  }
  if (const auto* decision = dynamic_cast<DecisionState*>(state)) {
    out << " decision " << decision->decision << (decision->nonGreedy ? " lazy" : "");
  }
}

std::string described(const ATN& atn) {
  std::ostringstream out;
  out << static_cast<int>(atn.grammarType) << ' ' << atn.maxTokenType;
  for (ATNState* state : atn.states) {
    describe(out << '\n', state);
    if (state == nullptr) continue;
    out << " type " << state->getStateType() << " of " << state->ruleIndex
        << (state->epsilonOnlyTransitions ? " empty" : "");
    describe_own(out, state);
    for (Transition* transition : state->transitions) describe(out, *transition);
  }
  out << "\ndecisions";
  for (const ATNState* state : atn.decisionToState) describe(out, state);
  out << "\nrules";
  for (const ATNState* state : atn.ruleToStartState) describe(out, state);
  for (const ATNState* state : atn.ruleToStopState) describe(out, state);
  for (const std::size_t type : atn.ruleToTokenType) out << ' ' << type;
  out << "\nmodes";
  for (const ATNState* state : atn.modeToStartState) describe(out, state);
  for (const auto& action : atn.lexerActions) out << '\n' << action->toString();
  return out.str();
}

// The generated classes keep their tables to themselves; naming a member in an explicit
// instantiation is allowed all the same.
using Table = std::vector<std::uint16_t>;
template <class Tag, Table* kTable>
struct Reveal {
  friend const Table& table_of(Tag) { return *kTable; }
};
struct OfParser {
  friend const Table& table_of(OfParser);
};
struct OfLexer {
  friend const Table& table_of(OfLexer);
};
template struct Reveal<OfParser, &RbtParser::_serializedATN>;
template struct Reveal<OfLexer, &RbtLexer::_serializedATN>;

void check_same(const std::vector<std::uint16_t>& table) {
  const std::string ours = described(TableReader().deserialize(table));
  CHECK(ours.size() > 10'000);
  CHECK(ours == described(ATNDeserializer().deserialize(table)));
}

TEST_CASE("our reader of the parser's and the lexer's tables finds what ANTLR's own reader finds") {
  RbtParser::prepare();
  RbtLexer::prepare();
  check_same(table_of(OfParser()));
  check_same(table_of(OfLexer()));
}

TEST_CASE("a table of another format is refused") {
  CHECK_THROWS_AS((void)TableReader().deserialize(std::vector<std::uint16_t>(20, 3)),
                  std::logic_error);
}

}  // namespace
