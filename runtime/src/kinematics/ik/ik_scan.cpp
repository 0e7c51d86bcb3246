#include "ik_scan.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/angles.hpp"
#include "ik_free.hpp"

namespace armlet {
namespace {

constexpr int kSamples = 90;  // of a revolution
constexpr double kStep = 2.0 * kPi / kSamples;
constexpr double kNarrow = 1e-9;  // rad; shorter intervals are not halved
constexpr double kEdge = 1e-10;   // nor those at one end of which the branch does not exist
constexpr double kWorth = 1e-7;   // rad or m, smallest possible gain of an interval
// rad; nearer to the end of a branch, joints change like square roots:
constexpr double kNearEdge = 5e-3;
constexpr double kAtEdge = 0.35;  // rad or m there, and farther away in any direction
// bound on the curvature of joints between samples, relative to the second difference
constexpr double kBend = 0.7;
// rad or m of that from which on joints may move in any direction
constexpr double kSwing = 0.5;
constexpr double kOutside = 1e3;    // cost of a solution outside the limits
constexpr double kNone = 1e9;       // cost of no solution
constexpr double kSlightly = 1e-7;  // rad or m of excess that does not count
constexpr double kRevolution = 2.0 * kPi;
constexpr int kLooks = 600;  // largest number of further samples
constexpr std::size_t kMaxBranches = 16;
constexpr unsigned kEveryBranch = ~0U;

// One branch at one value.
struct Sample {
  bool exists = false;
  double at = 0.0;
  double cost = kNone;  // the largest change, or more than kOutside
  JointArray q{};       // as the formula has them
  unsigned loose = 0;   // joints that share an angle with others
};
using Samples = std::array<Sample, kMaxBranches>;

// A branch between two values, and the possible deviation of each joint from the straight line.
struct Piece {
  std::size_t branch = 0;
  Sample left, right;
  JointArray bend{};
};

struct Best {
  double cost = kNone;
  FormulaSolution solution;
};

// Samples a revolution, and halves the intervals between samples as long as a nearer solution is
// possible in them.
class Scan {
 public:
  Scan(const Robot& robot, const IkGoal& goal, const IkOptions& options, int joint,
       const Eigen::VectorXd& near, bool nearest_only)
      : nearest_only_(nearest_only),
        robot_(robot),
        goal_(goal),
        options_(options),
        joint_(joint),
        n_(static_cast<std::size_t>(robot.n())),
        near_(near) {
    T_world_tool_.linear() = goal.R;
    T_world_tool_.translation() = goal.p;
    start_ = joint == kArmAngle ? 0.0 : near[joint];
  }

  std::vector<FormulaSolution> run() {
    samples_.resize(kSamples);
    for (int k = 0; k < kSamples; ++k) {
      // Steps in the order 0, +1, -1, +2, -2, ...
      const int step = k % 2 == 1 ? (k + 1) / 2 : -k / 2;
      const double at = start_ + step * kStep;
      if (!is_too_far(at - kStep, at + kStep)) look(at, kEveryBranch, samples_[index(step)]);
    }
    std::vector<std::pair<double, Piece>> pieces;
    for (int step = 0; step < kSamples; ++step) {
      for (std::size_t b = 0; b < kMaxBranches; ++b) {
        const Piece piece = between_samples(step, b);
        const double bound = lower_bound(piece);
        if (bound < enough(b)) pieces.push_back({bound, piece});
      }
    }
    std::ranges::stable_sort(pieces, {}, &std::pair<double, Piece>::first);
    for (const auto& [bound, piece] : pieces) {
      if (bound < enough(piece.branch)) halve(piece);
    }
    std::vector<FormulaSolution> out;
    for (const Best& best : best_) {
      if (best.cost < kOutside) out.push_back(best.solution);
    }
    return out;
  }

 private:
  static std::size_t index(int step) {
    return static_cast<std::size_t>((step + kSamples) % kSamples);
  }

  // The cost that an interval must be able to undercut.
  double enough(std::size_t branch) const {
    return (nearest_only_ ? least_ : best_[branch].cost) - kWorth;
  }

  // Whether no value between low and high can be as near as the best known: the joint itself
  // changes by more.
  bool is_too_far(double low, double high) const {
    if (!nearest_only_ || joint_ == kArmAngle || is_shared_) return false;
    const double middle = angle_difference(0.5 * (low + high), options_.seed[joint_]);
    return std::abs(middle) - 0.5 * (high - low) > least_;
  }

  void look(double at, unsigned wanted, Samples& out) {
    double arm_angle_change = 0.0;
    (joint_ == kArmAngle ? arm_angle_change : near_[joint_]) = at;
    ClosedSolutions found;
    closed_form(robot_).solve(T_world_tool_, near_, found,
                              std::min(goal_.position_tolerance, goal_.rotation_tolerance),
                              arm_angle_change, wanted);
    for (const ClosedSolution& solution : found) {
      const auto branch = static_cast<std::size_t>(solution.branch);
      Sample& sample = out[branch];
      sample = {.exists = true, .at = at, .q = solution.q};
      FormulaSolution settled{solution.q, solution.branch};
      const double beyond = bring_near(robot_, goal_, options_, found.free, settled.q);
      if (found.free) sample.loose = differing(sample.q, settled.q);
      if (joint_ != kArmAngle) {
        const double moved = angle_difference(settled.q[static_cast<std::size_t>(joint_)], at);
        is_shared_ = is_shared_ || std::abs(moved) > kNarrow;
      }
      const double change = change_of(settled.q, options_.seed);
      sample.cost = beyond > kSlightly ? kOutside + beyond : change;
      // Among solutions of equal cost the first is kept; it is the one near to the present value.
      if (sample.cost < best_[branch].cost - 1e-12) best_[branch] = {sample.cost, settled};
      least_ = std::min(least_, sample.cost);
    }
  }

