#include "one_to_four_joints.hpp"

#include <vector>

#include "armlet/math/polynomial.hpp"
#include "armlet/math/real_roots.hpp"
#include "closed_form_families.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Relative to the size of an equation: rounding may have removed a double root.
constexpr double kNearTouching = 1e-7;
constexpr double kVanishes = 1e-12;

Vector3d lifted(const Vector3d& v, double h) { return {v.x(), v.y(), v.z() + h}; }

// Whether a point lies on the z axis.
bool on_axis(const Vector3d& w) { return w.head<2>().norm() < kNoLength; }
bool near_axis(const Vector3d& w) { return w.head<2>().norm() < kNearAxis; }

// Whether axes 1, 2 and 3 meet in a point.
bool meet_in_a_point(const CanonicalRows& rows) {
  return rows.meet(1) && rows.meet(2) && rows.h[1] == 0.0;
}

// Solutions are numbered in the order in which they are found.
void number_branches(Branches& out) {
  for (int i = 0; i < out.count; ++i) out.at[static_cast<std::size_t>(i)].bits = i;
}

// The next solution.
Branch& add(Branches& out, const Branch& branch) {
  Branch& added = out.add(branch);
  added.bits = out.count - 1;
  return added;
}

// Adds both solutions of an elbow about parallel axes 1 and 2, each with the angles of the rest.
void add_elbow(const Elbow& elbow, Branch branch, Branches& out, const Angle* sum = nullptr) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(elbow.count); ++i) {
    branch.phi[0] = elbow.x1[i];
    branch.phi[1] = elbow.x2[i];
    if (sum != nullptr) branch.phi[2] = inverse(branch.phi[0] * elbow.x2[i]) * *sum;
    add(out, branch);
  }
  out.free = out.free || elbow.free;
  out.leave_open(0, elbow.open1);
  out.leave_open(1, elbow.open2);
}

// Solves Rz(x1) v = u in the plane across the axis.
void position_by_one(const Vector3d& u, const Vector3d& v, Branch branch, Branches& out) {
  bool whole = true;
  const Angle first = angle_from_to(v.x(), v.y(), u.x(), u.y(), whole);
  if (whole && !on_axis(v))
    branch.phi[0] = first;
  else
    out.leave_open(0);
  out.free = out.free || near_axis(v);
  add(out, branch);
}

// Solves Z_0 X_1 Rz(x2) t = u. The equations are Pieper's: the distance from the first axis' origin
// and the height along it do not depend on x1.
void position_by_two(const CanonicalRows& rows, const Vector3d& u, const Vector3d& t, Branch branch,
                     Branches& out) {
  const Angle& alpha = rows.alpha[1];
  const double a = rows.a[1];
  if (rows.parallel(1)) {
    const Links links{a, 0.0, t.x(), t.y()};
    return add_elbow(solve_elbow(links, u.x(), u.y(), branch.phi[0], branch.phi[1]), branch, out);
  }
  const double z = u.z() - rows.h[0];
  const double along = (z - alpha.c * t.z()) / alpha.s;
  AnglePair second;
  if (a == 0.0) {
    second = circle_meets_plane(t.y(), t.x(), along);
  } else {
    const double r2 = u.head<2>().squaredNorm() + z * z;
    bool whole = true;
    second.count = 1;
    second.x[0] =
        angle_from_to(t.x(), t.y(), (r2 - a * a - t.squaredNorm()) / (2.0 * a), along, whole);
    if (!whole || on_axis(t)) second.count = -1;
  }
  out.leave_open(1, second.count < 0);
  second = or_present(second, branch.phi[1], out.free);
  out.free = out.free || near_axis(t);
  for (int i = 0; i < second.count; ++i) {
    branch.phi[1] = second.x[static_cast<std::size_t>(i)];
    position_by_one(u, placed(rows, 1, rotated(branch.phi[1], t)), branch, out);
  }
}

// A value that depends on the angle of joint 3: v0 + v1 cos x3 + v2 sin x3.
using Wave = Vector3d;

// The point w after joint 3 in the frame of joint 2 with its height: the square of its distance
// from the origin, and its coordinate along axis 2.
struct Circle {
  Wave square, along;
};
Circle circle_of(const CanonicalRows& rows, const Vector3d& w) {
  const Angle& alpha = rows.alpha[2];
  const double a = rows.a[2];
  const double h = rows.h[1];
  const double z = w.z() + rows.h[2];
  Circle out;
  out.square = {a * a + w.head<2>().squaredNorm() + z * z + h * h + 2.0 * h * alpha.c * z,
                2.0 * (a * w.x() + h * alpha.s * w.y()), 2.0 * (h * alpha.s * w.x() - a * w.y())};
  out.along = {h + alpha.c * z, alpha.s * w.y(), alpha.s * w.x()};
  return out;
}

