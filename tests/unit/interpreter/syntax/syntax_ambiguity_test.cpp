// Random sentences of grammar/RbtParser.g4, parsed with ANTLR's exact detection of ambiguities.

#include <doctest/doctest.h>

#undef WHEN  // of doctest; the parser has a function of that name
#include <RbtParser.h>

#include "syntax/parser/token_feed.hpp"
#include "syntax_sentences.hpp"

namespace armlet::lang {
namespace {

struct Reports : antlr4::BaseErrorListener {
  int mistakes = 0;
  int ambiguities = 0;
  int full_contexts = 0;

  void syntaxError(antlr4::Recognizer*, antlr4::Token*, size_t, size_t, const std::string&,
                   std::exception_ptr) override {
    ++mistakes;
  }
  void reportAmbiguity(antlr4::Parser*, const antlr4::dfa::DFA&, size_t, size_t, bool,
                       const antlrcpp::BitSet&, antlr4::atn::ATNConfigSet*) override {
    ++ambiguities;
  }
  void reportAttemptingFullContext(antlr4::Parser*, const antlr4::dfa::DFA&, size_t, size_t,
                                   const antlrcpp::BitSet&, antlr4::atn::ATNConfigSet*) override {
    ++full_contexts;
  }
};

std::string shown(const Tokens& tokens, RbtParser& parser) {
  std::string out;
  for (const Token& token : tokens) {
    if (token.type != kEndOfText) out += parser.getVocabulary().getSymbolicName(token.type) + ' ';
  }
  return out;
}

TEST_CASE("the grammar has no ambiguity, and one token of context is never needed") {
  RbtParser::prepare();
  SentenceWriter writer(1);
  CHECK(writer.rules() <= 65);
  std::size_t tokens = 0;
  for (int i = 0; i < 5000; ++i) {
    const Tokens program = writer.program();
    tokens += program.size();
    TokenFeed feed(program);
    RbtParser parser(&feed);
    Reports reports;
    parser.removeErrorListeners();
    parser.addErrorListener(&reports);
    parser.max_level = 100'000;
    parser.getInterpreter<antlr4::atn::ParserATNSimulator>()->setPredictionMode(
        antlr4::atn::PredictionMode::LL_EXACT_AMBIG_DETECTION);
    parser.program();
    const bool clean =
        reports.mistakes == 0 && reports.ambiguities == 0 && reports.full_contexts == 0;
    if (clean) continue;
    INFO(shown(program, parser));
    INFO("mistakes ", reports.mistakes, ", ambiguities ", reports.ambiguities, ", full contexts ",
         reports.full_contexts);
    REQUIRE(clean);
  }
  CHECK(tokens > 100'000);
}

}  // namespace
}  // namespace armlet::lang
