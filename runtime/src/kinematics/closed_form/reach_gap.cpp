#include "armlet/kinematics/reach_gap.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "branches.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTouching = 1e-9;  // m: distance from the boundary that is only rounding

// An arm as the closed form reads it: rows are numbered in that order; joints as in the arm.
struct Reading {
  const CanonicalRows& rows;

  int joint(int row) const { return rows.reversed ? rows.n - 1 - row : row; }
  // The link between the axes of this row and the next.
  int link(int row) const { return rows.reversed ? joint(row + 1) : joint(row); }
};

// Collects the smallest gap of several solutions; empty if one of the solutions has no gap.
class LeastGap {
 public:
  void add(const ReachGap& gap) {
    if (!any_ || gap.miss < least_.miss || !gap.exists()) least_ = gap;
    any_ = true;
  }
  ReachGap least() const { return least_; }

 private:
  ReachGap least_;
  bool any_ = false;
};

ReachGap between(double distance, double low, double high, ReachGap gap) {
  gap.distance = distance;
  if (distance > high + kTouching) {
    gap.kind = GapKind::kTooFar;
    gap.limit = high;
  } else if (distance < low - kTouching) {
    gap.kind = GapKind::kTooNear;
    gap.limit = low;
  } else {
    return {};
  }
  gap.miss = std::abs(distance - gap.limit);
  return gap;
}

// Two links in a plane, rotated by the joints of two rows.
ReachGap elbow_gap(const Reading& arm, int row, double l, double m, double distance, ReachGap gap) {
  gap.from = arm.joint(row);
  gap.links = {l, m};
  gap.link_numbers = {arm.link(row), arm.link(row + 1)};
  return between(distance, std::abs(l - m), l + m, gap);
}

// The plane across the parallel axes from the second on that contains a position at `height` along
// them: its distance from axis 1, and the position in the plane, for either side.
struct Passing {
  double m = 0.0;  // signed distance of the plane from axis 1
  double from_axis = 0.0;
  std::array<Vector2d, 2> in_plane{};
  std::array<double, 2> along{};
};

Passing passing(const CanonicalRows& rows, const Vector3d& u, double height) {
  const Angle& alpha = rows.alpha[1];
  const double z = u.z() - rows.h[0];
  const double m = (alpha.c * z - height) / alpha.s;
  Passing out;
  out.m = m;
  out.from_axis = u.head<2>().norm();
  const double h2 = (out.from_axis - m) * (out.from_axis + m);
  const double h = std::sqrt(std::fmax(h2, 0.0));
  out.along = {h, -h};
  for (std::size_t i = 0; i < 2; ++i)
    out.in_plane[i] = {out.along[i] - rows.a[1], alpha.c * m + alpha.s * z};
  return out;
}

bool misses_axis(const Reading& arm, const Passing& pass, ReachGap& gap) {
  const double least = std::abs(pass.m);
  if (pass.from_axis >= least - kTouching) return false;
  gap.kind = GapKind::kTooClose;
  gap.from = arm.joint(0);
  gap.distance = pass.from_axis;
  gap.limit = least;
  gap.miss = least - pass.from_axis;
  return true;
}

// The gap for joints 1 to 3, axes 2 and 3 parallel, that bring the point w, fixed after joint 3, to
// the position u.
ReachGap gap_of_parallel(const Reading& arm, const Vector3d& u, const Vector3d& w, ReachGap gap) {
  const CanonicalRows& rows = arm.rows;
  const Passing pass = passing(rows, u, rows.h[1] + rows.h[2] + w.z());
  if (misses_axis(arm, pass, gap)) return gap;
  LeastGap least;
  for (const Vector2d& position : pass.in_plane)
    least.add(elbow_gap(arm, 1, std::abs(rows.a[2]), w.head<2>().norm(), position.norm(), gap));
  return least.least();
}

// Joint 3 of an arm whose axes 1 and 2 meet: the range of distances of w from their intersection,
// and of its coordinate along axis 2 at a given distance.
struct Spread {
  double low = 0.0;
  double high = INFINITY;
  std::array<double, 2> along2{};
  int count = 0;
};

Spread spread_of_slide(const CanonicalRows& rows, const Vector3d& w, double distance) {
  const Angle& alpha = rows.alpha[2];
  const Angle& x = rows.phi[2];
  const Vector2d v(x.c * w.x() - x.s * w.y() + rows.a[2], x.s * w.x() + x.c * w.y());
  const double h = rows.h[1];
  Spread out;
  const double rest = v.squaredNorm() + 2.0 * h * alpha.s * v.y() + h * h * alpha.s * alpha.s;
  out.low = std::sqrt(std::fmax(rest, 0.0));
  const double root = std::sqrt(std::fmax(distance * distance - rest, 0.0));
  out.count = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    const double z = -h * alpha.c + (i == 0 ? root : -root);
    out.along2[i] = h + alpha.s * v.y() + alpha.c * z;
  }
  return out;
}

