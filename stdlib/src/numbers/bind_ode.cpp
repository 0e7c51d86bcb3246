// ode: differential equations (language reference, section 19; ruling 33).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "armlet/interpreter/sorting.hpp"
#include "armlet/math/ode.hpp"
#include "numbers/ode_steps.hpp"
#include "session/bind.hpp"
#include "values/blocks.hpp"

namespace armlet::bind {
namespace {

// The parameters in their order, which failures mark.
enum Parameter { kRate, kStart, kFrom, kTo, kStepSize, kMethod, kTolerance, kKnots };

constexpr double kMostSteps = 10'000'000;

// The stretch of time and its steps.
struct Stretch {
  double t0 = 0.0;
  double t1 = 0.0;
  double step = 0.0;
  std::span<const double> knots{};
};

// Whether the stretch and the step make sense.
Answer<void> check_times(Vm& vm, const Stretch& stretch) {
  int parameter = kFrom;
  for (const double t : {stretch.t0, stretch.t1, stretch.step}) {
    if (!std::isfinite(t)) return not_finite(vm, "a time given to ode", t, parameter);
    ++parameter;
  }
  if (stretch.step <= 0.0) {
    return domain_failure(vm, "ode with a step", stretch.step, "be longer than 0 s", {}, kStepSize);
  }
  if (stretch.t1 > stretch.t0) return {};
  return failure(
      vm, "R0609",
      fmt::format("ode from {:.15g} s to {:.15g} s: the end must be later than the start",
                  stretch.t0, stretch.t1),
      kTo);
}

// The program's f, its result copied out of the list that it gives.
class Rate {
 public:
  Rate(Vm& vm, Obj* f) : vm_(vm), f_(f) {}
  ~Rate() { release(vm_, state_); }
  Rate(const Rate&) = delete;
  Rate& operator=(const Rate&) = delete;

  Answer<void> operator()(double t, std::span<const double> y, std::span<double> rate) {
    if (state_ == nullptr || state_->refs != 1) {  // the program may have kept the last one
      release(vm_, state_);
      state_ = new_list(vm_, static_cast<std::uint32_t>(y.size()), false);
      if (state_ == nullptr) return Failed{};
    }
    const auto copy = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) state_->data[i].d = y[i];
    };
    // With the sums that the method makes of them.
    if (!in_blocks(vm_, y.size(), 4 * kCost, copy)) return Failed{};
    const Slot arguments[] = {slot_of(t), slot_of(state_)};
    Slot result;
    if (!vm_.call(f_, arguments, result)) return Failed{};
    const auto values = reals_value(result);
    const std::size_t count = values.size();
    if (count == rate.size()) std::ranges::copy(values, rate.begin());
    release(vm_, result.o);
    if (count == rate.size()) return {};
    return failure(vm_, "R0613",
                   fmt::format("the function given to ode returns {} values for a state of {}",
                               count, rate.size()),
                   kRate, "it gives the rate of change of every element of the state");
  }

 private:
  Vm& vm_;
  Obj* f_;
  ListObj* state_ = nullptr;
};

Failed cannot_integrate(Vm& vm, const OdeOutcome& outcome, double tolerance, std::size_t half) {
  switch (outcome.status) {
    case OdeStatus::kNotFinite:
      return failure(vm, "R0612",
                     fmt::format("element {} of the state is not finite at t = {:.6g} s",
                                 outcome.element, outcome.t),
                     kRate, {}, "use a shorter step, or method: \"rkf45\"");
    case OdeStatus::kNotRates:
      return failure(vm, "R0609",
                     fmt::format("this method takes a state [q; v], and the rate of element {} is "
                                 "not element {} of the state",
                                 outcome.element, outcome.element + half),
                     kRate, "\"symplectic\" and \"verlet\" integrate positions and their speeds",
                     "give f(t, y) as the speeds, then the accelerations, or use \"rk4\"");
    case OdeStatus::kStepTooSmall:
      return failure(vm, "R0609",
                     fmt::format("ode cannot go on at t = {:.6g} s: no step is short enough for a "
                                 "tolerance of {:.6g}",
                                 outcome.t, tolerance),
                     kRate, "the equation is stiff there, or jumps, or runs to infinity");
    case OdeStatus::kTooManySteps:
      return failure(
          vm, "R0609",
          fmt::format("ode gave up at t = {:.6g} s after a million steps within one", outcome.t),
          kRate, "the equation is stiff there",
          "use a larger tol, or look for a rate that is far too large");
    default:
      return {};
  }
}

