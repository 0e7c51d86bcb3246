#pragma once
// Cameras of a run, for its record.

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "armlet/camera/pinhole.hpp"

namespace armlet::lab {

// A camera of the program.
//
// robot, link  that carry it; link is counted as in Mount; -1: it is in the world or on an object.
// object       that carries it; empty: none.
struct RecordedCamera {
  std::string name;
  Intrinsics lens;
  int robot = -1;
  int link = 0;
  std::string object;
  Eigen::Isometry3d T_on_camera = Eigen::Isometry3d::Identity();
};

// taken  the number of pictures that all of them took.
struct RecordedCameras {
  std::vector<RecordedCamera> list;
  std::uint64_t taken = 0;
};

}  // namespace armlet::lab
