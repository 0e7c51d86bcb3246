#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "console.hpp"
#include "prompt/line_source.hpp"

namespace armlet::cli {
namespace {

class PlainLines final : public LineSource {
 public:
  explicit PlainLines(bool prompts) : prompts_(prompts) {}

  std::optional<std::string> next(std::string_view prompt) override {
    if (prompts_) {
      print_out(prompt);
      if (!finish_output()) return std::nullopt;
    }
    while (true) {
      const std::size_t end = read_.find('\n', searched_);
      if (end != std::string::npos) {
        std::string line = read_.substr(0, end);
        read_.erase(0, end + 1);
        searched_ = 0;
        return line;
      }
      searched_ = read_.size();
      char piece[4096];
      const ssize_t count = read(STDIN_FILENO, piece, sizeof piece);
      if (count < 0 && errno == EINTR && !interrupted()) continue;
      if (count <= 0) break;
      read_.append(piece, static_cast<std::size_t>(count));
    }
    if (read_.empty() || interrupted()) return std::nullopt;
    searched_ = 0;
    return std::exchange(read_, {});  // the last line, without an end
  }

 private:
  bool prompts_;
  std::string read_;
  std::size_t searched_ = 0;  // so far there is no end of a line
};

}  // namespace

std::unique_ptr<LineSource> plain_lines(bool prompts) { return std::make_unique<PlainLines>(prompts); }

}  // namespace armlet::cli