double value_at(const Matrix3d& Q, const Angle& x) {
  const Vector3d v(1.0, x.c, x.s);
  return v.dot(Q * v);
}

// The angles at which v^T Q v = 0, v = (1, cos x, sin x): the zeros of a quartic in tan(x/2), which
// is measured from a direction where it is far from infinite. Where two zeros nearly coincide the
// angle between them is listed too, in case rounding has removed both.
//
// Q  of the size of 1 unless its terms cancel: then every angle is a zero, and the present one is
//    used.
std::vector<Angle> zeros_of(const Matrix3d& Q, const Angle& present, bool& free) {
  constexpr double kHalfRight = 0.70710678118654752;
  const Angle eighths[] = {{1, 0},  {kHalfRight, kHalfRight},   {0, 1},  {-kHalfRight, kHalfRight},
                           {-1, 0}, {-kHalfRight, -kHalfRight}, {0, -1}, {kHalfRight, -kHalfRight}};
  Angle far{};
  double most = 0.0;
  for (const Angle& x : eighths) {
    const double value = std::abs(value_at(Q, x));
    if (value > most) {
      most = value;
      far = x;
    }
  }
  if (!(most > kVanishes)) {
    free = true;
    return {present};
  }
  const Angle from{-far.c, -far.s};
  Matrix3d R = Matrix3d::Identity();
  R.bottomRightCorner<2, 2>() << from.c, -from.s, from.s, from.c;
  const Matrix3d P = R.transpose() * (Q / most) * R;
  // v (1 + T^2) = (1 + T^2, 1 - T^2, 2 T)
  Eigen::VectorXd c(5);
  c << P(0, 0) + 2.0 * P(0, 1) + P(1, 1), 4.0 * (P(0, 2) + P(1, 2)),
      2.0 * (P(0, 0) - P(1, 1)) + 4.0 * P(2, 2), 4.0 * (P(0, 2) - P(1, 2)),
      P(0, 0) - 2.0 * P(0, 1) + P(1, 1);
  std::vector<double> zeros = real_roots(c);
  for (const double T : real_roots(polynomial_derivative(c))) {
    const double size = (1.0 + T * T) * (1.0 + T * T);
    if (std::abs(polynomial_value(c, T)) < kNearTouching * size) zeros.push_back(T);
  }
  std::vector<Angle> out;
  for (const double T : zeros) {
    const double r = 1.0 + T * T;
    out.push_back(from * Angle{(1.0 - T * T) / r, 2.0 * T / r});
  }
  return out;
}

// Z_0 X_1 Z_1 X_2 Z_2 w = u for axes 1 and 2 that neither meet nor are parallel. With k1 and k2 the
// coordinates of Rz(x2) t across axis 2, distance and height give both, and k1^2 + k2^2 is
// determined by t: an equation in x3 alone (Pieper 1968; subproblem 5 of Elias and Wen), divided by
// the size of its terms.
Matrix3d position_equation(const CanonicalRows& rows, const Vector3d& u, const Circle& circle) {
  const Angle& alpha = rows.alpha[1];
  const double a = rows.a[1];
  const double z = u.z() - rows.h[0];
  const double r2 = u.head<2>().squaredNorm() + z * z;
  const Vector3d one = Vector3d::UnitX();
  const Wave k1 = (r2 - a * a) * one - circle.square;  // times 2 a
  const Wave k2 = z * one - alpha.c * circle.along;    // times sin alpha
  const double s2 = alpha.s * alpha.s;
  const double a2 = 4.0 * a * a;
  Matrix3d Q = s2 * k1 * k1.transpose() + a2 * k2 * k2.transpose();
  Q += a2 * s2 * circle.along * circle.along.transpose();
  Q -= 0.5 * a2 * s2 * (circle.square * one.transpose() + one * circle.square.transpose());
  const double size = s2 * k1.squaredNorm() + a2 * k2.squaredNorm() +
                      a2 * s2 * (circle.along.squaredNorm() + circle.square.norm());
  return Q / size;
}

