#include "closed_form_families.hpp"

#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Three joints with parallel axes from `first` on: an elbow, and a third angle that completes the
// sum of their angles.
void bend(Branch& branch, std::size_t first, const Elbow& elbow, int which, const Angle& sum) {
  const std::size_t i = static_cast<std::size_t>(which);
  branch.phi[first] = elbow.x1[i];
  branch.phi[first + 1] = elbow.x2[i];
  branch.phi[first + 2] = inverse(elbow.x1[i] * elbow.x2[i]) * sum;
}

// Joint 3 of an arm whose axes 1 and 2 meet: its angle, or its height, from the distance of the
// position to their common point.
struct Third {
  int count = 0;
  bool open = false;
  std::array<Angle, 2> x{};
  std::array<double, 2> z{};
};

// The rotations of joint i, from 0, for which the point w of the frame after it has the squared
// distance distance2 from the origin about which joint i - 1 rotates: the squared length of h e_z +
// a e_x + Rx(alpha) (Rz(x) w + h_i e_z) is linear in cos x and sin x. This is subproblem 3 of Paden
// and Kahan (R. Murray, Z. Li, S. Sastry, A Mathematical Introduction to Robotic Manipulation,
// 1994, chapter 3, Paden-Kahan subproblems), written as circle and plane.
AnglePair angles_for_distance(const CanonicalRows& rows, std::size_t i, double distance2,
                              const Vector3d& w) {
  const Angle& alpha = rows.alpha[i];
  const double z = w.z() + rows.h[i];
  const double a = rows.a[i];
  const double h = rows.h[i - 1];
  const double fixed =
      a * a + w.x() * w.x() + w.y() * w.y() + z * z + h * h + 2.0 * h * alpha.c * z;
  const double A = 2.0 * (a * w.x() + h * alpha.s * w.y());
  const double B = 2.0 * (h * alpha.s * w.x() - a * w.y());
  return circle_meets_plane(A, B, distance2 - fixed);
}

Third third_angle(const CanonicalRows& rows, double distance2, const Vector3d& w,
                  const Angle& present, bool& free) {
  const AnglePair found = angles_for_distance(rows, 2, distance2, w);
  const AnglePair pair = or_present(found, present, free);
  return {pair.count, found.count < 0, pair.x, {rows.h[2], rows.h[2]}};
}

Third third_slide(const CanonicalRows& rows, double distance2, const Vector3d& w) {
  const Angle& alpha = rows.alpha[2];
  const Vector3d v = rotated(rows.phi[2], w);
  const double h = rows.h[1];
  const double x = rows.a[2] + v.x();
  // (z + h cos alpha)^2 = distance^2 - the terms without z
  const double rest = x * x + v.y() * v.y() + 2.0 * h * alpha.s * v.y() + h * h * alpha.s * alpha.s;
  const double square = distance2 - rest;
  if (square < -kClosedSlack * (distance2 + rest)) return {};
  const double root = std::sqrt(std::fmax(square, 0.0));
  const double middle = -h * alpha.c - v.z();
  return {root == 0.0 ? 1 : 2, false, {rows.phi[2], rows.phi[2]}, {middle + root, middle - root}};
}

