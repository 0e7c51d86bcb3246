// Writes generated/RbtTables.h: the automata of the generated lexer and parser, made in advance. At
// run time ANTLR would interpret the grammar and build the automata from the texts that it has
// seen. This program lets ANTLR build them, so that a short program needs neither the grammar nor
// the automata.
//
// usage: make_tables > grammar/generated/RbtTables.h

#include <antlr4-runtime.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "RbtLexer.h"
#include "RbtParser.h"

namespace {

using namespace antlr4;
using namespace antlr4::atn;
using dfa::DFAState;

// The width of a line of numbers, characters.
constexpr std::size_t kLineWidth = 100;

void print_list(const char* type, const std::string& name, const std::vector<std::string>& items) {
  std::printf("inline constexpr %s %s[] = {\n", type, name.c_str());
  std::string line = "   ";
  for (const std::string& item : items) {
    if (line.size() + item.size() + 2 > kLineWidth) {
      std::printf("%s\n", line.c_str());
      line = "   ";
    }
    line += " " + item + ",";
  }
  std::printf("%s\n};\n\n", line.c_str());
}

template <class Number>
void print_numbers(const char* type, const std::string& name, const std::vector<Number>& numbers) {
  std::vector<std::string> items;
  for (const Number number : numbers) items.push_back(std::to_string(number));
  print_list(type, name, items);
}

// ---------------------------------------------------------------- the lexer

// Makes protected members of the simulator accessible.
class LexerAutomaton : public LexerATNSimulator {
 public:
  using LexerATNSimulator::LexerATNSimulator;

  DFAState* start() {
    return addDFAState(computeStartState(&nothing_, atn.modeToStartState[0]).release());
  }
  DFAState* next(DFAState* from, std::size_t character) {
    auto reached = std::make_unique<OrderedATNConfigSet>();
    getReachableConfigSet(&nothing_, from->configs.get(), reached.get(), character);
    return reached->isEmpty() ? nullptr : addDFAState(reached.release());
  }

 private:
  ANTLRInputStream nothing_{""};
};

constexpr std::size_t kCharacters = 0x110000;
constexpr std::size_t kAscii = 128;

// The first characters of the character intervals that the grammar distinguishes.
std::vector<std::size_t> intervals_of(const ATN& atn) {
  std::set<std::size_t> firsts{0};
  for (const ATNState* state : atn.states) {
    if (state == nullptr) continue;
    for (const Transition* transition : state->transitions) {
      const misc::IntervalSet label = transition->label();
      for (const misc::Interval& interval : label.getIntervals()) {
        if (interval.b < 0) continue;
        firsts.insert(static_cast<std::size_t>(std::max<ssize_t>(interval.a, 0)));
        firsts.insert(static_cast<std::size_t>(interval.b) + 1);
      }
    }
  }
  firsts.erase(firsts.lower_bound(kCharacters), firsts.end());
  return {firsts.begin(), firsts.end()};
}

// Transitions by state and character interval. State 0 has no transitions, state 1 is the first.
struct LexerTable {
  std::vector<std::size_t> firsts;  // of the character intervals
  std::vector<std::vector<std::size_t>> next{std::vector<std::size_t>(firsts.size())};
  std::vector<std::size_t> token{0};  // the token that ends in the state

  explicit LexerTable(const ATN& atn) : firsts(intervals_of(atn)) {
    std::vector<dfa::DFA> automata;
    automata.emplace_back(atn.getDecisionState(0), 0);
    PredictionContextCache cache;
    LexerAutomaton automaton(atn, automata, cache);
    std::vector<DFAState*> states{automaton.start()};
    std::map<DFAState*, std::size_t> numbers{{states[0], 1}};
    for (std::size_t i = 0; i < states.size(); ++i) {
      std::vector<std::size_t>& row = next.emplace_back();
      for (const std::size_t first : firsts) {
        DFAState* to = automaton.next(states[i], first);
        if (to != nullptr && numbers.emplace(to, states.size() + 1).second) states.push_back(to);
        row.push_back(to == nullptr ? 0 : numbers[to]);
      }
      token.push_back(states[i]->isAcceptState ? states[i]->prediction : 0);
    }
  }

