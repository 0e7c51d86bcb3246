#include "ik_free.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/angles.hpp"
#include "ik_minimax.hpp"
#include "kinematics/forward/periodic.hpp"
#include "kinematics/self_motion/self_motion.hpp"

namespace armlet {
namespace {

// Columns of the Jacobian that differ by less, m and rad, belong to one axis; results are checked
// by forward kinematics.
constexpr double kOneLine = 1e-6;
constexpr double kRounding = 1e-7;  // rad or m, allowed excess of a limit
constexpr double kBeyond = 1e-5;    // the same, for a solution that is discarded anyway

struct Range {
  double lower = -INFINITY;
  double upper = INFINITY;
};

Range range_of(const Robot& robot, const IkOptions& options, std::size_t i) {
  if (!options.respect_limits) return {};
  const Eigen::Index k = static_cast<Eigen::Index>(i);
  return {robot.lower()[k], robot.upper()[k]};
}

// A joint that shares an angle, in the sum: the value nearest to the seed, its change from the
// seed, and the room from there.
struct Member {
  std::size_t joint = 0;
  double sign = 1.0;
  double nearest = 0.0;
  double away = 0.0;
  double up = 0.0, down = 0.0;
};

struct Members {
  std::array<Member, kMaxJoints> at;
  std::size_t count = 0;

  const Member* begin() const { return at.data(); }
  const Member* end() const { return at.data() + count; }
};

// The smallest largest change with which the joints together make up `delta`, starting from their
// nearest values; the rest that they cannot make up is returned too.
struct Division {
  double change = 0.0;
  double left_over = 0.0;
};

double room(const Member& m, double delta) { return m.sign * delta > 0.0 ? m.up : m.down; }

// The part of one joint if no joint may change by more.
double part(const Member& m, double delta, double change) {
  return std::clamp(change - m.away, 0.0, room(m, delta));
}

double sum_of_parts(const Members& members, double delta, double change) {
  double sum = 0.0;
  for (const Member& m : members) sum += part(m, delta, change);
  return sum;
}

// The sum of the parts is piecewise linear and monotone in the change.
Division divide(const Members& members, double delta) {
  const double wanted = std::abs(delta);
  Division out;
  std::array<double, 2 * kMaxJoints> knots{};
  std::size_t count = 0;
  double all = 0.0;
  for (const Member& m : members) {
    const double most = room(m, delta);
    all += most;
    knots[count++] = m.away;
    if (std::isfinite(most)) knots[count++] = m.away + most;
  }
  std::ranges::sort(std::span(knots).first(count));
  if (all < wanted) {
    out.left_over = wanted - all;
    out.change = knots[count - 1];
    return out;
  }
  double low = 0.0, sum_low = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double sum = sum_of_parts(members, delta, knots[k]);
    if (sum >= wanted) {
      const double slope = knots[k] > low ? (sum - sum_low) / (knots[k] - low) : 0.0;
      out.change = slope > 0.0 ? low + (wanted - sum_low) / slope : knots[k];
      return out;
    }
    low = knots[k];
    sum_low = sum;
  }
  // Beyond the last knot, joints without limits continue with the same slope.
  const double slope = sum_of_parts(members, delta, low + 1.0) - sum_low;
  out.change = low + (wanted - sum_low) / slope;
  return out;
}

// Divides the shared value, which counts modulo a period (0: it does not).
double settle(Members& members, const Robot& robot, const IkOptions& options, double period,
              JointArray& q) {
  double excess = 0.0, away = 0.0;
  for (std::size_t k = 0; k < members.count; ++k) {
    Member& m = members.at[k];
    const Range range = range_of(robot, options, m.joint);
    const double seed = options.seed[static_cast<Eigen::Index>(m.joint)];
    m.nearest = std::clamp(seed, range.lower, range.upper);
    m.away = std::abs(m.nearest - seed);
    m.up = range.upper - m.nearest;
    m.down = m.nearest - range.lower;
    excess += m.sign * (q[m.joint] - m.nearest);
    away = std::max(away, m.away);
  }
  double delta = excess;
  Division best;
  if (period > 0.0) {
    const double first = excess - period * std::floor(excess / period);  // 0 or more
    const Division up = divide(members, first);
    const Division down = divide(members, first - period);
    const auto key = [away](const Division& d) {
      return std::pair(d.left_over > kRounding ? d.left_over : 0.0, std::max(d.change, away));
    };
    const bool upwards = key(up) <= key(down);
    delta = upwards ? first : first - period;
    best = upwards ? up : down;
  } else {
    best = divide(members, delta);
  }
  for (const Member& m : members) {
    const double more = part(m, delta, best.change);
    q[m.joint] = m.nearest + (m.sign * delta > 0.0 ? more : -more);
  }
  return best.left_over;
}

// Sets of joints that move the tool in the same direction. The first of each set represents it.
class Shares {
 public:
  Shares(const Robot& robot, const IkGoal& goal, const JointArray& q)
      : robot_(robot), n_(static_cast<std::size_t>(robot.n())) {
    J_ = jacobian(robot, Eigen::Map<const Eigen::VectorXd>(q.data(), robot.n()));
    position_only_ = goal.weights.tail<3>().isZero();
  }