  // Bounds on the joints from the values at the one end at which the branch exists.
  static double bend_at_edge(const Piece& piece) {
    const double width = piece.right.at - piece.left.at;
    return width > kNearEdge ? kRevolution : kAtEdge * std::sqrt(width / kNearEdge);
  }

  double difference(std::size_t i, double from, double to) const {
    return robot_.is_revolute(static_cast<int>(i)) ? angle_difference(to, from) : to - from;
  }

  unsigned differing(const JointArray& a, const JointArray& b) const {
    unsigned bits = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (std::abs(difference(i, a[i], b[i])) > kNarrow) bits |= 1U << i;
    }
    return bits;
  }

  double second_difference(std::size_t i, const Sample& a, const Sample& b, const Sample& c) const {
    return std::abs(difference(i, b.q[i], c.q[i]) - difference(i, a.q[i], b.q[i]));
  }

  Piece between_samples(int step, std::size_t b) const {
    const Sample& before = samples_[index(step - 1)][b];
    const Sample& after = samples_[index(step + 2)][b];
    Piece piece{b, samples_[index(step)][b], samples_[index(step + 1)][b], {}};
    const bool whole = piece.left.exists && piece.right.exists;
    if (piece.left.exists) piece.right.at = piece.left.at + kStep;
    if (!whole && piece.right.exists) piece.left.at = piece.right.at - kStep;
    for (std::size_t i = 0; i < n_; ++i) {
      double& bend = piece.bend[i];
      if (!whole) {
        bend = bend_at_edge(piece);
        continue;
      }
      // Without neighbours, a joint may deviate by its whole difference.
      const double all = std::abs(difference(i, piece.left.q[i], piece.right.q[i]));
      bend = before.exists ? second_difference(i, before, piece.left, piece.right) : all;
      bend =
          std::max(bend, after.exists ? second_difference(i, piece.left, piece.right, after) : all);
      bend = bend > kSwing || all > kSwing ? kRevolution : kBend * bend;
    }
    return piece;
  }

  // A lower bound of the cost in the interval.
  double lower_bound(const Piece& piece) const {
    if (!piece.left.exists && !piece.right.exists) return kNone;
    if (is_too_far(piece.left.at, piece.right.at)) return kNone;
    const Sample& end = piece.left.exists ? piece.left : piece.right;
    const bool whole = piece.left.exists && piece.right.exists;
    double bound = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      if (((piece.left.loose | piece.right.loose) >> i & 1U) != 0) continue;
      const double other = whole ? end.q[i] + difference(i, end.q[i], piece.right.q[i]) : end.q[i];
      bound = std::max(bound,
                       change_within(robot_, options_, i, std::min(end.q[i], other) - piece.bend[i],
                                     std::max(end.q[i], other) + piece.bend[i]));
    }
    return bound;
  }

  // Processes the more promising half first.
  void halve(const Piece& piece) {
    const bool whole = piece.left.exists && piece.right.exists;
    if (piece.right.at - piece.left.at < (whole ? kNarrow : kEdge) || looks_ >= kLooks) return;
    ++looks_;
    Samples middle;
    const double at = 0.5 * (piece.left.at + piece.right.at);
    look(at, 1U << piece.branch, middle);
    Sample& sample = middle[piece.branch];
    sample.at = at;
    std::array<Piece, 2> halves = {Piece{piece.branch, piece.left, sample, {}},
                                   Piece{piece.branch, sample, piece.right, {}}};
    for (std::size_t i = 0; i < n_; ++i) {
      const double second =
          whole && sample.exists ? second_difference(i, piece.left, sample, piece.right) : 0.0;
      for (Piece& half : halves) {
        const bool whole_half = half.left.exists && half.right.exists;
        const double all =
            whole_half ? std::abs(difference(i, half.left.q[i], half.right.q[i])) : 0.0;
        if (!whole_half)
          half.bend[i] = bend_at_edge(half);
        else if (!whole)
          half.bend[i] = all > kSwing ? kRevolution : all;
        else
          half.bend[i] = second > kSwing || all > kSwing ? kRevolution : kBend * second;
      }
    }
    if (lower_bound(halves[1]) < lower_bound(halves[0])) std::swap(halves[0], halves[1]);
    for (const Piece& half : halves) {
      if (lower_bound(half) < enough(half.branch)) halve(half);
    }
  }

  bool nearest_only_;
  bool is_shared_ = false;  // with other joints, which changes the value after the closed form
  double least_ = kNone;    // smallest cost so far
  int looks_ = 0;
  const Robot& robot_;
  const IkGoal& goal_;
  const IkOptions& options_;
  int joint_;
  std::size_t n_;
  Eigen::VectorXd near_;
  Eigen::Isometry3d T_world_tool_ = Eigen::Isometry3d::Identity();
  double start_ = 0.0;
  std::vector<Samples> samples_;
  std::array<Best, kMaxBranches> best_;
};

}  // namespace

std::vector<FormulaSolution> scan_open_joint(const Robot& robot, const IkGoal& goal,
                                             const IkOptions& options, int joint,
                                             const Eigen::VectorXd& near, bool nearest_only) {
  return Scan(robot, goal, options, joint, near, nearest_only).run();
}

}  // namespace armlet
