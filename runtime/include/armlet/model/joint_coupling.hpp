#pragma once

#include <string>

#include "armlet/model/joint_arrays.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// A joint table with mimic joints. With n joint values q, the values of the m rows are E q +
// offset, and the joint forces are E^T times the forces of the rows. So results computed for rows
// that move independently give the results for the joints.
//
// E     m x n, one entry in each row.
// rows  the arm with an independent joint in every row. It has the links, the tool and the payload,
//       but not RobotSpec::followers.
struct JointCoupling {
  JointMatrix E;
  JointVector offset;
  Robot rows;

  // From the spec of a robot with mimic joints, with all rates of its joints and a home.
  //
  // throws  ArgumentError as Robot does.
  explicit JointCoupling(const RobotSpec& spec);

  JointVector values(JointsIn q) const { return E * q + offset; }
  JointVector rates(JointsIn qd) const { return E * qd; }
};

// The joint that moves row k, from 0, and the ratio.
struct RowMotion {
  int joint = 0;
  double ratio = 1.0;
};
RowMotion motion_of_row(const Robot& robot, int k);

// Values and rates of the rows of any robot, and its joint forces from the forces of the rows.
JointVector row_values(const Robot& robot, JointsIn q);
JointVector row_rates(const Robot& robot, JointsIn qd);
JointVector joint_forces(const Robot& robot, JointsIn of_rows);

// "-0.5 x joint 2 + 10 deg" for the row of a mimic joint, else empty.
std::string copy_text(const Robot& robot, int k);

}  // namespace armlet
