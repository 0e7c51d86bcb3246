// Curves that the tool can follow: a pose for every fraction of the length.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <variant>
#include <vector>

#include "armlet/math/twist.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Circle through three points, from the first over the second to the third.
struct Arc {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d e = Eigen::Vector3d::UnitX();  // towards the first point
  Eigen::Vector3d f = Eigen::Vector3d::UnitY();  // direction at the start
  double radius = 0.0;                           // m
  double sweep = 0.0;                            // rad, above 0 and below 2 pi

  [[nodiscard]] Eigen::Vector3d at(double fraction) const;
};

// Nothing if the three points are on one line or two of them are the same.
std::optional<Arc> arc_through(const Eigen::Vector3d& p1, const Eigen::Vector3d& p2,
                               const Eigen::Vector3d& p3);

// Position and rotation with two derivatives by length: [m; rad].
struct CurveState {
  Vector6d x, slope, curvature;
};

// A part of a curve, straight or on a circle; the orientation rotates about one fixed axis.
//
// length    m; for rotations without translation, an equivalent length.
// from, to  the part of it that is used, as fractions.
struct CurvePiece {
  Eigen::Isometry3d T_start = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_end = Eigen::Isometry3d::Identity();
  double length = 0.0;
  Arc arc{};  // if its radius is above zero
  double from = 0.0;
  double to = 1.0;

  [[nodiscard]] bool is_round() const { return arc.radius > 0.0; }
  // Travel of the tool point, m, without the equivalent length of rotations.
  [[nodiscard]] double travel() const;
  // The length by which a blend is measured, m: travel, or the equivalent length of a rotation
  // (nearly) without translation.
  [[nodiscard]] double measure() const;
  [[nodiscard]] Eigen::Isometry3d at(double fraction) const;
  // Relative to the pose at the start (fraction 0) or at the end (1): positions in the world's
  // axes, rotations in those of that pose.
  [[nodiscard]] CurveState state_from_start(double fraction) const;
  [[nodiscard]] CurveState state_from_end(double fraction) const;
};

CurvePiece straight_piece(const Eigen::Isometry3d& T_start, const Eigen::Isometry3d& T_end);
CurvePiece arc_piece(const Eigen::Isometry3d& T_start, const Eigen::Isometry3d& T_end,
                     const Arc& arc);

// The arc through p_via; nothing for the reasons of no_circle_over.
std::optional<CurvePiece> piece_over(const Eigen::Isometry3d& T_start, const Eigen::Vector3d& p_via,
                                     const Eigen::Isometry3d& T_end);

// The path round a corner: quintics from one state to another, both relative to the corner. Between
// straight pieces these are P - r d1 + 2 r (d1 u + (d2 - d1)(u^3 - u^4 / 2)), where r is the travel
// of the tool point in either piece.
//
// before, after  derivatives by the travel of the tool point.
// reach          2 r, m.
// length         of the corner as a part of a curve, m. In pieces whose rotation has a larger
//                equivalent length than their travel, a metre of travel has a length above 1; the
//                corner changes smoothly from that of one piece to that of the other.
// enters, leaves  the derivative of u by the fraction of the length at both ends; their sum is 2.
struct CurveCorner {
  Eigen::Isometry3d T_corner = Eigen::Isometry3d::Identity();
  CurveState before, after;
  double reach = 0.0;
  double length = 0.0;
  double enters = 1.0, leaves = 1.0;

  [[nodiscard]] Eigen::Isometry3d at(double fraction) const;
  // The pose at u = 1/2, which is next to the corner between straight pieces.
  [[nodiscard]] Eigen::Isometry3d middle() const { return at_share(0.5); }

 private:
  [[nodiscard]] Eigen::Isometry3d at_share(double u) const;
};

// The corner between two pieces, each of which it shortens by `blend` of its travel, or by half of
// it if that is less. For a rotation without translation the equivalent length replaces travel.
CurveCorner cut_corner(CurvePiece& before, CurvePiece& behind, double blend);

// A curve through poses in a time from 0 to 1: piecewise polynomials of the position (relative to
// the first pose, in the world's axes) and of the rotation vector (relative to the first pose).
struct CurveSpline {
  Eigen::Isometry3d T_start = Eigen::Isometry3d::Identity();
  std::array<std::vector<Segment>, 6> x{};

  [[nodiscard]] Eigen::Isometry3d at(double time) const;
};

// Travel of the tool point on a curve, m, as the sum of a number of chords; `at` gives its poses
// from 0 to 1.
template <class Curve>
double chord_length(const Curve& curve, int chords) {
  double length = 0.0;
  Eigen::Vector3d before = curve.at(0.0).translation();
  for (int k = 1; k <= chords; ++k) {
    const Eigen::Vector3d p = curve.at(static_cast<double>(k) / chords).translation();
    length += (p - before).norm();
    before = p;
  }
  return length;
}

// A curve of consecutive pieces.
class PoseCurve {
 public:
  void add(const CurvePiece& piece);
  void add(const CurveCorner& corner);
  // Adds the only part of a curve; its fractions are times.
  void add(CurveSpline spline);

  [[nodiscard]] double length() const { return starts_.back(); }
  [[nodiscard]] Eigen::Isometry3d at(double fraction) const;

 private:
  std::vector<std::variant<CurvePiece, CurveCorner, CurveSpline>> parts_;
  std::vector<double> starts_ = {0.0};  // m; the last is the end
};

}  // namespace armlet