void position_by_three(const CanonicalRows& rows, const Vector3d& u, const Vector3d& w,
                       const Branch& near, Branches& out) {
  if (rows.meet(1) || (rows.parallel(2) && !rows.parallel(1))) {
    reach_position(rows, u, w, near, out);
    for (int i = 0; i < out.count; ++i) out.at[static_cast<std::size_t>(i)].bits = i;
    return;
  }
  const Circle circle = circle_of(rows, w);
  std::vector<Angle> thirds;
  if (rows.parallel(1)) {
    const double height = u.z() - rows.h[0] - circle.along[0];
    const AnglePair turns = circle_meets_plane(circle.along[1], circle.along[2], height);
    const AnglePair pair = or_present(turns, near.phi[2], out.free);
    out.leave_open(2, turns.count < 0);
    for (int i = 0; i < pair.count; ++i) thirds.push_back(pair.x[static_cast<std::size_t>(i)]);
  } else {
    bool open = false;
    thirds = zeros_of(position_equation(rows, u, circle), near.phi[2], open);
    out.free = out.free || open;
    out.leave_open(2, open);
  }
  for (const Angle& third : thirds) {
    Branch branch = near;
    branch.phi[2] = third;
    const Vector3d v = placed(rows, 2, lifted(rotated(third, w), rows.h[2]));
    position_by_two(rows, u, lifted(v, rows.h[1]), branch, out);
  }
}

// The first n joint values that bring the point w, fixed after the last of them, to the position u.
void solve_position(const CanonicalRows& rows, int n, const Vector3d& u, const Vector3d& w,
                    const Branch& near, Branches& out) {
  if (n == 1) return position_by_one(u, w, near, out);
  if (n == 2) return position_by_two(rows, u, lifted(w, rows.h[1]), near, out);
  position_by_three(rows, u, w, near, out);
}

// Three axes that meet in a point: a line fixed after joint 3 and its goal determine the three
// joint angles.
void rotation_about_a_point(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                            Branches& out) {
  Matrix3d R03 = G.linear();
  if (rows.n == 4) {
    const auto frame_of = [](const Vector3d& direction, const Vector3d& point) {
      Matrix3d F;
      F.col(0) = direction;
      F.col(2) = direction.cross(point).normalized();
      F.col(1) = F.col(2).cross(direction);
      return F;
    };
    const Angle& alpha = rows.alpha[3];
    const Vector3d z = G.linear().col(2);
    const Vector3d p = G.translation() - rows.h[3] * z - Vector3d(0, 0, rows.h[0]);
    R03 = frame_of(z, p) * frame_of({0, -alpha.s, alpha.c}, {rows.a[3], 0, rows.h[2]}).transpose();
  }
  if (!R03.allFinite()) return;
  const Euler euler = solve_euler(R03, rows.alpha[1], rows.alpha[2], near.phi[0]);
  out.free = out.free || euler.singular;
  for (int i = 0; i < euler.count; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    Branch& branch = add(out, near);
    branch.phi[0] = euler.x1[k];
    branch.phi[1] = euler.x2[k];
    branch.phi[2] = euler.x3[k];
  }
}

// Axes 1, 2 and 3 parallel, the fourth not: its direction gives the sum of their angles; what
// remains is an elbow.
void bend_in_plane(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                   Branches& out) {
  const Vector3d z = G.linear().col(2);
  bool whole = true;
  const Angle sum = angle_from_to(0.0, -rows.alpha[3].s, z.x(), z.y(), whole);
  const Vector3d wrist = G.translation() - rows.h[3] * z - rotated(sum, {rows.a[3], 0, 0});
  const Elbow elbow =
      solve_elbow({rows.a[1], 0.0, rows.a[2], 0.0}, wrist.x(), wrist.y(), near.phi[0], near.phi[1]);
  add_elbow(elbow, near, out, &sum);
}

bool three_parallel(const CanonicalRows& rows) { return rows.parallel(1) && rows.parallel(2); }

// Height of a point on the last axis that is not on the axis before it.
double height_on_axis(const CanonicalRows& rows) {
  const std::size_t last = static_cast<std::size_t>(rows.n) - 1;
  if (rows.parallel(rows.n - 1) || std::abs(rows.a[last]) > 0.01) return 0.0;
  double size = 0.1;
  for (std::size_t i = 0; i < last; ++i) size += std::abs(rows.a[i]) + std::abs(rows.h[i]);
  return size;
}

// Whether two neighbouring joints have one axis.
bool has_double_axis(const CanonicalRows& rows, int n) {
  for (int i = 1; i < n; ++i) {
    if (rows.parallel(i) && rows.a[static_cast<std::size_t>(i)] == 0.0) return true;
  }
  return false;
}