// Axes 1 and 2 meet: the distance from their common point gives joint 3.
void reach_meeting(const CanonicalRows& rows, const Vector3d& u_base, const Vector3d& w,
                   const Branch& near, Branches& out) {
  const Vector3d u = u_base - Vector3d(0, 0, rows.h[0]);
  const Third third = rows.revolute[2]
                          ? third_angle(rows, u.squaredNorm(), w, near.phi[2], out.free)
                          : third_slide(rows, u.squaredNorm(), w);
  out.leave_open(2, third.open);
  for (int i = 0; i < third.count; ++i) {
    const Angle x3 = third.x[static_cast<std::size_t>(i)];
    const double z3 = third.z[static_cast<std::size_t>(i)];
    Vector3d t = placed(rows, 2, rotated(x3, w) + Vector3d(0, 0, z3));
    t.z() += rows.h[1];
    // Height above the plane of axis 1: alpha1.s (x2 t)_y + alpha1.c t_z = u_z.
    const Angle& alpha1 = rows.alpha[1];
    const double height = (u.z() - alpha1.c * t.z()) / alpha1.s;
    const AnglePair turns = circle_meets_plane(t.y(), t.x(), height);
    const AnglePair second = or_present(turns, near.phi[1], out.free);
    out.leave_open(1, turns.count < 0);
    out.free = out.free || t.head<2>().norm() < kNearAxis;
    for (int j = 0; j < second.count; ++j) {
      const Angle x2 = second.x[static_cast<std::size_t>(j)];
      const Vector3d v = placed(rows, 1, rotated(x2, t));
      bool whole = true;
      Angle x1 = angle_from_to(v.x(), v.y(), u.x(), u.y(), whole);
      if (!whole || v.head<2>().norm() < kNoLength) {
        x1 = near.phi[0];
        out.leave_open(0);
      }
      out.free = out.free || v.head<2>().norm() < kNearAxis;
      Branch& branch = out.add(near);
      branch.phi[0] = x1;
      branch.phi[1] = x2;
      branch.phi[2] = x3;
      branch.height[2] = z3;
      branch.bits += kElbowBit * i + kShoulderBit * j;
    }
  }
}

}  // namespace

int rotate_into_plane(const CanonicalRows& rows, const Vector3d& u, double height,
                      const Angle& near, std::array<PlaneView, 2>& out, Branches& branches) {
  const Angle& alpha = rows.alpha[1];
  const double z = u.z() - rows.h[0];
  // Along the parallel axes: -alpha.s r_y + alpha.c z = height, with r = Rz(-x) u.
  const double m = (alpha.c * z - height) / alpha.s;
  const double rho2 = u.x() * u.x() + u.y() * u.y();
  const double rho = std::sqrt(rho2);
  const auto view = [&](const Angle& x, double along) {
    return PlaneView{x, along - rows.a[1], alpha.c * m + alpha.s * z};
  };
  branches.free = branches.free || rho < kNearAxis;
  if (rho < kNoLength) {
    if (std::abs(m) > kNoLength) return 0;
    branches.leave_open(0);
    out[0] = view(near, 0.0);
    out[1] = view({-near.c, -near.s}, 0.0);
    return 2;
  }
  const double h2 = (rho - m) * (rho + m);
  if (h2 < -kClosedSlack * rho2) return 0;
  const double h = std::sqrt(std::fmax(h2, 0.0));
  const double r2 = h * h + m * m;
  for (std::size_t i = 0; i < 2; ++i) {
    const double along = i == 0 ? h : -h;
    const Angle x{(along * u.x() + m * u.y()) / r2, (along * u.y() - m * u.x()) / r2};
    out[i] = view(x, along);
  }
  return h == 0.0 ? 1 : 2;
}

void reach_position(const CanonicalRows& rows, const Vector3d& u, const Vector3d& w,
                    const Branch& near, Branches& out) {
  if (!rows.parallel(2) || !rows.revolute[2]) return reach_meeting(rows, u, w, near, out);
  std::array<PlaneView, 2> views;
  const int count =
      rotate_into_plane(rows, u, rows.h[1] + rows.h[2] + w.z(), near.phi[0], views, out);
  for (int i = 0; i < count; ++i) {
    const PlaneView& view = views[static_cast<std::size_t>(i)];
    const Elbow elbow =
        solve_elbow({rows.a[2], 0.0, w.x(), w.y()}, view.X, view.Y, near.phi[1], near.phi[2]);
    out.free = out.free || elbow.free;
    out.leave_open(1, elbow.open1);
    out.leave_open(2, elbow.open2);
    for (int j = 0; j < elbow.count; ++j) {
      Branch& branch = out.add(near);
      branch.phi[0] = view.theta;
      branch.phi[1] = elbow.x1[static_cast<std::size_t>(j)];
      branch.phi[2] = elbow.x2[static_cast<std::size_t>(j)];
      branch.bits += kShoulderBit * i + kElbowBit * j;
    }
  }
}

void solve_shoulder(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                    Branches& out) {
  // In the frame of joint 3 without its height, which reach_position adds.
  reach_position(rows, G * rows.tool_point, rows.tool_point, near, out);
}

Matrix3d left_for_wrist(const CanonicalRows& rows, const Branch& branch, Matrix3d M) {
  for (std::size_t j = 0; j < 3; ++j) M = rotated_back(branch.phi[j], rows.alpha[j + 1], M);
  return M;
}

