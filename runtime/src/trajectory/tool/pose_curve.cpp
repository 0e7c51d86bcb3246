#include "trajectory/tool/pose_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/trajectory/cartesian_path.hpp"
#include "armlet/trajectory/profile.hpp"

namespace armlet {
namespace {

// m, equivalent length of a rotation by one radian without translation
constexpr double kRotationLength = 0.2;
// m: with a shorter travel it counts as a rotation without translation
constexpr double kRotatesInPlace = 1e-3;

}  // namespace

Eigen::Vector3d Arc::at(double fraction) const {
  const auto [s, c] = det::sincos(sweep * fraction);
  return centre + radius * (c * e + s * f);
}

std::optional<Arc> arc_through(const Eigen::Vector3d& p1, const Eigen::Vector3d& p2,
                               const Eigen::Vector3d& p3) {
  const Eigen::Vector3d u = p2 - p1;
  const Eigen::Vector3d v = p3 - p1;
  const Eigen::Vector3d normal = u.cross(v);
  const double size = normal.norm();
  if (!(size > 1e-9 * u.norm() * v.norm()) || !((p3 - p2).norm() > 0.0)) return std::nullopt;
  const Eigen::Vector3d to_centre =
      (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) / (2.0 * size * size);
  Arc arc;
  arc.centre = p1 + to_centre;
  arc.radius = to_centre.norm();
  arc.e = -to_centre / arc.radius;
  arc.f = (normal / size).cross(arc.e);
  const Eigen::Vector3d last = p3 - arc.centre;
  arc.sweep = det::atan2(last.dot(arc.f), last.dot(arc.e));
  // In this direction of rotation the second point comes before the third.
  if (arc.sweep <= 0.0) arc.sweep += 2.0 * std::numbers::pi;
  return arc;
}

double CurvePiece::travel() const {
  if (is_round()) return arc.radius * arc.sweep;
  return (T_end.translation() - T_start.translation()).norm();
}

double CurvePiece::measure() const {
  const double way = travel();
  return way >= kRotatesInPlace ? way : length;
}

Eigen::Isometry3d CurvePiece::at(double fraction) const {
  Eigen::Isometry3d T = interpolate(T_start, T_end, fraction);
  if (is_round()) T.translation() = arc.at(fraction);
  return T;
}

namespace {

CurveState state_at(const CurvePiece& piece, double fraction, double anchor) {
  CurveState state{Vector6d::Zero(), Vector6d::Zero(), Vector6d::Zero()};
  const Eigen::Vector3d position = piece.at(fraction).translation();
  state.x.head<3>() = position - piece.at(anchor).translation();
  // The axis of the rotation is the same in the axes of all orientations of the arc.
  const Eigen::Vector3d rotation =
      rotation_log(piece.T_start.linear().transpose() * piece.T_end.linear());
  state.x.tail<3>() = (fraction - anchor) * rotation;
  state.slope.tail<3>() = rotation / piece.length;
  if (piece.is_round()) {
    const Arc& arc = piece.arc;
    const auto [s, c] = det::sincos(arc.sweep * fraction);
    const double rate = arc.sweep / piece.length;
    state.slope.head<3>() = arc.radius * rate * (c * arc.f - s * arc.e);
    state.curvature.head<3>() = -rate * rate * (position - arc.centre);
  } else {
    state.slope.head<3>() =
        (piece.T_end.translation() - piece.T_start.translation()) / piece.length;
  }
  return state;
}

}  // namespace

CurveState CurvePiece::state_from_start(double fraction) const {
  return state_at(*this, fraction, 0.0);
}

CurveState CurvePiece::state_from_end(double fraction) const {
  return state_at(*this, fraction, 1.0);
}

CurvePiece straight_piece(const Eigen::Isometry3d& T_start, const Eigen::Isometry3d& T_end) {
  const double distance = (T_end.translation() - T_start.translation()).norm();
  return {.T_start = T_start,
          .T_end = T_end,
          .length = std::max(distance, kRotationLength * angle_between(T_start, T_end))};
}

CurvePiece arc_piece(const Eigen::Isometry3d& T_start, const Eigen::Isometry3d& T_end,
                     const Arc& arc) {
  return {
      .T_start = T_start,
      .T_end = T_end,
      .length = std::max(arc.radius * arc.sweep, kRotationLength * angle_between(T_start, T_end)),
      .arc = arc};
}

std::optional<CurvePiece> piece_over(const Eigen::Isometry3d& T_start, const Eigen::Vector3d& p_via,
                                     const Eigen::Isometry3d& T_end) {
  const Eigen::Vector3d &p1 = T_start.translation(), &p3 = T_end.translation();
  if (no_circle_over(p1, p_via, p3)) return std::nullopt;
  return arc_piece(T_start, T_end, *arc_through(p1, p_via, p3));
}

namespace {

// Converts derivatives by length to derivatives by travel.
CurveState by_measure(CurveState state, const CurvePiece& piece) {
  const double rate = piece.length / piece.measure();
  state.slope *= rate;
  state.curvature *= rate * rate;
  return state;
}

}  // namespace

CurveCorner cut_corner(CurvePiece& before, CurvePiece& behind, double blend) {
  const double r = std::min({blend, 0.5 * before.measure(), 0.5 * behind.measure()});
  before.to = 1.0 - r / before.measure();
  behind.from = r / behind.measure();
  const double first = before.length / before.measure();
  const double second = behind.length / behind.measure();
  CurveCorner corner{.T_corner = before.T_end,
                     .before = by_measure(before.state_from_end(before.to), before),
                     .after = by_measure(behind.state_from_start(behind.from), behind),
                     .reach = 2.0 * r,
                     .length = 4.0 * r / (1.0 / first + 1.0 / second)};
  corner.enters = 2.0 * second / (first + second);
  corner.leaves = 2.0 * first / (first + second);
  return corner;
}

// The share grows at a rate that changes from `enters` to `leaves` and is constant to first order
// at both ends, so that speeds and accelerations along the curve are continuous.
Eigen::Isometry3d CurveCorner::at(double fraction) const {
  const double x = fraction;
  return at_share(enters * x + (leaves - enters) * x * x * x * (1.0 - 0.5 * x));
}

Eigen::Isometry3d CurveCorner::at_share(double u) const {
  Vector6d x;
  for (int i = 0; i < 6; ++i) {
    x[i] = quintic_segment({before.x[i], before.slope[i], before.curvature[i]},
                           {after.x[i], after.slope[i], after.curvature[i]}, reach)
               .value(u * reach);
  }
  return make_pose(T_corner.linear() * rotation_exp(x.tail<3>()),
                   T_corner.translation() + x.head<3>());
}

Eigen::Isometry3d CurveSpline::at(double time) const {
  Vector6d now;
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::size_t k = 0;
    while (k + 1 < x[i].size() && x[i][k + 1].start <= time) ++k;
    now[static_cast<Eigen::Index>(i)] = x[i][k].value(time - x[i][k].start);
  }
  return make_pose(T_start.linear() * rotation_exp(now.tail<3>()),
                   T_start.translation() + now.head<3>());
}

