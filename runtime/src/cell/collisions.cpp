#include "armlet/cell/collisions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "armlet/collision/own_pairs.hpp"
#include "armlet/kinematics/forward.hpp"
#include "cell/arm_bodies.hpp"
#include "cell/finger_collisions.hpp"

namespace armlet {
namespace {

// Whether a body closes on an object, or reaches into it. The palm of a gripper does not.
bool takes_hold(const Robot& arm, const ArmSolid& body) {
  const ArmSolids& solids = arm.derived<ArmSolids>();
  if (solids.is_bare()) return body.frame > solids.neighbour_of_last();
  return arm.tool().kind == ToolKind::kParallelGripper ? is_finger(body.role) : is_hand(body.role);
}

// Objects this near to the tool point count as between the fingers of a gripper, which may touch
// them.
constexpr double kAmongFingers = 0.05;  // m

// Whether contact forces on a body of the arm are measured; the rod of an arm without a gripper
// ends in the tool point.
bool is_feeler(const Robot& arm, int frame, LinkShapeRole role) {
  const ArmSolids& solids = arm.derived<ArmSolids>();
  return is_hand(role) || (solids.is_bare() && frame > solids.neighbour_of_last());
}

// A robot, the hand with fingers on it, and what it carries, as bodies of a scene.
struct ArmBodies {
  std::vector<ArmSolid> solids;
  std::vector<CellBody> bodies;
  std::size_t own = 0;      // the first ones are its own
  std::size_t carried = 0;  // index of the first carried body; those of the gripper come before it
};

// Adds a hand with fingers in its present state, fixed to the last frame of the arm.
void add_hand(const Cell& cell, int arm, ArmBodies& to) {
  const int n = cell.robot(arm).model->rows();
  for (int i = 0; i < cell.robot_count(); ++i) {
    const CellRobot& part = cell.robot(i);
    if (part.on != arm) continue;
    const std::vector<Eigen::Isometry3d> frames = link_frames(*part.model, part.q);
    for (const ArmSolid& each : part.model->derived<ArmSolids>().solids()) {
      ArmSolid body{.frame = n, .role = each.role, .solid = each.solid};
      body.solid.T = (each.frame == 0 ? part.model->T_world_base()
                                      : frames[static_cast<std::size_t>(each.frame - 1)]) *
                     each.solid.T;
      to.solids.push_back(std::move(body));
      to.bodies.push_back({.robot = i, .frame = each.frame, .role = each.role});
    }
  }
}

ArmBodies bodies_of(const Cell& cell, int robot) {
  const Robot& model = *cell.robot(robot).model;
  ArmBodies arm{.solids = model.derived<ArmSolids>().solids()};
  for (const ArmSolid& each : arm.solids)
    arm.bodies.push_back({.robot = robot, .frame = each.frame, .role = each.role});
  close_fingers(cell.robot(robot), cell.world(), arm.solids);
  arm.own = arm.solids.size();
  if (model.tool().kind == ToolKind::kFingers) add_hand(cell, robot, arm);
  arm.carried = arm.solids.size();
  const World& world = cell.world();
  for (const std::size_t i : world.carried()) {
    const auto& attachment = world.attachment_of(i);
    if (attachment->carrier != robot) continue;
    Solid solid = solid_of(world.object(i).shape);
    solid.T = attachment->T_carrier_obj;
    const int frame = attachment->frame == kFlange ? model.rows() : attachment->frame;
    arm.solids.push_back({.frame = frame, .solid = solid, .still = frame == 0});
    arm.bodies.push_back({.robot = robot, .object = world.object(i).name, .frame = frame});
  }
  return arm;
}

// The bodies of a robot in their present poses, in the world.
std::vector<Solid> placed(const Cell& cell, int robot, const std::vector<ArmSolid>& solids) {
  const CellRobot& arm = cell.robot(robot);
  const std::vector<Eigen::Isometry3d> frames = link_frames(*arm.model, arm.q);
  std::vector<Solid> all;
  for (const ArmSolid& each : solids) {
    Solid solid = each.solid;
    solid.T = (each.frame == 0 ? arm.model->T_world_base()
                               : frames[static_cast<std::size_t>(each.frame - 1)]) *
              each.solid.T;
    if (arm.on >= 0) solid.T = cell.T_world_flange(arm.on) * solid.T;
    all.push_back(std::move(solid));
  }
  return all;
}

class CellScene {
 public:
  CellScene(const Cell& cell, int robot, const Trajectory& motion)
      : cell_(cell),
        robot_(robot),
        arm_(*cell.robot(robot).model),
        mine_(bodies_of(cell, robot)),
        p_start_(forward(arm_, motion.start()).translation()),
        end_(motion.end()),
        p_end_(forward(arm_, end_).translation()) {
    scene_.arms.push_back({.robot = &arm_, .motion = &motion, .solids = mine_.solids});
    scene_.duration = motion.duration();
    names_.push_back(mine_.bodies);
    add_objects();
    for (int other = 0; other < cell.robot_count(); ++other) {
      if (other != robot && cell.robot(other).on < 0) add_robot(other);
    }
    add_own_pairs();
  }

