#include "armlet/interpreter/work.hpp"

#include <algorithm>

#include "armlet/core/random.hpp"
#include "vm/state/state.hpp"
#include "vm_fixture.hpp"

using namespace armlet;
using namespace armlet::lang;

namespace {

// A machine whose library functions a test calls itself.
struct Bench {
  explicit Bench(RunLimits limits = {}) : vm(compiled("print(1)"), options(limits)) {}
  static VmOptions options(RunLimits limits) {
    VmOptions made;
    made.limits = limits;
    return made;
  }
  std::uint64_t steps() {
    const StepMeter& meter = vm.state().steps;
    return meter.total + static_cast<std::uint64_t>(meter.chunk - meter.left);
  }
  Vm vm;
};

std::string taken(Vm& vm, TextMaker& text) {
  Obj* made = text.take();
  std::string out(text_value({.o = made}));
  release(vm, made);
  return out;
}

const char* const kLinks =
    "struct N { next: N[] }\nvar n = N([])\nvar m = N([])\nvar i = 0\n"
    "while (i < 60) { n = N([n, n]); m = N([m, m]); i = i + 1 }\n";

}  // namespace

TEST_CASE("blocks cover everything once, and count as steps in proportion") {
  Bench bench;
  std::vector<int> seen(1'000'000);
  REQUIRE(in_blocks(bench.vm, seen.size(), 8, [&](std::size_t begin, std::size_t end) {
    CHECK(end - begin <= kBlockWork / 8);
    for (std::size_t i = begin; i < end; ++i) ++seen[i];
  }));
  CHECK(std::ranges::all_of(seen, [](int count) { return count == 1; }));
  CHECK(bench.steps() >= 8 * seen.size() / kWorkPerStep - 100);
  CHECK(bench.steps() <= 8 * seen.size() / kWorkPerStep + 100);
  CHECK(in_blocks(bench.vm, 0, 8, [](std::size_t, std::size_t) { return false; }));
}

TEST_CASE("a block that gives false ends the work, and so does the limit of steps") {
  Bench free;
  Bench bench({.steps = 1000});
  int blocks = 0;
  CHECK(!in_blocks(free.vm, 1'000'000, 8, [&](std::size_t, std::size_t) { return ++blocks < 2; }));
  CHECK(blocks == 2);
  CHECK(!in_blocks(bench.vm, 1'000'000, 8, [&](std::size_t, std::size_t) { ++blocks; }));
  CHECK(blocks <= 3);
  CHECK(bench.vm.state().fault->diagnostic.code == "R0622");
}

TEST_CASE("a text made piece by piece is the text of its pieces, and counts against the heap") {
  Bench bench({.heap_bytes = 1'000'000});
  std::string expected;
  {
    TextMaker text(bench.vm);
    for (int i = 0; i < 2000; ++i) {
      const std::string piece(static_cast<std::size_t>(i % 97), static_cast<char>('a' + i % 26));
      expected += piece;
      REQUIRE(text.add(piece));
    }
    CHECK(bench.vm.state().heap.used() >= expected.size());
    CHECK(taken(bench.vm, text) == expected);
  }
  TextMaker endless(bench.vm);
  bool goes_on = true;
  for (int i = 0; goes_on && i < 2000; ++i) goes_on = endless.add(std::string(1000, 'x'));
  CHECK(!goes_on);
  CHECK(endless.take() == nullptr);
  CHECK(bench.vm.state().fault->diagnostic.code == "R0628");
  CHECK(bench.vm.state().heap.used() == 0);
}

TEST_CASE("a text is found where the C++ library finds it") {
  Bench bench({.steps = 1ULL << 40U});
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    std::string text;
    const std::size_t size = round < 290 ? random.below(200) : 300'000 + random.below(300'000);
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>('a' + random.below(2));
    const std::size_t length = round % 3 == 2 && size > 0 ? random.below(size) : random.below(8);
    const std::size_t from = random.below(size + 2);
    std::string what = text.substr(size / 3, length);
    if (random.below(4) == 0 && !what.empty()) what.back() = 'c';
    std::size_t at = 0;
    REQUIRE(find_text(bench.vm, text, what, from, at));
    CHECK(at == text.find(what, from));
  }
}

