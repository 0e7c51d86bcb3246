#include "armlet/interpreter/host/program_function.hpp"

#include <atomic>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

#include "host_support.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

struct Gear {
  double ratio = 1.0;
  [[nodiscard]] bool operator==(const Gear&) const = default;
};
Gear make_gear(double ratio) { return {ratio}; }

Engine engine_with_gears() {
  Engine engine;
  engine.define(type<Gear>("Gear", "Two wheels.")
                    .constructor("(ratio: double)", &make_gear, "Of this ratio.", "Gear(2.0)")
                    .field("ratio", &Gear::ratio, "Of the speeds."));
  return engine;
}

}  // namespace

TEST_CASE("a function of the program is called by its name and type") {
  Hosted host(R"(
    var calls = 0
    fn half(x: double) -> double { calls += 1
      return 0.5 * x }
    fn times(n: int, s: string) -> string { var out = ""
      for (i in range(n)) { out = out + s }
      return out }
    fn mean(xs: double[]) -> double { var all = 0.0
      for (x in xs) { all += x }
      return all / xs.length }
    fn squares(n: int) -> double[] { var out: double[] = []
      for (i in range(n)) { out.push(double(i * i)) }
      return out }
    fn is_even(n: int) -> bool { return n % 2 == 0 }
    fn stop(v: speed, a: double) -> length { return 2s * v / a }
    fn note(what: string) { print(what) }
  )");
  const auto half = host.vm.function<double(double)>("half");
  for (int i = 0; i < 10; ++i) CHECK(*half(i) == 0.5 * i);
  CHECK(host.vm.global<std::int64_t>("calls") == 10);
  CHECK(*host.vm.function<std::string(std::int64_t, std::string_view)>("times")(3, "ab") ==
        "ababab");
  CHECK(*host.vm.function<double(std::vector<double>)>("mean")({1.0, 2.0, 6.0}) == 3.0);
  CHECK(*host.vm.function<std::vector<double>(std::int64_t)>("squares")(4) ==
        std::vector<double>{0.0, 1.0, 4.0, 9.0});
  CHECK(*host.vm.function<bool(std::int64_t)>("is_even")(4));
  CHECK(*host.vm.function<double(double, double)>("stop")(3.0, 2.0) == 3.0);  // SI units
  CHECK(host.vm.function<void(const std::string&)>("note")("said"));
  CHECK(host.printed == "said\n");
}

TEST_CASE("a function that is asked for wrongly is refused with both signatures") {
  Hosted host("fn on_tick(dt: time, gear: int) -> double { return 1.0 }\nfn none() { }");
  Vm& vm = host.vm;
  CHECK(refusal_of([&] { static_cast<void>(vm.function<double(double)>("on_tick")); }) ==
        "`on_tick(dt: time, gear: int) -> double` of the program cannot be called as "
        "`double(double)`: it has 2 parameters, and is given 1.");
  CHECK(
      refusal_of([&] { static_cast<void>(vm.function<double(double, std::string)>("on_tick")); }) ==
      "`on_tick(dt: time, gear: int) -> double` of the program cannot be called as "
      "`double(double, std::string)`: `gear` is an int, where C++ passes std::string.");
  CHECK(refusal_of([&] { static_cast<void>(vm.function<std::string()>("none")); }) ==
        "`none()` of the program cannot be called as `std::string()`: it gives nothing, where C++ "
        "wants std::string.");
  CHECK(refusal_of([&] { static_cast<void>(vm.function<void()>("on_tik")); }) ==
        "The program has no function `on_tik`; did you mean `on_tick`?");
  const auto absent = vm.try_function<void()>("on_tik");
  REQUIRE_FALSE(absent);
  CHECK(absent.error().message == "The program has no function `on_tik`; did you mean `on_tick`?");
}