void solve_wrist(const CanonicalRows& rows, const Matrix3d& M, const Branch& near, Branch branch,
                 Branches& out) {
  const Euler wrist = solve_euler(M, rows.alpha[4], rows.alpha[5], near.phi[3]);
  const int ways = branch.bits;
  out.free = out.free || wrist.singular;
  for (int j = 0; j < wrist.count; ++j) {
    const std::size_t k = static_cast<std::size_t>(j);
    branch.phi[3] = wrist.x1[k];
    branch.phi[4] = wrist.x2[k];
    branch.phi[5] = wrist.x3[k];
    branch.bits = ways + kWristBit * j;
    out.add(branch);
  }
}

// The point where the last three axes meet depends on the first three joints only; the wrist makes
// the remaining rotation.
void solve_spherical_wrist(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                           Branches& out) {
  const Vector3d centre = G.translation() - rows.h[5] * G.linear().col(2);
  Branches arms;
  reach_position(rows, centre, placed(rows, 3, Vector3d(0, 0, rows.h[3])), near, arms);
  out.free = arms.free;
  out.open = arms.open;
  for (int i = 0; i < arms.count; ++i) {
    const Branch& branch = arms.at[static_cast<std::size_t>(i)];
    solve_wrist(rows, left_for_wrist(rows, branch, G.linear()), near, branch, out);
  }
}

void solve_three_parallel(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                          Branches& out) {
  const Vector3d centre = G.translation() - rows.h[5] * G.linear().col(2);
  // From joint 4 to the point where axes 5 and 6 meet.
  const Vector3d last = placed(rows, 4, Vector3d(0, 0, rows.h[4]));
  std::array<PlaneView, 2> views;
  const double height = rows.h[1] + rows.h[2] + rows.h[3] + last.z();
  const int count = rotate_into_plane(rows, centre, height, near.phi[0], views, out);
  const Angle near_sum = near.phi[1] * near.phi[2] * near.phi[3];
  for (int i = 0; i < count; ++i) {
    const PlaneView& view = views[static_cast<std::size_t>(i)];
    const Matrix3d M = rotated_back(view.theta, rows.alpha[1], Matrix3d(G.linear()));
    const Euler wrist = solve_euler(M, rows.alpha[4], rows.alpha[5], near_sum);
    out.free = out.free || wrist.singular;
    out.leave_open(3, wrist.open);  // the sum of the angles 1 to 3
    for (int j = 0; j < wrist.count; ++j) {
      const std::size_t k = static_cast<std::size_t>(j);
      const Angle sum = wrist.x1[k];
      const Vector3d last_link = rotated(sum, last);
      const Elbow elbow = solve_elbow({rows.a[2], 0.0, rows.a[3], 0.0}, view.X - last_link.x(),
                                      view.Y - last_link.y(), near.phi[1], near.phi[2]);
      out.free = out.free || elbow.free;
      for (int e = 0; e < elbow.count; ++e) {
        Branch& branch = out.add(near);
        branch.phi[0] = view.theta;
        bend(branch, 1, elbow, e, sum);
        branch.bits = kShoulderBit * i + kWristBit * j + kElbowBit * e;
        branch.phi[4] = wrist.x2[k];
        branch.phi[5] = wrist.x3[k];
      }
    }
  }
}

