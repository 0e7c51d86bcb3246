#include "armlet/interpreter/host/globals.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "host_support.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

constexpr const char* kAll = R"(
  enum State { Idle, Busy }
  struct Stop { name: string = ""
    at: length = 0mm }
  var on = true
  var count = 3
  var ratio = 0.25
  var speed = 200mm/s
  var name = "left"
  var xs = [1.0, 2.5]
  var ks = [1, 2]
  var names = ["a", "b"]
  var rows = [[1.0], [2.0, 3.0]]
  var A = [1, 2, 3; 4, 5, 6]
  var stop = Stop(name: "A", at: 5mm)
  var stops = [Stop(name: "B", at: 1m)]
  var state = State.Busy
  var stock = {"bolt": 3, "nut": 5}
  let limit = 7
  fn show() -> string { return f"{on} {count} {ratio} {speed} {name} {xs} {ks} {names} {rows} {A} {stop} {stops} {state} {stock}" }
)";

constexpr const char* kNames[] = {"on",    "count", "ratio", "speed", "name",  "xs",    "ks",
                                  "names", "rows",  "A",     "stop",  "stops", "state", "stock"};

}  // namespace

TEST_CASE("variables of every type are read as values with their units") {
  Hosted host(kAll);
  Vm& vm = host.vm;
  CHECK(vm.global("on") == true);
  CHECK(vm.global("count") == 3);
  CHECK(vm.global("ratio") == 0.25);
  CHECK(vm.global("speed") == Value(0.2, "m/s"));
  CHECK(vm.global("speed").in("mm/s") == 200.0);
  CHECK(vm.global("name") == "left");
  CHECK(vm.global("xs") == std::vector<double>{1.0, 2.5});
  CHECK(vm.global("names") == Value{"a", "b"});
  CHECK(vm.global("A") == Value(Value::Matrix{2, 3, {1, 2, 3, 4, 5, 6}}));
  CHECK(vm.global("stop")["at"].in("cm") == 0.5);
  CHECK(vm.global("state") == Value(Value::Enum{"State", "Busy"}));
  CHECK(vm.global("stock") == Value(Value::Map{{"bolt", 3}, {"nut", 5}}));
  CHECK(vm.global("limit") == 7);
  CHECK(vm.global<double>("speed") == 0.2);
  CHECK(vm.global<std::string>("name") == "left");
  CHECK(vm.global<std::vector<double>>("xs") == std::vector<double>{1.0, 2.5});
  CHECK(vm.global<bool>("on"));
}

TEST_CASE("a value that is read and set again changes nothing that the program sees") {
  Hosted host(kAll);
  const auto show = host.vm.function<std::string()>("show");
  const std::string before = *show();
  for (const char* name : kNames) {
    CAPTURE(name);
    const Value value = host.vm.global(name);
    host.vm.set(name, value);
    CHECK(host.vm.global(name) == value);
    CHECK(*show() == before);
  }
}

TEST_CASE("variables are set, and the program sees it") {
  Hosted host(kAll);
  Vm& vm = host.vm;
  vm.set("on", false);
  vm.set("count", 4);
  vm.set("ratio", 2);  // an int where a double is
  vm.set("speed", 1.5, "mm/s");
  vm.set("name", "right");
  vm.set("xs", std::vector<double>{3.0});
  vm.set("names", {"x"});
  vm.set("state", Value::Enum{"State", "Idle"});
  vm.set("stock", Value::Map{{"pin", 1}});
  const std::string seen = *vm.function<std::string()>("show")();
  CHECK(seen ==
        "false 4 2.0 0.0015 m/s right [3.0] [1, 2] [\"x\"] [[1.0], [2.0, 3.0]] "
        "[1.0, 2.0, 3.0; 4.0, 5.0, 6.0] Stop(name: \"A\", at: 5 mm) [Stop(name: \"B\", at: 1 m)] "
        "State.Idle [\"pin\": 1]");
}

