#include "armlet/cell/kept_pictures.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <memory>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/model/catalog.hpp"

using namespace armlet;
using Eigen::Isometry3d;

namespace {

Image random_picture(int width, int height, PixelKind kind, int colors, Random& random) {
  Image image(width, height, kind);
  const int bytes = width * image.channels();
  for (int y = 0; y < height; ++y)
    for (int i = 0; i < bytes; ++i)
      image.row(y)[i] = static_cast<std::uint8_t>(random.below(static_cast<std::uint64_t>(colors)));
  return image;
}

struct Sight {
  Cell cell;
  int arm;
  int eye;
  Isometry3d T;
  explicit Sight(std::shared_ptr<KeptPictures> kept) {
    arm = cell.add_robot(make_robot("scara"), "arm");
    Object card;
    card.name = "card";
    card.shape = Box{{0.1, 0.08, 0.01}};
    card.T_world_obj.translation() = Eigen::Vector3d(0.5, 0.1, 0.05);
    cell.insert(card, Mount{});
    Camera camera;
    camera.name = "eye";
    camera.T_on_camera = looking_at({0.5, 0.1, 0.0}, {0.4, -0.2, 0.9});
    camera.lens = Pinhole(intrinsics_from_fov(96, 72, 1.0));
    camera.noise = 4.0;
    eye = cell.cameras().add(std::move(camera));
    cell.cameras().keep_pictures(std::move(kept));
    T = cell.cameras().T_world_camera(cell, eye);
  }
  Image look() { return cell.cameras().color(cell, eye, T); }
};

}  // namespace

TEST_CASE("kept pictures are given back pixel by pixel, and the oldest go when memory is short") {
  Random random(3);
  for (int trial = 0; trial < 40; ++trial) {
    const PixelKind kind = trial % 2 == 0 ? PixelKind::kRgb : PixelKind::kGrey;
    KeptPictures kept(1 << 20);
    const int width = 1 + static_cast<int>(random.below(700));
    const Image image = random_picture(width, 1 + static_cast<int>(random.below(5)), kind,
                                       trial % 3 == 0 ? 1 : 3, random);
    kept.put({1, 2}, image);
    CHECK(kept.find({1, 2}) == image);
    CHECK(kept.find({2, 1}).is_empty());
  }
  const Image one = random_picture(100, 10, PixelKind::kRgb, 250, random);
  KeptPictures kept(15'000);  // 4 kB each
  for (std::uint64_t i = 0; i < 3; ++i) kept.put({i, 0}, one);
  CHECK(!kept.find({0, 0}).is_empty());  // used again
  kept.put({3, 0}, one);
  CHECK(kept.count() == 3);
  CHECK(kept.bytes() <= 15'000);
  CHECK(kept.find({1, 0}).is_empty());
  CHECK(kept.find({0, 0}) == one);
  kept.put({9, 0}, random_picture(400, 40, PixelKind::kRgb, 250, random));  // larger than all
  CHECK(kept.count() == 3);
}

TEST_CASE("a camera with kept pictures gives the same ones, and draws a scene once") {
  const auto kept = std::make_shared<KeptPictures>(std::size_t{4} << 20U);
  Sight plain(nullptr), first(kept), second(kept);
  for (Sight* each : {&plain, &first, &second})
    each->cell.set_joints(0, Eigen::Vector4d(0.2, 0.4, 0.05, 0.1));
  for (int i = 0; i < 3; ++i) {
    const Image wanted = plain.look();  // with the noise of its number
    CHECK(first.look() == wanted);
    CHECK(second.look() == wanted);
  }
  CHECK(kept->count() == 1);
  CHECK(kept->bytes() < 96 * 72 * 3);
}

TEST_CASE("whatever changes a picture makes it another one") {
  const std::vector<std::pair<const char*, std::function<void(Sight&)>>> changes = {
      {"a joint", [](Sight& s) { s.cell.set_joints(s.arm, Eigen::Vector4d(0.3, 0.4, 0.05, 0.1)); }},
      {"a place", [](Sight& s) { s.T.translation().x() += 1e-9; }},
      {"a body",
       [](Sight& s) {
         Object ball;
         ball.name = "ball";
         ball.shape = Sphere{0.03};
         ball.T_world_obj.translation() = Eigen::Vector3d(0.45, 0.1, 0.2);
         s.cell.insert(ball, Mount{});
       }},
      {"a shape that is only shown",
       [](Sight& s) {
         s.cell.draw({.name = "line",
                      .kind = DrawingKind::kLine,
                      .size = {0.2, 0.01, 0.0},
                      .T_on_drawing = Isometry3d(Eigen::Translation3d(0.5, 0.1, 0.1))});
       }},
      {"a shape",
       [](Sight& s) {
         Object other;
         other.name = "cube";
         other.shape = Box{{0.02, 0.03, 0.04}};
         other.color = "red";
         other.T_world_obj.translation() = Eigen::Vector3d(0.5, 0.2, 0.1);
         s.cell.insert(other, Mount{});
       }},
  };
  for (const auto& [what, change] : changes) {
    const std::string changed(what);
    CAPTURE(changed);
    const auto kept = std::make_shared<KeptPictures>(std::size_t{4} << 20U);
    Sight sight(kept), plain(nullptr);
    static_cast<void>(sight.look());
    static_cast<void>(plain.look());
    change(sight);
    change(plain);
    CHECK(sight.look() == plain.look());
    CHECK(kept->count() == 2);
  }
}

TEST_CASE("who only looks leaves the noise of the next picture as it was") {
  Sight looked(nullptr), plain(nullptr);
  const auto taken = looked.cell.cameras().taken();
  static_cast<void>(looked.look());
  looked.cell.cameras().set_taken(taken);
  CHECK(looked.look() == plain.look());
  CHECK(looked.look() == plain.look());
  CHECK_THROWS_AS(looked.cell.cameras().set_taken({1, 2, 3}), ArgumentError);
}
