// The acceleration parameters of a trajectory and their integration (language reference, section
// 19).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/math/ode.hpp"
#include "armlet/trajectory/accelerations.hpp"
#include "moves/trajectories.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/ode_program.hpp"
#include "values/ode_steps.hpp"

namespace armlet::bind {
namespace {

Answer<MatrixObj*> parameters(Vm& vm, const PlannedMotion& tr, std::int64_t joint) {
  const Trajectory& motion = tr.motion;
  if (joint < 1 || joint > motion.n())
    return failure(vm, "R0606", fmt::format("joint {} is outside 1 to {}", joint, motion.n()),
                   at("joint"));
  const auto pieces = acceleration_pieces(motion, static_cast<int>(joint) - 1);
  int degree = 0;
  for (const Segment& piece : pieces) degree = std::max(degree, piece.degree);
  MatrixObj* matrix = new_matrix(vm, static_cast<std::uint32_t>(pieces.size()),
                                 static_cast<std::uint32_t>(degree + 1));
  if (matrix == nullptr) return Failed{};
  double* out = matrix->data();
  for (const Segment& piece : pieces) {
    for (int k = 0; k <= degree; ++k) *out++ = piece.c[static_cast<std::size_t>(k)];
  }
  return matrix;
}

constexpr double kMostSteps = 1'000'000;
constexpr double kTolerance = 1e-8;

// The ODE q' = v, v' = a(t) for all joints; the state holds the positions, then the speeds.
class Accelerations {
 public:
  explicit Accelerations(const Trajectory& motion) : knots_(motion.knots()) {
    for (int i = 0; i < motion.n(); ++i) joints_.push_back(acceleration_pieces(motion, i));
  }

  // Keeps the interval that begins at t or contains it; its parameters then hold up to its end.
  void stay_behind(double t) { stretch_ = static_cast<int>(stretch_at(t)); }

  bool operator()(double t, std::span<const double> y, std::span<double> rate) const {
    const std::size_t n = joints_.size();
    const std::size_t k = stretch_ >= 0 ? static_cast<std::size_t>(stretch_) : stretch_at(t);
    for (std::size_t i = 0; i < n; ++i) {
      const Segment& a = joints_[i][k];
      rate[i] = y[n + i];
      rate[n + i] = a.value(t - a.start);
    }
    return true;
  }

 private:
  [[nodiscard]] std::size_t stretch_at(double t) const {
    const auto behind = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
    return static_cast<std::size_t>(behind - knots_.begin()) - 1;
  }

  std::vector<double> knots_;
  std::vector<std::vector<Segment>> joints_;
  int stretch_ = -1;  // -1: the interval that contains the time
};

// The arguments of a call, checked.
struct Request {
  OdeMethod method;
  std::vector<double> times;  // the times of the steps
};
Answer<Request> request_of(Vm& vm, const Trajectory& motion, double step, std::string_view name,
                           bool split) {
  const auto method = ode_method(name);
  if (!method) {
    std::string names;
    for (const std::string_view known : ode_method_names())
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", known);
    return failure(vm, "R0609", fmt::format("there is no method \"{}\" to integrate with", name),
                   at("method"), "the methods are " + names);
  }
  if (!(std::isfinite(step) && step > 0.0))
    return domain_failure(vm, "an integration with a step", step, "be longer than 0 s", {},
                          at("step"));
  std::vector<double> knots = motion.knots();
  if (!split && knots.size() > 2) knots = {knots.front(), knots.back()};
  const double steps = count_steps(knots, step);
  if (steps <= kMostSteps) return Request{*method, step_times(knots, step)};
  return failure(
      vm, "R0613",
      fmt::format("this would take {:.15g} steps; {:.15g} are the limit", steps, kMostSteps),
      at("step"), {}, "use a longer step");
}

Answer<RecordObj*> integrate(Vm& vm, const PlannedMotion& tr, double step, std::string_view method,
                             bool split) {
  const Trajectory& motion = tr.motion;
  const auto request = request_of(vm, motion, step, method, split);
  if (!request) return Failed{};
  const auto n = static_cast<std::uint32_t>(motion.n());
  const auto rows = static_cast<std::uint32_t>(request->times.size());
  if (!charge_steps(vm, rows)) return Failed{};
  RecordObj* solution = new_solution(vm, rows, 2 * n);
  if (solution == nullptr) return Failed{};
  ListObj* const times = &times_of(*solution);
  MatrixObj* const states = &states_of(*solution);
  std::vector<double> y(2 * std::size_t{n});
  for (std::uint32_t i = 0; i < n; ++i) {
    y[i] = motion.value(static_cast<int>(i), 0.0);
    y[n + i] = motion.value(static_cast<int>(i), 0.0, 1);
  }
  Accelerations a(motion);
  const OdeRate rate = [&a](double t, std::span<const double> state, std::span<double> out) {
    return a(t, state, out);
  };
  OdeIntegrator integrator(static_cast<int>(y.size()), request->method, kTolerance);
  for (std::uint32_t row = 0;; ++row) {
    const double t = request->times[row];
    times->data[row].d = t;
    std::ranges::copy(y, states->data() + std::size_t{row} * y.size());
    if (row + 1 == rows) return solution;
    if (split) a.stay_behind(t);
    const OdeOutcome outcome = integrator.advance(rate, t, request->times[row + 1] - t, y);
    if (outcome.status == OdeStatus::kDone) continue;
    release(vm, solution);
    return failure(vm, "R0609",
                   fmt::format("the integration cannot go on at t = {:.6g} s", outcome.t),
                   at("method"), "no step is short enough where the accelerations jump",
                   "use split: true, or a method with fixed steps");
  }
}

constexpr NativeFunction kAccelerationFunctions[] = {
    def<parameters>(
        "trajectory.accelParameters(tr: trajectory, joint: int) -> matrix",
        "The acceleration of a joint, counted from 1, as polynomials: row i holds the coefficients "
        "a0, a1, a2 ... of the powers of t - knots[i] (SI), up to the next knot.",
        "trajectory(\"434\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]).accelParameters(1)"),
    def<integrate>(
        "trajectory.integrate(tr: trajectory, step: time, method: string = \"rk4\", split: bool = "
        "true) -> OdeSolution",
        "Integrates the accelerations of all joints from the start, with the methods of ode: t "
        "holds the start and the end of every step, y one row for each with all positions and then "
        "all speeds. From knot to knot all steps are equal, and none is longer than step; without "
        "split they are so over the whole motion, whatever its knots.",
        "trajectory(\"434\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]).integrate(step: "
        "10ms).t.last",
        {.check = check_method<"method">}),
};

}  // namespace

std::span<const NativeFunction> acceleration_functions() { return kAccelerationFunctions; }

}  // namespace armlet::bind
