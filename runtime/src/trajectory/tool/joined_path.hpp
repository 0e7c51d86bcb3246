// Consecutive joint paths with rounded corners between them.
#pragma once

#include <span>
#include <vector>

#include "armlet/model/robot.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// The straight line in joint space from q0 to q1, as a function of the length s of the path: the
// travel of the tool point, m, or the equivalent length of the joint rotations if that is larger.
// Duration 0 if q0 is q1.
Trajectory joint_line(const Robot& robot, const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);

// Joined parts of a path, each a function of its own length s from 0 on.
//
// q       the joint path of the whole.
// from    position on the whole at which each part begins after its corner, m, and
// to      at which it ends before the next.
// corner  length by which the corner after each part shortens it and the next, m; 0 for the last.
struct JoinedPath {
  Trajectory q{};
  std::vector<double> from{}, to{}, corner{};

  // Position on the whole of a position on a part, within the shortened part.
  [[nodiscard]] double position(std::size_t part, double s) const;
};

// Joins the parts; each starts where the one before it ends. A corner is a cubic spline of three
// pieces with the values, slopes and curvatures of both sides at its ends.
//
// blends  largest distance of the corner after each part from the end of the part, m, above 0; one
//         fewer than there are parts.
JoinedPath join_rounded(std::span<const Trajectory> parts, std::span<const double> blends);

// The first position on a path from which the tool point travels at most `blend` metres to its end;
// the same at its start.
double blend_at_end(const Robot& robot, const Trajectory& path, double blend);
double blend_at_start(const Robot& robot, const Trajectory& path, double blend);

}  // namespace armlet