  // The joints with the same axis as joint i, itself first; marks them as used.
  Members with(std::size_t i) {
    Members out;
    if (taken_[i]) return out;
    const auto column = [this](std::size_t k) { return J_.col(static_cast<Eigen::Index>(k)); };
    for (std::size_t k = i; k < n_; ++k) {
      if (taken_[k] || turns(k) != turns(i)) continue;
      const double plus = (column(k) - column(i)).cwiseAbs().maxCoeff();
      const double minus = (column(k) + column(i)).cwiseAbs().maxCoeff();
      if (std::min(plus, minus) > kOneLine) continue;
      out.at[out.count].joint = k;
      out.at[out.count++].sign = plus < minus ? 1.0 : -1.0;
      taken_[k] = true;
    }
    return out;
  }
  // Whether joint i rotates about the tool point, and the orientation is free.
  bool alone(std::size_t i) const {
    return position_only_ &&
           J_.col(static_cast<Eigen::Index>(i)).head<3>().cwiseAbs().maxCoeff() <= kOneLine;
  }
  bool turns(std::size_t i) const { return is_periodic(robot_, static_cast<int>(i)); }

 private:
  const Robot& robot_;
  std::size_t n_;
  Jacobian J_;
  bool position_only_ = false;
  std::array<bool, kMaxJoints> taken_{};
};

double bring_one(const Robot& robot, const IkOptions& options, std::size_t i, double& value) {
  const Range range = range_of(robot, options, i);
  const double near = options.seed[static_cast<Eigen::Index>(i)];
  if (std::abs(value - near) <= kPi && value >= range.lower && value <= range.upper) return 0.0;
  if (is_periodic(robot, static_cast<int>(i))) {
    if (options.respect_limits)
      value = wrapped_within(value, near, range.lower - 1e-6, range.upper + 1e-6);
    else if (std::abs(value - near) > kPi)
      value = nearest_copy_of_angle(value, near);
  }
  return std::max({range.lower - value, value - range.upper, 0.0});
}

}  // namespace

double change_of(const JointArray& q, const Eigen::VectorXd& seed) {
  double change = 0.0;
  for (Eigen::Index i = 0; i < seed.size(); ++i)
    change = std::max(change, std::abs(q[static_cast<std::size_t>(i)] - seed[i]));
  return change;
}

double change_within(const Robot& robot, const IkOptions& options, std::size_t i, double low,
                     double high) {
  const double seed = options.seed[static_cast<Eigen::Index>(i)];
  const Range range = range_of(robot, options, i);
  const bool turns = is_periodic(robot, static_cast<int>(i));
  const double first = turns ? std::round((seed - 0.5 * (low + high)) / (2.0 * kPi)) : 0.0;
  const int copies = turns ? 3 : 0;
  double least = INFINITY;
  for (int copy = -copies; copy <= copies; ++copy) {
    const double shift = (first + copy) * (2.0 * kPi);
    const double from = std::max(low + shift, range.lower - kLimitSlack);
    const double to = std::min(high + shift, range.upper + kLimitSlack);
    if (from <= to) least = std::min(least, std::max({from - seed, seed - to, 0.0}));
  }
  return least;
}

double bring_near(const Robot& robot, const IkGoal& goal, const IkOptions& options, bool shares,
                  JointArray& q) {
  double beyond = 0.0;
  const std::size_t n = static_cast<std::size_t>(robot.n());
  if (!shares) {
    for (std::size_t i = 0; i < n && beyond <= kBeyond; ++i)
      beyond = std::max(beyond, bring_one(robot, options, i, q[i]));
    return beyond;
  }
  Shares alike(robot, goal, q);
  for (std::size_t i = 0; i < n; ++i) {
    Members members = alike.with(i);
    if (members.count == 0) continue;
    if (alike.alone(i)) {
      for (const Member& m : members) {
        const Range range = range_of(robot, options, m.joint);
        q[m.joint] =
            std::clamp(options.seed[static_cast<Eigen::Index>(m.joint)], range.lower, range.upper);
      }
    } else if (members.count == 1) {
      beyond = std::max(beyond, bring_one(robot, options, i, q[i]));
    } else {
      beyond =
          std::max(beyond, settle(members, robot, options, alike.turns(i) ? 2.0 * kPi : 0.0, q));
    }
  }
  return beyond;
}

