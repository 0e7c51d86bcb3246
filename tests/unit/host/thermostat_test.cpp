// A host that heats rooms: what the language says of exclusive resources, names and failures comes
// from it. This program is linked with the interpreter alone.

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/define_type.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/interpreter/resource.hpp"
#include "armlet/interpreter/world_names.hpp"

namespace armlet {
namespace {

// ---- the house ----------------------------------------------------------------------------------

struct Radiator {
  std::string name;
  double power = 0.0;  // W
  bool is_on = false;
};

class House : public Timeline {
 public:
  double temperature = 18.0;  // of all rooms, degrees Celsius
  std::vector<std::unique_ptr<Radiator>> radiators;

  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_; }
  [[nodiscard]] std::int64_t tick_ns() const override { return 100'000'000; }
  bool advance_to(std::int64_t t_ns) override {
    const double dt = static_cast<double>(t_ns - now_ns_) * 1e-9;
    for (const auto& radiator : radiators)
      temperature += radiator->is_on ? radiator->power * dt * 1e-4 : 0.0;
    now_ns_ = t_ns;
    return true;
  }

 private:
  std::int64_t now_ns_ = 0;
};

House& house(Vm& vm) { return *static_cast<House*>(vm.host()); }

// ---- its words ----------------------------------------------------------------------------------

std::string heater_called(std::string_view name) { return "the heater of " + std::string(name); }
constexpr ResourceWords kHeaterWords{
    .plural = "heaters",
    .act = "heat",
    .acts = "the heating",
    .act_on_one = "heat a room",
    .busy = "is heating already",
    .still = "still heating",
    .begun = "the heater had been on",
    .not_begun = "nothing has been heated",
    .called = heater_called,
};

constexpr CatalogEntry kMessages[] = {
    {"E0901", "", "there is no room called \"{}\"", "\nRooms are those of the house.\n"},
    {"R0901", "Frost", "`{}` cannot heat below {} degrees", "\nWater freezes.\n"},
};

// A heater of the house, as a value of programs.
struct Heater {
  Radiator* radiator = nullptr;
  bool operator==(const Heater&) const = default;
  [[nodiscard]] std::string text() const { return radiator->name; }
  [[nodiscard]] double power() const { return radiator->power; }
};

class Heating final : public Waiting {
 public:
  Heating(House& house, Resource heater, Radiator& radiator, double seconds)
      : house_(house),
        heater_(std::move(heater)),
        radiator_(radiator),
        due_ns_(house.now_ns() + static_cast<std::int64_t>(seconds * 1e9)) {
    radiator_.is_on = true;
  }
  [[nodiscard]] std::int64_t due_ns() const override { return due_ns_; }
  [[nodiscard]] bool is_over() const override { return house_.now_ns() >= due_ns_; }
  void stop() override { due_ns_ = house_.now_ns(); }
  Signal finish(Vm&, Slot&) override {
    radiator_.is_on = false;
    return Signal::kDone;
  }
  [[nodiscard]] std::string what() const override { return "heat"; }
  [[nodiscard]] Resource resource() const override { return heater_; }