TEST_CASE("a function is not called with what is no number and no text") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Hosted host(R"(
    var calls = 0
    fn wait_for(n: int, dt: time) -> double { calls += 1
      return dt / 1s }
    fn half(x: double) -> double { calls += 1
      return 0.5 * x }
    fn first(xs: double[]) -> double { calls += 1
      return xs[0] }
    fn same(s: string) -> string { calls += 1
      return s }
  )");
  Vm& vm = host.vm;
  const auto wait_for = vm.function<double(std::int64_t, double)>("wait_for");
  const auto half = vm.function<double(double)>("half");
  const auto first = vm.function<double(std::vector<double>)>("first");
  const auto of_values = vm.function<Value(Value)>("first");
  CHECK(refusal_of([&] { static_cast<void>(wait_for(1, kNan)); }) ==
        "`dt` of `wait_for` takes a time, and was given nan; any number will do, also an infinite "
        "one.");
  CHECK(refusal_of([&] { static_cast<void>(half(-kNan)); }).starts_with("`x` of `half` takes"));
  CHECK(refusal_of([&] {
          static_cast<void>(first({1.0, kNan}));
        }).starts_with("`xs` of `first` takes a double[], and was given nan"));
  CHECK(refusal_of([&] {
          static_cast<void>(of_values(std::vector<double>{1.0, kNan}));
        }).starts_with("Element 1 of `xs` takes a double, and was given nan"));
  CHECK(refusal_of(
            [&] { static_cast<void>(vm.function<std::string(std::string)>("same")("\xFF")); }) ==
        "`s` of `same` takes a string, and was given bytes that are no text in UTF-8, from byte 0 "
        "on.");
  CHECK(vm.global("calls") == 0);
  CHECK(*half(kInfinite) == kInfinite);
  CHECK(*wait_for(1, -kInfinite) == -kInfinite);
  CHECK(*first({kInfinite}) == kInfinite);
  CHECK(*of_values(std::vector<double>{-kInfinite}) == Value(-kInfinite));
  CHECK(vm.global("calls") == 4);
}

TEST_CASE("a failure of a function is reported, and the next call succeeds") {
  Hosted host(R"(
    fn at(i: int) -> double { let xs = [1.0, 2.0]
      return xs[i] }
  )");
  const auto at = host.vm.function<double(std::int64_t)>("at");
  CHECK(host.vm.error() == nullptr);
  CHECK_FALSE(at(7));
  REQUIRE(host.vm.error() != nullptr);
  CHECK(host.vm.error()->code == "R0606");
  CHECK(host.vm.error_text().find("host.rbt:3:") != std::string::npos);
  CHECK(*at(1) == 2.0);
}

TEST_CASE("values of any type go through Value, and those of the host through its types") {
  const Engine engine = engine_with_gears();
  Hosted host(R"(
    struct Stop { name: string = ""
      at: length = 0mm }
    fn next(stop: Stop) -> Stop { return Stop(name: stop.name + "!", at: stop.at + 5mm) }
    fn doubled(g: Gear) -> Gear { return Gear(2 * g.ratio) }
  )",
              {}, engine);
  const Value stop(Value::Record{"Stop", {{"name", "A"}, {"at", Value(1, "cm")}}});
  const auto next = host.vm.function<Value(Value)>("next")(stop);
  REQUIRE(next);
  CHECK((*next)["name"] == "A!");
  CHECK((*next)["at"].in("mm") == 15.0);
  CHECK(refusal_of([&] { static_cast<void>(host.vm.function<Value(Value)>("next")(3)); }) ==
        "`stop` takes a Stop, and was given an int.");
  CHECK(*host.vm.function<Gear(Gear)>("doubled")(Gear{1.5}) == Gear{3.0});
  CHECK(refusal_of([&] {
          static_cast<void>(host.vm.function<Gear(double)>("doubled"));
        }).ends_with("`g` is a Gear, where C++ passes double."));
}

TEST_CASE("limits hold for each call, and cancelling stops one") {
  VmOptions options;
  options.limits.steps = 1000;
  Hosted host(R"(
    fn turn(n: int) -> int { var k = 0
      while (k < n) { k += 1 }
      return k }
    fn endless() { while (true) { } }
    fn waits() { wait(1s) }
  )",
              options);
  const auto turn = host.vm.function<std::int64_t(std::int64_t)>("turn");
  for (int i = 0; i < 100; ++i) REQUIRE(*turn(900) == 900);  // 90,000 steps in all
  const auto endless = host.vm.function<void()>("endless");
  CHECK_FALSE(endless());
  CHECK(host.vm.error()->code == "R0622");
  CHECK_FALSE(host.vm.function<void()>("waits")());
  CHECK(host.vm.error()->message.find("wait") != std::string::npos);
}

TEST_CASE("a stop request that comes when nothing runs stops no later call") {
  Hosted host(
      "fn twice(x: int) -> int { return 2 * x }\nfn spin() { for (i in range(100000)) { } }");
  const auto twice = host.vm.function<std::int64_t(std::int64_t)>("twice");
  const auto spin = host.vm.function<void()>("spin");
  for (int i = 0; i < 3; ++i) {
    host.vm.cancel();
    CHECK(*twice(i) == 2 * i);
    host.vm.cancel();
    CHECK(spin());
  }
}

