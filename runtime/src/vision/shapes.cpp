#include "armlet/vision/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/parameters.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {
namespace {

// Rows [first, last) of a picture.
Image rows_of(const Image& image, int first, int last) {
  Image part(image.width(), last - first, image.kind());
  std::copy(image.row(first), image.row(first) + image.width() * image.channels() * (last - first),
            part.row(0));
  return part;
}

// Calls work(part) for bands of rows, each with `margin` additional rows above and below, and
// combines the results.
//
// cost  operations for each pixel.
template <class F>
Image by_bands(const Image& image, int margin, std::uint64_t cost, F work) {
  constexpr std::uint64_t kBandWork = std::uint64_t{1} << 25U;
  const std::uint64_t row = cost * static_cast<std::uint64_t>(image.width());
  const int band = static_cast<int>(std::clamp<std::uint64_t>(kBandWork / row, 8, 8192));
  Image out(image.width(), image.height(), image.kind());
  for (int y = 0; y < image.height(); y += band) {
    const int end = std::min(y + band, image.height());
    const int above = std::max(0, y - margin), below = std::min(image.height(), end + margin);
    checkpoint(row * static_cast<std::uint64_t>(below - above));
    const Image part = work(rows_of(image, above, below));
    std::copy(part.row(y - above),
              part.row(y - above) + image.width() * image.channels() * (end - y), out.row(y));
  }
  return out;
}

}  // namespace

Image adaptive_threshold(const Image& grey, int radius, double offset, bool gaussian) {
  check_door_picture("adaptiveThreshold", grey, true);
  check_picture_parameter("adaptiveThreshold", "radius", radius);
  check_picture_parameter("adaptiveThreshold", "offset", offset);
  const std::uint64_t cost = gaussian ? 16 + static_cast<std::uint64_t>(radius) : 16;
  return by_bands(grey, radius, cost, [&](const Image& part) {
    return call_opencv(&OpencvDoor::adaptive, {.picture = door_picture(part)},
                       {static_cast<double>(radius), offset, gaussian ? 1.0 : 0.0})
        .picture;
  });
}

Image changed_by(Morphology operation, const Image& image, int radius, bool disc) {
  check_door_picture("erode", image, false);
  check_picture_parameter("erode", "radius", radius);
  if (operation == Morphology::kOpen || operation == Morphology::kClose) {
    const bool opens = operation == Morphology::kOpen;
    return changed_by(
        opens ? Morphology::kDilate : Morphology::kErode,
        changed_by(opens ? Morphology::kErode : Morphology::kDilate, image, radius, disc), radius,
        disc);
  }
  const auto side = static_cast<std::uint64_t>(2 * radius + 1);
  const std::uint64_t cost = (disc ? side * side / 8 : side / 4) + 4;
  return by_bands(image, radius, cost * static_cast<std::uint64_t>(image.channels()),
                  [&](const Image& part) {
                    return call_opencv(&OpencvDoor::morphology, {.picture = door_picture(part)},
                                       {operation == Morphology::kDilate ? 1.0 : 0.0,
                                        static_cast<double>(radius), disc ? 1.0 : 0.0})
                        .picture;
                  });
}

std::vector<PlanePoints> find_contours(const Image& grey, bool holes, double min_area) {
  check_door_picture("contours", grey, true);
  check_picture_parameter("contours", "minArea", min_area);
  const OpencvResult found = call_opencv(&OpencvDoor::contours, {.picture = door_picture(grey)},
                                         {holes ? 1.0 : 0.0, min_area});
  std::vector<PlanePoints> contours;
  std::size_t at = 1;
  for (auto left = static_cast<std::size_t>(found.numbers[0]); left > 0; --left) {
    PlanePoints& points = contours.emplace_back(static_cast<Eigen::Index>(found.numbers[at++]), 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i, at += 2)
      points.row(i) << found.numbers[at], found.numbers[at + 1];
  }
  return contours;
}

PlanePoints polygon_of(const PlanePoints& contour, double tolerance) {
  check_picture_parameter("polygon", "tolerance", tolerance);
  if (contour.rows() < 1 || contour.rows() > 100'000 || !contour.allFinite() ||
      contour.cwiseAbs().maxCoeff() > 1e6) {
    throw ArgumentError(fmt::format(
        "An outline of {} points; expected 1 to 100000 of finite numbers.", contour.rows()));
  }
  checkpoint(500 * static_cast<std::uint64_t>(contour.rows()));
  const OpencvResult found = call_opencv(
      &OpencvDoor::polygon,
      {.numbers = {{contour.data(), static_cast<std::size_t>(contour.size())}}}, {tolerance});
  return Eigen::Map<const PlanePoints>(found.numbers.data(),
                                       static_cast<Eigen::Index>(found.numbers.size() / 2), 2);
}

}  // namespace armlet
