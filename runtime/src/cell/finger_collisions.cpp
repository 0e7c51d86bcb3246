// What fingers would meet while the arm that carries them stands.
#include "cell/finger_collisions.hpp"

#include <algorithm>

#include "armlet/collision/motion_check.hpp"
#include "armlet/kinematics/forward.hpp"
#include "cell/arm_bodies.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;

// The motion of a finger, 0 to 2, that follows from one of the palm: every joint of it goes with
// one joint of the palm, in proportion.
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

// What is in the way of fingers, in the frame of the flange that carries them.
class FingerScene {
 public:
  FingerScene(const Cell& cell, int arm)
      : cell_(cell), arm_(arm), T_flange_world_(cell.T_world_flange(arm).inverse()) {
    add_objects();
    for (int other = 0; other < cell.robot_count(); ++other) {
      if (cell.robot(other).on != arm) add_robot(other);
    }
  }

  [[nodiscard]] std::vector<CellCollision> meet(int finger, const Trajectory& motion) const {
    const Robot& model = *cell_.robot(finger).model;
    MotionScene scene{.fixed = fixed_, .duration = motion.duration()};
    scene.arms.push_back(
        {.robot = &model, .motion = &motion, .solids = model.derived<ArmSolids>().solids()});
    for (std::size_t i = 0; i < scene.arms[0].solids.size(); ++i) {
      for (std::size_t k = 0; k < fixed_.size(); ++k) {
        scene.pairs.push_back({.a = {0, static_cast<int>(i)},
                               .b = {BodyRef::kFixed, static_cast<int>(k)},
                               .leaving = true});
      }
    }
    std::vector<CellCollision> found;
    for (const Meeting& each : check_motion(scene).meetings) {
      const CheckedPair& pair = scene.pairs[each.pair];
      const ArmSolid& link = scene.arms[0].solids[static_cast<std::size_t>(pair.a.index)];
      found.push_back({.body = {.robot = finger, .frame = link.frame, .role = link.role},
                       .other = names_[static_cast<std::size_t>(pair.b.index)],
                       .t = each.t,
                       .depth = each.depth,
                       .t_deepest = each.t_deepest,
                       .p_world = T_flange_world_.inverse() * each.p_world,
                       .higher = -1.0,
                       .at_start = each.t <= 0.0,
                       .at_end = each.at_end});
    }
    return found;
  }

 private:
  void add(Solid solid, const Isometry3d& T_world_solid, CellBody name) {
    solid.T = T_flange_world_ * T_world_solid;
    fixed_.push_back(std::move(solid));
    names_.push_back(std::move(name));
  }

  // What could be taken is there to be touched: forces judge that.
  void add_objects() {
    const World& world = cell_.world();
    for (std::size_t i = 0; i < world.size(); ++i) {
      const Object& object = world.object(i);
      const auto& carried = world.attachment_of(i);
      if (carried ? carried->carrier == arm_ : !object.fixed) continue;
      CellBody name{.object = object.name};
      if (carried) name.robot = carried->carrier;
      add(solid_of(object.shape), object.T_world_obj, std::move(name));
    }
  }

  // Where its bodies are now. Of the arm that carries the fingers those that are not next to them,
  // half as thick, as it is compared with itself.
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
  int arm_;
  Isometry3d T_flange_world_;
  std::vector<Solid> fixed_;
  std::vector<CellBody> names_;
};

}  // namespace

std::vector<CellCollision> find_finger_collisions(const Cell& cell, int robot,
                                                  const Trajectory& motion) {
  const CellRobot& part = cell.robot(robot);
  const FingerScene scene(cell, part.on);
  if (part.hand >= 0) return scene.meet(robot, motion);
  std::vector<CellCollision> all;
  for (int i = 0; i < static_cast<int>(part.fingers.size()); ++i) {
    const std::vector<CellCollision> met =
        scene.meet(part.fingers[static_cast<std::size_t>(i)], motion_of_finger(i, motion));
    all.insert(all.end(), met.begin(), met.end());
  }
  std::ranges::stable_sort(all, {}, &CellCollision::t);
  return all;
}

}  // namespace armlet
