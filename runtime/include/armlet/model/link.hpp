#pragma once

#include <Eigen/Core>
#include <string>

namespace armlet {

// Friction seen at the motor's shaft. The joint feels
// f(qd) = gear^2 viscous qd + |gear| (coulomb_plus if qd > 0, coulomb_minus if qd < 0, else 0).
struct Friction {
  double viscous = 0.0;        // N m s/rad, >= 0
  double coulomb_plus = 0.0;   // N m, >= 0
  double coulomb_minus = 0.0;  // N m, <= 0
};

// The rigid body moved by a joint and the motor that moves it. Positions are in the link's own DH
// frame: the far end of the link for the standard convention, the near end for the modified one.
struct Link {
  double mass = 0.0;                                  // kg
  Eigen::Vector3d com = Eigen::Vector3d::Zero();      // centre of mass, m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre of mass, kg m^2
  double motor_inertia = 0.0;                         // of the rotor, kg m^2
  double gear = 1.0;                                  // motor turns per joint turn, may be negative
  Friction friction;
  std::string mesh;  // file of the shape; empty: none
};

}  // namespace armlet
