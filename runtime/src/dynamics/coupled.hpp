#pragma once

#include "armlet/model/joint_arrays.hpp"
#include "armlet/model/joint_coupling.hpp"

// Dynamics of arms with mimic joints: with the values E q + offset of the rows, their forces tau
// and their matrices M become E^T tau and E^T M E for the joints.
namespace armlet {

inline JointVector for_joints(const JointCoupling& coupling, const JointVector& of_rows) {
  return coupling.E.transpose() * of_rows;
}
inline JointMatrix for_joints(const JointCoupling& coupling, const JointMatrix& of_rows) {
  return coupling.E.transpose() * of_rows * coupling.E;
}

}  // namespace armlet