namespace {

constexpr double kFirstSlide = 0.3;   // rad or m
constexpr double kLastSlide = 1e-8;   // and the smallest progress
constexpr double kNoSlide = 1e-10;    // rad or m; smallest gain for which a motion is tried
constexpr double kWorthwhile = 1e-3;  // rad or m
constexpr int kSlides = 60;
constexpr int kCorrections = 8;

using Eigen::VectorXd;
// The change of a joint along a direction, and its negative: a + t b.
struct Line {
  double a = 0.0, b = 0.0;
};

// The distance along a direction, at most `most` to either side, that minimises the largest change:
// the lowest point of the lines' upper envelope, which is followed from its left end.
class Descent {
 public:
  Descent(const Robot& robot, const IkOptions& options, const JointArray& q, const VectorXd& v,
          double most) {
    double low = -most, high = most;
    const auto n = static_cast<std::size_t>(robot.n());
    for (std::size_t i = 0; i < n; ++i) {
      const Range range = range_of(robot, options, i);
      const double vi = v[static_cast<Eigen::Index>(i)];
      const double away = q[i] - options.seed[static_cast<Eigen::Index>(i)];
      lines_[count_++] = {away, vi};
      lines_[count_++] = {-away, -vi};
      if (std::abs(vi) < 1e-12) continue;
      const double to_lower = (range.lower - q[i]) / vi;
      const double to_upper = (range.upper - q[i]) / vi;
      low = std::max(low, std::min(to_lower, to_upper));
      high = std::min(high, std::max(to_lower, to_upper));
    }
    if (!(low <= 0.0 && high >= 0.0)) return;
    length_ = lowest(low, high);
    promise_ = change_at(0.0) - change_at(length_);
  }

  double length() const { return length_; }
  double promise() const { return promise_; }

 private:
  double change_at(double t) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < count_; ++k)
      largest = std::max(largest, lines_[k].a + t * lines_[k].b);
    return largest;
  }

  double lowest(double low, double high) const {
    const double at_low = change_at(low);
    Line top{0.0, -INFINITY};
    for (std::size_t k = 0; k < count_; ++k) {
      if (lines_[k].a + low * lines_[k].b >= at_low - 1e-15 && lines_[k].b > top.b) top = lines_[k];
    }
    double t = low;
    while (top.b < 0.0) {
      double next = high;
      Line steeper{0.0, 0.0};
      for (std::size_t k = 0; k < count_; ++k) {
        if (!(lines_[k].b > top.b)) continue;
        const double crossing = (top.a - lines_[k].a) / (lines_[k].b - top.b);
        if (crossing > next || (crossing == next && lines_[k].b <= steeper.b)) continue;
        next = std::max(crossing, t);
        steeper = lines_[k];
      }
      t = next;
      if (t >= high) return high;
      top = steeper;
    }
    return t;
  }

  std::array<Line, 2 * kMaxJoints> lines_{};
  std::size_t count_ = 0;
  double length_ = 0.0, promise_ = 0.0;
};

}  // namespace

bool slide_nearer(const Robot& robot, const IkGoal& goal, const IkOptions& options, JointArray& q,
                  double singular) {
  IkSolver solver(robot, goal);
  bool several = false;
  double change = change_of(q, options.seed);
  double most = kFirstSlide;
  for (int slide = 0; slide < kSlides && most > kLastSlide; ++slide) {
    const JointDirections idle = idle_directions(robot, goal, q, singular);
    several = several || idle.cols() > 1;
    if (idle.cols() > 1 && idle.cols() <= kMostIdle) {
      slide_minimax(robot, goal, options, q, singular);
      return true;
    }
    bool nearer = false, promising = false;
    // First in the direction of the seed, then each direction by itself.
    for (Eigen::Index k = idle.cols() == 1 ? 1 : 0; k <= idle.cols() && !nearer; ++k) {
      VectorXd v;
      if (k == 0)
        v = idle * (idle.transpose() *
                    (options.seed - Eigen::Map<const Eigen::VectorXd>(q.data(), robot.n())));
      else
        v = idle.col(k - 1);
      const double size = v.norm();
      if (!(size > 1e-12)) continue;
      v /= size;
      const Descent descent(robot, options, q, v, most);
      if (!(descent.promise() > kNoSlide)) continue;
      promising = true;
      JointArray next = q;
      for (Eigen::Index i = 0; i < v.size(); ++i)
        next[static_cast<std::size_t>(i)] += descent.length() * v[i];
      const bool met = options.respect_limits ? solver.solve_in_box(next, kCorrections)
                                              : solver.solve_free(next, kCorrections);
      if (!met || !goal.is_met(solver.error_of(next))) continue;
      const double shorter = change_of(next, options.seed);
      if (shorter >= change - kNoSlide) continue;
      // With several free directions the path is long and has no exact end.
      nearer = idle.cols() == 1 || shorter < change - kWorthwhile;
      change = shorter;
      q = next;
    }
    if (!promising || (!nearer && idle.cols() > 1)) break;
    most = nearer ? std::min(2.0 * most, kFirstSlide) : 0.5 * most;
  }
  return several;
}

}  // namespace armlet
