// Pictures that cameras of a cell take.

#include <fmt/format.h>

#include <cmath>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"

namespace armlet {

int Cell::add_camera(Camera camera) {
  const int number = cameras_.add(std::move(camera));
  publish_camera(cameras_.at(number));
  return number;
}

Image Cell::capture(int camera, const Eigen::Isometry3d& T_world_camera,
                    std::optional<Image> given) {
  if (const Image* taken = cameras_.taken_at(camera, now_ns(), T_world_camera)) return *taken;
  const std::uint64_t frame = cameras_.taken(camera);
  Image image = given ? cameras_.take_given(camera, *std::move(given))
                      : cameras_.color(*this, camera, T_world_camera);
  cameras_.keep(camera, now_ns(), T_world_camera, image);
  publish_frame({.t_ns = now_ns(),
                 .camera = cameras_.at(camera).name,
                 .frame = frame,
                 .width = image.width(),
                 .height = image.height(),
                 .channels = image.channels(),
                 .pixels = image.bytes(),
                 .T_world_camera = T_world_camera});
  return image;
}

std::int64_t Cameras::next_frame_ns(int camera, std::int64_t now_ns) const {
  const double rate = at(camera).rate;
  if (rate == 0.0) return now_ns;
  const auto instant = [&](double k) {
    return static_cast<std::int64_t>(std::floor(k * 1e9 / rate));
  };
  double k = std::floor(static_cast<double>(now_ns) * 1e-9 * rate);
  while (k > 0.0 && instant(k) > now_ns) k -= 1.0;
  while (instant(k) <= now_ns) k += 1.0;
  return instant(k);
}

std::uint64_t Cameras::taken(int camera) const {
  (void)at(camera);
  return taken_[static_cast<std::size_t>(camera)];
}

const Image* Cameras::taken_at(int camera, std::int64_t t_ns,
                               const Eigen::Isometry3d& T_world_camera) const {
  if (at(camera).rate == 0.0) return nullptr;
  const auto found = last_.find(camera);
  if (found == last_.end() || found->second.t_ns != t_ns ||
      found->second.T_world_camera.matrix() != T_world_camera.matrix())
    return nullptr;
  return found->second.image.get();
}

void Cameras::keep(int camera, std::int64_t t_ns, const Eigen::Isometry3d& T_world_camera,
                   const Image& image) {
  if (at(camera).rate == 0.0) return;
  last_[camera] = {t_ns, T_world_camera, std::make_shared<const Image>(image)};
}

Image Cameras::take_given(int camera, Image given) {
  const Intrinsics& lens = at(camera).lens.intrinsics();
  if (given.width() != lens.width || given.height() != lens.height) {
    throw ArgumentError(fmt::format("A picture for `{}` is {} x {}; expected {} x {}, as it takes.",
                                    at(camera).name, given.width(), given.height(), lens.width,
                                    lens.height));
  }
  if (given.kind() != PixelKind::kRgb) {
    throw ArgumentError(
        fmt::format("A picture for `{}` has one channel; expected three, RGB.", at(camera).name));
  }
  ++taken_[static_cast<std::size_t>(camera)];
  return given;
}

}  // namespace armlet
