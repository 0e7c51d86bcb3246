// ode: differential equations (language reference, section 19; ruling 33).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "armlet/interpreter/sorting.hpp"
#include "armlet/math/ode.hpp"
#include "bind.hpp"
#include "blocks.hpp"
#include "ode_steps.hpp"

namespace armlet::bind {
namespace {

enum Parameter { kRate, kStart, kFrom, kTo, kStepSize, kMethod, kTolerance, kKnots };

constexpr double kMostSteps = 10'000'000;

// Whether the stretch and the step make sense; otherwise a failure is set.
bool check_times(Vm& vm, const Slot* args) {
  const double t0 = args[kFrom].d;
  const double t1 = args[kTo].d;
  const double step = args[kStepSize].d;
  for (const int p : {kFrom, kTo, kStepSize}) {
    if (std::isfinite(args[p].d)) continue;
    static_cast<void>(not_finite(vm, "a time given to ode", args[p].d, p));
    return false;
  }
  if (step <= 0.0) {
    static_cast<void>(
        domain_failure(vm, "ode with a step", step, "be longer than 0 s", {}, kStepSize));
    return false;
  }
  if (t1 <= t0) {
    static_cast<void>(failure(vm, "R0609",
                              fmt::format("ode from {:.15g} s to {:.15g} s: the end must be later "
                                          "than the start",
                                          t0, t1),
                              kTo));
    return false;
  }
  return true;
}

// The program's f, its result copied out of the list that it gives.
class Rate {
 public:
  Rate(Vm& vm, Obj* f) : vm_(vm), f_(f) {}
  ~Rate() { release(vm_, state_); }
  Rate(const Rate&) = delete;
  Rate& operator=(const Rate&) = delete;

  bool operator()(double t, std::span<const double> y, std::span<double> rate) {
    if (state_ == nullptr || state_->refs != 1) {  // the program may have kept the last one
      release(vm_, state_);
      state_ = new_list(vm_, static_cast<std::uint32_t>(y.size()), false);
      if (state_ == nullptr) return false;
    }
    const auto copy = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) state_->data[i].d = y[i];
    };
    // With the sums that the method makes of them.
    if (!in_blocks(vm_, y.size(), 4 * kCost, copy)) return false;
    const Slot arguments[] = {slot_of(t), slot_of(state_)};
    Slot result;
    if (!vm_.call(f_, arguments, result)) return false;
    const auto values = reals_value(result);
    const bool fits = values.size() == rate.size();
    if (fits) std::ranges::copy(values, rate.begin());
    if (!fits) {
      static_cast<void>(
          failure(vm_, "R0613",
                  fmt::format("the function given to ode returns {} values for a state of {}",
                              values.size(), rate.size()),
                  kRate, "it gives the rate of change of every element of the state"));
    }
    release(vm_, result.o);
    return fits;
  }

 private:
  Vm& vm_;
  Obj* f_;
  ListObj* state_ = nullptr;
};

Signal cannot_integrate(Vm& vm, const OdeOutcome& outcome, double tolerance) {
  switch (outcome.status) {
    case OdeStatus::kNotFinite:
      return failure(vm, "R0612",
                     fmt::format("element {} of the state is not finite at t = {:.6g} s",
                                 outcome.element, outcome.t),
                     kRate, {}, "use a shorter step, or method: \"rkf45\"");
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
      return Signal::kFail;
  }
}

// The instants from step to step; nothing: the failure is set.
std::optional<std::vector<double>> times_of(Vm& vm, const Slot* args) {
  constexpr double kSameTime = 1e-12;  // relative
  const double t0 = args[kFrom].d, t1 = args[kTo].d;
  const double apart = kSameTime * std::max(std::abs(t0), std::abs(t1));
  constexpr std::size_t kMostKnots = 1'000'000;
  std::vector<double> given;
  if (args[kKnots].o != nullptr) {
    const auto values = reals_value(args[kKnots]);
    if (values.size() > kMostKnots) {
      static_cast<void>(failure(
          vm, "R0613",
          fmt::format("ode with {} knots; {} are the limit", values.size(), kMostKnots), kKnots));
      return std::nullopt;
    }
    given.assign(values.begin(), values.end());
  }
  std::size_t bad = given.size();
  if (!find_number(vm, given, bad, [](double x) { return !std::isfinite(x); })) return std::nullopt;
  if (bad != given.size()) {
    static_cast<void>(not_finite(vm, "a knot given to ode", given[bad], kKnots));
    return std::nullopt;
  }
  std::vector<double> room(given.size());
  std::less<double> order;
  if (!sort_stably(vm, std::span<double>(given), std::span<double>(room), order))
    return std::nullopt;
  std::vector<double> knots = {t0};
  for (const double knot : given) {
    if (knot > knots.back() + apart && knot < t1 - apart) knots.push_back(knot);
  }
  knots.push_back(t1);
  const double steps = count_steps(knots, args[kStepSize].d);
  if (steps <= kMostSteps) {
    if (!charge_work(vm, static_cast<std::uint64_t>(8.0 * steps))) return std::nullopt;
    return step_times(knots, args[kStepSize].d);
  }
  static_cast<void>(
      failure(vm, "R0613",
              fmt::format("ode would take {:.15g} steps; {:.15g} are the limit", steps, kMostSteps),
              kStepSize, {}, "use a longer step"));
  return std::nullopt;
}