void solve_planar_arm_twist(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                            Branches& out) {
  const Vector3d z = G.linear().col(2);
  const Vector3d w = G.translation() - rows.h[4] * z;
  std::array<PlaneView, 2> views;
  const double height = rows.h[1] + rows.h[2] + rows.h[3];
  Angle heading = near.phi[0];
  bool open = true;
  if (w.head<2>().norm() < kNoLength) {
    // The wrist is on axis 1: the tool's axis determines the direction of the plane.
    const AnglePair x = circle_meets_plane(-rows.alpha[1].s * z.y(), rows.alpha[1].s * z.x(),
                                           rows.alpha[4].c - rows.alpha[1].c * z.z());
    if (x.count > 0) heading = x.x[0];
    open = x.count <= 0;
  }
  const int count = rotate_into_plane(rows, w, height, heading, views, out);
  if (!open) out.open = 0;
  for (int i = 0; i < count; ++i) {
    const PlaneView& view = views[static_cast<std::size_t>(i)];
    const Matrix3d M = rotated_back(view.theta, rows.alpha[1], Matrix3d(G.linear()));
    bool whole = true;
    const double s = rows.alpha[4].s;
    const Angle sum = angle_from_to(0.0, -s, M(0, 2), M(1, 2), whole);
    const Angle twist = angle_from_to(M(2, 0), M(2, 1), 0.0, s, whole);
    const double X = view.X - sum.c * rows.a[4];
    const double Y = view.Y - sum.s * rows.a[4];
    const Elbow elbow =
        solve_elbow({rows.a[2], 0.0, rows.a[3], 0.0}, X, Y, near.phi[1], near.phi[2]);
    out.free = out.free || elbow.free;
    for (int e = 0; e < elbow.count; ++e) {
      Branch& branch = out.add(near);
      branch.phi[0] = view.theta;
      bend(branch, 1, elbow, e, sum);
      branch.bits = kShoulderBit * i + kElbowBit * e;
      branch.phi[4] = twist;
    }
  }
}

// Three parallel revolute joints: the links between them are (a, 0).
void solve_plane(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                 Branches& out) {
  const Angle sum{G.linear()(0, 0), G.linear()(1, 0)};
  const Elbow elbow = solve_elbow({rows.a[1], 0.0, rows.a[2], 0.0}, G.translation().x(),
                                  G.translation().y(), near.phi[0], near.phi[1]);
  out.free = out.free || elbow.free;
  for (int e = 0; e < elbow.count; ++e) {
    Branch& branch = out.add(near);
    bend(branch, 0, elbow, e, sum);
    branch.bits = kElbowBit * e;
  }
}

void solve_scara(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                 Branches& out) {
  // Links between the revolute joints; `before` is the part that the prismatic joint shifts before
  // each.
  std::array<Eigen::Vector2d, 4> link;
  link.fill(Eigen::Vector2d::Zero());
  std::array<Angle, 4> before{};
  std::array<std::size_t, 3> turning{};
  std::size_t slide = 0;
  std::size_t turns = 0;
  double height = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    link[turns] += Eigen::Vector2d(before[turns].c, before[turns].s) * rows.a[i];
    height += rows.h[i];
    if (rows.revolute[i]) {
      turning[turns++] = i;
    } else {
      slide = i;
      before[turns] = rows.phi[i];
    }
  }
  const Angle heading = Angle{G.linear()(0, 0), G.linear()(1, 0)} * inverse(before[3]);
  const Eigen::Vector2d& last = link[3];
  const Eigen::Vector2d p = G.translation().head<2>() - link[0] -
                            Eigen::Vector2d(heading.c * last.x() - heading.s * last.y(),
                                            heading.s * last.x() + heading.c * last.y());
  const Elbow elbow =
      solve_elbow({link[1].x(), link[1].y(), link[2].x(), link[2].y()}, p.x(), p.y(),
                  before[0] * near.phi[turning[0]], before[1] * near.phi[turning[1]]);
  out.free = out.free || elbow.free;
  for (int e = 0; e < elbow.count; ++e) {
    const std::size_t f = static_cast<std::size_t>(e);
    Branch& branch = out.add(near);
    branch.phi[turning[0]] = inverse(before[0]) * elbow.x1[f];
    branch.phi[turning[1]] = inverse(before[1]) * elbow.x2[f];
    branch.phi[turning[2]] = inverse(before[2] * elbow.x1[f] * elbow.x2[f]) * heading;
    branch.height[slide] = G.translation().z() - height;
    branch.bits = kElbowBit * e;
  }
}

