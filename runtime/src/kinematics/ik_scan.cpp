#include "ik_scan.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/angles.hpp"
#include "ik_free.hpp"

namespace armlet {
namespace {

constexpr int kSamples = 90;  // of a turn
constexpr double kStep = 2.0 * kPi / kSamples;
constexpr double kCoarse = 1e-3;  // rad, of all valleys that are looked at
constexpr double kFine = 1e-9;    // of the best of them
constexpr std::size_t kValleys = 24;
constexpr std::size_t kDeepest = 5;
constexpr double kMayFall = 0.35;   // rad or m that a valley may lie below its sample
constexpr double kOutside = 1e3;    // counted for a solution outside the limits
constexpr double kNone = 1e9;       // for none
constexpr double kSlightly = 1e-7;  // rad or m beyond a limit that is none
constexpr double kGolden = 0.6180339887498949;

// One branch at one value.
struct Choice {
  double cost = kNone;    // the largest change, or more than kOutside
  double change = kNone;  // also where it is outside
  double at = 0.0;
  FormulaSolution solution;
};
using Choices = std::array<Choice, kMaxBranches>;

class Scan {
 public:
  Scan(const Robot& robot, const IkGoal& goal, const IkOptions& options, int joint,
       const Eigen::VectorXd& near, Copies copies)
      : copies_(copies), robot_(robot), goal_(goal), options_(options), joint_(joint), near_(near) {
    T_world_tool_.linear() = goal.R;
    T_world_tool_.translation() = goal.p;
    start_ = joint == kArmAngle ? 0.0 : near[joint];
  }

  std::vector<FormulaSolution> run() {
    std::vector<Choices> samples(kSamples);
    for (int k = 0; k < kSamples; ++k)
      look(start_ + k * kStep, kEveryBranch, samples[static_cast<std::size_t>(k)]);
    std::vector<Valley> valleys;
    for (std::size_t b = 0; b < kMaxBranches; ++b) find_valleys(samples, b, valleys);
    std::ranges::stable_sort(valleys, {}, &Valley::change);
    if (valleys.size() > kValleys) valleys.resize(kValleys);
    for (Valley& valley : valleys) {
      if (valley.change < best_[valley.branch].cost + kMayFall) narrow(valley, kCoarse);
    }
    std::ranges::stable_sort(valleys, {}, &Valley::cost);
    // The best of all, and of each branch the best one.
    std::array<bool, kMaxBranches> seen{};
    for (std::size_t k = 0; k < valleys.size(); ++k) {
      const bool first = !seen[valleys[k].branch] && joint_ != kArmAngle;
      if (k < kDeepest || first) narrow(valleys[k], kFine);
      seen[valleys[k].branch] = true;
    }
    std::vector<FormulaSolution> out;
    for (const Choice& choice : best_) {
      if (choice.cost < kOutside) out.push_back(choice.solution);
    }
    return out;
  }

 private:
  // Between low and high a branch is nearer, or nearer to its limits, than at both.
  struct Valley {
    std::size_t branch = 0;
    double low = 0.0, high = 0.0;
    double cost = kNone;
    double change = kNone;
  };

  static std::size_t branch_of(const Choice& c) {
    return static_cast<std::size_t>(c.solution.branch);
  }

  void look(double at, unsigned wanted, Choices& out) {
    double arm_turn = 0.0;
    (joint_ == kArmAngle ? arm_turn : near_[joint_]) = at;
    ClosedSolutions found;
    closed_form(robot_).solve(T_world_tool_, near_, found,
                              std::min(goal_.position_tolerance, goal_.rotation_tolerance),
                              arm_turn, wanted);
    for (const ClosedSolution& solution : found) {
      Choice choice{.at = at, .solution = {solution.q, solution.branch}};
      const double beyond =
          bring_near(robot_, goal_, options_, found.free, choice.solution.q, copies_);
      choice.change = change_of(choice.solution.q, options_.seed);
      choice.cost = beyond > kSlightly ? kOutside + beyond : choice.change;
      const std::size_t b = branch_of(choice);
      // Of equals the one that came first, which is the one near to the present value.
      if (choice.cost < best_[b].cost - 1e-12) best_[b] = choice;
      out[b] = choice;
    }
  }
  double cost_at(double at, std::size_t branch) {
    Choices out;
    look(at, 1U << branch, out);
    return out[branch].cost;
  }

  void find_valleys(const std::vector<Choices>& samples, std::size_t b,
                    std::vector<Valley>& valleys) const {
    const std::size_t n = samples.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Choice& here = samples[k][b];
      if (here.cost < kNone && here.cost <= samples[(k + n - 1) % n][b].cost &&
          here.cost <= samples[(k + 1) % n][b].cost)
        valleys.push_back({b, here.at - kStep, here.at + kStep, here.cost, here.change});
    }
  }

  void narrow(Valley& valley, double width) {
    double& low = valley.low;
    double& high = valley.high;
    double inner = high - kGolden * (high - low);
    double outer = low + kGolden * (high - low);
    double at_inner = cost_at(inner, valley.branch);
    double at_outer = cost_at(outer, valley.branch);
    while (high - low > width) {
      if (at_inner <= at_outer) {
        high = outer;
        outer = inner;
        at_outer = at_inner;
        inner = high - kGolden * (high - low);
        at_inner = cost_at(inner, valley.branch);
      } else {
        low = inner;
        inner = outer;
        at_inner = at_outer;
        outer = low + kGolden * (high - low);
        at_outer = cost_at(outer, valley.branch);
      }
    }
    valley.cost = std::min(at_inner, at_outer);
  }

  Copies copies_;
  const Robot& robot_;
  const IkGoal& goal_;
  const IkOptions& options_;
  int joint_;
  Eigen::VectorXd near_;
  Eigen::Isometry3d T_world_tool_ = Eigen::Isometry3d::Identity();
  double start_ = 0.0;
  Choices best_;
};

}  // namespace

std::vector<FormulaSolution> scan_open_joint(const Robot& robot, const IkGoal& goal,
                                             const IkOptions& options, int joint,
                                             const Eigen::VectorXd& near) {
  // Limits hide a narrow interval where copies inside them take over, so these come second: they
  // lie at least half a turn away.
  auto out = Scan(robot, goal, options, joint, near, Copies::kAll).run();
  const auto is_near = [&](const FormulaSolution& s) { return change_of(s.q, options.seed) < kPi; };
  if (std::ranges::any_of(out, is_near)) return out;
  const auto far = Scan(robot, goal, options, joint, near, Copies::kInside).run();
  out.insert(out.end(), far.begin(), far.end());
  return out;
}

}  // namespace armlet
