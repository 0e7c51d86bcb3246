#pragma once

#include "armlet/model/joint_arrays.hpp"

// All throw ArgumentError unless their arguments have n finite elements and the result is finite.
namespace armlet {

// 1/2 qd' M(q) qd, with the motors' rotors, J.
double kinetic_energy(const Robot& robot, JointsIn q, JointsIn qd);

// Minus the sum over the links of mass times gravity times centre of mass, J; zero where a mass
// stands at the world's origin.
double potential_energy(const Robot& robot, JointsIn q);

}  // namespace armlet
