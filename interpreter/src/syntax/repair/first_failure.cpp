#include "syntax/repair/first_failure.hpp"

#include <RbtParser.h>

#include "syntax/parser/table_prediction.hpp"

namespace armlet::lang {

antlr4::Token* FirstFailure::recoverInline(antlr4::Parser* parser) {
  throw antlr4::InputMismatchException(parser);
}

void FirstFailure::reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) {
  if (found_) return;
  const std::size_t at = error.getOffendingToken()->getTokenIndex();
  // A missing statement belongs to the statement around it.
  std::size_t statement = at;
  for (auto* ctx = static_cast<antlr4::ParserRuleContext*>(parser->getContext());
       ctx != nullptr && statement == at;
       ctx = static_cast<antlr4::ParserRuleContext*>(ctx->parent)) {
    if (ctx->getRuleIndex() == RbtParser::RuleStmt) statement = ctx->start->getTokenIndex();
  }
  found_ = {.statement = statement, .at = at};
}

void FirstFailure::recover(antlr4::Parser*, std::exception_ptr error) {
  std::rethrow_exception(error);
}

// Tokens that cannot begin a statement of a block count as a statement with a mistake.
void FirstFailure::sync(antlr4::Parser* parser) {
  if (parser->getContext()->getRuleIndex() != RbtParser::RuleBlock) return;
  antlr4::TokenStream* input = parser->getTokenStream();
  if (may_stand_in_block(input->LA(1)) || input->LA(1) == antlr4::Token::EOF) return;
  if (!found_) found_ = {.statement = input->index(), .at = input->index()};
  throw antlr4::InputMismatchException(parser);
}

}  // namespace armlet::lang