  [[nodiscard]] const MotionScene& scene() const { return scene_; }
  [[nodiscard]] const CellBody& body(const BodyRef& ref) const {
    const auto index = static_cast<std::size_t>(ref.index);
    return ref.arm == BodyRef::kFixed ? fixed_names_[index]
                                      : names_[static_cast<std::size_t>(ref.arm)][index];
  }

 private:
  void add_objects() {
    const World& world = cell_.world();
    for (std::size_t i = 0; i < world.size(); ++i) {
      if (world.attachment_of(i)) continue;
      const Object& object = world.object(i);
      Solid solid = solid_of(object.shape);
      solid.T = object.T_world_obj;
      add_fixed(std::move(solid), {.object = object.name}, takes_here(object));
    }
  }

  // Whether the gripper of this robot takes the object, or has released it, at an end of the
  // motion.
  [[nodiscard]] bool takes_here(const Object& object) const {
    const Tool& hand = arm_.tool();
    const bool has_fingers = hand.kind == ToolKind::kFingers;
    if (object.fixed || !(hand.can_grasp() || has_fingers)) return false;
    return std::min(grasp_distance(object, p_start_), grasp_distance(object, p_end_)) <=
           (has_fingers ? kAmongFingers : hand.grasp_distance);
  }

  void add_fixed(Solid solid, CellBody name, bool is_taken) {
    const BodyRef other{BodyRef::kFixed, static_cast<int>(scene_.fixed.size())};
    scene_.fixed.push_back(std::move(solid));
    fixed_names_.push_back(std::move(name));
    pair_with(other, is_taken, false);
  }

  // Adds the pairs of all bodies of the moving robot with another body.
  //
  // moves  the other body moves too, so that the base has to be checked.
  void pair_with(const BodyRef& other, bool is_taken, bool moves) {
    const CellBody name_of_other = body(other);
    for (std::size_t i = 0; i < mine_.solids.size(); ++i) {
      const bool carried = i >= mine_.carried;
      if (!moves && mine_.solids[i].still) continue;
      if (is_taken && !carried && takes_hold(arm_, mine_.solids[i])) continue;
      if (carried && holds(name_of_other, mine_.bodies[i].object)) continue;
      const bool touches = !name_of_other.object.empty() &&
                           is_feeler(arm_, mine_.bodies[i].frame, mine_.bodies[i].role);
      const bool leaving = carried || touches;
      scene_.pairs.push_back({.a = {0, static_cast<int>(i)}, .b = other, .leaving = leaving});
    }
  }

  // Whether the body belongs to another gripper that holds the same object.
  [[nodiscard]] bool holds(const CellBody& name, const std::string& object) const {
    if (name.robot < 0 || !name.object.empty()) return false;
    const CellRobot& other = cell_.robot(name.robot);
    return other.held == object &&
           takes_hold(*other.model, {.frame = name.frame, .role = name.role});
  }

