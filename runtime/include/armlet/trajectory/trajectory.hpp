// Motion as a function of time: one piecewise polynomial per joint, for all planners.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

class SampleTable;

// One polynomial piece: q(t) = sum_k c[k] (t - start)^k for start <= t <= start + duration.
struct Segment {
  static constexpr int kMaxDegree = 7;
  double start = 0.0;     // s
  double duration = 0.0;  // s, > 0
  int degree = 0;         // the highest k in use, <= kMaxDegree
  std::array<double, kMaxDegree + 1> c{};

  // The derivative of the given order (0: position) at `u` seconds after the start of the piece.
  [[nodiscard]] double value(double u, int order = 0) const;
  [[nodiscard]] double end() const { return start + duration; }
};

// The motion of one joint. Pieces follow one another without a gap from t = 0; without pieces the
// joint is at rest at q_end. After the last piece the joint stays at q_end, which is exact.
struct JointPath {
  std::vector<Segment> segments{};
  double q_end = 0.0;
};

// A motion of n joints, checked by the constructor, immutable afterwards.
//
// Time is clamped: before 0 and after duration() the joints are at rest at the first and last
// position. At duration() the position is exactly the requested one.
class Trajectory {
 public:
  Trajectory() = default;

  // joints    one path each.
  // duration  s; joints that end earlier wait. At least the end of every path (within 1e-9 s).
  // throws    ArgumentError when pieces overlap, leave gaps, do not start at 0 or are not finite.
  Trajectory(std::vector<JointPath> joints, double duration);

  // n joints at rest at q for `duration` seconds (0 is allowed).
  static Trajectory at_rest(const Eigen::VectorXd& q, double duration);

  [[nodiscard]] int n() const { return static_cast<int>(joints_.size()); }
  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] const JointPath& joint(int i) const { return joints_[static_cast<size_t>(i)]; }
  [[nodiscard]] Eigen::VectorXd start() const;
  [[nodiscard]] Eigen::VectorXd end() const;

  // State at time t, s, without allocating: position, rad or m, speed and acceleration.
  // throws  ArgumentError if one of the arguments has not n elements.
  void sample(double t, Eigen::Ref<Eigen::VectorXd> q, Eigen::Ref<Eigen::VectorXd> qd,
              Eigen::Ref<Eigen::VectorXd> qdd) const;

  // The derivative of the given order (0: position, 3: jerk) of joint i, from 0, at time t, s.
  [[nodiscard]] double value(int i, double t, int order = 0) const;

  // All times at which some polynomial begins or ends, ascending, each once, from 0 to duration().
  [[nodiscard]] std::vector<double> knots() const;

  // The largest |derivative| of joint i inside of the pieces of the whole motion (order 1: speed,
  // 2: acceleration), from the roots of the next derivative, not from samples. Jumps between pieces
  // do not count: see continuity.
  [[nodiscard]] double peak(int i, int order) const;

  // Smallest and largest position of joint i over the whole motion.
  struct Range {
    double lower;
    double upper;
  };
  [[nodiscard]] Range range(int i) const;

  // The motion, executed `factor` times slower: duration and knots are multiplied by it, the
  // k-th derivative is divided by its k-th power.
  // throws  ArgumentError unless factor is finite and above zero.
  // source  J. M. Hollerbach, Dynamic scaling of manipulator trajectories, Journal of Dynamic
  //         Systems, Measurement, and Control 106, 1984.
  [[nodiscard]] Trajectory stretched(double factor) const;

  // This motion and then the next, which starts where this one ends.
  // throws  ArgumentError if the numbers of joints differ or a joint would jump more than 1e-9.
  [[nodiscard]] Trajectory then(const Trajectory& next) const;

  // The motion in the opposite direction, with the same path and duration.
  [[nodiscard]] Trajectory reversed() const;

  // The start of a motion: from rest, or from a given state.
  enum class Start { kAtRest, kMoving };

  // How smoothly joint i comes to rest: the highest order of derivative that is continuous at every
  // knot, zero at the end and, from rest, zero at the start; -1 if the position jumps. Differences
  // count if above `tolerance` times the peak of that derivative.
  [[nodiscard]] int continuity(int i, double tolerance = 1e-9, Start start = Start::kAtRest) const;

 private:
  std::vector<JointPath> joints_;
  double duration_ = 0.0;
  std::shared_ptr<const SampleTable> table_;  // shared by copies: it never changes
};

}  // namespace armlet
