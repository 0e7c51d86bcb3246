// ode: differential equations (language reference, 19.2; ruling 33).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/math/ode.hpp"
#include "bind.hpp"

namespace armlet::bind {
namespace {

enum Parameter { kRate, kStart, kFrom, kTo, kStep, kMethod, kTolerance, kKnots };

constexpr double kMostSteps = 10'000'000;

// How many steps lead from t0 to t1; the last may be shorter. 0 with a failure if that makes no
// sense.
std::int64_t steps_between(Vm& vm, const Slot* args) {
  const double t0 = args[kFrom].d;
  const double t1 = args[kTo].d;
  const double step = args[kStep].d;
  for (const int p : {kFrom, kTo, kStep}) {
    if (std::isfinite(args[p].d)) continue;
    static_cast<void>(not_finite(vm, "a time given to ode", args[p].d, p));
    return 0;
  }
  if (step <= 0.0) {
    static_cast<void>(domain_failure(vm, "ode with a step", step, "be longer than 0 s", {}, kStep));
    return 0;
  }
  if (t1 <= t0) {
    static_cast<void>(failure(vm, "R0609",
                              fmt::format("ode from {:.15g} s to {:.15g} s: the end must be later "
                                          "than the start",
                                          t0, t1),
                              kTo));
    return 0;
  }
  // A rest of rounding makes no step of its own.
  const double steps = std::ceil((t1 - t0) / step - 1e-9);
  if (steps > kMostSteps) {
    static_cast<void>(failure(
        vm, "R0613",
        fmt::format("ode would take {:.15g} steps; {:.15g} are the limit", steps, kMostSteps),
        kStep, {}, "use a longer step"));
    return 0;
  }
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(steps));
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
    for (std::size_t i = 0; i < y.size(); ++i) state_->data[i].d = y[i];
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

// From t to next, in pieces that end where the rate jumps.
OdeOutcome advance_split(OdeIntegrator& integrator, const OdeRate& rate, double t, double next,
                         std::span<const double> knots, std::span<double> y) {
  constexpr double kSameTime = 1e-12;  // relative
  const double apart = kSameTime * std::max(std::abs(t), std::abs(next));
  for (auto knot = std::ranges::upper_bound(knots, t + apart);
       knot != knots.end() && *knot < next - apart; ++knot) {
    const OdeOutcome outcome = integrator.advance(rate, t, *knot - t, y);
    if (outcome.status != OdeStatus::kDone) return outcome;
    t = *knot;
  }
  return integrator.advance(rate, t, next - t, y);
}

// The knots of a call in ascending order; nothing: the failure is set.
std::optional<std::vector<double>> sorted_knots(Vm& vm, Slot list) {
  std::vector<double> knots;
  if (list.o == nullptr) return knots;
  const auto given = reals_value(list);
  knots.assign(given.begin(), given.end());
  for (const double knot : knots) {
    if (std::isfinite(knot)) continue;
    static_cast<void>(not_finite(vm, "a knot given to ode", knot, kKnots));
    return std::nullopt;
  }
  std::ranges::sort(knots);
  return knots;
}

// The start and every step: n + 1 rows.
Signal integrate(Vm& vm, Slot* args, OdeIntegrator& integrator, std::int64_t steps,
                 std::span<const double> knots) {
  const auto start = reals_value(args[kStart]);
  const double t0 = args[kFrom].d;
  const double t1 = args[kTo].d;
  const double step = args[kStep].d;
  const double tolerance = args[kTolerance].d;
  const auto rows = static_cast<std::uint32_t>(steps + 1);
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
    const double t = t0 + static_cast<double>(row) * step;
    times->data[row].d = row == steps ? t1 : t;
    std::ranges::copy(y, states->data() + std::size_t{row} * columns);
    if (row == steps) return give(args, solution);
    const double next = row + 1 == steps ? t1 : t0 + static_cast<double>(row + 1) * step;
    const OdeOutcome outcome = advance_split(integrator, call, t, next, knots, y);
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
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (!std::isfinite(start[i]))
      return not_finite(vm, fmt::format("element {} of the start", i), start[i], kStart);
  }
  const double tolerance = args[kTolerance].d;
  if (!(tolerance > 0.0 && std::isfinite(tolerance)))
    return domain_failure(vm, "ode with a tolerance", tolerance, "be greater than 0", {},
                          kTolerance);
  const std::int64_t steps = steps_between(vm, args);
  if (steps == 0) return Signal::kFail;
  OdeIntegrator integrator(static_cast<int>(start.size()), *method, tolerance);
  const auto knots = sorted_knots(vm, args[kKnots]);
  return knots ? integrate(vm, args, integrator, steps, *knots) : Signal::kFail;
}

constexpr NativeFunction kFunctions[] = {
    {"ode",
     "(f: fn(double, double[]) -> double[], y0: double[], t0: time, t1: time, step: time, method: "
     "string = \"rk4\", tol: double = 1e-8, knots: time[]?) -> OdeSolution",
     "Integrates y' = f(t, y) from y0: t holds the start and the end of every step, y one row for "
     "each. Methods: \"euler\", \"euler-richardson\", \"rk4\", and \"rkf45\", which divides the "
     "steps until the error stays below tol. No step goes across one of the knots: times where f "
     "is "
     "not smooth.",
     "ode(fn(t, y) => [-y[0]], [1.0], 0s, 1s, step: 100ms).t.last", ode},
};

}  // namespace

std::span<const NativeFunction> ode_functions() { return kFunctions; }

}  // namespace armlet::bind
