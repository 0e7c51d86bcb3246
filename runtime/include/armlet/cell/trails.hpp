#pragma once
// The paths of tool points, shown as lines.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

class Cell;

// At most one trail for each robot. A trail is made of straight pieces (world/drawings.hpp) between
// positions of the tool point that are at least `kPiece` apart, and ends where a motion ends. Of a
// long trail the last kMostPieces are kept.
class Trails {
 public:
  static constexpr double kPiece = 0.005;  // m
  static constexpr int kMostPieces = 4000;

  // Begins the trail of a robot at the present position of its tool point. An existing trail
  // continues, and its next pieces have this colour and width.
  //
  // width   m.
  // throws  ArgumentError for a robot that does not exist, and a width out of range.
  void begin(const Cell& cell, int robot, std::string color, double width);
  [[nodiscard]] bool empty() const { return trails_.empty(); }
  // Draws the path since the last piece of a robot, if it is long enough or `at_end`.
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