  std::size_t interval_of(std::size_t character) const {
    const auto after = std::upper_bound(firsts.begin(), firsts.end(), character);
    return static_cast<std::size_t>(after - firsts.begin()) - 1;
  }
};

void write_lexer() {
  ANTLRInputStream text("");
  RbtLexer lexer(&text);
  const LexerTable table(lexer.getATN());
  const std::vector<std::size_t>& firsts = table.firsts;
  std::map<std::vector<std::size_t>, std::size_t> classes;
  std::vector<std::size_t> class_of;  // by interval
  std::vector<std::vector<std::size_t>> columns;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    std::vector<std::size_t> column;
    for (const auto& row : table.next) column.push_back(row[i]);
    const auto [found, added] = classes.emplace(column, classes.size());
    if (added) columns.push_back(column);
    class_of.push_back(found->second);
  }
  std::vector<std::size_t> ascii;
  for (std::size_t c = 0; c < kAscii; ++c) ascii.push_back(class_of[table.interval_of(c)]);
  std::vector<std::string> ranges;
  for (std::size_t i = 0; i < firsts.size(); ++i) {
    const bool is_last = i + 1 == firsts.size();
    const std::size_t end = is_last ? kCharacters : firsts[i + 1];
    if (end <= kAscii || (!is_last && class_of[i] == class_of[i + 1])) continue;
    ranges.push_back("{" + std::to_string(end) + ", " + std::to_string(class_of[i]) + "}");
  }
  std::vector<std::size_t> next;
  for (std::size_t state = 0; state < table.next.size(); ++state) {
    for (const auto& column : columns) next.push_back(column[state]);
  }
  std::printf("// Characters of one class lead from every state to the same one.\n");
  std::printf("inline constexpr std::size_t kCharacterClasses = %zu;\n\n", columns.size());
  print_numbers("std::uint8_t", "kAsciiClass", ascii);
  std::printf("// The others, by the first character behind each range.\n");
  print_list("CharacterRange", "kCharacterRanges", ranges);
  std::printf("// By state and class; 0: no token goes on like this. The first state is 1.\n");
  print_numbers("std::uint16_t", "kNextLexerState", next);
  std::printf("// The kind of token that ends in the state; 0: none.\n");
  print_numbers("std::uint8_t", "kTokenOfState", table.token);
}

// ---------------------------------------------------------------- the parser

// A stream of tokens given by their kinds.
class Kinds : public TokenStream {
 public:
  explicit Kinds(std::vector<std::size_t> kinds = {}) : kinds_(std::move(kinds)), token_(1) {}
  std::size_t LA(ssize_t i) override {
    const std::size_t at = at_ + static_cast<std::size_t>(i) - 1;
    return at < kinds_.size() ? kinds_[at] : Token::EOF;
  }
  void consume() override { at_ = std::min(at_ + 1, kinds_.size()); }
  ssize_t mark() override { return 0; }
  void release(ssize_t) override {}
  std::size_t index() override { return at_; }
  void seek(std::size_t index) override { at_ = index; }
  std::size_t size() override { return kinds_.size(); }
  std::string getSourceName() const override { return {}; }
  Token* LT(ssize_t) override { return &token_; }
  Token* get(std::size_t) const override { return nullptr; }
  TokenSource* getTokenSource() const override { return nullptr; }
  std::string getText(const misc::Interval&) override { return {}; }
  std::string getText() override { return {}; }
  std::string getText(RuleContext*) override { return {}; }
  std::string getText(Token*, Token*) override { return {}; }

 private:
  std::vector<std::size_t> kinds_;
  std::size_t at_ = 0;
  CommonToken token_;
};

class ParserAutomaton : public RbtParser {
 public:
  explicit ParserAutomaton(TokenStream* nothing) : RbtParser(nothing) {
    removeErrorListeners();
    simulator().setPredictionMode(PredictionMode::SLL);
  }

  ParserATNSimulator& simulator() { return *getInterpreter<ParserATNSimulator>(); }

  // Extends the automaton of the decision by these tokens.
  void predict(std::size_t decision, const std::vector<std::size_t>& kinds) {
    Kinds input(kinds);
    try {
      simulator().adaptivePredict(&input, decision, nullptr);
    } catch (const NoViableAltException&) {  // no program continues with these tokens
    }
  }
  void set_precedence(int precedence) { _precedenceStack = {precedence}; }
};

constexpr std::size_t kLookAhead = 5;     // tokens; for more of them ANTLR predicts
constexpr std::size_t kEnd = 0;           // the kind of the token for the end of the text
constexpr int kPrecedences = 16;          // of operators: 0 to 15
constexpr std::size_t kAccepts = 0x8000;  // + 256 * precedence + alternative

class DecisionWriter {
 public:
  DecisionWriter() : parser_(&nothing_) {}

  void write() {
    std::vector<std::size_t> starts, precedence_starts;
    std::size_t precedence_decision = 0;
    auto& automata = parser_.simulator().decisionToDFA;
    for (std::size_t decision = 0; decision < automata.size(); ++decision) {
      dfa::DFA& automaton = automata[decision];
      if (!automaton.isPrecedenceDfa()) {
        parser_.set_precedence(0);
        parser_.predict(decision, {});
        starts.push_back(explore(decision, automaton.s0));
        continue;
      }
      if (precedence_decision != 0) throw std::logic_error("two rules of operators");
      precedence_decision = decision;
      starts.push_back(0);
      for (int level = 0; level < kPrecedences; ++level) {
        parser_.set_precedence(level);
        parser_.predict(decision, {});
        precedence_starts.push_back(explore(decision, automaton.getPrecedenceStartState(level)));
      }
    }
    std::printf(
        "// Decisions: from each state the tokens first to last lead to another state, or\n"
        "// (kAccepts) to alternative `to %% 256` if the precedence is at most\n"
        "// `to / 256 %% 128`, or whatever it is if that is 0. State 0 knows nothing.\n");
    std::printf("inline constexpr std::uint16_t kAccepts = %zu;\n", kAccepts);
    std::printf("inline constexpr std::size_t kEnd = %zu;  // the kind of the end of the text\n",
                kEnd);
    std::printf("inline constexpr std::size_t kPrecedenceDecision = %zu;\n\n", precedence_decision);
    print_numbers("std::uint16_t", "kDecisionStart", starts);
    print_numbers("std::uint16_t", "kPrecedenceStart", precedence_starts);
    first_edge_.push_back(edges_.size());
    print_numbers("std::uint16_t", "kFirstEdge", first_edge_);
    print_list("DecisionEdge", "kDecisionEdges", edges_);
    write_block();
  }

