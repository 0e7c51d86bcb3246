#include "armlet/vision/edges.hpp"

#include <algorithm>

#include "armlet/core/error.hpp"
#include "armlet/image/parameters.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {
namespace {

template <int kColumns>
Eigen::Matrix<double, Eigen::Dynamic, kColumns> rows_of(const std::vector<double>& numbers) {
  Eigen::Matrix<double, Eigen::Dynamic, kColumns> rows(
      static_cast<Eigen::Index>(numbers.size()) / kColumns, kColumns);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    rows(static_cast<Eigen::Index>(i) / kColumns, static_cast<Eigen::Index>(i) % kColumns) =
        numbers[i];
  return rows;
}

void check_black_and_white(const Image& edges) {
  const auto bytes = edges.bytes();
  if (std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t v) { return v == 0 || v == 255; }))
    return;
  throw ArgumentError(
      "Lines are looked for in a picture of edges, whose pixels are 0 or 255: lines(edges(img)).");
}

}  // namespace

Image find_edges(const Image& grey, double low, double high) {
  check_door_picture("edges", grey, true);
  check_picture_parameter("edges", "low", low);
  check_picture_parameter("edges", "high", high);
  if (low > high) throw ArgumentError("`low` of `edges` is above `high`.");
  return call_opencv(&OpencvDoor::edges, {.picture = door_picture(grey)}, {low, high}).picture;
}

Eigen::Matrix<double, Eigen::Dynamic, 4> find_lines(const Image& edges,
                                                    const LineOptions& options) {
  check_door_picture("lines", edges, true);
  check_picture_parameter("lines", "votes", options.votes);
  check_picture_parameter("lines", "minLength", options.min_length);
  check_picture_parameter("lines", "maxGap", options.max_gap);
  check_black_and_white(edges);
  return rows_of<4>(
      call_opencv(&OpencvDoor::lines, {.picture = door_picture(edges)},
                  {static_cast<double>(options.votes), options.min_length, options.max_gap})
          .numbers);
}

Eigen::Matrix<double, Eigen::Dynamic, 3> find_circles(const Image& grey,
                                                      const CircleOptions& options) {
  check_door_picture("circles", grey, true);
  check_picture_parameter("circles", "minRadius", options.min_radius);
  check_picture_parameter("circles", "maxRadius", options.max_radius);
  check_picture_parameter("circles", "distance", options.distance);
  check_picture_parameter("circles", "edge", options.edge);
  check_picture_parameter("circles", "roundness", options.roundness);
  if (options.min_radius > options.max_radius)
    throw ArgumentError("`minRadius` of `circles` is above `maxRadius`.");
  return rows_of<3>(
      call_opencv(&OpencvDoor::circles, {.picture = door_picture(grey)},
                  {static_cast<double>(options.min_radius), static_cast<double>(options.max_radius),
                   options.distance, options.edge, options.roundness})
          .numbers);
}

}  // namespace armlet
