#include "syntax/repair/first_failure.hpp"

#include <RbtParser.h>

#include "syntax/table_prediction.hpp"

namespace armlet::lang {

antlr4::Token* FirstFailure::recoverInline(antlr4::Parser* parser) {
  throw antlr4::InputMismatchException(parser);
}

void FirstFailure::reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) {
  if (found_) return;
  antlr4::RuleContext* ctx = parser->getContext();
  while (ctx != nullptr && ctx->getRuleIndex() != RbtParser::RuleStmt) {
    ctx = static_cast<antlr4::RuleContext*>(ctx->parent);
  }
  const auto* statement = static_cast<antlr4::ParserRuleContext*>(ctx);
  found_ = {.statement = statement == nullptr ? 0 : statement->start->getTokenIndex(),
            .at = error.getOffendingToken()->getTokenIndex()};
}

void FirstFailure::recover(antlr4::Parser*, std::exception_ptr error) {
  std::rethrow_exception(error);
}

// What starts no statement of a block is a statement of its own with a mistake.
void FirstFailure::sync(antlr4::Parser* parser) {
  if (parser->getContext()->getRuleIndex() != RbtParser::RuleBlock) return;
  antlr4::TokenStream* input = parser->getTokenStream();
  if (may_stand_in_block(input->LA(1)) || input->LA(1) == antlr4::Token::EOF) return;
  if (!found_) found_ = {.statement = input->index(), .at = input->index()};
  throw antlr4::InputMismatchException(parser);
}

}  // namespace armlet::lang
