#include "table_reader.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace {

using namespace antlr4;
using namespace antlr4::atn;
using misc::IntervalSet;

// The beginning of a table: the version of the format and its identity,
// 59627784-3BE5-417A-B9EB-8131A7286089.
constexpr std::uint16_t kFormat[] = {0x0003, 0x608b, 0xa72a, 0x8133, 0xb9ed,
                                     0x417c, 0x3be7, 0x7786, 0x5964};
constexpr std::size_t kNone = 0xFFFF;

bool is(ATNState* state, std::size_t type) {
  return state != nullptr && state->getStateType() == type;
}

bool is_block_start(std::size_t type) {
  return type == ATNState::BLOCK_START || type == ATNState::PLUS_BLOCK_START ||
         type == ATNState::STAR_BLOCK_START;
}

// Reads the words of a table in their order. All but the first are stored with 2 added.
class Words {
 public:
  explicit Words(const std::vector<std::uint16_t>& table) : at_(table.data() + std::size(kFormat)) {
    if (!std::equal(std::begin(kFormat), std::end(kFormat), table.data())) {
      throw std::logic_error("the tables in grammar/generated have another format");
    }
  }
  std::size_t next() { return static_cast<std::uint16_t>(*at_++ - 2); }
  std::size_t next_or(std::size_t none) {
    const std::size_t word = next();
    return word == kNone ? none : word;
  }

 private:
  const std::uint16_t* at_;
};

void read_states(Words& words, ATN& atn) {
  std::vector<std::pair<ATNState*, std::size_t>> partners;
  const std::size_t count = words.next();
  atn.states.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t type = words.next();
    if (type == ATNState::ATN_INVALID_TYPE) {
      atn.addState(nullptr);
      continue;
    }
    const std::size_t rule = words.next_or(INVALID_INDEX);
    ATNState* state = ATNDeserializer::stateFactory(type, rule);
    if (type == ATNState::LOOP_END || is_block_start(type)) {
      partners.emplace_back(state, words.next());
    }
    atn.addState(state);
  }
  for (const auto& [state, partner] : partners) {
    if (is(state, ATNState::LOOP_END)) {
      static_cast<LoopEndState*>(state)->loopBackState = atn.states[partner];
    } else {
      auto* start = static_cast<BlockStartState*>(state);
      start->endState = static_cast<BlockEndState*>(atn.states[partner]);
      start->endState->startState = start;
    }
  }
  for (std::size_t n = words.next(); n > 0; --n) {
    static_cast<DecisionState*>(atn.states[words.next()])->nonGreedy = true;
  }
  for (std::size_t n = words.next(); n > 0; --n) {
    static_cast<RuleStartState*>(atn.states[words.next()])->isLeftRecursiveRule = true;
  }
}

void read_rules(Words& words, ATN& atn) {
  const std::size_t count = words.next();
  for (std::size_t i = 0; i < count; ++i) {
    atn.ruleToStartState.push_back(static_cast<RuleStartState*>(atn.states[words.next()]));
    if (atn.grammarType == ATNType::LEXER) {
      atn.ruleToTokenType.push_back(words.next_or(Token::EOF));
    }
  }
  atn.ruleToStopState.resize(count);
  for (ATNState* state : atn.states) {
    if (!is(state, ATNState::RULE_STOP)) continue;
    auto* stop = static_cast<RuleStopState*>(state);
    atn.ruleToStopState[state->ruleIndex] = stop;
    atn.ruleToStartState[state->ruleIndex]->stopState = stop;
  }
  for (std::size_t n = words.next(); n > 0; --n) {
    atn.modeToStartState.push_back(static_cast<TokensStartState*>(atn.states[words.next()]));
  }
}

// `wide`: characters consist of two words.
void read_sets(Words& words, bool wide, std::vector<IntervalSet>& sets) {
  const auto character = [&words, wide] {
    const std::size_t low = words.next();
    return static_cast<ssize_t>(wide ? low | words.next() << 16U : low);
  };
  for (std::size_t n = words.next(); n > 0; --n) {
    const std::size_t intervals = words.next();
    IntervalSet& set = sets.emplace_back();
    if (words.next() != 0) set.add(-1);  // the end of the text
    for (std::size_t i = 0; i < intervals; ++i) {
      const ssize_t first = character();
      const ssize_t last = character();
      set.add(first, last);
    }
  }
}

