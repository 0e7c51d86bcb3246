#pragma once
// Joint values as arguments.

#include <array>

#include "values/bind.hpp"
#include "values/robots/robot_state.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Joint values in a call: a posJ, or a list of numbers.
using Joints = const PosJ&;
using JointList = std::span<const double>;

// The joint values of an argument; fails unless there is one for each joint of the robot.
Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, JointList values, int parameter);
Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, const PosJ& values,
                                       int parameter);

// The joint values of the arguments 1, 2 and so on.
template <class... Lists>
Answer<std::array<Eigen::VectorXd, sizeof...(Lists)>> joint_arguments(Vm& vm, const Robot& robot,
                                                                      const Lists&... lists) {
  std::array<Eigen::VectorXd, sizeof...(Lists)> values;
  int parameter = 0;
  const auto read = [&](const auto& list) {
    auto given = joint_argument(vm, robot, list, parameter + 1);
    if (!given) return false;
    values[static_cast<std::size_t>(parameter++)] = *std::move(given);
    return true;
  };
  if (!(read(lists) && ...)) return Failed{};
  return values;
}

// law(robot, q) for the joint values of argument 1; a failure if they do not fit the robot.
template <class Result, class Q, class Law>
Answer<Result> at_joints(Vm& vm, const RobotRef& r, Q values, const Law& law) {
  if (!check_arm(vm, r.id)) return Failed{};
  const Robot& robot = model_of(vm, r);
  const auto q = joint_argument(vm, robot, values, 1);
  if (!q) return Failed{};
  return Answer<Result>(law(robot, *q));
}

// law(robot, q, qd) for the joint values of argument 1 and the joint speeds of argument 2.
template <class Result, class Q, class Rates, class Law>
Answer<Result> at_joint_speeds(Vm& vm, const RobotRef& r, Q values, Rates rates, const Law& law) {
  if (!check_arm(vm, r.id)) return Failed{};
  const Robot& robot = model_of(vm, r);
  const auto given = joint_arguments(vm, robot, values, rates);
  if (!given) return Failed{};
  const auto& [q, qd] = *given;
  return Answer<Result>(law(robot, q, qd));
}

// The seed for a solution: the joint values of an argument, or the present ones.
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, const PosJ* near, int parameter);
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, JointList near, int parameter);

}  // namespace armlet::bind
