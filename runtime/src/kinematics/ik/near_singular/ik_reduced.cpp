#include "ik_reduced.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/angles.hpp"
#include "armlet/math/decompose.hpp"
#include "kinematics/forward/periodic.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNearlySingular = 5e-3;  // least singular value, m or rad per rad or m
// remaining error, m and rad, up to which curves are followed
constexpr double kShallow = 2e-3;
constexpr double kPiece = 0.1;           // rad or m
constexpr double kShortestPiece = 1e-3;  // rad or m
constexpr int kMostPieces = 300;         // of a curve, in one direction
// in one direction: after them the goal counts as met along the whole curve
constexpr int kIdlePieces = 2;
constexpr double kAhead = 0.9;       // cosine between the directions at both ends of a piece
constexpr double kLookAhead = 1e-4;  // rad or m, for the curvature
// rad or m; solutions no farther from their middle count as one
constexpr double kOne = 5e-7;
constexpr double kRounding = 2e-15;       // m and rad, of a height
constexpr double kSlopeRounding = 1e-12;  // per rad or m
constexpr double kMet = 1e-11;            // m and rad
constexpr double kSettled = 1e-11;        // rad or m
constexpr double kFarthestStep = 0.2;     // rad or m
constexpr int kCorrections = 12;

// A point of the curve, at the length s from the beginning of its piece.
//
// height  the remaining error there.
// slope   derivative of the height by s.
struct Point {
  double s = 0.0;
  VectorXd q{};
  double height = 0.0;
  double slope = 0.0;
};

class ReducedSearch {
 public:
  ReducedSearch(const Robot& robot, const IkGoal& goal, const JointArray& q)
      : robot_(robot), solver_(robot, goal), n_(robot.n()), origin_(to_vector(q, robot.n())) {
    for (Eigen::Index row = 0; row < 6; ++row) {
      if (goal.weights[row] != 0.0) rows_.push_back(row);
    }
  }

  [[nodiscard]] std::optional<ReducedCurve> run() {
    const SvdParts parts = singular_values(linear_at(origin_).J);
    if (!(parts.s[n_ - 1] < kNearlySingular)) return std::nullopt;
    const VectorXd start = origin_, lost = parts.U.col(n_ - 1), idle = parts.V.col(n_ - 1);
    lost_ = lost;
    idle_ = idle;
    Point left, right;
    double half = 0.5 * kPiece;
    do {
      left.q = right.q = origin_;
      if (half < kShortestPiece) return std::nullopt;
      half *= 0.5;
    } while (!reaches(-2.0 * half, left) || !reaches(2.0 * half, right));
    search(left, right);
    keep(start);
    if (walk(right, start)) return std::move(curve_);
    std::ranges::reverse(curve_.points);
    origin_ = start;
    lost_ = lost;
    idle_ = -idle;
    left.s = -left.s;
    walk(left, start);
    return std::move(curve_);
  }

 private:
  struct Linear {
    VectorXd error;
    MatrixXd J;
  };

  [[nodiscard]] Linear linear_at(const VectorXd& q) {
    const IkRows all = solver_.rows_of(to_array(q));
    Linear linear{VectorXd(n_), MatrixXd(n_, n_)};
    for (Eigen::Index r = 0; r < n_; ++r) {
      linear.error[r] = all.error[rows_[static_cast<std::size_t>(r)]];
      linear.J.row(r) = all.J.row(rows_[static_cast<std::size_t>(r)]);
    }
    return linear;
  }

  // J with the lost direction of the tool as an additional column, and the joint direction that it
  // belongs to as an additional row: regular also where J is not.
  [[nodiscard]] MatrixXd bordered(const MatrixXd& J) const {
    MatrixXd B = MatrixXd::Zero(n_ + 1, n_ + 1);
    B.topLeftCorner(n_, n_) = J;
    B.topRightCorner(n_, 1) = lost_;
    B.bottomLeftCorner(1, n_) = idle_.transpose();
    return B;
  }

