// A short run for a backend: two robots, one object, one of everything.
#pragma once

#include <array>

#include "armlet/backend/backend.hpp"

namespace armlet {

inline void play_short_run(Backend& backend) {
  const RunInfo run{.robots = {{"arm", {{JointUnit::kRadian}, {JointUnit::kMetre}}},
                               {"left", {{JointUnit::kRadian}}}},
                    .objects = {{.name = "cube",
                                 .shape = "box",
                                 .size = {0.04, 0.04, 0.04},
                                 .mass = 0.2,
                                 .color = "red"}}};
  backend.on(BeginRun{.run = run});
  const std::array q{0.1, -0.0};
  const std::array qd{1.0 / 3.0, 2.5};
  const std::array qdd{-1e-20, 4.0};
  JointSample sample{.t_ns = 10000000, .robot = 0, .q = q, .qd = qd, .qdd = qdd};
  sample.T_world_tool.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  backend.on(sample);
  backend.on(ObjectEvent{.t_ns = 10000000, .name = "cube", .robot = 1});
  backend.on(ObjectSample{.t_ns = 20000001, .name = "cube"});
  backend.on(
      ObjectAdded{.t_ns = 20000001, .object = {.name = "ball", .shape = "sphere", .size = {0.02}}});
  backend.on(ObjectEvent{.t_ns = 30000000, .change = ObjectChange::kRemoved, .name = "ball"});
  backend.on(Note{.t_ns = 30000000, .text = "say \"hi\",\n now"});
  backend.on(Note{.t_ns = 30000000, .kind = NoteKind::kAdvice, .text = "slower"});
  backend.on(RobotAdded{.t_ns = 40000000, .robot = {"late", {{JointUnit::kMetre}}}});
  backend.on(EndRun{.t_ns = 3000000000});
}

}  // namespace armlet
