#include "syntax/mistakes/recovery.hpp"

#include <RbtParser.h>

#include "syntax/parser/table_prediction.hpp"
#include "syntax/tokens/token_kinds.hpp"

namespace armlet::lang {
namespace {

bool continues_block(std::uint16_t type) {
  return word_of(type).follows_block || type == RbtParser::SEMI;
}

}  // namespace

antlr4::Token* StatementRecovery::recoverInline(antlr4::Parser* parser) {
  throw antlr4::InputMismatchException(parser);
}

void StatementRecovery::reportError(antlr4::Parser* parser,
                                    const antlr4::RecognitionException& error) {
  if (reported_) return;
  reported_ = true;
  antlr4::RuleContext* ctx = parser->getContext();
  while (ctx != nullptr && ctx->getRuleIndex() != RbtParser::RuleStmt) {
    ctx = static_cast<antlr4::RuleContext*>(ctx->parent);
  }
  const std::size_t at = error.getOffendingToken()->getTokenIndex();
  const auto* statement = static_cast<antlr4::ParserRuleContext*>(ctx);
  resume_ = report_(statement == nullptr ? 0 : statement->start->getTokenIndex(), at);
}

// All rules between the mistake and its statement end; the statement skips the rest of its tokens.
void StatementRecovery::recover(antlr4::Parser* parser, std::exception_ptr error) {
  antlr4::ParserRuleContext* ctx = parser->getContext();
  if (ctx->getRuleIndex() != RbtParser::RuleStmt) std::rethrow_exception(error);
  reported_ = false;
  antlr4::TokenStream* input = parser->getTokenStream();
  std::size_t at = input->index();
  try {
    std::rethrow_exception(error);
  } catch (const antlr4::RecognitionException& cause) {
    at = std::max(at, cause.getOffendingToken()->getTokenIndex());
  }
  input->seek(std::max(next_statement(tokens_, ctx->start->getTokenIndex(), at), resume_));
}

// Called before each iteration of a loop in the grammar: tokens that cannot begin a statement of a
// block are reported and skipped.
void StatementRecovery::sync(antlr4::Parser* parser) {
  if (parser->getContext()->getRuleIndex() != RbtParser::RuleBlock) return;
  antlr4::TokenStream* input = parser->getTokenStream();
  while (!may_stand_in_block(input->LA(1)) && input->LA(1) != antlr4::Token::EOF) {
    const std::size_t at = input->index();
    report_(at, at);
    input->seek(std::max(at + 1, next_statement(tokens_, at, at)));
  }
}

std::size_t next_statement(const Tokens& tokens, std::size_t start, std::size_t at) {
  std::size_t depth = 0;
  for (std::size_t i = start; i < tokens.size(); ++i) {
    const std::uint16_t type = tokens[i].type;
    if (type == kEndOfText) return i;
    if (depth == 0 && i > start && i >= at && tokens[i].line_break_before && word_of(type).resumes)
      return i;
    if (is_opener(type)) ++depth;
    if (is_closer(type) && depth == 0) return i;
    if (is_closer(type)) --depth;
    if (depth > 0 || i < at) continue;
    if (type == RbtParser::SEMI && tokens[i + 1].type != RbtParser::ELSE) return i + 1;
    if (type == RbtParser::RBRACE && !continues_block(tokens[i + 1].type)) return i + 1;
  }
  return tokens.size() - 1;
}

}  // namespace armlet::lang