  // Newton's method for the point at s, from point.q.
  [[nodiscard]] bool settle(double s, Point& point) {
    point.s = s;
    VectorXd wanted(n_ + 1);
    for (int k = 0; k < kCorrections; ++k) {
      const Linear linear = linear_at(point.q);
      wanted.head(n_) = linear.error;
      wanted[n_] = s - idle_.dot(point.q - origin_);
      const SquareFactors factors(bordered(linear.J));
      const VectorXd change = factors.solve(wanted);
      const double size = change.head(n_).cwiseAbs().maxCoeff();
      if (!(size < kFarthestStep)) return false;
      point.q += change.head(n_);
      point.height = change[n_];
      if (size >= kSettled) continue;
      wanted.setZero();
      wanted[n_] = 1.0;
      point.slope = factors.solve(wanted)[n_];
      return std::isfinite(point.slope);
    }
    return false;
  }

  // Newton's method for the point at s; false if the curve bends away from its direction, or if
  // another curve was reached.
  [[nodiscard]] bool reaches(double s, Point& point) {
    return settle(s, point) && (point.q - origin_).norm() * kAhead <= std::abs(s);
  }

  // The zero of the height or the slope between two points.
  //
  // source  M. Dowell, P. Jarratt, A modified regula falsi method for computing the root of an
  //         equation, BIT 11, 1971 (the Illinois method).
  [[nodiscard]] std::optional<Point> zero_of(double Point::*value, const Point& from,
                                             const Point& to) {
    constexpr int kSteps = 60;
    double a = from.s, f_a = from.*value, b = to.s, f_b = to.*value;
    Point at = from;
    for (int k = 0; k < kSteps; ++k) {
      const double s = b - f_b * (b - a) / (f_b - f_a);
      if (!settle(s, at)) return std::nullopt;
      const double f = at.*value;
      if (f == 0.0 || std::abs(s - b) < kSettled) break;
      if (f * f_b < 0.0) {
        a = b;
        f_a = f_b;
      } else {
        f_a *= 0.5;
      }
      b = s;
      f_b = f;
    }
    return at;
  }

  void keep(const VectorXd& q) { curve_.points.push_back(to_array(q)); }

  void take(const std::optional<Point>& zero) {
    if (!zero) return;
    const JointArray q = to_array(zero->q);
    const IkError error = solver_.error_of(q);
    if (error.position < kMet && error.rotation < kMet) curve_.solutions.push_back(q);
  }

  // Whether the goal is met all along the curve.
  static bool is_idle(const Point& point) {
    return std::abs(point.height) + kPiece * std::abs(point.slope) < kMet;
  }

  // Adds the points between two others at which the slope changes its sign, in their order; if the
  // height is not near zero in a piece, any point of the piece will do. A piece is halved until the
  // slope is monotone in it, or is nowhere near zero.
  void add_turns(const Point& left, const Point& right, std::vector<Point>& turns) {
    Point middle = left;
    middle.q = 0.5 * (left.q + right.q);
    if (!settle(0.5 * (left.s + right.s), middle)) return;
    const double half = middle.s - left.s;
    const auto [least, most] =
        std::minmax({std::abs(left.slope), std::abs(middle.slope), std::abs(right.slope)});
    if (std::min({std::abs(left.height), std::abs(middle.height), std::abs(right.height)}) >
        2.0 * half * most) {
      turns.push_back(middle);
      return;
    }
    const double bend = middle.slope - left.slope, next_bend = right.slope - middle.slope;
    const double swerve = std::abs(next_bend - bend);
    const bool turns_back = left.slope * right.slope <= 0.0;
    const bool same_way =
        bend * next_bend > 0.0 && swerve < 0.5 * std::max(std::abs(bend), std::abs(next_bend));
    if (!turns_back && middle.slope * left.slope > 0.0 && least > swerve) return;
    if (same_way || swerve < kSlopeRounding || half < kLookAhead) {
      if (!turns_back) return;
      if (const auto turn = zero_of(&Point::slope, left, right)) turns.push_back(*turn);
      return;
    }
    add_turns(left, middle, turns);
    add_turns(middle, right, turns);
  }

