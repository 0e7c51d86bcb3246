#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/kinematics/limits.hpp"
#include "armlet/kinematics/posture.hpp"
#include "armlet/kinematics/reach_gap.hpp"
#include "armlet/math/twist.hpp"

namespace armlet {

// Which parts of the goal the tool has to match.
//
// kPose           position and orientation. An arm with fewer than six joints reaches only the
//                 poses that it can; others are kOrientationUnreachable.
// kPosition       the position; the orientation is free.
// kPositionFirst  the position, keeping the orientation at the seed as far as the arm can: if that
//                 orientation cannot be kept, the change of orientation is made as small as
//                 possible.
// kHeading        the position and the rotation about the world's z axis (the heading of the goal's
//                 x axis, or of its y axis if x is vertical), with the tilt of the tool at the
//                 seed. For arms whose tool axis stays parallel to z, such as a SCARA.
// kMasked         the rows of [p; log R] chosen by IkOptions::mask.
enum class IkTask { kPose, kPosition, kPositionFirst, kHeading, kMasked };

enum class IkMaskFrame { kWorld, kTool };

// kFirst    the first solution found, starting at the seed.
// kNearest  of all solutions found, the one whose largest joint change from the seed is smallest
//           (in SI numbers); of solutions equal within 1e-9, the one with the positive elbow.
//           Joints that the goal leaves free are chosen by the same rule among all values within
//           the limits. An arm that is already at the goal does not move.
enum class IkChoice { kFirst, kNearest };

// kAuto     the arm's closed form if it has one for this task (the whole pose, or the position of a
//           three-joint arm, with kNearest), otherwise iterations.
// kNumeric  always iterations.
enum class IkMethod { kAuto, kNumeric };

struct IkOptions {
  Eigen::VectorXd seed;  // n joint values to start from and to stay near; empty: the arm's home
  IkTask task = IkTask::kPose;
  std::array<bool, 6> mask{true, true, true, true, true, true};  // for kMasked
  IkMaskFrame mask_frame = IkMaskFrame::kWorld;
  IkChoice choice = IkChoice::kNearest;
  IkMethod method = IkMethod::kAuto;
  // Choose the solution with the best posture (`choice` is ignored). A redundant arm moves from
  // each solution found by self-motion as far as the posture improves.
  std::optional<PostureGoal> posture{};
  double position_tolerance = 1e-6;  // m
  double rotation_tolerance = 1e-6;  // rad
  int iterations = 30;               // per start
  int starts = 200;
  bool respect_limits = true;
  bool diagnose = true;  // find the reason when there is no solution
};

enum class IkStatus {
  kOk,
  kUnreachable,             // the position is out of reach
  kOrientationUnreachable,  // the position can be reached, but not with this orientation
  kJointLimit,              // only with joints outside their limits
  kSingularGoal,            // the iteration stalls at a singular configuration next to the goal
  kBadRotation,             // the goal's rotation part is not a rotation
  kBadSize,                 // the seed has not one value per joint
  kNotFinite,               // the goal or the seed has nan, infinity or a value beyond 1e6
};

// "unreachable", "joint limit", ...
std::string_view to_text(IkStatus status);

// Why there is no solution, in numbers. Which of them are set depends on the status.
//
// distance    from the goal to the nearest reachable tool point, of all branches, m.
// angle       from the goal's orientation to the nearest one found at that point, rad.
// nearest     that pose of the tool in the world; q_nearest are its joint values.
// violations  joints that would be outside their limits in the best solution without limits.
// gap         what the geometry of an arm with a closed form excludes, whatever the limits are.
// sigma_min   closeness to a singularity at q_nearest (see Singularity), and the lost direction.
struct IkDiagnosis {
  double distance = 0.0;
  double angle = 0.0;
  Eigen::Isometry3d nearest = Eigen::Isometry3d::Identity();
  Eigen::VectorXd q_nearest;
  std::vector<LimitViolation> violations;
  ReachGap gap;
  double sigma_min = 0.0;
  Vector6d lost_direction = Vector6d::Zero();
};

// q is the solution if status is kOk, otherwise the best configuration found. The errors belong to
// q and contain only what the task demands.
struct IkResult {
  IkStatus status = IkStatus::kUnreachable;
  Eigen::VectorXd q;
  double position_error = 0.0;  // m
  double rotation_error = 0.0;  // rad
  int iterations = 0;           // 0 if a formula gave the answer
  int starts = 0;
  // "numeric"; or the structure of the closed form, also if that excluded the goal; or "the robot
  // stands there".
  std::string_view solver = "numeric";
  int branch = -1;          // of the closed form, see ClosedSolution; -1: numeric
  Eigen::VectorXd margins;  // from each joint to its nearer limit, rad or m; below 0: beyond it
  double posture = 0.0;     // value of the posture asked for (posture_value)
  IkDiagnosis diagnosis;

  bool ok() const { return status == IkStatus::kOk; }
};

// Joint values that bring the tool point to a pose, within the limits and near the seed.
//
// T_world_tool  the goal, in the world.
// returns       a result with a status; a goal or seed that is wrong gives a status, not an
//               exception.
// throws        ArgumentError if a posture is given whose q_given has not n elements.
// source        of the iterations: S. K. Chan, P. D. Lawrence, General inverse kinematics with the
//               error damped pseudoinverse, ICRA 1988; of the closed forms: see closed_form.hpp.
IkResult solve_ik(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                  const IkOptions& options = {});

// Distinct solutions, nearest to the seed first, at most `count`: every branch of the closed form
// if the arm has one, otherwise those that the search finds. An arm with more than six joints has
// infinitely many solutions; those with the arm angle of the seed are returned, or else examples.
// With kPositionFirst: all solutions of an arm whose closed form is for positions; of other arms
// those with the orientation of the seed, or with the reachable one nearest to it.
std::vector<Eigen::VectorXd> solve_ik_all(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                                          const IkOptions& options = {}, int count = 16);

// "elbow up, wrist flipped": the branch of a result in words; empty if no closed form gave it.
std::string branch_name(const Robot& robot, const IkResult& result);

// One full sentence that says why a result is not ok, with distances, angles and joints.
std::string explain(const Robot& robot, const Eigen::Isometry3d& T_world_tool,
                    const IkResult& result);

}  // namespace armlet
