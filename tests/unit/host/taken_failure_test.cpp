#include "armlet/interpreter/host/taken_failure.hpp"

#include "host_support.hpp"

using namespace armlet;

namespace {

struct Found : FailureDetail {
  std::int64_t number = 0;
};

// f(7), or what the function left that failed, or the length of the message of an error of the kinds Lost and Blind.
Answer<std::int64_t> ask(Vm& vm, FunctionValue f) {
  constexpr std::string_view kKinds[] = {"Lost", "Blind"};
  const Slot arguments[] = {slot_of(std::int64_t{7})};
  Slot result;
  if (vm.call(f.object, arguments, result)) return result.i;
  const auto taken = take_failure(vm, kKinds);
  if (!taken) return Failed{};
  if (const auto* found = dynamic_cast<const Found*>(taken->detail.get())) return found->number;
  return static_cast<std::int64_t>(taken->message.size());
}

// Fails and leaves the number.
Answer<std::int64_t> lose(Vm& vm, std::int64_t number) {
  Failure f;
  f.headline = Headline("R0627", {"it is gone"});
  f.kind = "Lost";
  auto found = std::make_shared<Found>();
  found->number = number;
  f.detail = std::move(found);
  return fail(vm, std::move(f));
}

Engine engine_that_asks() {
  Engine engine;
  engine.define(def("ask(f: fn(int) -> int) -> int", &ask, "Asks.", "ask(fn(i) => i)"));
  engine.define(def("lose(number: int) -> int", &lose, "Fails.", "lose(3)"));
  return engine;
}

const std::string kFail = R"(
fn failing(kind: string, i: int) -> int {
    try { if (i > 0) { throw error("gone", kind: kind) } } finally { left += 1 }
    return i
}
)";

}  // namespace

TEST_CASE("a failure of an expected kind is taken back, and the native function goes on") {
  const Engine engine = engine_that_asks();
  const Hosted host("var left = 0\n" + kFail + R"(
    print(ask(fn(i) => i + 1), ask(fn(i) => failing("Lost", i)), ask(fn(i) => failing("Blind", i)))
    var sum = 0
    for (k in range(1000)) { sum += ask(fn(i) => failing("Lost", i)) }
    print(sum, left)
    try { ask(fn(i) => failing("Other", i)) } catch (e) { print(e.kind, e.message, left) }
  )",
                    {}, engine);
  CHECK(host.printed == "8 4 4\n4000 1002\nOther gone 1003\n");
}

TEST_CASE("what a function leaves that fails goes with its failure, and not with others") {
  const Engine engine = engine_that_asks();
  const Hosted host(R"(
    print(ask(fn(i) => lose(10 * i)))
    print(ask(fn(i) { try { return lose(3) } catch (e) { throw e } }))
    print(ask(fn(i) { try { return lose(3) } catch (e) { throw error("other", kind: "Lost") } }))
    print(ask(fn(i) { try { return lose(3) } finally { print("left") } }))
  )",
                    {}, engine);
  CHECK(host.printed == "70\n3\n5\nleft\n3\n");
}

TEST_CASE("a failure that no catch could take stays") {
  const Engine engine = engine_that_asks();
  VmOptions options;
  options.limits.steps = 100'000;
  Vm vm(compiled(engine, "print(ask(fn(i) { while (true) { } return i }))"), options);
  const RunResult result = vm.run();
  CHECK(result.status == Progress::kFailed);
  REQUIRE(result.error);
  CHECK(result.error->code == "R0622");
  // Without a failure there is nothing to take.
  const Hosted host("print(ask(fn(i) => i))", {}, engine);
  CHECK(host.printed == "7\n");
}
