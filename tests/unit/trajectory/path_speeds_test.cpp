// Paths whose moves have speeds of their own, against an independent optimum along the same curve.
// ARMLET_SURVEY=100 ARMLET_SEED=1 runs it over so many paths.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "motions.hpp"
#include "survey.hpp"

using namespace armlet;
using Eigen::VectorXd;

namespace {

struct SpeedCase {
  Robot robot;
  PathMove move;
};

// From two to four straight moves of 5 to 30 cm in random directions, at 10 to 250 mm/s, with
// corners of 5 to 100 mm.
SpeedCase random_case(std::mt19937_64& generator) {
  constexpr const char* kArms[] = {"ur5", "irb120", "puma560", "pa10_6"};
  SpeedCase out{*make_robot(kArms[generator() % 4]), {}};
  const VectorXd middle = 0.5 * (out.robot.lower() + out.robot.upper());
  out.move.q0 = middle;
  for (Eigen::Index i = 0; i < middle.size(); ++i)
    out.move.q0[i] += uniform(generator, -0.6, 0.6) + (i == 2 || i == 4 ? 1.0 : 0.0);
  Eigen::Isometry3d T = forward(out.robot, out.move.q0);
  for (int k = 2 + static_cast<int>(generator() % 3); k > 0; --k) {
    Eigen::Vector3d way(uniform(generator, -1, 1), uniform(generator, -1, 1),
                        uniform(generator, -1, 1));
    T.translation() += uniform(generator, 0.05, 0.3) * way.normalized();
    out.move.points.push_back({.T_world_tool = T,
                               .blend = 0.005 * std::pow(20.0, uniform(generator, 0, 1)),
                               .tool_speed = 0.01 * std::pow(25.0, uniform(generator, 0, 1))});
  }
  out.move.points.back().blend = 0.0;
  return out;
}

// The curve of a motion at positions along what the tool point travels: speeds of the joints per
// metre and how they change, and the speed that is asked for there.
struct CurvePoint {
  double x = 0.0;
  VectorXd slope, curvature;
  double speed = INFINITY;
};

class SpeedCurve {
 public:
  SpeedCurve(const SpeedCase& c, const PathPlan& plan)
      : case_(c), motion_(*plan.motion.trajectory) {
    constexpr int kTimes = 40000;
    double x = 0.0, before = 0.0;
    for (int k = 0; k <= kTimes; ++k) {
      t_.push_back(motion_.duration() * k / kTimes);
      const double v = speed_at(t_.back());
      x += 0.5 * (v + before) * motion_.duration() / kTimes * (k > 0 ? 1.0 : 0.0);
      before = v;
      x_.push_back(x);
    }
    for (const double t : plan.times) borders_.push_back(travelled(t));
  }

  // The squared speed is 0 at both ends, where no slopes are needed.
  std::vector<CurvePoint> points(int count) const {
    std::vector<CurvePoint> out;
    for (int k = 0; k <= count; ++k) {
      const double x = x_.back() * k / count;
      out.push_back(point_at(
          time_of(std::clamp(x, 0.02 * x_.back() / count, x_.back() * (1.0 - 0.02 / count)))));
      out.back().x = x;
      for (std::size_t leg = 0; leg < borders_.size(); ++leg) {
        const double from = leg > 0 ? borders_[leg - 1] : 0.0;
        if (x >= from && x <= borders_[leg])
          out.back().speed = std::min(out.back().speed, *case_.move.points[leg].tool_speed);
      }
    }
    return out;
  }

 private:
  double speed_at(double t) const {
    VectorXd q(motion_.n()), qd(motion_.n()), qdd(motion_.n());
    motion_.sample(t, q, qd, qdd);
    return (jacobian(case_.robot, q).topRows<3>() * qd).norm();
  }

  double travelled(double t) const {
    const auto k = static_cast<std::size_t>(std::clamp(t / motion_.duration(), 0.0, 1.0) *
                                            static_cast<double>(t_.size() - 1));
    return x_[k];
  }

  double time_of(double x) const {
    const auto after = std::ranges::upper_bound(x_, x);
    const auto k =
        std::clamp<std::size_t>(static_cast<std::size_t>(after - x_.begin()), 1, x_.size() - 1);
    const double step = x_[k] - x_[k - 1];
    return t_[k - 1] + (step > 0.0 ? (x - x_[k - 1]) / step : 0.0) * (t_[k] - t_[k - 1]);
  }

  CurvePoint point_at(double t) const {
    const double h = 1e-5 * motion_.duration();
    t = std::clamp(t, h, motion_.duration() - h);
    VectorXd q(motion_.n()), qd(motion_.n()), qdd(motion_.n());
    motion_.sample(t, q, qd, qdd);
    const double v = speed_at(t), vd = (speed_at(t + h) - speed_at(t - h)) / (2.0 * h);
    CurvePoint out;
    out.slope = qd / v;
    out.curvature = (qdd - out.slope * vd) / (v * v);
    return out;
  }

