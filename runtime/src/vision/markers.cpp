#include "armlet/vision/markers.hpp"

#include <fmt/format.h>

#include "armlet/core/error.hpp"
#include "armlet/image/parameters.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {
namespace {

constexpr std::int64_t kMostMarkerPixels = 2'097'152;  // noise has many squares to check

}  // namespace

std::vector<FoundMarker> find_markers(const Image& grey, int dictionary) {
  check_door_picture("markers", grey, true, kMostMarkerPixels);
  check_picture_parameter("markers", "dictionary", dictionary);
  const OpencvResult found = call_opencv(&OpencvDoor::markers, {.picture = door_picture(grey)},
                                         {static_cast<double>(dictionary)});
  constexpr std::size_t kNumbers = 9;  // of a marker
  std::vector<FoundMarker> markers;
  for (std::size_t i = 0; i + kNumbers <= found.numbers.size(); i += kNumbers) {
    FoundMarker marker{.id = static_cast<int>(found.numbers[i])};
    for (int k = 0; k < 4; ++k) {
      const std::size_t at = i + 1 + static_cast<std::size_t>(2 * k);
      marker.corners.row(k) << found.numbers[at], found.numbers[at + 1];
    }
    markers.push_back(marker);
  }
  return markers;
}

Image marker_picture(int id, int dictionary, int cell) {
  check_picture_parameter("markerPicture", "id", id);
  check_picture_parameter("markerPicture", "dictionary", dictionary);
  check_picture_parameter("markerPicture", "cell", cell);
  return call_opencv(
             &OpencvDoor::marker, {},
             {static_cast<double>(dictionary), static_cast<double>(id), static_cast<double>(cell)})
      .picture;
}

Eigen::Matrix<double, 4, 3> marker_points(double size) {
  if (!(size > 0.0 && size < 1e6))
    throw ArgumentError(fmt::format("The size of a marker is {} m; expected more than 0.", size));
  const double half = 0.5 * size;
  Eigen::Matrix<double, 4, 3> points;
  points << -half, half, 0, half, half, 0, half, -half, 0, -half, -half, 0;
  return points;
}

}  // namespace armlet
