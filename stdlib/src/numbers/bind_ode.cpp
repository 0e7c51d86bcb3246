// ode: differential equations (language reference, section 19.1).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "armlet/interpreter/host/function_value.hpp"
#include "armlet/interpreter/sorting.hpp"
#include "armlet/math/ode.hpp"
#include "rules/rules.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/ode_program.hpp"
#include "values/ode_steps.hpp"
#include "values/setting_words.hpp"

namespace armlet::bind {
namespace {

// The parameters that are not called the same in both forms of a call.
struct Names {
  CallPart to, tolerance;
};
constexpr Names kFromTo{at("t1"), at("tol")};            // ode(f, y0, t0, t1, step, ...)
constexpr Names kDuring{at("during"), at("tolerance")};  // ode(f, y0, during, step, ...)

constexpr double kMostSteps = 10'000'000;
constexpr double kUsualSteps = 100.0;  // if the call gives no step

// The interval of integration and its steps.
struct Stretch {
  double t0 = 0.0;
  double t1 = 0.0;
  double step = 0.0;
  std::span<const double> knots{};
  Names names = kFromTo;
};

// Checks the interval and the step.
Answer<void> check_times(Vm& vm, const Stretch& stretch) {
  const Names& names = stretch.names;
  const std::pair<double, CallPart> times[] = {
      {stretch.t0, at("t0")}, {stretch.t1, names.to}, {stretch.step, at("step")}};
  for (const auto& [t, part] : times) {
    if (!std::isfinite(t)) return not_finite(vm, "a time given to ode", t, part);
  }
  const bool lasts = names.to == kDuring.to;
  if (lasts && stretch.t1 <= 0.0) {
    return failure(
        vm, "R0609",
        fmt::format("ode during {:.15g} s: the time must be longer than 0 s", stretch.t1), names.to,
        {}, "from one time to another it needs a step: ode(f, y0, 0s, 1s, step: 10ms)");
  }
  if (stretch.step <= 0.0) {
    return domain_failure(vm, "ode with a step", stretch.step, "be longer than 0 s", {},
                          at("step"));
  }
  if (stretch.t1 > stretch.t0) return {};
  return failure(
      vm, "R0609",
      fmt::format("ode from {:.15g} s to {:.15g} s: the end must be later than the start",
                  stretch.t0, stretch.t1),
      names.to);
}

Failed cannot_integrate(Vm& vm, const OdeOutcome& outcome, double tolerance, std::size_t half) {
  switch (outcome.status) {
    case OdeStatus::kNotFinite:
      return failure(vm, "R0612",
                     fmt::format("element {} of the state is not finite at t = {:.6g} s",
                                 outcome.element, outcome.t),
                     at("f"), {}, "use a shorter step, or method: \"rkf45\"");
    case OdeStatus::kNotRates:
      return failure(vm, "R0609",
                     fmt::format("this method takes a state [q; v], and the rate of element {} is "
                                 "not element {} of the state",
                                 outcome.element, outcome.element + half),
                     at("f"), "\"symplectic\" and \"verlet\" integrate positions and their speeds",
                     "give f(t, y) as the speeds, then the accelerations, or use \"rk4\"");
    case OdeStatus::kStepTooSmall:
      return failure(vm, "R0609",
                     fmt::format("ode cannot go on at t = {:.6g} s: no step is short enough for a "
                                 "tolerance of {:.6g}",
                                 outcome.t, tolerance),
                     at("f"), "the equation is stiff there, or jumps, or runs to infinity");
    case OdeStatus::kTooManySteps:
      return failure(
          vm, "R0609",
          fmt::format("ode gave up at t = {:.6g} s after a million steps within one", outcome.t),
          at("f"), "the equation is stiff there",
          "use a larger tolerance, or look for a rate that is far too large");
    default:
      return {};
  }
}

// The knots in ascending order.
Answer<std::vector<double>> sorted_knots(Vm& vm, std::span<const double> knots, CallPart part) {
  constexpr std::size_t kMostKnots = 1'000'000;
  if (knots.size() > kMostKnots) {
    return failure(vm, "R0613",
                   fmt::format("ode with {} knots; {} are the limit", knots.size(), kMostKnots),
                   part);
  }
  std::vector<double> sorted(knots.begin(), knots.end());
  std::size_t bad = sorted.size();
  if (!find_number(vm, sorted, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad != sorted.size()) return not_finite(vm, "a knot given to ode", sorted[bad], part);
  std::vector<double> room(sorted.size());
  std::less<double> order;
  if (!sort_stably(vm, std::span<double>(sorted), std::span<double>(room), order)) return Failed{};
  return sorted;
}

// The times of the rows, and those of them at which a step has to end.
struct Instants {
  std::vector<double> times, knots;
};
Answer<Instants> instants_of(Vm& vm, const Stretch& stretch) {
  constexpr double kSameTime = 1e-12;  // relative
  const double apart = kSameTime * std::max(std::abs(stretch.t0), std::abs(stretch.t1));
  const auto given = sorted_knots(vm, stretch.knots, at("knots"));
  if (!given) return Failed{};
  std::vector<double> knots = {stretch.t0};
  for (const double knot : *given) {
    if (knot > knots.back() + apart && knot < stretch.t1 - apart) knots.push_back(knot);
  }
  knots.push_back(stretch.t1);
  const double steps = count_steps(knots, stretch.step);
  if (steps > kMostSteps) {
    return failure(
        vm, "R0613",
        fmt::format("ode would take {:.15g} steps; {:.15g} are the limit", steps, kMostSteps),
        at("step"), {}, "use a longer step");
  }
  if (!charge_work(vm, static_cast<std::uint64_t>(8.0 * steps))) return Failed{};
  std::vector<double> times = step_times(knots, stretch.step);
  return Instants{std::move(times), std::move(knots)};
}

// An integration from row to row.
class Integration {
 public:
  Integration(Vm& vm, OdeRate rate, const Instants& instants, OdeIntegrator& integrator)
      : vm_(vm), rate_(std::move(rate)), instants_(instants), integrator_(integrator) {}

  // Also detects the events of the program.
  void wait_for(const WitnessesOfProgram& witnesses, OdeEvents& events) {
    witnesses_ = &witnesses;
    events_ = &events;
  }

  // The state at every time, one row each, until an event stops the integration.
  Answer<RecordObj*> run(std::span<const double> start, double tolerance) {
    const auto rows = static_cast<std::uint32_t>(instants_.times.size());
    RecordObj* solution = new_solution(vm_, rows, static_cast<std::uint32_t>(start.size()));
    if (solution == nullptr) return Failed{};
    const Answer<std::uint32_t> filled = fill(*solution, start, tolerance);
    RecordObj* result = nullptr;
    if (filled) result = *filled == rows ? solution : shortened(vm_, *solution, *filled);
    if (result != solution) release(vm_, solution);
    if (result == nullptr) return Failed{};
    if (crossings_.empty() || set_crossings(vm_, *result, crossings_)) return result;
    release(vm_, result);
    return Failed{};
  }

 private:
  // Returns the number of rows.
  Answer<std::uint32_t> fill(RecordObj& solution, std::span<const double> start, double tolerance) {
    const auto rows = static_cast<std::uint32_t>(instants_.times.size());
    std::vector<double> y(start.begin(), start.end()), before;
    const auto put = [&](std::uint32_t row, double t) {
      times_of(solution).data[row].d = t;
      std::ranges::copy(y, states_of(solution).data() + std::size_t{row} * y.size());
    };
    if (events_ != nullptr && !looked(events_->begin(instants_.times[0], y))) return Failed{};
    auto knot = instants_.knots.begin();
    for (std::uint32_t row = 0;; ++row) {
      const double t = instants_.times[row];
      if (!charge_work(vm_, 2 * y.size())) return Failed{};
      put(row, t);
      if (row + 1 == rows) return rows;
      while (*knot <= t) ++knot;
      const double h = instants_.times[row + 1] - t;
      before = y;
      const OdeOutcome outcome = integrator_.advance(rate_, t, h, y, std::max(*knot, t + h));
      if (outcome.status != OdeStatus::kDone)
        return cannot_integrate(vm_, outcome, tolerance, y.size() / 2);
      if (events_ == nullptr) continue;
      if (!looked(events_->look(rate_, t, h, before, y))) return Failed{};
      if (!take_crossings()) continue;
      y = crossings_.back().y;
      put(row + 1, crossings_.back().t);
      return row + 2;
    }
  }

  Answer<void> looked(const OdeEvents::Outcome& outcome) {
    if (outcome.status == OdeEvents::Status::kDone) return {};
    return witnesses_->cannot_look(outcome);
  }

  // Whether an event stops the integration; events after it do not happen.
  bool take_crossings() {
    for (const OdeCrossing& crossing : events_->found()) {
      crossings_.push_back(crossing);
      if (witnesses_->stops(crossing.witness)) return true;
    }
    return false;
  }

  Vm& vm_;
  OdeRate rate_;
  const Instants& instants_;
  OdeIntegrator& integrator_;
  const WitnessesOfProgram* witnesses_ = nullptr;
  OdeEvents* events_ = nullptr;
  std::vector<OdeCrossing> crossings_;
};

Answer<OdeMethod> method_called(Vm& vm, std::string_view name, CallPart part) {
  if (const auto method = ode_method(name)) return *method;
  std::string names;
  for (const std::string_view known : ode_method_names())
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", known);
  return failure(vm, "R0609", fmt::format("there is no method \"{}\" to integrate with", name),
                 part, "the methods are " + names);
}

Answer<void> check_start(Vm& vm, std::span<const double> start) {
  if (start.empty())
    return failure(vm, "R0613", "ode needs a state of at least one value", at("y0"));
  std::size_t bad = start.size();
  if (!find_number(vm, start, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad == start.size()) return {};
  return not_finite(vm, fmt::format("element {} of the start", bad), start[bad], at("y0"));
}

// The settings of a call.
struct OdeSettings {
  Stretch stretch{};
  std::string_view method{};
  double tolerance = 0.0;
  std::span<const Slot> when{};
  const Type* record = nullptr;  // the struct of the states; null: lists
};

Answer<RecordObj*> solve(Vm& vm, const OdeRate& rate, std::span<const double> start,
                         const OdeSettings& settings) {
  const auto method = method_called(vm, settings.method, at("method"));
  if (!method || !check_start(vm, start)) return Failed{};
  const bool splits = *method == OdeMethod::kSymplectic || *method == OdeMethod::kVerlet;
  if (splits && start.size() % 2 != 0) {
    return failure(vm, "R0613", fmt::format("a state [q; v] cannot have {} elements", start.size()),
                   at("y0"),
                   fmt::format("\"{}\" integrates positions and as many speeds", settings.method));
  }
  const double tolerance = settings.tolerance;
  if (!(tolerance > 0.0 && std::isfinite(tolerance)))
    return domain_failure(vm, "ode with a tolerance", tolerance, "be greater than 0", {},
                          settings.stretch.names.tolerance);
  if (!check_times(vm, settings.stretch)) return Failed{};
  const auto instants = instants_of(vm, settings.stretch);
  if (!instants) return Failed{};
  constexpr std::uint64_t kStages = 18;  // stages of a method, each the size of the state
  const Scratch scratch(vm, kStages * start.size() * sizeof(double));
  if (!scratch.granted()) return Failed{};
  const int size = static_cast<int>(start.size());
  OdeIntegrator integrator(size, *method, tolerance);
  Integration integration(vm, rate, *instants, integrator);
  WitnessesOfProgram program(vm, settings.when, at("when"), settings.record);
  if (program.empty()) return integration.run(start, tolerance);
  auto witnesses = program.witnesses();
  if (!witnesses) return Failed{};
  OdeEvents events(*std::move(witnesses), size, *method, tolerance);
  integration.wait_for(program, events);
  return integration.run(start, tolerance);
}

Answer<RecordObj*> solve_lists(Vm& vm, FunctionValue f, std::span<const double> start,
                               const OdeSettings& settings) {
  RateOfProgram rate(vm, f.object, at("f"));
  const OdeRate call = [&rate](double t, std::span<const double> y, std::span<double> out) {
    return static_cast<bool>(rate(t, y, out));
  };
  return solve(vm, call, start, settings);
}

Answer<RecordObj*> ode(Vm& vm, FunctionValue f, std::span<const double> start, double t0, double t1,
                       double step, std::string_view method, double tolerance,
                       std::optional<std::span<const double>> knots,
                       std::optional<std::span<const Slot>> when) {
  return solve_lists(vm, f, start,
                     {.stretch = {t0, t1, step, knots.value_or(std::span<const double>())},
                      .method = method,
                      .tolerance = tolerance,
                      .when = when.value_or(std::span<const Slot>())});
}

// The state is a struct of quantities; the function returns a struct of the rates of its fields.
Answer<RecordObj*> solve_structs(Vm& vm, FunctionValue f, Slot from, OdeSettings settings) {
  const RecordObj& start = *static_cast<const RecordObj*>(from.o);  // the type S is a struct
  const std::span<const double> values(reinterpret_cast<const double*>(start.fields()),
                                       start.layout->size);
  RateOfStructs rate(vm, f.object, *start.layout->type);
  const OdeRate call = [&rate](double t, std::span<const double> y, std::span<double> out) {
    return static_cast<bool>(rate(t, y, out));
  };
  settings.record = start.layout->type;
  const auto solution = solve(vm, call, values, settings);
  if (!solution) return Failed{};
  RecordObj* const out = with_structs(vm, **solution, *settings.record);
  release(vm, *solution);
  if (out == nullptr) return Failed{};
  return out;
}

Answer<RecordObj*> ode_with_units(Vm& vm, FunctionValue f, Slot from, double t0, double t1,
                                  double step, std::string_view method, double tolerance,
                                  std::optional<std::span<const double>> knots,
                                  std::optional<std::span<const Slot>> when) {
  return solve_structs(vm, f, from,
                       {.stretch = {t0, t1, step, knots.value_or(std::span<const double>())},
                        .method = method,
                        .tolerance = tolerance,
                        .when = when.value_or(std::span<const Slot>())});
}

// A call with a duration may leave the steps to a method with step control.
OdeSettings during_settings(double during, std::optional<double> step,
                            std::optional<std::string_view> method, double tolerance,
                            std::optional<std::span<const double>> knots) {
  return {.stretch = {0.0, during, step.value_or(during / kUsualSteps),
                      knots.value_or(std::span<const double>()), kDuring},
          .method = method.value_or(step ? "rk4" : "dopri5"),
          .tolerance = tolerance};
}

// Fails if a method without step control gets no step.
Answer<void> check_step(Vm& vm, const OdeSettings& settings, bool has_step) {
  const auto method = method_called(vm, settings.method, at("method"));
  if (!method) return Failed{};
  if (has_step || *method == OdeMethod::kFehlberg45 || *method == OdeMethod::kDormandPrince45)
    return {};
  return failure(vm, "R0609",
                 fmt::format("ode with the method \"{}\" needs a step", settings.method),
                 at("method"), "its steps are as long as it is told, whatever the error",
                 "say step: ..., or use \"dopri5\" or \"rkf45\", which keep to a tolerance");
}

Answer<RecordObj*> ode_during(Vm& vm, FunctionValue f, std::span<const double> start, double during,
                              std::optional<double> step, std::optional<std::string_view> method,
                              double tolerance, std::optional<std::span<const double>> knots,
                              std::optional<std::span<const Slot>> when) {
  OdeSettings settings = during_settings(during, step, method, tolerance, knots);
  settings.when = when.value_or(std::span<const Slot>());
  if (!check_step(vm, settings, step.has_value())) return Failed{};
  return solve_lists(vm, f, start, settings);
}

Answer<RecordObj*> ode_with_units_during(Vm& vm, FunctionValue f, Slot from, double during,
                                         std::optional<double> step,
                                         std::optional<std::string_view> method, double tolerance,
                                         std::optional<std::span<const double>> knots,
                                         std::optional<std::span<const Slot>> when) {
  OdeSettings settings = during_settings(during, step, method, tolerance, knots);
  settings.when = when.value_or(std::span<const Slot>());
  if (!check_step(vm, settings, step.has_value())) return Failed{};
  return solve_structs(vm, f, from, settings);
}

// The times of the states that ode returns.
Answer<ListObj*> ode_times(Vm& vm, double during, std::optional<double> step,
                           std::optional<std::span<const double>> knots) {
  const Stretch stretch{0.0, during, step.value_or(during / kUsualSteps),
                        knots.value_or(std::span<const double>()), kDuring};
  if (!check_times(vm, stretch)) return Failed{};
  const auto instants = instants_of(vm, stretch);
  if (!instants) return Failed{};
  ListObj* const list = new_list(vm, static_cast<std::uint32_t>(instants->times.size()), false);
  if (list == nullptr) return Failed{};
  for (std::uint32_t k = 0; k < list->size; ++k) list->data[k].d = instants->times[k];
  return list;
}

Answer<RecordObj*> event(Vm& vm, Slot g, std::string_view direction, bool stop) {
  const Type* const state = parameter_type(vm, g.o, 1);
  const Type* const with_struct = vm.program().library_record("OdeEvent", state);
  RecordObj* const record = new_record(
      vm, with_struct != nullptr ? with_struct : vm.program().library_record("OdeEvent"));
  if (record == nullptr) return Failed{};
  retain(g.o);
  record->fields()[0] = g;
  Obj* const text = new_text(vm, direction);
  record->fields()[1].o = text;
  record->fields()[2] = slot_of(stop);
  if (text != nullptr) return record;
  release(vm, record);
  return Failed{};
}

constexpr NativeFunction kOdeFunctions[] = {
    def<ode>(
        "ode(f: fn(double, double[]) -> double[], y0: double[], t0: time, t1: time, step: time, "
        "method: string = \"rk4\", tol: double = 1e-8, knots: time[]?, when: "
        "OdeEvent[]?) -> OdeSolution",
        "Integrates y' = f(t, y) from y0: t holds the start and the end of every step, y one row "
        "for "
        "each. Methods: \"euler\", \"euler-richardson\", \"rk4\"; \"rkf45\", which divides the "
        "steps "
        "until the error stays below tol; \"dopri5\", which chooses its steps and gives rows in "
        "between by a polynomial; \"symplectic\" and \"verlet\" for a state of positions, then "
        "speeds. "
        "All steps are equal and none is longer than step; with knots, times where f is not "
        "smooth, "
        "they are so from knot to knot, and none goes across one. events are the instants at which "
        "a "
        "function of `when` went through zero; one that stops makes the last row.",
        "ode(fn(t, y) => [-y[0]], [1.0], 0s, 1s, step: 100ms).t.last",
        {.check = check_method<"method">}),
    def<ode_during>(
        "ode(f: fn(double, double[]) -> double[], y0: double[], during: time, step: time?, "
        "method: string?, tolerance: double = 1e-8, knots: time[]?, when: OdeEvent[]?) -> "
        "OdeSolution",
        "The same from 0 s on, for so long. Without a step the method is \"dopri5\", which keeps "
        "to the tolerance, and a hundred rows are given; with one it is \"rk4\". Methods that do "
        "not choose their steps need one.",
        "ode(fn(t, y) => [-y[0]], [1.0], during: 1s, tolerance: 1e-10).y.rows",
        {.check = check_method<"method">}),
    def<ode_with_units>(
        "ode(f: fn(time, S) -> U, y0: S, t0: time, t1: time, step: time, method: string = \"rk4\", "
        "tol: double = 1e-8, knots: time[]?, when: OdeEvent<S>{g: fn(time, S) -> double, "
        "direction: string, stop: bool}[]?) -> OdeSolution<S>{t: time[], y: S[], events: "
        "OdeCrossing<S>{t: time, event: int, y: S}[]}",
        "The same for a state with units, a struct of quantities: f(t, y) gives a struct whose "
        "fields have the same names and are the rates of those of y. y of the solution and of its "
        "events are such structs.",
        "ode(fn(t: double, y: double[]) => [-y[0]], [1.0], 0s, 1s, step: 100ms).t.last",
        {.check = check_all_of<check_rates, check_method<"method">>}),
    def<ode_with_units_during>(
        "ode(f: fn(time, S) -> U, y0: S, during: time, step: time?, method: string?, tolerance: "
        "double = 1e-8, knots: time[]?, when: OdeEvent<S>{g: fn(time, S) -> double, direction: "
        "string, stop: bool}[]?) -> OdeSolution<S>{t: time[], y: S[], events: OdeCrossing<S>{t: "
        "time, event: int, y: S}[]}",
        "A state with units from 0 s on, for so long; steps and methods are those of a state "
        "without.",
        "ode(fn(t, y) => [-y[0]], [1.0], during: 1s, tolerance: 1e-10).y.rows",
        {.check = check_all_of<check_rates, check_method<"method">>}),
    def<ode_times>(
        "odeTimes(during: time, step: time?, knots: time[]?) -> time[]",
        "The times of the states that ode gives with the same settings: the start and the end of "
        "every step.",
        "odeTimes(during: 1s, step: 250ms)"),
    def<event>(
        "event(g: fn(double, double[]) -> double, direction: string = \"both\", stop: bool = "
        "false) -> "
        "OdeEvent",
        "For when of ode: g(t, y) goes through zero, \"both\" ways or only \"rising\" or "
        "\"falling\". "
        "The instant is found to 1e-9 s by shorter steps of the same method. A function that goes "
        "through zero twice within one step is not seen.",
        "ode(fn(t, y) => [y[1], -9.81], [1.0, 0.0], 0s, 1s, step: 10ms, when: [event(fn(t, y) => "
        "y[0], "
        "stop: true)]).t.last",
        {.check = check_word<"direction", kDirections>}),
    def<event>(
        "event(g: fn(time, S) -> D, direction: string = \"both\", stop: bool = false) -> "
        "OdeEvent<S>{g: fn(time, S) -> double, direction: string, stop: bool}",
        "The same for a state with units: g takes the struct, and gives a quantity or a number.",
        "event(fn(t, y) => y[0], direction: \"falling\").stop",
        {.check = check_word<"direction", kDirections>}),
};

}  // namespace

std::span<const NativeFunction> ode_functions() { return kOdeFunctions; }

}  // namespace armlet::bind
