// A process that forks while another of its threads compiles.
#ifdef __unix__
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "host_support.hpp"

using namespace armlet;

namespace {

// Mistakes far into a statement, for which ANTLR interprets the grammar under its lock.
std::string text_with_mistakes() {
  std::string text;
  for (int i = 0; i < 40; ++i)
    text += "let a" + std::to_string(i) + " = [[fn(x: double[], y: int) => x[0]] 3 ; }\n";
  return text;
}

// Whether a child that compiles a program ends by itself.
bool child_compiles(const Engine& engine, const std::string& text) {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    alarm(20);  // a child that waits for a lock that nobody has is ended by it
    static_cast<void>(engine.compile(text, "wrong.rbt"));
    _exit(engine.compile("print(1)", "child.rbt").program ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

TEST_CASE("a child that is forked while a thread compiles can compile") {
  const Engine engine;
  const std::string wrong = text_with_mistakes();
  std::string whole;
  for (int i = 0; i < 1000; ++i) whole += "let a" + std::to_string(i) + " = 1 + 1\n";
  std::atomic<bool> end{false};
  const auto compile = [&](const std::string& text) {
    while (!end) static_cast<void>(engine.compile(text, "thread.rbt"));
  };
  std::thread first(compile, wrong);
  std::thread second(compile, whole);
  int compiled = 0;
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    compiled += child_compiles(engine, wrong) ? 1 : 0;
  }
  end = true;
  first.join();
  second.join();
  CHECK(compiled == 20);
}
#endif
