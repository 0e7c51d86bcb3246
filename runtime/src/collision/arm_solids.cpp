#include "armlet/collision/arm_solids.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "math/solvers.hpp"

namespace armlet {
namespace {

constexpr int kPositions = 256;     // of the joints, tried for every pair
constexpr int kCloseLooks = 64;     // of these, bodies themselves are compared in so many
constexpr double kFarApart = 0.1;   // of the reach of the arm
constexpr double kStick = 0.003;    // m, radius
constexpr double kNoLength = 0.03;  // m, a hand that is shorter is none
constexpr double kHandRoom = 0.15;  // m, of the hand that an arm without one would have

// The shape of link i is given in the frame that moves with joint i before the row's constants
// (standard convention), or in the frame after it (modified).
Eigen::Isometry3d T_frame_link(const Robot& robot, int link) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  if (!standard || link == 0 || link > robot.n()) return Eigen::Isometry3d::Identity();
  return dh_pose(DhConvention::kStandard, robot.joint(link - 1).dh).inverse();
}

// The frame that joint k + 1 turns about or slides along, seen from frame k: its axis is z.
Eigen::Isometry3d T_frame_axis(const Robot& robot, int k) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  if (standard || k >= robot.n()) return Eigen::Isometry3d::Identity();
  return dh_pose(DhConvention::kModified, robot.joint(k).dh);
}

// From the axis of joint k to that of joint k + 1, counted from 1, but for the joint's own motion
// along and about the former.
Eigen::Isometry3d T_axis_next(const Robot& robot, int k) {
  return T_frame_link(robot, k).inverse() * T_frame_axis(robot, k);
}

constexpr double kSameAxis = 1e-9;

bool are_parallel(const Eigen::Isometry3d& T_axis_next) {
  return T_axis_next.linear().col(2).head<2>().norm() < kSameAxis;
}

// Whether the axes of joints k and k + 1 are one.
bool is_one_axis(const Robot& robot, int k) {
  const Eigen::Isometry3d T = T_axis_next(robot, k);
  return are_parallel(T) && T.translation().head<2>().norm() < kSameAxis;
}

// Whether only joints with parallel axes are between two frames. A joint table does not say where
// along these axes links are: most arms have them side by side, drawn from the table they lie in
// one plane.
bool may_be_side_by_side(const Robot& robot, int lower, int upper) {
  for (int k = lower + 1; k < upper; ++k) {
    if (!are_parallel(T_axis_next(robot, k))) return false;
  }
  return true;
}

// The first frame that moves on the axis on which frame k moves.
int first_on_axis(const Robot& robot, int k) {
  while (k > 1 && is_one_axis(robot, k - 1)) --k;
  return k;
}

// The way of a rod is inside of its sleeve; it ends where the link ends.
void cut_rod(const Robot& robot, const LinkShape& shape, Solid& solid) {
  const Eigen::Isometry3d T_link_next =
      T_frame_link(robot, shape.link).inverse() * T_frame_axis(robot, shape.link);
  const double middle = solid.T.translation().z();
  const double low = middle - solid.half.z();
  const double high =
      std::min(middle + solid.half.z(), std::max(T_link_next.translation().z(), 0.0));
  solid.T.translation().z() = 0.5 * (low + high);
  solid.half.z() = 0.5 * (high - low);
}

// The flange and a hand of no length.
bool is_left_out(const LinkShape& shape, bool bare) {
  return shape.role == LinkShapeRole::kMark || (bare && shape.role == LinkShapeRole::kFlange) ||
         (bare && is_hand(shape.role));
}

