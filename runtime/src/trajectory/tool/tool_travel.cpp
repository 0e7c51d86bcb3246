#include "trajectory/tool/tool_travel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/kinematics/jacobian.hpp"

namespace armlet {
namespace {

// The speed of the tool point at a time, m/s; or per unit of the motion's parameter.
class ToolSpeed {
 public:
  ToolSpeed(const Robot& robot, const Trajectory& motion)
      : robot_(robot), motion_(motion), q_(robot.n()), qd_(robot.n()), qdd_(robot.n()) {}

  double at(double t) {
    motion_.sample(t, q_, qd_, qdd_);
    forward_and_jacobian(robot_, q_, J_);
    return (J_.topRows<3>() * qd_).norm();
  }

 private:
  const Robot& robot_;
  const Trajectory& motion_;
  Eigen::VectorXd q_, qd_, qdd_;
  Jacobian J_;
};

}  // namespace

std::vector<Segment> tool_travel(const Robot& robot, const Trajectory& path) {
  ToolSpeed rate(robot, path);
  const std::vector<double> s = path.knots();
  std::vector<Segment> travel;
  double so_far = 0.0;
  double g1 = rate.at(0.0);
  for (std::size_t k = 0; k + 1 < s.size(); ++k) {
    const double h = s[k + 1] - s[k];
    const double g0 = g1, middle = rate.at(s[k] + 0.5 * h);
    g1 = rate.at(s[k + 1]);
    travel.push_back({.start = s[k],
                      .duration = h,
                      .degree = 3,
                      .c = {so_far, g0, (4.0 * middle - 3.0 * g0 - g1) / (2.0 * h),
                            2.0 * (g0 + g1 - 2.0 * middle) / (3.0 * h * h)}});
    so_far += h * (g0 + 4.0 * middle + g1) / 6.0;
  }
  return travel;
}

namespace {

// The maximum of a function on an interval: of the parabolas through neighbouring samples.
template <class Function>
double highest(Function f, double from, double to) {
  constexpr int kSamples = 8;
  std::array<double, kSamples + 1> v{};
  for (int k = 0; k <= kSamples; ++k)
    v[static_cast<std::size_t>(k)] = f(from + (to - from) * k / kSamples);
  double most = std::max(v.front(), v.back());
  for (std::size_t k = 1; k < kSamples; ++k) {
    most = std::max(most, v[k]);
    const double curve = v[k - 1] - 2.0 * v[k] + v[k + 1];
    const double slope = 0.5 * (v[k + 1] - v[k - 1]);
    if (curve < 0.0 && std::abs(slope) <= -curve)
      most = std::max(most, v[k] - 0.5 * slope * slope / curve);
  }
  return most;
}

}  // namespace

double tool_excess(const Robot& robot, const TimedRun& run, std::span<const SpeedZone> zones) {
  double most = 0.0;
  ToolSpeed speed(robot, run.motion);
  const std::vector<double> knots = run.motion.knots();
  for (const SpeedZone& zone : zones) {
    if (!std::isfinite(zone.speed)) continue;
    const double from = run.time_at(zone.from), to = run.time_at(zone.to);
    auto k = static_cast<std::size_t>(std::ranges::upper_bound(knots, from) - knots.begin());
    for (k = std::max<std::size_t>(k, 1); k < knots.size() && knots[k - 1] < to; ++k) {
      const double begin = std::max(from, knots[k - 1]), end = std::min(to, knots[k]);
      const double here = highest([&](double t) { return speed.at(t); }, begin, end);
      most = std::max(most, here / zone.speed);
    }
  }
  return most;
}

}  // namespace armlet
