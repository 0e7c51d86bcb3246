#pragma once

#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"

namespace armlet {

// A joint of an arm that is a chain of a mechanism: its value is ratio a + offset, a that of an
// actuator.
//
// row  of the chain that it moves itself, counted from 0.
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

// What moves the rows of a chain. Of the rows that one actuator moves, the joint is the row that
// the actuator is named after, or that moves with it one to one, or else the first; the others copy
// it.
//
// chain    bodies that move, from the base to the tip.
// returns  an error for a row that several actuators move together, or none.
Result<ChainDrives> drives_of_chain(const Mechanism& mechanism, const std::vector<int>& chain);

// The rows of the joint table: kinds, limits and what moves them. Rows that copy a joint keep it
// within their own limits, which a note says; limits that leave it no range do not count, nor a
// whole revolution.
std::vector<Joint> joints_of_chain(const Mechanism& mechanism, const std::vector<int>& chain,
                                   const ChainDrives& drives, std::vector<std::string>& notes);

// Joint values of the mechanism while all joints of the chain are at zero: what the coupling adds
// to the values of its actuators.
Eigen::VectorXd values_at_zero(const Mechanism& mechanism, const ChainDrives& drives);

// Adds the motor and the friction of a link whose joint copies another one, times a ratio, to those
// of the link that this one moves.
void add_copied_motor(const Link& copy, double ratio, Link& leader);

}  // namespace armlet