 private:
  House& house_;
  Resource heater_;
  Radiator& radiator_;
  std::int64_t due_ns_;
};

const TypeOf<Heater>& heater_type() {
  static const TypeOf<Heater> type = [] {
    TypeOf<Heater> heater = armlet::type<Heater>("heater", "Heats a room.");
    heater.method("power() -> double", &Heater::power, "In watts.")
        .handle()
        .ambient()
        .exclusive(kHeaterWords);
    return heater;
  }();
  return type;
}

Resource resource_of(const Heater& heater) {
  return {&heater_type().type(), heater.radiator->name};
}

Heater declared_heater(Vm& vm, std::string_view name, std::optional<double> power) {
  auto& all = house(vm).radiators;
  all.push_back(
      std::make_unique<Radiator>(Radiator{std::string(name), power.value_or(1000.0), false}));
  return {all.back().get()};
}

Answer<std::unique_ptr<Waiting>> warm(Vm& vm, const Heater& heater, double seconds) {
  const Resource resource = resource_of(heater);
  if (!require_free(vm, resource)) return Failed{};
  if (house(vm).temperature < 0.0) {
    return fail(
        vm,
        {.headline = {kMessages[1], {resource.name, "0"}}, .resource = resource, .moved = false});
  }
  return std::unique_ptr<Waiting>(
      std::make_unique<Heating>(house(vm), resource, *heater.radiator, seconds));
}

void check_room(CheckCall& call) {
  const auto name = call.constant(at("room"));
  if (!name || call.world() == nullptr || call.world()->has(name->text)) return;
  Diagnostic d = make_diagnostic(kMessages[0], call.span(at("room")), {name->text});
  d.why = "the rooms of " + call.world()->world + " are";
  for (const std::string& thing : call.world()->things) d.why += ' ' + thing;
  call.report(std::move(d));
}

Engine thermostat() {
  Engine engine;
  engine.define(heater_type()).add_messages(kMessages);
  engine.define(def("heater{}(name: string, power: double?) -> heater", &declared_heater, "", ""));
  engine.define(def("warm(h: heater, time: time)", &warm, "", "", {.pauses = true}));
  engine.define(def(
      "temperature() -> double", [](Vm& vm) { return house(vm).temperature; }, "", ""));
  engine.define(def("area(room: string) -> double", [](std::string_view) { return 20.0; }, "", "",
                    {.check = check_room}));
  return engine;
}

// ---- programs -----------------------------------------------------------------------------------

struct Outcome {
  std::string printed;
  std::string told;  // the messages as people read them
  double temperature = 0.0;
};

Outcome run(const std::string& text, double temperature = 18.0) {
  static const Engine engine = thermostat();
  CompileOptions options;
  options.world = std::make_shared<const WorldNames>(WorldNames{"the house", {"kitchen", "bath"}});
  const Compilation compilation = engine.compile(text, "house.rbt", options);
  Outcome out;
  for (const Diagnostic& d : compilation.diagnostics)
    out.told += render_text(d, *compilation.sources);
  if (compilation.program == nullptr) return out;
  House house;
  house.temperature = temperature;
  Vm vm(compilation.program, {.timeline = &house,
                              .host = &house,
                              .output = [&](std::string_view part) { out.printed += part; }});
  const RunResult result = vm.run();
  if (result.error) out.told += render_text(*result.error, *compilation.sources);
  out.temperature = house.temperature;
  return out;
}

bool has(const std::string& text, std::string_view part) {
  CAPTURE(text);
  CAPTURE(part);
  const bool found = text.find(part) != std::string::npos;
  CHECK(found);
  return found;
}

TEST_CASE("heaters are declared, commanded by tasks, and guarded") {
  const Outcome both =
      run("heater living { power: 2000.0 }\n"
          "heater bath { power: 1000.0 }\n"
          "parallel { living.warm(time: 10s); bath.warm(time: 20s) }\n"
          "print(living, living.power(), living == bath)\n");
  CHECK(both.told == "");
  CHECK(both.printed == "living 2000.0 false\n");
  CHECK(both.temperature == doctest::Approx(22.0));

  const Outcome guarded =
      run("heater living { power: 2000.0 }\n"
          "var looks = 0\n"
          "{\n"
          "  every (1s) { looks = looks + 1 }\n"
          "  warm(time: 100s) until temperature() > 20.95\n"
          "}\n"
          "print(looks)\n");
  CHECK(guarded.told == "");
  CHECK(guarded.temperature == doctest::Approx(21.0).epsilon(0.01));
  CHECK(guarded.printed.size() == 3);  // between 14 and 16 looks

  const Outcome watched =
      run("heater living { power: 2000.0 }\n"
          "{\n"
          "  when (temperature() > 19.0) { print(\"warm\") }\n"
          "  warm(time: 10s)\n"
          "}\n");
  CHECK(watched.told == "");
  CHECK(watched.printed == "warm\n");
}

TEST_CASE("two branches that command one heater are refused in the words of the host") {
  const Outcome seen =
      run("heater living { power: 2000.0 }\n"
          "parallel { living.warm(time: 1s); living.warm(time: 2s) }\n");
  has(seen.told, "E0501: two branches command `living` at the same time");

  const Outcome met =
      run("heater living { power: 2000.0 }\n"
          "fn go() { living.warm(time: 3s) }\n"
          "parallel { { wait(1s); go() } go() }\n");
  has(met.told, "R0617: `living` is heating already");
  has(met.told, ", heater living,");

  const Outcome caught = run(
      "heater living { power: 2000.0 }\n"
      "fn go() { living.warm(time: 3s) }\n"
      "fn late() { wait(1s); try { go() } catch (e) { print(e.kind, e.heater, e.time == 1s) } }\n"
      "parallel { go(); late() }\n"
      "living.warm(time: 1s)\n");
  CHECK(caught.told == "");
  CHECK(caught.printed == "Busy living true\n");
}

TEST_CASE("which heater is meant, and that one is missing, is said with its noun") {
  has(run("warm(time: 1s)").told, "E0220: no heater is known here");
  const std::string two =
      run("heater a { power: 1.0 }\nheater b { power: 1.0 }\nwarm(time: 1s)").told;
  has(two, "E0205: there are two heaters; which one should heat?");
  has(two, "or put the heating inside with (heater: a) { ... }");
  const Outcome with =
      run("heater a { power: 1000.0 }\nheater b { power: 1.0 }\n"
          "with (heater: a) { warm(time: 10s) }\nprint(b)");
  CHECK(with.told == "");
  CHECK(with.temperature == doctest::Approx(19.0));
}

TEST_CASE("failures have the host's rows, and say what had begun") {
  const std::string cold = run("heater a { power: 1.0 }\nwarm(time: 1s)", -5.0).told;
  has(cold, "R0901: `a` cannot heat below 0 degrees");
  has(cold, ", heater a, nothing has been heated");
  CHECK(run("heater a { power: 1.0 }\n"
            "try { warm(time: 1s) } catch (e) { print(e.kind) }",
            -5.0)
            .printed == "Frost\n");
  has(run("heater a { power: 1.0 }\n"
          "parallel {\n  warm(time: 100s)\n  wait until temperature() > 90.0, timeout: 5s\n}")
          .told,
      "the heater of a is at line 3, still heating");
}

TEST_CASE("what takes time where none can pass is said with the verb of the host") {
  const std::string late = "fn late() -> bool { warm(time: 1s)\n return true }\n";
  const std::string heater = "heater a { power: 1.0 }\n";
  has(run(heater + late + "wait until late()").told, "E0505: a condition cannot wait or heat");
  has(run(heater + late + "record r every (1s) { x: late() }").told,
      "E0505: what `record` samples cannot wait or heat");
}

TEST_CASE("names of the house are checked against its description") {
  CHECK(run("print(area(\"kitchen\"))").printed == "20.0\n");
  const std::string wrong = run("print(area(\"attic\"))").told;
  has(wrong, "E0901: there is no room called \"attic\"");
  has(wrong, "the rooms of the house are kitchen bath");
}

TEST_CASE("rows of messages are refused where a code is known or no code") {
  Engine engine;
  engine.add_messages(kMessages);
  CHECK_THROWS_AS(engine.add_messages(kMessages), ArgumentError);
  static constexpr CatalogEntry kTaken[] = {{"E0501", "", "mine", ""}};
  CHECK_THROWS_AS(engine.add_messages(kTaken), ArgumentError);
  static constexpr CatalogEntry kNone[] = {{"hot", "", "mine", ""}};
  CHECK_THROWS_AS(engine.add_messages(kNone), ArgumentError);
  CHECK(engine.messages().find("R0901")->kind == "Frost");
  CHECK(engine.messages().of_kind("Frost")->code == "R0901");
}

}  // namespace
}  // namespace armlet
