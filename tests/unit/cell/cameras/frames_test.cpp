// Pictures that cameras of a cell take, as events that backends receive.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "armlet/backend/owned_event.hpp"
#include "armlet/backend/recorder.hpp"
#include "armlet/backend/run_hash.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;

namespace {

Camera small_camera(std::string name, double rate = 0.0) {
  Camera camera;
  camera.name = std::move(name);
  camera.T_on_camera = looking_at({0.4, 0.0, 0.0}, {0.4, -0.1, 0.6});
  camera.lens = Pinhole(intrinsics_from_fov(24, 16, 1.0));
  camera.noise = 3.0;
  camera.rate = rate;
  return camera;
}

// Keeps copies of the pictures that it receives.
class Album : public Backend {
 public:
  void on(const Event& event) override {
    CHECK(number_of(event) == count_++);
    if (kind_of(event) == EventKind::kImageFrame)
      frames_.push_back(std::make_unique<const OwnedEvent>(event));
  }
  [[nodiscard]] std::size_t size() const { return frames_.size(); }
  [[nodiscard]] const ImageFrame& at(std::size_t i) const {
    return std::get<ImageFrame>(frames_.at(i)->event());
  }

 private:
  std::uint64_t count_ = 0;
  std::vector<std::unique_ptr<const OwnedEvent>> frames_;
};

// A cell with a camera at T, whose events are kept.
struct Looking {
  Album album{};
  Cell cell{};
  int eye = 0;
  Eigen::Isometry3d T;

  Looking() {
    cell.set_backend(&album);
    eye = cell.add_camera(small_camera("eye"));
    T = cell.cameras().T_world_camera(cell, eye);
  }
};

bool has_pixels(const ImageFrame& frame, const Image& image) {
  return std::ranges::equal(frame.pixels, image.bytes()) && frame.width == image.width() &&
         frame.height == image.height() && frame.channels == image.channels();
}

}  // namespace

TEST_CASE("the event of a picture has its pixels, instant, number and camera") {
  Looking looking;
  auto& [album, cell, eye, T] = looking;
  const Image first = cell.capture(eye, T);
  cell.advance_to(30'000'000);
  const Eigen::Isometry3d higher = T * make_translation({0.0, 0.0, -0.1});
  const Image second = cell.capture(eye, higher);
  REQUIRE(album.size() == 2);
  CHECK(album.at(0).camera == "eye");
  CHECK(album.at(0).t_ns == 0);
  CHECK(album.at(0).frame == 0);
  CHECK(has_pixels(album.at(0), first));
  CHECK(album.at(0).T_world_camera.matrix() == T.matrix());
  CHECK(album.at(1).t_ns == 30'000'000);
  CHECK(album.at(1).frame == 1);
  CHECK(has_pixels(album.at(1), second));
  CHECK(album.at(1).T_world_camera.matrix() == higher.matrix());
  CHECK_FALSE(first == second);
}

TEST_CASE("a run is described with its cameras, also with those that come later") {
  Recorder recorder;
  Cell cell;
  cell.set_backend(&recorder);
  const int arm = cell.add_robot(make_robot("puma560"), "arm");
  cell.insert({.name = "cart", .shape = Box{}, .T_world_obj = make_translation({0.5, 0.2, 0.3})});
  Camera camera = small_camera("eye", 25.0);
  camera.on = {.base = FrameBase::kCarrier, .on = "arm", .carrier = arm};
  cell.add_camera(camera);
  camera.name = "elbow";
  camera.on.frame = 3;
  cell.add_camera(camera);
  cell.begin();
  camera.name = "late";
  camera.on = {.base = FrameBase::kObject, .on = "cart"};
  cell.add_camera(camera);
  const std::vector<CameraInfo>& cameras = recorder.run().cameras;
  REQUIRE(cameras.size() == 3);
  CHECK(cameras[0].name == "eye");
  CHECK(cameras[0].width == 24);
  CHECK(cameras[0].fx == camera.lens.intrinsics().fx);
  CHECK(cameras[0].rate == 25.0);
  CHECK(cameras[0].robot == arm);
  CHECK(cameras[0].link == kCameraFlange);
  CHECK(cameras[1].link == 3);
  CHECK(cameras[2].robot == -1);
  CHECK(cameras[2].object == "cart");
  CHECK(cameras[2].T_on_camera.matrix() == camera.T_on_camera.matrix());
}

