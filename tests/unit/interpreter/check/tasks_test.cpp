// Tasks: their order, how they end, and what they leave behind (language reference, section 12).

#include "vm/tasks/tasks.hpp"

#include <string>
#include <thread>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/render.hpp"
#include "vm/state/state.hpp"
#include "vm_fixture.hpp"

namespace armlet::lang {

namespace {

// Keeps the Vm after the run, to look at what is left.
struct Kept {
  std::string output;
  std::unique_ptr<Vm> vm;
  RunResult result;

  explicit Kept(const std::string& text, RunLimits limits = {}) {
    VmOptions options;
    options.limits = limits;
    options.output = [this](std::string_view printed) { output += printed; };
    vm = std::make_unique<Vm>(compiled(text), options);
    result = vm->run();
  }
};

std::string task_of(const Outcome& outcome) {
  return outcome.error && outcome.error->when ? outcome.error->when->task : "no error";
}

// A program of nested blocks with everything that tasks can do, made from the numbers of a seed.
std::string random_tasks(Random& random, int depth) {
  const auto number = [&](std::uint64_t n) { return std::to_string(random.below(n)); };
  std::string text;
  for (std::uint64_t i = 0, count = 1 + random.below(3); i < count; ++i) {
    switch (random.below(depth > 0 ? 9 : 4)) {
      case 0:
        text += "x += " + number(9) + "; log += f\"{x} \"\n";
        break;
      case 1:
        text += "wait(" + number(50) + "ms); log += f\"{now():.3f s} \"\n";
        break;
      case 2:
        text += "try { wait until x > " + number(60) + ", timeout: " + number(40) +
                "ms; log += \"yes \" } catch (e) { log += \"no \" }\n";
        break;
      case 3:
        text += "if (x % 5 == " + number(5) + ") { throw error(\"x" + number(100) + "\") }\n";
        break;
      case 4:
        text += "parallel {\n{ " + random_tasks(random, depth - 1) + "}\n{ " +
                random_tasks(random, depth - 1) + "}\n}\n";
        break;
      case 5:
        text += "{ when (x % 3 == " + number(3) + ") { " + random_tasks(random, depth - 1) + "}\n" +
                random_tasks(random, depth - 1) + "}\n";
        break;
      case 6:
        text += "{ every (" + std::to_string(1 + random.below(20)) + "ms) { " +
                random_tasks(random, depth - 1) + "}\n" + random_tasks(random, depth - 1) + "}\n";
        break;
      case 7:
        text += "try { " + random_tasks(random, depth - 1) + "} finally { " +
                random_tasks(random, depth - 1) + "}\n";
        break;
      default:
        text += "try { " + random_tasks(random, depth - 1) +
                "} catch (e) { log += e.message + \" \" }\n";
        break;
    }
  }
  return text;
}

}  // namespace

TEST_CASE("nothing is left on the heap after tasks were cancelled") {
  const Kept kept(
      "fn work(xs: string[]) { var own = [xs[0] + \"!\"]\n"
      "  try { when (own.length > 0) { wait(9s); print(own[0]) }\n"
      "        parallel { { own.push(\"a\"); wait(9s) }; { wait(8s); own.push(\"b\") } } }\n"
      "  finally { print(own.length) } }\n"
      "try { parallel { work([\"x\"]); { wait(1s); throw error(\"stop\") } } }\n"
      "catch (e) { print(e.message) }");
  CHECK(kept.result.status == Progress::kDone);
  CHECK(kept.output == "2\nstop\n");
  kept.vm->state().clear();
  CHECK(kept.vm->state().heap.used() == 0);
}

TEST_CASE("the heap holds as much after a parallel as before it") {
  VmOptions options;
  std::vector<std::uint64_t> used;
  Vm* vm = nullptr;
  options.output = [&](std::string_view) { used.push_back(vm->state().heap.used()); };
  Vm made(compiled("fn f() { try { parallel { { var s = [\"a\"]; s.push(\"b\"); wait(9s) }\n"
                   "  { wait(1s); throw error(\"e\") } } } catch (e) { } }\n"
                   "f()\nprint(\"now\")\nfor (i in range(50)) { f() }\nprint(\"now\")"),
          options);
  vm = &made;
  CHECK(made.run().status == Progress::kDone);
  REQUIRE(used.size() == 2);
  CHECK(used[0] == used[1]);
}

TEST_CASE("a task counts as memory, and there is a limit to them") {
  const std::string many =
      "fn f(n: int) { if (n == 0) { wait(1s) } else { parallel { f(n - 1); f(n - 1) } } }\n";
  RunLimits limits;
  limits.heap_bytes = 1U << 20U;
  CHECK(run(many + "f(5)", limits).code().empty());
  CHECK(run(many + "f(8)", limits).code() == "R0628");
  CHECK(run(many + "f(13)").code() == "R0633");
  CHECK(run("fn f() { parallel { f() } }\nf()").code() == "R0633");
}

TEST_CASE("a failed start of tasks starts none of them") {
  RunLimits limits;
  limits.heap_bytes = 1U << 16U;
  CHECK(run("try { parallel { print(1); print(2); print(3); print(4); print(5); print(6);"
            "print(7); print(8) } } catch (e) { print(\"none\") }",
            limits)
            .output == "none\n");
}

TEST_CASE("a host may let virtual time end earlier") {
  RunLimits limits;
  limits.time_ns = 10'000'000'000;
  CHECK(run("wait(4s)\nwait(6s)\nprint(now())", limits).output == "10 s\n");
  const auto late = run("wait(4s)\ntry { wait(7s) } catch (e) { print(e.message) }", limits);
  CHECK(late.output == "a wait of 7 s would end after virtual time does: at most 6 s are left\n");
  CHECK(run("while (true) { wait(1s) }", limits).code() == "R0636");
  CHECK(run("every (1s) { }\nwait until false", limits).code() == "R0636");
  CHECK(run("wait until false, timeout: 10.5s", limits).code() == "R0636");
  limits.time_ns = 0;
  CHECK(run("print(1)\nwait(0s)\nprint(2)", limits).output == "1\n2\n");
  CHECK(run("wait(1ms)", limits).code() == "R0636");
  for (const std::int64_t end_ns : {std::int64_t{-1}, kEndOfTime_ns + 1}) {
    limits.time_ns = end_ns;
    CHECK_THROWS_AS(run("print(1)", limits), ArgumentError);
  }
}

TEST_CASE("messages name the task") {
  CHECK(task_of(run("parallel {\nwait(1s)\n{ wait(1s); throw error(\"x\") }\n}")) ==
        "branch 2 of parallel on line 1");
  CHECK(task_of(run("wait(1s)\nwhen (now() > 2s) { throw error(\"x\") }\nwait(9s)")) ==
        "when on line 2");
  CHECK(task_of(run("every (1s) { throw error(\"x\") }\nwait(9s)")) == "every on line 1");
  CHECK(task_of(run("wait(1s)\nthrow error(\"x\")")).empty());
  CHECK(task_of(run("let xs = [1]\nvar i = 0\nparallel { { wait(1s); i = 5 }\n"
                    "wait until xs[i] > 1 }")) == "branch 2 of parallel on line 3");
}

TEST_CASE("editors get the task too") {
  const std::string text = "parallel {\n{ wait(1s); throw error(\"x\") }\n}";
  const Outcome outcome = run(text);
  REQUIRE(outcome.error);
  const std::string json = render_json(*outcome.error, compiled(text)->sources());
  CHECK(json.find("\"task\":\"branch 1 of parallel on line 1\"") != std::string::npos);
}

TEST_CASE("cancelling reaches all tasks, which run their finally blocks") {
  const Outcome outcome =
      run("try { parallel { { try { wait(9s) } finally { print(\"a\") } }\n"
          "{ try { wait(1s); cancelNow(); wait(9s) } finally { print(\"b\") } } } }\n"
          "catch (e) { print(\"never\") } finally { print(\"c\") }");
  CHECK(outcome.status == Progress::kCancelled);
  CHECK(outcome.output == "a\nb\nc\n");
}

TEST_CASE("cancelling twice leaves at once") {
  const Outcome outcome = run(
      "try { parallel { { try { cancelNow(); wait(9s) } finally { wait(1s); cancelNow(); wait(1s)\n"
      "print(\"never\") } }; wait(99s) } } finally { print(\"never\") }");
  CHECK(outcome.status == Progress::kCancelled);
  CHECK(outcome.output.empty());
}

TEST_CASE("another thread can cancel tasks that never pause, and tasks that wait") {
  for (const char* body : {"while (true) { }", "while (true) { wait(1ms) }"}) {
    Vm vm(compiled(std::string("parallel { { ") + body + " }\n{ " + body + " } }"), {});
    std::thread other([&] { vm.cancel(); });
    const RunResult result = vm.run();
    other.join();
    CHECK(result.status == Progress::kCancelled);
  }
}

TEST_CASE("a task that never pauses is stopped, whatever the others do") {
  RunLimits limits;
  limits.steps = 10'000;
  const Outcome outcome = run(
      "parallel { { for (i in range(99)) { wait(1s) } }\n{ wait(2s); while (true) { } } }", limits);
  CHECK(outcome.code() == "R0622");
  CHECK(task_of(outcome) == "branch 2 of parallel on line 1");
  CHECK(run("fn w() { for (i in range(9000)) { } }\nparallel { w(); w(); w() }", limits)
            .code()
            .empty());
  CHECK(run("while (true) { when (true) { } }", limits).code() == "R0647");
}

TEST_CASE("tasks cannot start where time cannot pass") {
  // Only a function that comes from elsewhere gets past the check (E0520).
  for (const char* body : {"parallel { print(1) }", "when (true) { print(1) }"}) {
    const std::string text =
        std::string("let f = fn(x: double) { ") + body + "\n return x }\nprint(map([1.0], f))";
    CHECK(run(text).code() == "R0632");
  }
}

TEST_CASE("stuck tasks are listed with what they wait for") {
  const Outcome outcome =
      run("var a = false\nparallel {\nwait until a\n{ wait(1s); wait until a && a }\n}");
  CHECK(outcome.code() == "R0621");
  REQUIRE(outcome.error);
  CHECK(outcome.error->why ==
        "branch 1 of parallel on line 2 waits for `a`\n"
        "branch 2 of parallel on line 2 waits for `a && a`");
}

TEST_CASE("a task that waits for ever while it cleans up does not hold the others") {
  const Outcome outcome = run(
      "try { parallel { { try { wait(9s) } finally { try { wait until false } finally {"
      "print(\"a\") } } }\n{ wait(1s); throw error(\"stop\") } } } catch (e) { print(e.message) }");
  CHECK(outcome.status == Progress::kDone);
  CHECK(outcome.output == "a\nstop\n");
}

TEST_CASE("skipped beats are reported once, at the end, for each `every`") {
  const Outcome outcome =
      run("fn f() { every (1s) { wait(1.5s) }\nwait(4s) }\nf()\nf()\n"
          "{ every (1s) { }\nwait(5s) }");
  REQUIRE(outcome.advice.size() == 1);
  CHECK(outcome.advice[0].code == "W0706");
  CHECK(outcome.advice[0].message == "4 beats of `every` were skipped");
}

TEST_CASE("beats come at exact multiples of a period that no double holds exactly") {
  const Outcome outcome =
      run("var n = 0\n{ every (0.1s) { n += 1 }\nwait(1000.05s) }\nprint(n, now())");
  CHECK(outcome.output == "10001 1000.05 s\n");
}

TEST_CASE("a run can be repeated to the letter") {
  Random random(20'260'101);
  int ended_well = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string text = "var x = 0\nvar log = \"\"\ntry {\n" + random_tasks(random, 3) +
                             "} catch (e) { log += e.message } finally { print(log, x, now()) }";
    CAPTURE(text);
    RunLimits limits;
    limits.steps = 100'000;
    const std::shared_ptr<const Program> program = compiled(text);
    const Outcome first = outcome_of(program, limits);
    const Outcome second = outcome_of(program, limits);
    CHECK(first.output == second.output);
    CHECK(first.steps == second.steps);
    CHECK(first.code() == second.code());
    CHECK(first.advice.size() == second.advice.size());
    if (first.status == Progress::kDone) ++ended_well;
    const Kept kept(text, limits);
    kept.vm->state().clear();
    CHECK(kept.vm->state().heap.used() == 0);
    CHECK(kept.vm->state().tree.all().empty());
  }
  CHECK(ended_well > 200);
}

TEST_CASE("running out of memory anywhere among tasks leaks nothing") {
  const std::string text =
      "fn f(s: string) { var xs = [s]\ntry { when (xs.length > 2) { wait(1s); xs.push(s + \"w\") "
      "}\n"
      "parallel { { xs.push(s + \"a\"); wait(1s) }; { wait(500ms); xs.push(s + \"b\")\n"
      "if (s == \"y\") { throw error(s + \"!\") } } } } finally { xs.push(s + \"c\") } }\n"
      "try { f(\"x\"); f(\"y\") } catch (e) { print(e.message) }";
  const std::shared_ptr<const Program> program = compiled(text);
  bool done = false;
  for (std::uint64_t n = 1; !done; ++n) {
    CAPTURE(n);
    REQUIRE(n < 10'000);
    Vm vm(program, {});
    vm.state().heap.refuse_from(n);
    const RunResult result = vm.run();
    vm.state().clear();
    CHECK(vm.state().heap.used() == 0);
    done = result.status == Progress::kDone && n > 200;
    if (done) CHECK(result.error == std::nullopt);
  }
}

}  // namespace armlet::lang
