#include "collision/motion_cells.hpp"

#include <algorithm>

namespace armlet {
namespace {

constexpr double kSameTime = 1e-9;  // s, one tick of the clock

std::vector<double> common_knots(const MotionScene& scene) {
  std::vector<double> all = {0.0};
  for (const ArmInMotion& arm : scene.arms) {
    for (const double knot : arm.motion->knots()) {
      const double t = knot - arm.from;
      if (t > 0.0 && t < scene.duration) all.push_back(t);
    }
  }
  std::ranges::sort(all);
  std::vector<double> distinct;
  for (const double t : all) {
    if (distinct.empty() || t - distinct.back() > kSameTime) distinct.push_back(t);
  }
  if (distinct.size() > 1 && scene.duration - distinct.back() <= kSameTime) distinct.pop_back();
  distinct.push_back(scene.duration);
  return distinct;
}

// The polynomial of a joint from t0 to t1 of its motion, between knots.
JointCurve curve_between(const JointPath& path, double t0, double t1) {
  JointCurve curve;
  curve.b[0] = path.q_end;
  const double middle = 0.5 * (t0 + t1);
  if (path.segments.empty() || middle >= path.segments.back().end()) return curve;
  const auto behind = std::ranges::upper_bound(path.segments, middle, {}, &Segment::start);
  const Segment& piece = behind == path.segments.begin() ? *behind : *(behind - 1);
  const int m = piece.degree;
  curve.degree = m;
  double scale = 1.0;     // (t1 - t0)^k / k!
  double binomial = 1.0;  // m over k
  for (int k = 0; k <= m; ++k) {
    curve.b[static_cast<std::size_t>(k)] = scale * piece.value(t0 - piece.start, k) / binomial;
    scale *= (t1 - t0) / (k + 1);
    binomial = binomial * (m - k) / (k + 1);
  }
  // m rounds of sums of neighbours convert the scaled powers into Bernstein coefficients.
  for (int round = 1; round <= m; ++round) {
    for (int k = m; k >= round; --k)
      curve.b[static_cast<std::size_t>(k)] += curve.b[static_cast<std::size_t>(k - 1)];
  }
  return curve;
}

}  // namespace

JointCurve::Range JointCurve::range() const {
  const auto [lower, upper] = std::minmax_element(b.begin(), b.begin() + degree + 1);
  return {*lower, *upper};
}

double JointCurve::halve(JointCurve& second) {
  second = *this;
  for (int round = 1; round <= degree; ++round) {
    // The last value of each round of de Casteljau's scheme belongs to the first half.
    for (int k = 0; k <= degree - round; ++k) {
      const auto at = static_cast<std::size_t>(k);
      second.b[at] = 0.5 * (second.b[at] + second.b[at + 1]);
    }
    b[static_cast<std::size_t>(round)] = second.b[0];
  }
  return second.b[0];
}

MotionCells::MotionCells(const MotionScene& scene) : times_(common_knots(scene)) {
  for (const ArmInMotion& arm : scene.arms) joints_ += arm.robot->n();
  curves_.reserve(static_cast<std::size_t>(joints_ * count()));
  for (int cell = 0; cell < count(); ++cell) {
    for (const ArmInMotion& arm : scene.arms) {
      for (int i = 0; i < arm.robot->n(); ++i) {
        curves_.push_back(curve_between(arm.motion->joint(i), arm.from + start(cell),
                                        arm.from + start(cell + 1)));
      }
    }
  }
}

}  // namespace armlet
