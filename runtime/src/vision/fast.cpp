#include "armlet/vision/fast.hpp"

#include "armlet/image/parameters.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {

PlanePoints fast_corners(const Image& grey, int threshold) {
  check_door_picture("corners", grey, true);
  check_picture_parameter("corners", "threshold", threshold);
  const OpencvResult found = call_opencv(&OpencvDoor::fast, {.picture = door_picture(grey)},
                                         {static_cast<double>(threshold)});
  PlanePoints points(static_cast<Eigen::Index>(found.numbers.size() / 3), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto at = static_cast<std::size_t>(3 * i);
    points.row(i) << found.numbers[at], found.numbers[at + 1];
  }
  return points;
}

}  // namespace armlet
