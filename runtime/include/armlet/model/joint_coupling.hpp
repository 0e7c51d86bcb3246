#pragma once

#include <string>

#include "armlet/model/joint_arrays.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// The rows of a joint table of which some copy others. With n joint values q the values of the m
// rows are E q + offset, the forces of the joints E^T times those of the rows: what is worked out
// for the rows, each moving on its own, gives what holds for the joints.
//
// E     m x n, one entry in each row.
// rows  the arm whose rows all move on their own. It has the links, the tool and the payload, but
//       not RobotSpec::followers.
struct JointCoupling {
  JointMatrix E;
  JointVector offset;
  Robot rows;

  // Of the spec of a robot of which rows copy others, with all rates of its joints and a home.
  //
  // throws  ArgumentError as Robot does.
  explicit JointCoupling(const RobotSpec& spec);

  JointVector values(JointsIn q) const { return E * q + offset; }
  JointVector rates(JointsIn qd) const { return E * qd; }
};

// The joint that moves row k, counted from 0, and by which ratio.
struct RowMotion {
  int joint = 0;
  double ratio = 1.0;
};
RowMotion motion_of_row(const Robot& robot, int k);

// Positions and rates of the rows of any robot, and the forces of its joints from those of the
// rows.
JointVector row_values(const Robot& robot, JointsIn q);
JointVector row_rates(const Robot& robot, JointsIn qd);
JointVector joint_forces(const Robot& robot, JointsIn of_rows);

// "-0.5 x joint 2 + 10 deg" for a row that copies another one, else empty.
std::string copy_text(const Robot& robot, int k);

}  // namespace armlet
