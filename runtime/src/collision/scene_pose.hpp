// A scene in one configuration; poses are computed when they are needed.
#pragma once

#include <span>
#include <vector>

#include "armlet/collision/motion_check.hpp"

namespace armlet {

class ScenePose {
 public:
  // throws  ArgumentError as check_motion.
  explicit ScenePose(const MotionScene& scene);

  // q       joint values of all arms, arm by arm.
  // travel  bound on the deviation of each of them, >= 0.
  void place(std::span<const double> q, std::span<const double> travel);

  // A body in the world.
  [[nodiscard]] const Solid& body(const BodyRef& ref);
  [[nodiscard]] double reach(const BodyRef& ref) const { return reaches_[slot(ref)]; }

  // Bound on the motion of any point of one body relative to the other one.
  [[nodiscard]] double travel(const CheckedPair& pair);

 private:
  struct ArmPose {
    std::vector<Eigen::Isometry3d> frames;  // the base, and the frame after each joint
    std::size_t first_joint = 0;
    std::size_t first_body = 0;
    int placed = 0;
  };
  [[nodiscard]] std::size_t slot(const BodyRef& ref) const;
  const ArmPose& pose_of(int arm);
  [[nodiscard]] double travel_of(const BodyRef& ref);
  // The largest displacement of a body by the joints after frame `from`, while the joints before it
  // are at rest.
  [[nodiscard]] double travel_behind(const BodyRef& ref, int from);

  const MotionScene& scene_;
  std::vector<ArmPose> arms_;
  std::vector<Solid> bodies_;    // in the world: those of the arms, then the fixed ones
  std::vector<double> reaches_;  // of the same
  std::vector<int> placed_;      // number of the configuration in which each was placed
  std::vector<double> far_;      // bound on the motion of each, and when it was computed
  std::vector<int> far_known_;
  std::size_t first_fixed_ = 0;
  std::span<const double> q_, travel_;
  int now_ = 0;
};

}  // namespace armlet
