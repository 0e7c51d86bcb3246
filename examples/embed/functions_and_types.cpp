// Functions and a type of the host, as a program uses them.
#include <armlet/interpreter/host.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <stdexcept>

namespace {

// A tank of water; a program works on copies, as with every value.
class Tank {
 public:
  explicit Tank(double height) : height(height) {}
  [[nodiscard]] Tank filled(double by) const { return Tank(height + by); }
  [[nodiscard]] bool operator==(const Tank&) const = default;
  [[nodiscard]] std::string text() const {
    return std::to_string(std::lround(height * 1e3)) + " mm of water";
  }

  double height;  // m
};

Tank make_tank(double height) { return Tank(height); }

// Returns a number, or a failure with the reason why there is none.
armlet::Answer<double> level_of(armlet::Vm& vm, const Tank& tank, double full) {
  if (full > 0.0) return tank.height / full;
  return armlet::fail(vm, {.headline = {"R0626", {"`level` needs a height above 0"}}});
}

}  // namespace

int main() {
  armlet::Engine engine;
  engine.define(armlet::type<Tank>("Tank", "A tank of water.")
                    .constructor("(height: length)", &make_tank, "Filled so high.", "Tank(1m)")
                    .assignable("height: length", &Tank::height, "Of the water.")
                    .method("filled(by: length) -> Tank", &Tank::filled, "With more in it."));
  engine.define(armlet::def("level(tank: Tank, full: length) -> double", &level_of,
                            "How full it is, from 0 to 1.", "level(Tank(1m), 2m)"));
  // A function with data of its own that throws: the program can catch this error.
  const std::map<std::string, double> sizes{{"small", 0.5}, {"large", 2.0}};
  engine.define(armlet::def(
      "height_of(kind: string) -> length",
      [sizes](std::string_view kind) { return sizes.at(std::string(kind)); },
      "The height of a kind of tank.", "height_of(\"small\")"));

  const armlet::Compilation compiled = engine.compile(R"(
    var tank = Tank(height_of("small")).filled(by: 20cm)
    tank.height += 50mm
    print(tank, level(tank, full: height_of("large")))
    try { print(level(tank, full: 0m)) } catch (e) { print(e.message) }
    try { print(height_of("huge")) } catch (e) { print("no such tank") }
  )",
                                                      "tanks.rbt");
  std::cout << compiled.text();
  if (!compiled.program) return 1;
  armlet::Vm vm(compiled.program, {.output = [](std::string_view text) { std::cout << text; }});
  std::cout << (vm.run().status == armlet::Progress::kDone ? "done" : vm.error_text()) << '\n';
  std::cout << vm.global<Tank>("tank").text() << '\n';
}

// Prints:
// 750 mm of water 0.375
// `level` needs a height above 0
// no such tank
// done
// 750 mm of water
