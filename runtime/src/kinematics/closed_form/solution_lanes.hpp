#pragma once

#include "chain/lane_parts.hpp"
#include "closed_arm.hpp"

// The closed forms of arms with six revolute joints, one solution per lane: where
// the functions of closed_form_families.cpp take a square root with both signs, the lanes have the
// signs. Solutions that do not exist become NaN. Angles stay sines and cosines.
namespace armlet::closed {

// Bounds on squared sines of half the angle between two solutions: where the solutions coincide,
// and how far below zero rounding may take it.
constexpr double kAlike = 1e-10;
constexpr double kBeyond = 1e-5;

using det::root;

// A cosine and sine per lane.
template <class V>
struct Angles {
  V c, s;
  [[gnu::always_inline]] friend Angles operator*(const Angles& a, const Angles& b) {
    return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
  }
};

// Rx(-alpha) Rz(-x) v
template <class V>
[[gnu::always_inline]] inline Parts<V> rotated_back(const Angles<V>& x, const PlainAngle& alpha,
                                                    const Parts<V>& v) {
  const V vy = x.c * v.y - x.s * v.x;
  return {x.c * v.x + x.s * v.y, alpha.c * vy + alpha.s * v.z, alpha.c * v.z - alpha.s * vy};
}

// The state of a kernel for one vector of solutions. The formulas are those of branches.hpp and
// closed_form_families.cpp.
template <class V>
struct SolutionLanes {
  using Bits = det::LaneBits<V>;

  const ClosedArm& arm;
  const double* G;               // ClosedGoal::rows
  V shoulder, elbow, wrist;      // the signs, +1 for the first solution
  Angles<V> x[kSixJoints] = {};  // in the order of the rows
  Bits touching = {};            // solutions that nearly coincide with others

  // Records whether a square, on the scale of 1, is neither clearly positive nor clearly negative.
  [[gnu::always_inline]] void note(V square, double below) {
    touching |= (square >= -below) & (square < kAlike);
  }

  [[gnu::always_inline]] Parts<V> column(unsigned c) const {
    const V none = {};
    return {G[3 * c] - none, G[3 * c + 1] - none, G[3 * c + 2] - none};
  }

  // Two links in a plane that reach (X, Y): joints `first` and the next one.
  [[gnu::always_inline]] void bend(unsigned first, V X, V Y) {
    const V R2 = X * X + Y * Y;
    const V s2 =
        (arm.links.sum2 - R2) * (R2 - arm.links.difference2) * (arm.links.scale * arm.links.scale);
    note(s2, arm.slack);
    const V c = (R2 - 0.5 * (arm.links.sum2 + arm.links.difference2)) * arm.links.scale;
    const V s = elbow * root(s2);
    const V px = arm.links.l + arm.links.m_l * c;
    const V py = arm.links.m_l * s;
    const V one = 1.0 / R2;
    x[first] = {(X * px + Y * py) * one, (Y * px - X * py) * one};
    x[first + 1] = {c * arm.links.m_back.c - s * arm.links.m_back.s,
                    s * arm.links.m_back.c + c * arm.links.m_back.s};
  }

  // The remaining orientation M of a wrist, by columns: returns its first angle and stores those of
  // the last two joints.
  [[gnu::always_inline]] Angles<V> solve_wrist(const Parts<V>* M) {
    const PlainAngle& alpha = arm.alpha[4];
    const PlainAngle& beta = arm.alpha[5];
    const V c = (alpha.c * beta.c - M[2].z) * arm.inverse_ss;
    const V n = M[2].x * M[2].x + M[2].y * M[2].y;
    // At right angles the sine itself is in M: no digits are lost next to the singularity.
    const V s2 = arm.right_wrist ? n : (1.0 - c) * (1.0 + c);
    note(s2, kBeyond);
    note(n, 0.0);
    const V s = wrist * root(s2);
    const V ux = beta.s * s;
    const V uy = -alpha.c * beta.s * c - alpha.s * beta.c;
    const V vx = alpha.s * s;
    const V vy = alpha.s * c * beta.c + alpha.c * beta.s;
    const V one = 1.0 / n;
    x[4] = {c, s};
    x[5] = {(M[0].z * vx + M[1].z * vy) * one, (M[0].z * vy - M[1].z * vx) * one};
    return {(ux * M[2].x + uy * M[2].y) * one, (ux * M[2].y - uy * M[2].x) * one};
  }
};

// The first part, which all solutions share except for its sign: one joint's angle is middle +-
// half.
struct FirstChoice {
  PlainAngle middle, half;
  double x, y, z;      // position to reach, in the frame of its rotation about axis 1
  double one;          // 1 / its squared distance from axis 1
  double along, X, Y;  // (sign * along + X, Y) is the position in the plane of parallel axes
  double sine2;        // squared sine of half the angle between both, negative if there is none

  [[gnu::always_inline]] FirstChoice(const ClosedArm& arm, const double* G) {
    x = G[9] - arm.h[5] * G[6];
    y = G[10] - arm.h[5] * G[7];
    z = G[11] - arm.h[5] * G[8] - arm.h[0];
    const double rho2 = x * x + y * y;
    one = 1.0 / rho2;
    if (arm.family == LaneFamily::kSphericalMeeting)
      from_distance(arm, rho2 + z * z);
    else
      from_height(arm, rho2);
    if (rho2 < 1e-12) sine2 = 0.0;  // on the axis every angle is a solution
  }