// Times in ascending order.
Answer<std::vector<double>> sorted_knots(Vm& vm, std::span<const double> knots) {
  constexpr std::size_t kMostKnots = 1'000'000;
  if (knots.size() > kMostKnots) {
    return failure(vm, "R0613",
                   fmt::format("ode with {} knots; {} are the limit", knots.size(), kMostKnots),
                   kKnots);
  }
  std::vector<double> sorted(knots.begin(), knots.end());
  std::size_t bad = sorted.size();
  if (!find_number(vm, sorted, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad != sorted.size()) return not_finite(vm, "a knot given to ode", sorted[bad], kKnots);
  std::vector<double> room(sorted.size());
  std::less<double> order;
  if (!sort_stably(vm, std::span<double>(sorted), std::span<double>(room), order)) return Failed{};
  return sorted;
}

// The instants from step to step, and those among them that no step goes across.
struct Instants {
  std::vector<double> times, knots;
};
Answer<Instants> times_of(Vm& vm, const Stretch& stretch) {
  constexpr double kSameTime = 1e-12;  // relative
  const double apart = kSameTime * std::max(std::abs(stretch.t0), std::abs(stretch.t1));
  const auto given = sorted_knots(vm, stretch.knots);
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
        kStepSize, {}, "use a longer step");
  }
  if (!charge_work(vm, static_cast<std::uint64_t>(8.0 * steps))) return Failed{};
  std::vector<double> times = step_times(knots, stretch.step);
  return Instants{std::move(times), std::move(knots)};
}

// A solution with room for the state at `rows` instants; null: it failed.
RecordObj* new_solution(Vm& vm, std::uint32_t rows, std::uint32_t columns) {
  RecordObj* solution = new_record(vm, vm.program().library_record("OdeSolution"));
  if (solution == nullptr) return nullptr;
  ListObj* times = new_list(vm, rows, false);
  solution->fields()[0].o = times;
  MatrixObj* states = times != nullptr ? new_matrix(vm, rows, columns) : nullptr;
  solution->fields()[1].o = states;
  if (states != nullptr) return solution;
  release(vm, solution);
  return nullptr;
}

// The state at every instant, a row each.
Answer<RecordObj*> integrate(Vm& vm, FunctionValue f, std::span<const double> start,
                             const Instants& instants, OdeIntegrator& integrator,
                             double tolerance) {
  const auto rows = static_cast<std::uint32_t>(instants.times.size());
  RecordObj* solution = new_solution(vm, rows, static_cast<std::uint32_t>(start.size()));
  if (solution == nullptr) return Failed{};
  auto* times = static_cast<ListObj*>(solution->fields()[0].o);
  auto* states = static_cast<MatrixObj*>(solution->fields()[1].o);
  Rate rate(vm, f.object);
  const OdeRate call = [&rate](double t, std::span<const double> y, std::span<double> out) {
    return static_cast<bool>(rate(t, y, out));
  };
  std::vector<double> y(start.begin(), start.end());
  auto knot = instants.knots.begin();
  for (std::uint32_t row = 0;; ++row) {
    const double t = instants.times[row];
    times->data[row].d = t;
    if (!charge_work(vm, 2 * y.size())) {
      release(vm, solution);
      return Failed{};
    }
    std::ranges::copy(y, states->data() + std::size_t{row} * y.size());
    if (row + 1 == rows) return solution;
    while (*knot <= t) ++knot;
    const double h = instants.times[row + 1] - t;
    const OdeOutcome outcome = integrator.advance(call, t, h, y, std::max(*knot, t + h));
    if (outcome.status == OdeStatus::kDone) continue;
    release(vm, solution);
    return cannot_integrate(vm, outcome, tolerance, y.size() / 2);
  }
}

