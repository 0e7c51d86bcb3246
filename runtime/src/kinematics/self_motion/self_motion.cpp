#include "kinematics/self_motion/self_motion.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/angles.hpp"
#include "kinematics/forward/periodic.hpp"
#include "kinematics/self_motion/self_motion_search.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

constexpr double kTraceStep = 0.25;      // rad or m; norm over the joints
constexpr double kShortestTrace = 1e-4;  // for sharp bends of a curve
constexpr double kBendCosine = 0.94;     // of the directions at both ends of a step
constexpr double kTraceAstray = 0.4;     // of a step, largest correction
constexpr double kCloseToCurve = 0.05;   // rad or m; a point nearer to a curve is projected onto it
constexpr double kOnCurve = 1e-4;        // rad or m, and
constexpr double kStillAway = 0.3;       // ratio of distances, for a point that is not on it
constexpr double kFirstCorrection = 3e-3;  // largest remaining error, m and rad
constexpr int kTraceCorrections = 10;
constexpr double kLookAhead = 1e-4;      // rad or m, for the curvature at a singularity
constexpr double kFarthestMirror = 3.0;  // rad or m
constexpr int kMirrorCorrections = 20;
constexpr std::size_t kMaxCurves = 32;
constexpr std::size_t kMaxPoints = 400;

using Eigen::VectorXd;

}  // namespace

namespace {

// The Jacobian with the rows outside of the task set to zero.
Jacobian counting_jacobian(const Robot& robot, const IkGoal& goal, const JointArray& q) {
  const JacobianFrame frame = goal.in_tool_axes ? JacobianFrame::kTool : JacobianFrame::kWorld;
  Jacobian J = jacobian(robot, Eigen::Map<const VectorXd>(q.data(), robot.n()), frame);
  for (Eigen::Index r = 0; r < 6; ++r) {
    if (goal.weights[r] == 0.0) J.row(r).setZero();
  }
  return J;
}

}  // namespace

JointDirections idle_directions(const Robot& robot, const IkGoal& goal, const JointArray& q,
                                double rank_tolerance) {
  const Jacobian J = counting_jacobian(robot, goal, q);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxJoints, 6>;
  const Eigen::ColPivHouseholderQR<Rows> rows(J.transpose());
  const auto pivots = rows.matrixQR().diagonal();
  Eigen::Index rank = 0;
  while (rank < pivots.size() && std::abs(pivots[rank]) > rank_tolerance) ++rank;
  const JointDirections Q = rows.householderQ();
  return Q.rightCols(robot.n() - rank);
}

SelfMotions::SelfMotions(const Robot& robot, const IkGoal& goal, const IkOptions& options)
    : robot_(robot),
      goal_(goal),
      options_(options),
      n_(static_cast<std::size_t>(robot.n())),
      solver_(robot, goal) {
  for (std::size_t i = 0; i < n_; ++i) turns_[i] = is_periodic(robot, static_cast<int>(i));
}

// b - a; for revolute joints modulo revolutions, within half a revolution.
inline double SelfMotions::difference(std::size_t i, double a, double b) const {
  const double d = b - a;
  if (!turns_[i]) return d;
  constexpr double kToInteger = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds
  return d - 2.0 * kPi * ((d / (2.0 * kPi) + kToInteger) - kToInteger);
}

// One step along the curve, with a correction back onto it; `along` becomes the direction of the
// chord. Where two curves cross, the step goes straight on.
//
// source  E. L. Allgower, K. Georg, Numerical Continuation Methods, 1990, chapter 2 (predictor and
//         corrector).
bool SelfMotions::step(const JointArray& from, JointArray& along, double length, JointArray& to) {
  for (std::size_t i = 0; i < n_; ++i) to[i] = from[i] + length * along[i];
  const JointArray aimed = to;
  if (!solver_.correct(to, kFirstCorrection)) return false;
  double astray = 0.0, square = 0.0, ahead = 0.0;
  for (std::size_t i = 0; i < n_; ++i) {
    const double difference = to[i] - from[i];
    astray += (to[i] - aimed[i]) * (to[i] - aimed[i]);
    square += difference * difference;
    ahead += difference * along[i];
  }
  const double size = std::sqrt(square);
  if (astray > kTraceAstray * kTraceAstray * length * length || ahead < kBendCosine * size)
    return false;
  for (std::size_t i = 0; i < n_; ++i) along[i] = (to[i] - from[i]) / size;
  return true;
}

