#pragma once
// The parser's reaction to a mistake during a repair: it stops and reports the position.

#include <optional>

#include "antlr4-runtime.h"
#include "syntax/repair/mend.hpp"

namespace armlet::lang {

class FirstFailure : public antlr4::ANTLRErrorStrategy {
 public:
  [[nodiscard]] const std::optional<ParseFailure>& found() const { return found_; }

  void reset(antlr4::Parser*) override {}
  antlr4::Token* recoverInline(antlr4::Parser* parser) override;
  void recover(antlr4::Parser* parser, std::exception_ptr error) override;
  void sync(antlr4::Parser* parser) override;
  bool inErrorRecoveryMode(antlr4::Parser*) override { return false; }
  void reportMatch(antlr4::Parser*) override {}
  void reportError(antlr4::Parser* parser, const antlr4::RecognitionException& error) override;

 private:
  std::optional<ParseFailure> found_;
};

}  // namespace armlet::lang
