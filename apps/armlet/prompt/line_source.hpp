#pragma once
// Where the lines of the prompt come from: a terminal that can be edited, or anything else.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::cli {

// What could stand at the cursor. `word_bytes` of the line before it are replaced.
struct Choices {
  std::size_t word_bytes = 0;
  std::vector<std::string> texts{};
};
using Completer = std::function<Choices(std::string_view before_cursor)>;

class LineSource {
 public:
  virtual ~LineSource() = default;
  // The next line without its end. Nothing: there are no more, or Ctrl-C was pressed
  // (interrupted()).
  [[nodiscard]] virtual std::optional<std::string> next(std::string_view prompt) = 0;
  // The line behind the one that was taken, which stays, if it is there already or comes within
  // `patience_ms`, as in a pipe. Nothing: nobody knows.
  [[nodiscard]] virtual std::optional<std::string_view> peek(int /*patience_ms*/) { return {}; }
  // A text that can be fetched again with the arrow keys, in this session and in later ones.
  virtual void remember(const std::string& /*text*/) {}
};

// Lines of standard input as they come. With `prompts` they are asked for.
[[nodiscard]] std::unique_ptr<LineSource> plain_lines(bool prompts);
// Lines that are edited in a terminal, with a history that is kept in a file; `history` may be
// empty. Null: the library for it is not there.
[[nodiscard]] std::unique_ptr<LineSource> edited_lines(Completer complete,
                                                       const std::string& history);

}  // namespace armlet::cli
