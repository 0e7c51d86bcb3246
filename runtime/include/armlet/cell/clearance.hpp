// What is nearest to the robots of a cell as they are now.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "armlet/cell/collisions.hpp"

namespace armlet {

// Two things and how far they are apart.
//
// distance          m, below zero if they overlap, by so much.
// p_body, p_other   in the world: their nearest points, or those that lie deepest in the other one.
struct Clearance {
  CellBody body;   // of the robot, or what it carries
  CellBody other;  // an object, another robot's, or of the same robot
  double distance = 0.0;
  Eigen::Vector3d p_body = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_other = Eigen::Vector3d::Zero();
};

// Of the robot with all that it carries, compared with what find_collisions compares it with: each
// pair of two things once. Those nearer than 0.01 mm, which touch or overlap, the deepest first, at
// most `most`; if there are none, the nearest pair that is not of its own links, if it is nearer
// than `reach`.
std::vector<Clearance> clearances(const Cell& cell, int robot, double reach, std::size_t most);

}  // namespace armlet
