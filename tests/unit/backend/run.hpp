// A short run told to a backend: two robots, one object, one of everything.
#pragma once

#include <array>

#include "armlet/backend/backend.hpp"

namespace armlet {

inline void play_short_run(Backend& backend) {
  const RunInfo run{
      .robots = {{"arm", {JointUnit::kRadian, JointUnit::kMetre}}, {"left", {JointUnit::kRadian}}},
      .objects = {{.name = "cube",
                   .shape = "box",
                   .size = {0.04, 0.04, 0.04},
                   .mass = 0.2,
                   .color = "red"}}};
  backend.begin(run);
  const std::array q{0.1, -0.0};
  const std::array qd{1.0 / 3.0, 2.5};
  const std::array qdd{-1e-20, 4.0};
  JointSample sample{.t_ns = 10000000, .robot = 0, .q = q, .qd = qd, .qdd = qdd};
  sample.T_world_tool.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  backend.joint_sample(sample);
  backend.object_event({.t_ns = 10000000, .name = "cube", .robot = 1});
  backend.object_sample({.t_ns = 20000001, .name = "cube"});
  backend.object_added(20000001, {.name = "ball", .shape = "sphere", .size = {0.02}});
  backend.object_event({.t_ns = 30000000, .change = ObjectChange::kRemoved, .name = "ball"});
  backend.note({.t_ns = 30000000, .text = "say \"hi\",\n now"});
  backend.note({.t_ns = 30000000, .kind = NoteKind::kAdvice, .text = "slower"});
  backend.robot_added(40000000, {"late", {JointUnit::kMetre}});
  backend.end(3000000000);
}

}  // namespace armlet
