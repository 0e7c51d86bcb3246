// Functions of C++ as functions of the language, by their own types.

#include "armlet/interpreter/define.hpp"

#include <doctest/doctest.h>

#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"

namespace armlet {

namespace {
struct Pear {
  double weight = 0.0;
  bool operator==(const Pear&) const = default;
  [[nodiscard]] double times(double k) const { return k * weight; }
  [[nodiscard]] std::string text() const {
    return "pear of " + std::to_string(static_cast<int>(weight));
  }
};
// With a destructor that counts.
struct Crate {
  std::shared_ptr<int> content;
};
const HostType kPear = host_type<Pear>("pear", "A fruit.");
const HostType kCrate = host_type<Crate>("crate", "Holds something.");
const HostType kStone{.name = "stone", .size = sizeof(int)};
}  // namespace

template <>
inline constexpr const HostType* kHostType<Pear> = &kPear;
template <>
inline constexpr const HostType* kHostType<Crate> = &kCrate;

namespace {

double mixed(double x, std::int64_t n, bool minus) {
  return minus ? x - static_cast<double>(n) : x + static_cast<double>(n);
}
Answer<double> root(Vm& vm, double x) {
  if (x < 0.0) return fail(vm, {.headline = Headline::own("R0609", "no root"), .mark = at("x")});
  return x / 2.0;
}
std::string twice(std::string_view text) { return std::string(text) + std::string(text); }
std::vector<double> shifted(std::span<const double> xs, std::optional<double> by) {
  std::vector<double> out(xs.begin(), xs.end());
  for (double& x : out) x += by.value_or(1.0);
  return out;
}
std::int64_t count(std::span<const Slot> items) { return static_cast<std::int64_t>(items.size()); }
Pear pear(double weight) { return {weight}; }
double weight(const Pear& p) { return p.weight; }
const std::shared_ptr<int> kContent = std::make_shared<int>(7);
Crate crate() { return {kContent}; }
std::int64_t content(const Crate& c) { return *c.content; }
bool is_given(const Pear* p) { return p != nullptr; }
std::vector<Pear> split(const Pear& p) { return {{p.weight / 2.0}, {p.weight / 4.0}}; }
double total(HostList<Pear> pears) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pears.size(); ++i) sum += pears[i].weight;
  return sum;
}
Answer<double> sum_of_doubles(const ScriptFunction<double(double)>& f, std::int64_t n) {
  double sum = 0.0;
  for (std::int64_t i = 0; i < n; ++i) {
    const Answer<double> y = f(static_cast<double>(i));
    if (!y) return Failed{};
    sum += *y;
  }
  return sum;
}
double trace_of(const MatrixObj& m) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < m.rows; ++i) sum += m.data()[i * m.cols + i];
  return sum;
}
Answer<void> nothing(Vm& vm, bool fails) {
  if (fails) return fail(vm, {.headline = Headline::own("R0609", "as asked")});
  return {};
}
std::string why_root(double x) { return "the root of " + std::to_string(static_cast<int>(x)); }

constexpr NativeFunction kTyped[] = {
    def<mixed>("mixed(x: double, n: int = 2, minus: bool = false) -> double", "", ""),
    def<root>("root(x: double) -> double", "", "", {.explain = explained_by<why_root>}),
    def<twice>("twice(text: string) -> string", "", ""),
    def<shifted>("shifted(xs: double[], by: double?) -> double[]", "", ""),
    def<count>("count(xs: T[]) -> int", "", ""),
    def<pear>("pear(weight: double) -> pear", "", ""),
    def<&Pear::weight>("pear.weight(p: pear) -> double", "", ""),
    def<&Pear::times>("times(p: pear, k: double) -> double", "", ""),
    def<crate>("crate() -> crate", "", ""),
    def<content>("content(c: crate) -> int", "", ""),
    def<is_given>("isGiven(p: pear?) -> bool", "", ""),
    def<split>("split(p: pear) -> pear[]", "", ""),
    def<total>("total(pears: pear[]) -> double", "", ""),
    def<sum_of_doubles>("sumOf(f: fn(double) -> double, n: int) -> double", "", ""),
    def<trace_of>("traceOf(m: matrix) -> double", "", ""),
    def<nothing>("nothing(fails: bool)", "", ""),
    def<&Pear::text>("explain(p: pear) -> string", "", ""),
    def<[](double x) { return -x; }>("minus(x: double) -> double", "", ""),
};

