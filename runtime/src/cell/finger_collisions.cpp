// Collisions of fingers while the arm that carries them is at rest.
#include "cell/finger_collisions.hpp"

#include <algorithm>
#include <utility>

#include "armlet/collision/motion_check.hpp"
#include "armlet/kinematics/forward.hpp"
#include "cell/arm_bodies.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;

// The motion of a finger, 0 to 2, that follows from one of the palm: every joint of it is
// proportional to one joint of the palm.
Trajectory motion_of_finger(int finger, const Trajectory& palm) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(palm.n());
  const Eigen::VectorXd origin = finger_joints(finger, zero);
  std::vector<JointPath> joints(static_cast<std::size_t>(origin.size()));
  for (Eigen::Index i = 0; i < origin.size(); ++i) {
    JointPath& path = joints[static_cast<std::size_t>(i)];
    path.q_end = origin[i];
    for (int k = 0; k < palm.n(); ++k) {
      Eigen::VectorXd unit = zero;
      unit[k] = 1.0;
      const double factor = finger_joints(finger, unit)[i] - origin[i];
      if (factor == 0.0) continue;
      path = palm.joint(k);
      path.q_end = origin[i] + factor * path.q_end;
      for (Segment& each : path.segments) {
        for (double& c : each.c) c *= factor;
        each.c[0] += origin[i];
      }
    }
  }
  return Trajectory(std::move(joints), palm.duration());
}

// A finger of a hand with fingers, and its motion from now on.
//
// asked            its motion is the one to be checked.
// compares_itself  it begins at the same instant, and its own call compares it with this one.
struct MovingFinger {
  int robot = -1;
  const Trajectory* motion = nullptr;
  double from = 0.0;
  bool asked = false;
  bool compares_itself = false;
};

// The obstacles of fingers, in the frame of the flange that carries them.
class FingerScene {
 public:
  FingerScene(const Cell& cell, int hand)
      : cell_(cell),
        hand_(hand),
        arm_(cell.robot(hand).on),
        T_flange_world_(cell.T_world_flange(arm_).inverse()) {
    add_objects();
    for (int other = 0; other < cell.robot_count(); ++other) {
      if (cell.robot(other).on != arm_ || other == hand) add_robot(other);
    }
  }

  [[nodiscard]] std::vector<CellCollision> meet(std::span<const MovingFinger> fingers) const {
    MotionScene scene{.fixed = fixed_};
    for (const MovingFinger& each : fingers) {
      const Robot& model = *cell_.robot(each.robot).model;
      scene.duration = std::max(scene.duration, each.motion->duration() - each.from);
      scene.arms.push_back({.robot = &model,
                            .motion = each.motion,
                            .from = each.from,
                            .solids = model.derived<ArmSolids>().solids()});
    }
    std::vector<std::vector<Solid>> begin{fixed_};
    for (const ArmInMotion& each : scene.arms) begin.push_back(placed_at_begin(each));
    for (std::size_t i = 0; i < fingers.size(); ++i) {
      if (!fingers[i].asked) continue;
      const int first = static_cast<int>(i);
      add_pairs(scene, first, BodyRef::kFixed, begin);
      for (std::size_t k = 0; k < fingers.size(); ++k) {
        if (k == i || (fingers[k].asked && k < i) || fingers[k].compares_itself) continue;
        add_pairs(scene, first, static_cast<int>(k), begin);
      }
    }
    const auto body_of = [&](const BodyRef& ref) -> CellBody {
      if (ref.arm == BodyRef::kFixed) return names_[static_cast<std::size_t>(ref.index)];
      const auto arm = static_cast<std::size_t>(ref.arm);
      const ArmSolid& link = scene.arms[arm].solids[static_cast<std::size_t>(ref.index)];
      return {.robot = fingers[arm].robot, .frame = link.frame, .role = link.role};
    };
    std::vector<CellCollision> found;
    for (const Meeting& each : check_motion(scene).meetings) {
      const CheckedPair& pair = scene.pairs[each.pair];
      found.push_back({.body = body_of(pair.a),
                       .other = body_of(pair.b),
                       .t = each.t,
                       .depth = each.depth,
                       .at_least = each.at_least,
                       .t_deepest = each.t_deepest,
                       .p_world = T_flange_world_.inverse() * each.p_world,
                       .higher = -1.0,
                       .at_start = each.t <= 0.0,
                       .at_end = each.at_end});
    }
    return found;
  }

 private:
  static std::vector<Solid> placed_at_begin(const ArmInMotion& arm) {
    Eigen::VectorXd q(arm.robot->n());
    for (int i = 0; i < arm.robot->n(); ++i) q[i] = arm.motion->value(i, arm.from);
    const std::vector<Isometry3d> frames = link_frames(*arm.robot, q);
    std::vector<Solid> placed;
    for (const ArmSolid& each : arm.solids) {
      placed.push_back(each.solid);
      placed.back().T = (each.frame == 0 ? arm.robot->T_world_base()
                                         : frames[static_cast<std::size_t>(each.frame - 1)]) *
                        each.solid.T;
    }
    return placed;
  }

