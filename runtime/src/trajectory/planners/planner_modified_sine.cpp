// The planner ModSine: the modified sine law, whose acceleration changes least abruptly among the
// smooth laws.

#include "armlet/math/angles.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/trajectory/law_planner.hpp"
#include "armlet/trajectory/profile.hpp"
#include "trajectory/planners/planning.hpp"

namespace armlet {
namespace {

// Position, speed and acceleration at x of the modified sine law, which leads from 0 to 1: the
// acceleration is a sine of quick period in the first and last eighth and one of three times that
// period in between.
//
// source  R. L. Norton, Cam Design and Manufacturing Handbook, 2009, chapter 3, modified sine
//         acceleration.
AxisState modified_sine(double x) {
  constexpr double kQuick = 4.0 * kPi;
  constexpr double kSlow = kQuick / 3.0;
  constexpr double kPeak = 4.0 * kPi * kPi / (kPi + 4.0);
  const bool in_between = x > 0.125 && x < 0.875;
  const double frequency = in_between ? kSlow : kQuick;
  const auto [sine, cosine] = det::sincos(in_between ? kSlow * x + kPi / 3.0 : kQuick * x);
  const double lead = x <= 0.125 ? 0.0 : in_between ? 2.0 / kPi : 4.0 / kPi;
  const double ratio = kQuick / frequency;  // ratio of the two periods
  return {.q = kPeak / kQuick * (x + lead - ratio * ratio * sine / kQuick),
          .v = kPeak / kQuick * (1.0 - ratio * cosine),
          .a = kPeak * sine};
}

// The law as 64 pieces of degree 5, with errors below 1e-10.
ScalarLaw modified_sine_law() {
  constexpr int kPieces = 64;
  ScalarLaw law;
  for (int k = 0; k < kPieces; ++k) {
    const double begin = static_cast<double>(k) / kPieces;
    const double end = static_cast<double>(k + 1) / kPieces;
    const AxisState last = k + 1 == kPieces ? AxisState{.q = 1.0} : modified_sine(end);
    law.push_back(quintic_segment(modified_sine(begin), last, end - begin));
    law.back().start = begin;
  }
  return law;
}

}  // namespace

Plan plan_modified_sine(const MoveRequest& request) {
  static const Planner planner = planner_of_law(modified_sine_law());
  return planner(request);
}

}  // namespace armlet