struct Run {
  std::string printed;
  std::string error;
};
Run run(const Engine& engine, const std::string& text) {
  const Compilation compilation = engine.compile(text, "typed.rbt");
  for (const Diagnostic& d : compilation.diagnostics) CAPTURE(d.message);
  REQUIRE(compilation.program != nullptr);
  Run out;
  VmOptions options;
  options.output = [&](std::string_view part) { out.printed += part; };
  Vm vm(compilation.program, std::move(options));
  const RunResult result = vm.run();
  if (result.error) out.error = result.error->message;
  return out;
}

Engine typed_engine() {
  Engine engine;
  engine.add_type(kPear).add_type(kCrate).add_functions(kTyped);
  return engine;
}

TEST_CASE("functions of C++ take and give values of their own types") {
  const Engine engine = typed_engine();
  CHECK(engine.check_signatures().empty());
  const auto printed = [&](const std::string& text) { return run(engine, text).printed; };
  CHECK(printed("print(mixed(1.5), mixed(1.5, 3), mixed(1.5, 3, minus: true))") ==
        "3.5 4.5 -1.5\n");
  CHECK(printed("print(root(4.0))") == "2.0\n");
  CHECK(printed("print(twice(\"ab\"))") == "abab\n");
  CHECK(printed("print(shifted([1.0, 2.0]), shifted([1.0], by: 0.5))") == "[2.0, 3.0] [1.5]\n");
  CHECK(printed("print(count([1, 2, 3]), count([\"a\"]))") == "3 1\n");
  CHECK(printed("print(pear(8.0), pear(8.0).weight)") == "pear of 8 8.0\n");
  CHECK(printed("print(isGiven(), isGiven(pear(1.0)))") == "false true\n");
  CHECK(printed("print(split(pear(8.0)), total(split(pear(8.0))))") ==
        "[pear of 4, pear of 2] 6.0\n");
  CHECK(printed("print(pear(8.0) == pear(8.0), pear(8.0) == pear(7.0))") == "true false\n");
  CHECK(printed("print(pear(8.0).times(3.0))") == "24.0\n");
  CHECK(printed("let c = crate()\nprint(content(c), content(crate()))") == "7 7\n");
  CHECK(kContent.use_count() == 1);
  CHECK(printed("print(sumOf(fn(x) => x * x, 4))") == "14.0\n");
  CHECK(printed("print(traceOf([1.0, 2.0; 3.0, 4.0]))") == "5.0\n");
  CHECK(printed("nothing(false)\nprint(minus(2.0))") == "-2.0\n");
}

TEST_CASE("what a typed function refuses is a failure of the program") {
  const Engine engine = typed_engine();
  CHECK(run(engine, "print(root(0.0 - 4.0))").error == "no root");
  CHECK(run(engine, "nothing(true)").error == "as asked");
  CHECK(run(engine, "print(sumOf(fn(x) => root(2.5 - x), 9))").error == "no root");
  CHECK(run(engine, "try { nothing(true) } catch (e) { print(\"caught\") }").printed == "caught\n");
  CHECK(run(engine, "print(explain(root(9.0)))").printed == "the root of 9\n");
}

TEST_CASE("functions that keep values of their own are kept by the engine and its programs") {
  auto log = std::make_shared<std::vector<double>>();
  Compilation compilation;
  {
    Engine engine;
    const double factor = 3.0;
    engine.define(def(
        "scaled(x: double) -> double", [factor](double x) { return factor * x; }, "Three times x.",
        "scaled(2.0)"));
    engine.define(def(
        "logged(x: double) -> int",
        [log](double x) {
          log->push_back(x);
          return static_cast<std::int64_t>(log->size());
        },
        "Keeps x.", "logged(1.0)"));
    engine.define(def("mixed(x: double, n: int, minus: bool) -> double", &mixed, "", ""));
    compilation = engine.compile(
        "print(scaled(2.0), logged(5.0), logged(6.0), mixed(1.0, 2, false))", "kept.rbt");
  }
  REQUIRE(compilation.program != nullptr);
  std::string printed;
  {
    VmOptions options;
    options.output = [&](std::string_view part) { printed += part; };
    Vm vm(compilation.program, std::move(options));
    CHECK(vm.run().status == Progress::kDone);
  }
  CHECK(printed == "6.0 1 2 3.0\n");
  CHECK(*log == std::vector<double>{5.0, 6.0});
  compilation = {};
  CHECK(log.use_count() == 1);
}