TEST_CASE("equality of values that share their parts takes as long as they have parts") {
  const Outcome outcome =
      run(std::string(kLinks) + "print(n == m)\nprint(n == n)", {.steps = 2000});
  CHECK(outcome.status == Progress::kDone);
  CHECK(outcome.output == "true\ntrue\n");
}

TEST_CASE("a number that is not equal to itself is found among shared parts too") {
  CHECK(output_of("let nan = 0.0 / 0.0\nlet a = [nan]\nlet b = [a, a]\nlet c = [b, b]\n"
                  "print(c == c, b == b, a == a)") == "false false false\n");
  CHECK(output_of("let a = [1.0]\nlet b = [a, a]\nlet c = [b, b]\nlet d = [[[1.0], [1.0]], b]\n"
                  "print(c == c, c == d, d == [b, [a, [2.0]]])") == "true true false\n");
}

TEST_CASE("random values that share parts are equal when their texts are") {
  Random random(11);
  for (int round = 0; round < 40; ++round) {
    std::string text = "let v0 = [[1.0], [2.0]]\nlet w0 = [[1.0], [2.0]]\n";
    for (int i = 1; i <= 5; ++i) {
      const std::string left = std::to_string(random.below(2));
      const std::string now = std::to_string(i);
      const std::string before = std::to_string(i - 1);
      for (const std::string name : {"v", "w"}) {
        const std::string other = random.below(8) == 0 ? "w" : name;
        text += "let " + name + now + " = [" + name + before + ", " + other + before + "]\n";
      }
    }
    text += "var x = w5\n";
    if (random.below(2) == 0) text += "x[0][1][0][1][0][1][0] = 3.0\n";
    CHECK(output_of(text + "print((v5 == x) == (f\"{v5}\" == f\"{x}\"))") == "true\n");
  }
}

TEST_CASE("what a long comparison keeps in mind counts against the heap") {
  const std::string links =
      "struct N { next: N[] }\nvar n = N([])\nvar m = N([])\nvar i = 0\n"
      "while (i < 3000) { n = N([n]); m = N([m]); i = i + 1 }\nprint(n == m)";
  CHECK(run(links).output == "true\n");
  CHECK(run(links, {.heap_bytes = 560'000}).code() == "R0628");
}

TEST_CASE("the text of values that share their parts ends at the limit of steps or of the heap") {
  const std::string shown = std::string(kLinks) + "print(f\"{n}\".length)";
  CHECK(run(shown, {.steps = 100'000}).code() == "R0622");
  CHECK(run(shown, {.heap_bytes = 1'000'000}).code() == "R0628");
}

TEST_CASE("deep calls count against the heap") {
  const std::string deep =
      "fn f(n: int) -> int { return n == 0 ? 0 : f(n - 1) + 1 }\nprint(f(9000))";
  CHECK(run(deep).output == "9000\n");
  CHECK(run(deep, {.heap_bytes = 100'000}).code() == "R0628");
  // What a deep call took is given back to the tasks that come after it.
  const std::string tasks =
      "fn f(n: int) -> int { return n == 0 ? 0 : f(n - 1) + 1 }\n"
      "for (i in range(20)) { parallel { assert(f(2000) == 2000) } }\nprint(1)";
  CHECK(run(tasks, {.heap_bytes = 1'000'000}).output == "1\n");
}

TEST_CASE("copies and texts of the machine count as steps") {
  const auto steps = [](const std::string& text) { return run(text).steps; };
  const std::string list = "var a = new double[1000000]\n";
  const std::uint64_t base = steps(list);
  CHECK(steps(list + "var b = a\nb[0] = 1.0\na[1] = 1.0") > base + 10'000);
  CHECK(steps(list + "let b = a[0:900000]") > base + 10'000);
  CHECK(steps(list + "print(a == a)") > base + 3'000);
  CHECK(steps(list + "let t = f\"{a}\"") > base + 100'000);
  const std::string text = "var s = \"abcdefghij\"\nfor (i in range(17)) { s += s }\n";
  const std::uint64_t base_text = steps(text);
  CHECK(steps(text + "let t = s + s") > base_text + 5'000);
  CHECK(steps(text + "print(s.length)") > base_text + 4'000);
  CHECK(steps(text + "print(s < s + \"a\")") > base_text + 8'000);
}
