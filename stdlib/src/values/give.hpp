#pragma once
// Joint values as arguments.

#include "motion/moves.hpp"
#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Joint values in a call: a posJ, or a list of numbers.
using Joints = const PosJ&;
using JointList = std::span<const double>;

// The joint values of an argument, if there are as many as the robot has joints.
Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, JointList values, int parameter);
Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, const PosJ& values,
                                       int parameter);

// The joint values from which a robot looks for others: those of an argument, or the present ones.
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, const PosJ* near, int parameter);
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, JointList near, int parameter);

}  // namespace armlet::bind
