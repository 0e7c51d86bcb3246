#pragma once
// Base classes of the generated parser with limits of nesting. The functions of the parser are
// recursive, so a text of a few hundred kilobytes could overflow the stack.

#include <cstddef>

#include "antlr4-runtime.h"

// A parse tree context with its depth of nesting.
class GuardedCtx : public antlr4::ParserRuleContext {
 public:
  GuardedCtx() = default;
  GuardedCtx(antlr4::ParserRuleContext* parent_context, size_t state)
      : antlr4::ParserRuleContext(parent_context, state), level(level_of(parent_context)) {}

  // Contexts of labelled alternatives are made by copyFrom; without this declaration their depth
  // would begin at 0 again.
  using antlr4::ParserRuleContext::copyFrom;
  void copyFrom(antlr4::ParserRuleContext* other) override {
    antlr4::ParserRuleContext::copyFrom(other);
    level = level_of(other);
  }

  static size_t level_of(antlr4::ParserRuleContext* context) {
    return context == nullptr ? 0 : static_cast<GuardedCtx*>(context)->level;
  }

  size_t level = 0;
  size_t chain = 0;  // consecutive operators and suffixes: 1 + 2 + 3 has two
};

// Throws ParseCancellationException if the nesting exceeds `max_level`, or a chain exceeds
// `max_chain`.
class GuardedParser : public antlr4::Parser {
 public:
  using antlr4::Parser::Parser;

  size_t max_level = 200;
  size_t max_chain = 1000;
  bool chain_too_long = false;  // which of the two limits was exceeded

  // Whether `rule` is a level of nesting.
  virtual bool opensLevel(size_t rule) const = 0;

  void enterRule(antlr4::ParserRuleContext* context, size_t state, size_t rule) override {
    antlr4::Parser::enterRule(context, state, rule);
    enter_level(context, rule);
  }

  using antlr4::Parser::enterRecursionRule;
  void enterRecursionRule(antlr4::ParserRuleContext* context, size_t state, size_t rule,
                          int precedence) override {
    antlr4::Parser::enterRecursionRule(context, state, rule, precedence);
    enter_level(context, rule);
  }

  // `1 + 2`, parsed after `1`: the new context replaces the old one as the parent.
  void pushNewRecursionContext(antlr4::ParserRuleContext* context, size_t state,
                               size_t rule) override {
    auto* grown = static_cast<GuardedCtx*>(context);
    auto* inner = static_cast<GuardedCtx*>(_ctx);
    grown->level = inner->level;
    grown->chain = inner->chain + 1;
    chain_too_long = grown->chain > max_chain;
    if (chain_too_long) throw antlr4::ParseCancellationException("too long a chain");
    antlr4::Parser::pushNewRecursionContext(context, state, rule);
  }

 private:
  void enter_level(antlr4::ParserRuleContext* context, size_t rule) {
    if (!opensLevel(rule)) return;
    if (++static_cast<GuardedCtx*>(context)->level > max_level) {
      throw antlr4::ParseCancellationException("nested too deeply");
    }
  }
};