namespace {

// The frame with z along k and y as near as possible to v.
bool frame_about(const Vector3d& k, const Vector3d& v, Matrix3d& out) {
  const Vector3d y = v - v.dot(k) * k;
  const double r = y.norm();
  if (r < 1e-9) return false;
  out.col(1) = y / r;
  out.col(2) = k;
  out.col(0) = out.col(1).cross(k);
  return true;
}

// The reference direction of the arm angle: the x axis of the base, or its y axis if k is near x.
bool reference_frame(const Vector3d& k, Matrix3d& out) {
  return frame_about(k, std::abs(k.x()) < 0.9999 ? Vector3d::UnitX() : Vector3d::UnitY(), out);
}

// The vector from the shoulder to the wrist, in the frame of joint 3, for an angle of the elbow.
Vector3d shoulder_to_wrist(const CanonicalRows& rows, const Angle& x4) {
  Vector3d t = rotated(x4, placed(rows, 4, Vector3d(0, 0, rows.h[4])));
  t.z() += rows.h[3];
  t = placed(rows, 3, t);
  t.z() += rows.h[2];
  return t;
}

Matrix3d about_x(const Angle& alpha) {
  Matrix3d R;
  R << 1, 0, 0, 0, alpha.c, -alpha.s, 0, alpha.s, alpha.c;
  return R;
}
Matrix3d about_z(const Angle& x) {
  Matrix3d R;
  R << x.c, -x.s, 0, x.s, x.c, 0, 0, 0, 1;
  return R;
}

// The angle by which the elbow's axis is rotated about the line from shoulder to wrist.
Angle arm_angle(const CanonicalRows& rows, const Branch& near) {
  const Matrix3d R03 = about_z(near.phi[0]) * about_x(rows.alpha[1]) * about_z(near.phi[1]) *
                       about_x(rows.alpha[2]) * about_z(near.phi[2]);
  const Vector3d D = R03 * shoulder_to_wrist(rows, near.phi[3]);
  const Vector3d axis = R03 * Vector3d(0, -rows.alpha[3].s, rows.alpha[3].c);
  Matrix3d F;
  if (D.norm() < 1e-9 || !reference_frame(D.normalized(), F)) return {};
  bool whole = true;
  const Angle x = angle_from_to(0.0, 1.0, axis.dot(F.col(0)), axis.dot(F.col(1)), whole);
  return whole ? x : Angle{};
}

}  // namespace

void solve_shoulder_elbow_wrist(const CanonicalRows& rows, const Isometry3d& G, const Branch& near,
                                Branches& out) {
  const Vector3d D = G.translation() - rows.h[6] * G.linear().col(2) - Vector3d(0, 0, rows.h[0]);
  const double L = D.norm();
  Matrix3d F;
  if (L < 1e-9 || !reference_frame(D / L, F)) return;
  const Vector3d m = placed(rows, 4, Vector3d(0, 0, rows.h[4]));
  const Angle& alpha3 = rows.alpha[3];
  const AnglePair elbow = angles_for_distance(rows, 3, L * L, m);
  const det::SinCos more = det::sincos(out.arm_angle_change);
  const Angle psi = arm_angle(rows, near) * Angle{more.cos, more.sin};
  const Matrix3d base = F * about_z(psi);
  for (int i = 0; i < elbow.count; ++i) {
    Branch branch = near;
    const Angle x4 = elbow.x[static_cast<std::size_t>(i)];
    branch.phi[3] = x4;
    Matrix3d arm;
    if (!frame_about(shoulder_to_wrist(rows, x4) / L, Vector3d(0, -alpha3.s, alpha3.c), arm))
      continue;
    const Matrix3d R03 = base * arm.transpose();
    const Matrix3d M =
        (R03 * about_x(alpha3) * about_z(x4) * about_x(rows.alpha[4])).transpose() * G.linear();
    const Euler shoulder = solve_euler(R03, rows.alpha[1], rows.alpha[2], near.phi[0]);
    const Euler wrist = solve_euler(M, rows.alpha[5], rows.alpha[6], near.phi[4]);
    out.free = out.free || shoulder.singular || wrist.singular;
    for (int s = 0; s < shoulder.count; ++s) {
      for (int w = 0; w < wrist.count; ++w) {
        const std::size_t j = static_cast<std::size_t>(s);
        const std::size_t k = static_cast<std::size_t>(w);
        branch.phi[0] = shoulder.x1[j];
        branch.phi[1] = shoulder.x2[j];
        branch.phi[2] = shoulder.x3[j];
        branch.phi[4] = wrist.x1[k];
        branch.phi[5] = wrist.x2[k];
        branch.phi[6] = wrist.x3[k];
        branch.bits = kElbowBit * i + kShoulderBit * s + kWristBit * w;
        out.add(branch);
      }
    }
  }
}

}  // namespace armlet