TEST_CASE("a call is stopped from another thread") {
  Hosted host("fn endless() { while (true) { } }", {.limits = {.steps = UINT64_MAX}});
  std::atomic<bool> has_ended{false};
  // A request that comes before the call has begun is too early, so it is repeated.
  std::thread other([&] {
    while (!has_ended) {
      host.vm.cancel();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  CHECK_FALSE(host.vm.function<void()>("endless")());
  has_ended = true;
  CHECK(host.vm.error()->code == "R0629");
  other.join();
}

TEST_CASE("a Vm that is busy refuses a second user, and stays as it was") {
  std::atomic<bool> is_inside{false};
  std::atomic<bool> may_leave{false};
  Vm* inner = nullptr;
  std::string re_entered;
  Engine engine;
  engine.define(def(
      "linger()",
      [&] {
        is_inside = true;
        while (!may_leave) std::this_thread::yield();
      },
      "Waits for the test.", "linger()"));
  engine.define(def(
      "again() -> int",
      [&]() -> std::int64_t {
        re_entered =
            refusal_of([&] { static_cast<void>(inner->function<std::int64_t()>("three")()); });
        return 1;
      },
      "Calls the program.", "again()"));
  Hosted host(R"(
    fn three() -> int { return 3 }
    fn lingers() { linger() }
    fn enters() -> int { return again() }
  )",
              {}, engine);
  inner = &host.vm;
  const auto three = host.vm.function<std::int64_t()>("three");
  std::thread other([&] { static_cast<void>(host.vm.function<void()>("lingers")()); });
  while (!is_inside) std::this_thread::yield();
  const std::string busy = "This Vm runs already, in another thread.";
  CHECK(refusal_of([&] { static_cast<void>(three()); }) == busy);
  CHECK(refusal_of([&] { static_cast<void>(host.vm.global("x")); }) == busy);
  CHECK(refusal_of([&] { host.vm.run({}); }) == busy);
  may_leave = true;
  other.join();
  CHECK(*three() == 3);
  CHECK(*host.vm.function<std::int64_t()>("enters")() == 1);
  CHECK(re_entered == "This Vm runs already: a function that it calls cannot run it.");
  CHECK(*three() == 3);
}

// The thread that made all calls so far is in the middle of one, or of beginning one, when the
// others come: two at once would lose a count.
TEST_CASE("threads that call at once are refused or served, never two at a time") {
  for (int round = 0; round < 50; ++round) {
    Hosted host("var count = 0\nfn bump() { count += 1 }");
    const auto bump = host.vm.function<void()>("bump");
    std::atomic<bool> others_may_come{false};
    std::atomic<std::int64_t> done{0};
    const auto call = [&](int times) {
      for (int i = 0; i < times; ++i) {
        try {
          if (bump()) ++done;
        } catch (const ArgumentError&) {
        }
      }
    };
    const auto come = [&] {
      while (!others_may_come) std::this_thread::yield();
      call(500);
    };
    std::thread first(come);
    std::thread second(come);
    call(round);  // the owner's
    others_may_come = true;
    call(5000);
    first.join();
    second.join();
    CHECK(host.vm.global<std::int64_t>("count") == done);
    CHECK(done >= round);
  }
}

TEST_CASE("what a function of the host throws is a failure of the program") {
  Engine engine;
  engine.define(def(
      "fuse() -> double", []() -> double { throw std::runtime_error("it is hot"); }, "Blows.",
      "fuse()"));
  Hosted host(R"(
    fn blown() -> double { return fuse() }
    fn caught() -> string { try { return f"{fuse()}" } catch (e) { return e.message } }
  )",
              {}, engine);
  CHECK_FALSE(host.vm.function<double()>("blown")());
  CHECK(host.vm.error()->message == "`fuse` failed: it is hot");
  CHECK(*host.vm.function<std::string()>("caught")() == "`fuse` failed: it is hot");
}

TEST_CASE("functions are called between two slices, and the run goes on as if they had not been") {
  const std::string text = R"(
    var n = 0
    var sum = 0
    fn peek() -> int { return 1000 * n + sum % 7 }
    for (i in range(300)) { n += 1
      sum += i * i }
    print(n, sum)
  )";
  Hosted whole(text);
  std::string printed;
  const Engine engine;
  Vm vm(compiled(engine, text), {.output = [&](std::string_view part) { printed += part; }});
  CHECK(refusal_of([&] { static_cast<void>(vm.function<std::int64_t()>("peek")()); }) ==
        "The program has not run yet, so nothing in it has a value; run it first.");
  std::mt19937 random(7);
  int looks = 0;
  std::int64_t last = 0;
  while (vm.run({.steps = 1 + random() % 9}) == Progress::kPaused) {
    if (!vm.try_global("sum")) continue;  // not yet
    const auto now = vm.function<std::int64_t()>("peek")();
    REQUIRE(now);
    CHECK(*now / 1000 == vm.global<std::int64_t>("n"));
    CHECK(*now >= last - 6);
    last = *now;
    ++looks;
  }
  CHECK(looks > 30);
  CHECK(printed == whole.printed);
}