  void add_robot(int other) {
    const CellRobot& state = cell_.robot(other);
    ArmBodies theirs = bodies_of(cell_, other);
    if (stand_in_each_other(other, theirs)) return;
    // An object that this gripper holds or takes may be in the gripper of another robot.
    const auto is_taken = [&](const CellBody& body) {
      if (body.object.empty()) return false;
      return body.object == cell_.robot(robot_).held || takes_here(cell_.world().at(body.object));
    };
    if (!state.motion) {
      std::vector<Solid> solids = placed(cell_, other, theirs.solids);
      for (std::size_t i = 0; i < solids.size(); ++i) {
        const bool taken = is_taken(theirs.bodies[i]);
        add_fixed(std::move(solids[i]), std::move(theirs.bodies[i]), taken);
      }
      return;
    }
    const Motion& motion = *state.motion;
    const int arm = static_cast<int>(scene_.arms.size());
    scene_.arms.push_back({.robot = state.model.get(),
                           .motion = &motion.trajectory(),
                           .from = to_seconds(cell_.now_ns() - motion.start_ns()),
                           .solids = theirs.solids});
    // A collision may occur after the first robot has come to rest.
    scene_.duration = std::max(scene_.duration, to_seconds(motion.end_ns() - cell_.now_ns()));
    names_.push_back(theirs.bodies);
    for (std::size_t i = 0; i < theirs.solids.size(); ++i)
      pair_with({arm, static_cast<int>(i)}, is_taken(theirs.bodies[i]), !theirs.solids[i].still);
  }

  // Arms whose bases overlap cannot exist together: they are taken for alternatives. Tables and
  // frames of bases may overlap.
  [[nodiscard]] bool stand_in_each_other(int other, const ArmBodies& theirs) const {
    const auto base_of = [&](int robot, const ArmBodies& bodies) {
      std::vector<ArmSolid> still;
      for (std::size_t i = 0; i < bodies.own; ++i) {
        const ArmSolid& each = bodies.solids[i];
        if (each.still && (each.frame > 0 || !each.given)) still.push_back(each);
      }
      for (const Solid& each : cell_.robot(robot).model->derived<ArmSolids>().pedestal())
        still.push_back({.solid = each});
      return placed(cell_, robot, still);
    };
    for (const Solid& a : base_of(robot_, mine_)) {
      for (const Solid& b : base_of(other, theirs)) {
        if (gap_between(a, b).distance < -kSoft) return true;
      }
    }
    return false;
  }

  // Adds the pairs of its slim links, and of what it carries with all links except the last.
  void add_own_pairs() {
    const ArmSolids& arm = arm_.derived<ArmSolids>();
    const int slim = static_cast<int>(mine_.solids.size());
    for (std::size_t i = 0; i < mine_.own; ++i) {
      scene_.arms[0].solids.push_back(arm.slim()[i]);
      names_[0].push_back(mine_.bodies[i]);
    }
    for (const auto& [first, second] : arm_.derived<OwnPairs>().pairs())
      scene_.pairs.push_back({.a = {0, slim + first}, .b = {0, slim + second}});
    for (std::size_t i = mine_.carried; i < mine_.solids.size(); ++i) add_own_pairs_of(i);
  }

  // Pairs of what the robot carries on one link with its other bodies. Neighbours of that link, and
  // objects that a gripper takes where the motion begins or ends, are left out.
  void add_own_pairs_of(std::size_t i) {
    const ArmSolids& arm = arm_.derived<ArmSolids>();
    const int slim = static_cast<int>(scene_.arms[0].solids.size() - mine_.own);
    const int frame = mine_.solids[i].frame;
    const bool on_last = frame == arm_.rows();
    const bool is_taken = !on_last && takes_along(mine_.bodies[i].object, frame);
    // The body that is moved by more joints comes first.
    const auto add = [&](int other) {
      const BodyRef mine{0, static_cast<int>(i)}, theirs{0, other};
      const bool is_first = frame >= scene_.arms[0].solids[static_cast<std::size_t>(other)].frame;
      scene_.pairs.push_back(
          {.a = is_first ? mine : theirs, .b = is_first ? theirs : mine, .leaving = true});
    };
    for (std::size_t k = 0; k < mine_.own; ++k) {
      const int link = mine_.solids[k].frame;
      if (on_last ? link >= arm.neighbour_of_last() : std::abs(link - frame) <= 1) continue;
      if (is_taken && takes_hold(arm_, mine_.solids[k])) continue;
      add(slim + static_cast<int>(k));
    }
    if (on_last) return;
    for (std::size_t k = mine_.own; k < mine_.solids.size(); ++k) {
      const bool is_hand = k < mine_.carried;
      // If both are carried: one is on the last link, or the first one is the outer one of the
      // loop.
      const int link = mine_.solids[k].frame;
      if (is_hand ? is_taken : link == frame || (link != arm_.rows() && k > i)) continue;
      add(static_cast<int>(k));
    }
  }