// The angle of the last remaining joint.
Angle last_angle(const Matrix3d& M) {
  bool whole = true;
  return angle_from_to(1.0, 0.0, M(0, 0), M(1, 0), whole);
}

}  // namespace

ClosedFormKind recognised_few(const CanonicalRows& rows) {
  if (rows.n > 4 || rows.reversed) return ClosedFormKind::kNone;
  for (int i = 0; i < rows.n; ++i) {
    if (!rows.revolute[static_cast<std::size_t>(i)]) return ClosedFormKind::kNone;
  }
  if (has_double_axis(rows, rows.n)) return ClosedFormKind::kNone;
  const bool round = rows.n >= 3 && meet_in_a_point(rows);
  if (rows.n == 4) {
    if (three_parallel(rows) && rows.parallel(3)) return ClosedFormKind::kNone;
    const Vector3d axis(0, -rows.alpha[3].s, rows.alpha[3].c);
    const bool through = axis.cross(Vector3d(rows.a[3], 0, rows.h[2])).norm() < kNoLength;
    return round && through ? ClosedFormKind::kNone : ClosedFormKind::kFewPose;
  }
  if (rows.n == 3 && three_parallel(rows)) return ClosedFormKind::kNone;
  return round || on_axis(rows.tool_point) ? ClosedFormKind::kFewPose
                                           : ClosedFormKind::kFewPosition;
}

void solve_few_position(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                        Branches& out) {
  solve_position(rows, rows.n, G * rows.tool_point, rows.tool_point, near, out);
}

void solve_few_pose(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                    Branches& out) {
  const std::size_t last = static_cast<std::size_t>(rows.n) - 1;
  if (rows.n >= 3 && meet_in_a_point(rows)) {
    rotation_about_a_point(rows, G, near, out);
    if (rows.n == 3) return;
  } else if (rows.n == 4 && three_parallel(rows)) {
    bend_in_plane(rows, G, near, out);
  } else if (rows.n == 1) {
    add(out, near);
  } else {
    const double height = height_on_axis(rows);
    const Vector3d u = G.translation() + (height - rows.h[last]) * G.linear().col(2);
    solve_position(rows, rows.n - 1, u, placed(rows, last, Vector3d(0, 0, height)), near, out);
  }
  for (int i = 0; i < out.count; ++i) {
    Branch& branch = out.at[static_cast<std::size_t>(i)];
    Matrix3d M = G.linear();
    for (std::size_t j = 0; j < last; ++j) M = rotated_back(branch.phi[j], rows.alpha[j + 1], M);
    branch.phi[last] = last_angle(M);
  }
}

ClosedFormKind recognised_wrist(const CanonicalRows& rows) {
  if (rows.n != 5 && rows.n != 6) return ClosedFormKind::kNone;
  for (int i = 0; i < rows.n; ++i) {
    if (!rows.revolute[static_cast<std::size_t>(i)]) return ClosedFormKind::kNone;
  }
  const bool solvable = !has_double_axis(rows, 3) && !three_parallel(rows) &&
                        !meet_in_a_point(rows) && !on_axis(placed(rows, 3, {0, 0, rows.h[3]}));
  if (!solvable || !rows.meet(4)) return ClosedFormKind::kNone;
  if (rows.n == 5) return ClosedFormKind::kMeetingWrist;
  return rows.meet(5) && rows.h[4] == 0.0 ? ClosedFormKind::kSphericalWrist : ClosedFormKind::kNone;
}

void solve_any_wrist(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                     Branches& out) {
  const std::size_t last = static_cast<std::size_t>(rows.n) - 1;
  const Vector3d centre = G.translation() - rows.h[last] * G.linear().col(2);
  Branches arms;
  position_by_three(rows, centre, placed(rows, 3, Vector3d(0, 0, rows.h[3])), near, arms);
  out.free = arms.free;
  out.open = arms.open;
  for (int i = 0; i < arms.count; ++i) {
    Branch branch = arms.at[static_cast<std::size_t>(i)];
    const Matrix3d M = left_for_wrist(rows, branch, G.linear());
    if (rows.n == 6) {
      solve_wrist(rows, M, near, branch, out);
      continue;
    }
    bool whole = true;
    branch.phi[3] = angle_from_to(0.0, -rows.alpha[4].s, M(0, 2), M(1, 2), whole);
    branch.phi[4] = last_angle(rotated_back(branch.phi[3], rows.alpha[4], M));
    out.add(branch);
  }
  number_branches(out);
}

}  // namespace armlet
