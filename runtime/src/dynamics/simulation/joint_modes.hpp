#pragma once

#include <array>

#include "armlet/model/joint_arrays.hpp"
#include "dynamics/checks.hpp"

namespace armlet {

// The mode of each joint: it slides in one direction, against dry friction, or it is at rest, held
// by friction or by the stop at a limit. Within a mode the equation of motion is smooth.
class JointModes {
 public:
  struct Mode {
    bool stands = false;
    int slides = 0;   // 1 or -1; 0: no dry friction
    int at_stop = 0;  // 1: at its upper limit, -1: at its lower
  };

  explicit JointModes(const Robot& robot) : robot_(&robot) {}

  void set_robot(const Robot& robot) { robot_ = &robot; }
  [[nodiscard]] const Mode& operator[](Eigen::Index i) const {
    return modes_[static_cast<std::size_t>(i)];
  }

  // Writes the accelerations of the present modes. False: joint bad_joint() moves no inertia.
  [[nodiscard]] bool accelerate(const double* q, const double* qd, const double* tau, double* qdd);
  [[nodiscard]] int bad_joint() const { return bad_joint_; }

  // The margin of the modes: the smallest one is below zero when a mode has ended.
  [[nodiscard]] double margin(const double* q, const double* qd, const double* tau);
  // The margin of one joint, after a call of margin().
  [[nodiscard]] double margin_of(Eigen::Index i, const double* q, const double* qd) const;

  // Chooses the modes from here on; joints with a rate of zero may be at rest. False: joint
  // bad_joint() moves no inertia.
  [[nodiscard]] bool settle(const double* q, const double* qd, const double* tau);

  // Changes the rates by an impact of joint i against its stop. False as above.
  [[nodiscard]] bool strike(Eigen::Index i, const double* q, double* qd, double restitution);

  // The force of friction in joint i in its mode.
  [[nodiscard]] double friction(Eigen::Index i, double qd) const;

 private:
  // The range of forces with which friction and stop can hold a joint, against the motor's.
  struct Range {
    double lowest, highest;
  };
  [[nodiscard]] const PlanLink& motor(Eigen::Index i) const {
    return robot_->derived<RobotDynamics>().plan.links[robot_->row_of(static_cast<int>(i))];
  }
  // Whether the arm is more than one chain: there are links outside of it, or mimic joints.
  [[nodiscard]] bool is_composed() const;
  [[nodiscard]] Range range_of(Eigen::Index i) const;
  [[nodiscard]] bool has_dry_friction(Eigen::Index i) const;
  [[nodiscard]] bool may_stand(Eigen::Index i, double qd) const;
  [[nodiscard]] bool is_wrong(Eigen::Index i, double qd, double qdd) const;
  void flip(Eigen::Index i);
  void look_at_stop(Eigen::Index i, double q);
  template <class Moves>
  [[nodiscard]] bool solve_part(const JointMatrix& M, const Moves& moves, const JointVector& b,
                                JointVector& x);
  // Accelerations with the joints at rest held, and the holding forces in hold_.
  [[nodiscard]] bool accelerate_held(const double* q, const double* qd, const double* tau,
                                     double* qdd);

  const Robot* robot_;
  std::array<Mode, kMaxJoints> modes_{};
  JointVector hold_;
  bool any_stands_ = false;
  int bad_joint_ = 0;
};

}  // namespace armlet
