#pragma once

#include "armlet/model/joint_arrays.hpp"

// All throw ArgumentError unless their arguments have n finite elements and the result is finite.
namespace armlet {

// 1/2 qd' M(q) qd, with the motors' rotors, J.
double kinetic_energy(const Robot& robot, JointsIn q, JointsIn qd);

// Minus the sum over the links of mass times gravity times centre of mass, J; a mass at the world's
// origin contributes zero.
double potential_energy(const Robot& robot, JointsIn q);

}  // namespace armlet
