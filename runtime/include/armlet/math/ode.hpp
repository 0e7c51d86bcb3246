#pragma once
// Initial value problems y' = f(t, y): four one-step methods with one interface.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace armlet {

// kEuler            order 1.
// kEulerRichardson  order 2: the slope at the middle, reached with half an Euler step.
// kRungeKutta4      order 4: the classic four slopes.
// kFehlberg45       order 5 with an estimate of order 4 beside it, which chooses the steps.
enum class OdeMethod : std::uint8_t { kEuler, kEulerRichardson, kRungeKutta4, kFehlberg45 };

// "euler", "euler-richardson", "rk4", "rkf45", in the order of OdeMethod.
[[nodiscard]] std::span<const std::string_view> ode_method_names();
// The method of one of these names; empty for any other name.
[[nodiscard]] std::optional<OdeMethod> ode_method(std::string_view name);

// Writes f(t, y) to `rate`, which has as many elements as y. Returns false to end the integration.
using OdeRate = std::function<bool(double t, std::span<const double> y, std::span<double> rate)>;

enum class OdeStatus : std::uint8_t {
  kDone,
  kStopped,       // the rate function returned false
  kNotFinite,     // an element of the state became infinite or undefined
  kStepTooSmall,  // no step, however short, meets the tolerance: stiff, or discontinuous
  kTooManySteps,  // a million steps did not reach the end: stiff
};

struct OdeOutcome {
  OdeStatus status = OdeStatus::kDone;
  double t = 0.0;   // how far it came
  int element = 0;  // kNotFinite: which element of the state
};

// Integrates one system. Memory is taken when it is made; steps take none.
class OdeIntegrator {
 public:
  // size       elements of the state, >= 0.
  // tolerance  of kFehlberg45: the root mean square over the elements of
  //            error / (tolerance (1 + |y|)) stays below 1 in every step.
  // throws     ArgumentError on a negative size or a tolerance that is not positive.
  OdeIntegrator(int size, OdeMethod method, double tolerance = 1e-8);

  // Moves the state y from t to t + h; h may be negative.
  //
  // The methods of fixed order do it in one step. kFehlberg45 takes as many as it needs, ends at
  // t + h exactly, and goes on with its own step in the next call. When the outcome is not kDone, y
  // is the state at outcome.t (kStepTooSmall, kTooManySteps) or of no use (kStopped, kNotFinite).
  //
  // throws  ArgumentError if y has not `size` elements, or t or h is not finite.
  // source  Euler-Richardson: H. Gould, J. Tobochnik, W. Christian, An Introduction to Computer
  //         Simulation Methods, 3rd ed. 2006, section 3.7. Classic: W. Kutta, Z. Math. Phys. 46,
  //         1901. Fehlberg: E. Fehlberg, NASA TR R-315, 1969, table III; the fifth-order result is
  //         kept. Step control: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential
  //         Equations I, 2nd ed. 1993, eq. II.4.13.
  OdeOutcome advance(const OdeRate& rate, double t, double h, std::span<double> y);

  // How often the rate function has been called.
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  [[nodiscard]] std::span<double> stage(int k) {
    return {work_.data() + static_cast<std::ptrdiff_t>(k) * size_, static_cast<std::size_t>(size_)};
  }
  [[nodiscard]] bool slope(const OdeRate& rate, double t, std::span<const double> y, int k);
  [[nodiscard]] bool euler(const OdeRate& rate, double t, double h, std::span<double> y);
  [[nodiscard]] bool euler_richardson(const OdeRate& rate, double t, double h, std::span<double> y);
  [[nodiscard]] bool runge_kutta_4(const OdeRate& rate, double t, double h, std::span<double> y);
  [[nodiscard]] bool fehlberg_stages(const OdeRate& rate, double t, double h,
                                     std::span<const double> y);
  [[nodiscard]] double fehlberg_error(double h, std::span<const double> y);
  OdeOutcome fehlberg(const OdeRate& rate, double t, double h, std::span<double> y);

  int size_;
  OdeMethod method_;
  double tolerance_;
  double own_step_ = 0.0;     // of kFehlberg45, > 0; 0: none yet
  std::vector<double> work_;  // six slopes, then a trial state
  std::int64_t evaluations_ = 0;
};

}  // namespace armlet