// Whether a prismatic joint is so far outside its limits that the curve will hardly return.
bool SelfMotions::slides_away(const JointArray& q) const {
  for (std::size_t i = 0; i < n_; ++i) {
    if (turns_[i]) continue;
    const auto k = static_cast<Eigen::Index>(i);
    const double lower = robot_.lower()[k], upper = robot_.upper()[k];
    if (std::abs(q[i] - 0.5 * (lower + upper)) > upper - lower) return true;
  }
  return false;
}

// Adds points until the curve is closed; returns whether it is.
bool SelfMotions::walk(const JointArray& from, const JointArray& first, Curve& curve) {
  JointArray along = first, at = from;
  double length = kTraceStep, gone = 0.0;
  while (curve.size() < kMaxPoints) {
    JointArray chord = along, next{};
    if (!step(at, chord, length, next)) {
      length *= 0.5;
      if (length < kShortestTrace) return false;
      continue;
    }
    // The direction of the next chord changes as much as that of this one did.
    double square = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      along[i] = gone > 0.0 ? 2.0 * chord[i] - along[i] : chord[i];
      square += along[i] * along[i];
    }
    for (std::size_t i = 0; i < n_; ++i) along[i] /= std::sqrt(square);
    at = next;
    gone += length;
    double away = 0.0, ahead = 0.0, turned = 0.0;
    JointArray start = at;
    for (std::size_t i = 0; i < n_; ++i) {
      const double back = difference(i, at[i], from[i]);
      start[i] += back;
      away += back * back;
      ahead += back * along[i];
      turned += along[i] * first[i];
    }
    if (gone > 2.0 * length && away <= 0.6 * length * length && turned > kBendCosine) {
      if (ahead > 0.0) curve.push_back(at);
      curve.push_back(start);
      return true;
    }
    curve.push_back(at);
    if (slides_away(at)) return false;
    length = std::min(1.5 * length, kTraceStep);
  }
  return false;
}

// The distance of q from a piece of a curve; infinite if it is larger than needed. `share` is the
// position of the nearest point on the piece.
double SelfMotions::distance_to(const JointArray& a, const JointArray& b, const JointArray& q,
                                double& share) const {
  JointArray away{};
  double across = 0.0, square = 0.0;
  for (std::size_t i = 0; i < n_; ++i) {
    away[i] = difference(i, a[i], q[i]);
    if (std::abs(away[i]) > kTraceStep + kCloseToCurve) return INFINITY;
    across += away[i] * (b[i] - a[i]);
    square += (b[i] - a[i]) * (b[i] - a[i]);
  }
  share = square > 0.0 ? std::clamp(across / square, 0.0, 1.0) : 0.0;
  double distance = 0.0;
  for (std::size_t i = 0; i < n_; ++i) {
    const double off = away[i] - share * (b[i] - a[i]);
    distance += off * off;
  }
  return std::sqrt(distance);
}

bool SelfMotions::is_known(const JointArray& q) {
  for (const Curve& curve : curves_) {
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
      double share = 0.0;
      const double distance = distance_to(curve[k], curve[k + 1], q, share);
      if (distance > kCloseToCurve) continue;
      JointArray on_curve{};
      for (std::size_t i = 0; i < n_; ++i)
        on_curve[i] = curve[k][i] + share * (curve[k + 1][i] - curve[k][i]);
      if (!solver_.solve_free(on_curve, kTraceCorrections)) continue;
      double square = 0.0;
      for (std::size_t i = 0; i < n_; ++i) {
        const double off = difference(i, on_curve[i], q[i]);
        square += off * off;
      }
      if (std::sqrt(square) < kOnCurve + kStillAway * distance) return true;
    }
  }
  return false;
}