  // Whether the gripper takes an object that is carried on a link, or has released it, at an end of
  // the motion.
  [[nodiscard]] bool takes_along(const std::string& name, int frame) const {
    Object object = cell_.world().at(name);
    if (takes_here(object)) return true;
    const auto T_world_link = [&](const Eigen::VectorXd& q) {
      return frame == 0 ? arm_.T_world_base() : link_frame(arm_, q, frame);
    };
    const Eigen::Isometry3d T_link_obj = cell_.world().attachment(name)->T_carrier_obj;
    object.T_world_obj = T_world_link(end_) * T_link_obj;
    return takes_here(object);
  }

  const Cell& cell_;
  int robot_;
  const Robot& arm_;
  ArmBodies mine_;
  Eigen::Vector3d p_start_;
  Eigen::VectorXd end_;
  Eigen::Vector3d p_end_;
  MotionScene scene_;
  std::vector<std::vector<CellBody>> names_;  // of the bodies of each arm of the scene
  std::vector<CellBody> fixed_names_;
};

// Whether both are the same robot, or the same object.
bool is_same_thing(const CellBody& a, const CellBody& b) {
  return a.object == b.object && (!a.object.empty() || a.robot == b.robot);
}

// The bodies of a thing in their present poses.
struct PlacedThing {
  std::vector<Solid> solids;
  std::vector<CellBody> bodies;
};

PlacedThing thing_now(const Cell& cell, const CellBody& thing, Carried carried) {
  if (!thing.object.empty()) {
    const Object& object = cell.world().at(thing.object);
    Solid solid = solid_of(object.shape);
    solid.T = object.T_world_obj;
    return {{solid}, {thing}};
  }
  ArmBodies robot = bodies_of(cell, thing.robot);
  if (carried == Carried::kLeftOut) {
    robot.solids.resize(robot.carried);
    robot.bodies.resize(robot.carried);
  }
  PlacedThing now{placed(cell, thing.robot, robot.solids), std::move(robot.bodies)};
  for (const int finger : cell.robot(thing.robot).fingers) {
    PlacedThing part = thing_now(cell, {.robot = finger}, carried);
    now.solids.insert(now.solids.end(), part.solids.begin(), part.solids.end());
    now.bodies.insert(now.bodies.end(), part.bodies.begin(), part.bodies.end());
  }
  return now;
}

// Whether a body of a robot is the object, is fastened on it or lies on it.
bool belongs_to(const World& world, const CellBody& body, const std::string& object) {
  if (body.object.empty() || object.empty()) return false;
  if (world.are_fastened(body.object, object)) return true;
  std::string below = body.object;
  while (!below.empty() && below != object) {
    const auto& attachment = world.attachment(below);
    below = attachment ? attachment->on : std::string();
  }
  return below == object;
}

// The first collision of each pair of things, with the largest depth of all.
std::vector<CellCollision> each_once(const std::vector<CellCollision>& all) {
  std::vector<CellCollision> found;
  for (const CellCollision& each : all) {
    const auto same = std::ranges::find_if(found, [&](const CellCollision& known) {
      return is_same_thing(known.body, each.body) && is_same_thing(known.other, each.other);
    });
    if (same == found.end()) {
      found.push_back(each);
      continue;
    }
    same->at_end = same->at_end || each.at_end;
    const bool unknown = same->higher < 0.0 || each.higher < 0.0;
    same->higher = unknown ? -1.0 : std::max(same->higher, each.higher);
    if (each.depth <= same->depth) continue;
    same->depth = each.depth;
    same->at_least = each.at_least;
    same->t_deepest = each.t_deepest;
    same->p_world = each.p_world;
  }
  return found;
}

}  // namespace

bool feels(const Cell& cell, const CellBody& body) {
  if (body.robot < 0) return false;
  if (cell.robot(body.robot).hand >= 0) return true;  // a finger
  const Robot& arm = *cell.robot(body.robot).model;
  return body.object.empty() ? is_feeler(arm, body.frame, body.role) : body.frame == arm.rows();
}

std::string body_text(const Cell& cell, const CellBody& body) {
  if (!body.object.empty()) return fmt::format("\"{}\"", body.object);
  const CellRobot& arm = cell.robot(body.robot);
  const auto part = [&]() -> std::string {
    if (arm.on >= 0) return arm.hand < 0 ? "the palm" : "a link";
    if (is_finger(body.role)) return "a finger";
    if (body.role == LinkShapeRole::kTool)
      return arm.model->tool().kind == ToolKind::kParallelGripper ? "the gripper" : "the tool";
    if (body.role == LinkShapeRole::kFlange) return "the flange";
    return body.frame == 0 ? std::string("the base") : fmt::format("link {}", body.frame);
  };
  return fmt::format("{} of `{}`", part(), arm.name);
}

std::vector<CellCollision> find_collisions(const Cell& cell, int robot, const Trajectory& motion,
                                           std::span<const MotionBeside> beside) {
  if (cell.robot(robot).on >= 0)
    return each_once(find_finger_collisions(cell, robot, motion, beside));
  const CellScene scene(cell, robot, motion);
  std::vector<CellCollision> all;
  for (const Meeting& each : check_motion(scene.scene()).meetings) {
    const CheckedPair& pair = scene.scene().pairs[each.pair];
    all.push_back({.body = scene.body(pair.a),
                   .other = scene.body(pair.b),
                   .t = each.t,
                   .depth = each.depth,
                   .at_least = each.at_least,
                   .t_deepest = each.t_deepest,
                   .p_world = each.p_world,
                   .higher = each.higher,
                   .at_start = each.t <= 0.0,
                   .at_end = each.at_end});
  }
  return each_once(all);
}

std::optional<ObjectOverlap> deepest_overlap(const World& world, const Object& object) {
  std::optional<ObjectOverlap> deepest;
  Solid body = solid_of(object.shape);
  body.T = object.T_world_obj;
  const double reach = body.reach();
  for (const std::size_t i : world.near(body.T.translation(), reach)) {
    const Object& other = world.object(i);
    if (&other == &object || (other.fixed && object.fixed) || world.attachment_of(i) ||
        world.are_fastened(other.name, object.name))
      continue;
    Solid solid = solid_of(other.shape);
    solid.T = other.T_world_obj;
    const double most = reach + solid.reach();
    if ((solid.T.translation() - body.T.translation()).squaredNorm() >= most * most) continue;
    const Gap gap = gap_between(body, solid);
    const double depth = -gap.distance;
    if (depth > kRestTolerance && (!deepest || depth > deepest->depth)) {
      deepest = ObjectOverlap{
          .other = other.name, .depth = depth, .at_least = !is_whole_depth(body, solid, gap)};
    }
  }
  return deepest;
}

ComparedBodies compared_bodies(const Cell& cell, int robot, const Trajectory& motion) {
  const CellScene scene(cell, robot, motion);
  ComparedBodies all{.scene = scene.scene()};
  for (const CheckedPair& pair : all.scene.pairs)
    all.pairs.emplace_back(scene.body(pair.a), scene.body(pair.b));
  return all;
}

Clearance nearest_between(const Cell& cell, const CellBody& a, const CellBody& b, Carried carried) {
  const PlacedThing first = thing_now(cell, a, carried), second = thing_now(cell, b, carried);
  Clearance nearest;
  for (std::size_t i = 0; i < first.solids.size(); ++i) {
    if (a.object.empty() && belongs_to(cell.world(), first.bodies[i], b.object)) continue;
    for (std::size_t k = 0; k < second.solids.size(); ++k) {
      if (b.object.empty() && belongs_to(cell.world(), second.bodies[k], a.object)) continue;
      // Two robots may hold one object together, and a hand with fingers is a part of its arm.
      const std::string& held = first.bodies[i].object;
      if (a.object.empty() && !held.empty() && held == second.bodies[k].object) continue;
      if (a.robot != b.robot && held.empty() && second.bodies[k].object.empty() &&
          first.bodies[i].robot == second.bodies[k].robot && a.object.empty() && b.object.empty())
        continue;
      const Solid &one = first.solids[i], &other = second.solids[k];
      const double least = nearest.distance;
      if (least >= 0.0 && least < std::numeric_limits<double>::infinity() &&
          is_farther(one, other, least))
        continue;
      const Gap gap = gap_between(one, other);
      if (gap.distance >= least) continue;
      nearest = {.body = first.bodies[i],
                 .other = second.bodies[k],
                 .distance = gap.distance,
                 .p_body = gap.p_a,
                 .p_other = gap.p_b};
    }
  }
  return nearest;
}

}  // namespace armlet
