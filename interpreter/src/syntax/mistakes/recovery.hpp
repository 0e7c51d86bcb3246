#pragma once
// The parser's reaction to a mistake: one message, then the parser continues with the next
// statement.

#include <functional>

#include "antlr4-runtime.h"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The first token after the statement that starts at `start` and has a mistake at `at`.
[[nodiscard]] std::size_t next_statement(const Tokens& tokens, std::size_t start, std::size_t at);

class StatementRecovery : public antlr4::ANTLRErrorStrategy {
 public:
  // `report(statement, at)`: reports that the statement with the first token `statement` cannot
  // continue at token `at`. Returns a token before which the parser must not continue; 0 if there
  // is no such limit.
  using Report = std::function<std::size_t(std::size_t statement, std::size_t at)>;

  StatementRecovery(const Tokens& tokens, Report report)
      : tokens_(tokens), report_(std::move(report)) {}

  void reset(antlr4::Parser*) override { reported_ = false; }
  antlr4::Token* recoverInline(antlr4::Parser* parser) override;
  void recover(antlr4::Parser* parser, std::exception_ptr error) override;
  void sync(antlr4::Parser* parser) override;
  bool inErrorRecoveryMode(antlr4::Parser*) override { return false; }
  void reportMatch(antlr4::Parser*) override {}
  void reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) override;

 private:
  const Tokens& tokens_;
  Report report_;
  bool reported_ = false;
  std::size_t resume_ = 0;
};

}  // namespace armlet::lang
