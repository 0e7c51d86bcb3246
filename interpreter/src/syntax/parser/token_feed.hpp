#pragma once
// Passes our tokens to ANTLR's parser. ANTLR's token objects, 128 bytes each, are made when the
// parser reads them, and freed with their statement.

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "antlr4-runtime.h"
#include "syntax/tokens/token.hpp"

namespace armlet::lang {

class TokenFeed : public antlr4::TokenStream {
 public:
  explicit TokenFeed(const Tokens& tokens, const std::atomic<bool>* cancelled = nullptr)
      : tokens_(tokens), cancelled_(cancelled) {}

  // Frees the objects of all tokens before the current one.
  void drop_past();

  void consume() override;
  size_t LA(ssize_t i) override;
  antlr4::Token* LT(ssize_t k) override;
  antlr4::Token* get(size_t index) const override;
  ssize_t mark() override { return 0; }
  void release(ssize_t) override {}
  size_t index() override { return at_; }
  void seek(size_t index) override { at_ = std::min(index, tokens_.size() - 1); }
  size_t size() override { return tokens_.size(); }
  std::string getSourceName() const override { return {}; }
  antlr4::TokenSource* getTokenSource() const override { return nullptr; }
  std::string getText(const antlr4::misc::Interval&) override { return {}; }
  std::string getText() override { return {}; }
  std::string getText(antlr4::RuleContext*) override { return {}; }
  std::string getText(antlr4::Token*, antlr4::Token*) override { return {}; }

 private:
  const Tokens& tokens_;
  const std::atomic<bool>* cancelled_;
  std::size_t at_ = 0;
  std::size_t first_ = 0;  // the index of made_.front()
  mutable std::vector<std::unique_ptr<antlr4::CommonToken>> made_;
};

}  // namespace armlet::lang
