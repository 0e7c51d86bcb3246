#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace armlet::bench {

// Rotation by rows, then the position: a type that code with both alignments of Eigen can
// exchange.
using PlainPose = std::array<double, 12>;

// One joint: Rz(theta) Tz(d) followed by Tx(a) Rx(alpha).
struct KdlJoint {
  bool revolute = true;
  double theta = 0.0, d = 0.0, a = 0.0, alpha = 0.0;
  double lower = 0.0, upper = 0.0;
};

// The rigid body after a joint, in the frame after Tx(a) Rx(alpha): mass, centre, and inertia about
// the centre by xx, yy, zz, xy, xz, yz.
struct KdlBody {
  double mass = 0.0;
  std::array<double, 3> com{};
  std::array<double, 6> inertia{};
};

// An arm in Orocos KDL. It is compiled without the alignment of Eigen's types that Armlet uses, as
// the installed KDL library requires. Inputs are passed before the time is measured.
class [[gnu::visibility("default")]] KdlArm {
 public:
  KdlArm(const PlainPose& base, const std::vector<KdlJoint>& joints, const PlainPose& tool);
  ~KdlArm();

  void add_configuration(const double* q);
  void add_goal(const PlainPose& T_world_tool);
  void change_first_joint(int k, double amount);

  // For configuration k: a number that depends on the result; the other two functions copy it.
  double pose(int k);
  double frames(int k);  // of all segments
  double jacobian(int k);
  PlainPose last_pose() const;
  std::vector<double> last_jacobian() const;  // column by column

  // The Levenberg-Marquardt solver with weights for metres and radians (with its default weights,
  // made for millimetres, it hardly ever finds a solution), restarted at random until the solution
  // is within the limits.
  //
  // iterations  per start; the default of the solver is 500.
  bool solve(int k, const std::vector<double>& start, double tolerance, int iterations,
             int restarts);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace armlet::bench