Spread spread_of_rotation(const CanonicalRows& rows, const Vector3d& w, double distance) {
  const Angle& alpha = rows.alpha[2];
  const double h = rows.h[1];
  const double z = w.z() + rows.h[2];
  const double a = rows.a[2];
  const double middle = a * a + w.head<2>().squaredNorm() + z * z + h * h + 2.0 * h * alpha.c * z;
  const double A = 2.0 * (a * w.x() + h * alpha.s * w.y());
  const double B = 2.0 * (h * alpha.s * w.x() - a * w.y());
  const double swing = std::sqrt(A * A + B * B);
  const AnglePair third = circle_meets_plane(A, B, distance * distance - middle);
  Spread out;
  out.low = std::sqrt(std::fmax(middle - swing, 0.0));
  out.high = std::sqrt(middle + swing);
  out.count = third.count;
  for (int i = 0; i < third.count; ++i) {
    const Angle& x = third.x[static_cast<std::size_t>(i)];
    const double across = x.s * w.x() + x.c * w.y();
    out.along2[static_cast<std::size_t>(i)] = h + alpha.s * across + alpha.c * z;
  }
  return out;
}

// The same for axes 1 and 2 that meet. At the right distance, the position may still be too far
// along axis 1: axis 2 moves the point on a circle, which has a limited range of heights.
ReachGap gap_of_meeting(const Reading& arm, const Vector3d& position, const Vector3d& w,
                        ReachGap gap) {
  const CanonicalRows& rows = arm.rows;
  const Vector3d u = position - Vector3d(0, 0, rows.h[0]);
  const double distance = u.norm();
  const Spread spread =
      rows.revolute[2] ? spread_of_rotation(rows, w, distance) : spread_of_slide(rows, w, distance);
  gap.from = arm.joint(rows.reversed ? 1 : 0);
  const ReachGap radial = between(distance, spread.low, spread.high, gap);
  if (radial.exists()) return radial;
  const Angle& alpha = rows.alpha[1];
  LeastGap least;
  for (int i = 0; i < spread.count; ++i) {
    const double along2 = spread.along2[static_cast<std::size_t>(i)];
    const double radius =
        std::sqrt(std::fmax(distance * distance - along2 * along2, 0.0)) * std::abs(alpha.s);
    const double off = u.z() - alpha.c * along2;
    ReachGap high = gap;
    high.from = arm.joint(0);
    high.distance = u.z();
    high.limit = alpha.c * along2 + (off > 0.0 ? radius : -radius);
    high.miss = std::abs(off) - radius;
    high.kind = GapKind::kTooHigh;
    least.add(high.miss > kTouching ? high : ReachGap{});
  }
  return least.least();
}

ReachGap gap_of_shoulder(const Reading& arm, const Vector3d& u, const Vector3d& w,
                         const ReachGap& gap) {
  const bool plane = arm.rows.parallel(2) && arm.rows.revolute[2];
  return plane ? gap_of_parallel(arm, u, w, gap) : gap_of_meeting(arm, u, w, gap);
}

ReachGap centre_gap(const CanonicalRows& rows) {
  ReachGap gap;
  gap.point = rows.reversed ? GapPoint::kShoulderCentre : GapPoint::kWristCentre;
  return gap;
}

// Axes 2, 3 and 4 parallel: first the plane, then the position of axis 4 in it.
ReachGap gap_of_three_parallel(const Reading& arm, const Isometry3d& G) {
  const CanonicalRows& rows = arm.rows;
  const Vector3d centre = G.translation() - rows.h[5] * G.linear().col(2);
  const Vector3d last = placed(rows, 4, Vector3d(0, 0, rows.h[4]));
  const Passing pass = passing(rows, centre, rows.h[1] + rows.h[2] + rows.h[3] + last.z());
  ReachGap gap = centre_gap(rows);
  if (misses_axis(arm, pass, gap)) return gap;
  gap.point = GapPoint::kAxis;
  gap.axis = arm.joint(3);
  LeastGap least;
  const double r2 = pass.from_axis * pass.from_axis;
  if (r2 < 1e-20) return {};
  for (std::size_t i = 0; i < 2; ++i) {
    const double along = pass.along[i];
    const Angle x1{(along * centre.x() + pass.m * centre.y()) / r2,
                   (along * centre.y() - pass.m * centre.x()) / r2};
    const Matrix3d M = rotated_back(x1, rows.alpha[1], Matrix3d(G.linear()));
    const Euler wrist = solve_euler(M, rows.alpha[4], rows.alpha[5], Angle{});
    if (wrist.singular) return {};
    for (int j = 0; j < wrist.count; ++j) {
      const Angle& sum = wrist.x1[static_cast<std::size_t>(j)];
      const Vector2d wrist_point(sum.c * last.x() - sum.s * last.y(),
                                 sum.s * last.x() + sum.c * last.y());
      least.add(elbow_gap(arm, 1, std::abs(rows.a[2]), std::abs(rows.a[3]),
                          (pass.in_plane[i] - wrist_point).norm(), gap));
    }
  }
  return least.least();
}