void read_edges(Words& words, ATN& atn) {
  std::vector<IntervalSet> sets;
  read_sets(words, false, sets);
  read_sets(words, true, sets);
  for (std::size_t n = words.next(); n > 0; --n) {
    const std::size_t from = words.next();
    const std::size_t to = words.next();
    const std::size_t type = words.next();
    const std::size_t a = words.next();
    const std::size_t b = words.next();
    const std::size_t c = words.next();
    atn.states[from]->addTransition(
        ATNDeserializer::edgeFactory(atn, type, from, to, a, b, c, sets));
  }
}

// After the end of a rule, prediction continues after each call of the rule.
void add_returns(ATN& atn) {
  for (ATNState* state : atn.states) {
    for (Transition* transition : state->transitions) {
      if (transition->getSerializationType() != Transition::RULE) continue;
      const auto* call = static_cast<RuleTransition*>(transition);
      const std::size_t rule = call->target->ruleIndex;
      const bool leaves_recursion =
          atn.ruleToStartState[rule]->isLeftRecursiveRule && call->precedence == 0;
      atn.ruleToStopState[rule]->addTransition(
          new EpsilonTransition(call->followState, leaves_recursion ? rule : INVALID_INDEX));
    }
  }
}

void connect_loops(ATN& atn) {
  for (ATNState* state : atn.states) {
    const bool plus = is(state, ATNState::PLUS_LOOP_BACK);
    if (!plus && !is(state, ATNState::STAR_LOOP_BACK)) continue;
    for (const Transition* transition : state->transitions) {
      ATNState* to = transition->target;
      if (plus && is(to, ATNState::PLUS_BLOCK_START)) {
        static_cast<PlusBlockStartState*>(to)->loopBackState =
            static_cast<PlusLoopbackState*>(state);
      } else if (!plus && is(to, ATNState::STAR_LOOP_ENTRY)) {
        static_cast<StarLoopEntryState*>(to)->loopBackState =
            static_cast<StarLoopbackState*>(state);
      }
    }
  }
}

// Marks the decisions in left-recursive rules whether another operator follows.
void mark_precedence_decisions(ATN& atn) {
  for (ATNState* state : atn.states) {
    if (!is(state, ATNState::STAR_LOOP_ENTRY)) continue;
    if (!atn.ruleToStartState[state->ruleIndex]->isLeftRecursiveRule) continue;
    ATNState* end = state->transitions.back()->target;
    static_cast<StarLoopEntryState*>(state)->isPrecedenceDecision =
        is(end, ATNState::LOOP_END) && end->epsilonOnlyTransitions &&
        is(end->transitions[0]->target, ATNState::RULE_STOP);
  }
}

void read_decisions(Words& words, ATN& atn) {
  for (std::size_t n = words.next(); n > 0; --n) {
    auto* state = static_cast<DecisionState*>(atn.states[words.next()]);
    state->decision = static_cast<int>(atn.decisionToState.size());
    atn.decisionToState.push_back(state);
  }
}

}  // namespace

ATN TableReader::deserialize(const std::vector<std::uint16_t>& table) {
  Words words(table);
  const auto type = static_cast<ATNType>(words.next());
  ATN atn(type, words.next());
  read_states(words, atn);
  read_rules(words, atn);
  read_edges(words, atn);
  add_returns(atn);
  connect_loops(atn);
  read_decisions(words, atn);
  if (type == ATNType::LEXER) {
    for (std::size_t n = words.next(); n > 0; --n) {
      const auto action = static_cast<LexerActionType>(words.next());
      const int first = static_cast<int>(words.next_or(static_cast<std::size_t>(-1)));
      const int second = static_cast<int>(words.next_or(static_cast<std::size_t>(-1)));
      atn.lexerActions.push_back(lexerActionFactory(action, first, second));
    }
  }
  mark_precedence_decisions(atn);
  return atn;
}
