#include "armlet/vision/corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "armlet/core/error.hpp"
#include "armlet/image/arithmetic.hpp"
#include "armlet/vision/fast.hpp"
#include "armlet/vision/harris.hpp"
#include "armlet/vision/refine.hpp"
#include "armlet/vision/susan.hpp"

namespace armlet {
namespace {

PlanePoints susan_points(const Image& grey, const CornerOptions& options) {
  std::vector<SusanCorner> corners = susan_corners(grey, {.threshold = options.threshold});
  std::ranges::stable_sort(corners, std::greater<>{}, &SusanCorner::response);
  if (options.max > 0)
    corners.resize(std::min(corners.size(), static_cast<std::size_t>(options.max)));
  PlanePoints points(static_cast<Eigen::Index>(corners.size()), 2);
  for (std::size_t i = 0; i < corners.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) << corners[i].x, corners[i].y;
  return points;
}

PlanePoints harris_points(const Image& grey, const CornerOptions& options) {
  const auto corners = harris_corners(grey, {.quality = options.quality,
                                             .distance = options.distance,
                                             .sensitivity = options.sensitivity,
                                             .max = options.max});
  PlanePoints points(static_cast<Eigen::Index>(corners.size()), 2);
  for (std::size_t i = 0; i < corners.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) << corners[i].x, corners[i].y;
  return points;
}

PlanePoints fast_points(const Image& grey, const CornerOptions& options) {
  PlanePoints points = fast_corners(grey, options.threshold);
  if (options.max > 0 && options.max < points.rows())
    points.conservativeResize(options.max, Eigen::NoChange);
  return points;
}

PlanePoints detected(const Image& grey, const CornerOptions& options) {
  switch (options.method) {
    case CornerMethod::kHarris:
      return harris_points(grey, options);
    case CornerMethod::kFast:
      return fast_points(grey, options);
    case CornerMethod::kSusan:
      break;
  }
  return susan_points(grey, options);
}

}  // namespace

PlanePoints find_corners(const Image& grey, const CornerOptions& options) {
  if (options.max < 0)
    throw ArgumentError(
        fmt::format("At most {} corners are asked for; expected 0 or more.", options.max));
  PlanePoints points = detected(grey, options);
  if (!options.refine || points.rows() == 0) return points;
  const std::vector<RefinedCorner> refined = refine_corners(grey, points);
  for (std::size_t i = 0; i < refined.size(); ++i) {
    if (refined[i].end == RefineEnd::kConverged || refined[i].end == RefineEnd::kIterations)
      points.row(static_cast<Eigen::Index>(i)) << refined[i].x, refined[i].y;
  }
  return points;
}

PlanePoints find_corners_around(const Image& grey, const PlanePoints& places, double within,
                                const CornerOptions& options) {
  if (places.rows() == 0 || !places.allFinite() || !std::isfinite(within))
    throw ArgumentError("Corners are looked for around one place or more, all finite numbers.");
  // px: detectors leave out a border, and corners are compared with their neighbours.
  constexpr double kBorder = 16.0;
  const double margin = within + kBorder;
  const auto pixel = [](double at, int most) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(most)));
  };
  const PixelBox box{pixel(std::floor(places.col(0).minCoeff() - margin), grey.width()),
                     pixel(std::floor(places.col(1).minCoeff() - margin), grey.height()),
                     pixel(std::ceil(places.col(0).maxCoeff() + margin) + 1.0, grey.width()),
                     pixel(std::ceil(places.col(1).maxCoeff() + margin) + 1.0, grey.height())};
  if (box.right <= box.left || box.bottom <= box.top) return PlanePoints(0, 2);
  PlanePoints points = find_corners(cropped(grey, box), options);
  points.rowwise() += Eigen::RowVector2d(box.left, box.top);
  return points;
}

}  // namespace armlet
