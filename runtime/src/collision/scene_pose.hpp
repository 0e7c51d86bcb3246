// A scene at one position of all its joints, worked out as far as it is asked for.
#pragma once

#include <span>
#include <vector>

#include "armlet/collision/motion_check.hpp"

namespace armlet {

class ScenePose {
 public:
  // throws  ArgumentError as check_motion.
  explicit ScenePose(const MotionScene& scene);

  // q       positions of all joints, arm by arm.
  // travel  how far each of them may be from there, >= 0.
  void place(std::span<const double> q, std::span<const double> travel);

  // A body in the world.
  [[nodiscard]] const Solid& body(const BodyRef& ref);
  [[nodiscard]] double reach(const BodyRef& ref) const { return reaches_[slot(ref)]; }

  // How far any point of one body can get from where it is, seen from the other one.
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
  // By the joints behind frame `from`, those before it standing still.
  [[nodiscard]] double travel_behind(const BodyRef& ref, int from);

  const MotionScene& scene_;
  std::vector<ArmPose> arms_;
  std::vector<Solid> bodies_;    // in the world: those of the arms, then what is fixed
  std::vector<double> reaches_;  // of the same
  std::vector<int> placed_;      // when each was placed
  std::vector<double> far_;      // how far each gets, and when that was worked out
  std::vector<int> far_known_;
  std::size_t first_fixed_ = 0;
  std::span<const double> q_, travel_;
  int now_ = 0;
};

}  // namespace armlet
