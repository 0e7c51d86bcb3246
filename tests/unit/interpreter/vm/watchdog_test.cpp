#include "armlet/interpreter/host/watchdog.hpp"

#include <chrono>
#include <ctime>
#include <functional>
#include <thread>

#include "armlet/interpreter/format.hpp"
#include "vm_fixture.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

struct Guarded {
  Progress status;
  bool barked;
  std::string output;
};

Guarded run_guarded(const std::string& text, std::chrono::nanoseconds time) {
  Guarded guarded;
  VmOptions options;
  options.limits.steps = 1ULL << 60U;
  options.output = [&](std::string_view part) { guarded.output += part; };
  Vm vm(compiled(text), options);
  const Watchdog watchdog(vm, time);
  guarded.status = vm.run().status;
  guarded.barked = watchdog.has_barked();
  return guarded;
}

}  // namespace

TEST_CASE("a program that takes too long is cancelled, and its finally blocks run") {
  const Guarded endless = run_guarded("try { while (true) { } } finally { print(\"home\") }",
                                      std::chrono::milliseconds(20));
  CHECK(endless.status == Progress::kCancelled);
  CHECK(endless.barked);
  CHECK(endless.output == "home\n");
}

namespace {

using Seconds = std::chrono::duration<double>;

// What this process has computed, whatever else the machine does.
Seconds computed() { return Seconds(static_cast<double>(std::clock()) / CLOCKS_PER_SEC); }

// A stop request that comes from another thread when this process has computed for a while.
class Wish {
 public:
  explicit Wish(Seconds after)
      : thread_([this, begin = computed(), after] {
          while (computed() - begin < after && !ended_.load())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          wished_ = computed();
          flag.store(true);
        }) {}
  ~Wish() { thread_.join(); }
  Wish(const Wish&) = delete;
  Wish& operator=(const Wish&) = delete;

  // Computed since then.
  Seconds answered_in() {
    const Seconds now = computed();
    ended_.store(true);
    while (!flag.load()) std::this_thread::yield();
    return now - wished_;
  }

  std::atomic<bool> flag{false};

 private:
  std::atomic<bool> ended_{false};
  Seconds wished_{};
  std::thread thread_;
};

std::string repeated(int times, const std::function<std::string(int)>& part) {
  std::string out;
  for (int i = 0; i < times; ++i) out += part(i);
  return out;
}

// Programs that keep each part of the compiler busy in turn.
std::vector<std::string> long_programs() {
  const auto name = [](int i) { return std::to_string(i); };
  return {
      repeated(8'000, [&](int i) { return "var v" + name(i) + " = [1, 2, 3]\n"; }),
      repeated(2'000,
               [&](int i) {
                 return "fn f" + name(i) + "(x) { return x + " + name(i) + " }\nprint(f" + name(i) +
                        "(2))\n";
               }),
      repeated(4'000, [&](int i) { return "struct S" + name(i) + " { a: int; b: int[] }\n"; }),
      "var n = 0\n" + repeated(8'000, [](int) { return "if (n > 3) { n = n + 1 }\n"; }),
      repeated(15'000, [&](int i) { return "print(nobody" + name(i) + ")\n"; }),
      "/*" + std::string(400'000, '\n') + "*/\n" + std::string(50'000, ';'),
  };
}

}  // namespace

TEST_CASE("compiling that is not wanted before it begins ends without a program") {
  const std::atomic<bool> cancelled = true;
  CompileOptions options;
  options.cancelled = &cancelled;
  for (const char* text : {"print(1)\n", "print(nobody)\n", "print((\n"}) {
    const Compilation stopped = Engine().compile(text, "test.rbt", options);
    CHECK(stopped.cancelled);
    CHECK(stopped.program == nullptr);
    REQUIRE(stopped.diagnostics.size() == 1);
    CHECK(stopped.diagnostics[0].code == "R0629");
  }
  const Formatted formatted = format_program(Source("test.rbt", "print(1)\n"), &cancelled);
  CHECK_FALSE(formatted.text);
  REQUIRE(formatted.problems.size() == 1);
  CHECK(formatted.problems[0].code == "R0629");
}

TEST_CASE("compiling ends soon after it is cancelled, in each of its parts") {
  const Engine engine;
  for (const std::string& text : long_programs()) {
    const Seconds begin = computed();
    CHECK_FALSE(engine.compile(text, "test.rbt").cancelled);
    const Seconds whole = computed() - begin;
    for (const double part : {0.05, 0.4}) {
      CAPTURE(text.substr(0, 40));
      CAPTURE(part);
      Wish wish(part * whole);
      CompileOptions options;
      options.cancelled = &wish.flag;
      const Compilation stopped = engine.compile(text, "test.rbt", options);
      CHECK(wish.answered_in() <= whole / 3 + std::chrono::milliseconds(20));
      CHECK(stopped.cancelled);
      CHECK(stopped.program == nullptr);
    }
  }
}

TEST_CASE("laying out ends soon after it is cancelled") {
  const Source source("test.rbt", long_programs().front());
  const Seconds begin = computed();
  CHECK(format_program(source).text);
  const Seconds whole = computed() - begin;
  for (const double part : {0.05, 0.4, 0.6}) {
    CAPTURE(part);
    Wish wish(part * whole);
    const Formatted stopped = format_program(source, &wish.flag);
    CHECK(wish.answered_in() <= whole / 3 + std::chrono::milliseconds(20));
    CHECK_FALSE(stopped.text);
  }
}

TEST_CASE("a program that ends in time sees nothing of the limit") {
  const Guarded quick = run_guarded("print(1)", std::chrono::hours(1));
  CHECK(quick.status == Progress::kDone);
  CHECK_FALSE(quick.barked);
  CHECK(quick.output == "1\n");
}
