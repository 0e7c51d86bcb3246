#include "client/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>

namespace armlet::mesh {
namespace {

using Clock = std::chrono::steady_clock;

Error failed(std::string why) { return Error{"mesh", std::move(why)}; }

// The converter process at the other end of a socket. It ends with this object.
class Converter {
 public:
  explicit Converter(const ConverterRun& run) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
      reason_ = std::strerror(errno);
      return;
    }
    socket_ = ends[0];
    fcntl(socket_, F_SETFL, fcntl(socket_, F_GETFL) | O_NONBLOCK);
    std::vector<std::string> words{run.program};
    words.insert(words.end(), run.arguments.begin(), run.arguments.end());
    std::vector<char*> argv;
    for (std::string& each : words) argv.push_back(each.data());
    argv.push_back(nullptr);
    // The process gets no environment: its libraries need none, and may use paths from it.
    char plain[] = "LC_ALL=C";
    char* const environment[] = {plain, nullptr};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
#ifndef __SANITIZE_ADDRESS__
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
#endif
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // Resets the signal handling, whatever this process has changed.
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    const int error =
        posix_spawn(&process_, run.program.c_str(), &files, &attributes, argv.data(), environment);
    if (error != 0) {
      process_ = -1;
      reason_ = std::strerror(error);
    }
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
  }
  ~Converter() {
    if (process_ > 0) kill(process_, SIGKILL);
    end();
    if (socket_ >= 0) close(socket_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  [[nodiscard]] bool runs() const { return process_ > 0; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] int socket() const { return socket_; }

  void end() {
    if (process_ > 0) {
      while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
      }
      process_ = -1;
    }
  }
  // Gives a process that has closed its socket a second to end by itself, for its exit status.
  void let_end() {
    constexpr int kPasses = 100;
    for (int k = 0; k < kPasses && process_ > 0; ++k) {
      const pid_t ended = waitpid(process_, &status_, WNOHANG);
      if (ended == process_ || (ended < 0 && errno == ECHILD)) process_ = -1;
      if (process_ > 0) poll(nullptr, 0, 10);
    }
    if (process_ > 0) kill(process_, SIGKILL);
    end();
  }
  [[nodiscard]] int status() const { return status_; }

 private:
  int socket_ = -1;
  pid_t process_ = -1;
  int status_ = 0;
  std::string reason_;
};

// The communication with a converter: bytes in both directions, until the deadline.
class Talk {
 public:
  Talk(const ConverterRun& run, Converter& converter)
      : run_(run),
        converter_(converter),
        start_(Clock::now()),
        deadline_(start_ + std::chrono::seconds(run.limits.wall)) {}

  Result<std::string> take() {
    say(Say::kFile, run_.input);
    for (;;) {
      if (!transfer()) return broken();
      while (const auto message = next()) {
        const auto& [what, text] = *message;
        if (what == Say::kDone) return std::string(text);
        if (what == Say::kFailed) return failed(shown_text(text.substr(0, 2000)));
        if (what == Say::kStage) stage_ = shown_text(text.substr(0, 80));
        if (what == Say::kWant) answer(std::string(text));
        in_.erase(0, kSayHeader + text.size());
      }
      if (too_long_) return failed(*too_long_);
    }
  }

 private:
  struct Message {
    Say what;
    std::string_view text;  // a part of in_
  };

  void say(Say what, std::string_view text) {
    out_ += say_header(what, text.size());
    out_ += text;
  }

  void answer(const std::string& name) {
    const Sibling found = run_.find(name);
    say(found.state, found.text);
  }

  // The first complete message.
  std::optional<Message> next() {
    if (in_.size() < kSayHeader) return std::nullopt;
    const std::size_t length = said_length(in_.data());
    if (length > run_.limits.result) {
      too_long_ = fmt::format("it becomes a GLB of {} bytes; expected {} at most", length,
                              run_.limits.result);
      return std::nullopt;
    }
    if (in_.size() < kSayHeader + length) return std::nullopt;
    return Message{static_cast<Say>(in_[0]), std::string_view(in_).substr(kSayHeader, length)};
  }

  // Sends and receives some bytes; false if the other end is closed or time is up.
  bool transfer() {
    pollfd wait{converter_.socket(), static_cast<short>(POLLIN | (out_.empty() ? 0 : POLLOUT)), 0};
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
    if (left <= 0) {
      late_ = true;
      return false;
    }
    if (run_.is_cancelled && run_.is_cancelled()) {
      cancelled_ = true;
      return false;
    }
    constexpr long kBetweenLooks = 50;  // ms, between checks of the clock and of cancellation
    const int ready = poll(&wait, 1, static_cast<int>(std::min<long>(left, kBetweenLooks)));
    report();
    if (ready < 0) return errno == EINTR;
    if (ready == 0) return true;
    if ((wait.revents & POLLOUT) != 0 && !send_some()) return false;
    if ((wait.revents & POLLIN) != 0) return receive_some();
    return (wait.revents & (POLLHUP | POLLERR)) == 0;
  }

  bool send_some() {
    const ssize_t sent = ::send(converter_.socket(), out_.data() + sent_, out_.size() - sent_,
                                MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0) return errno == EAGAIN || errno == EINTR || errno == EPIPE;
    sent_ += static_cast<std::size_t>(sent);
    if (sent_ == out_.size()) {
      out_.clear();
      sent_ = 0;
    }
    return true;
  }

  bool receive_some() {
    char bytes[1 << 16];
    const ssize_t count = ::recv(converter_.socket(), bytes, sizeof bytes, MSG_DONTWAIT);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    in_.append(bytes, static_cast<std::size_t>(count));
    return count > 0;
  }

  void report() {
    const auto seconds = static_cast<int>(
        std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start_).count());
    if (seconds == reported_ || !run_.progress) return;
    reported_ = seconds;
    run_.progress(stage_, seconds);
  }

  // The reason why there is no answer.
  Error broken() {
    if (cancelled_) return failed("its conversion was cancelled");
    if (late_) {
      return failed(
          fmt::format("its conversion took more than {} s and was ended", run_.limits.wall));
    }
    converter_.let_end();
    const int status = converter_.status();
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU) {
      return failed(fmt::format("its conversion took more than {} s of computing and was ended",
                                run_.limits.cpu));
    }
    if (signal != 0) {
      return failed(fmt::format(
          "the converter broke down over it (signal {}, {}); the file is damaged, or needs "
          "more than {} MB of memory",
          signal, strsignal(signal), run_.limits.memory >> 20));
    }
    return failed(fmt::format("the converter ended without a result (exit status {})",
                              WIFEXITED(status) ? WEXITSTATUS(status) : status));
  }

  const ConverterRun& run_;
  Converter& converter_;
  Clock::time_point start_, deadline_;
  std::string in_, out_;
  std::size_t sent_ = 0;
  std::string stage_ = "reading";
  std::optional<std::string> too_long_;
  bool late_ = false;
  bool cancelled_ = false;
  int reported_ = 0;
};

}  // namespace

Result<std::string> run_converter(const ConverterRun& run) {
  ConverterRun limited = run;
  limited.arguments.push_back(fmt::format("{}", run.limits.memory));
  limited.arguments.push_back(fmt::format("{}", run.limits.cpu));
  Converter converter(limited);
  if (!converter.runs()) {
    return Error{"converter", fmt::format("the converter {} cannot be started: {}", run.program,
                                          converter.reason())};
  }
  return Talk(limited, converter).take();
}

}  // namespace armlet::mesh