TEST_CASE("steps of calls between slices are not steps of the program, nor the other way round") {
  const Engine engine;
  const auto program = compiled(engine, R"(
    fn turn(n: int) -> int { var k = 0
      while (k < n) { k += 1 }
      return k }
    while (true) { }
  )");
  const auto slices_until_limit = [&](bool calls) {
    Vm vm(program, {.limits = {.steps = 1000}});
    int slices = 0;
    while (vm.run({.steps = 90}) == Progress::kPaused) {
      if (calls) CHECK(*vm.function<std::int64_t(std::int64_t)>("turn")(900) == 900);
      ++slices;
    }
    CHECK(vm.result().error->code == "R0622");
    return slices;
  };
  CHECK(slices_until_limit(false) == 11);  // the limit is in the twelfth
  CHECK(slices_until_limit(true) == 11);
}

// What a thread has found of its stack holds there and no farther down, and not in another thread.
TEST_CASE("a function is called from any depth of any stack") {
  Hosted host("fn half(x: double) -> double { return x / 2 }");
  const auto half = host.vm.function<double(double)>("half");
  const std::function<double(int, double)> deep = [&](int levels, double x) {
    volatile char room[1000];
    room[0] = 0;
    if (levels > 0) return deep(levels - 1, x) + room[0];
    return *half(x);
  };
  for (const int levels : {0, 4500, 10, 1500, 0}) CHECK(deep(levels, 3.0) == 1.5);
  std::thread([&] { CHECK(deep(1000, 5.0) == 2.5); }).join();
  CHECK(deep(3, 7.0) == 3.5);
}

TEST_CASE("a function is not called before the variables have values") {
  const Engine engine;
  Vm vm(
      compiled(engine, "wait(1s)\nvar names = [\"a\"]\nfn first() -> string { return names[0] }"));
  CHECK(vm.run({.until_ns = 0}) == Progress::kPaused);
  const auto first = vm.function<std::string()>("first");
  CHECK(refusal_of([&] { static_cast<void>(first()); }) ==
        "`names` has no value yet: the program has not come to line 2, where it is declared.");
  CHECK(vm.run({}) == Progress::kDone);
  CHECK(*first() == "a");
}

TEST_CASE("a function goes with its entry, if that fails") {
  const Engine engine;
  Vm vm(compiled(engine, "fn half(x: double) -> double { return x / 2 }\nwait(1s)\nassert(false)",
                 {.is_entry = true}));
  CHECK(vm.run({.until_ns = 0}) == Progress::kPaused);
  const auto half = vm.function<double(double)>("half");
  CHECK(*half(3.0) == 1.5);
  CHECK(vm.run({}) == Progress::kFailed);
  for (int i = 0; i < 2; ++i) {
    CHECK(refusal_of([&] { static_cast<void>(half(3.0)); }) ==
          "This function is gone: the entry of the session that declares it has failed.");
  }
}

TEST_CASE("a function that is begun runs in slices, takes time and holds its arguments") {
  Hosted host(R"(
    var said: string[] = []
    fn say(what: string[], times: int) -> string[] {
      for (i in range(times)) { said.push(what[i % what.length]); wait(1s) }
      return said }
    fn bad() { assert(false) }
  )");
  Vm& vm = host.vm;
  const std::array<ValueKind, 2> takes{};
  const Result<ReadyFunction> say = ReadyFunction::find(vm, "say", takes, {});
  REQUIRE(say.ok());
  const std::vector<Value> arguments{Value({Value("a"), Value("b")}), Value(3)};
  CHECK(refusal_of([&] { say->begin(std::vector<Value>{Value(1)}); }) ==
        "This function has 2 parameters, and is given 1.");
  CHECK(refusal_of([&] {
          say->begin(std::vector<Value>{Value(1), Value(1)});
        }).find("`what`") != std::string::npos);
  for (int round = 1; round <= 2; ++round) {
    say->begin(arguments);
    CHECK(refusal_of([&] { say->begin(arguments); }) ==
          "A call in slices can begin only when what runs in the Vm has run to its end.");
    CHECK(vm.run({.until_ns = vm.timeline().now_ns() + 1'500'000'000}) == Progress::kPaused);
    while (vm.run({.until_ns = {}, .steps = 1}) == Progress::kPaused) {
    }
    CHECK(vm.result().status == Progress::kDone);
    CHECK(vm.timeline().now_ns() == round * 3'000'000'000);
    CHECK(vm.global("said").get<Value::List>().size() == 3U * static_cast<unsigned>(round));
  }
  ReadyFunction::find(vm, "bad", {}, {ValueKind::Form::kNothing}).value().begin({});
  CHECK(vm.run(Budget{}) == Progress::kFailed);
  say->begin(arguments);  // and is never run
}
