#pragma once
// The ways that hands have gone, as lines that are only shown.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

class Cell;

// Of each robot at most one. A trail is made of straight pieces (world/drawings.hpp) between places
// of the tool point that are at least `kPiece` apart, and ends where a motion ends. Of long ones
// the last kMostPieces are kept.
class Trails {
 public:
  static constexpr double kPiece = 0.005;  // m
  static constexpr int kMostPieces = 4000;

  // The trail of a robot begins where its tool point is now; one that it has goes on, and its next
  // pieces look like this.
  //
  // width   m.
  // throws  ArgumentError for a robot that is not there, and a width out of range.
  void begin(const Cell& cell, int robot, std::string color, double width);
  [[nodiscard]] bool empty() const { return trails_.empty(); }
  // Draws the way since the last piece of a robot, if it is long enough or `at_end`.
  void extend(Cell& cell, int robot, bool at_end);

 private:
  struct Trail {
    int robot = 0;
    std::string color;
    double width = 0.0;
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    int pieces = 0;
  };
  std::vector<Trail> trails_;
};

}  // namespace armlet