// Along the axis of the body, as far as the plane through the tool point, across the tool's axis.
//
// T_body_tool  the tool point, seen from the frame that the body is fixed to.
void make_stick(Solid& solid, const Eigen::Isometry3d& T_body_tool) {
  const Eigen::Vector3d along = solid.T.linear().col(2);
  const Eigen::Vector3d out = T_body_tool.linear().col(2);
  const auto beyond = [&](double z) {
    return (solid.T.translation() + z * along - T_body_tool.translation()).dot(out);
  };
  constexpr double kSame = 1e-9;  // m
  double low = -solid.half.z(), high = solid.half.z();
  const double at_low = beyond(low), at_high = beyond(high);
  if (at_low > kSame && at_high > kSame) {
    solid = {};
    return;
  }
  const double cut = low + (high - low) * at_low / (at_low - at_high);
  if (at_high > kSame) high = cut;
  if (at_low > kSame) low = cut;
  solid.T.translation() += 0.5 * (low + high) * along;
  solid = {.core = Solid::Core::kSegment,
           .half = {0.0, 0.0, 0.5 * (high - low)},
           .margin = kStick,
           .T = solid.T};
}

// Upper bound of the distance from the origin of frame k to the tool point, sliding joints being
// in.
double way_to_tool(const Robot& robot, int k) {
  double way = robot.T_flange_tool().translation().norm();
  for (int i = k; i < robot.n(); ++i) {
    const DhRow& row = robot.joint(i).dh;
    double d = row.d;
    if (!robot.is_revolute(i)) d = std::max({0.0, d + robot.lower()[i], -d - robot.upper()[i]});
    way += std::sqrt(row.a * row.a + d * d);
  }
  return way;
}

// Cuts off what is nearer to a point of its frame than `room`, along the axis of the body.
void clear_room(Solid& solid, const Eigen::Vector3d& p, double room) {
  const Eigen::Vector3d along = solid.T.linear().col(2);
  const Eigen::Vector3d middle = solid.T.translation() - p;
  double low = -solid.half.z(), high = solid.half.z();
  const bool is_low_in = (middle + low * along).norm() < room;
  const bool is_high_in = (middle + high * along).norm() < room;
  if (is_low_in && is_high_in) {
    solid = {};
    return;
  }
  if (!is_low_in && !is_high_in) return;
  // Where the axis passes through the ball of that radius.
  const double foot = -middle.dot(along);
  const double off = (middle + foot * along).squaredNorm();
  const double half_chord = std::sqrt(std::max(room * room - off, 0.0));
  if (is_high_in) high = std::min(high, foot - half_chord);
  if (is_low_in) low = std::max(low, foot + half_chord);
  solid.T.translation() += 0.5 * (low + high) * along;
  solid.half.z() = 0.5 * std::max(high - low, 0.0);
}

// Around both ends of the link that moves with frame k.
void leave_room_for_hand(const Robot& robot, int k, Solid& solid) {
  const bool standard = robot.spec().convention == DhConvention::kStandard;
  const int first = standard ? k - 1 : k;
  const Eigen::Vector3d ends[] = {
      standard ? T_frame_link(robot, k).translation() : Eigen::Vector3d(Eigen::Vector3d::Zero()),
      T_frame_axis(robot, k).translation()};
  for (int i = 0; i < 2; ++i) {
    const double room = kHandRoom - way_to_tool(robot, first + i);
    if (room > 0.0) clear_room(solid, ends[i], room + solid.margin);
  }
}

bool is_still(const Robot& robot, const LinkShape& shape) {
  if (shape.link == 0) return true;
  if (shape.link > 1 || !robot.is_revolute(0) || shape.kind == LinkShapeKind::kBox) return false;
  const Eigen::Isometry3d& T = shape.T_link_shape;
  return T.translation().head<2>().norm() + T.linear().col(2).head<2>().norm() < 1e-9;
}

// A tool that is a point alone is a needle from the flange to it.
void add_needle(const Robot& robot, std::vector<ArmSolid>& bodies) {
  constexpr double kThin = 5e-4;  // m
  const Eigen::Vector3d& p = robot.T_flange_tool().translation();
  const double length = p.norm();
  if (robot.tool().kind != ToolKind::kPoint || length < 2.0 * kThin) return;
  ArmSolid needle{.frame = robot.n(), .role = LinkShapeRole::kTool};
  needle.solid = {
      .core = Solid::Core::kSegment, .half = {0.0, 0.0, 0.5 * length - kThin}, .margin = kThin};
  needle.solid.T.linear() = rotation_from_z(p);
  needle.solid.T.translation() = 0.5 * p;
  bodies.push_back(needle);
}

