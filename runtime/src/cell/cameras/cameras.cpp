#include "armlet/cell/cameras.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/camera/renderer.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/image/blur.hpp"
#include "armlet/image/noise.hpp"
#include "armlet/image/parameters.hpp"
#include "armlet/math/pose.hpp"
#include "cell/cameras/camera_surfaces.hpp"

namespace armlet {

// The rasteriser and its pictures.
class Cameras::Drawer {
 public:
  Renderer renderer;
  Pictures pictures;
};

Cameras::Cameras() = default;
Cameras::~Cameras() = default;
Cameras::Cameras(const Cameras& other)
    : cameras_(other.cameras_), taken_(other.taken_), last_(other.last_), kept_(other.kept_) {}
Cameras& Cameras::operator=(const Cameras& other) {
  if (this != &other) *this = Cameras(other);
  return *this;
}
Cameras::Cameras(Cameras&&) noexcept = default;
Cameras& Cameras::operator=(Cameras&&) noexcept = default;

int Cameras::add(Camera camera) {
  if (camera.name.empty()) throw ArgumentError("A camera has no name.");
  if (std::ranges::find(cameras_, camera.name, &Camera::name) != cameras_.end())
    throw ArgumentError(fmt::format("There is a camera `{}` already.", camera.name));
  if (count() == kMost)
    throw ArgumentError(fmt::format("There are {} cameras already; no more are possible.", kMost));
  const Intrinsics& in = camera.lens.intrinsics();
  if (std::int64_t{in.width} * in.height > kMostPixels) {
    throw ArgumentError(fmt::format("A picture of {} x {} has {} pixels; expected at most {}.",
                                    in.width, in.height, std::int64_t{in.width} * in.height,
                                    kMostPixels));
  }
  if (camera.samples != 1 && camera.samples != 4)
    throw ArgumentError(fmt::format("`samples` is {}; expected 1 or 4.", camera.samples));
  for (const auto& [name, value] : {std::pair("noise", camera.noise), {"blur", camera.blur}})
    check_picture_parameter_as("camera", name, picture_parameter(name, "sigma"), value);
  if (camera.rate != 0.0 && !(camera.rate >= kLeastRate && camera.rate <= kMostRate))
    throw ArgumentError(fmt::format("`rate` is {} pictures a second; expected {} to {}.",
                                    camera.rate, kLeastRate, kMostRate));
  check_pose("camera", camera.T_on_camera);
  cameras_.push_back(std::move(camera));
  taken_.push_back(0);
  return count() - 1;
}

const Camera& Cameras::at(int camera) const {
  if (camera >= 0 && camera < count()) return cameras_[static_cast<std::size_t>(camera)];
  throw ArgumentError(fmt::format("There is no camera {}; there are {}.", camera, count()));
}

Eigen::Isometry3d Cameras::T_world_camera(const Cell& cell, int camera) const {
  const Camera& each = at(camera);
  return cell.T_world_mount(each.on) * each.T_on_camera;
}

Eigen::Isometry3d Cameras::T_world_camera_for(const Cell& cell, int camera,
                                              const Eigen::Isometry3d& tool) const {
  const Camera& each = at(camera);
  const Mount& on =
      each.on.base == FrameBase::kFrame ? cell.world().mount_of_frame(each.on.on) : each.on;
  if (on.base != FrameBase::kCarrier) return tool;
  const CellRobot& arm = cell.robot(on.carrier);
  if (on.frame != kFlange && on.frame != arm.model->rows()) {
    throw ArgumentError(fmt::format(
        "`{}` is on link {} of `{}`; where the tool point is does not say where that link is.",
        each.name, on.frame, arm.name));
  }
  return tool * cell.T_world_tool(on.carrier).inverse(Eigen::Isometry) *
         T_world_camera(cell, camera);
}

Scene Cameras::scene(const Cell& cell, int camera) {
  const Camera& each = at(camera);
  Scene all = scene(cell);
  if (!each.key_light) all.light = Light::flat();
  all.ground.drawn = each.ground;
  return all;
}

Scene Cameras::scene(const Cell& cell) {
  if (surfaces_ == nullptr) surfaces_ = std::make_unique<Surfaces>();
  Scene all{.bodies = surfaces_->bodies_of(cell)};
  all.ground.z = cell.world().floor_z().value_or(0.0);
  return all;
}

void Cameras::set_taken(std::vector<std::uint64_t> taken) {
  if (taken.size() > cameras_.size()) {
    throw ArgumentError(fmt::format("There are {} cameras, and {} counts of their pictures.",
                                    cameras_.size(), taken.size()));
  }
  std::ranges::copy(taken, taken_.begin());
}

Image Cameras::color(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera) {
  Image image = preview(cell, camera, T_world_camera);
  ++taken_[static_cast<std::size_t>(camera)];
  return image;
}

Image Cameras::clean(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera) {
  const Camera& each = at(camera);
  const Scene now = scene(cell, camera);
  KeptPictures::Key key{};
  if (kept_ != nullptr) {
    key = KeptPictures::key_of(now, each.lens, T_world_camera, each.samples, each.blur);
    if (Image known = kept_->find(key); !known.is_empty()) return known;
  }
  if (drawer_ == nullptr) drawer_ = std::make_unique<Drawer>();
  drawer_->renderer.render(now, each.lens, T_world_camera, {.samples = each.samples},
                           drawer_->pictures);
  Image image = drawer_->pictures.color;
  if (each.blur > 0.0) image = gaussian_blurred(image, each.blur);
  if (kept_ != nullptr) kept_->put(key, image);
  return image;
}

Image Cameras::preview(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera) {
  const Camera& each = at(camera);
  Image image = clean(cell, camera, T_world_camera);
  if (each.noise > 0.0) {
    Random random = Random(each.seed).split(taken_[static_cast<std::size_t>(camera)]);
    add_noise(image, each.noise, random);
  }
  return image;
}

Image Cameras::depth(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera) {
  if (drawer_ == nullptr) drawer_ = std::make_unique<Drawer>();
  drawer_->renderer.render(scene(cell, camera), at(camera).lens, T_world_camera,
                           {.samples = 1, .color = false, .depth = true}, drawer_->pictures);
  return drawer_->pictures.depth;
}

std::vector<std::int32_t> Cameras::bodies(const Cell& cell, int camera,
                                          const Eigen::Isometry3d& T_world_camera) {
  if (drawer_ == nullptr) drawer_ = std::make_unique<Drawer>();
  drawer_->renderer.render(scene(cell, camera), at(camera).lens, T_world_camera,
                           {.samples = 1, .color = false, .bodies = true}, drawer_->pictures);
  return drawer_->pictures.bodies;
}

namespace {

int number_of(const Cell& cell, std::string_view object) {
  for (std::size_t i = 0; i < cell.world().size(); ++i) {
    if (cell.world().object(i).name == object) return static_cast<int>(i);
  }
  throw ArgumentError(fmt::format("There is no object called \"{}\".", object));
}

}  // namespace

double Cameras::visible_share(const Cell& cell, int camera, std::string_view object) {
  const int body = number_of(cell, object);
  if (drawer_ == nullptr) drawer_ = std::make_unique<Drawer>();
  return drawer_->renderer.visible_share(scene(cell, camera), at(camera).lens,
                                         T_world_camera(cell, camera), body);
}

std::vector<SeenCorner> Cameras::corners(const Cell& cell, int camera, std::string_view object) {
  const int body = number_of(cell, object);
  return seen_corners(scene(cell, camera), at(camera).lens, T_world_camera(cell, camera), body);
}

}  // namespace armlet