TEST_CASE("what does not fit a variable is refused, and it stays as it was") {
  Hosted host(kAll);
  Vm& vm = host.vm;
  CHECK(refusal_of([&] { vm.set("speed", 0.2); }) ==
        "`speed` takes a speed, and was given a double; give its unit, such as \"m/s\".");
  CHECK(refusal_of([&] { vm.set("speed", 0.2, "mm"); }) ==
        "`speed` takes a speed, and was given a length.");
  CHECK(
      refusal_of([&] { vm.set("speed", 0.2, "parsec"); }).starts_with("There is no unit `parsec`"));
  CHECK(refusal_of([&] { vm.set("count", 1.5); }) ==
        "`count` takes an int, and was given a double.");
  CHECK(refusal_of([&] {
          vm.set("names", {"x", 1});
        }) == "Element 1 of `names` takes a string, and was given an int.");
  CHECK(refusal_of([&] {
          vm.set("state", Value::Enum{"State", "Gone"});
        }) == "`state` takes a value of State, which has no `Gone`.");
  CHECK(refusal_of([&] {
          vm.set("stop", Value::Record{"Stop", {{"name", "A"}}});
        }) == "`stop` needs the field `at` of Stop.");
  CHECK(refusal_of([&] { vm.set("limit", 8); }) ==
        "`limit` is fixed: line 19 says `let` or `final`; `var` can be set.");
  CHECK(refusal_of([&] { vm.set("spede", 1); }) ==
        "The program has no variable `spede`; did you mean `speed`?");
  CHECK(refusal_of([&] { static_cast<void>(vm.global<std::string>("count")); }) ==
        "`count` is an int in the program, which is no std::string in C++.");
  CHECK(vm.try_set("speed", 1)->message ==
        "`speed` takes a speed, and was given an int; give its unit, such as \"m/s\".");
  CHECK_FALSE(vm.try_set("count", 9));
  CHECK(vm.try_global("nothing").error().message == "The program has no variable `nothing`.");
  Hosted fresh(kAll);
  fresh.vm.set("count", 9);
  CHECK(*vm.function<std::string()>("show")() == *fresh.vm.function<std::string()>("show")());
}

TEST_CASE("what is not a number is refused where it comes from, and infinities are numbers") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr const char* kAnyNumber = " was given nan; any number will do, also an infinite one.";
  Hosted host(kAll);
  Vm& vm = host.vm;
  const std::string before = *vm.function<std::string()>("show")();
  CHECK(refusal_of([&] { vm.set("ratio", kNan); }) ==
        std::string("`ratio` takes a double, and") + kAnyNumber);
  CHECK(refusal_of([&] { vm.set("speed", -kNan, "mm/s"); }) ==
        std::string("`speed` takes a speed, and") + kAnyNumber);
  CHECK(refusal_of([&] {
          vm.set("xs", std::vector<double>{1.0, kInfinite, kNan});
        }) == std::string("Element 2 of `xs` takes a double, and") + kAnyNumber);
  CHECK(refusal_of([&] {
          vm.set("A", Value::Matrix{1, 2, {1.0, kNan}});
        }) == std::string("`A` takes a matrix, and") + kAnyNumber);
  CHECK(refusal_of([&] {
          vm.set("stops", {Value::Record{"Stop", {{"name", "C"}, {"at", Value(kNan, "m")}}}});
        }) ==
        std::string("The field `at` of element 0 of `stops` takes a length, and") + kAnyNumber);
  CHECK(*vm.function<std::string()>("show")() == before);
  for (const double number : {kInfinite, -kInfinite}) {
    vm.set("ratio", number);
    vm.set("speed", number, "m/s");
    vm.set("xs", std::vector<double>{number});
    CHECK(vm.global<double>("ratio") == number);
    CHECK(vm.global("speed") == Value(number, "m/s"));
    CHECK(vm.global<std::vector<double>>("xs") == std::vector<double>{number});
  }
  CHECK(vm.function<std::string()>("show")()->find("-inf -inf m/s left [-inf]") !=
        std::string::npos);
}

TEST_CASE("texts of programs are UTF-8, and ints have a largest one") {
  Hosted host(kAll);
  Vm& vm = host.vm;
  for (const char* broken :
       {"\xFF", "ab\xC3", "\x80", "\xED\xA0\x80", "\xC0\xAF", "\xF4\x90\x80\x80"})
    CHECK(refusal_of([&] {
            vm.set("name", broken);
          }).starts_with("`name` takes a string, and was given bytes that are no text in UTF-8"));
  CHECK(refusal_of([&] {
          vm.set("names", {"a", "ab\xC3"});
        }) ==
        "Element 1 of `names` takes a string, and was given bytes that are no text in UTF-8, from "
        "byte 2 on.");
  CHECK(vm.global("name") == "left");
  for (const char* whole : {"", "\x7F", "\u00e4\u20ac", "\U0001F600\U0010FFFF"}) {
    vm.set("name", whole);
    CHECK(vm.global("name") == whole);
  }
  CHECK(refusal_of([&] { vm.set("count", std::uint64_t{1} << 63U); }) ==
        "9223372036854775808 is beyond the largest int of a program, 9223372036854775807.");
  CHECK(vm.global("count") == 3);
  vm.set("count", (std::uint64_t{1} << 63U) - 1);
  CHECK(vm.global("count") == std::numeric_limits<std::int64_t>::max());
}