// Of what joint `link` moves, counted from 1.
bool has_bodies(const Robot& robot, int link) {
  if (link <= 0 || link > robot.n() || robot.spec().links.empty()) return false;
  const Link& own = robot.link(link - 1);
  return !own.bodies.empty() || !own.solids.empty();
}

Solid solid_of(const LinkSolid& body) {
  Solid solid;
  switch (body.kind) {
    case LinkSolidKind::kBox:
      solid = {.core = Solid::Core::kBox, .half = 0.5 * body.size};
      break;
    case LinkSolidKind::kCylinder:
      solid = {.core = Solid::Core::kCylinder,
               .half = {body.size.x(), body.size.x(), 0.5 * body.size.y()}};
      break;
    case LinkSolidKind::kSphere:
      solid = {.margin = body.size.x()};
      break;
  }
  solid.T = body.T_link_solid;
  return solid;
}

void add_bodies(const Robot& robot, std::vector<ArmSolid>& bodies) {
  for (int link = 1; link <= robot.n(); ++link) {
    if (!has_bodies(robot, link)) continue;
    for (const LinkSolid& each : robot.link(link - 1).solids)
      bodies.push_back({.frame = link, .solid = solid_of(each)});
    for (const LinkMesh& each : robot.link(link - 1).bodies) {
      ArmSolid body{.frame = link, .solid = solid_of(*each.triangles)};
      body.solid.T = each.T_link_mesh;
      bodies.push_back(std::move(body));
    }
  }
}

// Hands and fingers are what they are drawn as.
bool ends_bare(const Robot& robot) {
  return robot.spec().role == RobotRole::kArm && robot.tool().length < kNoLength;
}

std::vector<ArmSolid> bodies_of(const Robot& robot, bool bare) {
  const std::vector<Eigen::Isometry3d> frames = link_frames(robot, robot.home());
  const Eigen::Isometry3d T_world_tool = forward(robot, robot.home());
  std::vector<ArmSolid> bodies;
  for (const LinkShape& shape : link_shapes(robot)) {
    if (is_left_out(shape, bare) || has_bodies(robot, shape.link)) continue;
    ArmSolid body{.frame = std::min(shape.link, robot.n()),
                  .role = shape.role,
                  .solid = solid_of(shape),
                  .still = is_still(robot, shape)};
    if (body.solid.is_empty()) continue;
    const bool is_rod = shape.link > 0 && shape.role == LinkShapeRole::kLink &&
                        shape.kind == LinkShapeKind::kCylinder &&
                        !robot.is_revolute(shape.link - 1);
    if (is_rod) cut_rod(robot, shape, body.solid);
    body.solid.T = T_frame_link(robot, shape.link) * body.solid.T;
    if (bare && body.frame >= first_on_axis(robot, robot.n())) {
      const Eigen::Isometry3d& T_world_frame = frames[static_cast<std::size_t>(body.frame - 1)];
      make_stick(body.solid, T_world_frame.inverse() * T_world_tool);
    } else if (bare && body.frame > 0) {
      leave_room_for_hand(robot, body.frame, body.solid);
    }
    if (body.solid.is_empty()) continue;
    bodies.push_back(std::move(body));
  }
  add_bodies(robot, bodies);
  if (bare) add_needle(robot, bodies);
  return bodies;
}

// Half as thick. Shapes that follow from a joint table are thicker than most arms: a forearm passes
// a column that it would cut as drawn.
std::vector<ArmSolid> slimmed(std::vector<ArmSolid> bodies) {
  for (ArmSolid& each : bodies) {
    Solid& solid = each.solid;
    if (solid.core == Solid::Core::kSegment) solid.margin *= 0.5;
    if (solid.core == Solid::Core::kCylinder) solid.half.head<2>() *= 0.5;
  }
  return bodies;
}

