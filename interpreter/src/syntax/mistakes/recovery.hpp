#pragma once
// What the parser does at a mistake: one message, then on to the next statement.

#include <functional>

#include "antlr4-runtime.h"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

// The first token behind the statement that starts at `start` and has a mistake at `at`.
[[nodiscard]] std::size_t next_statement(const Tokens& tokens, std::size_t start, std::size_t at);

class StatementRecovery : public antlr4::ANTLRErrorStrategy {
 public:
  // `report(statement, at)`: the statement that starts at the first token cannot go on at the
  // second. Gives the token before which reading should not go on, 0 if any will do.
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
