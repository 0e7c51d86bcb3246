#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "armlet/kinematics/forward.hpp"

namespace armlet {

// The families of arms whose inverse kinematics has a formula. Which one an arm belongs to is found
// from its structure (parallel axes, axes that meet in a point), not from its name; arms read from
// the tool to the base count too.
enum class ClosedFormKind {
  kNone,
  kPlane,     // three turning joints with parallel axes: place in the plane and heading
  kScara,     // three parallel turning joints and one sliding along them, in any order
  kShoulder,  // three turning joints that reach a place: axes 2 and 3 parallel, or 1 and 2 meet
  kPlanarArmTwist,     // five joints: axes 2, 3, 4 parallel, the last one across (Scorbot)
  kSphericalParallel,  // six joints: 4, 5, 6 meet in a point, 2 and 3 parallel (Puma)
  kSphericalMeeting,   // six joints: 4, 5, 6 meet in a point, 1 and 2 meet
  kThreeParallel,      // six joints: 2, 3, 4 parallel, 5 and 6 meet (UR)
  kShoulderElbowWrist  // seven joints: 1, 2, 3 and 5, 6, 7 meet in points (PA-10, iiwa)
};

// "six joints, spherical wrist, axes 2 and 3 parallel"
std::string_view to_text(ClosedFormKind kind);

struct CanonicalRows;

// All joint configurations that bring the tool point to a pose, by formula.
//
// source  D. Pieper, The kinematics of manipulators under computer control, 1968; A. Elias and J.
// Wen, IK-Geo:
//         unified robot inverse kinematics using subproblem decomposition, Mech. Mach. Theory 209,
//         2025.
class ClosedForm {
 public:
  // The robot must outlive it.
  explicit ClosedForm(const Robot& robot);
  ~ClosedForm();
  ClosedForm(ClosedForm&&) noexcept;
  ClosedForm& operator=(ClosedForm&&) noexcept;

  ClosedFormKind kind() const { return kind_; }
  bool exists() const { return kind_ != ClosedFormKind::kNone; }
  bool reversed() const { return reversed_; }
  // An arm of seven joints may need one held still: the first (0) or the last (6); -1 if none.
  int held_joint() const {
    return hold_ == Hold::kNone ? -1 : hold_ == Hold::kFirst ? 0 : robot_->n() - 1;
  }

  // T_world_tool  the goal.
  // q_near        n joint values: where a joint may have any value (a singular configuration) it
  // keeps this one; an
  //               arm of seven joints keeps its arm angle or its held joint.
  // solutions     each checked by forward kinematics to 1e-9 m and rad; joints that turn lie within
  // half a turn of 0;
  //               limits are not looked at.
  // returns       how many there are; at most 16.
  int solve(const Eigen::Isometry3d& T_world_tool, JointsIn q_near,
            std::vector<Eigen::VectorXd>& solutions) const;

 private:
  enum class Hold : unsigned char { kNone, kFirst, kLast };
  void recognise(const Chain& chain);

  std::unique_ptr<CanonicalRows> rows_;
  const Robot* robot_;
  ClosedFormKind kind_ = ClosedFormKind::kNone;
  bool reversed_ = false;
  Hold hold_ = Hold::kNone;
};

}  // namespace armlet
