#include "armlet/vision/optical_flow.hpp"

#include <fmt/format.h>

#include <limits>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/parameters.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {

FollowedPoints follow_points(const Image& from, const Image& to, const PlanePoints& points,
                             const FlowOptions& options) {
  check_door_picture("flow", from, true);
  check_door_picture("flow", to, true);
  check_picture_parameter("flow", "window", options.window);
  check_picture_parameter("flow", "levels", options.levels);
  check_picture_parameter("flow", "within", options.within);
  if (from.width() != to.width() || from.height() != to.height()) {
    throw ArgumentError(fmt::format("The pictures are {} x {} and {} x {}; expected one size.",
                                    from.width(), from.height(), to.width(), to.height()));
  }
  if (options.window % 2 == 0)
    throw ArgumentError(fmt::format("`window` is {}; expected an odd number.", options.window));
  if (points.rows() < 1 || points.rows() > 1000)
    throw ArgumentError(fmt::format("There are {} points; expected 1 to 1000.", points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (!(points(i, 0) >= 0.0 && points(i, 0) <= from.width() - 1 && points(i, 1) >= 0.0 &&
          points(i, 1) <= from.height() - 1))
      throw ArgumentError(fmt::format("Point {} is outside of the picture.", i));
  }
  checkpoint(100'000 * static_cast<std::uint64_t>(points.rows()));
  const OpencvResult found =
      call_opencv(&OpencvDoor::flow,
                  {.picture = door_picture(from),
                   .other = door_picture(to),
                   .numbers = {{points.data(), static_cast<std::size_t>(points.size())}}},
                  {static_cast<double>(options.window), static_cast<double>(options.levels)});
  FollowedPoints result{.points = points};
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double* n = found.numbers.data() + 4 * i;
    const bool is_followed = n[2] != 0.0;
    result.way_back.push_back(is_followed ? n[3] : std::numeric_limits<double>::infinity());
    if (is_followed && n[3] <= options.within) {
      result.points.row(i) << n[0], n[1];
    } else {
      result.lost.push_back(static_cast<int>(i));
    }
  }
  return result;
}

}  // namespace armlet
