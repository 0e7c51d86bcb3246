#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "console/console.hpp"
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
    while (end_of_line() == std::string::npos && read_more()) {
    }
    if (interrupted()) {
      if (prompts_) print_out("\n");
      return std::nullopt;
    }
    const std::size_t end = end_of_line();
    if (end == std::string::npos && read_.empty()) {
      if (prompts_) print_out("\n");
      return std::nullopt;
    }
    std::string line = read_.substr(0, end);  // the last line may have no end
    read_.erase(0, end == std::string::npos ? end : end + 1);
    searched_ = 0;
    if (line.ends_with('\r')) line.pop_back();
    return line;
  }

  std::optional<std::string_view> peek(int patience_ms) override {
    while (end_of_line() == std::string::npos) {
      pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
      if (has_ended_ || poll(&input, 1, patience_ms) <= 0 || !read_more()) break;
    }
    const std::size_t end = end_of_line();
    if (end == std::string::npos && !has_ended_) return std::nullopt;
    return std::string_view(read_).substr(0, end);
  }

 private:
  std::size_t end_of_line() {
    const std::size_t end = read_.find('\n', searched_);
    searched_ = end == std::string::npos ? read_.size() : end;
    return end;
  }

  // False: there is no more input, or Ctrl-C was pressed.
  bool read_more() {
    if (has_ended_) return false;  // a terminal reports the end only once
    char piece[4096];
    ssize_t count = -1;
    do {
      count = ::read(STDIN_FILENO, piece, sizeof piece);
    } while (count < 0 && errno == EINTR && !interrupted());
    if (interrupted()) return false;
    has_ended_ = count <= 0;
    if (!has_ended_) read_.append(piece, static_cast<std::size_t>(count));
    return !has_ended_;
  }

  bool prompts_;
  bool has_ended_ = false;
  std::string read_;
  std::size_t searched_ = 0;  // there is no end of a line before this position
};

}  // namespace

std::unique_ptr<LineSource> plain_lines(bool prompts) {
  return std::make_unique<PlainLines>(prompts);
}

}  // namespace armlet::cli
