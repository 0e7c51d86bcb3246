#include "armlet/interpreter/host/memory.hpp"

#include <cstdlib>
#include <map>
#include <memory_resource>

#include "host_support.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

// Memory that counts, and refuses the n-th block.
struct Counter {
  std::map<void*, std::size_t> blocks;
  std::size_t taken = 0;
  std::size_t refused = 0;  // which; 0: none
  bool is_right = true;     // every block came back as it was taken

  Memory memory() {
    return {[](void* self, std::size_t bytes) { return static_cast<Counter*>(self)->take(bytes); },
            [](void* self, void* block, std::size_t bytes) {
              static_cast<Counter*>(self)->give_back(block, bytes);
            },
            this};
  }

 private:
  void* take(std::size_t bytes) {
    if (++taken == refused) return nullptr;
    void* block = std::aligned_alloc(16, (bytes + 15) / 16 * 16);
    blocks[block] = bytes;
    return block;
  }
  void give_back(void* block, std::size_t bytes) {
    const auto found = blocks.find(block);
    is_right = is_right && found != blocks.end() && found->second == bytes;
    blocks.erase(block);
    std::free(block);
  }
};

constexpr const char* kProgram = R"(
  var texts: string[] = []
  var A = [1, 2; 3, 4]
  for (i in range(40)) { texts.push("a text that is long enough, number " + f"{i}") }
  var large = new double[20000]
  var text = "x"
  for (i in range(14)) { text = text + text }
  var names = {"a": [1.0], "b": [2.0]}
  fn grown(n: int) -> double[] { var xs: double[] = []
    for (i in range(n)) { xs.push(double(i)) }
    return xs }
  print(texts.length, large.length, text.length)
)";

struct Outcome {
  Progress status = Progress::kDone;
  std::string message;
  std::string why;
};

Outcome outcome_with(Counter& counter, const std::shared_ptr<const Program>& program) {
  Vm vm(program, {.memory = counter.memory()});
  const RunResult result = vm.run();
  if (result.status == Progress::kDone) {
    const auto grown = vm.function<std::vector<double>(std::int64_t)>("grown")(5000);
    if (grown) return {};
    return {Progress::kFailed, vm.error()->message, vm.error()->why};
  }
  return {result.status, result.error->message, result.error->why};
}

}  // namespace

TEST_CASE("the memory of a program's values is the host's, and all of it comes back") {
  const Engine engine;
  const auto program = compiled(engine, kProgram);
  Counter counter;
  CHECK(outcome_with(counter, program).status == Progress::kDone);
  CHECK(counter.taken > 5);
  CHECK(counter.blocks.empty());
  CHECK(counter.is_right);
}

TEST_CASE("each block that the host refuses fails the program clearly, and nothing is lost") {
  const Engine engine;
  const auto program = compiled(engine, kProgram);
  Counter all;
  static_cast<void>(outcome_with(all, program));
  for (std::size_t n = 1; n <= all.taken; ++n) {
    CAPTURE(n);
    Counter counter{.refused = n};
    const Outcome outcome = outcome_with(counter, program);
    CHECK(outcome.status == Progress::kFailed);
    CHECK(outcome.message.starts_with("the program needs more than "));
    CHECK(outcome.why.starts_with("the host gives no more; the limit of this program is "));
    CHECK(counter.blocks.empty());
    CHECK(counter.is_right);
  }
}

TEST_CASE("a value for which the host gives no memory is refused as that") {
  Counter counter;
  const Engine engine;
  Vm vm(compiled(engine, kProgram), {.memory = counter.memory()});
  REQUIRE(vm.run().status == Progress::kDone);
  const std::vector<double> other(30'000, 1.0);
  counter.refused = counter.taken + 1;
  CHECK(refusal_of([&] { vm.set("large", other); }) ==
        "`large` finds no memory: the host of the program gives none.");
  CHECK(vm.global<std::vector<double>>("large") == std::vector<double>(20'000, 0.0));
  vm.set("large", other);
  CHECK(vm.global<std::vector<double>>("large") == other);
}

TEST_CASE("a memory resource of the standard library serves, also one that throws") {
  const Engine engine;
  const auto program = compiled(engine, kProgram);
  std::pmr::monotonic_buffer_resource pool;
  Vm vm(program, {.memory = memory_of(pool)});
  CHECK(vm.run().status == Progress::kDone);
  Vm starved(program, {.memory = memory_of(*std::pmr::null_memory_resource())});
  const RunResult result = starved.run();
  CHECK(result.status == Progress::kFailed);
  CHECK(result.error->code == "R0628");
}

TEST_CASE("the limit of a program is said where the limit is what stops it") {
  Counter counter;
  const Engine engine;
  VmOptions options{.limits = {.heap_bytes = 100'000}, .memory = counter.memory()};
  Vm vm(compiled(engine, kProgram), options);
  const RunResult result = vm.run();
  CHECK(result.status == Progress::kFailed);
  CHECK(result.error->message == "the program needs more than 100000 bytes of memory");
  CHECK(result.error->why.empty());
}
