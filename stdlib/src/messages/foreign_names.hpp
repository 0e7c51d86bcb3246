#pragma once
// What users of robot languages, of MATLAB and of Python write for names of this library.

#include "armlet/interpreter/foreign_name.hpp"

namespace armlet::bind {

inline constexpr ForeignName kForeignNames[] = {
    {"MoveAbsJ", "moveJ", "moveJ with a posJ moves the joints"},
    {"MoveJ", "moveJ"},
    {"MoveL", "moveL"},
    {"MoveC", "moveCirc", "here C stands for Cartesian; arcs are moveCirc(via, goal)"},
    {"PTP", "moveJ"},
    {"LIN", "moveL"},
    {"CIRC", "moveCirc"},
    {"SPTP", "moveJ"},
    {"SLIN", "moveL"},
    {"movej", "moveJ"},
    {"movel", "moveL"},
    {"movec", "moveCirc"},
    {"movep", "moveL"},
    {"open_gripper", "release"},
    {"close_gripper", "grasp"},
    {"pi", "PI"},
    {"time.time", "now"},
    {"toFixed", "round", "a format shows digits: f\"{x:.2f}\""},
    // figures
    {"bar", "bars"},
    {"qplot", "plot"},
    {"plot3", "scatter3"},
    {"savefig", "savePlot"},
    {"saveas", "savePlot"},
    {"title", "", "the title of a figure is given where it begins: figure(\"speed\")"},
    {"legend", "", "a line gets its name where it is drawn: plot(t, y, label: \"joint 1\")"},
    {"xlabel", "", "axes get their units from the types of what is drawn"},
    {"ylabel", "", "axes get their units from the types of what is drawn"},
    {"subplot", "", "each figure(\"...\") is a picture; plot(tr) and plot(run) draw panels"},
    {"semilogx", "", "figure(\"...\", log: \"x\") before plot(x, y) makes the axis logarithmic"},
    {"semilogy", "", "figure(\"...\", log: \"y\") before plot(x, y) makes the axis logarithmic"},
    {"loglog", "", "figure(\"...\", log: \"xy\") before plot(x, y) makes the axes logarithmic"},
    // types
    {"Point", "posC", "", ForeignKind::kType},
    {"Pose", "posC", "", ForeignKind::kType},
    {"pose", "posC", "", ForeignKind::kType},
    {"Robot", "robot", "", ForeignKind::kType},
    {"Object", "object", "", ForeignKind::kType},
    // settings of moves
    {"velocity", "speed", "", ForeignKind::kSetting},
    {"vel", "speed", "", ForeignKind::kSetting},
    {"v", "speed", "", ForeignKind::kSetting},
    {"acceleration", "accel", "", ForeignKind::kSetting},
    {"acc", "accel", "", ForeignKind::kSetting},
    {"a", "accel", "", ForeignKind::kSetting},
    {"duration", "time", "", ForeignKind::kSetting},
    {"t", "time", "", ForeignKind::kSetting},
    {"zone", "blend", "", ForeignKind::kSetting},
    {"radius", "blend", "", ForeignKind::kSetting},
    {"r", "blend", "", ForeignKind::kSetting},
    {"planner", "traj", "", ForeignKind::kSetting},
    {"trajectory", "traj", "", ForeignKind::kSetting},
    {"tolerance", "tol", "", ForeignKind::kSetting},
    {"tcp", "tool", "", ForeignKind::kSetting},
    {"wobj", "frame", "", ForeignKind::kSetting},
    {"base", "frame", "", ForeignKind::kSetting},
};

}  // namespace armlet::bind
