// Real roots of a polynomial piece, for exact extremes of position, speed and acceleration.
#pragma once

#include <array>
#include <cstddef>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Times in one piece, ascending; a polynomial has at most as many roots as its degree.
class Roots {
 public:
  void push_back(double u) { u_[count_++] = u; }
  [[nodiscard]] const double* begin() const { return u_.data(); }
  [[nodiscard]] const double* end() const { return u_.data() + count_; }

 private:
  std::array<double, Segment::kMaxDegree> u_{};
  std::size_t count_ = 0;
};

// Times u in [0, piece.duration], ascending, where the derivative of the given order changes sign.
Roots sign_changes(const Segment& piece, int order);

}  // namespace armlet
