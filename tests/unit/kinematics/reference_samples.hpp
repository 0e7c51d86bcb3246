#pragma once

#include <doctest/doctest.h>

#include "reference_robot.hpp"

namespace armlet::reference {

// Calls check(robot, sample, q) for every kinematic sample of every arm of tests/reference/robots;
// a failure names the arm. q  n, joint values of the sample, rad or m.
template <class Check>
void for_each_sample(const Check& check) {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const Json file = load(name);
    const Robot robot = robot_of(file.at("robot"));
    for (const Json& sample : file.at("kinematics")) {
      check(robot, sample, vector_of(sample.at("q")));
    }
  }
}

}  // namespace armlet::reference
