#pragma once
// Initial value problems y' = f(t, y): one-step methods with one interface.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace armlet {

// kEuler            order 1.
// kSymplectic       order 1, for a state [q; v]: v first, then q with the new v.
// kEulerRichardson  order 2: the slope at the middle, reached with half an Euler step.
// kRungeKutta4      order 4: the classic four slopes.
// kFehlberg45       order 5 with an error estimate of order 4, which controls the step size.
// kDormandPrince45  the same with smaller errors, and with a polynomial of order 4 within each
//                   step.
// kVerlet           order 2, for a state [q; v]: the velocity form of Verlet.
//
// For a state [q; v] the size is even, and the rate of the first half is the second half.
enum class OdeMethod : std::uint8_t {
  kEuler,
  kSymplectic,
  kEulerRichardson,
  kRungeKutta4,
  kFehlberg45,
  kDormandPrince45,
  kVerlet
};

// "euler", "symplectic", "euler-richardson", "rk4", "rkf45", "dopri5", "verlet", in the order of
// OdeMethod.
[[nodiscard]] std::span<const std::string_view> ode_method_names();
// The method of one of these names; empty for any other name.
[[nodiscard]] std::optional<OdeMethod> ode_method(std::string_view name);

// Writes f(t, y) to `rate`, which has as many elements as y. Returns false to end the integration.
using OdeRate = std::function<bool(double t, std::span<const double> y, std::span<double> rate)>;

enum class OdeStatus : std::uint8_t {
  kDone,
  kStopped,       // the rate function returned false
  kNotRates,      // kSymplectic, kVerlet: the derivative of an element of q is not its element of v
  kNotFinite,     // an element of the state became infinite or undefined
  kStepTooSmall,  // no step size meets the tolerance: stiff, or discontinuous
  kTooManySteps,  // a million steps did not reach the end: stiff
};

struct OdeOutcome {
  OdeStatus status = OdeStatus::kDone;
  double t = 0.0;   // time reached
  int element = 0;  // kNotFinite, kNotRates: index in the state
};

// Integrates one system. Memory is allocated by the constructor; steps allocate none.
class OdeIntegrator {
 public:
  // size       elements of the state, >= 0; even for kSymplectic and kVerlet.
  // tolerance  of the methods with step control: the root mean square over the elements of error /
  //            (tolerance (1 + |y|)) stays below 1 in every step.
  // throws     ArgumentError on another size or a tolerance that is not positive.
  OdeIntegrator(int size, OdeMethod method, double tolerance = 1e-8);

  // Moves the state y from t to t + h; h may be negative.
  //
  // The methods of fixed order do it in one step. kFehlberg45 takes as many steps as it needs, ends
  // at t + h exactly, and keeps its step size for the next call. kDormandPrince45 may step past t +
  // h, but not past `horizon`, and evaluates its polynomial at t + h; a call that continues from
  // the end of the last one uses the same step as far as it reaches. Any other state or time starts
  // a new integration. When the outcome is not kDone, y is the state at outcome.t (kStepTooSmall,
  // kTooManySteps) or undefined.
  //
  // horizon  time up to which f is smooth, not before t + h; nothing: t + h.
  // throws   ArgumentError if y has not `size` elements, t, h or horizon is not finite, or the
  //          horizon lies before t + h.
  // source   Euler-Richardson: H. Gould, J. Tobochnik, W. Christian, An Introduction to Computer
  //          Simulation Methods, 3rd ed. 2006, section 3.7. Classic: W. Kutta, Z. Math. Phys. 46,
  //          1901. Fehlberg: E. Fehlberg, NASA TR R-315, 1969, table III; the fifth-order result is
  //          kept. J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6, 1980; step control and
  //          polynomial: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential
  //          Equations I, 2nd ed. 1993, eq. II.4.13 and section II.6. Symplectic and Verlet: E.
  //          Hairer, C. Lubich, G. Wanner, Acta Numerica 12, 2003; where forces depend on v, the
  //          second half of Verlet's step evaluates them at v + h a.
  OdeOutcome advance(const OdeRate& rate, double t, double h, std::span<double> y,
                     std::optional<double> horizon = {});

  // To be called when the rate function has changed: discards what is known of the last step.
  void restart() { step_.is_known = knows_first_ = false; }

  // Number of calls of the rate function.
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  // An accepted step: its start and end; then its polynomial.
  struct Step {
    double begin = 0.0, end = 0.0;
    double read = 0.0;  // time up to which calls have used it
    bool is_known = false;
  };
  [[nodiscard]] std::span<double> stage(int k) {
    return {work_.data() + static_cast<std::ptrdiff_t>(k) * size_, static_cast<std::size_t>(size_)};
  }
  [[nodiscard]] bool slope(const OdeRate& rate, double t, std::span<const double> y, int k);
  [[nodiscard]] bool euler(const OdeRate& rate, double t, double h, std::span<double> y);
  [[nodiscard]] bool euler_richardson(const OdeRate& rate, double t, double h, std::span<double> y);
  [[nodiscard]] bool runge_kutta_4(const OdeRate& rate, double t, double h, std::span<double> y);
  OdeOutcome second_order(const OdeRate& rate, double t, double h, std::span<double> y);
  [[nodiscard]] bool pair_stages(const OdeRate& rate, double t, double h,
                                 std::span<const double> y);
  [[nodiscard]] double pair_error(double h, std::span<const double> y);
  OdeOutcome pair_step(const OdeRate& rate, double t, double end, std::span<double> y, int& steps);
  OdeOutcome pair_to(const OdeRate& rate, double t, double end, std::span<double> y);
  OdeOutcome dense_to(const OdeRate& rate, double t, double end, double horizon,
                      std::span<double> y);
  void make_polynomial(double h, std::span<const double> before);
  void read_polynomial(double t, std::span<double> y);

  int size_;
  OdeMethod method_;
  double tolerance_;
  double own_step_ = 0.0;     // of a method with step control, > 0; 0: none yet
  bool knows_first_ = false;  // the slope at the start of a step, from the end of the last
  Step step_{};               // of kDormandPrince45
  std::vector<double> work_;  // slopes, a trial state, coefficients of the polynomial
  std::int64_t evaluations_ = 0;
};

}  // namespace armlet
