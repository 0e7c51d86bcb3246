// Types of a host, each declared in one expression.

#include "armlet/interpreter/define_type.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "driver/vocabulary.hpp"

namespace armlet {
namespace {

struct Finger {
  double length = 0.0;
  [[nodiscard]] std::string text() const { return "finger"; }
};
struct Maker {
  std::string maker = "us";
  [[nodiscard]] bool is_known() const noexcept { return !maker.empty(); }
};
struct Grip : Maker {
  double width = 0.0;
  std::int64_t count = 2;
  bool closed = false;
  std::vector<double> forces{};
  Finger finger{0.04};
  [[nodiscard]] bool operator==(const Grip& other) const { return width == other.width; }
  [[nodiscard]] Grip opened(std::optional<double> by) const {
    Grip out = *this;
    out.width += by.value_or(0.01);
    return out;
  }
  [[nodiscard]] Grip plus(const Grip& other) const { return opened(other.width); }
  [[nodiscard]] std::vector<Finger> fingers() const { return {{0.01}, {0.02}}; }
};
Answer<Grip> make_grip(Vm& vm, double width) {
  if (width < 0.0)
    return fail(vm, {.headline = Headline::own("R0609", "too narrow"), .mark = at("width")});
  Grip out;
  out.width = width;
  return out;
}
double total(HostList<Finger> fingers) {
  double sum = 0.0;
  for (std::size_t i = 0; i < fingers.size(); ++i) sum += fingers[i].length;
  return sum;
}

TypeOf<Grip> grip() {
  return type<Grip>("Grip", "Two fingers.")
      .constructor("(width: length = 80mm)", &make_grip, "A new one.", "Grip()")
      .assignable("width: length", &Grip::width, "Between the fingers.")
      .assignable("count", &Grip::count)
      .assignable("closed", &Grip::closed)
      .assignable("forces", &Grip::forces)
      .assignable("maker", &Grip::maker)
      .assignable("finger: Finger", &Grip::finger)
      .field("fixedCount: int", &Grip::count)
      .method("opened(by: length?) -> Grip", &Grip::opened, "Wider.", "Grip().opened()")
      .method("isKnown() -> bool", &Grip::is_known)
      .method("fingers() -> Finger[]", &Grip::fingers)
      .method("half() -> length", [](const Grip& g) { return g.width / 2.0; })
      .method("operator+(other: Grip) -> Grip", &Grip::plus)
      .noun("a grip", "holds things");
}
TypeOf<Finger> finger() {
  return type<Finger>("Finger", "One of several.").field("length: length", &Finger::length);
}

std::string printed_by(const Engine& engine, const std::string& text) {
  const Compilation compilation = engine.compile(text, "types.rbt");
  if (compilation.program == nullptr) return compilation.diagnostics.at(0).message;
  std::string printed;
  VmOptions options;
  options.output = [&](std::string_view part) { printed += part; };
  Vm vm(compilation.program, std::move(options));
  const RunResult result = vm.run();
  return result.error ? result.error->message : printed;
}

Engine engine_with_types() {
  Engine engine;
  engine.define(finger()).define(grip());
  engine.define(def("total(fingers: Finger[]) -> length", &total, "", ""));
  engine.define(def(
      "isGiven(g: Grip?) -> bool", [](const Grip* g) { return g != nullptr; }, "", ""));
  return engine;
}

TEST_CASE("a type of C++ is declared in one expression, with fields, methods and operators") {
  const Engine engine = engine_with_types();
  CHECK(engine.check_signatures().empty());
  const auto printed = [&](const std::string& text) { return printed_by(engine, text); };
  CHECK(printed("print(Grip().width, new Grip(5mm).width)") == "80 mm 5 mm\n");
  CHECK(printed("var g = Grip(10mm)\ng.width = 20mm\ng.width += 5mm\nprint(g.width)") == "25 mm\n");
  CHECK(printed("var g = Grip(10mm)\nlet h = g\ng.count = 3\nprint(g.count, h.count)") == "3 2\n");
  CHECK(printed("var g = Grip()\ng.closed = true\ng.forces = [1.0, 2.0]\ng.maker = \"you\"\n"
                "print(g.closed, g.forces, g.maker)") == "true [1.0, 2.0] you\n");
  CHECK(printed("var g = Grip()\nprint(g.finger, g.finger.length)") == "finger 40 mm\n");
  CHECK(printed("print(Grip(5mm).opened(by: 5mm).width, Grip(5mm).opened().width)") ==
        "10 mm 15 mm\n");
  CHECK(printed("let g = Grip(8mm)\nprint(g.isKnown(), g.half(), (g + g).width, g == Grip(8mm))") ==
        "true 4 mm 16 mm true\n");
  CHECK(printed("print(total(Grip().fingers()), isGiven(), isGiven(Grip()))") ==
        "30 mm false true\n");
  CHECK(printed("print(Grip())") == "Grip\n");
  CHECK(printed("print(Grip(0mm - 1mm))") == "too narrow");
}

TEST_CASE("programs that misuse a declared type get messages") {
  const Engine engine = engine_with_types();
  const auto has = [&](const std::string& text, std::string_view part) {
    const std::string told = printed_by(engine, text);
    CAPTURE(told);
    return told.find(part) != std::string::npos;
  };
  CHECK(has("let g = Grip()\nprint(g.weight)", "weight"));
  CHECK(has("var g = Grip()\ng.fixedCount = 3", "nothing can be stored in this place"));
  CHECK(has("var g = Grip()\ng.width = 3s", "length"));
}

TEST_CASE("engines may name one type of C++ differently, and share it once declared") {
  const TypeOf<Finger> declared = finger();
  Engine first, second;
  first.define(declared);
  second.define(type<Finger>("Digit", "").method("twice() -> Digit[]", [](const Finger& f) {
    return std::vector<Finger>{f, f};
  }));
  CHECK(first.registry().types().contains("Finger"));
  CHECK_THROWS_AS(first.define(declared), ArgumentError);
  second.define(def(
      "digit() -> Digit", [] { return Finger{}; }, "", ""));
  CHECK(printed_by(second, "print(digit().twice())") == "[finger, finger]\n");
}

// What defining the type is refused for.
std::string refusal(const TypeDefinition& definition) {
  Engine engine;
  engine.define(finger());
  const std::size_t types = engine.registry().types().size();
  try {
    engine.define(definition);
  } catch (const ArgumentError& error) {
    CHECK(engine.registry().types().size() == types);
    return error.what();
  }
  return "";
}

TEST_CASE("every mistake of a declaration is reported, and nothing of it is kept") {
  const auto has = [](const std::string& text, std::string_view part) {
    CAPTURE(text);
    return text.find(part) != std::string::npos;
  };
  const std::string all = refusal(type<Grip>("Grip", "")
                                      .field("width: string", &Grip::width)
                                      .field("finger", &Grip::finger)
                                      .field("2nd", &Grip::count)
                                      .method("opened(by: length) -> Grip", &Grip::opened)
                                      .method("plus(other: Finger) -> Grip", &Grip::plus)
                                      .method("half", [](const Grip& g) { return g.width; })
                                      .method("operator!(other: Grip) -> Grip", &Grip::plus));
  CHECK(has(all, "The type `Grip` cannot be defined: "));
  CHECK(has(all, "the field `finger` needs its type: \"finger: type\""));
  const std::string signatures =
      refusal(type<Grip>("Grip", "")
                  .field("width: string", &Grip::width)
                  .field("2nd", &Grip::count)
                  .method("opened(by: length) -> Grip", &Grip::opened)
                  .method("plus(other: Finger) -> Grip", &Grip::plus)
                  .method("half", [](const Grip& g) { return g.width; })
                  .method("operator!(other: Grip) -> Grip", &Grip::plus));
  CHECK(has(signatures, "`width`: the result is double in C++, where the signature asks for "));
  CHECK(has(signatures, "`2nd` cannot be a name"));
  CHECK(has(signatures, "`opened`: `by` is an optional double in C++, where the signature asks"));
  CHECK(has(signatures,
            "`other` is the value of a Grip in C++, where the signature asks for the "
            "value of a Finger"));
  CHECK(has(signatures, "`half`: `(` is missing"));
  CHECK(has(signatures, "`operator!` cannot be a name"));
  CHECK(has(refusal(type<Grip>("length", "")), "there is a type of this name"));
  CHECK(has(refusal(type<Grip>("Finger", "")), "there is a type of this name"));
  CHECK(has(refusal(type<Grip>("let", "")), "`let` cannot be a name"));
  CHECK(has(refusal(type<Finger>("Digit", "")), "its values are those of `Finger`"));
  CHECK(has(refusal(type<Grip>("Grip", "").field("a", &Grip::count).field("a", &Grip::count)),
            "is known to this engine already"));
  double (*nothing_behind)(const Grip&) = nullptr;
  CHECK(has(refusal(type<Grip>("Grip", "").method("weight() -> double", nothing_behind)),
            "there is no function behind `weight("));
}

}  // namespace
}  // namespace armlet