SelfMotions::Found SelfMotions::follow(const JointArray& q) {
  if (is_known(q)) return Found::kCurve;
  JointDirections idle = idle_directions(robot_, goal_, q, kNearlyIdleTool);
  if (idle.cols() > 1) idle = idle_directions(robot_, goal_, q, kIdleTool);
  if (idle.cols() != 1) return idle.cols() == 0 ? Found::kAlone : Found::kOther;
  JointArray along{}, against{};
  for (std::size_t i = 0; i < n_; ++i) {
    along[i] = idle(static_cast<Eigen::Index>(i), 0);
    against[i] = -along[i];
  }
  Curve onwards, curve;
  if (!walk(q, along, onwards)) {
    walk(q, against, curve);
    std::ranges::reverse(curve);
  }
  curve.push_back(q);
  curve.insert(curve.end(), onwards.begin(), onwards.end());
  if (curve.size() < 3) return Found::kOther;
  curves_.push_back(std::move(curve));
  return Found::kCurve;
}

// The squared manipulability det(J J^T), by elimination, as a distance from singularities.
double SelfMotions::regularity(const JointArray& q) const {
  const Jacobian J = counting_jacobian(robot_, goal_, q);
  double A[6][6];
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c <= r; ++c) A[r][c] = r == c && goal_.weights[r] == 0.0 ? 1.0 : 0.0;
  }
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    const double* column = J.data() + 6 * i;
    for (int r = 0; r < 6; ++r) {
      for (int c = 0; c <= r; ++c) A[r][c] += column[r] * column[c];
    }
  }
  double product = 1.0;
  for (int k = 0; k < 6; ++k) {
    if (!(A[k][k] > 0.0)) return 0.0;
    product *= A[k][k];
    for (int r = k + 1; r < 6; ++r) {
      const double share = A[r][k] / A[k][k];
      for (int c = k + 1; c <= r; ++c) A[r][c] -= share * A[c][k];
    }
  }
  return product;
}

// Along the direction v that moves the tool least, the tool moves by u (sigma s + kappa s^2 / 2):
// the goal is met again, on the other side of the singularity, at s = -2 sigma / kappa.
bool SelfMotions::mirror(const JointArray& q, JointArray& other) {
  const Jacobian J = counting_jacobian(robot_, goal_, q);
  const SymmetricEigen eigen = symmetric_eigen(J * J.transpose());
  Eigen::Index least = 0;
  while (least < 5 && !(eigen.values[least] > kIdleTool * kIdleTool)) ++least;
  const double square = eigen.values[least];
  if (!(square > kIdleTool * kIdleTool)) return false;
  const double sigma = std::sqrt(square);
  const Vector6d u = eigen.vectors.col(least);
  const VectorXd v = J.transpose() * u / sigma;
  JointArray near = q;
  for (std::size_t i = 0; i < n_; ++i) near[i] += kLookAhead * v[static_cast<Eigen::Index>(i)];
  const Jacobian more = counting_jacobian(robot_, goal_, near) - J;
  const double kappa = u.dot(more * v) / kLookAhead;
  const double s = -2.0 * sigma / kappa;
  if (!(std::abs(s) < kFarthestMirror)) return false;
  other = q;
  for (std::size_t i = 0; i < n_; ++i) other[i] += s * v[static_cast<Eigen::Index>(i)];
  return solver_.solve_free(other, kMirrorCorrections);
}

void SelfMotions::follow_neighbours() {
  for (; mirrored_ < curves_.size() && curves_.size() < kMaxCurves; ++mirrored_) {
    std::vector<JointArray> others;
    const Curve& curve = curves_[mirrored_];
    double before = INFINITY, at = regularity(curve[0]);
    for (std::size_t k = 0; k < curve.size(); k += 2) {
      const double after = k + 2 < curve.size() ? regularity(curve[k + 2]) : INFINITY;
      JointArray other{};
      if (at < before && at <= after && mirror(curve[k], other)) others.push_back(other);
      before = at;
      at = after;
    }
    for (const JointArray& other : others) follow(other);
  }
}

bool SelfMotions::bring_nearer(JointArray& q, double& change) {
  bool nearer = false;
  for (; searched_ < curves_.size(); ++searched_) {
    if (search_curve(robot_, goal_, options_, curves_[searched_], q, change)) nearer = true;
  }
  return nearer;
}

}  // namespace armlet
