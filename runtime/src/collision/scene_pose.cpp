#include "collision/scene_pose.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/model/joint_coupling.hpp"

namespace armlet {
namespace {

void check_ref(const MotionScene& scene, const BodyRef& ref) {
  const bool has_arm = ref.arm >= 0 && ref.arm < static_cast<int>(scene.arms.size());
  const std::size_t count = ref.arm == BodyRef::kFixed ? scene.fixed.size()
                            : has_arm ? scene.arms[static_cast<std::size_t>(ref.arm)].solids.size()
                                      : 0;
  if (ref.index >= 0 && static_cast<std::size_t>(ref.index) < count) return;
  throw ArgumentError(
      fmt::format("There is no body {} of arm {} in the scene.", ref.index, ref.arm));
}

}  // namespace

ScenePose::ScenePose(const MotionScene& scene) : scene_(scene) {
  std::size_t joint = 0;
  for (const ArmInMotion& arm : scene.arms) {
    check_size("motion", arm.motion->n(), arm.robot->n());
    ArmPose pose{.frames = {}, .first_joint = joint, .first_body = bodies_.size()};
    pose.frames.resize(static_cast<std::size_t>(arm.robot->rows()) + 1);
    pose.frames[0] = arm.robot->T_world_base();
    arms_.push_back(std::move(pose));
    joint += static_cast<std::size_t>(arm.robot->n());
    for (const ArmSolid& each : arm.solids) bodies_.push_back(each.solid);
  }
  first_fixed_ = bodies_.size();
  bodies_.insert(bodies_.end(), scene.fixed.begin(), scene.fixed.end());
  for (const Solid& each : bodies_) reaches_.push_back(each.reach());
  placed_.assign(bodies_.size(), 0);
  far_.assign(bodies_.size(), 0.0);
  far_known_.assign(bodies_.size(), 0);
  for (const CheckedPair& pair : scene.pairs) {
    check_ref(scene, pair.a);
    check_ref(scene, pair.b);
  }
}

void ScenePose::place(std::span<const double> q, std::span<const double> travel) {
  q_ = q;
  travel_ = travel;
  ++now_;
}

std::size_t ScenePose::slot(const BodyRef& ref) const {
  const auto index = static_cast<std::size_t>(ref.index);
  if (ref.arm == BodyRef::kFixed) return first_fixed_ + index;
  return arms_[static_cast<std::size_t>(ref.arm)].first_body + index;
}

const ScenePose::ArmPose& ScenePose::pose_of(int arm) {
  ArmPose& pose = arms_[static_cast<std::size_t>(arm)];
  if (pose.placed == now_) return pose;
  pose.placed = now_;
  const Robot& robot = *scene_.arms[static_cast<std::size_t>(arm)].robot;
  const Eigen::Map<const Eigen::VectorXd> q(q_.data() + pose.first_joint, robot.n());
  (void)link_frames(robot, q, std::span(pose.frames).subspan(1));
  return pose;
}

const Solid& ScenePose::body(const BodyRef& ref) {
  const std::size_t at = slot(ref);
  if (ref.arm == BodyRef::kFixed || placed_[at] == now_) return bodies_[at];
  placed_[at] = now_;
  const ArmSolid& own =
      scene_.arms[static_cast<std::size_t>(ref.arm)].solids[static_cast<std::size_t>(ref.index)];
  bodies_[at].T = pose_of(ref.arm).frames[static_cast<std::size_t>(own.frame)] * own.solid.T;
  return bodies_[at];
}

// The outermost joint moves first, then the next one moves all beyond it, which is already
// displaced by the sum so far: no point gets farther than the sum of the arcs.
double ScenePose::travel_behind(const BodyRef& ref, int from) {
  const Solid& solid = body(ref);
  const ArmPose& pose = pose_of(ref.arm);
  const ArmInMotion& arm = scene_.arms[static_cast<std::size_t>(ref.arm)];
  const bool standard = arm.robot->spec().convention == DhConvention::kStandard;
  const double reach = reaches_[slot(ref)];
  double far = 0.0;
  for (int k = arm.solids[static_cast<std::size_t>(ref.index)].frame; k > from; --k) {
    const auto [joint, ratio] = motion_of_row(*arm.robot, k - 1);
    const double joint_travel =
        std::abs(ratio) * travel_[pose.first_joint + static_cast<std::size_t>(joint)];
    if (joint_travel == 0.0) continue;
    if (!arm.robot->row(k - 1).is_revolute()) {
      far += joint_travel;
      continue;
    }
    const Eigen::Isometry3d& T = pose.frames[static_cast<std::size_t>(standard ? k - 1 : k)];
    const Eigen::Vector3d out = solid.T.translation() - T.translation();
    far += joint_travel * (T.linear().col(2).cross(out).norm() + reach + far);
  }
  return far;
}

double ScenePose::travel_of(const BodyRef& ref) {
  if (ref.arm == BodyRef::kFixed) return 0.0;
  const std::size_t at = slot(ref);
  if (far_known_[at] != now_) {
    far_known_[at] = now_;
    far_[at] = travel_behind(ref, 0);
  }
  return far_[at];
}

double ScenePose::travel(const CheckedPair& pair) {
  if (pair.a.arm == pair.b.arm) {
    const ArmInMotion& arm = scene_.arms[static_cast<std::size_t>(pair.a.arm)];
    return travel_behind(pair.a, arm.solids[static_cast<std::size_t>(pair.b.index)].frame);
  }
  return travel_of(pair.a) + travel_of(pair.b);
}

}  // namespace armlet