// What defining `mixed` under this signature is refused for.
std::string refusal(const std::string& signature) {
  Engine engine;
  engine.add_type(kPear).add_type(kStone);
  try {
    engine.define(def(signature, &mixed, "", ""));
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("every difference between a signature and the types of C++ is reported") {
  const auto has = [](const std::string& text, std::string_view part) {
    CAPTURE(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(refusal("mixed(x: angle, n: int, minus: bool) -> length").empty());
  CHECK(has(refusal("mixed(x: double, n: int) -> double"),
            "the signature has 2 parameters, the function in C++ 3"));
  const std::string wrong = refusal("mixed(x: string, n: int?, minus: bool) -> pear");
  CHECK(has(wrong, "`x` is double in C++, where the signature asks for std::string_view"));
  CHECK(has(wrong, "`n` is std::int64_t in C++, where the signature asks for an optional "));
  CHECK(
      has(wrong, "the result is double in C++, where the signature asks for the value of a pear"));
  CHECK(has(refusal("mixed(x: double, x: int, minus: bool) -> double"),
            "two parameters are called `x`"));
  CHECK(has(refusal("mixed(x: double, n: nothing, minus: bool) -> double"), "nothing"));
  CHECK(has(refusal("mixed(x: double, n: int, minus: bool)"), "the result is double"));
  CHECK(has(refusal("mixed(x: double[], n: int, minus: bool) -> double"),
            "asks for std::span<const double>"));

  CHECK(has(refusal("mixed"), "`(` is missing"));
  CHECK(has(refusal(""), "it has no name"));
  CHECK(has(refusal("(x: double, n: int, minus: bool) -> double"), "it has no name"));
  double (*nothing_behind)(double) = nullptr;
  CHECK_THROWS_AS(def("f(x: double) -> double", nothing_behind, "", ""), ArgumentError);

  Engine engine;
  engine.add_type(kPear).add_type(kStone);
  CHECK_THROWS_WITH_AS(engine.define(def("weigh(p: stone) -> double", &weight, "", "")),
                       doctest::Contains("the value of a pear in C++"), ArgumentError);
  CHECK_THROWS_AS(engine.define(def("f(m: matrix) -> double", &total, "", "")), ArgumentError);
  CHECK_NOTHROW(engine.define(def("f(p: pear[]) -> double", &total, "", "")));
  CHECK_THROWS_AS(engine.define(def("f(p: pear[]) -> double", &total, "", "")), ArgumentError);
}

}  // namespace
namespace {

// Why the engine refuses a function; empty: it does not.
template <class F>
std::string refusal(const char* signature, F function) {
  Engine engine;
  try {
    engine.define(def(signature, function, "Help.", "f()"));
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a default has the type of its parameter") {
  const auto of_double = [](double x) { return x; };
  const auto of_int = [](std::int64_t x) { return x; };
  const auto of_bool = [](bool x) { return x; };
  const auto of_text = [](std::string_view x) { return static_cast<std::int64_t>(x.size()); };
  for (const char* written : {"3", "-2.5", "90deg"})
    CHECK(refusal((std::string("f(x: double = ") + written + ") -> double").c_str(), of_double) ==
          "");
  CHECK(refusal("f(x: length = 3mm) -> length", of_double) == "");
  CHECK(refusal("f(x: length = 0) -> length", of_double) == "");
  CHECK(refusal("f(x: bool = true) -> bool", of_bool) == "");
  CHECK(refusal("f(x: string = \"a\") -> int", of_text) == "");
  const auto names = [](const std::string& why, std::string_view is, std::string_view not_this) {
    CHECK_MESSAGE(why.find("the default of `x` is " + std::string(is) + ", not " +
                           std::string(not_this)) != std::string::npos,
                  why);
  };
  names(refusal("f(x: double = \"a\") -> double", of_double), "a string", "double");
  names(refusal("f(x: double = true) -> double", of_double), "a bool", "double");
  names(refusal("f(x: int = 2.5) -> int", of_int), "a double", "int");
  names(refusal("f(x: bool = 3) -> bool", of_bool), "an int", "bool");
  names(refusal("f(x: length = 3) -> length", of_double), "an int", "length");
  names(refusal("f(x: length = 3s) -> length", of_double), "a time", "length");
  names(refusal("f(x: string = 3mm) -> int", of_text), "a length", "string");
}

TEST_CASE("functions and their parameters have names that programs can write") {
  const auto half = [](double x) { return 0.5 * x; };
  for (const char* good : {"f", "group.f", "na\u00EFve", "test", "path"})
    CHECK(refusal((std::string(good) + "(x: double) -> double").c_str(), half) == "");
  for (const char* bad : {"while", "2f", "a b", "f.", ".f", "f.if", "a-b", "\u540D", "double"}) {
    const std::string why = refusal((std::string(bad) + "(x: double) -> double").c_str(), half);
    CHECK_MESSAGE(why.find("cannot be a name") != std::string::npos, bad, ": ", why);
  }
  CHECK(refusal("f(every: double) -> double", half) == "");
  CHECK(refusal("f(while: double) -> double", half).find("`while` cannot be a name") !=
        std::string::npos);
}

}  // namespace armlet