  // Adds the pairs of every body of a finger with those of another arm of the scene, or with the
  // fixed ones.
  //
  // begin  poses of the fixed bodies, and of each arm, at the start.
  void add_pairs(MotionScene& scene, int finger, int other,
                 const std::vector<std::vector<Solid>>& begin) const {
    const auto& links = begin[static_cast<std::size_t>(finger + 1)];
    const auto& others = begin[static_cast<std::size_t>(other + 1)];
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (std::size_t k = 0; k < others.size(); ++k) {
        // A finger may separate from other bodies that it touches at the start. From parts of its
        // own hand with fingers it may separate if it overlaps them; those that it only touches, it
        // collides with at once.
        const bool is_own = other != BodyRef::kFixed || names_[k].robot == hand_;
        const bool leaving = !is_own || gap_between(links[i], others[k]).distance < -kSoft;
        scene.pairs.push_back({.a = {finger, static_cast<int>(i)},
                               .b = {other, static_cast<int>(k)},
                               .leaving = leaving});
      }
    }
  }

  void add(Solid solid, const Isometry3d& T_world_solid, CellBody name) {
    solid.T = T_flange_world_ * T_world_solid;
    fixed_.push_back(std::move(solid));
    names_.push_back(std::move(name));
  }

  // Objects that can be grasped are meant to be touched: forces decide there.
  void add_objects() {
    const World& world = cell_.world();
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Object& object = world.object(i);
      const auto& carried = world.attachment_of(i);
      const bool is_own = carried && carried->carrier == arm_;
      if (is_own ? !carried->mounted || !object.fixed : !carried && !object.fixed) continue;
      CellBody name{.object = object.name};
      if (carried) name.robot = carried->carrier;
      add(solid_of(object.shape), object.T_world_obj, std::move(name));
    }
  }

  // Adds the bodies of a robot in their present poses. Of the arm that carries the fingers those
  // that are not next to them, with half their thickness, as for self-collisions.
  void add_robot(int other) {
    const CellRobot& state = cell_.robot(other);
    const ArmSolids& own = state.model->derived<ArmSolids>();
    std::vector<ArmSolid> solids = other == arm_ ? own.slim() : own.solids();
    close_fingers(state, cell_.world(), solids);
    const std::vector<Isometry3d> frames = link_frames(*state.model, state.q);
    for (const ArmSolid& each : solids) {
      if (other == arm_ && each.frame >= own.neighbour_of_last()) continue;
      Isometry3d T = (each.frame == 0 ? state.model->T_world_base()
                                      : frames[static_cast<std::size_t>(each.frame - 1)]) *
                     each.solid.T;
      if (state.on >= 0) T = cell_.T_world_flange(state.on) * T;
      add(each.solid, T, {.robot = other, .frame = each.frame, .role = each.role});
    }
  }

  const Cell& cell_;
  int hand_;
  int arm_;
  Isometry3d T_flange_world_;
  std::vector<Solid> fixed_;
  std::vector<CellBody> names_;
};

}  // namespace

std::vector<CellCollision> find_finger_collisions(const Cell& cell, int robot,
                                                  const Trajectory& motion,
                                                  std::span<const MotionBeside> beside) {
  const CellRobot& part = cell.robot(robot);
  const int hand = part.hand < 0 ? robot : part.hand;
  const std::vector<int>& parts = cell.robot(hand).fingers;
  std::vector<Trajectory> own;
  own.reserve(parts.size());
  std::vector<MovingFinger> fingers;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    const int finger = parts[static_cast<std::size_t>(i)];
    const CellRobot& state = cell.robot(finger);
    const auto found = std::ranges::find(beside, finger, &MotionBeside::robot);
    if (part.hand < 0) {
      own.push_back(motion_of_finger(i, motion));
      fingers.push_back({.robot = finger, .motion = &own.back(), .asked = true});
    } else if (finger == robot) {
      fingers.push_back({.robot = finger, .motion = &motion, .asked = true});
    } else if (found != beside.end()) {
      fingers.push_back(
          {.robot = finger, .motion = found->motion, .compares_itself = finger < robot});
    } else if (state.motion) {
      fingers.push_back({.robot = finger,
                         .motion = &state.motion->trajectory(),
                         .from = to_seconds(cell.now_ns() - state.motion->start_ns())});
    } else {
      own.push_back(Trajectory::at_rest(state.q, 0.0));
      fingers.push_back({.robot = finger, .motion = &own.back()});
    }
  }
  std::vector<CellCollision> all = FingerScene(cell, hand).meet(fingers);
  std::ranges::stable_sort(all, {}, &CellCollision::t);
  return all;
}

}  // namespace armlet