// Within the limits; a joint without one turns once or slides by the length of the arm.
Eigen::VectorXd random_position(const Robot& robot, Random& random) {
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i) {
    const double most = robot.is_revolute(i) ? std::numbers::pi : robot.length();
    double low = robot.lower()[i], high = robot.upper()[i];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      low = std::isfinite(low) ? low : std::isfinite(high) ? high - 2.0 * most : -most;
      high = std::isfinite(high) ? high : low + 2.0 * most;
    }
    q[i] = random.uniform(low, high);
  }
  return q;
}

struct OwnPair {
  std::pair<int, int> bodies;
  int overlaps = 0;
  bool comes_near = false;
  bool overlaps_at_home = false;
};

class OwnPairs {
 public:
  OwnPairs(const Robot& robot, const std::vector<ArmSolid>& bodies)
      : robot_(robot), bodies_(bodies), frames_(static_cast<std::size_t>(robot.n())) {
    for (const ArmSolid& each : bodies) placed_.push_back(each.solid);
    for (int a = 0; a < static_cast<int>(bodies.size()); ++a) {
      for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        if (frame(b) < first_on_axis(robot, std::max(frame(a), 1)) - 1 &&
            !may_be_side_by_side(robot, frame(b), frame(a)))
          pairs_.push_back({.bodies = {a, b}});
      }
    }
  }

  std::vector<std::pair<int, int>> find() {
    place(robot_.home());
    for (OwnPair& each : pairs_) each.overlaps_at_home = !is_free(each);
    Random random(0x61726d6c6574);
    for (int k = 0; k < kPositions; ++k) {
      place(random_position(robot_, random));
      for (OwnPair& each : pairs_) look(each, k < kCloseLooks);
    }
    std::vector<std::pair<int, int>> found;
    for (const OwnPair& each : pairs_) {
      const bool mostly = 2 * each.overlaps > kCloseLooks;
      if (each.comes_near && !mostly && !each.overlaps_at_home) found.push_back(each.bodies);
    }
    return found;
  }

 private:
  [[nodiscard]] int frame(int body) const { return bodies_[static_cast<std::size_t>(body)].frame; }
  [[nodiscard]] const Solid& placed(int body) const {
    return placed_[static_cast<std::size_t>(body)];
  }

  void place(const Eigen::VectorXd& q) {
    (void)link_frames(robot_, q, frames_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const int k = bodies_[i].frame;
      placed_[i].T = (k == 0 ? robot_.T_world_base() : frames_[static_cast<std::size_t>(k - 1)]) *
                     bodies_[i].solid.T;
    }
  }

  // Distance of the balls around both.
  [[nodiscard]] double apart(const OwnPair& pair) const {
    const Solid &a = placed(pair.bodies.first), &b = placed(pair.bodies.second);
    return (a.T.translation() - b.T.translation()).norm() - a.reach() - b.reach();
  }
  [[nodiscard]] bool is_free(const OwnPair& pair) const {
    return apart(pair) > 0.0 ||
           is_farther(placed(pair.bodies.first), placed(pair.bodies.second), 0.0);
  }
  void look(OwnPair& pair, bool closely) const {
    const double gap = apart(pair);
    pair.comes_near = pair.comes_near || gap < kFarApart * robot_.reach();
    if (closely && gap <= 0.0 && !is_free(pair)) ++pair.overlaps;
  }

  const Robot& robot_;
  const std::vector<ArmSolid>& bodies_;
  std::vector<Eigen::Isometry3d> frames_;
  std::vector<Solid> placed_;
  std::vector<OwnPair> pairs_;
};

}  // namespace

ArmSolids::ArmSolids(const Robot& robot)
    : solids_(bodies_of(robot, ends_bare(robot))),
      slim_(slimmed(solids_)),
      own_pairs_(OwnPairs(robot, slim_).find()),
      neighbour_of_last_(first_on_axis(robot, robot.n()) - 1),
      is_bare_(ends_bare(robot)) {}

}  // namespace armlet