void PoseCurve::add(const CurvePiece& piece) {
  const double length = (piece.to - piece.from) * piece.length;
  if (!(length > 0.0)) return;
  parts_.emplace_back(piece);
  starts_.push_back(starts_.back() + length);
}

void PoseCurve::add(const CurveCorner& corner) {
  parts_.emplace_back(corner);
  starts_.push_back(starts_.back() + corner.length);
}

void PoseCurve::add(CurveSpline spline) {
  parts_.emplace_back(std::move(spline));
  starts_.push_back(starts_.back() + 1.0);
}

Eigen::Isometry3d PoseCurve::at(double fraction) const {
  const double s = fraction * length();
  const auto after = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, s);
  const auto k = static_cast<std::size_t>(after - starts_.begin()) - 1;
  const double u = std::min((s - starts_[k]) / (starts_[k + 1] - starts_[k]), 1.0);
  if (const auto* corner = std::get_if<CurveCorner>(&parts_[k])) return corner->at(u);
  if (const auto* spline = std::get_if<CurveSpline>(&parts_[k])) return spline->at(u);
  const auto& piece = std::get<CurvePiece>(parts_[k]);
  return piece.at(u == 1.0 ? piece.to : piece.from + u * (piece.to - piece.from));
}

}  // namespace armlet
