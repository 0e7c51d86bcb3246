#include "trajectory/tool/joined_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "armlet/trajectory/part.hpp"
#include "armlet/trajectory/profile.hpp"
#include "trajectory/tool/tool_travel.hpp"

namespace armlet {
namespace {

constexpr double kRotationLength = 0.2;  // m, equivalent length of a joint rotation by one radian
constexpr double kRotationPerPiece = 2.0 * std::numbers::pi / 180.0;
constexpr double kSlidePerPiece = 0.02;  // m
constexpr int kFewestPieces = 16;
constexpr int kCornerPieces = 18;
constexpr double kNothing = 1e-9;  // m

// The straight line in joint space, in pieces short enough for measuring the tool travel.
Trajectory line_in_pieces(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, double length,
                          int pieces) {
  std::vector<JointPath> joints;
  for (Eigen::Index i = 0; i < q0.size(); ++i) {
    JointPath path{.q_end = q1[i]};
    for (int k = 0; k < pieces; ++k) {
      const double start = length * k / pieces, end = length * (k + 1) / pieces;
      const double slope = (q1[i] - q0[i]) / length;
      path.segments.push_back({.start = start,
                               .duration = end - start,
                               .degree = 1,
                               .c = {q0[i] + slope * start, slope}});
    }
    joints.push_back(std::move(path));
  }
  return {std::move(joints), length};
}

// Three cubic pieces of equal length with the given value, slope and curvature at both ends and
// continuous curvature in between: the unknowns are the curvatures at the two knots.
std::vector<Segment> corner_pieces(const AxisState& from, const AxisState& to, double length) {
  const double h = length / 3.0;
  const double rise = (to.q - from.q - length * from.v) / (h * h) - 4.0 / 3.0 * from.a - to.a / 6.0;
  const double bend = (to.v - from.v) / h - 0.5 * (from.a + to.a);
  const std::array<double, 4> a = {from.a, rise - bend, 2.0 * bend - rise, to.a};
  std::vector<Segment> pieces;
  double q = from.q, v = from.v;
  for (std::size_t k = 0; k < 3; ++k) {
    const double jerk = (a[k + 1] - a[k]) / h;
    pieces.push_back({.start = h * static_cast<double>(k),
                      .duration = h,
                      .degree = 3,
                      .c = {q, v, 0.5 * a[k], jerk / 6.0}});
    q = pieces.back().value(h);
    v = pieces.back().value(h, 1);
  }
  return pieces;
}

// The corner from the end of one shortened part to the start of the next, in pieces.
Trajectory corner_between(const Trajectory& before, const Trajectory& behind, double r) {
  const double s0 = before.duration() - r, length = 2.0 * r;
  std::vector<JointPath> joints;
  for (int i = 0; i < before.n(); ++i) {
    const AxisState from{before.value(i, s0), before.value(i, s0, 1), before.value(i, s0, 2)};
    const AxisState to{behind.value(i, r), behind.value(i, r, 1), behind.value(i, r, 2)};
    joints.push_back({.segments = corner_pieces(from, to, length), .q_end = to.q});
  }
  const Trajectory whole(std::move(joints), length);
  Trajectory pieces = part_of(whole, 0.0, length / kCornerPieces);
  for (int k = 1; k < kCornerPieces; ++k) {
    pieces =
        pieces.then(part_of(whole, length * k / kCornerPieces, length * (k + 1) / kCornerPieces));
  }
  return pieces;
}

// The value of s at which `travel` has grown by `distance` from its start; at most its end.
double travelled(const std::vector<Segment>& travel, double distance) {
  for (const Segment& piece : travel) {
    if (piece.value(piece.duration) < distance) continue;
    double low = 0.0, high = piece.duration;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (piece.value(middle) < distance ? low : high) = middle;
    }
    return piece.start + low;
  }
  return travel.back().end();
}

}  // namespace

Trajectory joint_line(const Robot& robot, const Eigen::VectorXd& q0, const Eigen::VectorXd& q1) {
  double rotation = 0.0, slide = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    double& most = robot.is_revolute(i) ? rotation : slide;
    most = std::max(most, std::abs(q1[i] - q0[i]));
  }
  if (rotation == 0.0 && slide == 0.0) return Trajectory::at_rest(q0, 0.0);
  const double wanted = std::ceil(std::max(rotation / kRotationPerPiece, slide / kSlidePerPiece));
  const int pieces = std::max(kFewestPieces, static_cast<int>(wanted));
  const Segment last = tool_travel(robot, line_in_pieces(q0, q1, 1.0, pieces)).back();
  const double travel = last.value(last.duration);
  return line_in_pieces(q0, q1, std::max({travel, kRotationLength * rotation, slide}), pieces);
}

double JoinedPath::position(std::size_t part, double s) const {
  const double cut = part > 0 ? corner[part - 1] : 0.0;
  return std::clamp(from[part] + s - cut, from[part], to[part]);
}

JoinedPath join_rounded(std::span<const Trajectory> parts, std::span<const double> blends) {
  JoinedPath joined;
  double cut = 0.0;  // from the start of the part
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double r = k + 1 < parts.size() ? blends[k] : 0.0;
    const double end = parts[k].duration() - r;
    joined.from.push_back(joined.q.duration());
    if (k == 0) {
      joined.q = part_of(parts[k], 0.0, end);
    } else if (end - cut > kNothing) {
      joined.q = joined.q.then(part_of(parts[k], cut, end));
    }
    joined.to.push_back(joined.q.duration());
    joined.corner.push_back(r);
    if (r > 0.0) joined.q = joined.q.then(corner_between(parts[k], parts[k + 1], r));
    cut = r;
  }
  return joined;
}

double blend_at_start(const Robot& robot, const Trajectory& path, double blend) {
  return std::min(blend, travelled(tool_travel(robot, path), blend));
}

double blend_at_end(const Robot& robot, const Trajectory& path, double blend) {
  return blend_at_start(robot, path.reversed(), blend);
}

}  // namespace armlet
