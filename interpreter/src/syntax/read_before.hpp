#pragma once
// Reuses the trees of unchanged top-level statements when an edited text is parsed again.

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "ast/ast.hpp"

namespace armlet::lang {

// A statement without mistakes, messages and inserted tokens.
struct ReadStatement {
  const ast::Stmt* tree = nullptr;  // null: an empty statement
  std::uint32_t begin = 0;          // bytes of its tokens
  std::uint32_t end = 0;
  std::uint64_t form = 0;  // a hash of the tokens that the parser saw
};

// The unchanged parts of an edited text. The parser reads a statement from its tokens and at most
// those of the next one; a comment before it may belong to it. The tree of a statement can
// therefore be reused if the statement, the text before it and the next statement are unchanged.
// The parser then checks that the tokens are the same too.
class ReadBefore {
 public:
  // statements  in the order of the text.
  ReadBefore(std::string_view before, const std::vector<ReadStatement>& statements,
             std::string_view now)
      : statements_(statements),
        shift_(static_cast<std::int64_t>(now.size()) - static_cast<std::int64_t>(before.size())) {
    const std::size_t most = std::min(before.size(), now.size());
    std::size_t same = 0;
    while (same < most && before[same] == now[same]) ++same;
    same_begin_ = static_cast<std::uint32_t>(same);
    std::size_t tail = 0;
    while (tail < most - same && before[before.size() - 1 - tail] == now[now.size() - 1 - tail])
      ++tail;
    same_end_ = static_cast<std::uint32_t>(before.size() - tail);
    size_ = static_cast<std::uint32_t>(before.size());
  }

  struct Found {
    const ReadStatement* statement = nullptr;  // null: none
    std::int64_t shift = 0;                    // from its old position to its new one
  };
  // The statement that begins at a byte of the new text.
  [[nodiscard]] Found at(std::uint32_t begin) const {
    if (const ReadStatement* found = beginning_at(begin); found != nullptr && in_front(*found))
      return {found, 0};
    const std::int64_t old = begin - shift_;
    if (old < 0 || old > size_) return {};
    const ReadStatement* found = beginning_at(static_cast<std::uint32_t>(old));
    return found != nullptr && behind(*found) ? Found{found, shift_} : Found{};
  }

 private:
  [[nodiscard]] const ReadStatement* beginning_at(std::uint32_t begin) const {
    const auto found = std::ranges::lower_bound(statements_, begin, {}, &ReadStatement::begin);
    return found != statements_.end() && found->begin == begin ? &*found : nullptr;
  }
  // Whether the statement and the next one are in the unchanged part at the beginning.
  [[nodiscard]] bool in_front(const ReadStatement& statement) const {
    const bool is_last = &statement == &statements_.back();
    return !is_last && (&statement + 1)->end < same_begin_;
  }
  // Whether the statement and the one before it are in the unchanged part at the end, and the next
  // one is known.
  [[nodiscard]] bool behind(const ReadStatement& statement) const {
    const bool is_first = &statement == &statements_.front();
    return !is_first && (&statement - 1)->begin > same_end_;
  }

  const std::vector<ReadStatement>& statements_;
  std::int64_t shift_;
  std::uint32_t same_begin_ = 0;  // bytes of the unchanged part at the beginning
  std::uint32_t same_end_ = 0;  // the first byte, in the old text, of the unchanged part at the end
  std::uint32_t size_ = 0;
};

}  // namespace armlet::lang
