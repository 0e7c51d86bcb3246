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
Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, JointList values, CallPart part);
Answer<Eigen::VectorXd> joint_argument(Vm& vm, const Robot& robot, const PosJ& values,
                                       CallPart part);

// The joint values of several arguments.
template <class... Lists>
Answer<std::array<Eigen::VectorXd, sizeof...(Lists)>> joint_arguments(
    Vm& vm, const Robot& robot, const std::array<CallPart, sizeof...(Lists)>& parts,
    const Lists&... lists) {
  std::array<Eigen::VectorXd, sizeof...(Lists)> values;
  std::size_t i = 0;
  const auto read = [&](const auto& list) {
    auto given = joint_argument(vm, robot, list, parts[i]);
    if (!given) return false;
    values[i++] = *std::move(given);
    return true;
  };
  if (!(read(lists) && ...)) return Failed{};
  return values;
}

// law(robot, q) for the joint values of the argument `q`; a failure if they do not fit the robot.
template <class Result, class Q, class Law>
Answer<Result> at_joints(Vm& vm, const RobotRef& r, Q values, const Law& law) {
  if (!check_arm(vm, r.id)) return Failed{};
  const Robot& robot = model_of(vm, r);
  const auto q = joint_argument(vm, robot, values, at("q"));
  if (!q) return Failed{};
  return Answer<Result>(law(robot, *q));
}

// law(robot, q, qd) for the joint values of `q` and the joint speeds of `qd`.
template <class Result, class Q, class Rates, class Law>
Answer<Result> at_joint_speeds(Vm& vm, const RobotRef& r, Q values, Rates rates, const Law& law) {
  if (!check_arm(vm, r.id)) return Failed{};
  const Robot& robot = model_of(vm, r);
  const auto given = joint_arguments(vm, robot, {at("q"), at("qd")}, values, rates);
  if (!given) return Failed{};
  const auto& [q, qd] = *given;
  return Answer<Result>(law(robot, q, qd));
}

// The seed for a solution: the joint values of an argument, or the present ones.
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, const PosJ* near, CallPart part);
Answer<Eigen::VectorXd> seed_of(Vm& vm, const RobotRef& r, JointList near, CallPart part);

}  // namespace armlet::bind