  // Whether the zeros on both sides of an extremum are one double zero.
  bool is_double(const Point& turn) {
    Point ahead = turn;
    if (std::abs(turn.height) > kMet) return false;
    if (!settle(turn.s + kLookAhead, ahead)) return false;
    const double bend = (ahead.slope - turn.slope) / kLookAhead;
    return std::abs(2.0 * turn.height / bend) <= kOne * kOne;
  }

  // The zeros of the height between two points; there is at most one between two extrema.
  void search(const Point& left, const Point& right) {
    if (is_idle(left) && is_idle(right)) return;
    curve_.is_idle = false;
    std::vector<Point> turns;
    add_turns(left, right, turns);
    Point last = left;
    bool was_double = false;
    for (const Point& turn : turns) {
      const bool now_double = is_double(turn);
      if (!was_double && !now_double) cross(last, turn);
      if (now_double || std::abs(turn.height) < kRounding)
        curve_.solutions.push_back(to_array(turn.q));
      last = turn;
      was_double = now_double;
    }
    if (!was_double) cross(last, right);
  }

  void cross(const Point& left, const Point& right) {
    if (left.height * right.height <= 0.0) take(zero_of(&Point::height, left, right));
  }

  // Updates both directions at a point of the curve, with the orientation kept.
  void turn_to(const Point& point) {
    const MatrixXd B = bordered(linear_at(point.q).J);
    VectorXd one = VectorXd::Zero(n_ + 1);
    one[n_] = 1.0;
    idle_ = SquareFactors(B).solve(one).head(n_).normalized();
    lost_ = SquareFactors(B.transpose()).solve(one).head(n_).normalized();
    origin_ = point.q;
  }

  [[nodiscard]] bool comes_back(const VectorXd& from, const VectorXd& to,
                                const VectorXd& start) const {
    double along = 0.0, square = 0.0, length = 0.0;
    for (int i = 0; i < robot_.n(); ++i) {
      const double back = start[i] - from[i];
      const double away = is_periodic(robot_, i) ? wrap_angle(back) : back;
      along += away * (to[i] - from[i]);
      square += away * away;
      length += (to[i] - from[i]) * (to[i] - from[i]);
    }
    const double off = std::sqrt(std::max(square - along * along / length, 0.0));
    return along >= 0.0 && along <= length && off < 0.1 * kPiece;
  }

  // Follows the curve from a point. Returns whether it is closed.
  bool walk(Point point, const VectorXd& start) {
    double length = kPiece;
    for (int k = 0; k < kMostPieces && std::abs(point.height) < kShallow; ++k) {
      turn_to(point);
      if (!idle_.allFinite() || !lost_.allFinite()) return false;
      Point left{.q = point.q};
      if (!settle(0.0, left)) return false;
      Point right = left;
      while (!reaches(length, right)) {
        length *= 0.5;
        right = left;
        if (length < kShortestPiece) return false;
      }
      search(left, right);
      keep(right.q);
      if (curve_.is_idle && k >= kIdlePieces) return true;
      if (k > 1 && comes_back(left.q, right.q, start)) return true;
      point = right;
      length = std::min(kPiece, 1.5 * length);
    }
    return false;
  }

  const Robot& robot_;
  IkSolver solver_;
  Eigen::Index n_;
  std::vector<Eigen::Index> rows_;
  // The origin of the current piece, and the two directions there.
  VectorXd origin_;
  VectorXd lost_;  // direction of the tool
  VectorXd idle_;  // direction of the joints
  ReducedCurve curve_;
};

}  // namespace

std::optional<ReducedCurve> reduced_curve(const Robot& robot, const IkGoal& goal,
                                          const JointArray& q) {
  return ReducedSearch(robot, goal, q).run();
}

}  // namespace armlet