 private:
  struct Found {
    DFAState* state;
    std::vector<std::size_t> path;
  };

  // Numbers the states that are reachable from `start`; returns the number of `start`, or 0 if it
  // decides nothing.
  std::size_t explore(std::size_t decision, DFAState* start) {
    if (start == nullptr || start->isAcceptState) return 0;
    const std::size_t base = first_edge_.size();
    std::map<DFAState*, std::size_t> numbers{{start, base}};
    std::deque<Found> todo{{start, {}}};
    while (!todo.empty()) {
      const Found at = std::move(todo.front());
      todo.pop_front();
      first_edge_.push_back(edges_.size());
      if (at.path.size() >= kLookAhead) continue;
      std::map<std::size_t, std::size_t> leads;
      for (std::size_t kind = kEnd; kind <= parser_.simulator().atn.maxTokenType; ++kind) {
        const std::size_t token = kind == kEnd ? Token::EOF : kind;
        std::vector<std::size_t> path = at.path;
        path.push_back(token);
        parser_.predict(decision, path);
        const auto edge = at.state->edges.find(token);
        if (edge == at.state->edges.end() || edge->second == ATNSimulator::ERROR.get()) continue;
        DFAState* to = edge->second;
        if (to->isAcceptState) {
          const std::size_t accepted = accepts(*to);
          if (accepted != 0) leads[kind] = accepted;
          continue;
        }
        if (numbers.emplace(to, base + numbers.size()).second) todo.push_back({to, path});
        leads[kind] = numbers[to];
      }
      add_edges(leads);
    }
    return base;
  }

  static std::size_t accepts(const DFAState& state) {
    if (state.requiresFullContext && state.prediction == 0) return 0;
    if (state.predicates.empty()) return kAccepts + state.prediction;
    if (state.predicates.size() != 1) return 0;
    const auto* predicate =
        dynamic_cast<const SemanticContext::PrecedencePredicate*>(state.predicates[0]->pred.get());
    if (predicate == nullptr || predicate->precedence == 0) return 0;
    return kAccepts + 256 * static_cast<std::size_t>(predicate->precedence) +
           static_cast<std::size_t>(state.predicates[0]->alt);
  }

  void add_edges(const std::map<std::size_t, std::size_t>& leads) {
    for (auto at = leads.begin(); at != leads.end();) {
      auto last = at, behind = std::next(at);
      while (behind != leads.end() && behind->second == at->second &&
             behind->first == last->first + 1)
        last = behind++;
      edges_.push_back("{" + std::to_string(at->first) + ", " + std::to_string(last->first) + ", " +
                       std::to_string(at->second) + "}");
      at = behind;
    }
  }

  // Writes the kinds of tokens that may begin a statement of a block, or end it; the parser checks
  // them before every statement.
  void write_block() {
    const ATN& atn = parser_.simulator().atn;
    std::vector<std::size_t> kinds;
    for (ATNState* state : atn.states) {
      if (state == nullptr || state->ruleIndex != RbtParser::RuleBlock) continue;
      if (state->getStateType() != ATNState::STAR_LOOP_ENTRY) continue;
      for (const ssize_t kind : atn.nextTokens(state).toList())
        kinds.push_back(static_cast<std::size_t>(kind));
    }
    std::printf("// What may stand where a statement of a block may begin.\n");
    print_numbers("std::uint8_t", "kStartsInBlock", kinds);
  }

  Kinds nothing_;
  ParserAutomaton parser_;
  std::vector<std::size_t> first_edge_{0};
  std::vector<std::string> edges_;
};

}  // namespace

int main() {
  RbtParser::prepare();
  std::printf(
      "#pragma once\n"
      "// Written by grammar/make_tables.cpp.\n\n"
      "#include <cstddef>\n#include <cstdint>\n\n"
      "namespace rbt_tables {\n\n"
      "struct CharacterRange {\n  std::uint32_t end;\n  std::uint8_t of_class;\n};\n\n"
      "struct DecisionEdge {\n  std::uint8_t first, last;\n  std::uint16_t to;\n};\n\n");
  write_lexer();
  DecisionWriter().write();
  std::printf("}  // namespace rbt_tables\n");
}
