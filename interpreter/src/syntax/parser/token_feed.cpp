#include "syntax/parser/token_feed.hpp"

#include "base/cancelled.hpp"

namespace armlet::lang {

void TokenFeed::drop_past() {
  made_.clear();
  first_ = at_;
}

void TokenFeed::consume() {
  stop_if(cancelled_);
  if (at_ + 1 < tokens_.size()) ++at_;
}

size_t TokenFeed::LA(ssize_t i) {
  const std::size_t index =
      i > 0 ? at_ + static_cast<std::size_t>(i) - 1 : at_ - static_cast<std::size_t>(-i);
  if (index >= tokens_.size() || tokens_[index].type == kEndOfText) return antlr4::Token::EOF;
  return tokens_[index].type;
}

antlr4::Token* TokenFeed::LT(ssize_t k) {
  const std::size_t back = static_cast<std::size_t>(k < 0 ? -k : 0);
  if (k == 0 || back > at_ - first_) return nullptr;
  const std::size_t index = k > 0 ? at_ + static_cast<std::size_t>(k) - 1 : at_ - back;
  return get(std::min(index, tokens_.size() - 1));
}

antlr4::Token* TokenFeed::get(size_t index) const {
  const std::size_t slot = index - first_;
  if (slot >= made_.size()) made_.resize(slot + 1);
  if (made_[slot] == nullptr) {
    const Token& token = tokens_[index];
    const size_t type = token.type == kEndOfText ? antlr4::Token::EOF : token.type;
    made_[slot] = std::make_unique<antlr4::CommonToken>(type);
    made_[slot]->setTokenIndex(index);
    made_[slot]->setStartIndex(token.begin);
    made_[slot]->setStopIndex(token.end);
  }
  return made_[slot].get();
}

}  // namespace armlet::lang
