#include "converter/confine.hpp"

#include <doctest/doctest.h>

// A sanitizer needs calls of the system that the filter refuses, so nothing is filtered with it.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace {

bool is_refused(long result) { return result == -1 && errno == EPERM; }

// What a process that has confined itself can do to others: 0, or the number of what it could.
int try_to_break_out(pid_t other) {
  if (!armlet::mesh::confine(std::size_t{1} << 30U, 10).empty()) return 100;
  if (!is_refused(syscall(SYS_tgkill, other, other, 0))) return 1;
  if (!is_refused(syscall(SYS_tkill, other, 0))) return 2;
  if (!is_refused(syscall(SYS_kill, other, 0))) return 3;
  if (!is_refused(syscall(SYS_rt_sigqueueinfo, other, SIGKILL, nullptr))) return 4;
  if (!is_refused(syscall(SYS_openat, -100, "/etc/passwd", 0))) return 5;
  if (!is_refused(syscall(SYS_socket, 2, 1, 0))) return 6;
  if (!is_refused(syscall(SYS_dup, 0))) return 7;
  // The same number of a process in the upper half, which the kernel does not look at.
  if (!is_refused(syscall(SYS_tgkill, (1L << 32U) | other, other, 0))) return 8;
  if (syscall(SYS_tgkill, getpid(), gettid(), 0) != 0) return 9;
  return 0;
}

}  // namespace

TEST_CASE("a converter signals nobody but itself, and opens nothing") {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(try_to_break_out(getppid()));
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("a converter may abort") {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (!armlet::mesh::confine(std::size_t{1} << 30U, 10).empty()) _exit(100);
    std::signal(SIGABRT, SIG_DFL);  // not to the handler of the tests
    std::abort();
  }
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGABRT);
}
#endif
