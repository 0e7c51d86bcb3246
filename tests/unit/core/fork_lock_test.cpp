#include "armlet/core/fork_lock.hpp"

#include <doctest/doctest.h>

#ifdef __unix__
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <thread>

TEST_CASE("a child finds the lock free, whoever held it when its parent forked") {
  std::atomic<bool> end{false};
  std::thread other([&] {
    while (!end) {
      const auto lock = armlet::lock_over_forks();
      std::this_thread::yield();
    }
  });
  int ended = 0;
  for (int i = 0; i < 30; ++i) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      alarm(20);  // ends a child that waits for ever
      { const auto lock = armlet::lock_over_forks(); }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ended += WIFEXITED(status) ? 1 : 0;
  }
  end = true;
  other.join();
  CHECK(ended == 30);
}
#endif
