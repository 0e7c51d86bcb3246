#include "values/world/cameras.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"

namespace armlet::bind {

namespace {
constexpr int kPixelSides = 2;
}  // namespace

const HostType kCamera = {
    .name = "camera",
    .size = sizeof(CameraRef),
    .is_handle = true,
    .equal =
        [](const void* a, const void* b) {
          return static_cast<const CameraRef*>(a)->id == static_cast<const CameraRef*>(b)->id;
        },
    .text =
        [](const void* value, std::string& out) {
          out += fmt::format("camera {}", static_cast<const CameraRef*>(value)->id + 1);
        },
    .help = "A camera of this cell.",
    .noun = "a camera"};

Failed fail_blind(Vm& vm, std::string_view clause, CallPart part, std::string fix) {
  Failure f;
  f.headline = {row("R0684"), {std::string(clause)}};
  f.mark = part;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

Answer<Points> points_of(Vm& vm, std::span<const Slot> rows, CallPart part) {
  Points points(static_cast<Eigen::Index>(rows.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto values = reals_value(rows[static_cast<std::size_t>(i)]);
    if (values.size() != 3) {
      return failure(vm, "R0613",
                     fmt::format("point {} has {} values; expected x, y and z", i, values.size()),
                     part);
    }
    points.row(i) << values[0], values[1], values[2];
    if (!points.row(i).allFinite())
      return not_finite(vm, fmt::format("a value of point {}", i), points.row(i).sum(), part);
  }
  if (points.rows() == 0) return failure(vm, "R0613", "there are no points", part);
  return points;
}

Answer<PlanePoints> pixels_of(Vm& vm, const MatrixObj& matrix, CallPart part,
                              std::string_view origin) {
  if (matrix.cols != kPixelSides || matrix.rows == 0) {
    return failure(
        vm, "R0613",
        fmt::format("pixels are the rows of an N x 2 matrix, x first; this one is {} x {}",
                    matrix.rows, matrix.cols),
        part);
  }
  PlanePoints pixels = Eigen::Map<const PlanePoints>(matrix.data(), matrix.rows, kPixelSides);
  for (Eigen::Index i = 0; i < pixels.size(); ++i) {
    if (!std::isfinite(pixels.data()[i]))
      return not_finite(vm, fmt::format("pixel {}{}", i / kPixelSides, origin), pixels.data()[i],
                        part);
  }
  return pixels;
}

Answer<Eigen::Isometry3d> pose_now(Vm& vm, const CameraRef& camera) try {
  Cell& cell = Host::of(vm).cell();
  return cell.cameras().T_world_camera(cell, camera.id);
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error), CallPart::first());
}

}  // namespace armlet::bind
