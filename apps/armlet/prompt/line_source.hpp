#pragma once
// The source of the lines of the prompt: a terminal with editing, or any other input.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::cli {

// Completions at the cursor. They replace the `word_bytes` of the line before it.
struct Choices {
  std::size_t word_bytes = 0;
  std::vector<std::string> texts{};
};
using Completer = std::function<Choices(std::string_view before_cursor)>;

class LineSource {
 public:
  virtual ~LineSource() = default;
  // The next line without its end. Nullopt: there are no more, or Ctrl-C was pressed
  // (interrupted()).
  [[nodiscard]] virtual std::optional<std::string> next(std::string_view prompt) = 0;
  // The line after the one returned last, without removing it, if it is available within
  // `patience_ms`, as in a pipe. Nullopt: not known.
  [[nodiscard]] virtual std::optional<std::string_view> peek(int /*patience_ms*/) { return {}; }
  // Adds a text to the history, which the arrow keys show in this session and in later ones.
  virtual void remember(const std::string& /*text*/) {}
};

// Lines of standard input without editing. With `prompts` a prompt is printed before each.
[[nodiscard]] std::unique_ptr<LineSource> plain_lines(bool prompts);
// Lines edited in a terminal, with a history in the file `history`, which may be empty. Null: the
// library for it is not installed.
[[nodiscard]] std::unique_ptr<LineSource> edited_lines(Completer complete,
                                                       const std::string& history);

}  // namespace armlet::cli
