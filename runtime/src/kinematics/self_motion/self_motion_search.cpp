#include "kinematics/self_motion/self_motion_search.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/ik/ik_free.hpp"
#include "kinematics/self_motion/self_motion.hpp"

namespace armlet {
namespace {

constexpr double kFinest = 1e-8;        // rad or m; shorter pieces are not halved
constexpr double kWorthLooking = 1e-7;  // rad or m, smallest possible gain of a piece
// bound on the curvature of joints, relative to the second difference
constexpr double kBending = 0.7;
constexpr int kMaxLooks = 400;
constexpr int kRefinements = 10;

// A part of the curve, and the possible deviation of each joint from the straight line.
struct Arc {
  JointArray left, right, bend;
};

class CurveSearch {
 public:
  CurveSearch(const Robot& robot, const IkGoal& goal, const IkOptions& options, JointArray& q,
              double& change)
      : robot_(robot),
        goal_(goal),
        options_(options),
        n_(static_cast<std::size_t>(robot.n())),
        solver_(robot, goal),
        best_(q),
        change_(change) {}

  bool run(const std::vector<JointArray>& traced) {
    std::vector<JointArray> curve = traced;
    std::vector<bool> wanted(curve.size(), false);
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      if (lower_bound(between(curve, k)) < enough()) wanted[k] = wanted[k + 1] = true;
    }
    for (std::size_t k = 0; k < curve.size(); ++k) {
      JointArray exact = curve[k];
      if (wanted[k] && solver_.solve_free(exact, kRefinements)) curve[k] = exact;
    }
    std::vector<std::pair<double, Arc>> arcs;
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      if (!wanted[k] || !wanted[k + 1]) continue;
      const Arc arc = between(curve, k);
      const double bound = lower_bound(arc);
      if (bound < enough()) arcs.push_back({bound, arc});
    }
    std::ranges::stable_sort(arcs, {}, &std::pair<double, Arc>::first);
    for (const auto& [bound, arc] : arcs) {
      if (bound >= enough()) break;
      look(arc.left);
      look(arc.right);
    }
    for (const auto& [bound, arc] : arcs) {
      if (bound >= enough()) break;
      halve(arc);
    }
    return found_;
  }

 private:
  double enough() const { return change_ - kWorthLooking; }

  static double second_difference(std::size_t i, const JointArray& a, const JointArray& b,
                                  const JointArray& c) {
    return std::abs((c[i] - b[i]) - (b[i] - a[i]));
  }

  Arc between(const std::vector<JointArray>& curve, std::size_t k) const {
    Arc arc{curve[k], curve[k + 1], {}};
    for (std::size_t i = 0; i < n_; ++i) {
      double& bend = arc.bend[i];
      if (k > 0) bend = second_difference(i, curve[k - 1], arc.left, arc.right);
      if (k + 2 < curve.size())
        bend = std::max(bend, second_difference(i, arc.left, arc.right, curve[k + 2]));
      bend = kBending * bend;
    }
    return arc;
  }

  // A lower bound of the joint change on the arc.
  double lower_bound(const Arc& arc) const {
    double bound = 0.0;
    for (std::size_t i = 0; i < n_ && bound < enough(); ++i) {
      const auto [low, high] = std::minmax(arc.left[i], arc.right[i]);
      bound = std::max(bound,
                       change_within(robot_, options_, i, low - arc.bend[i], high + arc.bend[i]));
    }
    return bound;
  }

  // Uses a point of the curve if it is nearer, after refinement.
  void look(const JointArray& at) {
    double away = 0.0;
    for (std::size_t i = 0; i < n_ && away < enough(); ++i)
      away = std::max(away, change_within(robot_, options_, i, at[i], at[i]));
    if (!(away < enough())) return;
    JointArray q = at;
    if (bring_near(robot_, goal_, options_, false, q) > kLimitSlack) return;
    const bool solved = options_.respect_limits ? solver_.solve_in_box(q, kRefinements)
                                                : solver_.solve_free(q, kRefinements);
    if (!solved) return;
    if (!goal_.is_met(solver_.error_of(q))) return;
    const bool singular = idle_directions(robot_, goal_, q, kIdleTool).cols() == 0;
    slide_nearer(robot_, goal_, options_, q, singular ? kNearlyIdleTool : kIdleTool);
    const double change = change_of(q, options_.seed);
    if (!(change < enough())) return;
    found_ = true;
    best_ = q;
    change_ = change;
  }

  // Divides an arc into halves, and searches the more promising one first.
  void halve(const Arc& arc) {
    double width = 0.0;
    for (std::size_t i = 0; i < n_; ++i)
      width = std::max(width, std::abs(arc.right[i] - arc.left[i]));
    if (width < kFinest || looks_ >= kMaxLooks) return;
    ++looks_;
    JointArray middle{};
    for (std::size_t i = 0; i < n_; ++i) middle[i] = 0.5 * (arc.left[i] + arc.right[i]);
    if (!solver_.solve_free(middle, kRefinements)) return;
    std::array<Arc, 2> halves = {Arc{arc.left, middle, {}}, Arc{middle, arc.right, {}}};
    for (std::size_t i = 0; i < n_; ++i) {
      const double bend = kBending * second_difference(i, arc.left, middle, arc.right);
      halves[0].bend[i] = halves[1].bend[i] = bend;
    }
    look(middle);
    std::array<double, 2> bounds = {lower_bound(halves[0]), lower_bound(halves[1])};
    if (bounds[1] < bounds[0]) {
      std::swap(halves[0], halves[1]);
      std::swap(bounds[0], bounds[1]);
    }
    for (std::size_t k = 0; k < 2; ++k) {
      if (bounds[k] < enough()) halve(halves[k]);
    }
  }

  const Robot& robot_;
  const IkGoal& goal_;
  const IkOptions& options_;
  std::size_t n_;
  IkSolver solver_;
  JointArray& best_;
  double& change_;
  bool found_ = false;
  int looks_ = 0;
};

}  // namespace

bool search_curve(const Robot& robot, const IkGoal& goal, const IkOptions& options,
                  const std::vector<JointArray>& curve, JointArray& q, double& change) {
  return CurveSearch(robot, goal, options, q, change).run(curve);
}

}  // namespace armlet
