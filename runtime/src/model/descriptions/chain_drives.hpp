#pragma once

#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"

namespace armlet {

// A joint of an arm that is a chain of a mechanism: its value is ratio a + offset, with a the value
// of an actuator.
//
// row  of the chain that it moves directly, from 0.
struct ChainJoint {
  Eigen::Index actuator = -1;
  int row = -1;
  double ratio = 1.0;
  double offset = 0.0;
};

// drives  Joint::drive of each row.
// joints  in the order of their rows.
struct ChainDrives {
  std::vector<RowDrive> drives;
  std::vector<ChainJoint> joints;
};

// The drives of the rows of a chain. If one actuator moves several rows, the joint is the row that
// has the actuator's name, or that moves with it one to one, or else the first; the others are
// mimic joints of it.
//
// chain    moving bodies, from the base to the tip.
// returns  an error for a row with several actuators, or none.
Result<ChainDrives> drives_of_chain(const Mechanism& mechanism, const std::vector<int>& chain);

// The rows of the joint table: kinds, limits and drives. A joint is restricted to the limits of its
// mimic joints, which a note reports; limits that leave no range are ignored, and so is a whole
// revolution.
std::vector<Joint> joints_of_chain(const Mechanism& mechanism, const std::vector<int>& chain,
                                   const ChainDrives& drives, std::vector<std::string>& notes);

// Joint values of the mechanism while all joints of the chain are at zero: the offsets of the
// coupling.
Eigen::VectorXd values_at_zero(const Mechanism& mechanism, const ChainDrives& drives);

// Adds the motor and the friction of a mimic joint, times a ratio, to those of the link that its
// source joint moves.
void add_copied_motor(const Link& copy, double ratio, Link& leader);

}  // namespace armlet
