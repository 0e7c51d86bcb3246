#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "armlet/kinematics/closed_form.hpp"
#include "canonical_rows.hpp"

namespace armlet {

// The parts from which the closed forms are composed. Angles are kept as sine and cosine; no
// inverse function is called before a branch is complete.

// Bits for the solution that each part of the arm uses (ClosedSolution::branch).
inline constexpr int kShoulderBit = 4;
inline constexpr int kElbowBit = 2;
inline constexpr int kWristBit = 1;

// One configuration: an angle or a height per joint, in the notation of CanonicalRows.
struct Branch {
  std::array<Angle, kMaxJoints> phi{};
  std::array<double, kMaxJoints> height{};
  int bits = 0;  // sum of the bits above
};

struct Branches {
  std::array<Branch, kMaxBranches> at;
  int count = 0;
  bool free = false;  // a joint may have any value, or nearly so
  // bits of the joints that keep their value because the goal does not determine it
  unsigned open = 0;
  double arm_angle_change = 0.0;  // of an arm of seven joints, added to its arm angle

  Branch& add(const Branch& b) {
    return at[static_cast<std::size_t>(count < kMaxBranches ? count++ : count - 1)] = b;
  }
  void leave_open(unsigned joint, bool is_open = true) {
    if (is_open) open |= 1U << joint;
  }
};

// Amount by which a sine or a length may exceed its bound by rounding. Branches are verified
// afterwards, so it may be generous.
inline constexpr double kClosedSlack = 1e-6;

// Angles x with A cos x + B sin x = C: two, one (twice the same), or none. count is -1 if every
// angle satisfies it.
//
// source  J. J. Craig, Introduction to Robotics, 2005, appendix C.
struct AnglePair {
  int count = 0;
  std::array<Angle, 2> x{};
};
inline AnglePair circle_meets_plane(double A, double B, double C) {
  AnglePair out;
  const double r2 = A * A + B * B;
  const double r = std::sqrt(r2);
  const double size = r + std::abs(C);
  if (r <= 1e-12) {
    out.count = std::abs(C) <= 1e-12 ? -1 : 0;
    return out;
  }
  double h2 = (r - C) * (r + C);
  if (h2 < 0.0) {
    if (std::abs(C) - r > kClosedSlack * size) return out;
    h2 = 0.0;
    C = C > 0.0 ? r : -r;
  }
  const double h = std::sqrt(h2);
  out.count = h2 == 0.0 ? 1 : 2;
  out.x[0] = {(A * C - B * h) / r2, (B * C + A * h) / r2};
  out.x[1] = {(A * C + B * h) / r2, (B * C - A * h) / r2};
  return out;
}

// The rotation that maps the direction (x, y) to the direction (u, v); whole is false if one of
// them has length zero.
inline Angle angle_from_to(double x, double y, double u, double v, bool& whole) {
  const double c = x * u + y * v;
  const double s = x * v - y * u;
  const double r = std::sqrt(c * c + s * s);
  whole = r > 1e-24;
  return whole ? Angle{c / r, s / r} : Angle{};
}

// The angles, or the present one if every angle is a solution; then free becomes true.
inline AnglePair or_present(const AnglePair& turns, const Angle& present, bool& free) {
  if (turns.count >= 0) return turns;
  free = true;
  return {1, {present, present}};
}

// A shorter line, m, has no direction; a point nearer to an axis counts as on it.
inline constexpr double kNoLength = 1e-9;

// Nearer than this, m, to a position where an angle is free, the angle is known so inexactly that a
// closed form without a result does not prove that there is no solution.
inline constexpr double kNearAxis = 1e-6;

// Two links in a plane: Rz(x1) [ l + Rz(x2) m ] = (X, Y). Returns both elbows. An arm that is
// folded back onto the first axis may rotate about it by any angle (free), and a link of length
// zero about its own end: for these angles the given values are used.
//
// source  the law of cosines: B. Siciliano et al., Robotics, 2009, section 2.12.1 (three links in a
//         plane).
struct Elbow {
  int count = 0;
  bool free = false;
  bool open1 = false, open2 = false;  // x1 or x2 is the given value
  std::array<Angle, 2> x1{}, x2{};
};
struct Links {
  double lx, ly, mx, my;
};
Elbow solve_elbow(const Links& links, double X, double Y, const Angle& x1_if_free,
                  const Angle& x2_if_free);

// Rz(x1) Rx(alpha) Rz(x2) Rx(beta) Rz(x3) = M: both solutions. Where x1 and x3 rotate about one
// line, x1 is the given value.
//
// source  Siciliano et al. 2009, section 2.12.5 (spherical wrist), here with any link twists.
struct Euler {
  int count = 0;
  bool singular = false;
  bool open = false;  // x1 is the given value
  std::array<Angle, 2> x1{}, x2{}, x3{};
};
Euler solve_euler(const Eigen::Matrix3d& M, const Angle& alpha, const Angle& beta,
                  const Angle& x1_if_free);

// Returns Rx(-alpha) Rz(-x) M.
Eigen::Matrix3d rotated_back(const Angle& x, const Angle& alpha, const Eigen::Matrix3d& M);
Eigen::Vector3d rotated_back(const Angle& x, const Angle& alpha, const Eigen::Vector3d& v);

}  // namespace armlet
