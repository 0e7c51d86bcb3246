// Paths of the joints one after another, with rounded corners between them.
#pragma once

#include <span>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// All joints from q0 to q1 in one proportion, as a function of the length s of the path: what the
// tool point travels, m, or what the angles of the joints count for if that is more. No duration if
// q0 is q1.
Trajectory joint_line(const Robot& robot, const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);

// Parts of a path as one, each a function of its own length s from 0 on.
//
// q       of the whole.
// from    where on the whole each part begins behind its corner, m, and
// to      where it ends before the next.
// corner  what the corner behind each part takes away of it and of the next, m; 0 for the last.
struct JoinedPath {
  Trajectory q{};
  std::vector<double> from{}, to{}, corner{};

  // Where on the whole a position on a part is; within the part's own stretch.
  [[nodiscard]] double position(std::size_t part, double s) const;
};

// Joins the parts; each starts where the one before it ends. A corner is a cubic
// spline of three pieces that takes over values, slopes and curvatures of both sides.
//
// blends  how far from its end the corner behind each part may begin, m, above 0; one fewer than
//         there are parts.
JoinedPath join_rounded(std::span<const Trajectory> parts, std::span<const double> blends);

// The position on a path from which on the tool point travels no more than `blend` metres until its
// end; or from its start.
double blend_at_end(const Robot& robot, const Trajectory& path, double blend);
double blend_at_start(const Robot& robot, const Trajectory& path, double blend);

}  // namespace armlet
