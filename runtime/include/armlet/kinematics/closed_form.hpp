#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/reach_gap.hpp"

namespace armlet {

// The families of arms with a closed form of inverse kinematics. The family of an arm follows from
// its structure (parallel axes, axes that meet in a point), not from its name. An arm that belongs
// to a family when read from the tool to the base counts too.
enum class ClosedFormKind {
  kNone,
  kPlane,     // three revolute joints with parallel axes: position in the plane and heading
  kScara,     // three parallel revolute joints and one sliding along them, in any order
  kShoulder,  // three revolute joints that reach a position: axes 2 and 3 parallel, or 1 and 2 meet
  kPlanarArmTwist,      // five joints: axes 2, 3, 4 parallel, the last one across (Scorbot)
  kSphericalParallel,   // six joints: 4, 5, 6 meet in a point, 2 and 3 parallel (Puma)
  kSphericalMeeting,    // six joints: 4, 5, 6 meet in a point, 1 and 2 meet
  kThreeParallel,       // six joints: 2, 3, 4 parallel, 5 and 6 meet (UR)
  kShoulderElbowWrist,  // seven joints: 1, 2, 3 and 5, 6, 7 meet in points (PA-10, iiwa)
  kFewPosition,         // one to three revolute joints of any other structure: position
  kFewPose,             // one to four of them: pose
  kMeetingWrist,        // five revolute joints: 4 and 5 meet, the first three of any structure
  kSphericalWrist       // six: 4, 5, 6 meet in a point, the first three of any other structure
};

// "six joints, spherical wrist, axes 2 and 3 parallel"
std::string_view to_text(ClosedFormKind kind);

inline constexpr int kMaxBranches = 16;
inline constexpr unsigned kEveryBranch = (1U << kMaxBranches) - 1U;

// One solution for a pose.
//
// q       the joint values, rad or m; revolute joints lie within half a revolution of 0.
// branch  a sum of 4 (shoulder), 2 (elbow) and 1 (wrist), each if the second of the two solutions
//         is taken. ClosedForm::branch_name gives it in words.
struct ClosedSolution {
  std::array<double, kMaxJoints> q;
  int n = 0;
  int branch = 0;

  Eigen::Map<const Eigen::VectorXd> joints() const { return {q.data(), n}; }
};

// All solutions for a pose, without allocation.
//
// free  some joint may take any value, at a singular position or within 1e-6 of one: there may be
//       more solutions than these, even if these are none.
// open  a bit for each joint that the goal does not determine and that keeps its given value, where
//       the values of other joints depend on it; joints about one line, which only share an angle,
//       are not listed.
struct ClosedSolutions {
  std::array<ClosedSolution, kMaxBranches> at;
  int count = 0;
  bool free = false;
  unsigned open = 0;

  const ClosedSolution* begin() const { return at.data(); }
  const ClosedSolution* end() const { return at.data() + count; }
};

struct CanonicalRows;
struct ClosedLanes;
class LaneForm;

// All joint configurations that bring the tool point to a pose, by formula.
//
// source  D. Pieper, The kinematics of manipulators under computer control, 1968; A. Elias and J.
//         Wen, IK-Geo: unified robot inverse kinematics using subproblem decomposition, Mech. Mach.
//         Theory 209, 2025.
class ClosedForm {
 public:
  explicit ClosedForm(const Chain& chain);
  ~ClosedForm();
  ClosedForm(ClosedForm&&) noexcept;
  ClosedForm& operator=(ClosedForm&&) noexcept;

  ClosedFormKind kind() const { return kind_; }
  bool exists() const { return kind_ != ClosedFormKind::kNone; }
  bool reversed() const { return reversed_; }
  // The joint of an arm of seven joints that is held at a given value: the first (0) or the last
  // (6); -1 if none.
  int held_joint() const {
    return hold_ == Hold::kNone ? -1 : hold_ == Hold::kFirst ? 0 : chain_.n - 1;
  }
  // Only the position of the goal counts (kShoulder, kFewPosition).
  bool position_only() const {
    return kind_ == ClosedFormKind::kShoulder || kind_ == ClosedFormKind::kFewPosition;
  }
  // Whether these solutions are all that exist, unless one of their joints is free: the arm has at
  // most six joints.
  bool complete() const { return exists() && chain_.n <= 6; }

  // T_world_tool      the goal.
  // q_near            n joint values. A joint that may have any value (at a singular position)
  //                   keeps this one; an arm of seven joints keeps its arm angle or the value of
  //                   its held joint.
  // tolerance         largest error of a solution, m and rad, measured by forward kinematics.
  //                   Solutions are refined to 1e-9 where the goal allows it.
  // arm_angle_change  added to the arm angle or the held joint of an arm of seven joints, rad.
  // wanted            bits of the requested branches.
  // solutions         in the order of their branches; joint limits are not checked.
  // returns           number of solutions; 0 if there are none, or if the arm has no closed form.
  int solve(const Eigen::Isometry3d& T_world_tool, JointsIn q_near, ClosedSolutions& solutions,
            double tolerance = 1e-9, double arm_angle_change = 0.0,
            unsigned wanted = kEveryBranch) const;

  // Why there is no solution, if the geometry of the arm excludes it whatever its limits are. No
  // gap if there is another reason, or for an arm with a held joint.
  //
  // T_world_tool        the goal, in the world.
  // orientation_counts  whether the goal's orientation has to be met.
  ReachGap gap(const Eigen::Isometry3d& T_world_tool, bool orientation_counts = true) const;

  // "shoulder front, elbow up, wrist flipped". Front and up are used for arms that stand or hang;
  // for others the two solutions are called + and -.
  std::string branch_name(int branch) const;

 private:
  enum class Hold : unsigned char { kNone, kFirst, kLast };
  void recognise(const Chain& chain);
  bool hold_still(Hold hold);
  // The goal of the other joints if the held joint were at 0.
  Eigen::Isometry3d without_held(const Eigen::Isometry3d& T_world_tool, double held) const;
  bool accept(const Eigen::Isometry3d& goal, double tolerance, ClosedSolution& solution) const;
  int take_lanes(const Eigen::Isometry3d& goal, double tolerance, const ClosedSolution& start,
                 const ClosedLanes& lanes, unsigned wanted, ClosedSolutions& solutions) const;

  Chain chain_;
  WalkPlan plan_;
  std::unique_ptr<CanonicalRows> rows_;
  std::unique_ptr<LaneForm> lanes_;  // where the family has a kernel
  ClosedFormKind kind_ = ClosedFormKind::kNone;
  bool reversed_ = false;
  Hold hold_ = Hold::kNone;
  // part that the held joint does not rotate
  Eigen::Isometry3d T_beside_held_ = Eigen::Isometry3d::Identity();
};

// The closed form of an arm. It is found once and stored with the arm; copies with the same
// geometry share it, whatever their limits and home.
const ClosedForm& closed_form(const Robot& robot);

}  // namespace armlet