// Five joints, axes 2, 3 and 4 parallel; the position of the wrist in their plane depends on the
// direction of the tool's axis.
ReachGap gap_of_planar_arm(const Reading& arm, const Isometry3d& G) {
  const CanonicalRows& rows = arm.rows;
  const Vector3d z = G.linear().col(2);
  const Vector3d w = G.translation() - rows.h[4] * z;
  const Passing pass = passing(rows, w, rows.h[1] + rows.h[2] + rows.h[3]);
  ReachGap gap = centre_gap(rows);
  if (misses_axis(arm, pass, gap)) return gap;
  if (rows.a[4] != 0.0) return {};
  LeastGap least;
  for (const Vector2d& position : pass.in_plane)
    least.add(elbow_gap(arm, 1, std::abs(rows.a[2]), std::abs(rows.a[3]), position.norm(), gap));
  return least.least();
}

// Two parallel revolute joints.
ReachGap gap_of_two(const Reading& arm, const Isometry3d& G) {
  const CanonicalRows& rows = arm.rows;
  if (rows.n != 2 || !rows.parallel(1)) return {};
  const Vector3d u = G * rows.tool_point;
  const double off = u.z() - rows.h[0] - rows.h[1] - rows.tool_point.z();
  ReachGap gap;
  if (std::abs(off) > kTouching) {
    gap.kind = GapKind::kOffPlane;
    gap.distance = gap.miss = std::abs(off);
    return gap;
  }
  return elbow_gap(arm, 0, std::abs(rows.a[1]), rows.tool_point.head<2>().norm(),
                   u.head<2>().norm(), gap);
}

// Three parallel revolute joints; `ends` are the rows that rotate them.
ReachGap gap_of_plane(const Reading& arm, const Isometry3d& G) {
  const CanonicalRows& rows = arm.rows;
  ReachGap gap;
  const double off = G.translation().z() - rows.h[0] - rows.h[1] - rows.h[2];
  if (std::abs(off) > kTouching) {
    gap.kind = GapKind::kOffPlane;
    gap.distance = gap.miss = std::abs(off);
    return gap;
  }
  gap.point = GapPoint::kAxis;
  gap.axis = arm.joint(2);
  return elbow_gap(arm, 0, std::abs(rows.a[1]), std::abs(rows.a[2]),
                   G.translation().head<2>().norm(), gap);
}

ReachGap gap_of_scara(const Reading& arm, const Isometry3d& G, bool heading_counts) {
  const CanonicalRows& rows = arm.rows;
  std::array<Vector2d, 4> link;
  link.fill(Vector2d::Zero());
  std::array<Angle, 4> before{};
  std::array<int, 3> turning{};
  std::size_t turns = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    link[turns] += Vector2d(before[turns].c, before[turns].s) * rows.a[i];
    if (rows.revolute[i]) {
      turning[turns++] = static_cast<int>(i);
    } else {
      before[turns] = rows.phi[i];
    }
  }
  const bool straight = link[3].isZero(0.0) && rows.tool_point.head<2>().isZero(kTouching);
  if (!heading_counts && !straight) return {};
  const Angle heading = Angle{G.linear()(0, 0), G.linear()(1, 0)} * inverse(before[3]);
  const Vector2d last(heading.c * link[3].x() - heading.s * link[3].y(),
                      heading.s * link[3].x() + heading.c * link[3].y());
  const Vector2d p = G.translation().head<2>() - link[0] - last;
  ReachGap gap;
  if (!straight) gap.point = GapPoint::kAxis;
  gap.axis = arm.joint(turning[2]);
  gap.from = arm.joint(turning[0]);
  gap.links = {link[1].norm(), link[2].norm()};
  gap.link_numbers = {arm.link(turning[0]), arm.link(turning[1])};
  return between(p.norm(), std::abs(gap.links[0] - gap.links[1]), gap.links[0] + gap.links[1], gap);
}