Answer<OdeMethod> method_called(Vm& vm, std::string_view name) {
  if (const auto method = ode_method(name)) return *method;
  std::string names;
  for (const std::string_view known : ode_method_names())
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", known);
  return failure(vm, "R0609", fmt::format("there is no method \"{}\" to integrate with", name),
                 kMethod, "the methods are " + names);
}

Answer<void> check_start(Vm& vm, std::span<const double> start) {
  if (start.empty()) return failure(vm, "R0613", "ode needs a state of at least one value", kStart);
  std::size_t bad = start.size();
  if (!find_number(vm, start, bad, [](double x) { return !std::isfinite(x); })) return Failed{};
  if (bad == start.size()) return {};
  return not_finite(vm, fmt::format("element {} of the start", bad), start[bad], kStart);
}

Answer<RecordObj*> ode(Vm& vm, FunctionValue f, std::span<const double> start, double t0, double t1,
                       double step, std::string_view method_name, double tolerance,
                       std::optional<std::span<const double>> knots) {
  const auto method = method_called(vm, method_name);
  if (!method || !check_start(vm, start)) return Failed{};
  const bool splits = *method == OdeMethod::kSymplectic || *method == OdeMethod::kVerlet;
  if (splits && start.size() % 2 != 0) {
    return failure(vm, "R0613", fmt::format("a state [q; v] cannot have {} elements", start.size()),
                   kStart,
                   fmt::format("\"{}\" integrates positions and as many speeds", method_name));
  }
  if (!(tolerance > 0.0 && std::isfinite(tolerance)))
    return domain_failure(vm, "ode with a tolerance", tolerance, "be greater than 0", {},
                          kTolerance);
  const Stretch stretch{t0, t1, step, knots.value_or(std::span<const double>())};
  if (!check_times(vm, stretch)) return Failed{};
  const auto instants = times_of(vm, stretch);
  if (!instants) return Failed{};
  constexpr std::uint64_t kStages = 18;  // of the state, and copies of it
  const Scratch scratch(vm, kStages * start.size() * sizeof(double));
  if (!scratch.granted()) return Failed{};
  OdeIntegrator integrator(static_cast<int>(start.size()), *method, tolerance);
  return integrate(vm, f, start, *instants, integrator, tolerance);
}

constexpr NativeFunction kOdeFunctions[] = {
    def<ode>(
        "ode(f: fn(double, double[]) -> double[], y0: double[], t0: time, t1: time, step: time, "
        "method: string = \"rk4\", tol: double = 1e-8, knots: time[]?) -> OdeSolution",
        "Integrates y' = f(t, y) from y0: t holds the start and the end of every step, y one row "
        "for "
        "each. Methods: \"euler\", \"euler-richardson\", \"rk4\"; \"rkf45\", which divides the "
        "steps "
        "until the error stays below tol; \"dopri5\", which chooses its steps and gives rows in "
        "between by a polynomial; \"symplectic\" and \"verlet\" for a state of positions, then "
        "speeds. "
        "All steps are equal and none is longer than step; with knots, times where f is not "
        "smooth, "
        "they are so from knot to knot, and none goes across one.",
        "ode(fn(t, y) => [-y[0]], [1.0], 0s, 1s, step: 100ms).t.last"),
};

}  // namespace

std::span<const NativeFunction> ode_functions() { return kOdeFunctions; }

}  // namespace armlet::bind
