// Take-up of new joint speeds: all joints together, from any speeds and accelerations.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace armlet {

// Largest accelerations and jerks of the joints, > 0.
//
// turn  jerk while the direction of the acceleration changes, not below `jerk`.
struct TakeUpLimits {
  Eigen::VectorXd acceleration;
  Eigen::VectorXd jerk;
  Eigen::VectorXd change;

  [[nodiscard]] TakeUpLimits part(double share) const {
    return {share * acceleration, share * jerk, share * change};
  }
};

// An interval of constant jerks of all joints.
struct TakeUpPiece {
  double duration = 0.0;  // s, > 0
  Eigen::VectorXd jerk;
};

// Brings speeds with the error x0 and the accelerations a0 to their targets: the error is 0 after
// the last piece.
struct TakeUp {
  Eigen::VectorXd x0;
  Eigen::VectorXd a0;
  std::vector<TakeUpPiece> pieces{};

  struct State {
    Eigen::VectorXd x;  // error of the speeds
    Eigen::VectorXd a;  // accelerations
  };
  [[nodiscard]] State at(double t) const;
  [[nodiscard]] double duration() const;
};

// The take-up from speeds with the error x and accelerations a.
//
// First the acceleration is rotated, with one constant jerk, into the direction in which the error
// then decays along a straight line as fast as the limits allow. The shortest such rotation is
// chosen after which the error decays without changing its sign; it is never longer than bringing
// the acceleration to zero. Two properties follow.
//
// * Planned again from any state on the take-up, the plan is the rest of the same take-up, because
//   the rest of a shortest rotation is the shortest rotation.
// * The speeds stay in the triangle of the present speeds, the speeds which they would have if the
//   acceleration was brought to zero, and the new ones, because the rotation is a parabola that
//   starts along the first side and ends on a line through the last corner. So no speed, of a joint
//   or of a tool that moves with the joints, exceeds the largest at the corners.
TakeUp plan_take_up(const Eigen::VectorXd& x, const Eigen::VectorXd& a, const TakeUpLimits& limits);

// The superposition: errors, accelerations and jerks are the sums.
TakeUp sum_of(const TakeUp& first, const TakeUp& second);

}  // namespace armlet
