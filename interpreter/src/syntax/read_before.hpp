#pragma once
// Statements at the top level that were read before, in a text that was much alike.

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "ast/ast.hpp"

namespace armlet::lang {

// One without a mistake and without a message, into which nothing was put.
struct ReadStatement {
  const ast::Stmt* tree = nullptr;  // null: it is empty
  std::uint32_t begin = 0;          // bytes of its tokens
  std::uint32_t end = 0;
  std::uint64_t form = 0;  // a hash of the tokens that the parser saw
};

// What of an earlier text stands in a new one. The parser reads a statement from its tokens, and
// looks at most at those of the next one; a comment in front of it can belong to it. So it is the
// same where it stands in a part that has not changed, together with what is in front of it and
// with the statement behind it. The parser then asks whether the tokens are the same too.
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
    std::int64_t shift = 0;                    // from where it stood to where it stands now
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
  // With the one behind it in the part at the beginning that has not changed.
  [[nodiscard]] bool in_front(const ReadStatement& statement) const {
    const bool is_last = &statement == &statements_.back();
    return !is_last && (&statement + 1)->end < same_begin_;
  }
  // With the one in front of it in the part at the end, and the one behind it known.
  [[nodiscard]] bool behind(const ReadStatement& statement) const {
    const bool is_first = &statement == &statements_.front();
    return !is_first && (&statement - 1)->begin > same_end_;
  }

  const std::vector<ReadStatement>& statements_;
  std::int64_t shift_;
  std::uint32_t same_begin_ = 0;  // bytes that are the same at the beginning
  std::uint32_t same_end_ = 0;    // from this byte of the earlier text on they are the same
  std::uint32_t size_ = 0;
};

}  // namespace armlet::lang