// The state at every instant, a row each.
Signal integrate(Vm& vm, Slot* args, OdeIntegrator& integrator, std::span<const double> instants) {
  const auto start = reals_value(args[kStart]);
  const double tolerance = args[kTolerance].d;
  const auto rows = static_cast<std::uint32_t>(instants.size());
  const auto columns = static_cast<std::uint32_t>(start.size());
  RecordObj* solution = new_record(vm, vm.program().library_record("OdeSolution"));
  if (solution == nullptr) return Signal::kFail;
  ListObj* times = new_list(vm, rows, false);
  solution->fields()[0].o = times;
  MatrixObj* states = times != nullptr ? new_matrix(vm, rows, columns) : nullptr;
  solution->fields()[1].o = states;
  if (states == nullptr) {
    release(vm, solution);
    return Signal::kFail;
  }
  Rate rate(vm, args[kRate].o);
  const OdeRate call = [&rate](double t, std::span<const double> y, std::span<double> out) {
    return rate(t, y, out);
  };
  std::vector<double> y(start.begin(), start.end());
  for (std::uint32_t row = 0;; ++row) {
    const double t = instants[row];
    times->data[row].d = t;
    if (!charge_work(vm, 2 * y.size())) {
      release(vm, solution);
      return Signal::kFail;
    }
    std::ranges::copy(y, states->data() + std::size_t{row} * columns);
    if (row + 1 == rows) return give(args, solution);
    const OdeOutcome outcome = integrator.advance(call, t, instants[row + 1] - t, y);
    if (outcome.status == OdeStatus::kDone) continue;
    release(vm, solution);
    return cannot_integrate(vm, outcome, tolerance);
  }
}

Signal ode(Vm& vm, Slot* args) {
  const auto method = ode_method(text_value(args[kMethod]));
  if (!method) {
    std::string names;
    for (const std::string_view name : ode_method_names())
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
    return failure(
        vm, "R0609",
        fmt::format("there is no method \"{}\" to integrate with", text_value(args[kMethod])),
        kMethod, "the methods are " + names);
  }
  const auto start = reals_value(args[kStart]);
  if (start.empty()) return failure(vm, "R0613", "ode needs a state of at least one value", kStart);
  std::size_t bad = start.size();
  if (!find_number(vm, start, bad, [](double x) { return !std::isfinite(x); }))
    return Signal::kFail;
  if (bad != start.size())
    return not_finite(vm, fmt::format("element {} of the start", bad), start[bad], kStart);
  const double tolerance = args[kTolerance].d;
  if (!(tolerance > 0.0 && std::isfinite(tolerance)))
    return domain_failure(vm, "ode with a tolerance", tolerance, "be greater than 0", {},
                          kTolerance);
  if (!check_times(vm, args)) return Signal::kFail;
  const auto instants = times_of(vm, args);
  if (!instants) return Signal::kFail;
  constexpr std::uint64_t kStages = 10;  // of the state, and copies of it
  const Scratch scratch(vm, kStages * start.size() * sizeof(double));
  if (!scratch.granted()) return Signal::kFail;
  OdeIntegrator integrator(static_cast<int>(start.size()), *method, tolerance);
  return integrate(vm, args, integrator, *instants);
}

constexpr NativeFunction kOdeFunctions[] = {
    {"ode",
     "(f: fn(double, double[]) -> double[], y0: double[], t0: time, t1: time, step: time, method: "
     "string = \"rk4\", tol: double = 1e-8, knots: time[]?) -> OdeSolution",
     "Integrates y' = f(t, y) from y0: t holds the start and the end of every step, y one row for "
     "each. Methods: \"euler\", \"euler-richardson\", \"rk4\", and \"rkf45\", which divides the "
     "steps until the error stays below tol. All steps are equal and none is longer than step; "
     "with "
     "knots, times where f is not smooth, they are so from knot to knot, and none goes across one.",
     "ode(fn(t, y) => [-y[0]], [1.0], 0s, 1s, step: 100ms).t.last", ode},
};

}  // namespace

std::span<const NativeFunction> ode_functions() { return kOdeFunctions; }

}  // namespace armlet::bind