  // Whether there clearly are two solutions or clearly none.
  [[gnu::always_inline]] bool exists() const { return sine2 >= kAlike; }
  [[gnu::always_inline]] bool is_missing() const { return sine2 < -kBeyond; }

 private:
  [[gnu::always_inline]] static double root_of(double square) {
    return root(det::Lanes{square, square})[0];
  }

  // Axes 2 and 3 are parallel: joint 1 brings the position to the right height along them.
  [[gnu::always_inline]] void from_height(const ClosedArm& arm, double rho2) {
    const PlainAngle& alpha = arm.alpha[1];
    const double m = (alpha.c * z - arm.height) / alpha.s;
    const double h2 = rho2 - m * m;
    along = root_of(h2);
    middle = {m * y * one, -(m * x * one)};
    half = {along * x * one, along * y * one};
    X = -arm.a[1];
    Y = alpha.c * m + alpha.s * z;
    sine2 = h2 * one;
  }

  // Axes 1 and 2 meet: joint 3 brings the position to the right distance from their common point.
  [[gnu::always_inline]] void from_distance(const ClosedArm& arm, double distance2) {
    const double C = distance2 - arm.meeting.fixed;
    const double r2 = arm.meeting.A * arm.meeting.A + arm.meeting.B * arm.meeting.B;
    const double h2 = r2 - C * C;
    const double h = root_of(h2);
    middle = {arm.meeting.A * C / r2, arm.meeting.B * C / r2};
    half = {-(arm.meeting.B * h) / r2, arm.meeting.A * h / r2};
    sine2 = h2 / r2;
  }
};

template <class V>
[[gnu::always_inline]] inline void spherical_parallel(SolutionLanes<V>& ways,
                                                      const FirstChoice& first) {
  const ClosedArm& arm = ways.arm;
  ways.x[0] = {first.middle.c + ways.shoulder * first.half.c,
               first.middle.s + ways.shoulder * first.half.s};
  ways.bend(1, first.X + ways.shoulder * first.along, first.Y - V{});
  const Angles<V> both = ways.x[1] * ways.x[2];
  Parts<V> M[3];
  for (unsigned c = 0; c < 3; ++c)
    M[c] = rotated_back(both, arm.alpha[3], rotated_back(ways.x[0], arm.alpha[1], ways.column(c)));
  ways.x[3] = ways.solve_wrist(M);
}

template <class V>
[[gnu::always_inline]] inline void three_parallel(SolutionLanes<V>& ways,
                                                  const FirstChoice& first) {
  const ClosedArm& arm = ways.arm;
  ways.x[0] = {first.middle.c + ways.shoulder * first.half.c,
               first.middle.s + ways.shoulder * first.half.s};
  Parts<V> M[3];
  for (unsigned c = 0; c < 3; ++c) M[c] = rotated_back(ways.x[0], arm.alpha[1], ways.column(c));
  const Angles<V> sum = ways.solve_wrist(M);
  const V hand_x = sum.c * arm.point[0] - sum.s * arm.point[1];
  const V hand_y = sum.s * arm.point[0] + sum.c * arm.point[1];
  ways.bend(1, (first.X + ways.shoulder * first.along) - hand_x, first.Y - hand_y);
  const Angles<V> both = ways.x[1] * ways.x[2];
  ways.x[3] = {both.c * sum.c + both.s * sum.s, both.c * sum.s - both.s * sum.c};
}

template <class V>
[[gnu::always_inline]] inline void spherical_meeting(SolutionLanes<V>& ways,
                                                     const FirstChoice& first) {
  const ClosedArm& arm = ways.arm;
  const double* w = arm.point;
  const Angles<V> x3 = {first.middle.c + ways.elbow * first.half.c,
                        first.middle.s + ways.elbow * first.half.s};
  // The position, from the common point in the frame of joint 2.
  const V ty3 = x3.s * w[0] + x3.c * w[1];
  const double tz3 = w[2] + arm.h[2];
  const V tx = x3.c * w[0] - x3.s * w[1] + arm.a[2];
  const V ty = arm.alpha[2].c * ty3 - arm.alpha[2].s * tz3;
  const V tz = arm.alpha[2].s * ty3 + arm.alpha[2].c * tz3 + arm.h[1];
  const V D = (first.z - arm.alpha[1].c * tz) / arm.alpha[1].s;
  const V r2 = tx * tx + ty * ty;
  const V one = 1.0 / r2;
  const V h2 = r2 - D * D;
  ways.note(h2 * one, kBeyond);
  ways.note(r2, 0.0);
  const V h = ways.shoulder * root(h2);
  const Angles<V> x2 = {(ty * D - tx * h) * one, (tx * D + ty * h) * one};
  const V vx = x2.c * tx - x2.s * ty;
  const V vy = arm.alpha[1].c * (x2.s * tx + x2.c * ty) - arm.alpha[1].s * tz;
  ways.x[0] = {(vx * first.x + vy * first.y) * first.one,
               (vx * first.y - vy * first.x) * first.one};
  ways.x[1] = x2;
  ways.x[2] = x3;
  Parts<V> M[3];
  for (unsigned c = 0; c < 3; ++c) {
    M[c] = rotated_back(ways.x[0], arm.alpha[1], ways.column(c));
    M[c] = rotated_back(x3, arm.alpha[3], rotated_back(x2, arm.alpha[2], M[c]));
  }
  ways.x[3] = ways.solve_wrist(M);
}

}  // namespace armlet::closed