// Spherical shoulder and wrist: the elbow alone determines the distance between them.
ReachGap gap_of_seven(const Reading& arm, const Isometry3d& G) {
  const CanonicalRows& rows = arm.rows;
  const Vector3d D = G.translation() - rows.h[6] * G.linear().col(2) - Vector3d(0, 0, rows.h[0]);
  const Vector3d m = placed(rows, 4, Vector3d(0, 0, rows.h[4]));
  const Angle& alpha = rows.alpha[3];
  const double z = m.z() + rows.h[3];
  const double a = rows.a[3];
  const double h = rows.h[2];
  const double middle = a * a + m.head<2>().squaredNorm() + z * z + h * h + 2.0 * h * alpha.c * z;
  const double A = 2.0 * (a * m.x() + h * alpha.s * m.y());
  const double B = 2.0 * (h * alpha.s * m.x() - a * m.y());
  const double swing = std::sqrt(A * A + B * B);
  ReachGap gap = centre_gap(rows);
  gap.from = arm.joint(rows.reversed ? 1 : 0);
  return between(D.norm(), std::sqrt(std::fmax(middle - swing, 0.0)), std::sqrt(middle + swing),
                 gap);
}

std::string_view name_of(GapPoint point) {
  switch (point) {
    case GapPoint::kToolPoint:
      return "the tool point";
    case GapPoint::kWristCentre:
      return "the wrist centre";
    case GapPoint::kShoulderCentre:
      return "seen from the tool, the shoulder centre";
    case GapPoint::kAxis:
      break;
  }
  return {};
}

}  // namespace

ReachGap ClosedForm::gap(const Isometry3d& T_world_tool, bool orientation_counts) const {
  if (hold_ != Hold::kNone || !exists()) return {};
  const CanonicalRows& rows = *rows_;
  const Reading arm{rows};
  const Isometry3d G = rows.goal(T_world_tool);
  switch (kind_) {
    case ClosedFormKind::kShoulder:
      return gap_of_shoulder(arm, G * rows.tool_point, rows.tool_point, {});
    case ClosedFormKind::kFewPosition:
      return gap_of_two(arm, G);
    case ClosedFormKind::kScara:
      return gap_of_scara(arm, G, orientation_counts);
    default:
      break;
  }
  if (!orientation_counts) return {};
  switch (kind_) {
    case ClosedFormKind::kPlane:
      return gap_of_plane(arm, G);
    case ClosedFormKind::kPlanarArmTwist:
      return gap_of_planar_arm(arm, G);
    case ClosedFormKind::kSphericalParallel:
    case ClosedFormKind::kSphericalMeeting:
      return gap_of_shoulder(arm, G.translation() - rows.h[5] * G.linear().col(2),
                             placed(rows, 3, Vector3d(0, 0, rows.h[3])), centre_gap(rows));
    case ClosedFormKind::kThreeParallel:
      return gap_of_three_parallel(arm, G);
    case ClosedFormKind::kShoulderElbowWrist:
      return gap_of_seven(arm, G);
    default:
      return {};
  }
}

std::string describe(const ReachGap& gap) {
  if (!gap.exists()) return {};
  const std::string point = gap.point == GapPoint::kAxis
                                ? fmt::format("the axis of joint {}", gap.axis + 1)
                                : std::string(name_of(gap.point));
  const std::string miss = format_mm(gap.miss);
  const int axis = gap.from + 1;
  const bool far = gap.kind == GapKind::kTooFar;
  switch (gap.kind) {
    case GapKind::kNone:
      break;
    case GapKind::kTooFar:
    case GapKind::kTooNear: {
      const int i = gap.link_numbers[0] + 1;
      const int j = gap.link_numbers[1] + 1;
      if (gap.links[1] > 0.0) {
        const std::string where =
            far ? fmt::format("beyond a{} + a{}", i, j) : fmt::format("inside |a{} - a{}|", i, j);
        return fmt::format("{} is {} {}: {} from axis {}, and links {} and {} are {} and {} long",
                           point, miss, where, format_mm(gap.distance), axis, i, j,
                           format_mm(gap.links[0]), format_mm(gap.links[1]));
      }
      return fmt::format("{} is {} {}: {} from where axes {} and {} meet, and {} is the {} it gets",
                         point, miss, far ? "beyond the stretched arm" : "inside the arm's hole",
                         format_mm(gap.distance), axis, axis + 1, format_mm(gap.limit),
                         far ? "farthest" : "nearest");
    }
    case GapKind::kTooClose:
      return fmt::format(
          "{} is {} too close to axis {}: {} from it, and the arm's offset keeps it "
          "{} away",
          point, miss, axis, format_mm(gap.distance), format_mm(gap.limit));
    case GapKind::kTooHigh:
      return fmt::format("{} is {} too far along axis {}", point, miss, axis);
    case GapKind::kOffPlane:
      return fmt::format("the goal is {} off the plane of the arm", miss);
  }
  return {};
}

}  // namespace armlet
