#pragma once

#include <memory>
#include <vector>

#include "kdl_arm.hpp"

namespace armlet::bench {

// The dynamics of an arm in Orocos KDL, compiled separately like KdlArm. Inputs are passed before
// the time is measured.
class [[gnu::visibility("default")]] KdlDynamics {
 public:
  // gravity  in the axes of the base of `arm`.
  KdlDynamics(const std::vector<KdlJoint>& joints, const std::vector<KdlBody>& bodies,
              const std::array<double, 3>& gravity);
  ~KdlDynamics();

  void add_motion(const double* q, const double* qd, const double* qdd, const double* tau);

  // For motion k: a number that depends on the result; the last two functions copy the result.
  double inverse(int k);
  double gravity(int k);
  double mass(int k);
  // Inertia matrix, bias forces and the factors of the matrix: KDL's own solver for forward
  // dynamics takes four times as long with six joints.
  double forward(int k);
  std::vector<double> last_forces() const;
  std::vector<double> last_mass() const;  // column by column

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace armlet::bench