TEST_CASE("a new version of a program takes over what the old one has computed, also nan") {
  constexpr const char* kText = "fn zero() -> double { return 0.0 }\nvar x = zero()\n";
  Hosted old(std::string(kText) + "x = zero() / zero()");
  Hosted fresh(kText);
  CHECK(carry_globals(old.vm, fresh.vm).kept == std::vector<std::string>{"x"});
  CHECK(std::isnan(fresh.vm.global<double>("x")));
}

TEST_CASE("a number with a unit is the same bits as the literal of a program") {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> numbers(-1000.0, 1000.0);
  for (const char* unit : {"mm", "deg", "deg/s", "g", "kg*m^2", "rpm", "ms"}) {
    for (int i = 0; i < 20; ++i) {
      const double number = std::round(numbers(random) * 1e3) / 1e3;
      char literal[64];
      std::snprintf(literal, sizeof literal, "var x = %.3f%s", number, unit);
      if (parse_unit(unit))
        CHECK_MESSAGE(Hosted(literal).vm.global("x") == Value(number, unit), literal);
    }
  }
}

TEST_CASE("between two slices of a loop a variable can be set, and the loop sees it") {
  const Engine engine;
  Vm vm(compiled(engine, "var go = true\nvar n = 0\nwhile (go) { n += 1 }"));
  int slices = 0;
  while (vm.run({.steps = 50}) == Progress::kPaused) {
    if (++slices == 4) vm.set("go", false);
    REQUIRE(slices < 10);
  }
  CHECK(vm.result().status == Progress::kDone);
  CHECK(vm.global<std::int64_t>("n") > 100);
}

TEST_CASE("a new version of a program takes over what has the same name and type") {
  Hosted old(R"(
    struct Stop { name: string = "" }
    enum State { Idle, Busy }
    var count = 1
    var speed = 1m/s
    var stop = Stop(name: "A")
    var state = State.Busy
    var names = ["a"]
    var gone = 1
    var was_var = 5
    let fixed = 1
    fn twice(x: double) -> double { return 2 * x }
    var f = twice
  )");
  old.vm.set("count", 41);
  old.vm.set("names", {"a", "b"});
  Hosted fresh(R"(
    struct Stop { name: string = ""
      at: length = 0mm }
    enum State { Idle, Busy }
    var count = 0
    var speed = 1.0
    var stop = Stop(name: "B")
    var state = State.Idle
    var names: string[] = []
    let was_var = 6
    let fixed = 2
    var extra = 1
    fn twice(x: double) -> double { return 2 * x }
    var f = twice
  )");
  const CarriedGlobals carried = carry_globals(old.vm, fresh.vm);
  CHECK(carried.kept == std::vector<std::string>{"count", "state", "names"});
  CHECK(carried.fresh == std::vector<std::string>{"extra"});
  std::string lost;
  for (const auto& [name, why] : carried.lost) lost += name + ": " + why + '\n';
  CHECK(lost ==
        "speed: it was a speed, and is a double\n"
        "stop: a Stop is no longer what it was\n"
        "was_var: it is fixed now\n"
        "f: it is a function, which belongs to its program\n"
        "gone: it is gone\n");
  CHECK(fresh.vm.global("count") == 41);
  CHECK(fresh.vm.global("names") == Value{"a", "b"});
  CHECK(fresh.vm.global("state") == Value(Value::Enum{"State", "Busy"}));
  CHECK(fresh.vm.global("was_var") == 6);
  CHECK(fresh.vm.global("fixed") == 2);
}

TEST_CASE("a closed program shows no variables") {
  const Engine engine;
  Vm vm(compiled(engine, "var x = 1", {.open = false}));
  CHECK(vm.run({}) == Progress::kDone);
  CHECK(vm.try_global("x").error().message == "The program has no variable `x`.");
}
