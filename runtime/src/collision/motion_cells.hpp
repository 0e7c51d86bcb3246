// The motions of all joints of a scene as polynomials between common knots.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "armlet/collision/motion_check.hpp"

namespace armlet {

// A polynomial over an interval of time as Bernstein coefficients: their minimum and maximum are
// bounds of its values.
//
// source  G. Farin, Curves and Surfaces for CAGD, 2002, chapter 5.
struct JointCurve {
  std::array<double, Segment::kMaxDegree + 1> b{};
  int degree = 0;

  struct Range {
    double lower, upper;
  };
  [[nodiscard]] Range range() const;
  // Divides it into halves; this one becomes the first. Returns the value between them.
  double halve(JointCurve& second);
};

class MotionCells {
 public:
  explicit MotionCells(const MotionScene& scene);

  [[nodiscard]] int count() const { return static_cast<int>(times_.size()) - 1; }
  [[nodiscard]] int joints() const { return joints_; }
  [[nodiscard]] double start(int cell) const { return times_[static_cast<std::size_t>(cell)]; }
  // One for each joint, arm by arm.
  [[nodiscard]] std::span<const JointCurve> curves(int cell) const {
    const auto n = static_cast<std::size_t>(joints_);
    return std::span(curves_).subspan(static_cast<std::size_t>(cell) * n, n);
  }

 private:
  int joints_ = 0;
  std::vector<double> times_;
  std::vector<JointCurve> curves_;
};

}  // namespace armlet