TEST_CASE("the hash of a run covers the pixels of its pictures") {
  const auto hash_with = [](double noise) {
    RunHash hash;
    Cell cell;
    cell.set_backend(&hash);
    Camera camera = small_camera("eye");
    camera.noise = noise;
    const int eye = cell.add_camera(camera);
    (void)cell.capture(eye, cell.cameras().T_world_camera(cell, eye));
    cell.end();
    return hash.value();
  };
  CHECK(hash_with(3.0) == hash_with(3.0));
  CHECK(hash_with(3.0) != hash_with(2.0));
}

TEST_CASE("the next frame of a camera is the first multiple of its period after now") {
  Cell cell;
  const int plain = cell.add_camera(small_camera("plain"));
  CHECK(cell.cameras().next_frame_ns(plain, 12345) == 12345);
  const int eye = cell.add_camera(small_camera("eye", 25.0));
  const Cameras& cameras = cell.cameras();
  CHECK(cameras.next_frame_ns(eye, 0) == 40'000'000);
  CHECK(cameras.next_frame_ns(eye, 39'999'999) == 40'000'000);
  CHECK(cameras.next_frame_ns(eye, 40'000'000) == 80'000'000);
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const double rate = std::exp(random.uniform(std::log(0.001), std::log(10'000.0)));
    const int other =
        trial < 90 ? cell.add_camera(small_camera("c" + std::to_string(trial), rate)) : eye;
    const double period = 1e9 / cameras.at(other).rate;
    std::int64_t t = static_cast<std::int64_t>(random.uniform(0.0, 1e12));
    const std::int64_t from = cameras.next_frame_ns(other, t);
    CHECK(from > t);
    CHECK(static_cast<double>(from - t) <= period + 1.0);
    t = from;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t next = cameras.next_frame_ns(other, t);
      // Both are rounded down to a nanosecond.
      CHECK(static_cast<double>(next - t) == doctest::Approx(period).epsilon(1e-12).scale(1e12));
      CHECK(next > t);
      t = next;
    }
  }
  Camera bad = small_camera("bad", 1e9);
  CHECK_THROWS_AS(cell.add_camera(bad), ArgumentError);
  bad.rate = -1.0;
  CHECK_THROWS_AS(cell.add_camera(bad), ArgumentError);
}

TEST_CASE("a camera with a rate has one picture at an instant, whoever asks for it") {
  Album album;
  Cell cell;
  cell.set_backend(&album);
  const int eye = cell.add_camera(small_camera("eye", 25.0));
  const int plain = cell.add_camera(small_camera("plain"));
  const Eigen::Isometry3d T = cell.cameras().T_world_camera(cell, eye);
  cell.advance_to(40'000'000);
  const Image one = cell.capture(eye, T);
  CHECK(cell.capture(eye, T) == one);
  CHECK(album.size() == 1);
  Cell copy = cell;
  copy.set_backend(nullptr);
  CHECK(copy.capture(eye, T) == one);
  // From elsewhere, or at another instant, it is another one.
  CHECK_FALSE(cell.capture(eye, T * make_translation({0.05, 0.0, 0.0})) == one);
  cell.advance_to(80'000'000);
  CHECK_FALSE(cell.capture(eye, T) == one);  // other noise
  CHECK(album.size() == 3);
  // Without a rate each call takes one.
  CHECK_FALSE(cell.capture(plain, T) == cell.capture(plain, T));
  CHECK(cell.cameras().taken(plain) == 2);
}

TEST_CASE("a given picture replaces the drawn one if it fits") {
  Looking looking;
  auto& [album, cell, eye, T] = looking;
  Image given(24, 16, PixelKind::kRgb);
  given.row(3)[5] = 77;
  CHECK(cell.capture(eye, T, given) == given);  // without noise and blur
  REQUIRE(album.size() == 1);
  CHECK(has_pixels(album.at(0), given));
  CHECK_THROWS_WITH_AS((void)cell.capture(eye, T, Image(16, 24, PixelKind::kRgb)),
                       "A picture for `eye` is 16 x 24; expected 24 x 16, as it takes.",
                       ArgumentError);
  CHECK_THROWS_WITH_AS((void)cell.capture(eye, T, Image(24, 16, PixelKind::kGrey)),
                       "A picture for `eye` has one channel; expected three, RGB.", ArgumentError);
  CHECK(album.size() == 1);
  CHECK(cell.cameras().taken(eye) == 1);
}

TEST_CASE("a preview is the picture that would be taken next, and leaves no trace") {
  Looking looking;
  auto& [album, cell, eye, T] = looking;
  const Image first = cell.capture(eye, T);
  const Image seen = cell.cameras().preview(cell, eye, T);
  CHECK_FALSE(seen == first);  // other noise
  CHECK(cell.cameras().preview(cell, eye, T) == seen);
  CHECK(album.size() == 1);
  CHECK(cell.capture(eye, T) == seen);
}