  const SpeedCase& case_;
  const Trajectory& motion_;
  std::vector<double> t_, x_, borders_;
};

// Whether from a squared speed b, at one end of an interval of width h, squared speeds of at most
// `other` at its other end can be reached within the accelerations of the joints.
bool can_reach(const Robot& robot, const CurvePoint& point, double b, double other, double h) {
  double least = -INFINITY, most = INFINITY;  // of the change of b per metre
  for (int i = 0; i < robot.n(); ++i) {
    const double A = robot.max_accel()[i], base = point.curvature[i] * b;
    const double half = 0.5 * point.slope[i];
    if (std::abs(half) < 1e-9) {
      if (std::abs(base) > A) return false;
      continue;
    }
    const double one = (-A - base) / half, two = (A - base) / half;
    least = std::max(least, std::min(one, two));
    most = std::min(most, std::max(one, two));
  }
  return least <= most && least <= (other - b) / h && most >= -b / h;
}

// The least time along a curve by bisection at every position: backwards the highest squared speed
// from which the rest can be run, forwards the highest one within that. Limits on jerk are left
// out.
//
// source  H. Pham, Q.-C. Pham, A new approach to time-optimal path parameterization based on
//         reachability analysis, IEEE T-RO 34(3), 2018.
double least_time(const Robot& robot, const std::vector<CurvePoint>& curve) {
  const std::size_t last = curve.size() - 1;
  std::vector<double> most(curve.size(), 0.0);
  const auto bound = [&](std::size_t k) {
    double v = curve[k].speed;
    for (int i = 0; i < robot.n(); ++i)
      v = std::min(v, robot.max_speed()[i] / std::max(std::abs(curve[k].slope[i]), 1e-12));
    return v * v;
  };
  const auto highest = [](double low, double high, const auto& is_possible) {
    if (is_possible(high)) return high;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (is_possible(middle) ? low : high) = middle;
    }
    return low;
  };
  for (std::size_t k = last; k-- > 1;) {
    const double h = curve[k + 1].x - curve[k].x;
    most[k] = highest(0.0, bound(k),
                      [&](double b) { return can_reach(robot, curve[k], b, most[k + 1], h); });
  }
  double time = 0.0, b = 0.0;
  for (std::size_t k = 0; k < last; ++k) {
    const double h = curve[k + 1].x - curve[k].x;
    // The same limits, from the other end.
    const double next = highest(0.0, most[k + 1], [&](double to) {
      for (int i = 0; i < robot.n(); ++i) {
        const double a = 0.5 * curve[k].slope[i] * (to - b) / h + curve[k].curvature[i] * b;
        if (to > b && std::abs(a) > robot.max_accel()[i]) return false;
      }
      return true;
    });
    time += 2.0 * h / (std::sqrt(b) + std::sqrt(next));
    b = next;
  }
  return time;
}

double time_of(SpeedCase c, Jerk jerk) {
  c.move.jerk = jerk;
  const PathPlan plan = plan_path(c.robot, c.move);
  REQUIRE(plan.ok());
  return plan.motion.trajectory->duration();
}

}  // namespace

// What limits on jerk add to each change of the speed: at most the time in which they let a joint
// come to its highest acceleration. The speed changes at both ends and at each corner, there down
// and up again.
TEST_CASE(
    "survey of paths with unequal speeds: at most 5 % longer than the optimum of their curve and "
    "what limits on jerk add to each change of speed") {
  std::mt19937_64 generator(survey_seed(81));
  const int count = survey_count(12);
  int tried = 0, above = 0;
  double worst = 0.0, worst_free = 0.0, sum = 0.0;
  for (int k = 0; k < count; ++tried) {
    REQUIRE(tried < 100 * count);
    const SpeedCase c = random_case(generator);
    const PathPlan plan = plan_path(c.robot, c.move);
    if (!plan.ok()) continue;
    CAPTURE(k);
    ++k;
    const double T = plan.motion.trajectory->duration();
    const double least = least_time(c.robot, SpeedCurve(c, plan).points(2000));
    const double ramp = (c.robot.max_accel().array() / c.robot.max_jerk().array()).maxCoeff();
    const double ramps = ramp * static_cast<double>(2 * c.move.points.size());
    const double free = time_of(c, Jerk::kFree) / least;
    CHECK(T >= least * 0.995);  // the optimum is found at 2,000 positions
    CHECK(T <= 1.05 * (least + ramps));
    above += T > 1.05 * least ? 1 : 0;
    sum += T / least / count;
    worst = std::max(worst, T / (least + ramps));
    worst_free = std::max(worst_free, free);
    if (T > 1.05 * (least + ramps))
      MESSAGE(c.robot.name() << ", " << c.move.points.size() << " moves: " << T << " s, optimum "
                             << least << " s, changes with limited jerk " << ramps << " s, " << free
                             << " without");
  }
  MESSAGE(count << " paths: " << 100.0 * (worst - 1.0)
                << " % at most beyond the optimum and what limits on jerk add to each change of "
                   "speed; without limits on jerk "
                << 100.0 * (worst_free - 1.0) << " %; all in all " << 100.0 * (sum - 1.0)
                << " % in the mean, " << above << " above 5 %");
}

// A wider corner is a shorter path, and each half of it is run at the speed of its own move.
TEST_CASE("a path takes no longer with wider corners") {
  std::mt19937_64 generator(survey_seed(82));
  const int count = survey_count(6);
  double worst = 0.0;
  for (int k = 0; k < count;) {
    SpeedCase c = random_case(generator);
    if (!plan_path(c.robot, c.move).ok()) continue;
    CAPTURE(k);
    ++k;
    double before = INFINITY;
    for (const double blend : {0.005, 0.01, 0.02, 0.05, 0.1, 0.2}) {
      for (std::size_t i = 0; i + 1 < c.move.points.size(); ++i) c.move.points[i].blend = blend;
      const PathPlan plan = plan_path(c.robot, c.move);
      if (!plan.ok()) break;
      const double T = plan.motion.trajectory->duration();
      CHECK(T <= 1.01 * before);
      worst = std::max(worst, T / before);
      before = std::min(before, T);
    }
  }
  MESSAGE("at most " << 100.0 * (worst - 1.0) << " % longer");
}
